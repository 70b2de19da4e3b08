"""Ball arithmetic (Arb), at a precision that is set, used and put back under one lock.

``flint.ctx.prec`` belongs to the whole process, so every use of Arb in stochgeom goes through
`working_precision`. A ball is a certified enclosure: comparing balls answers "certainly", and
an undecided comparison is False both ways.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Final, TypeAlias

import flint
from gmpy2 import mpq, mpz

from stochgeom.errors import NumberLimitError, PrecisionLimitError

Ball: TypeAlias = "Any"
"""A real ball, `flint.arb`; python-flint ships no complete type information."""

START_BITS: Final = 64
MAX_BITS: Final = 1 << 22
"""No certified question is pursued beyond this precision."""

_INTEGERS: Final = (int, type(mpz()))
_LOCK = threading.RLock()


@contextmanager
def working_precision(bits: int) -> Iterator[None]:
    """Run the block with `bits` of Arb precision, alone in the process, then restore.

    Examples
    --------
    >>> with working_precision(128):
    ...     ball = rational_ball(mpq(1, 3))
    >>> ball.rel_accuracy_bits() > 120
    True
    """
    with _LOCK:
        before = flint.ctx.prec
        flint.ctx.prec = bits
        try:
            yield
        finally:
            flint.ctx.prec = before


def rational_ball(value: mpq | int) -> Ball:
    """Enclose a rational number (exactly, where it is a whole number)."""
    numerator, denominator = int(value.numerator), int(value.denominator)
    return flint.arb(numerator) if denominator == 1 else flint.arb(numerator) / denominator


def number_ball(value: Any) -> Ball:
    """Enclose an exact number: a rational one, or one with a ``ball()`` of its own."""
    return value.ball() if hasattr(value, "ball") else rational_ball(value)


def full_turn_ball() -> Ball:
    """Enclose 2 pi."""
    return 2 * flint.arb.pi()


def argument_ball(x: Any, y: Any) -> Ball:
    """Enclose arg(x + i y) / (2 pi), turns in [0, 1), of exact numbers."""
    up, right = (flint.arb(int(v)) if isinstance(v, _INTEGERS) else number_ball(v) for v in (y, x))
    ball = flint.arb.atan2(up, right) / full_turn_ball()
    return ball + 1 if y < 0 else ball


def tangent_ball(turns: Any) -> Ball:
    """Enclose the tangent of a rational number of turns that is no odd number of quarters."""
    return (rational_ball(turns) * full_turn_ball()).tan()


def ball_sign(ball: Ball) -> int | None:
    """Return the sign of the number in the ball, or None while the ball does not tell."""
    if ball > 0:
        return 1
    if ball < 0:
        return -1
    return 0 if ball.is_zero() else None


def sign_by_refinement(enclose: Callable[[], Ball], start: int = START_BITS) -> int:
    """Return the sign of a number known not to be zero, doubling the precision until it shows.

    Raises
    ------
    PrecisionLimitError
        If `MAX_BITS` do not suffice.
    """
    bits = start
    while bits <= MAX_BITS:
        with working_precision(bits):
            sign = ball_sign(enclose())
        if sign is not None:
            return sign
        bits *= 2
    raise PrecisionLimitError(f"a sign is still undecided at {MAX_BITS} bits")


def exact_value(end: Ball) -> mpq:
    """Return an exact ball, such as an end of another one, as a rational number."""
    mantissa, exponent = end.man_exp()
    m, e = mpz(int(mantissa)), int(exponent)
    return mpq(m << e) if e >= 0 else mpq(m, mpz(1) << -e)


def certified_float(enclose: Callable[[], Ball]) -> float:
    """Return a number known not to be zero as a float, within one unit in the last place.

    Raises
    ------
    NumberLimitError
        For a number beyond the largest float.

    Examples
    --------
    >>> certified_float(flint.arb.pi)
    3.141592653589793
    """
    bits = 2 * START_BITS
    while True:
        with working_precision(bits):
            ball = enclose()
            if ball.rel_accuracy_bits() >= 60:
                break
        bits *= 2
    value = float(ball)
    if math.isinf(value):
        raise NumberLimitError("the number is too large for a float; accepted: below 1.79e308")
    return value


def floor_estimate(top: Callable[[], Ball], bottom: Callable[[], Ball], bits: int) -> int:
    """Propose floor(top / bottom) for a quotient of about 2**bits, right to one either way."""
    precision = START_BITS + bits
    while True:
        with working_precision(precision):
            ratio = top() / bottom()
            if ratio.is_finite() and ratio.rad() < 1:
                return int(ratio.mid().floor().unique_fmpz())
        precision *= 2
