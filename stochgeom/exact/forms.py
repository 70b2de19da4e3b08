"""Signs of linear forms of angles: sign(2 pi q_0 + sum of q_k angle_k), q rational.

Every comparison of costs, probabilities and tolerances ends here. Directions whose argument is
a multiple of an eighth of a turn, and all turn parts, are gathered into one rational number
first; if nothing else is left the sign is rational arithmetic. Otherwise Arb decides at 64 and
128 bits, and if it does not, an exact test tells whether the form is zero. (Before all that, a
float64 sum is looked at, and believed if it exceeds its proven error.) The test:

    Let n_k be the integers n q_k for a common denominator n, and z_k the remaining directions.
    sum n_k arg(z_k) is a rational multiple of pi iff the product of (z_k / conj z_k)**n_k is a
    unit of Z[i], since z / conj z = exp(2 i arg z) and the roots of unity of Q(i) are its
    units. Over a coprime base of all z_k and conj z_k the product is a unit iff every exponent
    is zero. Then 2 sum n_k arg(z_k) is a multiple of a quarter turn: one whole number of eighths
    that an enclosure identifies exactly, and the form is zero iff the turns cancel.

If the form is not zero, more bits decide. Directions are never raised to a power: a 20-bit
direction to the power 10**7 would need 186 Mbit. Over a real algebraic field there is no coprime
base at hand: there the product is expanded, within a limit of size
(`stochgeom.exact.expanded_forms`).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Final, NoReturn

from gmpy2 import mpq

from stochgeom.errors import NumberError, NumberLimitError, StochgeomError
from stochgeom.exact.algebraic import is_algebraic
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
from stochgeom.exact.expanded_forms import rational_turns_over_field
from stochgeom.exact.gaussian import Gaussian, coprime_base, exponent
from stochgeom.exact.predicates import sign
from stochgeom.exact.scalars import RationalLike, common_denominator, rational
from stochgeom.exact.shadows import TWO_PI, shadow, shadow_error

_Directions = dict[tuple[Any, Any], mpq]

_LEAST: Final = 2.0**-900
_MOST: Final = 2.0**900


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
    NumberLimitError
        If an undecided form over a field would expand to more than
        `stochgeom.exact.expanded_forms.MAX_EXPANDED_BITS`.

    Examples
    --------
    Machin's formula, 4 arctan(1/5) - arctan(1/239) = 45 degrees:

    >>> sign_of_form("-1/8", [(4, Angle(0, (5, 1))), (-1, Angle(0, (239, 1)))])
    0
    >>> sign_of_form("-1/8", [(4, Angle(0, (5, 1))), (-1, Angle(0, (10**30, 1)))])
    1
    """
    start = rational(turns)
    try:
        listed = [(rational(q), angle) for q, angle in terms]
        clear = _filtered(start, listed)
    except (AttributeError, TypeError, ValueError) as error:
        refuse_terms(terms, error)
    if clear:
        return clear
    constant, directions = _gather(start, listed)
    if not directions:
        return sign(constant)

    def enclose() -> Ball:
        total = rational_ball(constant)
        for (x, y), q in directions.items():
            total += rational_ball(q) * argument_ball(x, y)
        return total

    # An expanded product is dearer than a coprime base, and may be too large: more bits first.
    tries = 7 if any(is_algebraic(x) for x, _ in directions) else 2
    for bits in (START_BITS << k for k in range(tries)):
        with working_precision(bits):
            found = ball_sign(enclose())
        if found is not None:
            return found
    # One direction that is no eighth of a turn has an irrational number of turns: not zero.
    if len(directions) > 1 and _is_zero(constant, directions):
        return 0
    return sign_by_refinement(enclose, START_BITS << tries)


def refuse_terms(terms: object, error: Exception) -> NoReturn:
    """Say what is wrong with terms over which a computation stumbled; they are not checked before.

    Raises
    ------
    NumberError
        As it was raised, or because they are no pairs of a rational number and an Angle.
    """
    if isinstance(error, StochgeomError):
        raise error
    raise NumberError(
        f"{terms!r:.60}; accepted: pairs, each a rational number and an Angle", where="terms"
    ) from error


def _filtered(turns: mpq, terms: list[tuple[mpq, Angle]]) -> int:
    """Return the sign if float64 is certain of it, else 0.

    With a_k the shadow of angle k, e_k its error bound and |a_k| <= 8 (1 + |t_k|): q_k is off by
    2**-52 of itself (gmpy2 cuts), products and partial sums of n terms by n + 2 roundings. For
    n <= 16 all of that is below 2**-45 (1 + |t_k|) |q_k| for each term, so below 4 e_k |q_k|.
    """
    if len(terms) > 16:
        return 0
    try:
        total = TWO_PI * float(turns)
        margin = abs(total) * 2.0**-45
        for q, angle in terms:
            factor = float(q)
            total += factor * shadow(angle)
            margin += abs(factor) * 5 * shadow_error(angle)
    except (NumberLimitError, OverflowError):
        return 0
    if not _LEAST < margin < _MOST:
        return 0  # close to an underflow or an overflow of one of the terms
    return bool(total > margin) - bool(total < -margin)


def _gather(constant: mpq, terms: list[tuple[mpq, Angle]]) -> tuple[mpq, _Directions]:
    """Collect everything rational into one number of turns, and the rest by direction."""
    directions: _Directions = {}
    for q, angle in terms:
        exact = angle.rational_turns
        if exact is not None:
            constant += q * exact
            continue
        constant += q * angle.turn_part
        directions[angle.direction] = directions.get(angle.direction, mpq(0)) + q
    return constant, {direction: q for direction, q in directions.items() if q}


def rational_form(
    turns: RationalLike, terms: Iterable[tuple[RationalLike, Angle]] = ()
) -> mpq | None:
    """Return ``turns + sum of q * angle`` in full turns if it is rational, else None.

    Examples
    --------
    >>> rational_form(0, [(4, Angle(0, (5, 1))), (-1, Angle(0, (239, 1)))])
    mpq(1,8)
    >>> rational_form(0, [(4, Angle(0, (5, 1)))]) is None
    True
    """
    constant, directions = _gather(rational(turns), [(rational(q), angle) for q, angle in terms])
    if not directions:
        return constant
    # One direction that is no eighth of a turn has an irrational number of turns.
    rest = _rational_turns(directions) if len(directions) > 1 else None
    return None if rest is None else constant + rest


def _is_zero(constant: mpq, directions: _Directions) -> bool:
    rest = _rational_turns(directions)
    return rest is not None and bool(constant == -rest)


def _rational_turns(directions: _Directions) -> mpq | None:
    """Return sum of q arg(z) in turns if it is rational, else None."""
    if any(is_algebraic(x) for x, _ in directions):
        return rational_turns_over_field(directions)
    denominator = common_denominator(list(directions.values()))
    powers = {Gaussian(x, y): int((q * denominator).numerator) for (x, y), q in directions.items()}
    both = [number for z in powers for number in (z, z.conjugate())]
    for element in coprime_base(both):
        total = sum(
            n * (exponent(z, element) - exponent(z.conjugate(), element)) for z, n in powers.items()
        )
        if total:
            return None
    return mpq(_whole_eighths(powers), 8 * denominator)


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
