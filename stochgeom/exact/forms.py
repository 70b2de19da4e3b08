"""Signs of linear forms of angles: sign(2 pi q_0 + sum of q_k angle_k), q rational.

Every comparison of costs, probabilities and tolerances ends here. Directions whose argument is
a multiple of an eighth of a turn, and all turn parts, are gathered into one rational number
first; if nothing else is left the sign is rational arithmetic. Otherwise Arb decides at 64 and
128 bits, and if it does not, an exact test tells whether the form is zero:

    Let n_k be the integers n q_k for a common denominator n, and z_k the remaining directions.
    sum n_k arg(z_k) is a rational multiple of pi iff the product of (z_k / conj z_k)**n_k is a
    unit of Z[i], since z / conj z = exp(2 i arg z) and the roots of unity of Q(i) are its
    units. Over a coprime base of all z_k and conj z_k the product is a unit iff every exponent
    is zero. Then 2 sum n_k arg(z_k) is a multiple of a quarter turn: one whole number of eighths
    that an enclosure identifies exactly, and the form is zero iff the turns cancel.

If the form is not zero, more bits decide. Directions are never raised to a power: a 20-bit
direction to the power 10**7 would need 186 Mbit.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from gmpy2 import mpq, mpz

from stochgeom.exact.angles import Angle
from stochgeom.exact.balls import (
    MAX_BITS,
    START_BITS,
    Ball,
    argument_ball,
    ball_sign,
    rational_ball,
    sign_by_refinement,
    working_precision,
)
from stochgeom.exact.gaussian import Gaussian, coprime_base, exponent
from stochgeom.exact.predicates import sign
from stochgeom.exact.scalars import RationalLike, common_denominator, rational

_Directions = dict[tuple[mpz, mpz], mpq]


def sign_of_form(turns: RationalLike, terms: Iterable[tuple[RationalLike, Angle]] = ()) -> int:
    """Return the exact sign of ``2 pi turns + sum of q * angle``.

    Parameters
    ----------
    turns : rational
        The constant, in full turns.
    terms : iterable of (rational, Angle)
        The coefficients q and their angles.

    Returns
    -------
    int
        -1, 0 or 1.

    Raises
    ------
    PrecisionLimitError
        If a form that is not zero is still undecided at `stochgeom.exact.balls.MAX_BITS`.

    Examples
    --------
    Machin's formula, 4 arctan(1/5) - arctan(1/239) = 45 degrees:

    >>> sign_of_form("-1/8", [(4, Angle(0, (5, 1))), (-1, Angle(0, (239, 1)))])
    0
    >>> sign_of_form("-1/8", [(4, Angle(0, (5, 1))), (-1, Angle(0, (10**30, 1)))])
    1
    """
    constant, directions = _gather(turns, terms)
    if not directions:
        return sign(constant)

    def enclose() -> Ball:
        total = rational_ball(constant)
        for (x, y), q in directions.items():
            total += rational_ball(q) * argument_ball(x, y)
        return total

    for bits in (START_BITS, 2 * START_BITS):
        with working_precision(bits):
            found = ball_sign(enclose())
        if found is not None:
            return found
    # One direction that is no eighth of a turn has an irrational number of turns: not zero.
    if len(directions) > 1 and _is_zero(constant, directions):
        return 0
    return sign_by_refinement(enclose, 4 * START_BITS)


def _gather(
    turns: RationalLike, terms: Iterable[tuple[RationalLike, Angle]]
) -> tuple[mpq, _Directions]:
    """Collect everything rational into one number of turns, and the rest by direction."""
    constant = rational(turns)
    directions: _Directions = {}
    for coefficient, angle in terms:
        q = rational(coefficient)
        exact = angle.rational_turns
        if exact is not None:
            constant += q * exact
            continue
        constant += q * angle.turn_part
        directions[angle.direction] = directions.get(angle.direction, mpq(0)) + q
    return constant, {direction: q for direction, q in directions.items() if q}


def _is_zero(constant: mpq, directions: _Directions) -> bool:
    denominator = common_denominator(list(directions.values()))
    powers = {Gaussian(x, y): int((q * denominator).numerator) for (x, y), q in directions.items()}
    both = [number for z in powers for number in (z, z.conjugate())]
    for element in coprime_base(both):
        total = sum(
            n * (exponent(z, element) - exponent(z.conjugate(), element)) for z, n in powers.items()
        )
        if total:
            return False
    return bool(constant * denominator * 8 == -_whole_eighths(powers))


def _whole_eighths(powers: dict[Gaussian, int]) -> int:
    """Return sum of n arg(z) in eighths of a turn, known to be a whole number."""
    bits = START_BITS
    while bits <= MAX_BITS:
        with working_precision(bits):
            total: Any = sum((n * argument_ball(z.re, z.im) for z, n in powers.items()), start=0)
            whole = (total * 8).unique_fmpz()
        if whole is not None:
            return int(whole)
        bits *= 2
    raise AssertionError("the enclosure of a whole number shrinks to it")  # pragma: no cover
