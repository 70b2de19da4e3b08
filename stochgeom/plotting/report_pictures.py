"""The pictures of a report that only reports have: distributions in rows, ranges of actions."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil
from typing import Final

from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.exact.angles import Angle
from stochgeom.feeding.actions import Action
from stochgeom.plotting.bar_numbers import Room, bar_half, has_line, numbers_over_bars
from stochgeom.plotting.curves import in_degrees
from stochgeom.plotting.distributions import possible
from stochgeom.plotting.graph import TEXT, degree_ticks
from stochgeom.plotting.scene import GLYPH_WIDTH, Disc, Label, Line, Polygon, Scene, rectangle

_LEFT: Final = 84.0
_WIDTH: Final = 760.0
_ROW: Final = 80.0
_BAR_ROW: Final = 26.0
_MOST_LABELS: Final = 16


def distribution_scene(rows: Sequence[tuple[int, Hyperstate]], goal: Angle) -> Scene:
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
    kept = [k for k in range(len(state)) if possible(state, k)]
    places = [_WIDTH * in_degrees(state.orientations[k]) / 360 for k in kept]
    shares = [float(state.probability(k).decimal(4)) for k in kept]
    heights = [max((_ROW - 3.1 * TEXT) * share, 0.8) for share in shares]
    labelled = len(kept) <= _MOST_LABELS
    half = bar_half(places, 4.0 if labelled else 1.8, 0.4)
    for k, x, height in zip(kept, places, heights, strict=True):
        style = "image" if state.orientations[k] == goal else "bar"
        left = _LEFT + x
        scene.add(rectangle((left - half, base), (left + half, base + height), style))
    if not labelled:
        return
    size = 0.9 * TEXT
    texts = [state.probability(k).decimal(2) for k in kept]
    widths = [GLYPH_WIDTH * size * (len(text) + 0.5) for text in texts]
    room = Room(-widths[0] / 2, _WIDTH + widths[-1] / 2, _ROW - 2.0, half, 1.2 * size, 0.2 * size)
    for k, (x, y) in numbers_over_bars(places, heights, widths, room).items():
        if has_line(places[k], heights[k], (x, y), room):
            foot = (_LEFT + places[k], base + heights[k])
            scene.add(Line((foot, (foot[0], base + y + 1.5)), "leader"))
        scene.add(Label((_LEFT + x, base + y + 0.6 * size), texts[k], size))


def tolerance_scene(actions: Sequence[tuple[int, Action]]) -> Scene:
    """Return the range of each action as a bar, with its nominal angle and the ends' kinds.

    The axis runs over whole multiples of 90 degrees that hold all ranges.
    """
    scene = Scene()
    ends = [in_degrees(end) for _, a in actions for end in (a.low, a.high) if end is not None]
    low, high = 90 * int(min(ends, default=0) // 90), 90 * ceil(max(ends, default=90) / 90)
    bottom = -_BAR_ROW * len(actions)

    def at(degrees: float) -> float:
        return _LEFT + _WIDTH * (degrees - low) / (high - low)

    step = next(s for s in (15, 30, 45, 90, 180, 360, 720) if (high - low) / s <= 12 or s == 720)
    for degrees in range(low, high + 1, step):
        scene.add(Line(((at(degrees), 0.0), (at(degrees), bottom)), "grid"))
        scene.add(Label((at(degrees), bottom - 0.95 * TEXT), f"{degrees}°", TEXT))
    scene.add(rectangle((_LEFT, bottom), (_LEFT + _WIDTH, 0.0), "frame"))
    for place, (number, action) in enumerate(actions):
        y = -_BAR_ROW * (place + 0.5)
        scene.add(Label((_LEFT - 8, y), f"action {number}", TEXT, "end"))
        if action.low is None or action.high is None:
            scene.add(Label((_LEFT + _WIDTH / 2, y), "any angle", TEXT))
            continue
        first, last = at(in_degrees(action.low)), at(in_degrees(action.high))
        scene.add(rectangle((first, y - 6), (last, y + 6), "bar"))
        scene.add(Disc((first, y), 3.2, "hollow"), Disc((last, y), 3.2, "closed"))
        x = at(in_degrees(action.angle))
        scene.add(Polygon(((x, y - 2), (x - 5, y - 11), (x + 5, y - 11)), "image"))
        scene.add(Line(((x, y - 6), (x, y + 6)), "arrow"))
    return scene
