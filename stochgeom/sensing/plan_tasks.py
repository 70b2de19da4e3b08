"""How the best plan with sensors is found: one price for additive costs, several for quotients.

A plan is best for the quotient E[cost] / P(success) exactly if it is best for cost - price * gain
with its own quotient as the price; and that is additive, so the recursion finds it. Dinkelbach's
iteration starts with any plan, takes its quotient for the price, finds the best plan at that price,
and goes on from it. Each round lowers the quotient, there are finitely many plans, and where the
quotient stays it is the least.

Quotients of angle sums are in general irrational, and at a rational price values stay sums of
angles, whose order is decided fast. So an irrational quotient is enclosed between two rational
prices. The value of a plan is linear in the price: a plan that no other undercuts at both ends is
undercut by none in between, so neither at its own quotient, and it is optimal, exactly. Where
another plan has the same irrational quotient (twice the cost, twice the probability: that happens)
no enclosure decides; then the quotient itself is the price (`stochgeom.sensing.irrational_prices`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from numbers import Real
from time import monotonic
from typing import Any, Final, TypeAlias

from gmpy2 import mpq

from stochgeom.arguments import as_count, as_list, expect
from stochgeom.decision.labels import Labels, named
from stochgeom.decision.number_kinds import NumberKind, read_number
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.errors import InputError, NoPlanError, SensorError, ShapeMismatchError
from stochgeom.exact.decimals import Rounding, certified_decimal
from stochgeom.exact.quotients import SumQuotient, quotient
from stochgeom.sensing.decisions import Decisions
from stochgeom.sensing.irrational_prices import IrrationalPrice
from stochgeom.sensing.plan_tree import PlanTree
from stochgeom.sensing.sensor_plan import SensorPlan
from stochgeom.sensing.sensors import Sensor
from stochgeom.sensing.tree_search import STAGES, OutOfTimeError, TreeSearch

Sensors: TypeAlias = "Sensor | Iterable[Sensor] | Mapping[Any, Sensor]"
"""One sensor, several, or several with labels."""

MOST_MOVES: Final = 300
"""Moves on a way through a tree; each of them takes frames of Python's stack, which has 1000."""

_PRICE_DIGITS: Final = 20
"""Decimals of the rational prices that enclose an irrational one."""


class PlanTask:
    """A problem with its sensors, checked, and what is asked of it.

    Attributes
    ----------
    good_enough : number, optional
        The gain, per probability, at which subplans are cut off.
    round_cost : number, optional
        What a round costs besides its moves, of plans that are repeated.
    """

    good_enough: Any = None
    round_cost: Any = None

    def __init__(
        self,
        problem: PlanningProblem,
        sensors: Sensors,
        decisions: Decisions,
        prices: tuple[Any, ...],
        horizon: int | None,
        stages: Sequence[str] | None,
        node_limit: int,
    ) -> None:
        self.problem, self.decisions, self.prices = problem, decisions, prices
        self.sensors = {
            label: _fitting(sensor, label, problem) for label, sensor in labelled(sensors).items()
        }
        self.stages = _stages(horizon, stages)
        self.node_limit = as_count(node_limit, "nodes", where="node limit")

    def number(self, value: Any, where: str) -> Any:
        """Return a number of the problem's kind."""
        kind = NumberKind.RATIONAL if self.problem.exact else NumberKind.FLOAT
        return read_number(value, kind, where)

    def run(self, time_limit: float | None, progress: Callable[[float], None] | None) -> SensorPlan:
        """Return the best plan, or the best one that time allows.

        With a time limit, plans of no move are searched first, then those of one, and so on.
        """
        search = TreeSearch(
            self.problem,
            self.sensors,
            self.decisions,
            self.prices,
            self.stages,
            good_enough=self.good_enough,
            node_limit=self.node_limit,
        )
        search.report = progress
        moves = len(self.stages)
        best: PlanTree | None = None
        if time_limit is not None:
            search.deadline = monotonic() + expect(time_limit, Real, "seconds", "time limit")
        complete = self.good_enough is None
        for depth in range(moves + 1) if time_limit is not None else [moves]:
            try:
                for tree in self._solve(search, depth, best):
                    best = tree
            except OutOfTimeError:
                complete = False
                break
            except NoPlanError:
                if depth == moves:
                    raise
        if best is None:
            raise NoPlanError(f"no plan was found in {time_limit} seconds; accepted: more of them")
        return self._plan(best, None if complete else self._floor(search))

    def _solve(self, search: TreeSearch, moves: int, start: PlanTree | None) -> Iterator[PlanTree]:
        """Yield trees of so many moves, each better than the one before, the best one last."""
        if self.round_cost is not None:
            yield from until_success(search, moves, self.round_cost, start)
        else:
            yield search.solve(1, moves)[1]

    def _plan(self, tree: PlanTree, floor: Any) -> SensorPlan:
        """Return a plan with what is known about it: proven to be the best if no floor is given."""
        largest = max(abs(gain) for row in self.decisions.gains for gain in row)
        plan = SensorPlan(
            tree,
            self.round_cost,
            floor is None,
            floor,
            max((sensor.row_error for sensor in self.sensors.values()), default=mpq(0)),
            1 if self.decisions.accepts else largest,
        )
        return replace(plan, lower_bound=plan.expected_cost) if floor is None else plan

    def _floor(self, search: TreeSearch) -> Any:
        """Return what no plan costs less than.

        Once: the costs when states are seen. Repeated: those of a round that always gains most.
        """
        if self.round_cost is None:
            return search.bound(1)
        return quotient(self.round_cost, max(self.decisions.best_gains))


