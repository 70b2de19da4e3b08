"""Gaussian integers: greatest common divisor and coprime bases.

A coprime base of a set of Gaussian integers is a list of pairwise coprime non-units such that
every member of the set is a unit times a product of powers of base elements. Pairwise coprime
non-units are multiplicatively independent up to units, which is what turns "is this sum of
angles a rational multiple of pi" into "are these integer exponents zero", with no factoring
(D. J. Bernstein, Factoring into coprimes in essentially linear time, 2005; here the plain
quadratic refinement, since the sets are small).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from gmpy2 import f_div, mpz


class Gaussian(NamedTuple):
    """The Gaussian integer re + i im."""

    re: mpz
    im: mpz

    @property
    def norm(self) -> mpz:
        """The square of the absolute value; 1 exactly for the units."""
        return self.re * self.re + self.im * self.im

    def conjugate(self) -> Gaussian:
        """Return re - i im."""
        return Gaussian(self.re, -self.im)


def divide(a: Gaussian, b: Gaussian) -> tuple[Gaussian, bool]:
    """Return the Gaussian integer nearest to a / b, and whether it is the exact quotient.

    Examples
    --------
    >>> divide(Gaussian(5, 0), Gaussian(2, 1))
    (Gaussian(re=mpz(2), im=mpz(-1)), True)
    """
    norm = b.norm
    re = a.re * b.re + a.im * b.im
    im = a.im * b.re - a.re * b.im
    q_re, q_im = f_div(2 * re + norm, 2 * norm), f_div(2 * im + norm, 2 * norm)
    return Gaussian(q_re, q_im), q_re * norm == re and q_im * norm == im


def gcd(a: Gaussian, b: Gaussian) -> Gaussian:
    """Return a greatest common divisor (unique up to a unit) by Euclid's algorithm.

    The rounded quotient leaves a remainder of at most half the norm, so the number of divisions
    is at most the bit length of the smaller norm.

    Examples
    --------
    >>> gcd(Gaussian(5, 0), Gaussian(3, 1)).norm
    mpz(5)
    """
    while b.re or b.im:
        q, _ = divide(a, b)
        a, b = b, Gaussian(a.re - q.re * b.re + q.im * b.im, a.im - q.re * b.im - q.im * b.re)
    return a


def coprime_base(numbers: Iterable[Gaussian]) -> list[Gaussian]:
    """Return pairwise coprime non-units that generate all the given non-zero numbers.

    Examples
    --------
    >>> base = coprime_base([Gaussian(mpz(10), mpz(0)), Gaussian(mpz(2), mpz(1))])
    >>> sorted(int(element.norm) for element in base)
    [5, 20]
    """
    base: list[Gaussian] = []
    waiting = [number for number in numbers if number.norm > 1]
    while waiting:
        # Invariant: base is pairwise coprime; base and waiting together generate the input.
        number = waiting.pop()
        for place, element in enumerate(base):
            common = gcd(number, element)
            if common.norm == 1:
                continue
            del base[place]
            rests = (divide(number, common)[0], divide(element, common)[0])
            # Each product of norms over waiting and base falls by the norm of `common`.
            waiting.extend(g for g in (common, *rests) if g.norm > 1)
            break
        else:
            base.append(number)
    return base


def exponent(number: Gaussian, element: Gaussian) -> int:
    """Return how often the non-unit `element` divides `number`.

    Examples
    --------
    >>> exponent(Gaussian(mpz(8), mpz(0)), Gaussian(mpz(1), mpz(1)))
    6
    """
    count = 0
    while True:
        quotient, exact = divide(number, element)
        if not exact:
            return count
        number = quotient
        count += 1
