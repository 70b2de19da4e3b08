"""Transition probabilities estimated from counts: Dirichlet and multinomial (thesis 6.3.1).

The outcomes of an action in a state are drawn from unknown probabilities p_1, ..., p_k. Before any
trial these have a Dirichlet density with parameters alpha_j (Eq. 6.4); after counts x_j they have
one with parameters alpha_j + x_j (Eq. 6.8). With alpha_0 the sum of the alpha_j and n that of the
x_j, mean and variance of p_j are rational (Eq. 6.10, 6.11, 6.13):

    E(p_j)   = (alpha_j + x_j) / (alpha_0 + n)
    Var(p_j) = E(p_j) (1 - E(p_j)) / (alpha_0 + n + 1)

The variance falls with n in expectation, not always: after one success Beta(1, 9) has a larger one.
The likelihood alone (Eq. 6.12) gives x_j / n, which is undefined where n is 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from math import lgamma
from typing import Any, Final, TypeAlias, final

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.arguments import expect
from stochgeom.errors import PriorError
from stochgeom.exact.scalars import RationalLike, rational, rational_text
from stochgeom.tilting.counts import Outcome, TransitionCounts, numbered

ALPHA: Final = mpq(1, 100)
"""The parameter that the source chose for every outcome (6.3.1)."""

Row: TypeAlias = tuple[mpq, ...]
AlphaLike: TypeAlias = "RationalLike | Sequence[RationalLike] | Sequence[Sequence[RationalLike]]"


@final
class TransitionModel:
    """A stochastic control model: a posterior over every row of every transition matrix.

    Parameters
    ----------
    counts : TransitionCounts
        What was observed.
    alpha : rational, a row of them, or a table of states x outcomes; default 1/100
        The Dirichlet parameters before the observations, all positive. One number stands for all
        outcomes, one row for all states.

    Attributes
    ----------
    counts : TransitionCounts
        The observations.
    alpha : tuple of tuple of mpq
        The parameters, a row for each state.

    Raises
    ------
    PriorError
        If a parameter is not positive, or they are not as many as the outcomes.

    Notes
    -----
    Every value is an exact rational. A row costs O(outcomes), a matrix O(states x outcomes).

    Examples
    --------
    >>> seen = TransitionCounts([[[3, 1], [0, 0]]])
    >>> model = TransitionModel(seen, alpha=1)
    >>> model.row(1, 1), model.row(1, 2)
    ((mpq(2,3), mpq(1,3)), (mpq(1,2), mpq(1,2)))
    >>> model.variance(1, 1, 1), model.maximum_likelihood(1, 1), model.maximum_likelihood(1, 2)
    (mpq(2,63), (mpq(3,4), mpq(1,4)), None)
    """

    def __init__(self, counts: TransitionCounts, alpha: AlphaLike = ALPHA) -> None:
        self.counts = expect(counts, TransitionCounts, "TransitionCounts, as of a recording")
        self.alpha = _alpha_table(alpha, counts.states, len(counts.outcomes))
        self._rows: dict[tuple[int, int], Row] = {}

    # --- the posterior ---------------------------------------------------------------------------

    def parameters(self, action: int, state: int) -> Row:
        """Return the Dirichlet parameters alpha_j + x_j of a row (Eq. 6.8)."""
        seen = self.counts.row(action, state)
        return tuple(a + x for a, x in zip(self.alpha[state - 1], seen, strict=True))

    def row(self, action: int, state: int) -> Row:
        """Return the mean of a row: the estimate of least squared error (Eq. 6.10, 6.13)."""
        found = self._rows.get((action, state))
        if found is None:
            parameters = self.parameters(action, state)
            whole = sum(parameters)
            found = tuple(parameter / whole for parameter in parameters)
            self._rows[action, state] = found
        return found

    def matrix(self, action: int) -> tuple[Row, ...]:
        """Return the mean of a transition matrix, a row for each state."""
        return tuple(self.row(action, state) for state in range(1, self.counts.states + 1))

    def probability(self, action: int, state: int, outcome: Outcome) -> mpq:
        """Return the mean of one entry."""
        return self.row(action, state)[self._column(outcome)]

    def variance(self, action: int, state: int, outcome: Outcome) -> mpq:
        """Return the variance of one entry (Eq. 6.11)."""
        mean = self.probability(action, state, outcome)
        return mean * (1 - mean) / (sum(self.parameters(action, state)) + 1)

    def covariance(self, action: int, state: int, first: Outcome, second: Outcome) -> mpq:
        """Return the covariance of two entries of a row."""
        if self._column(first) == self._column(second):
            return self.variance(action, state, first)
        means = self.probability(action, state, first) * self.probability(action, state, second)
        return -means / (sum(self.parameters(action, state)) + 1)

    def marginal(self, action: int, state: int, outcome: Outcome) -> tuple[mpq, mpq]:
        """Return the parameters (a, b) of the Beta distribution of one entry."""
        parameters = self.parameters(action, state)
        own = parameters[self._column(outcome)]
        return own, sum(parameters) - own

    @cached_property
    def matrices(self) -> NDArray[np.float64]:
        """All means as floats, actions x outcomes x outcomes: each the nearest or next to it.

        What ended in another outcome stays there: nobody has tried an action from it.
        """
        n, k = self.counts.states, len(self.counts.outcomes)
        table = np.zeros((self.counts.actions, k, k))
        for a in range(self.counts.actions):
            table[a, :n] = [[float(entry) for entry in row] for row in self.matrix(a + 1)]
            table[a, n:, n:] = 1.0
        table.setflags(write=False)
        return table

    # --- the likelihood --------------------------------------------------------------------------

    def maximum_likelihood(self, action: int, state: int) -> Row | None:
        """Return the observed frequencies (Eq. 6.12); None where there are no observations."""
        seen = self.counts.row(action, state)
        total = sum(seen)
        return tuple(mpq(count, total) for count in seen) if total else None

    @cached_property
    def undefined_rows(self) -> tuple[tuple[int, int], ...]:
        """The pairs (action, state) never observed, whose frequencies are undefined."""
        return tuple(
            (int(a) + 1, int(i) + 1) for a, i in np.argwhere(self.counts.table.sum(axis=2) == 0)
        )

    @cached_property
    def unobserved_actions(self) -> tuple[int, ...]:
        """The actions never observed: all that is known of them is alpha."""
        return tuple(int(a) + 1 for a in np.flatnonzero(self.counts.table.sum(axis=(1, 2)) == 0))

    def log_evidence(self) -> float:
        """Return the log probability of the observations, in their order, given alpha.

        For comparing values of alpha; in floats.

        Examples
        --------
        One state, two outcomes, alpha = 1: all numbers of the first one among four are alike, 1/5,
        and a 3 comes in four orders, 1/20 each.

        >>> model = TransitionModel(TransitionCounts([[[3, 1]]]), alpha=1)
        >>> f"{model.log_evidence():.6f}", f"{-np.log(20):.6f}"
        ('-2.995732', '-2.995732')
        """
        total = 0.0
        for a, i in np.argwhere(self.counts.table.sum(axis=2) > 0):
            prior, seen = self.alpha[i], self.counts.row(int(a) + 1, int(i) + 1)
            total += lgamma(float(sum(prior))) - lgamma(float(sum(prior) + sum(seen)))
            for alpha, count in zip(prior, seen, strict=True):
                total += lgamma(float(alpha + count)) - lgamma(float(alpha))
        return total

    # --- values ----------------------------------------------------------------------------------

    def with_alpha(self, alpha: AlphaLike) -> TransitionModel:
        """Return the model of the same observations with other parameters."""
        return TransitionModel(self.counts, alpha)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TransitionModel):
            return NotImplemented
        return self.counts == other.counts and self.alpha == other.alpha

    def __hash__(self) -> int:
        return hash((self.counts, self.alpha))

    def __repr__(self) -> str:
        values = {value for row in self.alpha for value in row}
        shown = rational_text(values.pop()) if len(values) == 1 else "a table"
        return f"<TransitionModel: {self.counts.total} trials, alpha {shown}>"

    def _column(self, outcome: Outcome) -> int:
        if self.counts.has_other and outcome == self.counts.outcomes[-1]:
            return self.counts.states
        return numbered(outcome, self.counts.states, "outcome", other=self.counts.has_other) - 1


def _alpha_table(alpha: AlphaLike, states: int, outcomes: int) -> tuple[Row, ...]:
    table: Any = alpha
    if not _is_sequence(table):
        table = [table] * outcomes
    if not any(_is_sequence(row) for row in table):
        table = [table] * states
    if len(table) != states or not all(_is_sequence(r) and len(r) == outcomes for r in table):
        raise PriorError(
            f"a table of alphas with {len(table)} rows; accepted: one number, {outcomes} of them, "
            f"or {states} rows of {outcomes}",
            where="alpha",
        )
    rows = tuple(tuple(_positive(value) for value in row) for row in table)
    return tuple(rows[0] if row == rows[0] else row for row in rows)


def _is_sequence(value: Any) -> bool:
    return not isinstance(value, str) and hasattr(value, "__len__")


def _positive(value: RationalLike) -> mpq:
    number = rational(value, where="alpha")
    if number <= 0:
        raise PriorError(
            f"{rational_text(number)}; accepted: numbers above 0, such as 1/100", where="alpha"
        )
    return number
