"""A parts feeder that carries out a plan, seen from above (thesis Fig. 4.2).

Parts arrive on the left-hand conveyor belt, each in a random orientation, and pass a gripper for
every action (or the same one, so often). A filter lets the plan's final orientation through and
sends the rest around again, on the belt below. Which parts pass is decided exactly; the random
orientations are whole tenths of a degree, the same for the same seed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, Final, final

import numpy as np
from gmpy2 import mpq

from stochgeom.arguments import as_count
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.decision.priors import Prior
from stochgeom.errors import InputError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.shadows import shadow
from stochgeom.exact.sums import Probability
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.plotting.arguments import part_of
from stochgeom.plotting.distributions import BINS, bin_masses, fitted
from stochgeom.plotting.grasps import Pose, part_shapes, pose_shapes
from stochgeom.plotting.scene import (
    Label,
    Line,
    Polygon,
    Scene,
    arrow,
    points_of,
    rectangle,
    shown_degrees,
)
from stochgeom.plotting.silhouettes import FEW_DRAWN, Silhouette, silhouette

MOST_PARTS: Final = 12
MOST_STATIONS: Final = 8
_ENDS: Final = (4, 3)
"""Of more stations the first and the last so many are drawn."""

_SPACE: Final = 2.7
_STATION: Final = 4.0
_FILTER: Final = 4.6
_HALF: Final = 1.3
_SLAT: Final = 0.9
_LEAST_BELT: Final = 4.8
_RETURN: Final = -4.0
_SIZE: Final = 0.46
_LEAVING: Final = 3


@final
@dataclass(frozen=True, slots=True)
class Feeder:
    """What a feeder does with some parts.

    Attributes
    ----------
    plan : FeedingPlan
        What it carries out.
    thetas : tuple of Angle
        Orientations before the first action, of those furthest on first.
    period : Angle
        Final orientations that are so far apart are accepted alike.
    """

    plan: FeedingPlan
    thetas: tuple[Angle, ...]
    period: Angle

    def accepts(self, state: Angle) -> bool:
        """Tell whether the filter lets an orientation after the last action through."""
        return (state - self.plan.final_orientation) % self.period == ZERO

    @property
    def accepted(self) -> Decimal:
        """The probability that a part is let through, to three decimals.

        Of a plan for a gripper that errs it is a lower bound, and not rounded up.
        """
        nearest = Decimal(self._passing.decimal(3))
        if self.plan.gripper_error and self._passing.compare(mpq(str(nearest))) < 0:
            return nearest - Decimal("0.001")
        return nearest

    @property
    def _passing(self) -> Probability:
        plan = self.plan
        whole = self.period == FULL_TURN
        return plan.probability if whole else plan.probability_up_to_symmetry

    @property
    def refused(self) -> Decimal:
        """The probability that it is sent around again: the two add up to one."""
        return 1 - self.accepted

    @property
    def needs_filter(self) -> bool:
        """Whether a part may end in another orientation."""
        return not all(map(self.accepts, self.outcome.orientations))

    @property
    def outcome(self) -> Hyperstate:
        """The distribution after the last action, without what a prior makes impossible.

        A gripper that errs may bring a part to any of them, unless the plan is sure to succeed.
        """
        state = self.plan.distribution()
        passing: object = self._passing  # equal to 1 only if it is known to be
        return state if self.plan.gripper_error and passing != 1 else state.possible()

    @property
    def turned(self) -> float:
        """The gripper's angle after the last action, in radians."""
        return shadow(self.plan.cumulative_angles[-1])


def feeder_of(plan: FeedingPlan, parts: int, seed: int, *, up_to_symmetry: bool) -> Feeder:
    """Return a feeder with as many parts waiting, one in each station, one at the filter.

    Raises
    ------
    InputError
        If the plan is for a transfer function without a part, or a number is out of range.
    """
    part_of(plan)
    count = as_count(parts, "parts on the belt", most=MOST_PARTS) + len(stations_of(plan)) + 1
    random = np.random.default_rng(_as_seed(seed))
    thetas = tuple(random_orientations(plan.prior, count, random))
    return Feeder(plan, thetas, plan.transfer.period if up_to_symmetry else FULL_TURN)


def _as_seed(value: Any) -> int:
    """Return a whole number of 0 or more: without a seed the picture would differ each time."""
    seed = int(value.__index__()) if hasattr(value, "__index__") else -1
    if seed < 0:
        raise InputError(f"{value!r:.60} as the seed; accepted: whole numbers from 0 on")
    return seed


