"""Finding the best open-loop plan of a planning problem (Eq. 2.3, 2.5; thesis 2.4, 7.1.2).

Three roads to the same plan:

- best-first branch and bound, `stochgeom.decision.branch_and_bound`, which proves optimality by
  bounds and, stopped early, still tells a lower bound;
- breadth-first, `stochgeom.decision.search`, level by level, equal hyperstates merged;
- exhaustive, `stochgeom.decision.exhaustive_plans`, every plan by itself; float problems on numpy.

Of plans of equal cost one with the fewest actions is returned. In general the search is NP-complete
(thesis 2.4, after Papadimitriou and Tsitsiklis), so there are limits on nodes and time; the result
says whether it is proven.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, final

from stochgeom.arguments import as_count
from stochgeom.decision.branch_and_bound import BestFirst
from stochgeom.decision.exhaustive_plans import exhaustive_search, fitting_horizon
from stochgeom.decision.plan_costs import CostModel, PlanCost
from stochgeom.decision.plan_results import METHODS, NODE_LIMIT, Limits, PlanResult, model_of
from stochgeom.decision.planning_problem import PlanningProblem, Vector
from stochgeom.decision.search import Level, SearchResult, breadth_first
from stochgeom.errors import InputError


def find_plan(
    problem: PlanningProblem,
    horizon: int | None = None,
    cost: PlanCost | None = None,
    *,
    method: str | None = None,
    shortest: int = 1,
    all_optimal: bool = False,
    threshold: Any = None,
    node_limit: int = NODE_LIMIT,
    time_limit: float | None = None,
    progress: Callable[[float], object] | None = None,
) -> PlanResult:
    """Return a plan of least cost among those of at most `horizon` actions.

    Parameters
    ----------
    problem : PlanningProblem
        The problem.
    horizon : int, optional
        Most actions. Without it plans may be of any length: every action must have a price above
        0, which bounds the length of plans that are worth it, or be deterministic, so that there
        are finitely many hyperstates.
    cost : PlanCost, optional
        Default: the problem's own.
    method : str, optional
        ``"best-first"``, ``"breadth-first"`` or ``"exhaustive"``. Default: exhaustive for float
        problems with a horizon and no more plans than the node limit, else best-first.
    shortest : int, default 1
        Fewest actions: 1, or 0 if the plan that does nothing is one.
    all_optimal : bool, default False
        Return all plans of the least cost and, among those, the fewest actions.
    threshold : number, optional
        A plan that costs no more is good enough and ends the search (best-first only).
    node_limit : int, default 1,000,000
        Most hyperstates that are made.
    time_limit : float, optional
        Most seconds.
    progress : callable, optional
        ``progress(share)`` is told which share of the limits is used up.

    Returns
    -------
    PlanResult
        With ``proven`` False, and a lower bound, if a limit or the threshold ended the search.

    Raises
    ------
    InputError
        If the horizon is below `shortest`, the method is none, or nothing bounds the length.
    NodeLimitError
        If an exhaustive search would make more nodes than the limit: it tells how many.
    ProblemError, CostError
        If there is no cost, or it does not fit the problem.

    Notes
    -----
    Time and memory O(m^horizon n^2) at worst for m actions and n states, by every method.

    Examples
    --------
    >>> from stochgeom.decision.iterative_costs import IterativeCost
    >>> coin = PlanningProblem(
    ...     ["heads", "tails"], ["1/3", "2/3"], ["turn", "throw"],
    ...     {"turn": [[0, 1], [1, 0]], "throw": [["1/2", "1/2"], ["1/2", "1/2"]]},
    ... )
    >>> found = find_plan(coin, 4, IterativeCost("heads"))
    >>> found.plan, found.cost, found.proven
    (('turn',), mpq(3,1), True)
    """
    model = model_of(problem, cost)
    horizon = _read_horizon(model, horizon, shortest, method, threshold)
    limits = Limits(node_limit, time_limit, progress)
    threshold = None if threshold is None else model.as_cost(threshold)
    chosen = _default(model, horizon, shortest, node_limit, threshold) if method is None else method
    if chosen == "exhaustive":
        assert horizon is not None
        return exhaustive_search(
            model,
            horizon,
            shortest=shortest,
            all_optimal=all_optimal,
            node_limit=node_limit,
            limits=limits,
        )
    if chosen == "breadth-first":
        return _BreadthFirst(model, horizon, shortest, all_optimal).run(limits)
    search = BestFirst(
        model, horizon, shortest=shortest, all_optimal=all_optimal, threshold=threshold
    )
    return search.run(limits)


def best_action(problem: PlanningProblem, cost: PlanCost | None = None) -> PlanResult:
    """Return the best one-step plan, and with it all that are as good (Eq. 2.3).

    Examples
    --------
    >>> from stochgeom.decision.goal_costs import GoalCost
    >>> turn = PlanningProblem(
    ...     ["a", "b"], ["1/4", "3/4"], ["stay", "turn"], [[[1, 0], [0, 1]], [[0, 1], [1, 0]]]
    ... )
    >>> best_action(turn, GoalCost("a")).optimal
    (('turn',),)
    """
    return find_plan(problem, 1, cost, all_optimal=True)


def _default(
    model: CostModel, horizon: int | None, shortest: int, node_limit: int, threshold: Any
) -> str:
    problem = model.problem
    if problem.exact or horizon is None or threshold is not None:
        return "best-first"
    fits = fitting_horizon(len(problem.actions), horizon, shortest, node_limit)
    return "exhaustive" if fits == horizon else "best-first"


def _read_horizon(
    model: CostModel, horizon: int | None, shortest: int, method: str | None, threshold: Any
) -> int | None:
    """Return the horizon as an int, if there is one; refuse what does not go together."""
    if method is not None and method not in METHODS:
        raise InputError(f"method {method!r}; accepted: {', '.join(METHODS)}")
    if shortest not in (0, 1):
        raise InputError(f"shortest = {shortest!r}; accepted: 0 or 1", where="shortest")
    if threshold is not None and method not in (None, "best-first"):
        raise InputError(f"a threshold with method {method!r}; accepted: best-first")
    if horizon is None:
        if method == "exhaustive":
            raise InputError("no horizon; accepted: one, for an exhaustive search")
        if not model.least_price and not model.problem.deterministic:
            raise InputError(
                "no horizon, and an action is free: nothing bounds the length of a plan; accepted: "
                "a horizon, or prices above 0"
            )
        return None
    return as_count(horizon, "actions", least=shortest, where="horizon")


# --- breadth first -------------------------------------------------------------------------------


@final
class _Beginning:
    """A hyperstate with what was spent on the way to it.

    Beginnings with the same hyperstate are one if all actions have one price: the later one has
    spent as much or more. Otherwise they must have spent the same to be one. The plan without
    actions is apart from them unless it counts as a plan.
    """

    __slots__ = ("_hash", "_key", "hyperstate", "is_plan", "spent")

    def __init__(
        self, hyperstate: Vector, spent: Any, *, is_plan: bool, spent_counts: bool
    ) -> None:
        self.hyperstate, self.spent, self.is_plan = hyperstate, spent, is_plan
        content = hyperstate if isinstance(hyperstate, tuple) else hyperstate.tobytes()
        self._key = (content, is_plan, spent if spent_counts else None)
        self._hash = hash(self._key)

    def __eq__(self, other: object) -> bool:
        return self._key == other._key if isinstance(other, _Beginning) else NotImplemented

    def __hash__(self) -> int:
        return self._hash


@final
class _Worth:
    """A cost, ordered the other way round; None is that of no plan."""

    __slots__ = ("cost",)

    def __init__(self, cost: Any) -> None:
        self.cost = cost

    def __lt__(self, other: _Worth) -> bool:
        if self.cost is None or other.cost is None:
            return self.cost is None and other.cost is not None
        return bool(other.cost < self.cost)


@final
class _BreadthFirst:
    """Ties a problem to `stochgeom.decision.search`."""

    def __init__(
        self, model: CostModel, horizon: int | None, shortest: int, all_optimal: bool
    ) -> None:
        self._model, self._horizon = model, horizon
        self._shortest, self._keep_ties = shortest, all_optimal
        self._uniform = all(price == model.prices[0] for price in model.prices)

    def run(self, limits: Limits) -> PlanResult:
        """Search level by level."""
        model, problem = self._model, self._model.problem
        root = self._beginning(problem.prior, model.nothing, is_plan=self._shortest == 0)
        found = breadth_first(
            root,
            tuple(range(len(problem.actions))),
            self._after,
            self._worth,
            node_limit=limits.node_limit + 1,
            depth=self._horizon,
            keep_ties=self._keep_ties,
            enough=self._is_enough,
            stop=limits.reached,
        )
        return self._result(found, limits)

    def _beginning(self, hyperstate: Vector, spent: Any, *, is_plan: bool) -> _Beginning:
        return _Beginning(hyperstate, spent, is_plan=is_plan, spent_counts=not self._uniform)

    def _after(self, node: _Beginning, action: int) -> _Beginning:
        hyperstate = self._model.problem.after_number(node.hyperstate, action)
        return self._beginning(hyperstate, node.spent + self._model.prices[action], is_plan=True)

    def _worth(self, node: _Beginning) -> _Worth:
        return _Worth(self._model.value(node.spent, node.hyperstate) if node.is_plan else None)

    def _is_enough(self, level: Level[_Beginning, _Worth]) -> bool:
        """Tell whether all longer plans cost as much as the best one found: they are no shorter."""
        if level.worth.cost is None or not self._model.least_price:
            return False
        longer = self._model.floor((level.length + 1) * self._model.least_price)
        return not longer < level.worth.cost

    def _result(self, found: SearchResult[_Beginning, _Worth], limits: Limits) -> PlanResult:
        model, problem = self._model, self._model.problem
        first = next(level for level in found.levels if not level.worth < found.last.worth)
        words = found.sequences(first.length)
        plans = tuple(tuple(problem.actions[k] for k in word) for word in words)
        proven = found.last.complete
        cost = found.last.worth.cost
        if cost is None:  # the limit came before the first action
            cost = model.value(model.nothing, problem.prior)
        bound = model.bound(model.nothing, problem.prior, self._horizon)
        return PlanResult(
            problem,
            plans[0],
            cost,
            first.best[0].hyperstate,
            proven,
            cost if proven else min(bound, cost),
            plans if self._keep_ties else plans[:1],
            found.last.generated,
            found.last.distinct,
            "proven" if proven else (limits.reason or "node limit"),
            model,
        )
