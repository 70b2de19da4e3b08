"""Exact lifted angles: rational turns plus a rational direction.

An `Angle` is the real number 2 pi t + arg(x + i y) with t rational, (x, y) a non-zero vector of
integers and arg in [0, 2 pi). "Lifted" means that 370 degrees is not 10 degrees. The canonical
form is unique, so equality is equality of the parts:

- if 8 t is a whole number, its eighths are folded into the direction: t is whole, (x, y) is
  primitive;
- otherwise the eighths of the direction are folded into t, so that arg lies in [0, 45) degrees.

Why that is unique: a direction over Q whose argument is a rational multiple of pi is a multiple
of an eighth of a turn (the roots of unity of Q(i), and their square roots up to scale). Two
angles of the first kind are compared by turns, half plane and cross product; a difference whose
8 t is not whole is never zero, so ball arithmetic decides its sign.

Directions over a real algebraic field: see `stochgeom.exact.algebraic_directions`.
"""

from __future__ import annotations

from functools import total_ordering
from typing import TYPE_CHECKING, Any, Final, final

from gmpy2 import divexact, gcd, mpq, mpz

from stochgeom.errors import InputError, InvalidAngleError, NumberLimitError
from stochgeom.exact.algebraic import is_algebraic
from stochgeom.exact.algebraic_directions import algebraic_parts
from stochgeom.exact.balls import (
    Ball,
    argument_ball,
    certified_float,
    floor_estimate,
    full_turn_ball,
    rational_ball,
    sign_by_refinement,
)
from stochgeom.exact.decimals import Rounding, certified_decimal, rational_decimal
from stochgeom.exact.eighths import divide_by_eighths, eighths_of, fold
from stochgeom.exact.predicates import compare_arguments
from stochgeom.exact.scalars import RationalLike, integer_literal, is_pair, rational, rational_text
from stochgeom.exact.surds import ScalarLike, exact_scalar

if TYPE_CHECKING:
    import sympy

MAX_MULTIPLE_BITS: Final = 10_000_000
"""`n * angle` is refused when its direction would need more bits than this."""

_MPZ: Final = type(mpz())


