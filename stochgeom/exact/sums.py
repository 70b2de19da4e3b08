"""Rational combinations of angles counted in full turns: q_0 + q_1 a_1 + ... + q_k a_k.

Probabilities under exact priors are such numbers: the weight of the points in an arc is rational,
and the share of a constant density is the density times a difference of angles. Signs of their
differences are decided by `stochgeom.exact.forms`, so every comparison is exact.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import cached_property, lru_cache, total_ordering
from typing import TYPE_CHECKING, Any, Final, Protocol, final

from gmpy2 import mpq, mpz

from stochgeom.display import Displayed
from stochgeom.exact.angles import Angle, make_angle
from stochgeom.exact.balls import Ball, argument_ball, certified_float, rational_ball
from stochgeom.exact.decimals import certified_decimal, decimal_if_clear, rational_decimal
from stochgeom.exact.eighths import octant
from stochgeom.exact.forms import rational_form, refuse_terms, sign_of_form
from stochgeom.exact.predicates import sign
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.scalars import RationalLike, rational, rational_text

if TYPE_CHECKING:
    import sympy

_RATIONAL_TYPES: Final = (int, Fraction, type(mpz()), type(mpq()))


class Probability(Protocol):
    """What planners ask of a probability, whatever it is made of.

    `AngleSum` is the exact kind; `stochgeom.decision.probabilities` has a certified and an
    estimated one.
    """

    @property
    def exact(self) -> bool:
        """Whether the number is known exactly."""

    @property
    def rational(self) -> mpq | None:
        """The exact value if it is known to be rational, else None."""

    def ball(self) -> Ball:
        """Return an Arb ball around the number, at the working precision."""

    def decimal(self, digits: int = 4) -> str:
        """Return a decimal whose digits are vouched for."""

    def scaled(self, q: Any, /) -> Probability:
        """Return the number times a rational number."""

    def compare(self, other: Any, /) -> int:
        """Return -1, 0 or 1 as self is smaller than, equal to or larger than `other`."""

    def to_sympy(self) -> sympy.Expr:
        """Return an exact sympy expression; only exact numbers have one."""

    def __float__(self) -> float: ...


@final
@total_ordering
class AngleSum(Displayed):
    """The exact number constant + sum of q * a, with a the number of full turns of an angle.

    Parameters
    ----------
    constant : rational
        The constant.
    terms : iterable of (rational, Angle)
        The coefficients q and their angles.

    Attributes
    ----------
    constant, terms :
        The number in a form where everything plainly rational is gathered in `constant`, and
        each angle is a rational direction in (0, 45) degrees, no two of them equal.

    Notes
    -----
    Immutable. Two different forms may be the same number; `==` and `compare` decide that exactly.
    Building one costs a few microseconds a term.

    Examples
    --------
    >>> third = AngleSum("1/3") + AngleSum(0, [("1/2", Angle(0, (3, 2)))])
    >>> third.decimal(4), third.rational
    ('0.3801', None)

    Machin's formula: 4 arctan(1/5) - arctan(1/239) is an eighth of a turn.

    >>> AngleSum(0, [(4, Angle(0, (5, 1))), (-1, Angle(0, (239, 1)))]).rational
    mpq(1,8)
    """

    exact = True
    """Whether the number is known exactly: yes."""

    constant: mpq
    terms: tuple[tuple[mpq, Angle], ...]

    def __init__(
        self, constant: RationalLike = 0, terms: Iterable[tuple[RationalLike, Angle]] = ()
    ) -> None:
        total = rational(constant, where="constant of a sum")
        gathered: dict[Angle, mpq] = {}
        try:
            for factor, angle in terms:
                q = rational(factor, where="coefficient of a sum")
                eighths, x, y = octant(*angle.direction)
                total += q * (angle.turn_part + mpq(eighths, 8))
                if y:
                    rest = make_angle(0, x, y)
                    gathered[rest] = gathered.get(rest, mpq(0)) + q
        except (AttributeError, TypeError, ValueError) as error:
            refuse_terms(terms, error)
        self.__dict__["constant"] = total
        self.__dict__["terms"] = tuple((q, angle) for angle, q in gathered.items() if q)

    @classmethod
    def of(cls, value: AngleSum | TurnRatio | RationalLike) -> AngleSum:
        """Return a sum, a multiple of an angle or a rational number as a sum.

        Examples
        --------
        >>> AngleSum.of("1/3")
        AngleSum('1/3', [])
        """
        if isinstance(value, AngleSum):
            return value
        if isinstance(value, TurnRatio) and not value.inverse:
            return cls(0, [(value.coefficient, value.angle)])
        return cls(value)  # of an inverse: refused there

    @cached_property
    def rational(self) -> mpq | None:
        """The exact value if it is rational, else None."""
        return (
            _rational_value(self.constant, frozenset(self.terms)) if self.terms else self.constant
        )

    # --- arithmetic ------------------------------------------------------------------------------

    def scaled(self, q: RationalLike) -> AngleSum:
        """Return the number times a rational number."""
        factor = rational(q)
        if not factor:
            return _made(mpq(0), ())
        return _made(self.constant * factor, tuple((c * factor, a) for c, a in self.terms))

    def __mul__(self, q: RationalLike) -> AngleSum:
        """Return the number times a rational number."""
        return self.scaled(q) if _is_rational(q) else NotImplemented

    __rmul__ = __mul__

    def __add__(self, other: AngleSum | RationalLike) -> AngleSum:
        if not isinstance(other, AngleSum):
            if not _is_rational(other):
                return NotImplemented
            return _made(self.constant + other, self.terms)
        if not (self.terms and other.terms):
            return _made(self.constant + other.constant, self.terms or other.terms)
        gathered = {angle: q for q, angle in self.terms}
        for q, angle in other.terms:
            gathered[angle] = gathered.get(angle, 0) + q
        terms = tuple((q, angle) for angle, q in gathered.items() if q)
        return _made(self.constant + other.constant, terms)

    __radd__ = __add__

    def __sub__(self, other: AngleSum | RationalLike) -> AngleSum:
        if not isinstance(other, AngleSum) and not _is_rational(other):
            return NotImplemented
        return self + AngleSum.of(other).scaled(-1)

    def __rsub__(self, other: RationalLike) -> AngleSum:
        return self.scaled(-1) + other if _is_rational(other) else NotImplemented

    # --- comparison ------------------------------------------------------------------------------

    def sign(self) -> int:
        """Return -1, 0 or 1, exactly."""
        if not self.terms:
            return sign(self.constant)
        return sign_of_form(self.constant, self.terms)

    def compare(self, other: Any) -> int:
        """Return -1, 0 or 1 as self is smaller than, equal to or larger than `other`.

        Parameters
        ----------
        other : AngleSum, rational, or another kind of number that compares with an AngleSum
            Against the first two the answer is exact; another kind answers in its own way.

        Raises
        ------
        PrecisionLimitError
            If a certified number of another kind is still undecided at its limit.

        Examples
        --------
        >>> AngleSum(0, [(8, Angle(0, (3, 2)))]).compare("3/4")
        -1
        """
        if hasattr(other, "compare") and not isinstance(other, AngleSum | TurnRatio | Angle):
            return -int(other.compare(self))
        return (self - AngleSum.of(other)).sign()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, AngleSum) and not _is_rational(other):
            return NotImplemented
        return self is other or self.compare(other) == 0

    def __lt__(self, other: AngleSum | RationalLike) -> bool:
        if not isinstance(other, AngleSum) and not _is_rational(other):
            return NotImplemented
        return self.compare(other) < 0

    def __bool__(self) -> bool:
        """Tell whether the number is not 0, as of every kind of number."""
        return self.sign() != 0

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        # Equal numbers may be made of different angles, so only the value can be hashed.
        return hash(self.decimal(12)) if self.rational is None else hash(self.rational)

    # --- conversions -----------------------------------------------------------------------------

    def ball(self) -> Ball:
        """Return an Arb ball around the number, at the working precision."""
        total = rational_ball(self.constant)
        for q, angle in self.terms:
            total += rational_ball(q) * argument_ball(*angle.direction)
        return total

    def decimal(self, digits: int = 4) -> str:
        """Return the number as a correctly rounded decimal (ties to even)."""
        if self.terms:
            # Whether the number is rational matters for ties only, and is dear to find out.
            clear = decimal_if_clear(self.ball, digits)
            if clear is not None:
                return clear
        if self.rational is not None:
            return rational_decimal(self.rational, digits)
        return certified_decimal(self.ball, digits)

    def to_sympy(self) -> sympy.Expr:
        """Return the number as an exact sympy expression.

        Examples
        --------
        >>> AngleSum("1/3", [("1/2", Angle(0, (3, 2)))]).to_sympy()
        atan(2/3)/(4*pi) + 1/3
        """
        import sympy

        total = _sympy_rational(self.constant)
        for q, angle in self.terms:
            total += _sympy_rational(q) * angle.to_sympy() / (2 * sympy.pi)
        return total

    def __float__(self) -> float:
        return certified_float(self.ball) if self.rational is None else float(self.rational)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("an AngleSum is immutable")

    def __delattr__(self, name: str) -> None:
        raise AttributeError("an AngleSum is immutable")

    def __reduce__(self) -> tuple[Any, ...]:
        return AngleSum, (self.constant, self.terms)

    def __repr__(self) -> str:
        terms = ", ".join(f"({rational_text(q)!r}, {angle!r})" for q, angle in self.terms)
        return f"AngleSum({rational_text(self.constant)!r}, [{terms}])"

    def __str__(self) -> str:
        return self.decimal(4)


@lru_cache(maxsize=4096)
def _rational_value(constant: mpq, terms: frozenset[tuple[mpq, Angle]]) -> mpq | None:
    """Return the value if it is rational: a costly question, and hyperstates repeat their sums."""
    return rational_form(constant, terms)


def _made(constant: mpq, terms: tuple[tuple[mpq, Angle], ...]) -> AngleSum:
    """Return a sum whose terms are in canonical form already."""
    made = AngleSum.__new__(AngleSum)
    made.__dict__["constant"] = constant
    made.__dict__["terms"] = terms
    return made


def _is_rational(value: object) -> bool:
    """Tell whether a value is an exact rational number; text is none here."""
    return isinstance(value, _RATIONAL_TYPES) and not isinstance(value, bool)


def _sympy_rational(value: mpq) -> Any:
    import sympy

    return sympy.Rational(int(value.numerator), int(value.denominator))
