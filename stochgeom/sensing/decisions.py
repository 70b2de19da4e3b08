"""What a subplan with sensors ends in: a decision, and what it gains in each state.

Accepting a state gains 1 if it is the true one: the expected gain is the probability of success.
Ending in a state that costs something is the one decision that there is, with a negative gain.
Naming a part, or the value of a parameter, gains what the table of losses says.

Of a joint hyperstate w the best decision gains max over d of sum w(theta) g_d(theta). That is
convex in w, so splitting a hyperstate by a reading never makes it less.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import Any, final

from stochgeom.decision.additive_costs import AdditiveModel
from stochgeom.decision.distributions import listed
from stochgeom.decision.infinity import INFINITE
from stochgeom.decision.labels import Labels, named
from stochgeom.decision.number_kinds import NumberKind, common_kind, numbered, read_number
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.errors import MixedNumbersError, SensorError


@final
@dataclass(frozen=True)
class Decisions:
    """Decisions and their gains.

    Attributes
    ----------
    labels : tuple
        What can be decided.
    gains : tuple of tuples of numbers
        For each decision its gain in each state.
    accepts : bool
        Whether gains are probabilities of success, in [0, 1]; otherwise they are losses with the
        sign turned.
    """

    labels: tuple[Any, ...]
    gains: tuple[tuple[Any, ...], ...]
    accepts: bool

    @cached_property
    def best_gains(self) -> tuple[Any, ...]:
        """For each state the gain of the best decision if the state is known."""
        return tuple(max(column) for column in zip(*self.gains, strict=True))

    @cached_property
    def _places(self) -> tuple[int, ...] | None:
        """For each decision the one state where it gains 1, if it is 0 elsewhere."""
        places = []
        for row in self.gains:
            if sorted(set(row)) not in ([0, 1], [1]) or sum(row) != 1:
                return None
            places.append(row.index(1))
        return tuple(places)

    def best(self, weights: tuple[Any, ...]) -> tuple[Any, int]:
        """Return the largest gain of a joint hyperstate and the first decision that attains it.

        Examples
        --------
        >>> accept_one_of(["a", "b"]).best((1, 3))
        (3, 1)
        """
        if self._places is not None:
            values = [weights[k] for k in self._places]
        else:
            values = [
                sum((w * g for w, g in zip(weights, row, strict=True) if g), start=0 * weights[0])
                for row in self.gains
            ]
        best = 0
        for k in range(1, len(values)):
            if values[best] < values[k]:
                best = k
        return values[best], best


def accept_one_of(
    states: Iterable[Hashable], accepted: Iterable[Hashable] | None = None
) -> Decisions:
    """Return the decisions to accept one state, and fail in every other.

    Parameters
    ----------
    states : sequence of labels
        All states.
    accepted : sequence of labels, optional
        Those that may be accepted; default: any.

    Examples
    --------
    >>> accept_one_of(["a", "b", "c"], ["c"]).gains
    ((0, 0, 1),)
    """
    labels = Labels(states, "state")
    chosen = labels.all if accepted is None else Labels(accepted, "accepted state").all
    rows = []
    for state in chosen:
        place = labels.number(state, where="accepted states")
        rows.append(tuple(int(k == place) for k in range(len(labels))))
    return Decisions(chosen, tuple(rows), accepts=True)


def accept_groups(
    states: Iterable[Hashable], groups: Mapping[Any, Iterable[Hashable]]
) -> Decisions:
    """Return the decisions to accept a group of states, each right in all states of its group.

    Such as the orientations that are equivalent by symmetry, or those of one part.

    Examples
    --------
    >>> accept_groups(["a1", "a2", "b1"], {"a": ["a1", "a2"], "b": ["b1"]}).gains
    ((1, 1, 0), (0, 0, 1))
    """
    labels = Labels(states, "state")
    chosen = Labels(groups, "group")
    rows = []
    for group in chosen:
        places = {labels.number(s, where=f"group {named(group)}") for s in groups[group]}
        rows.append(tuple(int(k in places) for k in range(len(labels))))
    return Decisions(chosen.all, tuple(rows), accepts=True)


def lose_by_table(
    problem: PlanningProblem, losses: Mapping[Any, Any], *, where: str = "losses"
) -> Decisions:
    """Return the decisions of a table of losses: ``losses[decision][state]``.

    Parameters
    ----------
    problem : PlanningProblem
        Whose states, and whose kind of numbers.
    losses : mapping
        From decisions to losses: a sequence in the order of the states, or a mapping from states
        that leaves out zeros.

    Raises
    ------
    MixedNumbersError
        If the losses are of another kind than the problem's numbers.

    Examples
    --------
    >>> coin = PlanningProblem.from_matrices(["1/2", "1/2"], {"wait": [[1, 0], [0, 1]]})
    >>> lose_by_table(coin, {"say 0": {"1": 5}, "say 1": {"0": 1}}).gains
    ((mpq(0,1), mpq(-5,1)), (mpq(-1,1), mpq(0,1)))
    """
    labels, states = Labels(losses, "decision"), Labels(problem.states, "state")
    places = [f"{where} of decision {named(label)}" for label in labels]
    table = [listed(losses[d], states, place) for d, place in zip(labels, places, strict=True)]
    kind = common_kind(chain.from_iterable(map(numbered, table, places)))
    if kind.exact != problem.exact and kind is not NumberKind.RATIONAL:
        raise MixedNumbersError(
            f"losses are {kind.value} and the problem's numbers {problem.numbers.value}; "
            "accepted: one kind"
        )
    used = kind if problem.exact else NumberKind.FLOAT
    rows = [
        tuple(0 - read_number(value, used, place_of) for value, place_of in numbered(row, place))
        for row, place in zip(table, places, strict=True)
    ]
    return Decisions(labels.all, tuple(rows), accepts=False)


def lose_by_state(problem: PlanningProblem) -> tuple[Decisions, tuple[Any, ...]]:
    """Return the one decision to end, and the prices of the actions, of a problem's additive cost.

    Any cost counts that is one on the problem, such as the probability of missing a goal.

    Raises
    ------
    SensorError
        If the problem has no additive cost, or ending in a state costs infinitely much.

    Examples
    --------
    >>> from stochgeom.decision.additive_costs import AdditiveCost
    >>> cost = AdditiveCost(actions="1/8", states={"1": 1})
    >>> coin = PlanningProblem.from_matrices(["1/2", "1/2"], {"turn": [[0, 1], [1, 0]]}, cost=cost)
    >>> lose_by_state(coin)[0].gains, lose_by_state(coin)[1]
    (((mpq(0,1), mpq(-1,1)),), (mpq(1,8),))
    """
    model = None if problem.cost is None else problem.cost.on(problem)
    if not isinstance(model, AdditiveModel):
        raise SensorError(
            "the problem has no additive cost; accepted: one that is, such as AdditiveCost and "
            "GoalCost, or losses",
            where="cost",
        )
    for state, cost in zip(problem.states, model.state_costs, strict=True):
        if cost is INFINITE or cost == float("inf"):
            raise SensorError(
                "an infinite cost has no place in a plan with sensors; accepted: finite costs",
                where=f"state {named(state)}",
            )
    row = tuple(0 - cost for cost in model.state_costs)
    return Decisions(("end",), (row,), accepts=False), model.prices
