"""Best-first branch and bound over open-loop plans (thesis 2.4).

Of all beginnings under way, the one with the smallest bound is extended next. A beginning is
dropped if

- its bound is above the cost of the best plan found, or equal to it where no extension is shorter;
- another beginning leads to an equal hyperstate with no more actions and has spent no more.

The first is right because no extension undercuts the bound (see each cost), the second because the
two have the same extensions, which cost no more after the cheaper one. When the smallest bound is
above the best cost, no plan is better: that is the proof of optimality. If a limit ends the search
before, the smallest bound is a lower bound on the cost of all plans.

The worst case is that of exhaustive search.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterator
from itertools import count
from typing import TYPE_CHECKING, Any, TypeAlias, final

import numpy as np

from stochgeom.decision.plan_results import Limits, PlanResult

if TYPE_CHECKING:
    from stochgeom.decision.plan_costs import CostModel
    from stochgeom.decision.planning_problem import Vector

_Route: TypeAlias = "tuple[int, int]"
"""A beginning, by its number, and the number of the action that follows."""


@final
class BestFirst:
    """A best-first search under way.

    Parameters
    ----------
    model : CostModel
        Prices, costs and bounds.
    horizon : int or None
        Most actions.
    shortest : int
        Fewest actions: 0 or 1.
    all_optimal : bool
        Whether to keep all plans of the least cost and, among those, the fewest actions.
    threshold : number, optional
        A plan that costs no more ends the search.
    """

    def __init__(
        self,
        model: CostModel,
        horizon: int | None,
        *,
        shortest: int = 1,
        all_optimal: bool = False,
        threshold: Any = None,
    ) -> None:
        self._model, self._horizon, self._keep_ties = model, horizon, all_optimal
        self._threshold = threshold
        self._routes: list[list[_Route]] = []
        self._nodes: list[tuple[Any, int, Vector]] = []
        self._reached: dict[Any, list[int]] = {}
        self._heap: list[tuple[Any, int, int, int]] = []
        self._ticket = count()
        self._best: list[int] = []
        self._cost: Any = None
        self._made = 0
        self._keep(model.nothing, 0, model.problem.prior, None, counts=shortest == 0)

    def run(self, limits: Limits) -> PlanResult:
        """Search until the optimum is proven or a limit is reached."""
        while self._heap and not self._is_satisfied():
            bound, depth, _, number = heapq.heappop(self._heap)
            # Invariant: what was dropped cannot be better, and all else is on the heap.
            if self._is_useless(bound, depth):
                continue
            if not self._extend(number, limits):
                heapq.heappush(self._heap, (bound, depth, next(self._ticket), number))
                break
        return self._result(limits)

    def _is_satisfied(self) -> bool:
        return self._threshold is not None and bool(self._best and not self._threshold < self._cost)

    def _is_useless(self, bound: Any, depth: int) -> bool:
        """Tell whether nothing that follows is better than what was found, or is one more tie."""
        if not self._best:
            return False
        if self._cost < bound:
            return True
        if bound < self._cost:
            return False
        fewest = self._nodes[self._best[0]][1]
        return depth + 1 > fewest if self._keep_ties else depth + 1 >= fewest

    def _extend(self, number: int, limits: Limits) -> bool:
        spent, depth, hyperstate = self._nodes[number]
        after, prices = self._model.problem.after_number, self._model.prices
        for action, price in enumerate(prices):
            if limits.reached(self._made):
                return False
            self._keep(
                spent + price, depth + 1, after(hyperstate, action), (number, action), counts=True
            )
        return True

    def _keep(
        self, spent: Any, depth: int, hyperstate: Vector, route: _Route | None, *, counts: bool
    ) -> None:
        """Take in a beginning, unless another one is at least as good."""
        self._made += 1
        key = (counts, hyperstate.tobytes() if isinstance(hyperstate, np.ndarray) else hyperstate)
        others = self._reached.setdefault(key, [])
        for other in others:
            less, fewer, _ = self._nodes[other]
            if fewer <= depth and not spent < less:
                if self._keep_ties and fewer == depth and not less < spent and route is not None:
                    self._routes[other].append(route)
                return
        number = len(self._nodes)
        others.append(number)
        self._nodes.append((spent, depth, hyperstate))
        self._routes.append([] if route is None else [route])
        if counts:
            self._compare(number)
        left = None if self._horizon is None else self._horizon - depth
        if left != 0:
            bound = self._model.bound(spent, hyperstate, left)
            if not self._is_useless(bound, depth):
                heapq.heappush(self._heap, (bound, depth, next(self._ticket), number))

    def _compare(self, number: int) -> None:
        spent, depth, hyperstate = self._nodes[number]
        cost = self._model.value(spent, hyperstate)
        if self._best:
            if self._cost < cost:
                return
            fewest = self._nodes[self._best[0]][1]
            if not cost < self._cost and depth >= fewest:
                if depth == fewest and self._keep_ties:
                    self._best.append(number)
                return
        self._best, self._cost = [number], cost

    # --- what was found --------------------------------------------------------------------------

    def _result(self, limits: Limits) -> PlanResult:
        # A threshold or a limit leaves beginnings on the heap; some of them may be useless by now.
        open_bounds = [
            bound for bound, depth, _, _ in self._heap if not self._is_useless(bound, depth)
        ]
        proven = not open_bounds
        reason = "proven" if proven else (limits.reason or "threshold")
        lower = self._cost if proven else min(open_bounds)
        if not self._best:  # the limit came before the first action
            return self._empty(lower, reason)
        problem = self._model.problem
        plans = tuple(
            tuple(problem.actions[action] for action in word)
            for number in self._best
            for word in self._words(number)
        )
        return PlanResult(
            problem,
            plans[0],
            self._cost,
            self._nodes[self._best[0]][2],
            proven,
            min(lower, self._cost),
            plans,
            self._made,
            len(self._reached),
            reason,
            self._model,
        )

    def _empty(self, lower: Any, reason: str) -> PlanResult:
        model = self._model
        cost = model.value(model.nothing, model.problem.prior)
        prior = model.problem.prior
        return PlanResult(
            model.problem, (), cost, prior, False, lower, ((),), self._made, 1, reason, model
        )

    def _words(self, number: int) -> Iterator[tuple[int, ...]]:
        """Yield the numbers of the actions that lead to a beginning: one way, or all kept ones."""
        pending: list[tuple[int, tuple[int, ...]]] = [(number, ())]
        while pending:
            here, word = pending.pop()
            routes = self._routes[here]
            if not routes:
                yield word
            pending.extend((parent, (action, *word)) for parent, action in reversed(routes))
