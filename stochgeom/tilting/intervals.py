"""Confidence intervals for a share: successes of independent trials."""

from __future__ import annotations

import math
from numbers import Real
from statistics import NormalDist

from stochgeom.arguments import as_count
from stochgeom.errors import InputError


def wilson_interval(successes: int, trials: int, level: float = 0.95) -> tuple[float, float]:
    """Return the score interval of Wilson for a probability.

    It keeps its level where the share is near 0 or 1, unlike share plus or minus two standard
    errors, and never leaves [0, 1].

    Parameters
    ----------
    successes, trials : int
        Counts; at least one trial.
    level : float, default 0.95
        Above 0, below 1.

    Raises
    ------
    InputError
        If the counts or the level are none.

    Examples
    --------
    >>> [round(end, 4) for end in wilson_interval(126, 250)]
    [0.4424, 0.5654]
    >>> [round(end, 4) for end in wilson_interval(250, 250)]
    [0.9849, 1.0]
    """
    trials = as_count(trials, "trials")
    successes = as_count(successes, "successes", least=0, most=trials)
    check_level(level)
    z = NormalDist().inv_cdf((1 + level) / 2)
    share, spread = successes / trials, z * z / trials
    middle = (share + spread / 2) / (1 + spread)
    half = math.sqrt(spread * (share * (1 - share) + spread / 4)) / (1 + spread)
    low = 0.0 if successes == 0 else max(0.0, middle - half)
    high = 1.0 if successes == trials else min(1.0, middle + half)
    return low, high


def check_level(level: float) -> None:
    """Refuse what is no level of confidence.

    Raises
    ------
    InputError
        If it is no number between 0 and 1.
    """
    if not isinstance(level, Real) or not 0 < level < 1:
        raise InputError(f"a level of {level!r:.60}; accepted: above 0, below 1")
