"""A plan as a funnel (thesis Fig. 5.7), and a funnel under a prior (Fig. F.1).

Each action is one funnel: its mouth is the preimage, its foot the image. Horizontal is the angle
of the part as a camera sees it, its orientation relative to the gripper plus the gripper's own
angle. Then nothing moves between actions, and the foot of each funnel stands inside the mouth of
the next one exactly where it falls.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import ceil
from typing import Final, final

import numpy as np

from stochgeom.arguments import expect
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.priors import Prior
from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.plotting.curves import in_degrees
from stochgeom.plotting.distributions import bin_masses, fitted
from stochgeom.plotting.graph import TEXT, Panel, degree_ticks
from stochgeom.plotting.scene import Disc, Label, Line, Polygon, Scene, rectangle, shown_degrees

_ROW: Final = 58.0
_FALL: Final = 40.0
_CURVE_HEIGHT: Final = 120.0


@final
@dataclass(frozen=True, slots=True)
class Funnel:
    """One action: mouth and foot in degrees as the camera sees them, and their widths."""

    steps: int
    gripper: Angle
    mouth: tuple[float, float]
    foot: tuple[float, float]
    mouth_width: Angle
    foot_width: Angle


def funnels_of(plan: FeedingPlan) -> list[Funnel]:
    """Return the funnels of a plan, in the order in which they work.

    Examples
    --------
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> [(f.mouth_width.degrees(2), f.foot_width.degrees(2)) for f in funnels_of(plan)]
    [('180.00', '90.00'), ('112.62', '0.00')]
    """
    found = []
    stages = zip(plan.preimages[::-1], plan.cumulative_angles, strict=True)
    for k, (preimage, gripper) in enumerate(stages):
        mouth = plan.mouth if k == 0 else preimage.arc.rotate(gripper)
        image = preimage.image.rotate(gripper)
        found.append(
            Funnel(
                preimage.steps,
                gripper,
                (in_degrees(mouth.start), in_degrees(mouth.end)),
                (in_degrees(image.start), in_degrees(image.end)),
                mouth.width,
                image.width,
            )
        )
    return _beside_each_other(found)


def _beside_each_other(funnels: list[Funnel]) -> list[Funnel]:
    """Return the funnels moved by whole turns so that each one's foot is over the next mouth."""
    placed: list[Funnel] = []
    for funnel in funnels:
        # The middle of the first mouth is in [0, 360), every other one below the foot above it.
        aim = sum(placed[-1].foot) / 2 if placed else 180.0
        shift = 360.0 * round((aim - sum(funnel.mouth) / 2) / 360.0)
        placed.append(
            Funnel(
                funnel.steps,
                funnel.gripper,
                (funnel.mouth[0] + shift, funnel.mouth[1] + shift),
                (funnel.foot[0] + shift, funnel.foot[1] + shift),
                funnel.mouth_width,
                funnel.foot_width,
            )
        )
    return placed


