"""The sensor that reads how far the jaws stand apart when they hold a part (thesis 7.2.3).

In a stable orientation theta the jaws stand d(theta) apart. What a sensor makes of that:

- *perfect*: it reads d(theta). Orientations with exactly equal diameters are told apart by nothing:
  half a turn apart they always are equal, and others can be. Squares of diameters at stable
  orientations are rational, so equality is decided.
- *b bits*: it reads which of 2^b equal bins of the jaws' range holds the diameter; the edges are
  rational, a diameter at an edge is in the bin above it, and what is beyond the range is in the
  outermost bins.
- *b bits with noise*: a normal deviate is added to the diameter before that. The probabilities of
  the bins are certified decimals (`stochgeom.sensing.gaussian`).
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Final, final

from gmpy2 import is_square, isqrt, mpq

from stochgeom.arguments import as_list, expect
from stochgeom.errors import NotRationalError, SensorError
from stochgeom.exact.algebraic import is_algebraic
from stochgeom.exact.angles import Angle
from stochgeom.exact.balls import rational_ball
from stochgeom.exact.decimals import Rounding, certified_decimal, rational_decimal
from stochgeom.exact.scalars import RationalLike, rational, rational_text
from stochgeom.feeding.planning_problems import planning_problem_of
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.sensing.gaussian import gaussian_bins
from stochgeom.sensing.sensors import Sensor

MOST_BITS: Final = 10
"""A sensor of more bits has more readings than a plan can tell apart in print."""

LIKELIHOOD_DIGITS: Final = 15
"""Decimals of the likelihoods of a noisy sensor."""


@final
@dataclass(frozen=True, slots=True)
class JawRange:
    """The diameters that a sensor's bins cover: from `low` to `high`, both rational.

    Examples
    --------
    >>> [str(edge) for edge in JawRange(mpq(2), mpq(3)).edges(2)]
    ['9/4', '5/2', '11/4']
    """

    low: mpq
    high: mpq

    @property
    def width(self) -> mpq:
        """How long the range is."""
        return self.high - self.low

    def edges(self, bits: int) -> list[mpq]:
        """Return the edges between its 2^bits equal bins."""
        count = 1 << bits
        return [self.low + self.width * k / count for k in range(1, count)]


def jaw_range(squares: Iterable[mpq]) -> JawRange:
    """Return the range of some diameters, rounded outwards.

    To a power of ten that is at most a hundredth of the range. If all diameters are equal: from 0
    to twice the diameter.

    Parameters
    ----------
    squares : iterable of rationals
        Squared diameters.

    Examples
    --------
    >>> jaw_range([mpq(4), mpq(9)]), jaw_range([mpq(1, 2)])
    (JawRange(low=mpq(2,1), high=mpq(3,1)), JawRange(low=mpq(0,1), high=mpq(71,50)))
    """
    listed = list(squares)
    least, most = min(listed), max(listed)
    digits = 0
    while True:
        if least < most:
            low, high = _rounded(least, digits, Rounding.DOWN), _rounded(most, digits, Rounding.UP)
        else:
            low, high = mpq(0), _rounded(4 * most, digits, Rounding.UP)
        if (high - low) * 10**digits >= 102:  # the true range is shorter by less than two units
            return JawRange(low, high)
        digits += 1


def diameter_sensor(
    part: PartLike | DiameterFunction,
    bits: int | None = None,
    noise: RationalLike = 0,
    *,
    orientations: Mapping[Any, Angle] | None = None,
    **settings: Any,
) -> Sensor:
    """Return the sensor of the distance between the jaws that hold a part.

    Parameters
    ----------
    part : Part, its vertices, or DiameterFunction
        What is held.
    bits, noise, **settings
        As for `sensor_of_diameters`.
    orientations : mapping from labels to Angle, optional
        The states; default: those of `planning_problem_of(part)`.

    Examples
    --------
    >>> rectangle = [(0, 0), (3, 0), (3, 2), (0, 2)]
    >>> diameter_sensor(rectangle).blocks
    {'2': ('0.0000', '180.0000'), '3': ('90.0000', '270.0000')}
    """
    diameter = part if isinstance(part, DiameterFunction) else DiameterFunction(as_part(part))
    if orientations is None:
        orientations = planning_problem_of(diameter.part).orientations
    expect(orientations, Mapping, "a mapping from labels to angles", "orientations")
    squares = {label: diameter.squared(theta) for label, theta in orientations.items()}
    return sensor_of_diameters(squares, bits, noise, **settings)


def sensor_of_diameters(
    squares: Mapping[Any, mpq],
    bits: int | None = None,
    noise: RationalLike = 0,
    *,
    sd: RationalLike | None = None,
    between: tuple[RationalLike, RationalLike] | None = None,
    cost: RationalLike = 0,
    digits: int = LIKELIHOOD_DIGITS,
) -> Sensor:
    """Return the sensor of a distance between the jaws, known for each state.

    Parameters
    ----------
    squares : mapping from states to rationals
        The squared diameter in each state.
    bits : int, optional
        b, from 0 to `MOST_BITS`; default: the exact diameter is read.
    noise : rational, default 0
        Standard deviation of the noise, as a share of the sensor's range.
    sd : rational, optional
        Instead of `noise`: the standard deviation, as a length.
    between : pair of rationals, optional
        The sensor's range; default: `jaw_range`.
    cost : rational, default 0
        Cost of a look, in units of one action.
    digits : int, default 15
        Decimals of the likelihoods of a noisy sensor; ``row_error`` of the sensor says what that
        rounding amounts to.

    Raises
    ------
    SensorError
        For bits that are no such number, noise that is negative or without bits, and a range that
        is empty.

    Examples
    --------
    >>> sensor = sensor_of_diameters({"a": mpq(4), "b": mpq(9)}, bits=2, noise="0.1", digits=4)
    >>> sensor.readings
    ('below 2.25', '2.25 to 2.5', '2.5 to 2.75', 'from 2.75')
    >>> [str(p) for p in sensor.likelihood[0]]
    ['4969/5000', '31/5000', '0', '0']
    """
    check_rational(squares)
    if bits is None:
        if sd is not None or rational(noise, where="noise") != 0:
            raise SensorError(
                "noise without bits; accepted: a number of bits, or no noise", where="noise"
            )
        return _exact_sensor(squares, cost)
    covered = covered_range(between, squares)
    edges = covered.edges(_bits(bits))
    deviation = noise_deviation(noise, sd, covered)
    readings = _bin_names(edges)
    name = f"diameter, {bits} bit{'s' * (bits != 1)}"
    if deviation == 0:
        table: dict[Any, Any] = {}
        for label, square in squares.items():
            place = sum(1 for edge in edges if _is_at_least(square, edge))
            table[label] = [int(k == place) for k in range(len(readings))]
        return Sensor(readings, table, cost=cost, name=name)
    rows = {
        square: gaussian_bins(square, deviation, edges, digits) for square in set(squares.values())
    }
    return Sensor(
        readings,
        {label: rows[square][0] for label, square in squares.items()},
        cost=cost,
        name=f"{name}, noise {rational_text(deviation)}",
        row_error=max(error for _, error in rows.values()),
    )


def check_rational(squares: Mapping[Any, Any]) -> None:
    """Raise unless all squared diameters are rational; those of a regular pentagon are not.

    Raises
    ------
    NotRationalError
        Naming the state.
    """
    for label, square in squares.items():
        if is_algebraic(square):
            raise NotRationalError(
                f"the squared diameter {square} is irrational; accepted: parts whose squared "
                "diameters are rational, such as those with rational vertices",
                where=f"state {label}",
            )


def _exact_sensor(squares: Mapping[Hashable, mpq], cost: RationalLike) -> Sensor:
    """Return the sensor whose readings are the different diameters, increasing."""
    different = sorted(set(squares.values()))
    digits = 4
    while len(set(names := [root_text(square, digits) for square in different])) < len(different):
        digits *= 2
    place = dict(zip(different, names, strict=True))
    table = {
        label: {name: int(name == place[square]) for name in names}
        for label, square in squares.items()
    }
    return Sensor(names, table, cost=cost, name="diameter")


def root_text(square: mpq, digits: int) -> str:
    """Return a root as text: exactly where it is rational, else a correctly rounded decimal.

    Examples
    --------
    >>> root_text(mpq(9, 4), 4), root_text(mpq(2), 4)
    ('3/2', '1.4142')
    """
    exact = _rational_root(square)
    if exact is not None:
        return rational_text(exact)
    return certified_decimal(lambda: rational_ball(square).sqrt(), digits)


def _rational_root(square: mpq) -> mpq | None:
    if is_square(square.numerator) and is_square(square.denominator):
        return mpq(isqrt(square.numerator), isqrt(square.denominator))
    return None


def _rounded(square: mpq, digits: int, rounding: Rounding) -> mpq:
    exact = _rational_root(square)
    if exact is not None:
        return mpq(rational_decimal(exact, digits, rounding))
    return mpq(certified_decimal(lambda: rational_ball(square).sqrt(), digits, rounding))


def _is_at_least(square: mpq, edge: mpq) -> bool:
    """Tell whether the root of a square is at least an edge."""
    return bool(edge <= 0 or square >= edge * edge)


def _bin_names(edges: list[mpq]) -> list[str]:
    """Return names of the bins, with decimals that tell the edges apart."""
    if not edges:
        return ["anything"]
    digits = 0
    while True:
        names = [_trimmed(edge, digits) for edge in edges]
        exact = all(mpq(name) == edge for name, edge in zip(names, edges, strict=True))
        if len(set(names)) == len(edges) and (exact or digits >= 4):
            break
        digits += 1
    inner = [f"{low} to {high}" for low, high in pairwise(names)]
    return [f"below {names[0]}", *inner, f"from {names[-1]}"]


def _trimmed(value: mpq, digits: int) -> str:
    text = rational_decimal(value, digits)
    return text.rstrip("0").rstrip(".") if "." in text else text


def _bits(bits: int) -> int:
    if type(bits) is not int or not 0 <= bits <= MOST_BITS:
        raise SensorError(f"{bits!r}; accepted: whole numbers from 0 to {MOST_BITS}", where="bits")
    return bits


def covered_range(
    between: tuple[RationalLike, RationalLike] | None, squares: Mapping[Any, mpq]
) -> JawRange:
    """Return the range of a sensor: the one given, or that of the diameters.

    Examples
    --------
    >>> covered_range(("1.5", "3.5"), {}).width
    mpq(2,1)
    """
    if between is None:
        return jaw_range(squares.values())
    pair = as_list(between, "a pair of distances", "range of the sensor", SensorError)
    if len(pair) != 2:
        raise SensorError(
            f"{between!r:.60}; accepted: a pair of distances", where="range of the sensor"
        )
    low, high = (rational(value, where="range of the sensor") for value in pair)
    if not low < high:
        raise SensorError(
            f"from {low} to {high}; accepted: an increasing pair", where="range of the sensor"
        )
    return JawRange(low, high)


def noise_deviation(noise: RationalLike, sd: RationalLike | None, covered: JawRange) -> mpq:
    """Return the standard deviation of the noise as a length.

    Examples
    --------
    >>> noise_deviation("0.05", None, JawRange(mpq(2), mpq(4)))
    mpq(1,10)
    """
    share = rational(noise, where="noise")
    if sd is not None and share != 0:
        raise SensorError("noise and sd given; accepted: one of them", where="noise")
    length = share * covered.width if sd is None else rational(sd, where="sd")
    if length < 0:
        raise SensorError(f"standard deviation {length}; accepted: 0 or more", where="noise")
    return length