def stations_of(plan: FeedingPlan) -> list[int]:
    """Return the numbers of the actions that are drawn, 0 where some are left out."""
    if plan.steps <= MOST_STATIONS:
        return list(range(1, plan.steps + 1))
    first, last = _ENDS
    return [*range(1, first + 1), 0, *range(plan.steps - last + 1, plan.steps + 1)]


def random_orientations(
    prior: Prior | None, count: int, random: np.random.Generator
) -> list[Angle]:
    """Return random orientations: of a discrete prior as they are, else whole tenths of a degree.

    Other priors than the uniform one are drawn from as pictures show them, by arcs of 3 degrees.

    Examples
    --------
    >>> [t.degrees(1) for t in random_orientations(None, 3, np.random.default_rng(1))]
    ['170.3', '184.2', '271.8']
    """
    if isinstance(prior, DiscretePrior):
        atoms = list(prior)
        weights = np.array([float(weight) for _, weight in atoms])
        chosen = random.choice(len(atoms), count, p=weights / weights.sum())
        return [atoms[int(k)][0] for k in chosen]
    tenths = random.integers(0, 3600, count)
    if prior is not None:
        masses = np.array(bin_masses(prior))
        own = 3600 // BINS
        bins = random.choice(BINS, count, p=masses / masses.sum())
        tenths = own * bins + tenths % own
    return [Angle.from_turns(mpq(int(tenth), 3600)) for tenth in tenths]


def feeder_scene(feeder: Feeder) -> Scene:
    """Return the feeder: both belts, the grippers, the filter if one is needed."""
    plan = feeder.plan
    body = silhouette(part_of(plan), FEW_DRAWN)
    stations, scene = stations_of(plan), Scene()
    waiting = len(feeder.thetas) - len(stations) - 1
    first = max(waiting * _SPACE, _LEAST_BELT)
    gate = first + len(stations) * _STATION
    filtered = feeder.needs_filter
    leaving = gate + (_FILTER if filtered else 0.0)
    end = leaving + _LEAVING * _SPACE
    _add_belt(scene, 0.0, end, 0.0)
    for k in range(waiting):
        theta = feeder.thetas[len(stations) + 1 + k]
        scene.place(part_shapes(body.turned(shadow(theta))), first - (k + 0.5) * _SPACE)
    for k, step in enumerate(stations):
        _add_station(scene, feeder, body, step, first + (k + 0.5) * _STATION, k)
    if filtered:
        _add_filter(scene, feeder, body, gate + _FILTER / 2)
        _add_return(scene, feeder, body, gate + _FILTER / 2)
    for k in range(_LEAVING):
        # What the filter takes for the same is shown in turn.
        final = body.turned(shadow(plan.final_orientation + k * feeder.period) + feeder.turned)
        scene.place(part_shapes(final), leaving + (k + 0.5) * _SPACE)
    _add_words(scene, feeder, (0.0, first), (leaving, end))
    return scene


def _add_belt(scene: Scene, left: float, right: float, y: float) -> None:
    """Draw a belt from above, with its slats."""
    scene.add(rectangle((left, y - _HALF), (right, y + _HALF), "faint"))
    count = round((right - left) / _SLAT)
    for k in range(1, count):
        x = left + (right - left) * k / count
        scene.add(Line(((x, y - _HALF), (x, y + _HALF)), "rule"))


def _add_station(
    scene: Scene, feeder: Feeder, body: Silhouette, step: int, x: float, place: int
) -> None:
    """Draw the part that is at an action and the jaws closed on it, at the angle of the plan."""
    plan = feeder.plan
    if step == 0:
        left_out = plan.steps - sum(_ENDS)
        _add_heading(scene, x, f"{left_out} more", "and so on")
        return
    # The nearer to the filter, the earlier it came.
    theta = feeder.thetas[len(stations_of(plan)) - place]
    gripper = plan.cumulative_angles[step - 1]
    pushing = plan.action_name == "push-grasp"
    pose = Pose(body, shadow(plan.execute(theta)[step]), shadow(gripper), pushing=pushing)
    scene.place(pose_shapes(pose), x)
    at = f"at {shown_degrees(gripper.degrees(1))}"
    if step == 1 and plan.actions[0].tolerance is None and plan.prior is None:
        at = "at any angle"
    _add_heading(scene, x, f"{plan.action_name} {step}", at)


