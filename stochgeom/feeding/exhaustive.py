"""All plans of a part, gone through one by one (thesis 4.8): the slow road to the same optimum.

The root of the search is the hyperstate after the random first squeeze: the part is in state v_j
with the width of step j as its measure. The hyperstate after some actions is written as a map of
step numbers: for each initial step j the state its orientations are in now, modulo the period.
That is canonical, because the measures of the steps never change; what changes is which of them
are together. Two plans with the same map are one node.

Orientations that end together are an arc: after any actions the lifted map of step numbers is
non-decreasing and moves on by m over a period, so the steps that share a state modulo m are
neighbours. The probability of the most likely state is thus the difference of two breaks. The
m (m - 1) + 1 arcs between breaks are sorted once, by exact comparison, and from then on a
hyperstate is worth the rank of its widest arc: a small integer, and equal for equal widths.

Under a prior the first action puts a collapsed arc where it catches most. A wider arc has a place
where it catches no less, so the order of the widths is an order of the probabilities as well, and
the search stays the same but for the costs.

This module finds nothing by preimages. `first_disagreement` compares it with phase I.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from operator import itemgetter
from typing import TYPE_CHECKING, Final, TypeAlias, final

from gmpy2 import mpq

from stochgeom.decision.costs import Number, as_cost_ratio, expected_cost, length_bound
from stochgeom.decision.search import Level, SearchResult, breadth_first
from stochgeom.errors import InputError
from stochgeom.exact.angles import Angle
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.scalars import RationalLike
from stochgeom.feeding.action_classes import ActionClass, ActionClasses
from stochgeom.feeding.automaton import Map
from stochgeom.feeding.preimages import Preimages
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from stochgeom.decision.priors import Prior
    from stochgeom.exact.sums import Probability

NODE_LIMIT: Final = 1000
"""How many nodes the source's own search generates before it gives up."""

_Found: TypeAlias = SearchResult[Map, int]


@final
@dataclass(frozen=True, slots=True)
class PlanLength:
    """The best plans of a number of steps.

    Attributes
    ----------
    steps : int
        i, the number of actions, the random first one included.
    width : Angle
        The widest arc of orientations that i actions collapse; if not `complete`, that i actions
        were found to collapse.
    generated, distinct : int
        Nodes up to this length, the root included: all of them, and the different ones.
    complete : bool
        Whether no plan of this length does better: False if the node limit came first.
    """

    steps: int
    width: Angle
    generated: int
    distinct: int
    complete: bool