def funnel_scene(
    plan: FeedingPlan, prior: Prior | None = None, *, width: float = 520.0, digits: int = 2
) -> Scene:
    """Return a plan as a funnel; under a prior (default: the plan's own) with its density above.

    The density is drawn over arcs of 3 degrees; what the mouth catches is shaded.
    """
    plan = expect(plan, FeedingPlan, "a plan, such as plan_feeding(part)")
    prior = plan.prior if prior is None else expect(prior, Prior, "a prior, such as WrappedNormal")
    funnels, scene = funnels_of(plan), Scene()
    low, high = _range_of(funnels, whole_turn=prior is not None)
    height = _ROW * len(funnels) + 12.0
    panel = Panel(0.0, 0.0, width, height, (low, high), (0.0, height))
    step = degree_ticks(panel.x[1] - panel.x[0])[1]
    first = int(np.ceil(panel.x[0] / step))
    ticks = [step * k for k in range(first, int(panel.x[1] // step) + 1)]
    panel.frame(scene, x_ticks=ticks)
    for row, funnel in enumerate(funnels):
        _add_funnel(scene, panel, funnel, height - 8.0 - row * _ROW, digits)
        if row + 1 < len(funnels):
            _add_drops(scene, panel, funnel, height - 8.0 - row * _ROW)
    if prior is not None:
        _add_prior(scene, panel, prior, funnels[0], plan)
    return scene


def _range_of(funnels: list[Funnel], *, whole_turn: bool) -> tuple[float, float]:
    """Return multiples of 45 degrees that hold all funnels, a full turn apart at least if asked."""
    ends = [end for funnel in funnels for end in (*funnel.mouth, *funnel.foot)]
    low, high = 45 * int(min(ends) // 45), 45 * ceil(max(ends) / 45)
    while whole_turn and high - low < 360:
        # Alternately, so that the mouth is about in the middle.
        low, high = (low - 45, high) if sum(funnels[0].mouth) < low + high else (low, high + 45)
    return float(low), float(high)


def _add_funnel(scene: Scene, panel: Panel, funnel: Funnel, top: float, digits: int) -> None:
    bottom = top - _FALL
    (a, b), (u, v) = funnel.mouth, funnel.foot
    scene.add(
        Polygon((panel.at(a, top), panel.at(b, top), panel.at(v, bottom), panel.at(u, bottom)),
                "funnel"),
        rectangle(panel.at(u, bottom - 2.0), panel.at(v, bottom + 2.0), "image"),
    )  # fmt: skip
    if u == v:
        scene.add(Disc(panel.at(u, bottom), 3.0, "image"))
    left, right = panel.left - 6.0, panel.left + panel.width + 6.0
    widths = f"{funnel.mouth_width.degrees(digits)}° to {funnel.foot_width.degrees(digits)}°"
    y = panel.at(0.0, (top + bottom) / 2)[1]
    count = f"{funnel.steps} action" + ("s" if funnel.steps != 1 else "") + " to go"
    scene.add(Label((left, y + 0.65 * TEXT), count, TEXT, "end", bold=True))
    scene.add(Label((left, y - 0.65 * TEXT), widths, TEXT, "end"))
    gripper = f"gripper at {shown_degrees(funnel.gripper.degrees(digits))}"
    scene.add(Label((right, y), gripper, TEXT, "start"))


def _add_drops(scene: Scene, panel: Panel, funnel: Funnel, top: float) -> None:
    """Draw where the foot of a funnel falls into the next mouth."""
    for place in set(funnel.foot):
        scene.add(Line((panel.at(place, top - _FALL), panel.at(place, top - _ROW)), "drop"))


def _add_prior(scene: Scene, panel: Panel, prior: Prior, funnel: Funnel, plan: FeedingPlan) -> None:
    bottom = panel.height + 10.0
    upper = Panel(panel.left, bottom, panel.width, _CURVE_HEIGHT, panel.x, (0.0, 1.15))
    scene.add(rectangle(upper.at(panel.x[0], 0.0), upper.at(panel.x[1], 1.15), "frame"))
    if isinstance(prior, DiscretePrior):
        _add_atoms(scene, upper, prior, plan.mouth)
    else:
        masses = bin_masses(prior)
        heights = [mass / max(masses) for mass in masses]
        for ends, style in ((panel.x, "density"), (funnel.mouth, "caught")):
            scene.add(Polygon(_stairs(upper, heights, *ends), style))
    for end in funnel.mouth:
        scene.add(Line((upper.at(end, 1.15), panel.at(end, panel.height - 8.0)), "jump"))
    text, size = fitted(f"prior: {prior.describe()}", TEXT, panel.width)
    y = bottom + _CURVE_HEIGHT + 0.9 * TEXT
    scene.add(Label((panel.left, y), text, size, "start", bold=True))
    caught = plan.probability if prior is plan.prior else prior.mass(plan.mouth)
    place = (panel.left + panel.width + 6.0, upper.at(0.0, 0.5)[1])
    scene.add(Label(place, f"caught: {caught.decimal(4)}", TEXT, "start", bold=True))


def _add_atoms(scene: Scene, panel: Panel, prior: DiscretePrior, mouth: Arc) -> None:
    """Draw a bar for each orientation, shaded if the mouth holds it, which is decided exactly."""
    most = max(float(weight) for _, weight in prior)
    for theta, weight in prior:
        style = "caught" if mouth.contains(theta) else "density"
        first = in_degrees(theta) - 360.0 * ((in_degrees(theta) - panel.x[0]) // 360.0)
        for place in np.arange(first, panel.x[1], 360.0).tolist():
            x, y = panel.at(place, float(weight) / most)
            scene.add(rectangle((x - 2.0, panel.bottom), (x + 2.0, y), style))


def _stairs(
    panel: Panel, heights: list[float], left: float, right: float
) -> tuple[tuple[float, float], ...]:
    """Return the outline of the periodic histogram between two places."""
    size = 360.0 / len(heights)
    inner = [size * k for k in range(int(left // size) + 1, int(np.ceil(right / size)))]
    edges = [left, *inner, right]
    points = [panel.at(left, 0.0)]
    for a, b in pairwise(edges):
        height = heights[int((a + b) / 2 // size) % len(heights)]
        points += [panel.at(a, height), panel.at(b, height)]
    return (*points, panel.at(right, 0.0))
