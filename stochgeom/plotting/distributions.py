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
from stochgeom.plotting.bar_numbers import Room, bar_half, has_line, numbers_over_bars
from stochgeom.plotting.curves import in_degrees
from stochgeom.plotting.scene import (
    GLYPH_WIDTH,
    Label,
    Line,
    Polygon,
    Scene,
    rectangle,
    shortened,
)

BINS: Final = 120
"""Into so many arcs of 3 degrees a prior is divided to be drawn."""


MOST_BARS: Final = 360
"""More orientations are drawn by the degree."""

_MOST_NUMBERS: Final = 30
_NEXT_TO_NOTHING: Final = "<.01"


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


def add_distribution(
    scene: Scene, strip: Strip, state: Hyperstate, size: float, ceiling: float | None = None
) -> None:
    """Draw a hyperstate: a bar for each orientation that is possible, its probability above it.

    Numbers for which there is no room below the ceiling are left out, those of low bars first, and
    those of next to nothing where they would need a line.
    """
    scene.add(Line((strip.at(0.0), strip.at(360.0)), "frame"))
    places, shares = bars_of_state(state)
    centers = [strip.at(place)[0] - strip.left for place in places]
    tops = [strip.at(0.0, share)[1] - strip.bottom for share in shares]
    half = bar_half(centers, 0.5 * (0.16 * size + 0.1), 0.004)
    for center, top in zip(centers, tops, strict=True):
        x, y = strip.left + center, strip.bottom
        scene.add(rectangle((x - half, y), (x + half, y + top), "bar"))
    texts = _numbers(state, shares)
    if texts is None:  # too many to be read
        best = state.probability(state.most_likely()).decimal(2)
        note = f"{len(places)} orientations, the likeliest {_short(best)}"
        level = strip.at(0, max(shares))[1] + 0.9 * size
        scene.add(Label((strip.left, level), note, size, "start"))
        return
    widths = [GLYPH_WIDTH * size * (len(text) + 0.7) for text in texts]
    high = max(tops) + 5 * size if ceiling is None else ceiling
    room = Room(-0.3 * size, strip.width + size, high, half, 1.25 * size, 0.2 * size)
    for k, (x, y) in numbers_over_bars(centers, tops, widths, room).items():
        if has_line(centers[k], tops[k], (x, y), room):
            if texts[k] == _NEXT_TO_NOTHING:
                continue
            foot = (strip.left + centers[k], strip.bottom + tops[k])
            scene.add(Line((foot, (foot[0], strip.bottom + y + 0.15 * size)), "leader"))
        at = (strip.left + x, strip.bottom + y + 0.62 * size)
        scene.add(Label(at, texts[k], size))


def _numbers(state: Hyperstate, shares: Sequence[float]) -> list[str] | None:
    """Return the probabilities as texts; None if they are too many, or bars hold several."""
    state = state.possible()
    if len(shares) > _MOST_NUMBERS or len(shares) < len(state):
        return None
    return [_short(text) for text in state.probabilities(2)]


def bars_of_state(state: Hyperstate) -> tuple[list[float], list[float]]:
    """Return places in degrees and probabilities in floats: of what is possible, if that is few.

    Of more than `MOST_BARS` orientations, of every degree that has some.
    """
    state = state.possible()
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
        return _NEXT_TO_NOTHING
    return text.removeprefix("0") if text.startswith("0.") else text


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
    return shortened(text, max(most, 2)), size


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
