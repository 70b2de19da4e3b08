"""Scenes of single grasps: at an orientation, all stable ones, errors cancelled or not.

What the captions say is decided exactly; only the drawing is in floats.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from stochgeom.arguments import as_count
from stochgeom.exact.angles import HALF_TURN, Angle
from stochgeom.exact.shadows import shadow
from stochgeom.feeding.gripper_error import GripperError, as_gripper_error
from stochgeom.feeding.stability import StableGrasp, most_stable_grasps, stable_grasps
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.plotting.grasps import (
    JAW_THICKNESS,
    REACH,
    Pose,
    hull_shape,
    jaw_shapes,
    part_shapes,
    pose_shapes,
)
from stochgeom.plotting.scene import Label, Line, Polygon, Scene, arrow, points_of, shown_degrees
from stochgeom.plotting.silhouettes import FEW_DRAWN, silhouette
from stochgeom.transfer.squeeze import squeeze_function

CELL: Final = 2 * REACH + 0.35
MOST_GRASPS: Final = 12
_PER_ROW: Final = 6
_SIZE: Final = 0.3


def contact_word(part: Part, theta: Angle) -> str:
    """Return what holds of closed jaws at an orientation, exactly (thesis Defs. 3.3 and 3.4).

    ``"stable"``: an edge is flush, and turning either way opens the jaws. ``"flush, not stable"``:
    an edge is flush, but the part slips on. ``"wedged"``: cocked between exactly two vertices,
    where only friction can hold it.

    Examples
    --------
    >>> rectangle = Part([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> contact_word(rectangle, Angle()), contact_word(rectangle, Angle(0, (2, 1)))
    ('stable', 'wedged')
    """
    function, place = DiameterFunction(part), theta % HALF_TURN
    if place in function.minima.angles:
        return "stable"
    return "flush, not stable" if place in function.transitions.angles else "wedged"


def grasp_scene(part: Part, theta: Angle, *, hull: bool = True, pushing: bool = False) -> Scene:
    """Return a part between closed jaws at an orientation, with what they touch and a caption."""
    body = silhouette(part)
    pose = Pose(body, shadow(theta), pushing=pushing)
    scene = Scene(pose_shapes(pose, contacts=True))
    if hull and len(part.hull) < len(part):
        scene.add(hull_shape(pose.turned))
    caption = f"{shown_degrees(theta.degrees(2))}: {contact_word(part, theta)}"
    scene.add(Label((0.0, pose.gap[0] - JAW_THICKNESS - 0.4), caption, _SIZE))
    return scene


def stable_scene(part: Part, most: int = MOST_GRASPS) -> Scene:
    """Return the stable grasps in a row, the least stable first (thesis Fig. D.2).

    Of more than ``most`` the most stable ones are drawn; the best are in heavy letters.

    Raises
    ------
    InputError
        If ``most`` is below 1.
    """
    as_count(most, "grasps")
    grasps = sorted(stable_grasps(part), key=lambda grasp: (grasp.stability, grasp.orientation))
    best, body, scene = most_stable_grasps(part), silhouette(part, FEW_DRAWN), Scene()
    shown = grasps[-most:]
    for k, grasp in enumerate(shown):
        row, column = divmod(k, _PER_ROW)
        x, y = column * CELL, -row * (CELL + 0.9)
        scene.place(pose_shapes(Pose(body, shadow(grasp.orientation))), x, y)
        _stability_caption(scene, grasp, (x, y - CELL / 2 - 0.1), bold=grasp in best)
    if len(shown) < len(grasps):
        note = f"the {len(shown)} most stable of {len(grasps)} grasps"
        scene.add(Label((-CELL / 2, CELL / 2 + 0.2), note, _SIZE, "start"))
    return scene


def _stability_caption(
    scene: Scene, grasp: StableGrasp, at: tuple[float, float], *, bold: bool
) -> None:
    x, y = at
    orientation = f"at {grasp.orientation.degrees(2)}°"
    scene.add(
        Label((x, y), orientation, _SIZE, bold=bold),
        Label((x, y - 1.4 * _SIZE), f"Ψ = {grasp.stability.degrees(2)}°", _SIZE, bold=bold),
    )


def reached_from(part: Part, theta: Angle, error: Angle) -> tuple[Angle, ...]:
    """Return the orientations in which a squeeze leaves theta - error to theta + error.

    Each once, though the range may reach it at both of its ends, a full turn apart.

    Examples
    --------
    >>> rectangle = Part([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> [a.degrees(0) for a in reached_from(rectangle, Angle(0, (3, 1)), Angle(0, (1, 1)))]
    ['0', '90']
    """
    squeeze = squeeze_function(part)
    first, last = squeeze.step_at(theta - error), squeeze.step_at(theta + error)
    found: dict[Angle, Angle] = {}
    for k in range(first, last + 1):
        value = squeeze.lifted_values[k]
        found.setdefault(value.reduced(), value)
    return tuple(found.values())


def error_scene(part: Part, theta: Angle, error: GripperError, *, most: int = MOST_GRASPS) -> Scene:
    """Return what a squeeze makes of an uncertain orientation (thesis Figs. 3.2 and 3.3).

    On the left the part at theta, dashed at theta - error and theta + error; on the right every
    orientation that it may end in; of more than ``most`` so many, from the first to the last.
    """
    delta = as_gripper_error(error)
    body, scene = silhouette(part, FEW_DRAWN), Scene()
    before = Pose(body, shadow(theta), closed=False)
    scene.add(*jaw_shapes(before), *part_shapes(before.turned, style="faint"))
    for end in (theta - delta, theta + delta):
        turned = body.turned(shadow(end))
        scene.add(Polygon(points_of(turned.outline.tolist()), "ghost"))
        scene.add(Line((turned.mass, points_of(turned.outline[:1].tolist())[0]), "ghost"))
    scene.add(*arrow((CELL / 2 - 0.1, 0.0), (CELL / 2 + 0.9, 0.0), 0.25))
    finals = reached_from(part, theta, delta)
    shown = _spread(finals, most)
    for k, final in enumerate(shown):
        row, column = divmod(k, _PER_ROW)
        x, y = CELL + 1.0 + column * CELL, -row * (CELL + 0.5)
        scene.place(pose_shapes(Pose(body, shadow(final))), x, y)
        text = shown_degrees(final.degrees(2))
        scene.add(Label((x, y - CELL / 2 - 0.1), text, _SIZE))
    caption = f"{shown_degrees(theta.degrees(2))} ± {delta.degrees(2)}°"
    scene.add(Label((0.0, -CELL / 2 - 0.1), caption, _SIZE))
    scene.add(Label((CELL / 2 + 0.4, 0.4), "squeeze", _SIZE))
    if len(finals) == 1:
        verdict = "the error is cancelled"
    else:
        drawn = f", {len(shown)} of them drawn" if len(shown) < len(finals) else ""
        verdict = f"{len(finals)} final orientations{drawn}: the error is not cancelled"
    scene.add(Label((-CELL / 2, CELL / 2 + 0.2), verdict, _SIZE, "start", bold=True))
    return scene


def _spread(values: Sequence[Angle], most: int) -> list[Angle]:
    """Return all values, or so many of them, the first and the last among them."""
    if len(values) <= most:
        return list(values)
    last = len(values) - 1
    return [values[k * last // max(most - 1, 1)] for k in range(most)]