def _add_heading(
    scene: Scene, x: float, title: str, below: str, room: float = _STATION - 0.2
) -> None:
    scene.add(Label((x, 2.95), *fitted(title, _SIZE, room), bold=True))
    scene.add(Label((x, 2.25), *fitted(below, _SIZE, room)))


def _add_filter(scene: Scene, feeder: Feeder, body: Silhouette, x: float) -> None:
    """Draw the opening, in the shape of the final orientation, and the part that has come to it."""
    for low, high in ((_HALF, _HALF + 0.45), (-_HALF - 0.45, -_HALF)):
        scene.add(rectangle((x - 1.5, low), (x + 1.5, high), "palm"))
    state = feeder.plan.execute(feeder.thetas[0])[-1]
    scene.place(part_shapes(body.turned(shadow(state) + feeder.turned)), x)
    opening = body.turned(shadow(feeder.plan.final_orientation) + feeder.turned)
    scene.place([Polygon(points_of(opening.outline.tolist()), "hull")], x, scale=1.08)
    passes = f"passes {_share(feeder.accepted, feeder, '≥')}"
    _add_heading(scene, x, "filter", passes, _FILTER - 0.2)


def _share(share: Decimal, feeder: Feeder, bound: str) -> str:
    """Return a share as text; of a plan for a gripper that errs it is a bound."""
    if feeder.plan.gripper_error:
        return f"{bound} {share}"
    # Next to nothing is not nothing, for there is a filter.
    return {"0.000": "under 0.001", "1.000": "over 0.999"}.get(str(share), str(share))


def _add_return(scene: Scene, feeder: Feeder, body: Silhouette, right: float) -> None:
    """Draw the belt that takes back what the filter refuses: its orientations, likeliest first."""
    left, end = 0.0, right + _SPACE / 2
    _add_belt(scene, left, end, _RETURN)
    scene.add(*arrow((right, -_HALF - 0.5), (right, _RETURN + _HALF + 0.05), 0.3))
    scene.add(*arrow((0.6, _RETURN + _HALF), (0.6, -_HALF - 0.05), 0.3))
    y = _RETURN - _HALF - 0.55
    state = feeder.outcome
    refused = [k for k in range(len(state)) if not feeder.accepts(state.orientations[k])]
    refused.sort(key=lambda k: (-float(state.probability(k)), k))
    again = f"sent around again: {_share(feeder.refused, feeder, '≤')}"
    words = Label((left, y), again, _SIZE, "start", bold=True)
    count = f"in {len(refused)} orientation{'s' if len(refused) > 1 else ''}"
    scene.add(words, Label((left, y - 0.7), count, _SIZE, "start"))
    room = max(1, int((end - words.width - 1.0) / _SPACE))
    for place, k in enumerate(refused[:room]):
        x = end - (place + 0.5) * _SPACE
        turned = body.turned(shadow(state.orientations[k]) + feeder.turned)
        scene.place(part_shapes(turned), x, _RETURN)
        share = state.probability(k).decimal(3)
        scene.add(Label((x, y), "<.001" if share == "0.000" else share, _SIZE))


def _add_words(
    scene: Scene, feeder: Feeder, arrival: Sequence[float], leaving: Sequence[float]
) -> None:
    """Write what comes and what goes, with an arrow along each end of the belt."""
    plan = feeder.plan
    known = "at random angles"
    if plan.prior is not None:
        known = "as the prior says"
        text, size = fitted(f"prior: {plan.prior.describe()}", _SIZE, leaving[1])
        scene.add(Label((0.0, 4.1), text, size, "start"))
    final = shown_degrees(plan.final_orientation.reduced().degrees(1))
    gone = f"at {final} in the gripper"
    if feeder.period != FULL_TURN and plan.transfer.order > 1:
        gone = f"{gone}, or alike"
    for (left, right), title, text in (
        (arrival, "parts arrive", known),
        (leaving, "oriented parts", gone),
    ):
        middle = (left + right) / 2
        scene.add(Label((middle, 2.95), *fitted(title, _SIZE, right - left), bold=True))
        scene.add(Label((middle, 2.25), *fitted(text, _SIZE, right - left)))
        scene.add(*arrow((left + 1.1, -_HALF - 0.4), (right - 0.2, -_HALF - 0.4), 0.3))
