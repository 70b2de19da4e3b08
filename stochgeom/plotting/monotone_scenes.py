"""One action keeps the order of orientations: a portion of a transfer function (thesis Fig. 5.6).

The step of the induction in the proof of Lemma 5.1: three arcs under the graph before the action,
on its right after it. Both are exact until they are drawn.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

from stochgeom.arguments import as_count
from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc, ClosedArc
from stochgeom.feeding.closures import Closure
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.plotting.closure_scenes import LOOKS, NAMES
from stochgeom.plotting.curves import MOST_MARKED, in_degrees
from stochgeom.plotting.graph import TEXT, Panel, add_marked_steps, round_ticks
from stochgeom.plotting.scene import Disc, Label, Line, Scene, rectangle, shown_degrees

AnyArc = Arc | ClosedArc

_SIDE: Final = 330.0
_ROW: Final = 16.0
_BELOW: Final = 2.6 * TEXT
_RIGHT: Final = 14.0
_HALF: Final = 4.5
_WORDS: Final = _SIDE + _RIGHT + 3 * _ROW + 8.0


def monotone_step_scene(plan: FeedingPlan, closure: Closure, step: int = 1) -> Scene:
    """Return the portion of the transfer function that one action applies to the three arcs.

    Before the action they stand in rows under the graph, after it in columns on its right: in the
    same order, because the function never falls (Eq. 5.5).
    """
    step = as_count(step, "as the number of an action", most=plan.steps)
    alpha = plan.angles[step - 1]
    before: tuple[AnyArc, ...] = (closure.first, closure.gap, closure.last)
    if step > 1:
        before = closure.images[step - 2]
    before, after = _from_first_turn(before), _from_first_turn(closure.images[step - 1])
    steps = _portion(plan, alpha, before, after)
    panel = Panel(0.0, 0.0, _SIDE, _SIDE, *_ranges(steps))
    scene = Scene()
    # A number at the very bottom would meet the first one below.
    heights = [y for y in angle_ticks(*panel.y) if panel.at(0.0, y)[1] > 0.5 * TEXT]
    panel.frame(
        scene,
        title=f"{plan.action_name} {step}, turned by {shown_degrees(alpha.degrees(2))}",
        x_ticks=angle_ticks(*panel.x),
        y_ticks=heights,
        y_unit="°",
    )
    _add_steps(scene, panel, steps)
    _add_rows(scene, panel, before)
    _add_columns(scene, panel, after)
    return scene


def angle_ticks(low: float, high: float, most: int = 6) -> list[float]:
    """Return round places on an axis of degrees that begins and ends anywhere.

    Examples
    --------
    >>> angle_ticks(130, 320), angle_ticks(41.2, 43.9)
    ([135.0, 180.0, 225.0, 270.0, 315.0], [41.5, 42.0, 42.5, 43.0, 43.5])
    """
    if high - low < 60:
        return round_ticks(low, high, most)
    step = next((s for s in (15.0, 30.0, 45.0, 90.0) if (high - low) / s <= most), 180.0)
    return [step * k for k in range(math.ceil(low / step), math.floor(high / step) + 1)]


def _from_first_turn(arcs: Sequence[AnyArc]) -> tuple[AnyArc, ...]:
    """Return the arcs moved by whole turns, all alike, so that the first begins in [0, 360)."""
    start = arcs[0].start
    return tuple(arc.rotate(start.reduced() - start) for arc in arcs)


def _portion(
    plan: FeedingPlan, alpha: Angle, before: Sequence[AnyArc], after: Sequence[AnyArc]
) -> list[tuple[float, float, float]]:
    """Return start, end and value in degrees of the steps over the arcs and a little around.

    Values are lifted as the images are.
    """
    transfer = plan.transfer
    lift = after[0].start - transfer(before[0].start - alpha)
    low, high = before[0].start, before[-1].end
    margin = Angle.from_degrees(math.ceil(0.12 * in_degrees(high - low)) + 2)
    first = transfer.step_at(low - margin - alpha)
    last = transfer.step_before(high + margin - alpha)
    breaks = [in_degrees(transfer.lifted_breaks[k] + alpha) for k in range(first + 1, last + 1)]
    values = [in_degrees(transfer.lifted_values[k] + lift) for k in range(first, last + 1)]
    ends = [in_degrees(low - margin), *breaks, in_degrees(high + margin)]
    return list(zip(ends[:-1], ends[1:], values, strict=True))


def _ranges(steps: Sequence[tuple[float, float, float]]) -> tuple[tuple[float, float], ...]:
    low, high = steps[0][2], steps[-1][2]
    pad = 0.08 * (high - low) or 5.0
    return (steps[0][0], steps[-1][1]), (low - pad, high + pad)


def _add_steps(scene: Scene, panel: Panel, steps: Sequence[tuple[float, float, float]]) -> None:
    """Draw the steps, their ends marked if they are few."""
    if len(steps) > MOST_MARKED:
        corners = [panel.at(x, y) for a, b, y in steps for x in (a, b)]
        scene.add(Line(tuple(corners), "step"))
        return
    add_marked_steps(scene, panel, steps, cut_at_start=True)


def _add_rows(scene: Scene, panel: Panel, arcs: Sequence[AnyArc]) -> None:
    """Draw the arcs under the graph, each in a row with its name and its ends."""
    scene.add(Label((_WORDS, -_BELOW + _ROW), "before", TEXT, "start", bold=True))
    for k, (arc, name, look) in enumerate(zip(arcs, NAMES, LOOKS, strict=True)):
        y = -_BELOW - _ROW * k
        (x, _), (u, _) = (panel.at(in_degrees(end), 0.0) for end in (arc.start, arc.end))
        scene.add(*(Line(((end, 0.0), (end, y)), "drop") for end in (x, u)))
        if arc.width:
            scene.add(rectangle((x, y - _HALF), (u, y + _HALF), look))
        else:
            scene.add(Disc((x, y), _HALF, look))
        scene.add(Label((_WORDS, y), f"{name}: {_text(arc)}", TEXT, "start"))


def _add_columns(scene: Scene, panel: Panel, arcs: Sequence[AnyArc]) -> None:
    """Draw the images on the right, each in a column with its name above and its ends beside."""
    scene.add(Label((_WORDS, _SIDE - TEXT), "after", TEXT, "start", bold=True))
    for k, (arc, name, look) in enumerate(zip(arcs, NAMES, LOOKS, strict=True)):
        x = _SIDE + _RIGHT + _ROW * k
        (_, y), (_, v) = (panel.at(0.0, in_degrees(end)) for end in (arc.start, arc.end))
        scene.add(*(Line(((_SIDE, end), (x, end)), "drop") for end in (y, v)))
        if arc.width:
            scene.add(rectangle((x - _HALF, y), (x + _HALF, v), look))
        else:
            scene.add(Disc((x, y), _HALF, look))
        scene.add(Label((x, _SIDE + 0.8 * TEXT), name[-1], TEXT))
        text = f"{name}: {_text(arc)}"
        scene.add(Label((_WORDS, _SIDE - TEXT - _ROW * (k + 1)), text, TEXT, "start"))


def _text(arc: AnyArc) -> str:
    ends = [arc.start, arc.end] if arc.width else [arc.start]
    return " to ".join(shown_degrees(end.degrees(2)) for end in ends)
