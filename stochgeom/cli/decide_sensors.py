"""``stochgeom decide`` for problems with sensors: the best plan is a tree."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from stochgeom.cli.layout import count
from stochgeom.cli.output import write, write_json
from stochgeom.cli.progress import Progress
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.errors import InputError
from stochgeom.exact.quotients import number_decimal
from stochgeom.io.sensing_json import sensor_json, sensor_plan_json
from stochgeom.sensing.planners import plan_for_cost
from stochgeom.sensing.sensor_plan import SensorPlan
from stochgeom.sensing.sensors import Sensor


def decide_with_sensors(
    problem: PlanningProblem,
    sensors: Mapping[str, Sensor],
    horizon: int | None,
    *,
    digits: int,
    as_json: bool,
    node_limit: int,
    time_limit: float | None,
) -> int:
    """Search, print, return the exit code.

    Raises
    ------
    InputError
        If there is no horizon: trees have to end somewhere.
    """
    if horizon is None:
        raise InputError(
            "missing; a problem with sensors needs one, actions and looks together",
            where="--horizon",
        )
    with Progress("searching trees, first moves done") as progress:
        plan = plan_for_cost(
            problem,
            sensors,
            horizon,
            node_limit=node_limit,
            time_limit=time_limit,
            progress=progress.show,
        )
    if as_json:
        document: dict[str, Any] = {
            "schema": "stochgeom/decision-tree/1",
            "name": problem.name,
            "horizon": horizon,
            "sensors": {name: sensor_json(sensor) for name, sensor in sensors.items()},
            "plan": sensor_plan_json(plan, digits),
        }
        write_json(document)
    else:
        write(_text(problem, sensors, plan, horizon, digits))
    return 0


def _text(
    problem: PlanningProblem,
    sensors: Mapping[str, Sensor],
    plan: SensorPlan,
    horizon: int,
    digits: int,
) -> str:
    name = "" if problem.name is None else f"{problem.name}: "
    size = ", ".join(
        [
            count(len(problem.states), "state"),
            count(len(problem.actions), "action"),
            count(len(sensors), "sensor"),
        ]
    )
    described = "" if problem.cost is None else problem.cost.describe()
    title = "Optimal plan" if plan.proven else "Best plan found"
    lines = [
        f"{name}{size}, {'exact' if problem.exact else 'float'} numbers",
        f"cost: {described}",
        "",
        f"{title} of at most {count(horizon, 'move')}, looks included",
        *(f"  {line}" for line in plan.tree.text(digits).splitlines()),
        "",
        f"cost {plan.decimal(digits)}",
    ]
    if plan.round_cost is not None:
        lines.append(
            f"a round costs {number_decimal(plan.cost_of_round, digits)} and succeeds with "
            f"probability {number_decimal(plan.success, digits)}"
        )
    if not plan.proven:
        bound = number_decimal(plan.lower_bound, digits)
        lines.append(f"NOT proven optimal: time was over; no plan costs less than {bound}.")
    return "\n".join(lines)
