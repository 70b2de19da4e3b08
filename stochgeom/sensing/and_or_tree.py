"""The tree of all plans with sensors, whole: an AND/OR tree (thesis 7.2.5, Fig. 7.4).

At a node a plan ends or chooses one move: OR. After an action one node follows; after a look at a
sensor one for each reading that is possible, and a plan needs a subplan for all of them: AND. So
the plans from a node on are one more than the sum over its moves of the products over what follows.

Values go up from the leaves as in `stochgeom.sensing.tree_search`, but with no bounds, no merging
and no order of moves: this tree is for looking at, and for checking that search on small problems.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from math import prod
from typing import Any, Final, final

from stochgeom.decision.number_kinds import NumberKind
from stochgeom.decision.plan_results import check_problem
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.display import Displayed
from stochgeom.exact.quotients import SumQuotient, number_sign
from stochgeom.sensing.irrational_prices import IrrationalPrice
from stochgeom.sensing.plan_tasks import PlanTask, Sensors
from stochgeom.sensing.planners import ends_by_cost, plan_for_cost
from stochgeom.sensing.tree_nodes import Leaf, Wording, mass_of
from stochgeom.sensing.tree_search import check_tree_size

MOST_NODES: Final = 10_000
"""Nodes that a whole tree may have, unless told otherwise."""


@final
@dataclass(frozen=True, slots=True)
class Move:
    """A move that plans may make at a node, and the nodes that follow it.

    Attributes
    ----------
    senses : bool
        Whether it looks at a sensor; otherwise it acts.
    label : label
        The action, or the sensor.
    cost : number
        Its cost.
    branches : tuple of (label, Choice)
        The readings of positive probability and what follows them; after an action one node, of
        the reading None.
    """

    senses: bool
    label: Any
    cost: Any
    branches: tuple[tuple[Any, Choice], ...]


@final
@dataclass(frozen=True, slots=True)
class Choice:
    """A node: a joint hyperstate, where a plan ends or goes on.

    Attributes
    ----------
    end : Leaf
        What ending here decides; its weights are the joint hyperstate.
    moves : tuple of Move
        The other choices; none at the horizon.
    least : number or None
        The least expected cost from here on, times the probability of coming here; gains count
        against it at the price of the tree. None where the problem has no cost.
    best : tuple of int
        Which moves attain it, by their places; -1 for ending here. All that tie.
    """

    end: Leaf
    moves: tuple[Move, ...]
    least: Any
    best: tuple[int, ...]


@final
@dataclass(frozen=True)
class AndOrTree(Displayed):
    """All plans with sensors of so many moves.

    Made by `all_sensor_plans`.

    Attributes
    ----------
    root : Choice
        Before the first move.
    states : tuple of labels
        The states that joint hyperstates are about.
    words : Wording
        How texts and drawings speak of the ends.
    expected_cost : number or None
        Of the best plan; None where the problem has no cost.
    """

    root: Choice
    states: tuple[Any, ...]
    words: Wording
    expected_cost: Any

    def nodes(self) -> Iterator[Choice]:
        """Yield all nodes, each before those below it."""
        pending = [self.root]
        while pending:
            node = pending.pop()
            yield node
            pending.extend(child for move in reversed(node.moves) for _, child in move.branches)

    @cached_property
    def plans(self) -> int:
        """The number of plans."""
        return _count(self.root, lambda node: range(-1, len(node.moves)))

    @cached_property
    def best_plans(self) -> int:
        """The number of plans that cost least: more than one where some tie."""
        return _count(self.root, lambda node: node.best)

    def __repr__(self) -> str:
        nodes = sum(1 for _ in self.nodes())
        plural = "s" * (nodes != 1), "s" * (self.plans != 1)
        return f"<AndOrTree: {nodes} node{plural[0]}, {self.plans} plan{plural[1]}>"


def _count(node: Choice, chosen: Callable[[Choice], Iterable[int]]) -> int:
    """Return the number of plans from a node on that make only the chosen moves."""
    total = 0
    for place in chosen(node):
        branches = () if place < 0 else node.moves[place].branches
        total += prod(_count(child, chosen) for _, child in branches)
    return total


def all_sensor_plans(
    problem: PlanningProblem, sensors: Sensors, horizon: int, *, node_limit: int = MOST_NODES
) -> AndOrTree:
    """Return the tree of all plans with sensors of so many moves (7.2.5, Fig. 7.4).

    Parameters
    ----------
    problem : PlanningProblem
        With an `IterativeCost`, or one that is additive, tells the best plans, as `plan_for_cost`
        finds them; without a cost the tree has no values.
    sensors : Sensor, or several, or mapping from labels
        What may be looked at.
    horizon : int
        Most moves on any way through the tree, sensings included; at most 300.
    node_limit : int, default 10,000
        Most nodes.

    Raises
    ------
    NodeLimitError
        If the tree may have more nodes; says how many if every reading is possible everywhere.
    InputError
        If the horizon or the node limit is no whole number.
    ProblemError, SensorError, ShapeMismatchError, MixedNumbersError
        As for `plan_for_cost`.
    NoPlanError
        If no plan ever succeeds.

    Notes
    -----
    Time and space are those of the tree: (actions + readings)^horizon nodes.

    Examples
    --------
    Of a coin that may be looked at and turned, in one move or none:

    >>> from stochgeom.decision.additive_costs import AdditiveCost
    >>> from stochgeom.sensing.sensors import Sensor
    >>> coin = PlanningProblem(
    ...     ["heads", "tails"], ["1/2", "1/2"], ["turn"], [[[0, 1], [1, 0]]],
    ...     AdditiveCost(actions="1/8", states={"tails": 1}))
    >>> eye = Sensor.perfect(coin.states, cost="1/16")
    >>> all_sensor_plans(coin, eye, 1).plans
    3
    >>> tree = all_sensor_plans(coin, eye, 2)
    >>> tree, tree.expected_cost, tree.best_plans
    (<AndOrTree: 11 nodes, 13 plans>, mpq(1,8), 1)
    """
    check_problem(problem)
    decisions, prices, round_cost = ends_by_cost(problem)
    task = PlanTask(problem, sensors, decisions, prices, horizon, None, node_limit)
    check_tree_size(task.stages, len(problem.actions), task.sensors.values(), node_limit)
    cost = None if problem.cost is None else plan_for_cost(problem, sensors, horizon).expected_cost
    price = cost if round_cost is not None or cost is None else 1
    price = IrrationalPrice(price) if isinstance(price, SumQuotient) else price
    root = _Builder(task, price).node(_numbers(problem, problem.prior), horizon)
    return AndOrTree(root, problem.states, Wording(decisions.accepts), cost)


def _numbers(problem: PlanningProblem, hyperstate: Iterable[Any]) -> tuple[Any, ...]:
    """Return the entries of a hyperstate, floats as Python's own."""
    return tuple(map(float, hyperstate) if problem.numbers is NumberKind.FLOAT else hyperstate)


