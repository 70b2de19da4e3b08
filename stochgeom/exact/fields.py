"""Real algebraic number fields for parts whose coordinates are not rational.

A `RealField` is L = K(s): K = Q(g) for a real root g of a monic integer polynomial, given by a
formula that encloses it to any precision, and perhaps the square root s > 0 of an element of K that
is no square there. Numbers of it are `stochgeom.exact.algebraic.Algebraic`. Two families:

- Q(sqrt d), d squarefree: g = sqrt d, no s.
- The field of the regular m-gon: g = 2 cos(2 pi / m) and s = 2 sin(2 pi / m), with s^2 = 4 - g^2.
  s is the metric factor of the polygon: its directions are x + i s y with x, y in K, and so are all
  their products, so the second half of L is needed only beside rational directions. Where 4 divides
  m, s is in K. The polygons of m = 4, 3 and 8, 12 live in Q, Q(sqrt 3), Q(sqrt 2), Q(sqrt 3).

The angles that are both a rational number of turns and the argument of a direction over L are the
multiples of 1/(2 w) turn, w the number of roots of unity of L(i): for z over L(i) with such an
argument, z / conj z is a root of unity of L(i), and 1 + zeta has half the argument of zeta. w is 4
for most quadratic fields, 8 and 12 for sqrt 2 and sqrt 3; the m-gon's L(i) is the cyclotomic field
of order lcm(4, m), with that many roots of unity.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import cache, cached_property
from math import isqrt, lcm
from typing import TYPE_CHECKING, Any, Final, final

import flint

from stochgeom.errors import NumberError, NumberLimitError
from stochgeom.exact.balls import Ball

if TYPE_CHECKING:
    import sympy

Poly = Any
"""`flint.fmpq_poly`: an element of K as a polynomial in g; python-flint ships no types for it."""

MAX_RADICAND: Final = 10**12
"""Largest whole number, above or below the line, whose square root is taken."""

MAX_ORDER: Final = 1000
"""Most vertices of an exact regular polygon."""


class RealField(ABC):
    """A real number field K(s) with its embedding; compare fields by ``is``: there is one of each.

    Attributes
    ----------
    modulus : fmpq_poly
        The monic minimal polynomial of g, with integer coefficients.
    square : fmpq_poly or None
        s^2 as a polynomial in g; None if there is no s.
    unity : int
        w, the number of roots of unity of L(i).
    symbol : str
        How g is written.
    """

    modulus: Poly
    square: Poly | None = None
    unity: int
    symbol: str

    @property
    def degree(self) -> int:
        """The degree of K over Q."""
        return int(self.modulus.degree())

    @abstractmethod
    def generator_ball(self) -> Ball:
        """Enclose g, at the working precision."""

    @abstractmethod
    def root_ball(self) -> Ball:
        """Enclose s, at the working precision."""

    @abstractmethod
    def unity_parts(self, j: int) -> tuple[tuple[Poly, Poly | None], tuple[Poly, Poly | None]]:
        """Return the cosine and the sine of 2 pi j / w, each as (a, b) of a + b s."""

    @abstractmethod
    def description(self) -> dict[str, int]:
        """Return the field as documents name it."""

    @abstractmethod
    def symbols(self) -> tuple[sympy.Expr, sympy.Expr]:
        """Return g and s as sympy expressions."""

    @cached_property
    def bits(self) -> int:
        """Working precision at which most elements show their sign: powers of g cancel."""
        return 96 + 2 * self.degree


@final
class QuadraticField(RealField):
    """Q(sqrt d), d > 1 squarefree."""

    def __init__(self, d: int) -> None:
        self.d = d
        self.modulus = flint.fmpq_poly([-d, 0, 1])
        self.unity = {2: 8, 3: 12}.get(d, 4)
        self.symbol = f"sqrt({d})"

    def generator_ball(self) -> Ball:
        """Enclose sqrt d."""
        return flint.arb(self.d).sqrt()

    def root_ball(self) -> Ball:
        """Return 0: there is no s."""
        return flint.arb(0)

    def unity_parts(self, j: int) -> tuple[tuple[Poly, Poly | None], tuple[Poly, Poly | None]]:
        """Return cosine and sine of 2 pi j / w by table and quarter turns."""
        return (self._cosine(j), None), (self._cosine(j - self.unity // 4), None)

    def _cosine(self, j: int) -> Poly:
        w = self.unity
        j = min(j % w, -j % w)  # in [0, w / 2]
        sense = -1 if 4 * j > w else 1
        j = min(j, w // 2 - j)  # in [0, w / 4]: 0 to 90 degrees
        degrees = 360 * j // w
        rows = {0: [2, 0], 30: [0, 1], 45: [0, 1], 60: [1, 0], 90: [0, 0]}  # twice the cosine
        return flint.fmpq_poly(rows[degrees]) * flint.fmpq(sense, 2)

    def symbols(self) -> tuple[sympy.Expr, sympy.Expr]:
        """Return sqrt d, and 0 for s."""
        import sympy

        return sympy.sqrt(self.d), sympy.Integer(0)

    def description(self) -> dict[str, int]:
        """Return ``{"square root of": d}``."""
        return {"square root of": self.d}

    def __reduce__(self) -> tuple[Any, ...]:
        return quadratic_field, (self.d,)

    def __repr__(self) -> str:
        return f"quadratic_field({self.d})"

    def __str__(self) -> str:
        return f"Q(sqrt({self.d}))"


@final
class CyclotomicField(RealField):
    """The field of the regular m-gon: g = 2 cos(2 pi / m), s = 2 sin(2 pi / m)."""

    def __init__(self, m: int) -> None:
        self.m = m
        self.modulus = flint.fmpq_poly(flint.fmpz_poly.cos_minpoly(m))
        self.square = None if m % 4 == 0 else flint.fmpq_poly([4, 0, -1])
        self.unity = lcm(4, m)
        self.symbol = "g"

    def generator_ball(self) -> Ball:
        """Enclose 2 cos(2 pi / m)."""
        return 2 * flint.arb.cos_pi_fmpq(flint.fmpq(2, self.m))

    def root_ball(self) -> Ball:
        """Enclose 2 sin(2 pi / m)."""
        return 2 * flint.arb.sin_pi_fmpq(flint.fmpq(2, self.m))

    def unity_parts(self, j: int) -> tuple[tuple[Poly, Poly | None], tuple[Poly, Poly | None]]:
        """Return cosine and sine of 2 pi j / w."""
        m = self.m
        if m % 4 == 0:
            return (self.cosine(j), None), (self.cosine(j - m // 4), None)
        # w = 4 m, and j / (4 m) = r / 4 + k / m: a quarter turn r times, and k times that of m.
        r = j * pow(m, -1, 4) % 4
        k = (j - r * m) // 4
        cosine, sine = (self.cosine(k), None), (flint.fmpq_poly([0]), self.sine(k))
        for _ in range(r):
            cosine, sine = _negated(sine), cosine
        return cosine, sine

    @cache  # noqa: B019 - fields are kept for good, one of each
    def cosine(self, k: int) -> Poly:
        """Return cos(2 pi k / m), with 2 cos(k t) = C_k(2 cos t), C_{k+1} = g C_k - C_{k-1}."""
        k = min(k % self.m, -k % self.m)
        g, before, here = flint.fmpq_poly([0, 1]), flint.fmpq_poly([0, 1]), flint.fmpq_poly([2])
        for _ in range(k):
            before, here = here, (g * here - before) % self.modulus
        return here * flint.fmpq(1, 2) % self.modulus

    @cache  # noqa: B019 - fields are kept for good, one of each
    def sine(self, k: int) -> Poly:
        """Return sin(2 pi k / m) / s, where there is an s.

        sin(k t) = sin t U_k(2 cos t), with U_{k+1} = g U_k - U_{k-1}.
        """
        k %= self.m
        if 2 * k > self.m:
            return -self.sine(self.m - k)
        g, before, here = flint.fmpq_poly([0, 1]), flint.fmpq_poly([-1]), flint.fmpq_poly([0])
        for _ in range(k):
            before, here = here, (g * here - before) % self.modulus
        return here * flint.fmpq(1, 2)

    def symbols(self) -> tuple[sympy.Expr, sympy.Expr]:
        """Return 2 cos(2 pi / m) and 2 sin(2 pi / m)."""
        import sympy

        angle = 2 * sympy.pi / self.m
        return 2 * sympy.cos(angle), 2 * sympy.sin(angle)

    def description(self) -> dict[str, int]:
        """Return ``{"regular polygon": m}``."""
        return {"regular polygon": self.m}

    def __reduce__(self) -> tuple[Any, ...]:
        return _cyclotomic_field, (self.m,)

    def __repr__(self) -> str:
        return f"regular_polygon_field({self.m})"

    def __str__(self) -> str:
        return f"the field of the regular {self.m}-gon"


def _negated(parts: tuple[Poly, Poly | None]) -> tuple[Poly, Poly | None]:
    a, b = parts
    return -a, None if b is None else -b


@cache
def quadratic_field(d: int) -> QuadraticField:
    """Return Q(sqrt d) for a squarefree d > 1.

    Examples
    --------
    >>> quadratic_field(3).symbol
    'sqrt(3)'
    """
    if d < 2 or squarefree_part(d) != (1, d):
        raise NumberError(f"sqrt({d}) makes no field; accepted: squarefree numbers from 2 on")
    return QuadraticField(d)


@cache
def _cyclotomic_field(m: int) -> CyclotomicField:
    return CyclotomicField(m)


def regular_polygon_field(n: int) -> RealField | None:
    """Return the field of the regular n-gon; None for the square, whose field is Q.

    The m-gon of an odd m has the directions of the 2 m-gon, so these two share a field.

    Raises
    ------
    NumberLimitError
        If n is below 3 or above `MAX_ORDER`.

    Examples
    --------
    >>> regular_polygon_field(10), regular_polygon_field(97).degree, regular_polygon_field(6)
    (regular_polygon_field(5), 48, quadratic_field(3))
    """
    if not 3 <= n <= MAX_ORDER:
        raise NumberLimitError(
            f"the field of the regular {n}-gon; accepted: 3 to {MAX_ORDER} vertices"
        )
    if n == 4:
        return None
    root = {3: 3, 6: 3, 8: 2, 12: 3}.get(n)
    if root is not None:
        return quadratic_field(root)
    return _cyclotomic_field(n // 2 if n % 4 == 2 else n)


def squarefree_part(n: int) -> tuple[int, int]:
    """Return (k, d) with n = k^2 d and d squarefree, for n in [1, `MAX_RADICAND`].

    Examples
    --------
    >>> squarefree_part(12), squarefree_part(49), squarefree_part(10**12)
    ((2, 3), (7, 1), (1000000, 1))
    """
    k, d, rest, p = 1, 1, n, 2
    # Beyond the cube root of n, what is left is a prime, two primes, or the square of one.
    while p * p * p <= rest:
        while rest % (p * p) == 0:
            rest, k = rest // (p * p), k * p
        if rest % p == 0:
            rest, d = rest // p, d * p
        p += 1
    root = isqrt(rest)
    return (k * root, d) if root * root == rest else (k, d * rest)
