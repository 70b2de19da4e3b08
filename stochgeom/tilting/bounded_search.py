"""Branch and bound: the best plan without looking at all of them (thesis 2.4, 6.4).

A prefix of a plan leaves a hyperstate. Whoever could see the state after every tilt would do at
least as well from there as any open-loop plan. So with V_r(i) the probability of reaching the goal
from state i within r tilts with open eyes,

    V_0 = 1 at the goal and 0 elsewhere,  V_r(i) = max(V_(r-1)(i), max_a sum_j p_ij(a) V_(r-1)(j)),

the hyperstate times V_r is no less than what any plan makes of it. Prefixes are taken up in order
of that bound, the most promising one first. Everything is rational: no plan is lost to rounding.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from heapq import heappop, heappush
from typing import Final, final

from gmpy2 import mpq

from stochgeom.arguments import as_count
from stochgeom.tilting.estimation import Row, TransitionModel
from stochgeom.tilting.tilt_plans import (
    Distribution,
    TiltPlan,
    evaluate_tilt_plan,
    read_instance,
    usable_actions,
)

METHOD: Final = "branch and bound"


@final
@dataclass(frozen=True, slots=True)
class BoundedSearch:
    """What branch and bound found, and what it took.

    Attributes
    ----------
    plan : TiltPlan
        The best plan; with a node limit that came first, the best one seen.
    nodes : int
        Hyperstates made.
    of : int
        Hyperstates that looking at all plans would have made.
    limit : mpq
        No plan of the horizon does better than this: the plan's own probability if `complete`.
    complete : bool
        Whether the plan is proved to be the best.
    """

    plan: TiltPlan
    nodes: int
    of: int
    limit: mpq
    complete: bool


def bounded_tilt_search(
    model: TransitionModel,
    start: int,
    goal: int,
    most_tilts: int = 3,
    *,
    observed_only: bool = False,
    node_limit: int = 1_000_000,
) -> BoundedSearch:
    """Search for the plan of highest probability, the most promising prefix first.

    Of equally probable plans the shortest, then the first in the order of the actions, as in
    `best_tilt_plan`. In the worst case as slow as looking at all plans, m^k of them.

    Parameters
    ----------
    model, start, goal, most_tilts, observed_only
        As for `best_tilt_plan`.
    node_limit : int, default 10^6
        Most hyperstates to make.

    Examples
    --------
    >>> from stochgeom.tilting.counts import TransitionCounts
    >>> one, two = [[0, 9, 0], [0, 9, 0], [0, 0, 9]], [[9, 0, 0], [0, 0, 9], [9, 0, 0]]
    >>> seen = TransitionCounts([one, two])
    >>> found = bounded_tilt_search(TransitionModel(seen), 1, 3, most_tilts=6)
    >>> found.plan, found.nodes < found.of, found.complete
    (<TiltPlan 1 to 3: (1 2), probability 0.9956>, True, True)
    """
    start, goal, most_tilts = read_instance(model, start, goal, most_tilts)
    node_limit = as_count(node_limit, "nodes", where="node limit")
    actions = usable_actions(model, observed_only=observed_only)
    search = _Search(model, goal, actions, most_tilts)
    search.run(start, node_limit)
    plan = evaluate_tilt_plan(model, start, goal, search.best[2], METHOD)
    of = sum(len(actions) ** k for k in range(most_tilts + 1))
    return BoundedSearch(plan, search.nodes, of, search.limit, search.complete)


def seeing_values(
    model: TransitionModel, goal: int, actions: Sequence[int], most_tilts: int
) -> list[Row]:
    """Return V_0, ..., V_k: the probability of reaching the goal for one who sees the state.

    O(k m n^2) for k tilts, m actions and n states.
    """
    n, width = model.counts.states, len(model.counts.outcomes)
    matrices = [model.matrix(action) for action in actions]
    values = [tuple(mpq(j == goal - 1) for j in range(width))]
    for _ in range(most_tilts):
        last = values[-1]
        values.append(
            tuple(
                max([last[i], *(_product(matrix[i], last) for matrix in matrices)])
                if i < n
                else last[i]
                for i in range(width)
            )
        )
    return values


class _Search:
    """A search under way: the prefixes to take up, and the best plan so far."""

    def __init__(
        self, model: TransitionModel, goal: int, actions: Sequence[int], most_tilts: int
    ) -> None:
        self._goal, self._actions, self._most = goal, tuple(actions), most_tilts
        self._states, self._width = model.counts.states, len(model.counts.outcomes)
        # The columns of a matrix: a hyperstate is multiplied from the left.
        self._columns = {a: tuple(zip(*model.matrix(a), strict=True)) for a in actions}
        self._values = seeing_values(model, goal, actions, most_tilts)
        self.nodes = 0
        self.best: tuple[mpq, int, tuple[int, ...]]
        self.limit, self.complete = mpq(1), False

    def run(self, start: int, node_limit: int) -> None:
        root = tuple(mpq(j == start - 1) for j in range(self._width))
        self.best = (-root[self._goal - 1], 0, ())
        self.nodes = 1
        pending: list[tuple[mpq, int, tuple[int, ...], Distribution]]
        pending = [(-_product(root, self._values[self._most]), 0, (), root)]
        # Invariant: every plan not seen begins with a pending prefix, or is no better than best.
        while pending:
            bound, steps, prefix, here = pending[0]
            if -bound < -self.best[0] or self.nodes >= node_limit:
                break
            heappop(pending)
            if steps == self._most:
                continue
            for actions, after in self._children(prefix, here):
                self.best = min(self.best, (-after[self._goal - 1], steps + 1, actions))
                least = -_product(after, self._values[self._most - steps - 1])
                # A longer plan that is only as good does not count.
                if (least, steps + 2) <= self.best[:2]:
                    heappush(pending, (least, steps + 1, actions, after))
        self.limit = -min(pending[0][0], self.best[0]) if pending else -self.best[0]
        self.complete = self.limit == -self.best[0]

    def _children(
        self, prefix: tuple[int, ...], here: Distribution
    ) -> Iterator[tuple[tuple[int, ...], Distribution]]:
        for action in self._actions:
            self.nodes += 1
            after = [_product(here, column) for column in self._columns[action]]
            for lost in range(self._states, self._width):
                after[lost] += here[lost]
            yield (*prefix, action), tuple(after)


def _product(weights: Row, values: Row) -> mpq:
    total = mpq(0)
    for weight, value in zip(weights, values, strict=False):  # a row ends before other outcomes
        if weight and value:
            total += weight * value
    return total
