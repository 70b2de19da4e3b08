"""The simplest plan with a sensor: consult it once, accept the most likely state (thesis 7.2.3).

With the reading x the most likely state is accepted, and it is there with probability p(x). A part
in any other state falls back and everything is done anew: the next round senses again, and its
reading has nothing to do with this one. So a round succeeds with probability sum m(x) p(x), and
with r the cost of a round the expected cost is

    r / sum over x of m(x) p(x).

The source prints r sum m(x) / p(x) (Eq. 7.5). That would be right if the part kept its reading over
all rounds; it is never less, for 1/p is convex, and it can exceed the cost of not sensing at all.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, final

from stochgeom.arguments import expect
from stochgeom.decision.labels import Labels
from stochgeom.decision.number_kinds import NumberKind, read_number
from stochgeom.decision.probabilities import Enclosed
from stochgeom.errors import CostError, NoPlanError
from stochgeom.exact.balls import Ball
from stochgeom.exact.quotients import quotient
from stochgeom.exact.sums import AngleSum
from stochgeom.sensing.sensors import Sensor


@final
@dataclass(frozen=True, slots=True)
class ReadingDecision:
    """What to do after a reading.

    Attributes
    ----------
    reading : label
        What was read.
    marginal : number
        m(x), its probability.
    state : label
        The most likely state (Eq. 7.4), the first of equal ones.
    joint : number
        The probability that this is read and the state is that one.
    """

    reading: Hashable
    marginal: Any
    state: Hashable
    joint: Any

    @property
    def probability(self) -> Any:
        """The posterior probability p(x) of the state."""
        return quotient(self.joint, self.marginal)


@final
@dataclass(frozen=True)
class OneStepPlan:
    """Sense once, accept the most likely state; made by `one_step_plan`.

    Attributes
    ----------
    decisions : tuple of ReadingDecision
        One for each reading of positive probability.
    round_cost : number
        Cost of a round.
    """

    decisions: tuple[ReadingDecision, ...]
    round_cost: Any

    @cached_property
    def success(self) -> Any:
        """The probability that a round succeeds, sum m(x) p(x)."""
        joints = [decision.joint for decision in self.decisions]
        return sum(joints[1:], start=joints[0])

    @cached_property
    def expected_cost(self) -> Any:
        """The expected cost until a part is accepted."""
        return quotient(self.round_cost, self.success)

    @cached_property
    def printed_cost(self) -> Any:
        """What Eq. 7.5 of the source gives: not the expected cost, unless there is no noise in it.

        A rational number or a float where it is one, else an enclosed number.
        """
        parts = [(decision.marginal, decision.joint) for decision in self.decisions]
        if any(isinstance(m, AngleSum) for m, _ in parts):
            rational = [
                (m.rational, joint.rational) if isinstance(m, AngleSum) else (m, joint)
                for m, joint in parts
            ]
            if any(None in pair for pair in rational):
                return Enclosed.of(self._printed_ball(parts))
            parts = rational
        terms = [self.round_cost * m * m / joint for m, joint in parts]
        return sum(terms[1:], start=terms[0])

    def _printed_ball(self, parts: list[tuple[AngleSum, AngleSum]]) -> Callable[[], Ball]:
        cost = AngleSum.of(self.round_cost)

        def enclose() -> Ball:
            balls = [(m.ball(), joint.ball()) for m, joint in parts]
            return cost.ball() * sum(m * m / joint for m, joint in balls)

        return enclose


def one_step_plan(
    sensor: Sensor,
    prior: Sequence[Any] | Any,
    round_cost: Any = 1,
    *,
    accepted: Sequence[Hashable] | None = None,
) -> OneStepPlan:
    """Return the plan that senses once and accepts the most likely state.

    Parameters
    ----------
    sensor : Sensor
        What is consulted.
    prior : sequence of numbers, or mapping from states
        The hyperstate before.
    round_cost : number, default 1
        Cost of a round, the sensing included; more than 0.
    accepted : sequence of states, optional
        Only these may be accepted; default: any.

    Raises
    ------
    CostError
        If the cost of a round is not positive.
    NoPlanError
        If none of the accepted states has a positive probability.

    Examples
    --------
    The source's formula charges more for a sensor than for none:

    >>> prior = ["0.6", "0.1", "0.1", "0.1", "0.1"]
    >>> sensor = Sensor.from_function(range(5), lambda state: state == 0)
    >>> blind = one_step_plan(Sensor.blind(range(5)), prior)
    >>> plan = one_step_plan(sensor, prior)
    >>> plan.printed_cost, blind.expected_cost, plan.expected_cost
    (mpq(11,5), mpq(5,3), mpq(10,7))
    """
    expect(sensor, Sensor, "a Sensor, such as Sensor.noisy(states, '1/10')")
    weights = sensor.weights(prior)
    kind = NumberKind.FLOAT if isinstance(weights[0], float) else NumberKind.RATIONAL
    cost = read_number(round_cost, kind, "cost of a round")
    if not cost > 0:
        raise CostError(f"{cost}; accepted: more than 0", where="cost of a round")
    goals = sensor.states if accepted is None else Labels(accepted, "accepted state").all
    candidates = [sensor.state_number(state) for state in goals]
    decisions = []
    for reading, column in zip(sensor.readings, sensor.columns, strict=True):
        joint = [w * p for w, p in zip(weights, column, strict=True)]
        marginal = sum(joint[1:], start=joint[0])
        if marginal == 0:
            continue
        best = candidates[0]
        for k in candidates:
            best = k if joint[best] < joint[k] else best
        decisions.append(ReadingDecision(reading, marginal, sensor.states[best], joint[best]))
    plan = OneStepPlan(tuple(decisions), cost)
    if plan.success == 0:
        raise NoPlanError("no state that may be accepted is possible")
    return plan
