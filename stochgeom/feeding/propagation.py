"""What a plan makes of a uniform prior, action by action, on arrays of step numbers.

After the first action every state is a value v_k of the transfer function, reached from the
initial orientations of one step. An action at alpha sends v_k to v_l with b_l <= v_k - alpha <
b_{l+1}; a monotone map merges only neighbours, so the states stay sorted and the initial
orientations of each stay one arc between two breaks. States are therefore numbers of values, and
their probabilities differences of two breaks: no products of angles pile up, and a step of a
plan costs O(k log m) on arrays for k states in a period.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import final

import numpy as np
from gmpy2 import mpq

from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.exact.angles import Angle
from stochgeom.exact.lifted import Indices
from stochgeom.exact.ratios import TurnRatio
from stochgeom.transfer.step_function import StepFunction


@final
@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """The hyperstate after some actions, as numbers of values and breaks.

    Attributes
    ----------
    transfer : StepFunction
        Of every action.
    states : int array
        Numbers of the values v_k of the states in one period, increasing.
    starts : int array
        For each state the number of the break where its initial orientations begin; they end
        where those of the next state begin.
    """

    transfer: StepFunction
    states: Indices
    starts: Indices

    def __len__(self) -> int:
        """Return the number of states in a full turn."""
        return len(self.states) * self.transfer.order

    @property
    def ends(self) -> Indices:
        """For each state the number of the break where its initial orientations end."""
        return np.append(self.starts[1:], self.starts[0] + len(self.transfer))

    def most_likely(self) -> TurnRatio:
        """Return the probability of the most likely state (thesis Eq. 4.4)."""
        breaks, ends = self.transfer.lifted_breaks, self.ends
        place = int(breaks.widest(self.starts, ends)[0])
        width = breaks[int(ends[place])] - breaks[int(self.starts[place])]
        return TurnRatio(mpq(1), width)

    def hyperstate(self) -> Hyperstate:
        """Return the distribution over a full turn, with exact orientations and widths."""
        transfer = self.transfer
        breaks, values, m = transfer.lifted_breaks, transfer.lifted_values, len(transfer)
        pairs = [
            (values[int(state) + turn * m].reduced(), breaks[int(end)] - breaks[int(start)])
            for turn in range(transfer.order)
            for state, start, end in zip(self.states, self.starts, self.ends, strict=True)
        ]
        pairs.sort(key=lambda pair: pair[0])
        return Hyperstate(tuple(s for s, _ in pairs), tuple(w for _, w in pairs))


def outcomes(transfer: StepFunction, angles: Sequence[Angle]) -> Iterator[Outcome]:
    """Yield the hyperstate after each action of a plan under a uniform prior.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> s = squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> [len(outcome) for outcome in outcomes(s, [Angle(), Angle.from_degrees(-45)])]
    [4, 2]
    """
    m = len(transfer)
    # The first action only turns the uniform prior: its steps are those of the function.
    outcome = Outcome(transfer, np.arange(m), np.arange(m))
    yield outcome
    for alpha in angles[1:]:
        reached = transfer.lifted_breaks.positions(transfer.lifted_values, outcome.states, -alpha)
        outcome = _merged(outcome, reached)
        yield outcome


def _merged(outcome: Outcome, reached: Indices) -> Outcome:
    """Join neighbouring states that went to the same value, around the end of the period too."""
    fresh = np.ones(len(reached), dtype=np.bool_)
    fresh[1:] = reached[1:] != reached[:-1]
    # The last state of the period before went to reached[-1] - m.
    if len(reached) > 1:
        fresh[0] = reached[-1] - len(outcome.transfer) != reached[0]
    return Outcome(outcome.transfer, reached[fresh], outcome.starts[fresh])
