"""The closure of a set that a plan collapses, on the circle (thesis Fig. 5.5).

A sketch for the proof of Lemma 5.1, drawn from a plan: the set is Theta_a and Theta_c, the gap
between them Theta_b. Arcs are exact until they are drawn, and so is what the text says of them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding.closures import Closure
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.plotting.curves import in_degrees
from stochgeom.plotting.graph import TEXT
from stochgeom.plotting.scene import (
    XY,
    Disc,
    Label,
    Line,
    Polygon,
    Scene,
    rectangle,
    shown_degrees,
)

NAMES: Final = ("Θa", "Θb", "Θc")
LOOKS: Final = ("bar", "funnel", "bar")

_INNER: Final = 78.0
_OUTER: Final = 92.0
_CLOSURE: Final = 101.0
_LINE: Final = 18.0


def closure_scene(plan: FeedingPlan, closure: Closure) -> Scene:
    """Return the circle of orientations with the set, its gap and its closure, and where it ends.

    Beside it stands what the arcs are, and that the plan brings the gap where it brings the set.
    """
    scene = Scene()
    scene.add(Disc((0.0, 0.0), (_INNER + _OUTER) / 2, "hull"))
    for quarter in range(4):
        scene.add(Line((_polar(90.0 * quarter, _OUTER), _polar(90.0 * quarter, 97.0)), "frame"))
        scene.add(Label(_polar(90.0 * quarter, 139.0), f"{90 * quarter}°", TEXT))
    arcs = (closure.first, closure.gap, closure.last)
    for arc, style in zip(arcs, LOOKS, strict=True):
        scene.add(_sector(*_ends(arc), style))
    _add_names(scene, [sum(_ends(arc)) / 2 for arc in arcs])
    low, high = _ends(closure.arc)
    scene.add(Line(_round(low, high, _CLOSURE), "arrow"))
    for end in (low, high):
        scene.add(Line((_polar(end, _CLOSURE - 4.0), _polar(end, _CLOSURE + 4.0)), "arrow"))
    scene.add(Label(_polar((low + high) / 2, _CLOSURE + 13.0), "CΘ", TEXT, bold=True))
    _add_words(scene, _lines(plan, closure))
    return scene


def _lines(plan: FeedingPlan, closure: Closure) -> list[tuple[str, str]]:
    """Return rows of text, and the style of the swatch before each."""
    rows = [
        (f"{name}: {_span(arc)}", style)
        for name, arc, style in zip(
            NAMES, (closure.first, closure.gap, closure.last), LOOKS, strict=True
        )
    ]
    count = f"{plan.steps} {plan.action_name}{'s' if plan.steps > 1 else ''}"
    ends = [image.start for image in closure.images[-1]]
    # Of the gap it is not taken for granted.
    gap = closure.images[-1][1]
    too = "Θb as well" if not gap.width and ends[1] == ends[0] else "but not Θb"
    return [
        *rows,
        (f"CΘ: {closure.arc.width.degrees(2)}° wide", ""),
        ("", ""),
        (f"{count} bring{'' if plan.steps > 1 else 's'} Θa and Θc", ""),
        (f"to {_shown(closure.final_orientation)}, {too}", ""),
    ]


def _add_words(scene: Scene, rows: Sequence[tuple[str, str]]) -> None:
    top = (len(rows) - 1) * _LINE / 2
    for k, (text, style) in enumerate(rows):
        y = top - _LINE * k
        if style:
            scene.add(rectangle((160.0, y - 5.0), (176.0, y + 5.0), style))
        if text:
            scene.add(Label((184.0 if k < 4 else 160.0, y), text, TEXT, "start"))


def _add_names(scene: Scene, middles: Sequence[float]) -> None:
    """Write the names inside the ring, apart from each other, with a line to each arc."""
    places = spread(middles, [24.0] * len(middles), middles[0] - 90.0, middles[-1] + 90.0)
    for name, place, middle in zip(NAMES, places or middles, middles, strict=True):
        scene.add(Label(_polar(place, _INNER - 26.0), name, TEXT))
        scene.add(Line((_polar(place, _INNER - 14.0), _polar(middle, _INNER)), "rule"))


def _polar(degrees: float, radius: float) -> XY:
    angle = math.radians(degrees)
    return radius * math.cos(angle), radius * math.sin(angle)


def _round(low: float, high: float, radius: float) -> tuple[XY, ...]:
    """Return points on a circle from one angle to another, two degrees apart."""
    count = max(1, math.ceil((high - low) / 2.0))
    return tuple(_polar(low + (high - low) * k / count, radius) for k in range(count + 1))


def _sector(low: float, high: float, style: str) -> Polygon:
    return Polygon(_round(low, high, _OUTER) + _round(low, high, _INNER)[::-1], style)


def _ends(arc: Arc) -> tuple[float, float]:
    return in_degrees(arc.start), in_degrees(arc.end)


def _shown(angle: Angle) -> str:
    return shown_degrees(angle.reduced().degrees(2))


def _span(arc: Arc) -> str:
    """Return an arc as text, its start within the first turn."""
    start = arc.start.reduced()
    end = start + arc.width
    return f"{shown_degrees(start.degrees(2))} to {shown_degrees(end.degrees(2))}"


def spread(
    centers: Sequence[float], widths: Sequence[float], left: float, right: float
) -> list[float] | None:
    """Return centres of labels that do not overlap, near the given ones; None if too many.

    Examples
    --------
    >>> spread([1.0, 1.5, 4.0], [1.0, 1.0, 1.0], 0.0, 5.0)
    [0.75, 1.75, 4.0]
    >>> spread([4.5, 4.6], [1.0, 1.0], 0.0, 5.0), spread([1, 2], [2, 2], 0, 3)
    ([3.5, 4.5], None)
    """
    if sum(widths) > right - left:
        return None
    # Less the widths before it, no place may be below the one before: isotonic regression.
    before = [sum(widths[:k]) + widths[k] / 2 for k in range(len(widths))]
    blocks: list[tuple[float, int]] = []
    for center, offset in zip(centers, before, strict=True):
        total, count = center - offset, 1
        while blocks and blocks[-1][0] * count > total * blocks[-1][1]:
            sum_before, count_before = blocks.pop()
            total, count = total + sum_before, count + count_before
        blocks.append((total, count))
    free = [total / count for total, count in blocks for _ in range(count)]
    low, high = left, right - sum(widths)
    return [min(max(z, low), high) + b for z, b in zip(free, before, strict=True)]
