"""What a plan makes of a prior, action by action, on arrays of step numbers.

After the first action every state is a value v_k of the transfer function, reached from the
initial orientations of one step. An action at alpha sends v_k to v_l with b_l <= v_k - alpha <
b_{l+1}; a monotone map merges only neighbours, so the states stay sorted and the initial
orientations of each stay one arc between two breaks. States are therefore numbers of values, and
their probabilities under a uniform prior differences of two breaks: no products of angles pile
up, and a step of a plan costs O(k log m) on arrays for k states in a period. Under another prior
the probability of a state is the mass of its arc, where the first action has put it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, final

import numpy as np
from gmpy2 import mpq

from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.lifted import Indices
from stochgeom.exact.ratios import TurnRatio
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from stochgeom.decision.priors import Prior
    from stochgeom.exact.sums import Probability


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
    prior : Prior or None
        None for the uniform one.
    first_angle : Angle
        By which the breaks stand turned among the orientations before the first action.
    """

    transfer: StepFunction
    states: Indices
    starts: Indices
    prior: Prior | None = None
    first_angle: Angle = ZERO

    def __len__(self) -> int:
        """Return the number of states in a full turn."""
        return len(self.states) * self.transfer.order

    @property
    def possible(self) -> int:
        """The number of states in a full turn whose probability is not known to be 0."""
        return len(self) if self.prior is None else len(self.hyperstate().possible())

    @property
    def ends(self) -> Indices:
        """For each state the number of the break where its initial orientations end."""
        return np.append(self.starts[1:], self.starts[0] + len(self.transfer))

    def most_likely(self) -> Probability:
        """Return the probability of the most likely state (thesis Eq. 4.4)."""
        if self.prior is not None:
            masses = [mass for _, _, mass in self._states(self.prior)]
            best = masses[0]
            for mass in masses[1:]:
                best = mass if mass.compare(best) > 0 else best
            return best
        breaks, ends = self.transfer.lifted_breaks, self.ends
        place = int(breaks.widest(self.starts, ends)[0])
        width = breaks[int(ends[place])] - breaks[int(self.starts[place])]
        return TurnRatio(mpq(1), width)

    def hyperstate(self) -> Hyperstate:
        """Return the distribution over a full turn, with exact orientations and widths."""
        rows = sorted(self._states(self.prior), key=lambda row: row[0])
        return Hyperstate(
            tuple(state for state, _, _ in rows),
            tuple(width for _, width, _ in rows),
            None if self.prior is None else tuple(mass for _, _, mass in rows),
        )

    def _states(self, prior: Prior | None) -> Iterator[tuple[Angle, Angle, Probability]]:
        """Yield orientation, width and probability of every state in a full turn."""
        transfer, m = self.transfer, len(self.transfer)
        breaks, values = transfer.lifted_breaks, transfer.lifted_values
        for turn in range(transfer.order):
            for state, start, end in zip(self.states, self.starts, self.ends, strict=True):
                first = breaks[int(start)]
                width = breaks[int(end)] - first
                arc = Arc(first + transfer.period * turn + self.first_angle, width)
                mass = TurnRatio(mpq(1), width) if prior is None else prior.mass(arc)
                yield values[int(state) + turn * m].reduced(), width, mass


def outcomes(
    transfer: StepFunction, angles: Sequence[Angle], prior: Prior | None = None
) -> Iterator[Outcome]:
    """Yield the hyperstate after each action of a plan, under a uniform prior or another one.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> s = squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> [len(outcome) for outcome in outcomes(s, [Angle(), Angle.from_degrees(-45)])]
    [4, 2]
    """
    m = len(transfer)
    # The first action only turns a uniform prior: its steps are those of the function.
    first_angle = ZERO if prior is None else angles[0]
    outcome = Outcome(transfer, np.arange(m), np.arange(m), prior, first_angle)
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
    return replace(outcome, states=reached[fresh], starts=outcome.starts[fresh])
