"""Products of two sums of angles, enclosed, with equal products known to be equal.

A probability that is a sum of angles, times another or times a distance, is no sum of angles any
more. It is expanded over products of two angles, each an enclosed number that is known by its
angles: two expansions are equal if they are so term by term, and different ones are told apart by
Arb. Factors written over one `stochgeom.exact.angle_base.AngleBase` hide no relations.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, final

import flint

from stochgeom.decision.probabilities import Atom, Enclosed
from stochgeom.exact.angles import Angle
from stochgeom.exact.balls import Ball
from stochgeom.exact.sums import AngleSum


@final
@dataclass(frozen=True)
class Cosine:
    """The cosine of an angle, as a factor of a product."""

    angle: Angle

    def ball(self) -> Ball:
        """Return an Arb ball around the number, at the working precision."""
        return (2 * flint.arb.pi() * self.angle.ball()).cos()


def product(first: Any, second: Any, cosine: Cosine | None = None) -> Enclosed:
    """Return first * second, or first * second * cosine.

    Parameters
    ----------
    first, second : AngleSum or rational
        The factors.
    cosine : Cosine, optional
        An irrational one; rational cosines are factors of their own.

    Examples
    --------
    >>> width = AngleSum(0, [(1, Angle(0, (3, 2)))])
    >>> square = product(width, width)
    >>> square.decimal(6), product(1 - width, 1 - width).compare(square + (1 - 2 * width))
    ('0.008758', 0)
    """
    constant = AngleSum()
    atoms = []
    for p, a in _terms(first):
        for q, b in _terms(second):
            angles = tuple(sorted([*a, *b]))
            if cosine is None and len(angles) < 2:
                # What is linear stays a sum of angles: its ties with decimals are recognised.
                single = [(p * q, angle) for angle in angles]
                constant += AngleSum(0, single) if single else AngleSum(p * q)
            else:
                atoms.append((p * q, Atom((angles, cosine), _monomial(angles, cosine))))
    return Enclosed(atoms, constant)


def _terms(value: Any) -> list[tuple[Any, tuple[Angle, ...]]]:
    number = AngleSum.of(value)
    return [(number.constant, ()), *((q, (angle,)) for q, angle in number.terms)]


def _monomial(angles: tuple[Angle, ...], cosine: Cosine | None) -> Callable[[], Ball]:
    def enclose() -> Ball:
        total = flint.arb(1) if cosine is None else cosine.ball()
        for angle in angles:
            total *= angle.ball()
        return total

    return enclose