@final
@total_ordering
class Angle:
    """The exact angle 2 pi t + arg(x + i y).

    Parameters
    ----------
    turn_part : rational, default 0
        t, in full turns.
    direction : pair of exact numbers, default (1, 0)
        (x, y), not both zero; only the direction matters, not the length. Rational numbers, or
        numbers of one real field such as ``"sqrt(2)"``.

    Notes
    -----
    Immutable and hashable. Sums and differences cost a few microseconds; the direction of a sum
    is the product of the directions, so long sums of unrelated angles grow.

    Examples
    --------
    >>> Angle(0, (3, 2)) + Angle.from_degrees("71")
    Angle('71/360', (3, 2))
    >>> Angle.from_degrees("45") == Angle(0, (1, 1))
    True
    >>> Angle(0, (1, 1)) < Angle(0, (10**40, 10**40 + 1))
    True
    """

    __slots__ = ("_t", "_x", "_y")
    _t: Any  # int when whole, else mpq
    _x: Any  # mpz, or Algebraic
    _y: Any  # the same

    def __init__(
        self,
        turn_part: RationalLike = 0,
        direction: tuple[ScalarLike, ScalarLike] = (1, 0),
    ) -> None:
        t = rational(turn_part, where="turn part of an angle")
        if not is_pair(direction):
            raise InvalidAngleError(f"direction {direction!r}; accepted: a pair of numbers")
        x, y = (exact_scalar(value, where="direction of an angle") for value in direction)
        if x == 0 and y == 0:
            raise InvalidAngleError("direction (0, 0) has no angle; accepted: any other vector")
        _fill(self, t, x, y)

    # --- makers ----------------------------------------------------------------------------------

    @classmethod
    def from_turns(cls, turns: RationalLike) -> Angle:
        """Return a rational number of full turns.

        Examples
        --------
        >>> Angle.from_turns("1/4")
        Angle(0, (0, 1))
        """
        return make_angle(rational(turns, where="turns"), mpz(1), mpz(0))

    @classmethod
    def from_degrees(cls, degrees: RationalLike) -> Angle:
        """Return a rational number of degrees; text such as ``"35.5"`` is exact.

        Examples
        --------
        >>> Angle.from_degrees("-90")
        Angle(-1, (0, -1))
        """
        return make_angle(rational(degrees, where="degrees") / 360, mpz(1), mpz(0))

    @classmethod
    def between(
        cls,
        first: tuple[ScalarLike, ScalarLike],
        second: tuple[ScalarLike, ScalarLike],
    ) -> Angle:
        """Return the counter-clockwise angle in [0, 360) degrees from one vector to another.

        Examples
        --------
        >>> Angle.between((1, 0), (1, 1)).degrees(0)
        '45'
        """
        return (cls(0, second) - cls(0, first)).reduced()

    # --- parts and conversions -------------------------------------------------------------------

    @property
    def turn_part(self) -> mpz | mpq:
        """The t of the canonical form, in turns: whole, or not a multiple of 1/8."""
        return self._t if type(self._t) is not int else mpz(self._t)

    @property
    def direction(self) -> tuple[Any, Any]:
        """The (x, y) of the canonical form: primitive integers, or numbers of a field."""
        return self._x, self._y

    @property
    def rational_turns(self) -> mpq | None:
        """The exact number of turns if it is rational, else None.

        Examples
        --------
        >>> Angle(1, (1, 1)).rational_turns, Angle(0, (2, 1)).rational_turns
        (mpq(9,8), None)
        """
        if type(self._x) is not _MPZ:
            return None  # directions over a field that are rational turns have become those
        eighths = eighths_of(self._x, self._y)
        return None if eighths is None else self._t + mpq(eighths, 8)

    def degrees(self, digits: int = 4, rounding: Rounding = Rounding.NEAREST) -> str:
        """Return degrees as a correctly rounded decimal (ties to even, unless told otherwise).

        Examples
        --------
        >>> Angle(0, (3, 2)).degrees(), Angle(0, (0, 1)).degrees(1)
        ('33.6901', '90.0')
        """
        return self._decimal(360, digits, rounding)

    def turns(self, digits: int = 4) -> str:
        """Return turns as a correctly rounded decimal (ties to even).

        Examples
        --------
        >>> Angle(2, (3, 2)).turns(6)
        '2.093584'
        """
        return self._decimal(1, digits, Rounding.NEAREST)

    def _decimal(self, unit: int, digits: int, rounding: Rounding) -> str:
        exact = self.rational_turns
        if exact is not None:
            return rational_decimal(exact * unit, digits, rounding)
        return certified_decimal(lambda: self.ball() * unit, digits, rounding)

    def ball(self) -> Ball:
        """Return an Arb ball around the number of turns, at the working precision."""
        return rational_ball(self._t) + argument_ball(self._x, self._y)

    def to_float(self) -> float:
        """Return the angle in radians as a float, within one unit in the last place.

        Raises
        ------
        NumberLimitError
            For an angle beyond the largest float.

        Examples
        --------
        >>> Angle(0, (0, 1)).to_float()
        1.5707963267948966
        """
        return certified_float(lambda: self.ball() * full_turn_ball()) if self else 0.0

    def to_sympy(self) -> sympy.Expr:
        """Return the angle in radians as an exact sympy expression.

        Examples
        --------
        >>> Angle(0, (3, 2)).to_sympy(), Angle.from_degrees("71").to_sympy()
        (atan(2/3), 71*pi/180)
        """
        import sympy

        exact = self.rational_turns
        if exact is not None:
            return 2 * sympy.pi * sympy.Rational(int(exact.numerator), int(exact.denominator))
        turns = mpq(self._t) + (1 if self._y < 0 else 0)  # sympy's atan2 is in (-pi, pi]
        whole = sympy.Rational(int(turns.numerator), int(turns.denominator))
        x, y = (v.to_sympy() if is_algebraic(v) else int(v) for v in (self._x, self._y))
        return 2 * sympy.pi * whole + sympy.atan2(y, x)

    # --- arithmetic ------------------------------------------------------------------------------

    def __add__(self, other: Angle) -> Angle:
        if not isinstance(other, Angle):
            return NotImplemented
        ax, ay, bx, by = self._x, self._y, other._x, other._y
        x, y = ax * bx - ay * by, ax * by + ay * bx
        # arg a + arg b passes a full turn exactly if the argument of the product is smaller.
        carry = compare_arguments(x, y, ax, ay) < 0
        return make_angle(self._t + other._t + carry, x, y)

    def __sub__(self, other: Angle) -> Angle:
        if not isinstance(other, Angle):
            return NotImplemented
        ax, ay, bx, by = self._x, self._y, other._x, other._y
        borrow = compare_arguments(ax, ay, bx, by) < 0
        return make_angle(self._t - other._t - borrow, ax * bx + ay * by, ay * bx - ax * by)

    def __neg__(self) -> Angle:
        return ZERO - self

    def __mul__(self, count: int) -> Angle:
        """Return the integer multiple; refused if the direction would grow past the limit."""
        try:
            n = count.__index__()
        except AttributeError:
            return NotImplemented
        exact = self.rational_turns
        if exact is not None:
            return make_angle(exact * n, mpz(1), mpz(0))
        if abs(n) * max(self._x.bit_length(), self._y.bit_length()) > MAX_MULTIPLE_BITS:
            raise NumberLimitError(
                f"{rational_text(n):.20} times {self}; accepted: directions of at most "
                f"{MAX_MULTIPLE_BITS} bits (sign_of_form compares large multiples)"
            )
        total, step = ZERO, self if n >= 0 else -self
        for bit in bin(abs(n))[2:]:
            total += total
            if bit == "1":
                total += step
        return total

    __rmul__ = __mul__

    def __divmod__(self, period: Angle) -> tuple[int, Angle]:
        """Return (n, rest) with self = n period + rest and 0 <= rest < period."""
        share = _EIGHTHS.get(period)
        if share is not None and type(self._t) is int:
            count, x, y = divide_by_eighths(self._t, self._x, self._y, share)
            return count, make_angle(0, x, y)
        if period <= ZERO:
            raise InputError(f"period {period}; accepted: positive angles")
        count = floor_estimate(self.ball, period.ball, int(abs(self._t)).bit_length())
        rest = self - period * count
        # The estimate only proposes; these exact comparisons decide.
        while rest < ZERO:
            count, rest = count - 1, rest + period
        while rest >= period:
            count, rest = count + 1, rest - period
        return count, rest

    def __floordiv__(self, period: Angle) -> int:
        return divmod(self, period)[0]

    def __mod__(self, period: Angle) -> Angle:
        return divmod(self, period)[1]

    def reduced(self) -> Angle:
        """Return the angle modulo a full turn, in [0, 360) degrees."""
        return divmod(self, FULL_TURN)[1]

    # --- comparison ------------------------------------------------------------------------------

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Angle):
            return NotImplemented
        same = bool(self._x == other._x and self._y == other._y and self._t == other._t)
        if same or (type(self._x) is _MPZ and type(other._x) is _MPZ):
            return same
        return not self - other

    def __hash__(self) -> int:
        # An angle over a field may equal one over Q whose turns are not whole: the value is common.
        if type(self._x) is not _MPZ or (self._y and type(self._t) is not int):
            return hash(self.turns(12))
        return hash((self._t, self._x, self._y))

    def __lt__(self, other: Angle) -> bool:
        if not isinstance(other, Angle):
            return NotImplemented
        return self.compare(other) < 0

    def compare(self, other: Angle) -> int:
        """Return -1, 0 or 1 as self is smaller than, equal to or larger than `other`."""
        t, u = self._t, other._t
        if type(t) is int and type(u) is int:
            if t != u:
                return -1 if t < u else 1
            return compare_arguments(self._x, self._y, other._x, other._y)
        difference = self - other
        if type(difference._t) is int:
            return difference._whole_sign()
        return sign_by_refinement(difference.ball)  # never zero, see the module docstring

    def _whole_sign(self) -> int:
        if self._t < 0:
            return -1
        return 1 if self._t > 0 or self._y != 0 or self._x < 0 else 0

    def __bool__(self) -> bool:
        """Tell whether the angle is other than zero degrees (360 degrees is True)."""
        return bool(self._t != 0 or self._y != 0 or self._x < 0)

    # --- immutability, text ----------------------------------------------------------------------

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("an Angle is immutable")

    def __delattr__(self, name: str) -> None:
        raise AttributeError("an Angle is immutable")

    def __reduce__(self) -> tuple[Any, ...]:
        return Angle, (self.turn_part, self.direction)

    def __repr__(self) -> str:
        t = integer_literal(self._t) if type(self._t) is int else repr(rational_text(self._t))
        if type(self._x) is not _MPZ:
            return f"Angle({t}, ({self._x!r}, {self._y!r}))"
        return f"Angle({t}, ({integer_literal(self._x)}, {integer_literal(self._y)}))"

    def __str__(self) -> str:
        return f"{self.degrees(4)}°"

    def _repr_latex_(self) -> str:
        import sympy

        return f"$\\displaystyle {sympy.latex(self.to_sympy())}$"


