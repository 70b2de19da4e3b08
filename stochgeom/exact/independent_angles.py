"""Sums of angles over angles that are linearly independent over the rational numbers.

The angles of different directions can depend on each other: 2 arctan(1/2) and arctan(3/4) make a
quarter turn. Over a coprime base of the Gaussian integers z and their conjugates, z / conj z is a
unit times a product of powers of base elements; sum of q arg z is a rational number of turns
exactly if the same combination of the exponents vanishes (`stochgeom.exact.forms`). So dependence
of angles is dependence of integer vectors, which elimination decides.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from gmpy2 import mpq

from stochgeom.exact.angles import Angle
from stochgeom.exact.forms import rational_form
from stochgeom.exact.gaussian import Gaussian, coprime_base, exponent
from stochgeom.exact.sums import AngleSum

Independent: TypeAlias = "tuple[mpq, dict[Angle, mpq]]"
"""A constant, and coefficients of angles, all other than 0."""


def over_independent(sums: Sequence[AngleSum]) -> list[Independent]:
    """Return sums as combinations of 1 and of some of their angles that are independent with it.

    Over such angles a sum is 0 exactly if its constant and all its coefficients are.

    Examples
    --------
    >>> a, b = Angle(0, (2, 1)), Angle(0, (4, 3))
    >>> over_independent([AngleSum(0, [(1, a)]), AngleSum(0, [(2, a), (1, b)])])
    [(mpq(0,1), {Angle(0, (2, 1)): mpq(1,1)}), (mpq(1,4), {})]
    """
    angles = list(dict.fromkeys(angle for each in sums for _, angle in each.terms))
    written = _written(angles)
    found = []
    for each in sums:
        constant, factors = each.constant, dict[Angle, mpq]()
        for q, angle in each.terms:
            turns, combination = written[angle]
            constant += q * turns
            for other, factor in combination.items():
                factors[other] = factors.get(other, mpq(0)) + q * factor
        found.append((constant, {angle: q for angle, q in factors.items() if q}))
    return found


def _written(angles: list[Angle]) -> dict[Angle, Independent]:
    """Return each angle over the first independent ones of the list."""
    numbers = {angle: Gaussian(*angle.direction) for angle in angles}
    both = [z for number in numbers.values() for z in (number, number.conjugate())]
    base = coprime_base(both)
    # Rows in echelon form, each with the combination of angles that it is.
    rows: list[tuple[int, list[mpq], dict[Angle, mpq]]] = []
    written: dict[Angle, Independent] = {}
    for angle, z in numbers.items():
        vector = [mpq(exponent(z, e) - exponent(z.conjugate(), e)) for e in base]
        used: dict[Angle, mpq] = {}
        # Invariant: vector + sum of used * (vectors of those angles) is that of `angle`.
        for pivot, row, combination in rows:
            factor = vector[pivot] / row[pivot]
            if factor:
                vector = [a - factor * b for a, b in zip(vector, row, strict=True)]
                for other, share in combination.items():
                    used[other] = used.get(other, mpq(0)) + factor * share
        pivot = next((k for k, value in enumerate(vector) if value), -1)
        if pivot >= 0:
            own = {other: -share for other, share in used.items()}
            rows.append((pivot, vector, {**own, angle: mpq(1)}))
            written[angle] = mpq(0), {angle: mpq(1)}
        else:
            used = {other: share for other, share in used.items() if share}
            rest = [(mpq(1), angle), *((-share, other) for other, share in used.items())]
            turns = rational_form(0, rest)
            assert turns is not None
            written[angle] = turns, used
    return written
