"""The canonical form of a step function: checked, cut to one smallest period, merged.

Order and equality of neighbours are decided on arrays by float shadows where these are farther
apart than their error, and by exact angles elsewhere.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import Final

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.errors import InvalidStepFunctionError, NumberLimitError
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.predicates import Signs
from stochgeom.exact.shadows import shadow, shadow_error
from stochgeom.exact.vectors import AngleVector

MAX_TURNS: Final = 2**31
"""Step functions are lifted by fewer turns than this, so that step numbers fit 64 bits."""


def full_turn_share(period: Angle) -> int:
    """Return q with period = 2 pi / q.

    Raises
    ------
    InvalidStepFunctionError
        If the period is no whole share of a full turn.

    Examples
    --------
    >>> full_turn_share(Angle.from_degrees(90))
    4
    """
    turns = period.rational_turns
    if turns is None or turns <= 0 or turns.numerator != 1:
        raise InvalidStepFunctionError(
            f"period {period}; accepted: a full turn divided by a whole number"
        )
    return int(turns.denominator)


def canonical_steps(
    breaks: AngleVector, values: AngleVector, period: Angle
) -> tuple[AngleVector, AngleVector, Angle]:
    """Return breaks in [0, T), values and the smallest period T, or raise.

    O(m) for functions whose angles are directions over Q, where only 1, 2, 4 and 8 periods to
    a full turn come into question; O(m) for each divisor of m otherwise.
    """
    rises = _check_increasing(breaks, values, period)
    if not rises.all():
        # Break k stays if the value rises from step k - 1 to step k.
        keep = np.roll(rises, 1)
        breaks, values = breaks.take(keep), values.take(keep)
    breaks, values = _into_period(breaks, values, period)
    m, order = len(breaks), full_turn_share(period)
    # Rational directions differ by multiples of an eighth of a turn or by irrational turns.
    directions_only = breaks.turn_parts.dtype != object and not breaks.over_field
    # The smallest period cuts m into the most equal words; try many words first.
    for count in _divisors(m)[:-1]:
        if directions_only and 8 % (order * count):
            continue
        share = Angle.from_turns(mpq(1, order * count))
        step = m // count
        if _repeats(breaks, period, step, share) and _repeats(values, period, step, share):
            return breaks.take(slice(step)), values.take(slice(step)), share
    return breaks, values, period


def _check_increasing(breaks: AngleVector, values: AngleVector, period: Angle) -> NDArray[np.bool_]:
    """Raise unless breaks increase and values do not decrease; tell where values rise."""
    for vector, what in ((breaks, "breaks"), (values, "values")):
        if vector.largest_turn >= MAX_TURNS:
            raise NumberLimitError(
                f"lifted by 2**{vector.largest_turn.bit_length() - 1} turns or more; accepted: "
                f"fewer than {MAX_TURNS} (whole periods may be taken off all values)",
                where=what,
            )
    if not len(breaks) or len(breaks) != len(values):
        raise InvalidStepFunctionError(
            f"{len(breaks)} breaks and {len(values)} values; accepted: as many, at least one"
        )
    signs = np.empty(0, dtype=np.int8)
    for vector, what, least in ((breaks, "break", 1), (values, "value", 0)):
        signs = neighbour_signs(vector, period)
        (bad,) = np.nonzero(signs < least)
        if len(bad):
            k, n = int(bad[0]), len(vector)
            follower = (
                f"{what} {k + 1} at {vector[k + 1]}"
                if k + 1 < n
                else f"{what} 0 one period on at {vector[0] + period}"
            )
            raise InvalidStepFunctionError(
                f"{what} {k} at {vector[k]} is followed by {follower}; accepted: "
                + ("strictly increasing breaks" if least else "values that do not decrease"),
                where=f"{what} {k}",
            )
    return signs > 0


def neighbour_signs(vector: AngleVector, period: Angle) -> Signs:
    """Return the sign of a_{k+1} - a_k for k in [0, m), with a_m = a_0 + period."""
    values, n = vector.shadow, len(vector)
    gaps = np.append(values[1:], values[0] + shadow(period)) - values
    signs: Signs = np.sign(gaps).astype(np.int8)
    # Two shadows, a period and the roundings, which half the bounds would cover; what is closer
    # is decided by exact angles.
    margin = 3 * vector.error + 2 * shadow_error(period)
    for k in np.flatnonzero(np.abs(gaps) <= margin).tolist():
        follower = vector[k + 1] if k + 1 < n else vector[0] + period
        signs[k] = follower.compare(vector[k])
    return signs


def _into_period(
    breaks: AngleVector, values: AngleVector, period: Angle
) -> tuple[AngleVector, AngleVector]:
    """Lift whole periods off so that all breaks lie in [0, period), in order."""
    if breaks[0] >= ZERO and breaks[-1] < period:
        return breaks, values
    periods = breaks[0] // period
    shift = -(period * periods)
    breaks, values = breaks.rotate(shift), values.rotate(shift)
    inside = sum(1 for angle in breaks if angle < period)
    if inside == len(breaks):
        return breaks, values
    late, early = slice(inside, None), slice(inside)
    return (
        AngleVector.concatenate([breaks.take(late).rotate(-period), breaks.take(early)]),
        AngleVector.concatenate([values.take(late).rotate(-period), values.take(early)]),
    )


def _divisors(m: int) -> list[int]:
    small = [k for k in range(1, int(m**0.5) + 1) if m % k == 0]
    return sorted({*small, *(m // k for k in small)}, reverse=True)


def _repeats(vector: AngleVector, period: Angle, step: int, share: Angle) -> bool:
    """Tell whether a_{k+step} = a_k + share for all k."""
    if vector[step] != vector[0] + share:
        return False  # settles nearly every candidate
    ahead = [vector.take(slice(step, None)), vector.take(slice(step)).rotate(period)]
    return AngleVector.concatenate(ahead).equals(vector.rotate(share))


def find_rotation(word: Sequence[Hashable], target: Sequence[Hashable]) -> int | None:
    """Return the smallest k with word[k:] + word[:k] == target, or None.  O(m).

    Knuth, Morris and Pratt's search for `target` in `word` written twice.

    Examples
    --------
    >>> find_rotation("abcab", "ababc"), find_rotation("abc", "acb")
    (3, None)
    """
    m = len(target)
    fallback = [0] * m
    matched = 0
    for k in range(1, m):
        while matched and target[k] != target[matched]:
            matched = fallback[matched - 1]
        matched += target[k] == target[matched]
        fallback[k] = matched
    matched = 0
    for k in range(2 * m - 1):
        while matched and word[k % m] != target[matched]:
            matched = fallback[matched - 1]
        matched += word[k % m] == target[matched]
        if matched == m:
            return k - m + 1
    return None