def make_angle(t: Any, x: Any, y: Any) -> Angle:
    """Return the canonical angle of exact parts (t int or mpq; x, y exact, not both 0)."""
    angle = object.__new__(Angle)
    _fill(angle, t, x, y)
    return angle


# The slots' own setters, which pass by the class's refusal to set attributes.
_set_t, _set_x, _set_y = (vars(Angle)[name].__set__ for name in Angle.__slots__)


def _fill(angle: Angle, t: Any, x: Any, y: Any) -> None:
    if type(x) is not _MPZ or type(y) is not _MPZ:
        if type(x) is int and type(y) is int:
            x, y = mpz(x), mpz(y)
        else:
            t, x, y = algebraic_parts(t, x, y)
    if type(x) is _MPZ:
        if type(t) is not int:
            t, x, y = fold(t, x, y)
        common = gcd(x, y)
        if common != 1:
            x, y = divexact(x, common), divexact(y, common)
    _set_t(angle, t)
    _set_x(angle, x)
    _set_y(angle, y)


ZERO: Final = Angle(0, (1, 0))
EIGHTH_TURN: Final = Angle(0, (1, 1))
QUARTER_TURN: Final = Angle(0, (0, 1))
HALF_TURN: Final = Angle(0, (-1, 0))
FULL_TURN: Final = Angle(1, (1, 0))

_EIGHTHS: Final = {EIGHTH_TURN: 1, QUARTER_TURN: 2, HALF_TURN: 4, FULL_TURN: 8}
