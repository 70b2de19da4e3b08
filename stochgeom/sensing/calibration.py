"""Finding out an unknown parameter of a sensor by reading it (thesis 7.2.7).

The parameter becomes part of the state: a state is a value of the parameter together with a state
of the problem. Actions change the latter only; the likelihoods of readings depend on both. A
calibration plan moves and reads, and ends by naming a value. Its cost is what naming a wrong one
costs; `expected_entropy` says how uncertain the value is left.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from typing import Any, final

from stochgeom.arguments import expect
from stochgeom.decision.entropy import entropy_of
from stochgeom.decision.labels import Labels, named
from stochgeom.decision.number_kinds import common_kind, numbered, read_number
from stochgeom.decision.plan_results import check_problem
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.errors import ShapeMismatchError
from stochgeom.sensing.decisions import Decisions, lose_by_table
from stochgeom.sensing.plan_tree import PlanTree
from stochgeom.sensing.planners import sensor_plan
from stochgeom.sensing.sensor_plan import SensorPlan
from stochgeom.sensing.sensors import Sensor


@final
@dataclass(frozen=True)
class CalibrationProblem:
    """A problem whose states hold a parameter of the sensor; made by `calibration_problem`.

    Attributes
    ----------
    problem : PlanningProblem
        States are pairs (value of the parameter, state).
    sensor : Sensor
        The sensor of unknown parameter.
    values : tuple of labels
        What the parameter may be.
    """

    problem: PlanningProblem
    sensor: Sensor
    values: tuple[Any, ...]

    def decisions(self, losses: Any = 1) -> Decisions:
        """Return the decisions to name a value.

        Parameters
        ----------
        losses : number or mapping, default 1
            What a wrong value costs; or ``losses[named][true]``, zeros left out.
        """
        table = losses
        if not isinstance(losses, Mapping):
            table = {v: {other: losses for other in self.values if other != v} for v in self.values}
        return lose_by_table(
            self.problem,
            {
                value: {state: row.get(state[0], 0) for state in self.problem.states}
                for value, row in table.items()
            },
        )

    def plan(self, horizon: int, losses: Any = 1, action_costs: Any = 0, **more: Any) -> SensorPlan:
        """Return the plan of least expected cost that ends by naming a value.

        Parameters
        ----------
        horizon : int
            Most moves, readings included.
        losses : number or mapping, default 1
            As for `decisions`.
        action_costs : number or mapping, default 0
            Costs of the actions; a reading costs what the sensor does.
        **more
            As for `sensor_plan`.
        """
        return sensor_plan(
            self.problem,
            {self.sensor.name or "sensor": self.sensor},
            horizon,
            action_costs=action_costs,
            decisions=self.decisions(losses),
            **more,
        )

    def expected_entropy(self, plan: SensorPlan) -> Any:
        """Return how many bits of uncertainty of the parameter a plan leaves on average."""
        return expected_entropy(plan.tree, lambda state: state[0])


def calibration_problem(
    problem: PlanningProblem,
    sensors: Mapping[Hashable, Sensor],
    weights: Mapping[Hashable, Any] | None = None,
) -> CalibrationProblem:
    """Return the problem of finding out which sensor a sensor is.

    Parameters
    ----------
    problem : PlanningProblem
        What is known of the state, and what actions do to it.
    sensors : mapping from values of the parameter to Sensor
        What the sensor is if the parameter has that value: of the same readings and cost.
    weights : mapping from values to numbers, optional
        How likely each value is beforehand, of sum 1; default: all alike.

    Raises
    ------
    ShapeMismatchError
        If the sensors differ in readings or cost, or in states from the problem.

    Examples
    --------
    A sensor errs one time in ten or, broken, every other time. A pin that is surely out is read to
    find out which:

    >>> pin = PlanningProblem(
    ...     ["in", "out"], [0, 1], ["push"], [[[1, 0], [1, 0]]])
    >>> found = calibration_problem(pin, {
    ...     "sound": Sensor.noisy(pin.states, "1/10"), "broken": Sensor.noisy(pin.states, "1/2")})
    >>> [(found.plan(n).expected_cost, found.expected_entropy(found.plan(n)).decimal(3))
    ...  for n in (0, 1, 3)]
    [(mpq(1,2), '1.000'), (mpq(3,10), '0.853'), (mpq(99,500), '0.693')]
    >>> print(found.plan(1).tree.text())
    read sensor
      in (0.3000): broken (0.1667)
      out (0.7000): sound (0.3571)
    """
    check_problem(problem)
    expect(sensors, Mapping, "a mapping from values of the parameter to sensors", "sensors")
    values = Labels(sensors, "value")
    first = sensors[values.all[0]]
    for value, sensor in sensors.items():
        expect(sensor, Sensor, "a Sensor", f"sensor for {named(value)}")
        same = sensor.readings == first.readings and sensor.cost == first.cost
        if not same or sensor.states != problem.states:
            raise ShapeMismatchError(
                "other readings, costs or states than the first; accepted: sensors of the same "
                "readings and cost, of the states of the problem in its order",
                where=f"sensor for {named(value)}",
            )
    shares = _weights(values, weights, problem)
    states = [(value, state) for value in values for state in problem.states]
    tables = {}
    for action in problem.actions:
        rows = []
        for value in values:
            for row in problem.matrix(action):
                targets = zip(problem.states, row, strict=True)
                rows.append({(value, state): p for state, p in targets if p})
        tables[action] = rows
    return CalibrationProblem(
        PlanningProblem(
            states, [shares[v] * p for v in values for p in problem.prior], problem.actions, tables
        ),
        Sensor(
            first.readings,
            [row for value in values for row in sensors[value].likelihood],
            states=states,
            cost=first.cost,
            name=first.name,
            row_error=max(sensor.row_error for sensor in sensors.values()),
        ),
        values.all,
    )


def _weights(
    values: Labels, weights: Mapping[Hashable, Any] | None, problem: PlanningProblem
) -> dict[Any, Any]:
    """Return the prior of the values, in the problem's numbers."""
    if weights is not None:
        expect(weights, Mapping, "a mapping from values to numbers", "weights")
    given = {value: f"1/{len(values)}" for value in values} if weights is None else dict(weights)
    for value in given:
        values.number(value, where="weights")
    listed = [given.get(value, 0) for value in values]
    if weights is None and not problem.exact:
        listed = [1.0 / len(values)] * len(values)
    entries = list(numbered(listed, "weights"))
    kind = common_kind(entries)
    return {
        value: read_number(number, kind, where)
        for value, (number, where) in zip(values, entries, strict=True)
    }