@final
class ExhaustiveSearch:
    """What a breadth-first search found, for each plan length.

    Made by `search_plans`.
    """

    def __init__(
        self,
        transfer: StepFunction,
        classes: ActionClasses,
        ranks: ArcRanks,
        found: _Found,
        prior: Prior | None = None,
    ) -> None:
        self.transfer, self.classes, self.prior = transfer, classes, prior
        self._ranks, self._found = ranks, found

    @property
    def lengths(self) -> tuple[PlanLength, ...]:
        """The plan lengths that were reached, from 1 step on."""
        return tuple(map(self._plan_length, self._found.levels))

    def of_steps(self, steps: int) -> PlanLength:
        """Return what the plans of so many steps achieve.

        Once a period is collapsed, or no further hyperstate exists, more steps do no better.

        Raises
        ------
        InputError
            If the search did not go that far.
        """
        levels = self._found.levels
        ended = self._found.conclusive
        if steps < 1 or (steps > len(levels) and not ended):
            more = " or more" if ended else f" to {len(levels)}"
            raise InputError(f"{steps} steps; accepted: 1{more}")
        return self._plan_length(levels[min(steps, len(levels)) - 1])

    def _plan_length(self, level: Level[Map, int]) -> PlanLength:
        return PlanLength(
            level.length + 1,
            self._ranks.widths[level.worth],
            level.generated,
            level.distinct,
            level.complete,
        )

    @property
    def generated(self) -> int:
        """Nodes generated in all, the root and duplicates included."""
        return self._found.last.generated

    @property
    def distinct(self) -> int:
        """Different hyperstates among the nodes generated."""
        return self._found.last.distinct

    @property
    def solved(self) -> bool:
        """Whether the search ended by its own rule, before the node limit."""
        return self._found.last.complete

    @property
    def collapsed(self) -> bool:
        """Whether a plan was found that orients the part up to symmetry."""
        return self._found.last.worth == self._ranks.top

    def probability(self, steps: int) -> Probability:
        """Return the probability of the most likely state after the best plan of a length."""
        return _caught(self.of_steps(steps).width, self.prior)

    def expected_cost(self, steps: int, cost_ratio: RationalLike = 1) -> Number:
        """Return (i + c) / p for the best plan of i steps (Eq. 4.5)."""
        return expected_cost(steps + as_cost_ratio(cost_ratio), self.probability(steps))

    def optimal_steps(self, cost_ratio: RationalLike = 1) -> int:
        """Return the number of steps of least expected cost, the smallest of equal ones (Eq. 4.7).

        Of the lengths whose best plan is known.
        """
        steps = [level.length + 1 for level in self._found.levels if level.complete]
        return min(steps, key=lambda i: (self.expected_cost(i, cost_ratio), i))

    def plans(self, steps: int) -> Iterator[tuple[ActionClass, ...]]:
        """Yield the best plans of a length: the classes of the actions after the first squeeze.

        All of them if ties were kept, else one; of classes with the same map the first one
        stands for all. Once longer plans collapse no more, the shortest ones.
        """
        for word in self._found.sequences(self.of_steps(steps).steps - 1):
            yield self.classes.representatives(word)

    def __repr__(self) -> str:
        last = self.lengths[-1]
        return (
            f"<ExhaustiveSearch: {'solved' if self.solved else 'node limit reached'}, "
            f"{last.steps} steps, {self.generated} nodes, {self.distinct} of them different>"
        )


def search_plans(
    transfer: StepFunction,
    *,
    cost_ratio: RationalLike | None = None,
    node_limit: int = NODE_LIMIT,
    count_duplicates: bool = True,
    longest: int | None = None,
    keep_ties: bool = False,
    prior: Prior | None = None,
) -> ExhaustiveSearch:
    """Search the plans of 1, 2, ... steps until none can be better.

    Parameters
    ----------
    transfer : StepFunction
        What one action does.
    cost_ratio : rational >= 0, optional
        c. With it the search ends where no longer plan can be cheaper than the best one found,
        at the latest at `stochgeom.decision.costs.length_bound`; without it, where a period is
        collapsed.
    node_limit : int, default 1000
        Most nodes that are generated; the root, which is the hyperstate after the first squeeze,
        counts.
    count_duplicates : bool, default True
        Whether a hyperstate counts each time it is generated, or once. (The source does not say;
        the share of parts that it solves within 1000 nodes is met by counting each once.)
    longest : int, optional
        Most steps of a plan.
    keep_ties : bool, default False
        Keep all best plans, not just one.
    prior : Prior, optional
        Of the orientations before the first action; default: uniform.

    Raises
    ------
    CostError
        If the cost ratio is negative or not a rational number.
    InputError
        If the node limit or the number of steps is below 1.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> found = search_plans(squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> [found.expected_cost(i, 1).decimal(1) for i in (1, 2, 3, 4)], found.optimal_steps(1)
    (['6.4', '6.0', '8.0', '10.0'], 2)
    """
    if longest is not None and longest < 1:
        raise InputError(f"plans of {longest} steps; accepted: 1 or more")
    classes, ranks = ActionClasses(transfer), ArcRanks(transfer)
    c = None if cost_ratio is None else as_cost_ratio(cost_ratio)
    bounds = [] if longest is None else [longest]
    if c is not None:
        # Under a prior, the argument for the bound holds with full turns for periods.
        states = len(transfer) if prior is None else len(transfer) * transfer.order
        bounds.append(length_bound(states, c))
    found = breadth_first(
        tuple(range(len(transfer))),
        tuple(classes.merged),
        _act,
        ranks.widest,
        node_limit=node_limit,
        count_duplicates=count_duplicates,
        depth=min(bounds) - 1 if bounds else None,
        keep_ties=keep_ties,
        highest=ranks.top,
        enough=None if c is None else _StopRule(ranks, transfer.period, c, prior),
    )
    return ExhaustiveSearch(transfer, classes, ranks, found, prior)


