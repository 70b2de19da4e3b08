"""The simplest rational direction near the middle of an interval of angles.

A plan's actions may be any angle of an interval; people want one near its middle, machines want
one of few digits. Nothing here decides: every angle returned lies inside the interval by exact
comparison. Between rational directions, and between rational numbers of turns, all of it is
integer arithmetic, so it is the same on every machine. Otherwise ball arithmetic bounds the
interval: between one of either kind, or sums of both, the answer is a rational number of turns;
where a direction over a field is an end, it is a rational direction, which every field has.
"""

from __future__ import annotations

from gmpy2 import isqrt, mpq, mpz

from stochgeom.errors import InvalidArcError
from stochgeom.exact.algebraic import is_algebraic
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle, make_angle
from stochgeom.exact.balls import (
    START_BITS,
    exact_value,
    rational_ball,
    tangent_ball,
    working_precision,
)
from stochgeom.exact.predicates import half_plane

_BITS = 16  # halves are right to about one part in 2**_BITS


def nominal_angle(low: Angle, high: Angle) -> Angle:
    """Return the simplest angle within about an eighth of the width from the middle.

    Parameters
    ----------
    low, high : Angle
        low < high, at most 360 degrees apart. The answer lies strictly between.

    Raises
    ------
    InvalidArcError
        For any other low and high.

    Examples
    --------
    >>> nominal_angle(Angle.from_degrees(40), Angle.from_degrees(47)).degrees(4)
    '43.2000'
    >>> nominal_angle(Angle(0, (3, 1)), Angle(0, (1, 3))).degrees(0)
    '45'
    """
    width = _width(low, high)
    if not _are_directions(low, high):
        return _simplest_by_enclosure(low, high, mpq(3, 8), mpq(5, 8))
    middle = low + _half(width)
    eighth = _half(_half(_half(width)))
    angle = simplest_between(middle - eighth, middle + eighth)
    assert low < angle < high
    return angle


def nominal_inside(low: Angle, high: Angle, margin: Angle) -> Angle:
    """Return the simplest angle near the middle with more than `margin` to `low`.

    To `high` it has at least that. A rational direction if low and high are ones, whatever the
    margin is.

    Parameters
    ----------
    low, high : Angle
        More than twice the margin apart.
    margin : Angle
        0 or more.

    Examples
    --------
    >>> nominal_inside(Angle.from_degrees(0), Angle.from_degrees(90), Angle.from_degrees(44))
    Angle(0, (1, 1))
    """
    angle = nominal_angle(low, high)
    if not margin:
        return angle
    least, most = low + margin, high - margin
    if not _are_directions(low, high):
        return angle if least < angle <= most else nominal_angle(least, most)
    width = high - low
    middle, around = low + _half(width), width
    while not least < angle <= most:
        # `middle` is the middle but for a 2**-16th; if that is too rough, the rest is halved.
        around = _half(around)
        angle = simplest_between(middle - around, middle + around)
        if not least < middle <= most:
            return nominal_angle(least, most)
    return angle


def just_above(low: Angle, high: Angle) -> Angle:
    """Return an angle above `low` by less than a 2**-20th of the way to `high`."""
    width = _width(low, high)
    if not _are_directions(low, high):
        return _simplest_by_enclosure(low, high, mpq(1, 2**21), mpq(3, 2**22))
    for _ in range(21):
        width = _half(width)
    angle = simplest_between(low + _half(width), low + width)
    assert low < angle < high
    return angle


def simplest_between(first: Angle, last: Angle) -> Angle:
    """Return the simplest rational direction in [first, last], both rational directions.

    A multiple of a quarter turn if there is one, else the direction (q, p), turned by whole
    quarters, whose slope p / q is the simplest fraction (Stern and Brocot) of the interval.

    Raises
    ------
    InvalidArcError
        If last < first.
    """
    if last < first:
        raise InvalidArcError(f"no angle from {first} to {last}; accepted: first <= last")
    # The quadrant of `first`, as a whole number of quarter turns and a rest in [0, 90) degrees.
    quarters, ax, ay = _quadrant(first)
    if ay == 0:
        return first
    last_quarters, bx, by = _quadrant(last)
    if last_quarters > quarters:
        return _turn_quarters(quarters + 1, mpz(1), mpz(0))
    slope = simplest_fraction(mpq(ay, ax), mpq(by, bx))
    return _turn_quarters(quarters, slope.denominator, slope.numerator)


