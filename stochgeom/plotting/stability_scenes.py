"""Push-stability, squeeze-stability and squeeze-grasp diagrams (thesis Figs. 3.5 to 3.7).

A cross is a stable orientation, towards which the part turns from both sides; a diamond is an
unstable equilibrium, which it leaves; < and > delimit a wedging interval, in which it stays. Bars
are sets of initial orientations.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Final

from stochgeom.exact.angles import FULL_TURN
from stochgeom.exact.cells import CellSet
from stochgeom.exact.directions import nominal_angle
from stochgeom.exact.intervals import Interval
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.push_stability import Motion, PushStability
from stochgeom.grasping.squeeze_stability import SqueezeStability
from stochgeom.plotting.curves import MOST_MARKED
from stochgeom.plotting.graph import TEXT, Panel, degree_ticks
from stochgeom.plotting.scene import XY, Label, Scene, Shape, rectangle, shown_degrees
from stochgeom.plotting.track_rows import (
    Row,
    add_bands,
    add_cells,
    add_text,
    add_way,
    cross,
    diamond,
    plus,
    wedge_ends,
)

_WIDTH: Final = 560.0
_ROW: Final = 44.0
_FOOT: Final = 20.0

_Drawer = Callable[[Scene, Row], None]


def push_scene(push: PushStability, *, width: float = _WIDTH) -> Scene:
    """Return the push-stability diagram of one jaw (Fig. 3.5)."""
    kinds = _kinds_of_push(push)
    return _diagram([lambda scene, row: _add_push(scene, row, push)], kinds, width)


def squeeze_scene(squeeze: SqueezeStability, *, width: float = _WIDTH) -> Scene:
    """Return the squeeze-stability diagram (Fig. 3.6)."""
    kinds = _kinds(squeeze)
    return _diagram([lambda scene, row: _add_squeeze(scene, row, squeeze)], kinds, width)


def grasp_diagram_scene(diagram: GraspDiagram, *, width: float = _WIDTH) -> Scene:
    """Return the squeeze-grasp diagram (Fig. 3.7).

    From top to bottom the push by either jaw, the squeeze, the strong preimage of each stable
    orientation, and that of all of them together. Of more than `MOST_MARKED` stable orientations
    the preimages are not drawn one by one.
    """

    def add_strong(scene: Scene, row: Row) -> None:
        _add_strong(scene, row, diagram)

    def add_guaranteed(scene: Scene, row: Row) -> None:
        share = diagram.bound.decimal()
        scene.add(row.title(f"sure to end stable: {share} of all initial orientations"))
        add_cells(scene, row, diagram.guaranteed)
        for item in diagram.guaranteed:
            add_text(scene, row, item, shown_degrees(item.width.degrees(2)))

    rows: list[_Drawer] = [
        *(lambda scene, row, push=push: _add_push(scene, row, push) for push in diagram.jaws),
        lambda scene, row: _add_squeeze(scene, row, diagram.squeeze),
        add_strong,
        add_guaranteed,
    ]
    if len(diagram.stable) > MOST_MARKED:
        rows.remove(add_strong)
    kinds = dict.fromkeys((*_kinds_of_push(diagram.lower), *_kinds(diagram.squeeze)))
    return _diagram(rows, tuple(kinds), width)


def cells_scene(cells: CellSet, *, width: float = 420.0) -> Scene:
    """Return a set of orientations as bars, with dots at ends that belong to it, else circles."""

    def add(scene: Scene, row: Row) -> None:
        scene.add(row.title(f"{cells.measure.decimal()} of all orientations"))
        add_cells(scene, row, cells)
        for item in cells:
            add_text(scene, row, item, shown_degrees(item.width.degrees(2)))

    return _diagram([add], (), width)


def _diagram(rows: list[_Drawer], kinds: tuple[str, ...], width: float) -> Scene:
    scene, height = Scene(), _FOOT + _ROW * len(rows)
    panel = Panel(0.0, 0.0, width, height, (0.0, 360.0), (0.0, 1.0))
    panel.frame(scene, x_ticks=degree_ticks(360.0))
    for k, draw in enumerate(reversed(rows)):
        draw(scene, Row(panel, _FOOT + _ROW * k))
    _add_legend(scene, (0.0, height + 1.1 * TEXT), kinds)
    return scene


# --- rows ----------------------------------------------------------------------------------------


def _add_push(scene: Scene, row: Row, push: PushStability) -> None:
    row = row.with_marks(len(push.critical))
    scene.add(row.title(f"pushed by the {push.jaw.value} jaw"), row.axis())
    for theta in push.stable:
        scene.add(*(cross(place, row.size) for place in row.places(theta)))
    if len(push.valleys) > MOST_MARKED:  # then only the stable orientations are marked
        return
    for stable, unstable, step in push.sides:
        low, high = (stable, unstable) if step > 0 else (unstable, stable)
        add_way(scene, row, low, high, -step)
    for theta in push.unstable:
        scene.add(*(diamond(place, row.size) for place in row.places(theta)))


def _add_squeeze(scene: Scene, row: Row, squeeze: SqueezeStability) -> None:
    row, angle = row.with_marks(len(squeeze.angles)), squeeze.friction.angle
    friction = f"friction angle {shown_degrees(angle.degrees(2))}" if angle else "no friction"
    scene.add(row.title(f"squeezed, {friction}"), row.axis())
    wedges = squeeze.wedged.intervals()
    add_bands(scene, row, wedges, "palm")
    if len(squeeze.stable) <= MOST_MARKED:
        _add_ways(scene, row, squeeze)
        for item in wedges:
            start, *_ = row.places(item.start)
            *_, end = row.places(item.end)
            scene.add(*wedge_ends(start, end, row.size))
    for edge in squeeze.stable:
        for place in row.places(edge.orientation):
            scene.add((plus if edge.by_friction else cross)(place, row.size))
    for theta in squeeze.angles:
        if squeeze.motion(theta) is Motion.UNSTABLE:
            scene.add(*(diamond(place, row.size) for place in row.places(theta)))


def _add_ways(scene: Scene, row: Row, squeeze: SqueezeStability) -> None:
    angles = squeeze.angles
    for start, end in pairwise((*angles, angles[0] + FULL_TURN)):
        step = {Motion.COUNTERCLOCKWISE: 1, Motion.CLOCKWISE: -1}.get(
            squeeze.motion(nominal_angle(start, end))
        )
        if step is not None:
            add_way(scene, row, start, end, step)


def _add_strong(scene: Scene, row: Row, diagram: GraspDiagram) -> None:
    scene.add(row.title("sure to end at"))
    for edge in diagram.stable:
        strong = diagram.strong_preimage(edge.orientation)
        add_cells(scene, row, strong, "funnel")
        widest: tuple[Interval, ...] = strong.widest()
        for item in widest[:1]:
            add_text(scene, row, item, shown_degrees(edge.orientation.degrees(1)))


# --- the legend ----------------------------------------------------------------------------------


def _kinds_of_push(push: PushStability) -> tuple[str, ...]:
    return ("stable", "unstable") if len(push.valleys) <= MOST_MARKED else ("stable",)


def _kinds(squeeze: SqueezeStability) -> tuple[str, ...]:
    found = ["stable"]
    if any(edge.by_friction for edge in squeeze.stable):
        found.append("held by friction alone")
    if squeeze.wedged:
        found.append("wedged")
    if not squeeze.friction.angle:
        found.append("unstable")
    return tuple(found)


def _add_legend(scene: Scene, at: XY, kinds: tuple[str, ...]) -> None:
    x, y = at
    for kind in kinds:
        mark = (x + 7.0, y)
        scene.add(*_mark_of(kind, mark))
        label = Label((x + 21.0, y), kind, TEXT, "start")
        scene.add(label)
        x += 33.0 + label.width


def _mark_of(kind: str, at: XY) -> tuple[Shape, ...]:
    if kind == "unstable":
        return (diamond(at),)
    if kind == "wedged":
        (x, y), r = at, 9.0
        low, high = (x - r, y), (x + r, y)
        return (rectangle((x - r, y - 5), (x + r, y + 5), "palm"), *wedge_ends(low, high))
    return (plus(at) if kind == "held by friction alone" else cross(at),)
