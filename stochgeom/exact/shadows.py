"""Float64 values of exact angles, with a proven bound on their error: to filter, never to choose.

For the angle 2 pi t + arg(x + i y):

- the components (x, y) are rounded to float64, or cut to their leading 60 bits together, or, for
  numbers of a field, within one unit in the last place: the argument moves by at most 2**-52;
- arctan2 is taken as within 4 units in the last place (a test checks numpy's and Python's against
  Arb on every platform): at most 4 ulp(pi) = 2**-49;
- adding 2 pi for the lower half plane, 2 pi t, and three roundings of values below
  8 (1 + |t|): at most 4 (1 + |t|) 2**-50.

The sum is below (1 + |t|) 2**-47; for the t of a vector of angles, or a t that is rounded towards
zero, (2 + |t|) 2**-47 is the bound used.
"""

from __future__ import annotations

from math import atan2, pi
from typing import Any, Final

from gmpy2 import mpq, mpz

from stochgeom.errors import NumberLimitError
from stochgeom.exact.algebraic import is_algebraic
from stochgeom.exact.angles import Angle

TWO_PI: Final = 2.0 * pi
ERROR_PER_TURN: Final = 2.0**-47
KEPT_BITS: Final = 60

_LEAST: Final = 2.0**-500


def shadow(angle: Angle) -> float:
    """Return an angle in radians, within `shadow_error`.

    Raises
    ------
    NumberLimitError
        For an angle beyond the largest float.

    Examples
    --------
    >>> shadow(Angle(1, (0, 1))) / TWO_PI
    1.25
    """
    x, y = angle.direction
    value = atan2(*float_direction(x, y)[::-1])
    if value < 0 and y < 0:
        value += TWO_PI
    turns = angle.turn_part
    return value + TWO_PI * _float(turns) if turns else value


def float_direction(x: Any, y: Any) -> tuple[float, float]:
    """Return floats whose argument is within 2**-52 of that of a direction."""
    if is_algebraic(x) or is_algebraic(y):
        # Each is within a 2**-52nd of the truth, which moves the argument by half of that.
        return _scaled_floats(x, y)
    shift = max(x.bit_length(), y.bit_length()) - KEPT_BITS
    if shift > 0:  # one shift for both components: float(10**400) would overflow
        x, y = x >> shift, y >> shift
    return float(int(x)), float(int(y))


def _scaled_floats(x: Any, y: Any) -> tuple[float, float]:
    try:
        right, up = float(x), float(y)
    except (NumberLimitError, OverflowError):
        scale = mpz(1) << max(x.bit_length(), y.bit_length())
        return _scaled_floats(x * mpq(1, scale), y * mpq(1, scale))
    if max(abs(right), abs(up)) < _LEAST:  # an underflow would not be within one unit
        return _scaled_floats(x * mpz(2) ** 500, y * mpz(2) ** 500)
    return right, up


def shadow_error(angle: Angle) -> float:
    """Return the bound on the error of `shadow`."""
    return (2.0 + abs(_float(angle.turn_part))) * ERROR_PER_TURN


def _float(turns: mpz | mpq) -> float:
    try:
        return float(turns)
    except OverflowError:
        raise NumberLimitError(
            "the angle is too large for a float; accepted: below 1e308 turns"
        ) from None
