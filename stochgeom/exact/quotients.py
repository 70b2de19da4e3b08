"""Quotients of two sums of angles: posterior probabilities, expected costs of plans with sensors.

The sign of a sum of angles is decided for every input; a comparison of two quotients is not that
simple, for the products of angles in it are no linear form any more. It is decided exactly where
a quotient is rational, and where the products cancel term by term; otherwise the numbers are
different unless the angles satisfy an algebraic relation nobody knows of, and Arb tells which is
larger.
"""

from __future__ import annotations

from functools import cached_property, total_ordering
from typing import TYPE_CHECKING, Any, Final, TypeAlias, final

from gmpy2 import mpq

from stochgeom.errors import InputError, PrecisionLimitError
from stochgeom.exact.angles import Angle
from stochgeom.exact.balls import START_BITS, Ball, ball_sign, certified_float, working_precision
from stochgeom.exact.decimals import certified_decimal, rational_decimal
from stochgeom.exact.predicates import sign
from stochgeom.exact.scalars import from_float_exact
from stochgeom.exact.sums import AngleSum

if TYPE_CHECKING:
    import sympy

COMPARE_BITS: Final = 1 << 14
"""Quotients that are not told apart at this precision are refused as undecided."""

_Monomials: TypeAlias = "dict[frozenset[Angle | tuple[Angle, int]], mpq]"


@final
@total_ordering
class SumQuotient:
    """The exact number numerator / denominator.

    Parameters
    ----------
    numerator, denominator : AngleSum or rational
        The denominator is positive.

    Raises
    ------
    InputError
        If the denominator is not positive.

    Examples
    --------
    >>> width = AngleSum(0, [(1, Angle(0, (3, 2)))])
    >>> SumQuotient(width + 1, width).decimal(4)
    '11.6856'
    >>> SumQuotient(width * 2, width * 3).rational
    mpq(2,3)
    """

    exact = True
    """Whether the number is known exactly: yes."""

    def __init__(self, numerator: Any, denominator: Any) -> None:
        self.numerator, self.denominator = AngleSum.of(numerator), AngleSum.of(denominator)
        if self.denominator.sign() <= 0:
            raise InputError(f"denominator {self.denominator}; accepted: a positive number")

    @cached_property
    def rational(self) -> mpq | None:
        """The exact value if it is known to be rational, else None.

        It is the quotient of two like coefficients then; all of those are tried.
        """
        top, bottom = self.numerator.rational, self.denominator.rational
        if top is not None and (bottom is not None or top == 0):
            return mpq(0) if top == 0 else top / bottom
        if top is not None or bottom is not None:
            return None
        below = {angle: q for q, angle in self.denominator.terms}
        candidates = {q / below[angle] for q, angle in self.numerator.terms if angle in below}
        for value in candidates:
            if (self.numerator - self.denominator * value).sign() == 0:
                return value
        return None

    def ball(self) -> Ball:
        """Return an Arb ball around the number, at the working precision."""
        return self.numerator.ball() / self.denominator.ball()

    def decimal(self, digits: int = 4) -> str:
        """Return the number as a correctly rounded decimal (ties to even)."""
        exact = self.rational
        if exact is not None:
            return rational_decimal(exact, digits)
        return certified_decimal(self.ball, digits)

    def to_sympy(self) -> sympy.Expr:
        """Return the number as an exact sympy expression."""
        return self.numerator.to_sympy() / self.denominator.to_sympy()

    def compare(self, other: Any) -> int:
        """Return -1, 0 or 1 as self is smaller than, equal to or larger than `other`.

        Parameters
        ----------
        other : SumQuotient, AngleSum or rational
            Against a rational number the answer is exact without exception.

        Raises
        ------
        PrecisionLimitError
            If two irrational quotients are still undecided at `COMPARE_BITS`.

        Examples
        --------
        >>> width = AngleSum(0, [(1, Angle(0, (3, 2)))])
        >>> SumQuotient(width + 1, width).compare(SumQuotient(width * 2 + 2, width * 2))
        0
        """
        theirs = other if isinstance(other, SumQuotient) else SumQuotient(other, 1)
        if theirs.rational is not None:
            return int((self.numerator - self.denominator * theirs.rational).sign())
        if self.rational is not None:
            return -int(theirs.compare(self.rational))
        left = _product(self.numerator, theirs.denominator)
        right = _product(theirs.numerator, self.denominator)
        if all(left.get(key, 0) == right.get(key, 0) for key in {*left, *right}):
            return 0
        bits = START_BITS
        while bits <= COMPARE_BITS:
            with working_precision(bits):
                found = ball_sign(self.ball() - theirs.ball())
            if found is not None:
                return found
            bits *= 2
        raise PrecisionLimitError(
            f"two quotients near {float(self):.6g} are not told apart at {COMPARE_BITS} bits; "
            "they may be equal"
        )

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, SumQuotient | AngleSum | type(mpq()) | int):
            return NotImplemented
        return self.compare(other) == 0

    def __lt__(self, other: Any) -> bool:
        if not isinstance(other, SumQuotient | AngleSum | type(mpq()) | int):
            return NotImplemented
        return self.compare(other) < 0

    def __hash__(self) -> int:
        # Equal numbers may be made of different angles, so only the value can be hashed.
        return hash(self.decimal(12)) if self.rational is None else hash(self.rational)

    def __float__(self) -> float:
        return certified_float(self.ball) if self.rational is None else float(self.rational)

    def __str__(self) -> str:
        return self.decimal(4)

    def __repr__(self) -> str:
        return f"SumQuotient({self.numerator!r}, {self.denominator!r})"


