"""What the posterior says beyond its mean: medians, intervals, samples, checks (thesis 6.3.1).

One entry of a row has a Beta distribution, a whole row a Dirichlet distribution. Quantiles are
floats from scipy (extra `numeric`); samples are numpy's, by seed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import lgamma
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from stochgeom.arguments import as_count, as_list, expect
from stochgeom.errors import InputError, MissingExtraError, RecordingError
from stochgeom.tilting.counts import Outcome, TransitionCounts, numbered
from stochgeom.tilting.estimation import TransitionModel
from stochgeom.tilting.intervals import check_level

Floats = NDArray[np.float64]


def posterior_median(model: TransitionModel, action: int, state: int, outcome: Outcome) -> float:
    """Return the median of one entry: the estimate of least absolute error.

    Medians of a row need not add up to 1.

    Raises
    ------
    MissingExtraError
        If scipy is not installed.

    Examples
    --------
    >>> model = TransitionModel(TransitionCounts([[[3, 1]]]), alpha=1)
    >>> round(posterior_median(model, 1, 1, 1), 4)
    0.6862
    """
    expect(model, TransitionModel, "TransitionModel(counts)")
    a, b = model.marginal(action, state, outcome)
    return float(_beta().ppf(0.5, float(a), float(b)))


def credible_interval(
    model: TransitionModel, action: int, state: int, outcome: Outcome, level: float = 0.95
) -> tuple[float, float]:
    """Return the interval that holds one entry with probability `level`, as much on either side.

    Raises
    ------
    InputError
        If the level is not between 0 and 1.
    MissingExtraError
        If scipy is not installed.

    Examples
    --------
    >>> model = TransitionModel(TransitionCounts([[[3, 1]]]), alpha=1)
    >>> [round(end, 3) for end in credible_interval(model, 1, 1, 1, 0.9)]
    [0.343, 0.924]
    """
    expect(model, TransitionModel, "TransitionModel(counts)")
    check_level(level)
    a, b = map(float, model.marginal(action, state, outcome))
    low, high = _beta().ppf([(1 - level) / 2, (1 + level) / 2], a, b)
    return float(low), float(high)


def sample_matrices(model: TransitionModel, draws: int, seed: int = 0) -> Floats:
    """Draw transition matrices from the posterior: draws x actions x outcomes x outcomes.

    As in `TransitionModel.matrices`, another outcome stays what it is.

    Examples
    --------
    >>> model = TransitionModel(TransitionCounts([[[30, 10]]]), alpha=1)
    >>> matrices = sample_matrices(model, 2000, seed=1)
    >>> matrices.shape, f"{matrices[:, 0, 0, 0].mean():.2f}"
    ((2000, 1, 2, 2), '0.74')
    """
    expect(model, TransitionModel, "TransitionModel(counts)")
    draws = as_count(draws, "draws")
    random = np.random.default_rng(as_count(seed, "as a seed", least=0))
    actions, states, width = model.counts.table.shape
    found = np.zeros((draws, actions, width, width))
    found[:, :, states:, states:] = 1.0
    for a in range(actions):
        for i in range(states):
            parameters = [float(value) for value in model.parameters(a + 1, i + 1)]
            found[:, a, i] = random.dirichlet(parameters, draws)
    return found


def sampled_probabilities(
    matrices: Floats, start: int, goal: int, actions: Sequence[int]
) -> Floats:
    """Return the probability of a plan's success under each of the sampled matrices.

    Their mean estimates the probability expected under the posterior, their quantiles how sure it
    is.

    Examples
    --------
    >>> model = TransitionModel(TransitionCounts([[[1, 0], [0, 1]]]), alpha=1)
    >>> chances = sampled_probabilities(sample_matrices(model, 4000, seed=1), 1, 2, (1, 1))
    >>> f"{chances.mean():.1f}"
    '0.4'
    """
    if getattr(matrices, "ndim", 0) != 4:
        raise InputError(
            f"{matrices!r:.60}; accepted: what sample_matrices returns, draws x actions x outcomes "
            "x outcomes"
        )
    first, last = (numbered(state, matrices.shape[-1], "state") for state in (start, goal))
    listed = as_list(actions, "a list of tilts", "actions")
    tilts = [numbered(action, matrices.shape[1], "action") for action in listed]
    weights = np.zeros(matrices.shape[:1] + matrices.shape[-1:])
    weights[:, first - 1] = 1.0
    for action in tilts:
        weights = np.einsum("di,dij->dj", weights, matrices[:, action - 1])
    chances: Floats = weights[:, last - 1]
    return chances


@final
@dataclass(frozen=True, slots=True)
class PredictiveCheck:
    """Whether new counts of one row look like what the model predicts.

    Attributes
    ----------
    action, state : int
        The row.
    trials : int
        New trials of it.
    p_value : float
        Share of simulated rows that the model gives no more probability than the one seen.
    """

    action: int
    state: int
    trials: int
    p_value: float


def predictive_check(
    model: TransitionModel, counts: TransitionCounts, draws: int = 1000, seed: int = 0
) -> tuple[PredictiveCheck, ...]:
    """Compare new observations with the model's predictions, row by row.

    The probability of new counts, the parameters integrated out, is Dirichlet-multinomial. Rows are
    simulated from it, and those that are no more probable than the row seen are counted (the row
    seen among them). Given the model, small values are as rare as they are small.

    Parameters
    ----------
    model : TransitionModel
        Estimated from other observations.
    counts : TransitionCounts
        The new ones.
    draws, seed : int
        Simulated rows for each row seen.

    Raises
    ------
    RecordingError
        If the new counts have other states or actions.

    Examples
    --------
    >>> model = TransitionModel(TransitionCounts([[[90, 10], [0, 50]]]))
    >>> seen = predictive_check(model, TransitionCounts([[[1, 19], [0, 5]]]))
    >>> [row.p_value < 0.01 for row in seen]
    [True, False]
    """
    expect(model, TransitionModel, "TransitionModel(counts)")
    expect(counts, TransitionCounts, "TransitionCounts")
    if counts.table.shape != model.counts.table.shape:
        raise RecordingError(
            f"counts of shape {counts.table.shape}; accepted: {model.counts.table.shape}"
        )
    draws = as_count(draws, "draws")
    random = np.random.default_rng(as_count(seed, "as a seed", least=0))
    found = []
    for a, i in np.argwhere(counts.table.sum(axis=2) > 0):
        action, state = int(a) + 1, int(i) + 1
        parameters = np.array([float(value) for value in model.parameters(action, state)])
        seen = counts.table[a, i]
        total = int(seen.sum())
        rows = random.multinomial(total, random.dirichlet(parameters, draws))
        own = _log_probability(parameters, seen)
        # Equal rows have equal values up to rounding.
        as_rare = sum(_log_probability(parameters, row) <= own + 1e-9 for row in rows)
        found.append(PredictiveCheck(action, state, total, (as_rare + 1) / (draws + 1)))
    return tuple(found)


def _log_probability(parameters: Floats, counts: NDArray[np.int64]) -> float:
    """Return the log probability of counts in any order, up to what their total decides."""
    return sum(
        lgamma(alpha + count) - lgamma(alpha) - lgamma(count + 1)
        for alpha, count in zip(parameters.tolist(), counts.tolist(), strict=True)
        if count
    )


def _beta() -> Any:
    try:
        from scipy.stats import beta
    except ImportError as error:
        raise MissingExtraError.of("quantiles of the posterior", "scipy", "numeric") from error
    return beta
