"""Quotients of two sums of angles: posterior probabilities, expected costs of plans with sensors.

The sign of a sum of angles is decided for every input; a comparison of two quotients is not that
simple, for the products of angles in it are no linear form any more. It is decided exactly where
a quotient is rational, and where the products, written in linearly independent angles, cancel term
by term; otherwise the numbers are different unless those angles satisfy an algebraic relation that
nobody knows of, and Arb tells which is larger.
"""

from __future__ import annotations

from functools import cached_property, total_ordering
from typing import TYPE_CHECKING, Any, Final, TypeAlias, final

from gmpy2 import mpq

from stochgeom.errors import InputError, PrecisionLimitError
from stochgeom.exact.angle_base import AngleBase
from stochgeom.exact.angles import Angle
from stochgeom.exact.balls import START_BITS, Ball, ball_sign, certified_float, working_precision
from stochgeom.exact.decimals import certified_decimal, rational_decimal
from stochgeom.exact.predicates import sign
from stochgeom.exact.scalars import from_float_exact
from stochgeom.exact.sums import AngleSum

if TYPE_CHECKING:
    import sympy

COMPARE_BITS: Final = 1 << 14
"""Products that are not told apart at this precision are refused as undecided."""

_Monomials: TypeAlias = "dict[frozenset[Angle | tuple[Angle, int] | None], mpq]"


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
        return sign_of_products(
            self.numerator, theirs.denominator, theirs.numerator, self.denominator
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


def sign_of_products(a: Any, b: Any, c: Any, d: Any) -> int:
    """Return the sign of a b - c d, for sums of angles or rational numbers.

    Exact, but for products that are equal by a relation between independent angles which nobody
    knows of.

    Raises
    ------
    PrecisionLimitError
        If the sign is undecided at `COMPARE_BITS`, and the products are not equal term by term.

    Examples
    --------
    >>> width = AngleSum(0, [(1, Angle(0, (3, 2)))])
    >>> sign_of_products(width + 1, width * 2, width * 2 + 2, width)
    0
    """
    sums = [AngleSum.of(each) for each in (a, b, c, d)]
    bits = START_BITS
    while bits <= COMPARE_BITS:
        with working_precision(bits):
            first, second, third, fourth = (each.ball() for each in sums)
            found = ball_sign(first * second - third * fourth)
        if found is not None:
            return found
        if bits == 2 * START_BITS and _same_products(sums):
            return 0
        bits *= 2
    raise PrecisionLimitError(
        f"two products near {float(sums[0]) * float(sums[1]):.6g} are not told apart at "
        f"{COMPARE_BITS} bits; they may be equal"
    )


def _same_products(sums: list[AngleSum]) -> bool:
    """Tell whether a b and c d are the same polynomial in independent angles."""
    base = AngleBase(sums)
    a, b, c, d = map(base.write, sums)
    left, right = _product(a, b), _product(c, d)
    return all(left.get(key, 0) == right.get(key, 0) for key in {*left, *right})


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
    """Return the product, expanded: coefficients by the angles in a monomial."""
    result: _Monomials = {}
    for p, a in ((first.constant, None), *first.terms):
        for q, b in ((second.constant, None), *second.terms):
            # A square is told from its root, which a set would not do.
            key = frozenset([(a, 2)]) if a == b and a is not None else frozenset([a, b])
            result[key] = result.get(key, mpq(0)) + p * q
    return result