def _quadrant(angle: Angle) -> tuple[int, mpz, mpz]:
    """Return k and a direction in [0, 90) degrees that, turned by k quarters, is the angle."""
    x, y = angle.direction
    k = 4 * int(angle.turn_part)
    if half_plane(x, y):
        k, x, y = k + 2, -x, -y
    return (k, x, y) if x > 0 else (k + 1, y, -x)


def _turn_quarters(quarters: int, x: mpz, y: mpz) -> Angle:
    """Return the direction in [0, 90) degrees turned by whole quarters."""
    turns, k = divmod(quarters, 4)
    if k & 2:
        x, y = -x, -y
    return make_angle(turns, -y, x) if k & 1 else make_angle(turns, x, y)


def simplest_fraction(low: mpq, high: mpq) -> mpq:
    """Return the fraction of least denominator, then least numerator, in [low, high], low >= 0.

    Examples
    --------
    >>> simplest_fraction(mpq(3, 10), mpq(2, 5))
    mpq(1,3)
    """
    # Continued fractions: both ends share leading terms a_0, a_1, ...; keep the convergents.
    p0, q0, p1, q1 = mpz(0), mpz(1), mpz(1), mpz(0)
    a, b, c, d = low.numerator, low.denominator, high.numerator, high.denominator
    while True:
        whole, rest = divmod(a, b)
        if rest == 0 or (whole + 1) * d <= c:
            whole += rest != 0
            return mpq(whole * p1 + p0, whole * q1 + q0)
        p0, q0, p1, q1 = p1, q1, whole * p1 + p0, whole * q1 + q0
        # Past their shared whole part, the ends trade places in 1 / (x - whole).
        a, b, c, d = d, c - whole * d, b, rest


def _width(low: Angle, high: Angle) -> Angle:
    """Return high - low, in (0, 360] degrees."""
    width = high - low
    if not ZERO < width <= FULL_TURN:
        raise InvalidArcError(
            f"no angle chosen from {low} to {high}; accepted: low < high, at most 360° apart"
        )
    return width


def _are_directions(*angles: Angle) -> bool:
    """Tell whether all angles are whole turns and a rational direction."""
    return all(
        angle.turn_part.denominator == 1 and not is_algebraic(angle.direction[0])
        for angle in angles
    )


def _half(width: Angle) -> Angle:
    """Return about half of an angle in (0, 360] degrees, a rational direction, never 0.

    With n = |(x, y)|, half the argument is that of (n + x, y) or, without cancellation for
    x < 0, of (y, n - x); n comes from an integer square root.
    """
    if width.turn_part:
        return HALF_TURN
    x, y = width.direction
    n = isqrt((x * x + y * y) << (2 * _BITS))
    x, y = x << _BITS, y << _BITS
    if x < 0:
        return make_angle(0, y, n - x)
    return make_angle(0, n + x, y) if y > 0 else make_angle(0, -n - x, -y)


def _simplest_by_enclosure(low: Angle, high: Angle, first: mpq, last: mpq) -> Angle:
    """Return the simplest number of turns, or direction, between two shares of the way."""
    start, end = low.rational_turns, high.rational_turns
    if start is not None and end is not None:
        width = end - start
        return Angle.from_turns(_simplest_rational(start + width * first, start + width * last))
    over_a_field = is_algebraic(low.direction[0]) or is_algebraic(high.direction[0])
    bits = START_BITS
    while True:
        with working_precision(bits):
            ball, way = low.ball(), (high - low).ball()
            a = exact_value((ball + way * rational_ball(first)).upper())
            b = exact_value((ball + way * rational_ball(last)).lower())
            angle = None
            if a < b:
                turns = _simplest_direction if over_a_field else _simplest_turns
                angle = turns(a, b)
        if angle is not None and low < angle < high:
            return angle
        bits *= 2


def _simplest_turns(low: mpq, high: mpq) -> Angle:
    return Angle.from_turns(_simplest_rational(low, high))


def _simplest_direction(low: mpq, high: mpq) -> Angle | None:
    """Return the simplest direction between two numbers of turns; None if precision is short."""
    quarters = int(4 * low // 1)
    if 4 * high >= quarters + 1:
        return _turn_quarters(quarters + 1, mpz(1), mpz(0))
    rise, fall = (tangent_ball(turns - mpq(quarters, 4)) for turns in (low, high))
    first, last = exact_value(rise.upper()), exact_value(fall.lower())
    if not 0 <= first < last:
        return None
    slope = simplest_fraction(first, last)
    return _turn_quarters(quarters, slope.denominator, slope.numerator)


def _simplest_rational(low: mpq, high: mpq) -> mpq:
    """Return the simplest fraction of an interval of any sign."""
    shift = low.numerator // low.denominator
    return simplest_fraction(low - shift, high - shift) + shift
