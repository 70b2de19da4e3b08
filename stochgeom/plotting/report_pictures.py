"""The pictures of a report that only reports have: distributions in rows, ranges of actions."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil
from typing import Final

from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.exact.angles import Angle
from stochgeom.exact.decimals import significant
from stochgeom.feeding.actions import Action
from stochgeom.plotting.bar_numbers import Room, bar_half, has_line, numbers_over_bars
from stochgeom.plotting.curves import in_degrees
from stochgeom.plotting.graph import TEXT, degree_ticks
from stochgeom.plotting.scene import GLYPH_WIDTH, Disc, Label, Line, Polygon, Scene, rectangle

_LEFT: Final = 84.0
_WIDTH: Final = 760.0
_ROW: Final = 80.0
_BAR_ROW: Final = 26.0
_LEAST_BAR: Final = 18.0
"""Pixels that a bar with both marks needs."""

_STEPS: Final = (
    1e-9,
    1e-8,
    1e-7,
    1e-6,
    1e-5,
    1e-4,
    1e-3,
    0.01,
    0.1,
    0.25,
    0.5,
    1,
    2,
    5,
    10,
    15,
    30,
)
_MOST_LABELS: Final = 16


def distributions_scene(rows: Sequence[tuple[int, Hyperstate]], goal: Angle) -> Scene:
    """Return the distribution after each action, a row each, as stems over 0 to 360 degrees.

    Parameters
    ----------
    rows : sequence of (action, Hyperstate)
        From the top.
    goal : Angle
        The accepted orientation: its stem is dark, the others light.
    """
    scene = Scene()
    bottom = -_ROW * len(rows)
    for x in degree_ticks(360.0):
        px = _LEFT + _WIDTH * x / 360
        scene.add(Line(((px, 0.0), (px, bottom)), "grid"))
        scene.add(Label((px, bottom - 0.95 * TEXT), f"{x:g}°", TEXT))
    for place, (action, state) in enumerate(rows):
        base = -_ROW * (place + 1)
        scene.add(Line(((_LEFT, base), (_LEFT + _WIDTH, base)), "frame"))
        scene.add(Label((_LEFT - 20, base + 0.3 * _ROW), f"after {action}", TEXT, "end"))
        _add_stems(scene, state, base, goal.reduced())
    return scene


def _add_stems(scene: Scene, state: Hyperstate, base: float, goal: Angle) -> None:
    state = state.possible()
    places = [_WIDTH * in_degrees(theta) / 360 for theta in state.orientations]
    shares = [float(text) for text in state.probabilities(4)]
    heights = [max((_ROW - 3.1 * TEXT) * share, 0.8) for share in shares]
    labelled = len(state) <= _MOST_LABELS
    half = bar_half(places, 4.0 if labelled else 1.8, 0.4)
    for theta, x, height in zip(state.orientations, places, heights, strict=True):
        style = "image" if theta == goal else "bar"
        left = _LEFT + x
        scene.add(rectangle((left - half, base), (left + half, base + height), style))
    if not labelled:
        return
    size = 0.9 * TEXT
    texts = ["<0.01" if text == "0.00" else text for text in state.probabilities(2)]
    widths = [GLYPH_WIDTH * size * (len(text) + 0.5) for text in texts]
    room = Room(-widths[0] / 2, _WIDTH + widths[-1] / 2, _ROW - 2.0, half, 1.2 * size, 0.2 * size)
    for k, (x, y) in numbers_over_bars(places, heights, widths, room).items():
        if has_line(places[k], heights[k], (x, y), room):
            foot = (_LEFT + places[k], base + heights[k])
            scene.add(Line((foot, (foot[0], base + y + 1.5)), "leader"))
        scene.add(Label((_LEFT + x, base + y + 0.6 * size), texts[k], size))


def tolerance_scene(actions: Sequence[tuple[int, Action]], free: str = "any angle") -> Scene:
    """Return the range of each action as a bar about its nominal angle, with the ends' kinds.

    The axis is the error of the angle, the same for all actions; a range too narrow for marks is
    written out.

    Parameters
    ----------
    actions : sequence of (number, Action)
        From the top.
    free : str
        What is said of an action without a range.
    """
    scene = Scene()
    rooms = [_room(action) for _, action in actions]
    most = max((max(-room[0], room[1]) for room in rooms if room is not None), default=1.0)
    step = next((s for s in _STEPS if most / s <= 4), 45.0)
    edge = step * max(1, ceil(most / step - 1e-9))
    bottom = -_BAR_ROW * len(actions)

    def at(degrees: float) -> float:
        return _LEFT + _WIDTH * (degrees + edge) / (2 * edge)

    for tick in range(-round(edge / step), round(edge / step) + 1):
        x, sign = at(tick * step), "+" if tick > 0 else ""
        scene.add(Line(((x, 0.0), (x, bottom)), "grid"))
        scene.add(Label((x, bottom - 0.95 * TEXT), f"{sign}{tick * step:g}°", TEXT))
    scene.add(rectangle((_LEFT, bottom), (_LEFT + _WIDTH, 0.0), "frame"))
    for place, ((number, action), room) in enumerate(zip(actions, rooms, strict=True)):
        y = -_BAR_ROW * (place + 0.5)
        scene.add(Label((_LEFT - 8, y), f"action {number}", TEXT, "end"))
        if room is None:
            scene.add(Label((at(0.0), y), free, TEXT))
            continue
        first, last = at(room[0]), at(room[1])
        if last - first < _LEAST_BAR:
            width = action.tolerance
            assert width is not None
            note = f"{significant(width.degrees, 4)}° wide"
            scene.add(Line(((at(0.0), y - 6), (at(0.0), y + 6)), "arrow"))
            scene.add(Label((at(0.0) + 8, y), note, TEXT, "start"))
            continue
        scene.add(rectangle((first, y - 6), (last, y + 6), "bar"))
        scene.add(Disc((first, y), 3.2, "hollow"), Disc((last, y), 3.2, "closed"))
        x = at(0.0)
        scene.add(Polygon(((x, y - 2), (x - 5, y - 11), (x + 5, y - 11)), "image"))
        scene.add(Line(((x, y - 6), (x, y + 6)), "arrow"))
    return scene


def _room(action: Action) -> tuple[float, float] | None:
    """Return how far the ends of a range are from the nominal angle, in degrees."""
    if action.low is None or action.high is None:
        return None
    return in_degrees(action.low - action.angle), in_degrees(action.high - action.angle)
