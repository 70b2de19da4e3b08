"""Traces of a plan: part and gripper after each action, the distribution beside them.

Drawn as a camera above the gripper sees it: the gripper stands at the sum of the turns so far, the
part at its orientation relative to the gripper plus that sum. So every column shows the same
motion of the gripper, which is the point of a plan without sensors (thesis Figs. 1.1, 4.5, 4.6,
E.5, E.8). A stub on the jaw that is the lower one at 0 degrees tells 0 from 180.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from stochgeom.errors import InputError
from stochgeom.exact.angles import Angle
from stochgeom.exact.shadows import shadow
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.plotting.arguments import part_of
from stochgeom.plotting.distributions import Strip, add_distribution, add_prior, add_scale
from stochgeom.plotting.grasps import REACH, Pose, pose_shapes
from stochgeom.plotting.sample_orientations import Sample, sample_orientations
from stochgeom.plotting.scene import Label, Line, Scene, Shape, shown_degrees
from stochgeom.plotting.silhouettes import FEW_DRAWN, Silhouette, silhouette

MOST_COLUMNS: Final = 8
CELL: Final = 2 * REACH + 0.2
_SIZE: Final = 0.46
_STRIP_WIDTH: Final = 9.0


def typical_orientations(plan: FeedingPlan, most: int = MOST_COLUMNS) -> tuple[Angle, ...]:
    """Return an initial orientation inside every step of the first action, or inside some.

    Inside the larger part of the step beside what it maps to, so that the part is seen to turn.
    Under a prior only orientations that arrive.

    Examples
    --------
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> [theta.degrees(1) for theta in typical_orientations(plan)]
    ['26.6', '108.4', '206.6', '288.4']
    """
    return sample_orientations(plan, most).orientations


def trace_scene(
    plan: FeedingPlan,
    orientations: Sequence[Angle] | None = None,
    *,
    distribution: bool = True,
    digits: int = 1,
    most: int = MOST_COLUMNS,
) -> Scene:
    """Return the traces of a plan, a column for each initial orientation.

    Parameters
    ----------
    plan : FeedingPlan
        The plan of a part.
    orientations : sequence of Angle, optional
        Before the first action; default: `typical_orientations`, and what they are in words.
    distribution : bool
        Whether the hyperstate after each action is drawn beside the poses.
    digits : int
        Decimals of the angles.
    most : int
        Columns at most, if no orientations are given.

    Raises
    ------
    InputError
        If the plan is for a transfer function without a part.
    """
    part = part_of(plan)
    sample = Sample(tuple(orientations), "") if orientations is not None else None
    sample = sample or sample_orientations(plan, most)
    chosen = sample.orientations
    if not chosen:
        raise InputError("0 traces; accepted: 1 or more")
    body = silhouette(part, FEW_DRAWN)
    scene, gripper = Scene(), (0.0, *(shadow(angle) for angle in plan.cumulative_angles))
    for column, theta in enumerate(chosen):
        states = plan.execute(theta)
        x = column * CELL
        scene.add(Label((x, CELL / 2 + 0.3), shown_degrees(theta.degrees(digits)), _SIZE))
        for row, state in enumerate(states):
            shapes = _cell(plan, body, row, shadow(state), gripper[row])
            scene.place(shapes, x, -row * CELL)
        _final(scene, plan, states[-1], (x, -(plan.steps + 0.5) * CELL - 0.3), digits)
    for row in range(plan.steps + 1):
        _caption(scene, plan, row, digits)
    _add_ends(scene, plan, sample.words)
    right = (len(chosen) - 0.5) * CELL
    if distribution:
        _add_distributions(scene, plan, right + 0.8)
    _separators(scene, plan.steps, right)
    return scene


def _cell(
    plan: FeedingPlan, body: Silhouette, row: int, theta: float, gripper: float
) -> list[Shape]:
    pushing = plan.action_name == "push-grasp"
    pose = Pose(body, theta, gripper, closed=row > 0, pushing=pushing)
    return pose_shapes(pose)


def _final(
    scene: Scene, plan: FeedingPlan, state: Angle, at: tuple[float, float], digits: int
) -> None:
    """Write where a trace ends, heavily if it is where the plan's mouth ends."""
    reached = state.reduced() == plan.final_orientation.reduced()
    scene.add(Label(at, shown_degrees(state.reduced().degrees(digits)), _SIZE, bold=reached))


def _caption(scene: Scene, plan: FeedingPlan, row: int, digits: int) -> None:
    x, y = -CELL / 2 - 0.3, -row * CELL
    if row == 0:
        lines = ["before", "the first action"]
    else:
        angle = plan.angles[row - 1]
        lines = [f"{plan.action_name} {row}", f"turned by {shown_degrees(angle.degrees(digits))}"]
        if row == 1 and plan.actions[0].tolerance is None and plan.prior is None:
            lines[1] = "any angle, here 0°"
        if row > 2 or (row == 2 and plan.angles[0]):
            total = plan.cumulative_angles[row - 1]
            lines.append(f"gripper at {shown_degrees(total.degrees(digits))}")
    for k, line in enumerate(lines):
        place = (x, y + (len(lines) - 1 - 2 * k) * 0.62 * _SIZE)
        scene.add(Label(place, line, _SIZE, "end", bold=row > 0 and k == 0))


def _add_ends(scene: Scene, plan: FeedingPlan, words: str) -> None:
    """Write beside the angles above and below the columns what they are."""
    x = -CELL / 2 - 0.3
    rows = (
        (CELL / 2 + 0.3, ("orientation", f"({words})") if words else ("orientation",)),
        (-(plan.steps + 0.5) * CELL - 0.3, ("orientation at the end", "relative to the gripper")),
    )
    for y, lines in rows:
        for k, line in enumerate(lines):
            scene.add(Label((x, y - 1.24 * k * _SIZE), line, _SIZE, "end"))


def _add_distributions(scene: Scene, plan: FeedingPlan, left: float) -> None:
    def strip(row: int) -> Strip:
        return Strip(left, -row * CELL - 0.36 * CELL, _STRIP_WIDTH, 0.62 * CELL)

    heading = "probability of each orientation relative to the gripper"
    scene.add(Label((left, CELL / 2 + 0.3), heading, 0.8 * _SIZE, "start"))
    add_prior(scene, strip(0), plan.prior, _SIZE)
    for row, outcome in enumerate(plan.outcomes(), start=1):
        add_distribution(scene, strip(row), outcome.hyperstate(), _SIZE, 0.84 * CELL)
    add_scale(scene, strip(plan.steps), 0.8 * _SIZE)


def _separators(scene: Scene, steps: int, right: float) -> None:
    left = -CELL / 2
    for row in range(steps):
        y = -(row + 0.5) * CELL
        scene.shapes.insert(0, Line(((left, y), (right, y)), "rule"))