def until_success(
    search: TreeSearch, moves: int, round_cost: Any, start: PlanTree | None = None
) -> Iterator[PlanTree]:
    """Yield trees of less and less cost per success; the last one is the best.

    Parameters
    ----------
    search : TreeSearch
        Finds the best tree at a price.
    moves : int
        Most moves.
    round_cost : number
        Cost of a round besides its moves.
    start : PlanTree, optional
        A tree to begin with.

    Raises
    ------
    NoPlanError
        If no tree ever succeeds.
    """
    best: PlanTree | None = _some_success(search, moves) if start is None else start
    while best is not None:
        yield best
        best = _better(search, moves, round_cost, best)


def _better(search: TreeSearch, moves: int, round_cost: Any, best: PlanTree) -> PlanTree | None:
    """Return a tree of less cost per success, None if there is none: proven."""
    ratio = quotient(round_cost + best.cost, best.gain)

    def below(tree: PlanTree) -> bool:
        return tree.gain > 0 and bool(quotient(round_cost + tree.cost, tree.gain) < ratio)

    if not isinstance(ratio, SumQuotient):
        _, tree = search.solve(ratio, moves)
        return tree if below(tree) else None
    undercut = False
    for rounding in (Rounding.UP, Rounding.DOWN):
        price = mpq(certified_decimal(ratio.ball, _PRICE_DIGITS, rounding))
        value, tree = search.solve(price, moves)
        if below(tree):
            return tree
        undercut |= bool(value < best.cost - best.gain * price)
    if undercut:  # by a tree of the same quotient, or by one that is better by a hair
        _, tree = search.solve(IrrationalPrice(ratio), moves)
        return tree if below(tree) else None
    return None


def _some_success(search: TreeSearch, moves: int) -> PlanTree:
    """Return a plan that may succeed: to end at once, or the one that succeeds most often."""
    _, tree = search.solve(0, 0)
    if not tree.gain > 0:
        _, tree = search.solve(1, moves, free=True)
        if not tree.gain > 0:
            raise NoPlanError(f"no plan of {moves} moves ever succeeds")
    return tree


# --- what is given -------------------------------------------------------------------------------


def labelled(sensors: Sensors) -> dict[Any, Sensor]:
    """Return sensors by label: their names where they have any.

    Raises
    ------
    SensorError
        If what is given is no sensor.
    DuplicateLabelError
        If two have one name.

    Examples
    --------
    >>> list(labelled([Sensor.blind(["a"]), Sensor.blind(["a"], name="eye")]))
    ['sensor 0', 'eye']
    """
    if isinstance(sensors, Mapping):
        found = dict(sensors)
    else:
        listed = (
            [sensors] if isinstance(sensors, Sensor) else as_list(sensors, "sensors", "sensors")
        )
        names = [
            getattr(sensor, "name", None) or ("sensor" if len(listed) == 1 else f"sensor {k}")
            for k, sensor in enumerate(listed)
        ]
        found = dict(zip(Labels(names, "sensor") if names else (), listed, strict=True))
    for label, sensor in found.items():
        if not isinstance(sensor, Sensor):
            raise SensorError(
                f"{sensor!r:.60} is no sensor; accepted: Sensor", where=f"sensor {named(label)}"
            )
    return found


def _fitting(sensor: Sensor, label: Any, problem: PlanningProblem) -> Sensor:
    """Return a sensor in the numbers of a problem, its states in the problem's order."""
    place = f"sensor {named(label)}"
    if sensor.states != problem.states:
        for state in sensor.states:
            problem.state_number(state)
        raise ShapeMismatchError(
            f"its states are {sensor.states!r:.60}; accepted: those of the problem, in its order",
            where=place,
        )
    sensor.check_kind(problem.numbers)
    return sensor.to_float() if sensor.exact and not problem.exact else sensor


def _stages(horizon: int | None, stages: Sequence[str] | None) -> tuple[str, ...]:
    """Return what each move may be, from a horizon or from a list."""
    if (horizon is None) == (stages is None):
        raise InputError("neither or both of a horizon and stages; accepted: one of them")
    if stages is None:
        moves = as_count(horizon, "moves", least=0, most=MOST_MOVES, where="horizon")
        return ("any",) * moves
    stages = as_list(stages, f"a list of {', '.join(STAGES)}", "stages")
    as_count(len(stages), "of them", least=0, most=MOST_MOVES, where="stages")
    for stage in stages:
        if stage not in STAGES:
            raise InputError(f"{stage!r}; accepted: {', '.join(STAGES)}", where="stages")
    return tuple(stages)
