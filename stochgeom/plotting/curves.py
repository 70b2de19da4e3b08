"""What the graphs of functions consist of, in degrees: samples, steps, marks and bars.

Both roads, matplotlib and SVG, draw these, so that their tests can ask what is drawn.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final, final

import numpy as np

from stochgeom.arguments import as_count, expect
from stochgeom.errors import NumberLimitError
from stochgeom.exact.angles import Angle
from stochgeom.exact.lifted import LiftedAngles
from stochgeom.exact.shadows import shadow
from stochgeom.exact.vectors import AngleVector
from stochgeom.feeding.preimages import Preimage
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.plotting.arguments import DRAWN_SIZES, MOST_TURNS
from stochgeom.plotting.silhouettes import FloatArray, size_is_drawn
from stochgeom.transfer.step_function import StepFunction

MOST_MARKED: Final = 40
"""The ends of the steps and the extrema of functions with more of them are not marked."""

_MOST_TRANSITIONS: Final = 2000

_FLAT: Final = 0.12
_FLATTEST: Final = 1e-9
"""Functions that vary by less than an eighth are enlarged, those of rounding errors alone not."""


def in_degrees(angle: Angle) -> float:
    """Return an angle in degrees, for drawing: at multiples of 45 degrees it is exact.

    Examples
    --------
    >>> in_degrees(Angle(0, (0, 1)))
    90.0
    """
    exact = angle.rational_turns
    return float(exact * 360) if exact is not None else float(np.degrees(shadow(angle)))


def all_in_degrees(angles: AngleVector) -> FloatArray:
    """Return angles in degrees: exactly rounded if they are few, by their shadows if many."""
    if len(angles) > MOST_MARKED:
        return np.degrees(angles.shadow)
    return np.array([in_degrees(angle) for angle in angles])


@final
@dataclass(frozen=True, slots=True)
class Wave:
    """A piecewise sinusoidal function over [0, degrees): samples, and marks at its extrema."""

    x: FloatArray
    y: FloatArray
    minima: FloatArray
    maxima: FloatArray
    at_minima: FloatArray
    at_maxima: FloatArray

    @property
    def marked(self) -> bool:
        """Whether there are few enough extrema to mark each."""
        return len(self.minima) <= MOST_MARKED

    @property
    def limits(self) -> tuple[float, float]:
        """A range that shows all values: from 0, or nearly flat functions enlarged."""
        low, high = float(self.y.min()), float(self.y.max())
        if _FLATTEST * high < high - low < _FLAT * high:
            pad = 0.12 * (high - low)
            return low - pad, high + pad
        return 0.0, 1.12 * high

    @property
    def remark(self) -> str:
        """What a reader of the graph has to know, ``""`` if nothing."""
        remarks = ["axis not from 0"] if self.limits[0] else []
        if not self.marked:
            remarks.append(f"{np.sum(self.minima < self.x[-1])} minima, not marked")
        return "; ".join(remarks)


def wave_of(function: DiameterFunction | RadiusFunction, turns: int = 1) -> Wave:
    """Sample a diameter or radius function over whole turns, at its transitions as well.

    Raises
    ------
    NumberLimitError
        If floats do not hold the part.

    Examples
    --------
    >>> wave = wave_of(DiameterFunction([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> wave.minima.tolist(), wave.at_minima.round(3).tolist()
    ([0.0, 90.0, 180.0, 270.0, 360.0], [2.0, 3.0, 2.0, 3.0, 2.0])
    """
    end = 360.0 * as_count(turns, "turns", most=MOST_TURNS)
    if not size_is_drawn(function.part):
        raise NumberLimitError(
            f"floats do not hold the part; accepted: sizes {DRAWN_SIZES}, or Part.scale"
        )
    x = np.linspace(0.0, end, 720 * turns + 1)
    own = 180.0 if isinstance(function, DiameterFunction) else 360.0
    corners = np.degrees(function.transitions.shadow)
    if len(corners) <= _MOST_TRANSITIONS:
        x = np.unique(np.concatenate((x, _repeated(corners, own, end))))
    minima = _repeated(all_in_degrees(function.minima), own, end)
    maxima = _repeated(all_in_degrees(function.maxima), own, end)

    def values(degrees: FloatArray) -> FloatArray:
        return function.evaluate(np.radians(degrees))

    return Wave(x, values(x), minima, maxima, values(minima), values(maxima))


def _repeated(places: FloatArray, period: float, end: float) -> FloatArray:
    """Return the places and their copies by whole periods, up to the end, itself included."""
    copies = [places + period * k for k in range(round(end / period) + 1)]
    every = np.concatenate(copies)
    return every[every <= end]


@final
@dataclass(frozen=True, slots=True)
class Steps:
    """The steps of a step function over [0, degrees): starts, ends, values, in degrees.

    The first and the last may be cut off by the ends of the range, where nothing begins or ends.
    """

    starts: FloatArray
    ends: FloatArray
    values: FloatArray
    cut_at_start: bool
    end: float

    @property
    def marked(self) -> bool:
        """Whether there are few enough steps to mark which ends belong to them."""
        return len(self.values) <= MOST_MARKED

    @property
    def remark(self) -> str:
        """What a reader of the graph has to know, ``""`` if nothing."""
        # What is cut off at the start goes on at the end.
        count = len(self.values) - self.cut_at_start
        return "" if self.marked else f"{count} steps, ends not marked"


def steps_of(transfer: StepFunction, turns: int = 1) -> Steps:
    """Return the steps over whole turns.

    Examples
    --------
    >>> steps = steps_of(StepFunction([Angle.from_degrees(10)], [Angle.from_degrees(90)]))
    >>> steps.starts.tolist(), steps.ends.tolist(), steps.values.tolist()
    ([0.0, 10.0], [10.0, 360.0], [-270.0, 90.0])
    """
    expect(transfer, StepFunction, "a step function, such as squeeze_function(part)")
    as_count(turns, "turns", most=MOST_TURNS)
    breaks, values = transfer.lifted_breaks, transfer.lifted_values
    count = len(transfer) * transfer.order * turns
    first = 0 if not breaks[0] else -1  # the step that holds 0 may begin before it
    end = 360.0 * turns
    period = in_degrees(transfer.period)
    starts = _lifted_degrees(breaks, period, range(first, count))
    ends = np.append(starts[1:], end)
    starts[0] = 0.0
    return Steps(starts, ends, _lifted_degrees(values, period, range(first, count)), first < 0, end)


def _lifted_degrees(angles: LiftedAngles, period: float, numbers: Iterable[int]) -> FloatArray:
    base = all_in_degrees(angles.base)
    turn, place = np.divmod(np.array(list(numbers)), len(base))
    found: FloatArray = base[place] + period * turn
    return found


@final
@dataclass(frozen=True, slots=True)
class Bar:
    """A preimage as a horizontal bar: [start, end) in degrees, the exact width as text."""

    steps: int
    start: float
    end: float
    image: tuple[float, float]
    width_text: str


def bars_of(chain: Iterable[Preimage], digits: int = 2) -> list[Bar]:
    """Return the bars of the preimages of 1, 2, ... steps.

    Examples
    --------
    >>> from stochgeom.feeding.preimages import preimages
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> bars = bars_of(preimages(squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])))
    >>> [(round(bar.start, 1), round(bar.end, 1), bar.width_text) for bar in bars]
    [(123.7, 236.3, '112.62'), (56.3, 236.3, '180.00')]
    """
    return [
        Bar(
            preimage.steps,
            in_degrees(preimage.arc.start),
            in_degrees(preimage.arc.end),
            (in_degrees(preimage.image.start), in_degrees(preimage.image.end)),
            preimage.width.degrees(digits),
        )
        for preimage in chain
    ]


def turns_for(bars: Iterable[Bar]) -> int:
    """Return 1, or 2 where a bar ends beyond a full turn."""
    return 2 if any(bar.end > 360.0 for bar in bars) else 1
