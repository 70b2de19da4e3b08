"""Distributions over the orientations of a full turn, as strips of bars."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, final

import numpy as np
from gmpy2 import mpq

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.decision.priors import Prior
from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.shadows import TWO_PI, shadow
from stochgeom.plotting.curves import in_degrees
from stochgeom.plotting.scene import GLYPH_WIDTH, Label, Line, Polygon, Scene, rectangle

BINS: Final = 120
"""Into so many arcs of 3 degrees a prior is divided to be drawn."""


MOST_BARS: Final = 360
"""More orientations are drawn by the degree."""

_MOST_NUMBERS: Final = 30


@final
@dataclass(frozen=True, slots=True)
class Strip:
    """A rectangle whose x runs from 0 to 360 degrees and whose y from probability 0 to `top`."""

    left: float
    bottom: float
    width: float
    height: float
    top: float = 1.0

    def at(self, degrees: float, share: float = 0.0) -> tuple[float, float]:
        """Return the place of an orientation and a probability."""
        return (
            self.left + self.width * degrees / 360.0,
            self.bottom + self.height * share / self.top,
        )


def distribution_scene(state: Hyperstate, *, width: float = 9.0, size: float = 0.34) -> Scene:
    """Return one hyperstate with its scale of degrees, the highest bar as high as there is room."""
    most = max(bars_of_state(state)[1])
    scene, strip = Scene(), Strip(0.0, 0.0, width, 1.8, most)
    add_distribution(scene, strip, state, size)
    add_scale(scene, strip, size)
    return scene


def add_distribution(scene: Scene, strip: Strip, state: Hyperstate, size: float) -> None:
    """Draw a hyperstate: a bar for each orientation, its probability above it."""
    scene.add(Line((strip.at(0.0), strip.at(360.0)), "frame"))
    places, shares = bars_of_state(state)
    half = 0.5 * min(0.16 * size + 0.1, strip.width / (3 * max(len(places), 1)))
    for place, share in zip(places, shares, strict=True):
        x, y = strip.at(place, share)
        scene.add(rectangle((x - half, strip.bottom), (x + half, y), "bar"))
    texts = [f"{share:.2f}" for share in shares]
    if len(state) <= _MOST_NUMBERS:
        texts = [_short(text) for text in state.probabilities(2)]
    centers = [strip.at(place)[0] for place in places]
    widths = [GLYPH_WIDTH * size * (len(text) + 0.7) for text in texts]
    placed = spread(centers, widths, strip.left - 0.3 * size, strip.left + strip.width + size)
    if placed is None:  # too many for their numbers to be read
        best = state.probability(state.most_likely()).decimal(2)
        note = f"{len(state)} orientations, the likeliest {_short(best)}"
        level = strip.at(0, max(shares))[1] + 0.9 * size
        scene.add(Label((strip.left, level), note, size, "start"))
        return
    for x, own, width, text in zip(placed, shares, widths, texts, strict=True):
        # Above its own bar and above every bar that it would cover.
        reach = width / 2 - 0.2 * size
        below = [s for c, s in zip(centers, shares, strict=True) if abs(c - x) < reach + half]
        level = max([own, *below])
        scene.add(Label((x, strip.at(0, level)[1] + 0.7 * size), text, size))


def bars_of_state(state: Hyperstate) -> tuple[list[float], list[float]]:
    """Return places in degrees and probabilities in floats: of every orientation, if they are few.

    Of more than `MOST_BARS` orientations, of every degree that has some.
    """
    if len(state) <= MOST_BARS:
        places = [in_degrees(theta) for theta in state.orientations]
        return places, [float(state.probability(k)) for k in range(len(state))]
    sums: dict[int, float] = {}
    for theta, k in zip(state.orientations, range(len(state)), strict=True):
        degree = int(np.degrees(shadow(theta)))
        share = shadow(state.widths[k]) / TWO_PI if state.masses is None else state.probability(k)
        sums[degree] = sums.get(degree, 0.0) + float(share)
    return [degree + 0.5 for degree in sums], list(sums.values())


def _short(text: str) -> str:
    """Return ``".25"`` for ``"0.25"``, as tables print it, and ``"<.01"`` for ``"0.00"``."""
    if text == "0.00":
        return "<.01"
    return text.removeprefix("0") if text.startswith("0.") else text


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


def add_scale(scene: Scene, strip: Strip, size: float) -> None:
    """Write degrees under the lowest strip."""
    for degrees in (0, 90, 180, 270, 360):
        x, y = strip.at(degrees)
        scene.add(Line(((x, y), (x, y - 0.3 * size)), "frame"))
        scene.add(Label((x, y - 1.0 * size), f"{degrees}°", size))


def add_prior(scene: Scene, strip: Strip, prior: Prior | None, size: float) -> None:
    """Draw what is known before the first action; heights are relative to the largest."""
    scene.add(Line((strip.at(0.0), strip.at(360.0)), "frame"))
    if prior is None:
        scene.add(rectangle(strip.at(0.0), strip.at(360.0, 0.25), "density"))
        scene.add(Label(strip.at(180.0, 0.125), "uniform", size))
        return
    if isinstance(prior, DiscretePrior):
        most = max(float(weight) for _, weight in prior)
        for theta, weight in prior:
            x, y = strip.at(in_degrees(theta), 0.75 * float(weight) / most)
            scene.add(rectangle((x - 0.06, strip.bottom), (x + 0.06, y), "density"))
    else:
        heights = bin_masses(prior)
        scene.add(Polygon(_stairs(strip, [0.75 * h / max(heights) for h in heights]), "density"))
    scene.add(Label(strip.at(0.0, 0.95), *fitted(prior.describe(), size, strip.width), "start"))


def fitted(text: str, size: float, width: float) -> tuple[str, float]:
    """Return text and a size in which it fits: smaller letters first, then fewer.

    Examples
    --------
    >>> fitted("short", 1.0, 9.0), fitted("a long description", 1.0, 4.0)
    (('short', 1.0), ('a long d…', 0.7))
    """
    size = max(0.7 * size, min(size, width / (GLYPH_WIDTH * len(text))))
    most = int(width / (GLYPH_WIDTH * size) + 1e-9)
    return (text if len(text) <= most else text[: max(most - 1, 1)] + "…"), size


def _stairs(strip: Strip, heights: Sequence[float]) -> tuple[tuple[float, float], ...]:
    edges = np.linspace(0.0, 360.0, len(heights) + 1)
    points = [strip.at(0.0)]
    for k, height in enumerate(heights):
        points += [strip.at(float(edges[k]), height), strip.at(float(edges[k + 1]), height)]
    return (*points, strip.at(360.0))


def bin_masses(prior: Prior, bins: int = BINS) -> list[float]:
    """Return the probabilities of equal arcs from 0 degrees on, in floats.

    Examples
    --------
    >>> from stochgeom.decision.priors import uniform_prior
    >>> bin_masses(uniform_prior(), 4)
    [0.25, 0.25, 0.25, 0.25]
    """
    width = Angle.from_turns(mpq(1, bins))
    return [float(prior.mass(Arc(Angle.from_turns(mpq(k, bins)), width))) for k in range(bins)]
