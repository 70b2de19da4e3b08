"""What a search for a plan found, whether it is proven optimal, and what it took."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from numbers import Real
from typing import TYPE_CHECKING, Any, Final, final

from stochgeom.arguments import as_count, expect
from stochgeom.decision.infinity import is_infinite
from stochgeom.decision.planning_problem import PlanningProblem, Vector
from stochgeom.errors import InputError, ProblemError

if TYPE_CHECKING:
    from stochgeom.decision.plan_costs import CostModel

METHODS: Final = ("best-first", "breadth-first", "exhaustive")
"""The roads to a plan, by name; see `stochgeom.decision.plan_search`."""

NODE_LIMIT: Final = 1_000_000
"""Nodes that a search makes at most, unless told otherwise."""


@final
@dataclass(frozen=True)
class PlanResult:
    """A plan, with its cost and what is known of better ones.

    Attributes
    ----------
    problem : PlanningProblem
        Whose plan.
    plan : tuple of labels
        The actions.
    cost : number
        What the plan costs; infinite if no plan was found that costs less.
    hyperstate : vector
        What the plan makes of the prior.
    proven : bool
        Whether no plan that was asked for costs less, and none of the same cost is shorter. (Of a
        float problem: up to the rounding of floats.)
    lower_bound : number
        No plan that was asked for costs less; the cost itself if proven.
    optimal : tuple of plans
        All plans of this cost and length if they were asked for and the cost is finite, else this
        plan alone or some of them.
    nodes : int
        Hyperstates that were made, equal ones counted each time.
    distinct : int
        Different ones among them, as far as that was looked at.
    reason : str
        Why the search ended: ``"proven"``, ``"node limit"``, ``"time limit"``, ``"threshold"`` or
        ``"tries"``.
    """

    problem: PlanningProblem
    plan: tuple[Any, ...]
    cost: Any
    hyperstate: Vector
    proven: bool
    lower_bound: Any
    optimal: tuple[tuple[Any, ...], ...]
    nodes: int
    distinct: int
    reason: str
    model: CostModel = field(repr=False, compare=False)

    @property
    def feasible(self) -> bool:
        """Whether the cost is finite."""
        return not is_infinite(self.cost)

    def __len__(self) -> int:
        return len(self.plan)


@final
class Limits:
    """Ends a search after so many nodes or so many seconds, and tells how far it is.

    Parameters
    ----------
    node_limit : int
        Most nodes.
    time_limit : float, optional
        Most seconds, from now on.
    progress : callable, optional
        ``progress(share)`` is told which share of the limits is used up, in [0, 1].

    Raises
    ------
    InputError
        If a limit is not positive.
    """

    def __init__(
        self,
        node_limit: int = NODE_LIMIT,
        time_limit: float | None = None,
        progress: Callable[[float], object] | None = None,
    ) -> None:
        self.node_limit = as_count(node_limit, "nodes", where="node limit")
        if time_limit is not None and not expect(time_limit, Real, "seconds", "time limit") > 0:
            raise InputError(f"{time_limit} seconds; accepted: more than 0", where="time limit")
        self._time_limit, self._progress = time_limit, progress
        self._start = time.monotonic()
        self.reason: str | None = None
        """Which limit came first; None: none yet."""

    def reached(self, nodes: int) -> bool:
        """Tell whether a search that has made so many nodes has to end."""
        share = nodes / self.node_limit
        if nodes >= self.node_limit:
            self.reason = "node limit"
        elif nodes % _INTERVAL == 0 and self._time_limit is not None:
            share = max(share, (time.monotonic() - self._start) / self._time_limit)
            if share >= 1:
                self.reason = "time limit"
        if self._progress is not None and nodes % _INTERVAL == 0:
            self._progress(share)
        return self.reason is not None


_INTERVAL: Final = 64
"""Nodes between two looks at the clock."""


def check_problem(problem: PlanningProblem) -> None:
    """Refuse what is no planning problem.

    Raises
    ------
    ProblemError
        If it is none; an `OrientingProblem` holds one.
    """
    if not isinstance(problem, PlanningProblem):
        raise ProblemError(
            f"{problem!r:.60} is of type {type(problem).__name__}; accepted: a PlanningProblem, "
            "such as planning_problem_of(part).problem"
        )


def model_of(problem: PlanningProblem, cost: Any) -> Any:
    """Return the cost model of a cost, or of the problem's own.

    Raises
    ------
    ProblemError
        If there is neither.
    """
    check_problem(problem)
    chosen = problem.cost if cost is None else cost
    if chosen is None or not hasattr(chosen, "on"):
        raise ProblemError(
            f"the cost is {chosen!r:.60}; accepted: a PlanCost, given here or with the problem"
        )
    return chosen.on(problem)
