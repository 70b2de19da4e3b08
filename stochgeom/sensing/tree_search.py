"""The best plan with sensors of so many moves: an AND/OR tree, searched with bounds.

With w a joint hyperstate, M a matrix of an action, L_x the diagonal matrix of a reading and k moves
left, the least of E[cost of the moves] - price * E[gain of the decisions] is

    V_k(w) = min( - price * best gain of w,
                  c_a |w| + V_(k-1)(w M_a)                        over the actions a,
                  c_s |w| + sum over x of V_(k-1)(w L_x)          over the sensors s ),

where |w| is the sum of w. Losses are gains with the sign turned, at a price of 1; plans that are
tried until they succeed need other prices (`stochgeom.sensing.sensor_plans`).

The bound. V_k is concave and V_k(t w) = t V_k(w), for so are the terms of the minimum; hence
V_k(w) >= sum over theta of w(theta) V_k(e_theta), with e_theta the certainty of a state. In a known
state readings tell nothing, so V_k(e_theta) is at least the cost to go J_k(theta) of dynamic
programming on observed states. A move is left out if its cost and the bounds of what follows do
not undercut the best move before it; a sensing also when it is partly searched, the readings to
come replaced by their bounds. Neither changes a value.

Equal joint hyperstates are one node, whatever led to them, and what moves make of a node is kept
from one price to the next.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from time import monotonic
from typing import Any, Final, final

from stochgeom.decision.costs_to_go import CostsToGo, mean
from stochgeom.decision.number_kinds import NumberKind
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.errors import NodeLimitError
from stochgeom.exact.quotients import number_sign
from stochgeom.exact.sums import AngleSum
from stochgeom.sensing.decisions import Decisions
from stochgeom.sensing.plan_tree import PlanTree
from stochgeom.sensing.sensors import Sensor
from stochgeom.sensing.tree_nodes import Act, Leaf, Node, Sense

NODE_LIMIT: Final = 1_000_000
"""Nodes that the tree of all plans may have, unless told otherwise."""

_WRITTEN_OUT: Final = 30
"""Digits of a number of nodes that an error writes out."""

STAGES: Final = ("any", "act", "sense")
"""What a move may be."""


class OutOfTimeError(Exception):
    """The search was stopped by its clock; never seen by callers of plans."""


@dataclass(eq=False, slots=True)
class _Point:
    """A joint hyperstate, the best decision there, and what the moves make of it."""

    weights: tuple[Any, ...]
    mass: Any
    gain: Any
    decision: int
    acts: list[_Move] | None = None
    looks: list[_Move] | None = None


@dataclass(eq=False, slots=True)
class _Move:
    """An action or a sensing: its place among those, its cost times the mass, what follows."""

    senses: bool
    number: int
    cost: Any
    readings: tuple[int, ...]
    following: tuple[_Point, ...]


def _form(number: AngleSum) -> tuple[Any, ...]:
    return number.constant, frozenset(number.terms)


def _is_nothing(weight: Any) -> bool:
    """Tell whether a weight is 0.

    Of sums of angles by their form: weights are not negative and begin with an exact test, so that
    later ones are 0 only where they were multiplied by 0.
    """
    if isinstance(weight, AngleSum):
        return not weight.terms and weight.constant == 0
    return not weight


def tree_size(stages: Sequence[str], actions: int, readings: int) -> int:
    """Return the number of nodes of the tree of all plans.

    Examples
    --------
    >>> tree_size(["any"] * 3, actions=16, readings=4)
    8421
    """
    total = level = 1
    for stage in stages:
        level *= (actions if stage != "sense" else 0) + (readings if stage != "act" else 0)
        total += level
    return total


def check_tree_size(
    stages: Sequence[str], actions: int, sensors: Iterable[Sensor], node_limit: int
) -> None:
    """Refuse a problem whose tree of all plans may have more nodes than the limit.

    Raises
    ------
    NodeLimitError
        If it may; says how many. Readings that are not possible everywhere count everywhere.
    """
    readings = sum(any(column) for sensor in sensors for column in sensor.columns)
    size = tree_size(stages, actions, readings)
    if size > node_limit:
        power = len(str(size)) - 1
        nodes = str(size) if power < _WRITTEN_OUT else f"more than 10^{power}"
        raise NodeLimitError(
            f"{len(stages)} moves of {actions} actions and {readings} readings make a tree of "
            f"{nodes} nodes; accepted: up to {node_limit}, or another node limit",
            where="horizon",
        )


@final
class TreeSearch:
    """The search for plans of one problem, to be asked with several prices.

    Parameters
    ----------
    problem : PlanningProblem
        States, prior and actions.
    sensors : mapping from labels to Sensor
        Of the same states and kind of numbers.
    decisions : Decisions
        What plans end in.
    prices : tuple of numbers
        Cost of each action.
    stages : sequence of str
        For each move in turn what it may be: ``"any"``, ``"act"`` or ``"sense"``. Moves may be
        left out.
    good_enough : number, optional
        A subplan is cut off where the best decision gains this much per probability of coming
        there.
    node_limit : int
        Most nodes of the tree of all plans.

    Attributes
    ----------
    deadline : float, optional
        When `solve` gives up, on the clock of `time.monotonic`.
    report : callable, optional
        Told the share of the first moves that are searched, at each of them.

    Raises
    ------
    NodeLimitError
        If the tree of all plans has more nodes; the number is told.
    """

    def __init__(
        self,
        problem: PlanningProblem,
        sensors: Mapping[Any, Sensor],
        decisions: Decisions,
        prices: tuple[Any, ...],
        stages: Sequence[str],
        *,
        good_enough: Any = None,
        node_limit: int = NODE_LIMIT,
    ) -> None:
        self._problem, self._decisions = problem, decisions
        self._names, self._sensors = tuple(sensors), tuple(sensors.values())
        self._prices, self._stages = prices, tuple(stages)
        self._good_enough = good_enough
        self._floats = problem.numbers is NumberKind.FLOAT
        self._sums = problem.numbers is NumberKind.ANGLE_SUMS
        self.deadline: float | None = None
        self.report: Callable[[float], None] | None = None
        check_tree_size(self._stages, len(problem.actions), self._sensors, node_limit)
        self._points: dict[tuple[Any, ...], _Point] = {}
        self.root = self._point(self._prior())
        self._price: Any = 1
        self._known: dict[tuple[_Point, int], tuple[Any, tuple[int, _Move] | None]] = {}

    def _prior(self) -> tuple[Any, ...]:
        """Return the prior as plain floats, or as exact numbers whose zeros have the form of 0."""
        if self._floats:
            return tuple(map(float, self._problem.prior))
        return tuple(p if number_sign(p) else 0 * p for p in self._problem.prior)

    # --- nodes -----------------------------------------------------------------------------------

    def _point(self, weights: tuple[Any, ...]) -> _Point:
        # Whether sums of angles are equal is decided by their terms here: to merge less than all
        # that is equal is no error, and the exact test would cost more than it saves.
        key = tuple(map(_form, weights)) if self._sums else weights
        found = self._points.get(key)
        if found is None:
            mass = sum(weights[1:], start=weights[0])
            found = _Point(weights, mass, *self._decisions.best(weights))
            self._points[key] = found
        return found

    def _acts(self, point: _Point) -> list[_Move]:
        """Return the actions at a point; of several with one effect the cheapest, first one."""
        if point.acts is None:
            best: dict[_Point, int] = {}
            for number, price in enumerate(self._prices):
                after = self._problem.after_number(point.weights, number)
                # Floats of numpy's own kind would be hashed and added at a third of the speed.
                child = self._point(tuple(map(float, after)) if self._floats else tuple(after))
                if child is not point and (child not in best or price < self._prices[best[child]]):
                    best[child] = number
            point.acts = [
                _Move(False, number, point.mass * self._prices[number], (), (child,))
                for child, number in best.items()
            ]
        return point.acts

    def _looks(self, point: _Point) -> list[_Move]:
        """Return the sensings at a point, with the readings that are possible."""
        if point.looks is None:
            point.looks = []
            for number, sensor in enumerate(self._sensors):
                places, following = [], []
                for k, column in enumerate(sensor.columns):
                    weights = tuple(
                        w if p == 1 else w * p for w, p in zip(point.weights, column, strict=True)
                    )
                    if not all(map(_is_nothing, weights)):
                        places.append(k)
                        following.append(self._point(weights))
                cost = point.mass * sensor.cost
                point.looks.append(_Move(True, number, cost, tuple(places), tuple(following)))
        return point.looks

    def _moves(self, point: _Point, stage: int) -> Iterator[tuple[int, _Move]]:
        """Yield the moves from a stage on, each with the stage after it."""
        for place in range(stage, self._end):
            kind = self._stages[place]
            if kind != "act":
                for move in self._looks(point):
                    yield place + 1, move
            if kind != "sense":
                for move in self._acts(point):
                    yield place + 1, move
            if kind == "any":  # what later stages allow is allowed here
                return

    # --- values ----------------------------------------------------------------------------------

    def solve(
        self, price: Any, moves: int | None = None, *, free: bool = False
    ) -> tuple[Any, PlanTree]:
        """Return the least E[cost] - price * E[gain] and a plan that attains it.

        Of equal plans the one that ends first, then the one that senses, then the first action.

        Parameters
        ----------
        price : number
            0 or more.
        moves : int, optional
            Use only so many of the stages; default: all.
        free : bool, default False
            Let the moves cost nothing.
        """
        prices = tuple(0 * c for c in self._prices) if free else self._prices
        self._free = free
        self._end = len(self._stages) if moves is None else moves
        self._price = price
        self._known = {}
        ends = tuple(0 - gain * price for gain in self._decisions.best_gains)
        to_go = CostsToGo(self._problem, prices, ends)
        self._bounds = [to_go(left) for left in range(self._end + 1)]
        # Usually all states are worth the same once they are known.
        self._flat = [row[0] if len(set(row)) == 1 else None for row in self._bounds]
        value = self._value(self.root, 0)
        return value, PlanTree(
            self._node(self.root, 0), self._problem.states, self._decisions.accepts
        )

    def bound(self, price: Any) -> Any:
        """Return what no plan can go below, by the costs to go of states that are seen."""
        ends = tuple(0 - gain * price for gain in self._decisions.best_gains)
        to_go = CostsToGo(self._problem, self._prices, ends)
        return mean(self.root.weights, to_go(len(self._stages)))

    def _bound(self, point: _Point, stage: int) -> Any:
        left = self._end - stage
        if not left:
            return 0 - point.gain * self._price
        flat = self._flat[left]
        if flat is not None:
            return point.mass * flat
        return mean(point.weights, self._bounds[left])

    def _value(self, point: _Point, stage: int) -> Any:
        if stage == self._end:
            return 0 - point.gain * self._price
        key = (point, stage)
        found = self._known.get(key)
        if found is not None:
            return found[0]
        if self.deadline is not None and monotonic() > self.deadline:
            raise OutOfTimeError
        best, choice = 0 - point.gain * self._price, None
        if not self._is_good_enough(point):
            # Invariant: `best` is the least value of ending here and of the moves before this one.
            moves = list(self._moves(point, stage))
            for done, (following, move) in enumerate(moves):
                if self.report is not None and point is self.root:
                    self.report(done / len(moves))
                value = self._value_of(move, following, best)
                if value is not None and value < best:
                    best, choice = value, (following, move)
        self._known[key] = best, choice
        return best

    def _value_of(self, move: _Move, stage: int, limit: Any) -> Any | None:
        """Return the value of a move, or None once it is certain not to be below the limit."""
        bounds = [self._bound(child, stage) for child in move.following]
        total = sum(bounds, start=0 * move.cost if self._free else move.cost)
        # Invariant: `total` bounds the value of the move, the children before this one exact.
        if not total < limit:
            return None
        if stage == self._end:
            return total
        for child, bound in zip(move.following, bounds, strict=True):
            total = total - bound + self._value(child, stage)
            if not total < limit:
                return None
        return total

    def _is_good_enough(self, point: _Point) -> bool:
        return self._good_enough is not None and not point.gain < point.mass * self._good_enough

    # --- the plan --------------------------------------------------------------------------------

    def _node(self, point: _Point, stage: int) -> Node:
        """Return the plan from a point on, as the last solution chose it."""
        known = self._known.get((point, stage))
        if known is None or known[1] is None:
            truncated = stage < self._end and self._is_good_enough(point)
            label = self._decisions.labels[point.decision]
            return Leaf(point.weights, label, point.gain, truncated)
        following, move = known[1]
        children = [self._node(child, following) for child in move.following]
        if not move.senses:
            action = self._problem.actions[move.number]
            return Act(point.weights, action, self._prices[move.number], children[0])
        sensor = self._sensors[move.number]
        branches = zip((sensor.readings[k] for k in move.readings), children, strict=True)
        return Sense(point.weights, self._names[move.number], sensor.cost, tuple(branches))
