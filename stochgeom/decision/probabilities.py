"""Probabilities of three kinds: exact, certified by balls, and estimated.

`AngleSum` is the exact kind: comparisons are decided. `Enclosed` is a real number that ball
arithmetic encloses as tightly as asked: comparisons of different numbers are decided too, and equal
ones are recognised if they are made alike. `Estimated` is a float with an estimate of its error.
All three satisfy `Probability`, so planners need not know which one they hold.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Final, final

import flint
from gmpy2 import mpq

from stochgeom.errors import InputError, PrecisionLimitError
from stochgeom.exact.balls import START_BITS, Ball, ball_sign, rational_ball, working_precision
from stochgeom.exact.decimals import certified_decimal, check_digits, rational_decimal
from stochgeom.exact.scalars import RationalLike, from_float_exact
from stochgeom.exact.scalars import rational as as_rational
from stochgeom.exact.sums import AngleSum, Probability

__all__ = ["COMPARE_BITS", "AngleSum", "Atom", "Enclosed", "Estimated", "Probability"]

COMPARE_BITS: Final = 1 << 12
"""Enclosed numbers are compared up to this precision: balls of integrals are expensive."""


@final
@dataclass(frozen=True)
class Atom:
    """A real number that a function encloses; equal keys mean equal numbers.

    Attributes
    ----------
    key : hashable
        What makes the number.
    enclose : callable
        Returns an Arb ball around the number, at the working precision.
    """

    key: Hashable
    enclose: Callable[[], Ball] = field(compare=False, repr=False)


@final
class Enclosed:
    """A rational combination of enclosed numbers, plus an exact one.

    Parameters
    ----------
    atoms : iterable of (rational, Atom)
        The factors and the enclosed numbers.
    constant : AngleSum, default 0
        What is added to them.

    Notes
    -----
    A combination is equal to another if they are so term by term. Beyond that, numbers of this
    kind are taken for irrational and different: `decimal` of one that is half way between two
    decimals, and `compare` of two that are equal for another reason, end with
    PrecisionLimitError.

    Examples
    --------
    >>> root = Enclosed.of(lambda: flint.arb(2).sqrt() / 2)
    >>> root.decimal(6), root.compare("0.7071067811865475")
    ('0.707107', 1)
    >>> (root + root).compare(root.scaled(2))
    0
    """

    exact = False
    """Whether the number is known exactly: no."""

    rational = None
    """The exact value, if it were known to be rational."""

    def __init__(
        self, atoms: Iterable[tuple[RationalLike, Atom]], constant: AngleSum | None = None
    ) -> None:
        gathered: dict[Atom, mpq] = {}
        for factor, atom in atoms:
            gathered[atom] = gathered.get(atom, mpq(0)) + as_rational(factor)
        self._factors = {atom: factor for atom, factor in gathered.items() if factor}
        self._constant = AngleSum() if constant is None else constant

    @classmethod
    def of(cls, enclose: Callable[[], Ball], key: Hashable = None) -> Enclosed:
        """Return the number that a function encloses, known by `key` if it has one."""
        return cls([(1, Atom(object() if key is None else key, enclose))])

    def ball(self) -> Ball:
        """Return a ball around the number, at the working precision."""
        total = self._constant.ball()
        for atom, factor in self._factors.items():
            total += atom.enclose() * rational_ball(factor)
        return total

    def decimal(self, digits: int = 4) -> str:
        """Return the number as a correctly rounded decimal."""
        if not self._factors:
            return self._constant.decimal(digits)
        return certified_decimal(self.ball, digits)

    def scaled(self, q: RationalLike) -> Enclosed:
        """Return the number times a rational number."""
        factor = as_rational(q)
        atoms = [(factor * f, atom) for atom, f in self._factors.items()]
        return Enclosed(atoms, self._constant.scaled(factor))

    def simplified(self) -> Enclosed | AngleSum:
        """Return the number as an exact one if all enclosed numbers have cancelled.

        Examples
        --------
        >>> root = Enclosed.of(lambda: flint.arb(2).sqrt(), key="root")
        >>> (root + AngleSum(1) + root.scaled(-1)).simplified()
        AngleSum('1', [])
        """
        return self if self._factors else self._constant

    def __add__(self, other: Any) -> Enclosed:
        if isinstance(other, Enclosed):
            both = (*self._factors.items(), *other._factors.items())
            return Enclosed([(f, atom) for atom, f in both], self._constant + other._constant)
        if isinstance(other, AngleSum):
            atoms = [(f, atom) for atom, f in self._factors.items()]
            return Enclosed(atoms, self._constant + other)
        return NotImplemented

    __radd__ = __add__

    def compare(self, other: Any) -> int:
        """Return -1, 0 or 1; equal only if equal term by term.

        Raises
        ------
        PrecisionLimitError
            If the order is still undecided at `COMPARE_BITS`.
        """
        if isinstance(other, Estimated):
            return -other.compare(self)
        theirs = other if isinstance(other, Enclosed) else AngleSum.of(other)
        difference = self + theirs.scaled(-1)
        if not difference._factors:
            return difference._constant.sign()
        bits = START_BITS
        while bits <= COMPARE_BITS:
            with working_precision(bits):
                found = ball_sign(difference.ball())
            if found is not None:
                return found
            bits *= 2
        raise PrecisionLimitError(
            f"two certified numbers near {float(self):.6g} are not told apart at "
            f"{COMPARE_BITS} bits; they may be equal"
        )

    def __lt__(self, other: Any) -> bool:
        if not isinstance(other, Enclosed):
            return NotImplemented
        return self.compare(other) < 0

    def to_sympy(self) -> Any:
        """Refuse: the number is known by its enclosures only."""
        raise InputError("a number known by enclosures has no sympy form; accepted: exact numbers")

    def __float__(self) -> float:
        with working_precision(2 * START_BITS):
            return float(self.ball().mid())

    def __str__(self) -> str:
        return self.decimal(4)

    def __repr__(self) -> str:
        return f"<Enclosed {float(self):.6g}>"


@final
@dataclass(frozen=True)
class Estimated:
    """A number computed in floats, with an estimate of its error.

    Parameters
    ----------
    value : float
        The number.
    error : float
        How far it may be off, as far as the method that computed it can tell. No proof.

    Examples
    --------
    >>> number = Estimated(0.123456, 2e-5)
    >>> number.decimal(6), str(number), number.compare("0.12347"), number.compare("0.1236")
    ('0.123', '0.123', 0, -1)
    """

    value: float
    error: float

    exact = False
    rational = None

    def __post_init__(self) -> None:
        # NaN fails both comparisons.
        if not (abs(self.value) < float("inf") and 0 <= self.error < float("inf")):
            raise InputError(
                f"the estimate {self.value} +- {self.error}; accepted: finite numbers, error >= 0"
            )

    @cached_property
    def bounds(self) -> tuple[mpq, mpq]:
        """The ends of the interval that the error spans."""
        value, error = from_float_exact(self.value), from_float_exact(self.error)
        return value - error, value + error

    def ball(self) -> Ball:
        """Return the interval that the error spans, as a ball."""
        return flint.arb(self.value, self.error)

    def decimal(self, digits: int = 4) -> str:
        """Return as many of the decimals asked for as the error leaves certain.

        The whole number alone is given even if it is not.
        """
        low, high = self.bounds
        for count in range(check_digits(digits), 0, -1):
            text = rational_decimal(low, count)
            if text == rational_decimal(high, count):
                return text
        return rational_decimal((low + high) / 2, 0)

    def scaled(self, q: RationalLike) -> Estimated:
        """Return the number, and its error, times a rational number."""
        factor = float(as_rational(q))
        return Estimated(self.value * factor, self.error * abs(factor))

    def __add__(self, other: Any) -> Estimated:
        if isinstance(other, Estimated):
            return Estimated(self.value + other.value, self.error + other.error)
        if isinstance(other, AngleSum | Enclosed):
            return Estimated(self.value + float(other), self.error + 2.0**-52)
        return NotImplemented

    __radd__ = __add__

    def compare(self, other: Any) -> int:
        """Return -1 or 1 if the errors leave no doubt, else 0: not told apart."""
        if isinstance(other, Estimated):
            low, high = other.bounds
        elif isinstance(other, Enclosed):
            value = from_float_exact(float(other))
            slack = abs(value) / 2**50
            low, high = value - slack, value + slack
        else:
            number = AngleSum.of(other)
            mine = self.bounds
            above = number.compare(mine[1]) > 0
            return -1 if above else int(number.compare(mine[0]) < 0)
        if self.bounds[1] < low:
            return -1
        return int(self.bounds[0] > high)

    def to_sympy(self) -> Any:
        """Refuse: the number is an estimate."""
        raise InputError("an estimated number has no sympy form; accepted: exact numbers")

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        return self.decimal(4)
