"""Choosing sensors by what the best plans with them cost (thesis 7.2.7).

Sensors are compared by the expected cost of the best plan with each: which of two, how many bits,
which place for one. Two sensors read in sequence are one sensor of pairs (`fuse_sensors`).

Where a sensor can be moved while a plan is carried out, each place is a sensor of its own in
`iterative_sensor_plan` or `sensor_plan`, its cost with the move included; the plan then says where
to look.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cmp_to_key
from itertools import product
from typing import Any, final

from stochgeom.arguments import as_count, expect
from stochgeom.decision.labels import Labels
from stochgeom.decision.plan_results import check_problem
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.errors import MixedNumbersError, ShapeMismatchError
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.geometry.part import PartLike
from stochgeom.sensing.planners import iterative_sensor_plan
from stochgeom.sensing.sensing_problem import SensingProblem
from stochgeom.sensing.sensor_plan import SensorPlan
from stochgeom.sensing.sensors import Sensor


@final
@dataclass(frozen=True)
class RankedSensor:
    """A sensor and the best plan with it.

    Attributes
    ----------
    label : label
        Its name, its number of bits, its place.
    sensor : Sensor
        The sensor.
    plan : SensorPlan
        The best plan that may look at it.
    """

    label: Any
    sensor: Sensor
    plan: SensorPlan


def compare_sensors(
    problem: PlanningProblem,
    sensors: Mapping[Any, Sensor],
    horizon: int,
    *,
    planner: Callable[..., SensorPlan] = iterative_sensor_plan,
    **settings: Any,
) -> tuple[RankedSensor, ...]:
    """Return sensors by the cost of the best plan with each, cheapest first.

    Parameters
    ----------
    problem : PlanningProblem
        What the plans are for.
    sensors : mapping from labels to Sensor
        One of them is to be chosen; what each costs to read is the sensor's ``cost``.
    horizon : int
        Most moves of a plan.
    planner : callable, default `iterative_sensor_plan`
        Or `sensor_plan`.
    **settings
        More for the planner.

    Returns
    -------
    tuple of RankedSensor
        Equal costs in the order given.

    Examples
    --------
    A sensor that is right nine times in ten, or one that never errs but sees one state only? That
    depends on what a look costs:

    >>> problem = PlanningProblem(
    ...     range(3), ["1/3"] * 3, ["wait"], [[[1, 0, 0], [0, 1, 0], [0, 0, 1]]])
    >>> rough = Sensor.noisy(range(3), "1/10", cost="1/4")
    >>> narrow = Sensor.from_function(range(3), lambda state: state == 0)
    >>> for best in compare_sensors(problem, {"rough": rough, "narrow": narrow}, 1):
    ...     print(best.label, best.plan.expected_cost)
    rough 25/18
    narrow 3/2
    """
    expect(sensors, Mapping, "a mapping from labels to sensors", "sensors")
    found = [
        RankedSensor(
            label, sensors[label], planner(problem, {label: sensors[label]}, horizon, **settings)
        )
        for label in Labels(sensors, "sensor")
    ]
    return _ranked(found)


def place_sensor(
    problem: PlanningProblem,
    see: Callable[[Any, Any], Any],
    places: Mapping[Any, RationalLike],
    horizon: int,
    **settings: Any,
) -> tuple[RankedSensor, ...]:
    """Return the places for a sensor, best one first.

    Parameters
    ----------
    problem : PlanningProblem
        What the plans are for.
    see : callable
        ``see(place, state)`` is what a sensor there reads: a reading, or a mapping from readings
        to probabilities.
    places : mapping from places to rationals
        Where the sensor can stand, and what a look costs there.
    horizon : int
        Most moves of a plan.
    **settings
        More for `compare_sensors`.

    Examples
    --------
    A light barrier on a belt tells whether the part has passed it. Where should it stand?

    >>> belt = PlanningProblem(
    ...     range(4), ["1/8", "1/8", "1/4", "1/2"], ["wait"],
    ...     [[[int(j == k) for j in range(4)] for k in range(4)]])
    >>> found = place_sensor(belt, lambda place, state: state >= place, {1: 0, 2: 0, 3: 0}, 1)
    >>> [(best.label, str(best.plan.expected_cost)) for best in found]
    [(3, '4/3'), (1, '8/5'), (2, '8/5')]
    """
    check_problem(problem)
    expect(places, Mapping, "a mapping from places to costs", "places")
    expect(see, Callable, "a function of a place and a state", "see")
    sensors = {}
    for place, cost in places.items():
        rows = {
            state: seen if isinstance(seen := see(place, state), Mapping) else {seen: 1}
            for state in problem.states
        }
        readings = list(dict.fromkeys(reading for row in rows.values() for reading in row))
        sensors[place] = Sensor(
            readings,
            {state: [row.get(x, 0) for x in readings] for state, row in rows.items()},
            cost=cost,
            name=str(place),
        )
    return compare_sensors(problem, sensors, horizon, **settings)


def choose_bits(
    part: PartLike,
    most: int,
    noise: RationalLike = 0,
    horizon: int = 1,
    *,
    cost_per_bit: RationalLike = 0,
    **settings: Any,
) -> tuple[RankedSensor, ...]:
    """Return the numbers of bits of a jaw-diameter sensor, from 0 on, best one first.

    Parameters
    ----------
    part : Part, or its vertices
        What is oriented.
    most : int
        Most bits.
    noise : rational, default 0
        Standard deviation as a share of the sensor's range.
    horizon : int, default 1
        Most moves after the first squeeze.
    cost_per_bit : rational, default 0
        What a look costs, for each bit.
    **settings
        More for `SensingProblem`.

    Examples
    --------
    Four bits tell this part's four grasps apart; three do no better than two:

    >>> part = [(52, 58), (0, 55), (8, 17), (51, 0)]
    >>> for best in choose_bits(part, 6, cost_per_bit="1/4"):
    ...     print(best.label, best.plan.decimal(2))
    4 6.00
    2 6.41
    5 6.50
    6 7.00
    3 7.06
    1 8.59
    0 11.98
    """
    found = []
    for bits in range(as_count(most, "bits", least=0, where="most") + 1):
        cost = rational(cost_per_bit, where="cost of a bit") * bits
        problem = SensingProblem(part, bits, noise, sensor_cost=cost, **settings)
        found.append(RankedSensor(bits, problem.sensor, problem.plan(horizon)))
    return _ranked(found)


def _ranked(found: list[RankedSensor]) -> tuple[RankedSensor, ...]:
    def compare(first: RankedSensor, second: RankedSensor) -> int:
        a, b = first.plan.expected_cost, second.plan.expected_cost
        return -1 if a < b else int(b < a)

    return tuple(sorted(found, key=cmp_to_key(compare)))


def fuse_sensors(first: Sensor, second: Sensor, *, name: str | None = None) -> Sensor:
    """Return the sensor that reads one sensor and then another (sensor fusion).

    Given the state their readings are independent. A reading is a pair, the cost the sum of both;
    pairs that never occur are left out.

    Raises
    ------
    ShapeMismatchError
        If they are not sensors of the same states.
    MixedNumbersError
        If one is exact and the other is not.

    Examples
    --------
    >>> row = Sensor.from_function(range(4), lambda k: k // 2)
    >>> column = Sensor.from_function(range(4), lambda k: k % 2)
    >>> fuse_sensors(row, column).blocks
    {(0, 0): (0,), (0, 1): (1,), (1, 0): (2,), (1, 1): (3,)}
    """
    for sensor in (first, second):
        expect(sensor, Sensor, "a Sensor, such as Sensor.noisy(states, '1/10')")
    if first.states != second.states:
        raise ShapeMismatchError(
            f"sensors of the states {first.states!r:.60} and {second.states!r:.60}; "
            "accepted: sensors of the same states"
        )
    if first.exact != second.exact:
        raise MixedNumbersError("an exact and a float sensor; accepted: one kind")
    table = [
        [p * q for p, q in product(mine, theirs)]
        for mine, theirs in zip(first.likelihood, second.likelihood, strict=True)
    ]
    readings = list(product(first.readings, second.readings))
    possible = [k for k in range(len(readings)) if any(row[k] for row in table)]
    return Sensor(
        [readings[k] for k in possible],
        [[row[k] for k in possible] for row in table],
        states=first.states,
        cost=first.cost + second.cost,
        name=name,
        row_error=first.row_error + second.row_error,
    )
