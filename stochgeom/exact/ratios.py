"""Numbers proportional to an angle or to the inverse of one: probabilities and expected costs.

A `TurnRatio` is the exact number c a or c / a, with c rational and a an angle in full turns.
A probability under a uniform prior is h / (2 pi); an expected cost is (i + c) 2 pi / h.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import total_ordering
from typing import TYPE_CHECKING, Any, final

from gmpy2 import mpq

from stochgeom.display import Displayed
from stochgeom.errors import InputError
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.balls import Ball, certified_float, rational_ball
from stochgeom.exact.decimals import certified_decimal, rational_decimal
from stochgeom.exact.forms import sign_of_form
from stochgeom.exact.predicates import sign
from stochgeom.exact.scalars import RationalLike, rational

if TYPE_CHECKING:
    import sympy


@final
@total_ordering
@dataclass(frozen=True, slots=True, eq=False)
class TurnRatio(Displayed):
    """The exact positive number coefficient * a, or coefficient / a if `inverse`.

    Parameters
    ----------
    coefficient : rational
        At least 0.
    angle : Angle
        Positive; a is its number of full turns.
    inverse : bool
        Which of the two is meant.

    Examples
    --------
    >>> quarter = Angle.from_degrees(90)
    >>> TurnRatio(mpq(2), quarter, inverse=True).rational
    mpq(8,1)
    >>> TurnRatio(mpq(1), Angle(0, (3, 2))).decimal(4)
    '0.0936'
    """

    coefficient: mpq
    angle: Angle
    inverse: bool = False

    exact = True

    def __post_init__(self) -> None:
        exact = rational(self.coefficient, where="coefficient of a ratio")
        object.__setattr__(self, "coefficient", exact)
        if self.coefficient < 0 or self.angle <= ZERO:
            raise InputError(
                f"ratio of {self.coefficient} and {self.angle}; "
                "accepted: a coefficient of 0 or more and a positive angle"
            )

    @property
    def rational(self) -> mpq | None:
        """The exact value if it is rational, else None."""
        turns = self.angle.rational_turns
        if turns is None:
            return mpq(0) if self.coefficient == 0 else None
        return self.coefficient / turns if self.inverse else self.coefficient * turns

    def ball(self) -> Ball:
        """Return an Arb ball around the number, at the working precision."""
        c, a = rational_ball(self.coefficient), self.angle.ball()
        return c / a if self.inverse else c * a

    def scaled(self, q: RationalLike) -> TurnRatio:
        """Return the number times a rational number of 0 or more."""
        return TurnRatio(self.coefficient * rational(q), self.angle, self.inverse)

    def decimal(self, digits: int = 4) -> str:
        """Return the number as a correctly rounded decimal (ties to even)."""
        exact = self.rational
        if exact is not None:
            return rational_decimal(exact, digits)
        return certified_decimal(self.ball, digits)

    def to_sympy(self) -> sympy.Expr:
        """Return the number as an exact sympy expression.

        Examples
        --------
        >>> TurnRatio(mpq(2), Angle(0, (3, 2)), inverse=True).to_sympy()
        4*pi/atan(2/3)
        """
        import sympy

        c = sympy.Rational(int(self.coefficient.numerator), int(self.coefficient.denominator))
        turns = self.angle.to_sympy() / (2 * sympy.pi)
        return c / turns if self.inverse else c * turns

    def compare(self, other: Any) -> int:
        """Return -1, 0 or 1, exactly.

        Parameters
        ----------
        other : TurnRatio, rational number, or number of another kind
            Sums, enclosures and costs compare themselves with ratios.

        Raises
        ------
        InputError
            For c a against d / b with both angles irrational: no linear form decides that.
        """
        if not isinstance(other, TurnRatio):
            if hasattr(other, "decimal"):
                return -int(other.compare(self))
            return self._compare_rational(rational(other))
        mine, theirs = self.rational, other.rational
        if theirs is not None:
            return self._compare_rational(theirs)
        if mine is not None:
            return -other._compare_rational(mine)
        if self.inverse != other.inverse:
            raise InputError(f"{self!r} and {other!r} are not comparable by a linear form")
        if self.inverse:  # c / a < d / b  iff  c b < d a
            return sign_of_form(
                0, [(self.coefficient, other.angle), (-other.coefficient, self.angle)]
            )
        return sign_of_form(0, [(self.coefficient, self.angle), (-other.coefficient, other.angle)])

    def _compare_rational(self, value: mpq) -> int:
        if value <= 0:
            return sign(self.coefficient) if value == 0 else 1
        if self.inverse:  # c / a < v  iff  c - v a < 0
            return sign_of_form(self.coefficient, [(-value, self.angle)])
        return sign_of_form(-value, [(self.coefficient, self.angle)])

    def __eq__(self, other: object) -> bool:
        if isinstance(other, str):  # equal values must have equal hashes
            return NotImplemented
        try:
            return self.compare(other) == 0
        except InputError:
            return NotImplemented

    def __lt__(self, other: Any) -> bool:
        if isinstance(other, str):
            return NotImplemented
        return self.compare(other) < 0

    def __hash__(self) -> int:
        # Equal numbers may be made of different angles, so only the value can be hashed.
        exact = self.rational
        return hash(self.decimal(12)) if exact is None else hash(exact)

    def __float__(self) -> float:
        exact = self.rational
        return certified_float(self.ball) if exact is None else float(exact)

    def __str__(self) -> str:
        return self.decimal(4)