def quotient(numerator: Any, denominator: Any) -> Any:
    """Return numerator / denominator: a rational number or a float where it is one.

    Parameters
    ----------
    numerator, denominator : mpq, float or AngleSum
        Of one kind, or rational beside AngleSum. The denominator is positive.

    Examples
    --------
    >>> quotient(mpq(1), mpq(3)), quotient(AngleSum("1/4"), AngleSum("1/2"))
    (mpq(1,3), mpq(1,2))
    """
    if not isinstance(numerator, AngleSum) and not isinstance(denominator, AngleSum):
        return numerator / denominator
    made = SumQuotient(numerator, denominator)
    return made if made.rational is None else made.rational


def number_sign(value: Any) -> int:
    """Return the exact sign of a number of any kind.

    Examples
    --------
    >>> number_sign(AngleSum("-1/4")), number_sign(0.5)
    (-1, 1)
    """
    return value.sign() if isinstance(value, AngleSum) else sign(value)


def number_decimal(value: Any, digits: int = 4) -> str:
    """Return a number of any kind as a decimal, correctly rounded.

    Of a float, that is its own binary value, with whatever error computing it made.

    Examples
    --------
    >>> number_decimal(mpq(2, 3)), number_decimal(0.125, 2), number_decimal(AngleSum("1/8"), 3)
    ('0.6667', '0.12', '0.125')
    """
    if isinstance(value, float):
        return rational_decimal(from_float_exact(value), digits)
    if isinstance(value, type(mpq()) | int):
        return rational_decimal(mpq(value), digits)
    return str(value.decimal(digits))


def _product(first: AngleSum, second: AngleSum) -> _Monomials:
    """Return the product, expanded: coefficients by sets of the angles in a monomial."""
    result: _Monomials = {}
    for p, a in ((first.constant, None), *first.terms):
        for q, b in ((second.constant, None), *second.terms):
            # A square is told from its root, which a set would not do.
            angles = [angle for angle in (a, b) if angle is not None]
            key = frozenset(angles) if a != b or a is None else frozenset([(angles[0], 2)])
            result[key] = result.get(key, mpq(0)) + p * q
    return result