def first_disagreement(search: ExhaustiveSearch, chain: Preimages) -> int | None:
    """Return the first plan length for which phase I and the search differ, None if none does.

    Every length whose best plan the search knows is compared and, if a period was collapsed,
    whether phase I ends there too.
    """
    complete = [length for length in search.lengths if length.complete]
    for length in complete:
        if chain.of_steps(length.steps).width != length.width:
            return length.steps
    shortest = sum(length.width != search.transfer.period for length in complete) + 1
    if shortest <= len(complete) and chain.of_steps(shortest).steps != shortest:
        return shortest
    return None


def _act(node: Map, action: Map) -> Map:
    return tuple([action[state] for state in node])


@final
class ArcRanks:
    """The arcs between breaks, in order of their widths; equally wide ones share a rank.

    Attributes
    ----------
    widths : list of Angle
        The different widths, increasing; a rank is a place in it.
    top : int
        The rank of a whole period.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> ranks = ArcRanks(squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> [width.degrees(1) for width in ranks.widths]
    ['67.4', '112.6', '180.0']
    >>> ranks.widest((0, 1)), ranks.widest((1, 1))
    (1, 2)
    """

    def __init__(self, transfer: StepFunction) -> None:
        m = len(transfer)
        ends = [transfer.lifted_breaks[k] for k in range(2 * m)]
        arcs = [
            (ends[first + count] - ends[first], first, count)
            for first in range(m)
            for count in range(1, m)
        ]
        arcs.sort(key=itemgetter(0))
        self.widths: list[Angle] = []
        self._ranks = [[0] * (m + 1) for _ in range(m)]
        for width, equal in groupby(arcs, key=itemgetter(0)):
            for _, first, count in equal:
                self._ranks[first][count] = len(self.widths)
            self.widths.append(width)
        self.top = len(self.widths)
        self.widths.append(transfer.period)

    def widest(self, node: Map) -> int:
        """Return the rank of the widest arc of initial steps that are in one state.  O(m)."""
        m, doubled = len(node), node + node
        first = next((j for j in range(m) if node[j] != node[j - 1]), None)
        if first is None:
            return self.top
        best, start = 0, first
        for j in range(first + 1, first + m + 1):
            if doubled[j] != doubled[start]:
                best = max(best, self._ranks[start % m][j - start])
                start = j
        return best


class _StopRule:
    """Ends a search where no longer plan is cheaper than the best one found."""

    def __init__(
        self, ranks: ArcRanks, period: Angle, cost_ratio: mpq, prior: Prior | None
    ) -> None:
        self._ranks, self._period, self._cost_ratio = ranks, period, cost_ratio
        self._prior = prior
        self._best: Number | None = None

    def __call__(self, level: Level[Map, int]) -> bool:
        steps = level.length + 1
        cost = self._cost(steps, self._ranks.widths[level.worth])
        if self._best is None or cost < self._best:
            self._best = cost
        # One step more costs at least this much, even if it collapses a whole period.
        return not self._cost(steps + 1, self._period) < self._best

    def _cost(self, steps: int, width: Angle) -> Number:
        return expected_cost(steps + self._cost_ratio, _caught(width, self._prior))


def _caught(width: Angle, prior: Prior | None) -> Probability:
    """Return the probability of the best place of an arc."""
    return TurnRatio(mpq(1), width) if prior is None else prior.best_window(width).mass
