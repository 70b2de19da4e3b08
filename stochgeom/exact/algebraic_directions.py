"""Directions over a real algebraic field L, and which of them are rational turns.

With N = 2 w (see `stochgeom.exact.fields`), the directions over L whose argument is a rational
number of turns are the multiples of 1/N turn and no others. So an angle 2 pi t + arg z with z over
L is brought to one of three kinds:

- arg z is a multiple of 1/N turn: it moves into t, and what is left is a rational angle;
- x : y is rational: z becomes a direction over Q;
- otherwise z is kept, primitive, and if N t is a whole number t moves into z until it is whole.
  The angle then is no rational number of turns, and it is zero for no t.

Two equal angles of the third kind may still have different directions, since finding a unique one
would take an inverse; they are compared by their difference.
"""

from __future__ import annotations

from functools import cache
from typing import Any, Final

from gmpy2 import gcd, mpq, mpz

from stochgeom.exact.algebraic import Algebraic, is_algebraic, make_algebraic, simplified
from stochgeom.exact.balls import Ball, argument_ball, working_precision
from stochgeom.exact.fields import RealField
from stochgeom.exact.predicates import compare_arguments, cross_sign, dot_sign

_NEAR: Final = 2.0**-20


def algebraic_parts(t: Any, x: Any, y: Any) -> tuple[Any, Any, Any]:
    """Return (t, x, y) of the same angle in the form described above.

    Parameters
    ----------
    t : int or mpq
        Turns.
    x, y : int, mpz, mpq or Algebraic
        Not both zero.

    Examples
    --------
    >>> from stochgeom.exact.surds import exact_scalar
    >>> algebraic_parts(0, exact_scalar("sqrt(3)"), mpz(1))
    (mpq(1,12), mpz(1), mpz(0))
    """
    x, y = simplified(x), simplified(y)
    field = x.field if is_algebraic(x) else y.field if is_algebraic(y) else None
    if field is None or not x or not y:
        return t, *_along_axes(x, y)
    one = make_algebraic(field, field.modulus * 0 + 1, None)
    x, y = x * one, y * one
    ratio = _rational_ratio(x, y)
    if ratio is not None:
        return t, *ratio
    order = 2 * field.unity
    eighth = _turns_near(x, y, order)
    if eighth is not None and _is_along(x, y, *unity_direction(field, eighth)):
        return _whole_or_not(t + mpq(eighth, order)), mpz(1), mpz(0)
    if type(t) is not int and order % t.denominator == 0:
        whole, rest = divmod(int(t * order), order)
        turned = _product(x, y, *unity_direction(field, rest))
        t = whole + (compare_arguments(*turned, x, y) < 0)
        x, y = turned
    return t, *_primitive(x, y)


def direction_over(field: RealField, angle: Any) -> tuple[Any, Any] | None:
    """Return a direction over L at an angle modulo a full turn, None if there is none.

    Parameters
    ----------
    field : RealField
        L.
    angle : Angle
        Any angle; those over Q, and rational turns that are multiples of 1/N, have one.
    """
    order = 2 * field.unity
    turns = angle.turn_part * order
    if turns.denominator != 1:
        return None
    x, y = angle.direction
    return _product(x, y, *unity_direction(field, int(turns) % order))


def exact_direction(angle: Any, field: RealField | None) -> tuple[Any, Any]:
    """Return a direction, over Q or a field, of an angle that is known to have one there."""
    if angle.turn_part.denominator == 1:
        x, y = angle.direction
        return x, y
    direction = None if field is None else direction_over(field, angle)
    assert direction is not None, "differences of directions over a field have one"
    return direction


def _whole_or_not(t: mpq) -> int | mpq:
    return int(t) if t.denominator == 1 else t


def _along_axes(x: Any, y: Any) -> tuple[mpz, mpz]:
    """Return a rational direction, or one along an axis, as primitive integers."""
    if not x or not y:
        return mpz(int(x > 0) - int(x < 0)), mpz(int(y > 0) - int(y < 0))
    x, y = mpq(x), mpq(y)
    x, y = x.numerator * y.denominator, y.numerator * x.denominator
    common = gcd(x, y)
    return x // common, y // common


def _rational_ratio(x: Algebraic, y: Algebraic) -> tuple[mpz, mpz] | None:
    """Return x : y as primitive integers with the signs of x and y if it is rational."""
    rows = [
        (a, b)
        for left, right in zip(x.coefficients, y.coefficients, strict=True)
        for a, b in zip(_padded(left, right), _padded(right, left), strict=True)
    ]
    lead = next(((a, b) for a, b in rows if a), None)
    if lead is None or not lead[1]:
        return None
    a, b = lead
    if any(c * b != d * a for c, d in rows):
        return None
    sense = x.sign() * (1 if a > 0 else -1)
    return _along_axes(a * sense, b * sense)


def _padded(row: tuple[mpq, ...], other: tuple[mpq, ...]) -> tuple[mpq, ...]:
    return row + (mpq(0),) * (len(other) - len(row))


def _turns_near(x: Algebraic, y: Algebraic, order: int) -> int | None:
    """Return the only k with arg(x + i y) = k / order turns that is possible, if any is.

    Coefficients may cancel, so the precision grows until the enclosure is narrow.
    """
    bits = x.field.bits
    while True:
        with working_precision(bits):
            scaled: Ball = argument_ball(x, y) * order
            if scaled.is_finite() and scaled.rad() < _NEAR:
                nearest = float(scaled.mid())
                break
        bits *= 2
    k = int(nearest + 0.5)
    # The number is within _NEAR of the middle, and float() within a 2**-52nd of that, which is
    # below 2**12: so if it is whole, it is k, and this distance is below 2 _NEAR.
    return k % order if abs(nearest - k) < 2 * _NEAR else None


def _is_along(ax: Any, ay: Any, bx: Any, by: Any) -> bool:
    return cross_sign(ax, ay, bx, by) == 0 and dot_sign(ax, ay, bx, by) > 0


def _product(ax: Any, ay: Any, bx: Any, by: Any) -> tuple[Any, Any]:
    return ax * bx - ay * by, ax * by + ay * bx


def _primitive(x: Algebraic, y: Algebraic) -> tuple[Algebraic, Algebraic]:
    """Scale by a positive rational number until the coefficients are whole and have no divisor."""
    scale = mpz(x.common_denominator() * y.common_denominator())
    scale //= gcd(x.common_denominator(), y.common_denominator())
    if scale != 1:
        x, y = x * scale, y * scale
    common = gcd(x.content(), y.content())
    return (x, y) if common == 1 else (x * mpq(1, common), y * mpq(1, common))


@cache
def unity_direction(field: RealField, k: int) -> tuple[Any, Any]:
    """Return a direction over L at k / (2 w) turns, k in [0, 2 w).

    zeta^j for k = 2 j; zeta^j + zeta^(j+1), which is halfway between them, for k = 2 j + 1.
    """
    x, y = _unity(field, k // 2)
    if k % 2:
        right, up = _unity(field, k // 2 + 1)
        x, y = x + right, y + up
    return x, y


def _unity(field: RealField, j: int) -> tuple[Algebraic, Algebraic]:
    cosine, sine = field.unity_parts(j)
    return make_algebraic(field, *cosine), make_algebraic(field, *sine)
