"""Angles written over angles that are linearly independent over the rational numbers.

The widths of a part's steps are angles between its edges, and full of relations: they sum to a
full turn, symmetric parts have complementary ones. A sum of angles that hides them is equal to
another though nobody can see it from the terms; `AngleSum` decides that, but products of sums
(variances, mean distances) can only be compared term by term.

A direction z is a Gaussian integer. Over a coprime base of all directions and their conjugates
(`stochgeom.exact.gaussian`) z is a unit times a product of powers, so that arg z is a multiple of
an eighth of a turn plus whole multiples of the arguments of the base. Of two conjugate elements
one is enough, since their arguments are opposite; an element that is its own conjugate up to a unit
has a multiple of an eighth of a turn. What is left is linearly independent, together with a full
turn: a relation would make a product of powers of coprime elements and their conjugates a unit.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import final

from gmpy2 import mpq

from stochgeom.errors import NotRationalError
from stochgeom.exact.algebraic import is_algebraic
from stochgeom.exact.angles import Angle
from stochgeom.exact.eighths import octant
from stochgeom.exact.gaussian import Gaussian, coprime_base, divide, exponent
from stochgeom.exact.sums import AngleSum


@final
class AngleBase:
    """A base of the directions in some sums of angles.

    Parameters
    ----------
    sums : iterable of AngleSum
        Every angle in a sum to be written over the base must stand in one of them, or be an element
        of it.

    Raises
    ------
    NotRationalError
        For angles over a real algebraic field, where primes do not factor uniquely.

    Examples
    --------
    The angles of a triangle of 3-4-5 sides, in turns, and the difference of two of them:

    >>> first, second = Angle(0, (4, 3)), Angle(0, (24, 7))  # the second is twice a complement
    >>> sums = [AngleSum(0, [(1, first)]), AngleSum(0, [(1, second)])]
    >>> base = AngleBase(sums)
    >>> [len(base.write(each).terms) for each in sums], len(base.write(sums[0] * 2 + sums[1]).terms)
    ([1, 1], 0)
    """

    def __init__(self, sums: Iterable[AngleSum]) -> None:
        angles = {angle for each in sums for _, angle in each.terms}
        for angle in angles:
            if is_algebraic(angle.direction[0]):
                raise NotRationalError(
                    f"{angle} is an angle over {angle.direction[0].field}, where no independent "
                    "ones are known; accepted: angles of parts with rational vertices"
                )
        numbers = [Gaussian(*angle.direction) for angle in angles]
        self._elements = _one_of_two_conjugates(
            coprime_base([z for number in numbers for z in (number, number.conjugate())])
        )
        self._known: dict[Angle, AngleSum] = {}

    def write(self, value: AngleSum) -> AngleSum:
        """Return the same number, written over the base."""
        total = AngleSum(value.constant)
        for q, angle in value.terms:
            if angle not in self._known:
                self._known[angle] = self._expand(angle)
            total += self._known[angle] * q
        return total

    def _expand(self, angle: Angle) -> AngleSum:
        z = Gaussian(*angle.direction)
        terms = []
        rest = angle
        for element in self._elements:
            count = exponent(z, element) - exponent(z, element.conjugate())
            if count:
                direction = Angle(0, (element.re, element.im))
                terms.append((count, direction))
                for _ in range(abs(count)):
                    rest = rest - direction if count > 0 else rest + direction
        turns = rest.rational_turns
        assert turns is not None  # what is left is a power of 1 + i, real or a unit
        return AngleSum(mpq(turns), terms)


def _one_of_two_conjugates(base: list[Gaussian]) -> list[Gaussian]:
    """Return an element of each pair; those that are their own conjugates are left out.

    The one is kept whose direction is less than 22.5 degrees above a multiple of 45 degrees: the
    same for every set of angles, so that writing twice changes nothing.
    """
    return [
        element
        for element in base
        if not _is_associate(element, element.conjugate()) and _is_low(element)
    ]


def _is_low(element: Gaussian) -> bool:
    _, x, y = octant(element.re, element.im)
    return bool(y * (x + y) < x * (x - y))  # against the complement to 45 degrees; they never tie


def _is_associate(a: Gaussian, b: Gaussian) -> bool:
    """Tell whether two Gaussian integers differ by a unit."""
    return a.norm == b.norm and divide(a, b)[1]
