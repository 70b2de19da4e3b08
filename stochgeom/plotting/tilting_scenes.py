"""A tray from the side, before, during and after a tilt (thesis Fig. 6.1).

The length and the tilt are those of the setup, in its millimetres, seen along the axis of the tilt.
Walls, thickness and arm have no size in the setup: they are a schematic. Whether the tile slides is
told by friction alone, in floats as everything about the tray.
"""

from __future__ import annotations

import math
from typing import Final

from stochgeom.plotting.arguments import expect
from stochgeom.plotting.grasps import turn_shapes
from stochgeom.plotting.scene import (
    Disc,
    Label,
    Line,
    Scene,
    Shape,
    arrow,
    moved,
    points_of,
    rectangle,
    shown_degrees,
)
from stochgeom.tilting.tray import TraySetup

_SIDE: Final = 10.0
"""The inner side of the tray in units of the picture."""

_WALL: Final = 0.9
_THICK: Final = 0.22
_TILE: Final = 0.55
_HUB: Final = 0.3
_SIZE: Final = 0.62
_PITCH: Final = 14.5
_ARC: Final = 3.6


def tilting_scene(setup: TraySetup) -> Scene:
    """Return three side views: the tray level, tilted so that gravity moves the tile, level again.

    The tile begins at the left wall. On a tilt too flat for its friction it stays there.
    """
    setup = expect(setup, TraySetup, "a TraySetup")
    tilt, slides = math.radians(setup.tilt), does_slide(setup)
    length = setup.tile_length * _SIDE / setup.side
    start, end = -_SIDE / 2, _SIDE / 2 - length
    final = end if slides else start
    ground = -(_SIDE / 2 + _WALL) * math.sin(tilt) - 2.4
    scene = Scene()
    views = ((0.0, start, "before"), (tilt, final, _tilted(setup)), (0.0, final, "after"))
    for k, (angle, place, caption) in enumerate(views):
        shapes = [*_arm(ground), *(_angle_mark(angle) if angle else ())]
        way = _way(start, final, length) if angle else []
        shapes += turn_shapes([*way, *_tray(), _tile(place, length, "likely")], -angle)
        scene.place(shapes, k * _PITCH)
        scene.add(Label((k * _PITCH, ground - 1.0), caption, 1.2 * _SIZE, bold=True))
    scene.add(Label((_PITCH, ground - 2.1), _why(setup), _SIZE))
    scene.add(Label((0.9, ground / 2), "robot", _SIZE, "start"))
    _add_gravity(scene, (1.5 * _PITCH, 1.2))
    return scene


def does_slide(setup: TraySetup) -> bool:
    """Tell whether the tile starts to slide: the tilt is steeper than friction with the floor.

    Examples
    --------
    >>> does_slide(TraySetup()), does_slide(TraySetup(tilt=5))
    (True, False)
    """
    return math.sin(math.radians(setup.tilt)) > setup.support_friction * math.cos(
        math.radians(setup.tilt)
    )


def _tilted(setup: TraySetup) -> str:
    return f"tilted by {shown_degrees(f'{setup.tilt:g}')}"


def _why(setup: TraySetup) -> str:
    verb = "slides" if does_slide(setup) else "stays"
    slope = math.tan(math.radians(setup.tilt))
    steep = f"{slope:.3f}" if slope < 100 else "over 100"
    return f"the tile {verb}: slope {steep}, friction {setup.support_friction:.3f}"


def _tray() -> list[Shape]:
    """Return floor and walls; the middle of the floor's upper side is the axis of the tilt."""
    out = _SIDE / 2 + _THICK
    return [
        rectangle((-out, -_THICK), (out, 0.0), "palm"),
        rectangle((-out, 0.0), (-_SIDE / 2, _WALL), "palm"),
        rectangle((_SIDE / 2, 0.0), (out, _WALL), "palm"),
    ]


def _tile(left: float, length: float, style: str) -> Shape:
    return rectangle((left, 0.0), (left + length, _TILE), style)


def _way(start: float, end: float, length: float) -> list[Shape]:
    """Return where the tile was, and an arrow down the floor from there to where it is."""
    if start == end:
        return []
    y = _WALL + 0.75
    tail, tip = start + length / 2, end + length / 2
    return [_tile(start, length, "unlikely"), *arrow((tail, y), (tip, y), 0.5)]


def _arm(ground: float) -> list[Shape]:
    """Return the robot's hand under the tray, on an arm that stands on the ground."""
    return [
        Line(((-1.6, ground), (1.6, ground)), "tray"),
        rectangle((-0.32, ground), (0.32, -_THICK - _HUB), "jaw"),
        Disc((0.0, -_THICK - _HUB), _HUB + 0.12, "mass"),
    ]


def _angle_mark(angle: float) -> list[Shape]:
    """Return the level line to the right of the axis, and the angle from it to the floor."""
    fan = [-angle * k / 24 for k in range(25)]
    arc = points_of([(_ARC * math.cos(a), _ARC * math.sin(a)) for a in fan])
    return [Line(((0.0, 0.0), (_SIDE / 2 + 0.9, 0.0)), "hull"), Line(arc, "heading")]


def _add_gravity(scene: Scene, at: tuple[float, float]) -> None:
    x, y = at
    scene.add(*(moved(shape, x, y) for shape in arrow((0.0, 1.1), (0.0, -1.1), 0.5)))
    scene.add(Label((x, y + 1.7), "gravity", _SIZE))