def expected_entropy(tree: PlanTree, group: Callable[[Any], Hashable] | None = None) -> Any:
    """Return the mean Shannon entropy of the hyperstates a plan ends in, in bits (7.3).

    Parameters
    ----------
    tree : PlanTree
        The plan.
    group : callable, optional
        ``group(state)`` is what of the state one wants to know; default: all of it.

    Returns
    -------
    LogSum, Enclosed or float
        Exact for rational numbers, certified for angle sums; no more than the entropy before the
        plan where the plan only reads.

    Examples
    --------
    >>> from stochgeom.sensing.planners import iterative_sensor_plan
    >>> coin = PlanningProblem.from_matrices(["1/2", "1/2"], [[[1, 0], [0, 1]]])
    >>> plan = iterative_sensor_plan(coin, Sensor.noisy(coin.states, "1/4"), 1)
    >>> expected_entropy(plan.tree).decimal(4)
    '0.8113'
    """
    expect(tree, PlanTree, "the tree of a plan, such as sensor_plan(...).tree")
    if group is not None:
        expect(group, Callable, "a function of a state", "group")
    shares, masses = [], []
    for leaf in tree.leaves():
        gathered: dict[Hashable, Any] = {}
        for state, weight in zip(tree.states, leaf.weights, strict=True):
            key = state if group is None else group(state)
            gathered[key] = gathered[key] + weight if key in gathered else weight
        shares += list(gathered.values())
        masses.append(sum(leaf.weights[1:], start=leaf.weights[0]))
    # Of joint probabilities w and their sum m: m H(w / m) = - sum w log w + m log m.
    minus = entropy_of(masses)
    return entropy_of(shares) + (-minus if isinstance(minus, float) else minus.scaled(-1))