@dataclass(frozen=True, slots=True)
class _Builder:
    """Makes nodes from the leaves up."""

    task: PlanTask
    price: Any

    def node(self, weights: tuple[Any, ...], left: int) -> Choice:
        """Return the node of a joint hyperstate with so many moves left."""
        gain, number = self.task.decisions.best(weights)
        end = Leaf(weights, self.task.decisions.labels[number], gain)
        moves = tuple(self._moves(weights, left - 1)) if left else ()
        if self.price is None:
            return Choice(end, moves, None, ())
        mass = mass_of(end)
        values = [0 - gain * self.price]
        values += [
            sum((child.least for _, child in move.branches), start=mass * move.cost)
            for move in moves
        ]
        # Of values at an irrational price only the order is known.
        least = min(values)
        best = tuple(k - 1 for k, value in enumerate(values) if not least < value)
        return Choice(end, moves, least, best)

    def _moves(self, weights: tuple[Any, ...], left: int) -> Iterator[Move]:
        task = self.task
        for number, action in enumerate(task.problem.actions):
            after = _numbers(task.problem, task.problem.after_number(weights, number))
            yield Move(False, action, task.prices[number], ((None, self.node(after, left)),))
        for label, sensor in task.sensors.items():
            joints = (
                tuple(w * p for w, p in zip(weights, column, strict=True))
                for column in sensor.columns
            )
            branches = tuple(
                (reading, self.node(joint, left))
                for reading, joint in zip(sensor.readings, joints, strict=True)
                if any(map(number_sign, joint))
            )
            yield Move(True, label, sensor.cost, branches)
