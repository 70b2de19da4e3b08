"""Decision problems and plans with sensors as short pieces of HTML."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from stochgeom.decision.decision_rules import DecisionProblem
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.exact.quotients import number_decimal
from stochgeom.plotting.hyperstate_trees import open_loop_scene
from stochgeom.plotting.part_scenes import part_scene
from stochgeom.plotting.rich_html import MOST_ROWS, counted, table_html
from stochgeom.plotting.scene import shortened
from stochgeom.plotting.svg import svg_document, text_of
from stochgeom.plotting.tree_scenes import tree_scene
from stochgeom.sensing.recognition import RecognitionProblem
from stochgeom.sensing.sensing_problem import SensingProblem
from stochgeom.sensing.sensor_plan import SensorPlan
from stochgeom.sensing.sensors import Sensor

_MOST_COLUMNS: Final = 10
_MOST_LETTERS: Final = 24
_MOST_STATES: Final = 40
_MOST_NODES: Final = 60
"""A larger tree is no small picture: it is told in numbers."""


def planning_problem_html(problem: PlanningProblem) -> str:
    """Return what each action makes of the prior as a picture, over the prior as a table."""
    states, actions = len(problem.states), len(problem.actions)
    name = problem.name or "planning problem"
    summary = f"{name}: {counted(states, 'state')}, {counted(actions, 'action')}"
    if problem.cost is not None:
        summary += f", {problem.cost.describe()}"
    picture = ""
    if actions <= MOST_ROWS and states <= _MOST_STATES:
        scene = open_loop_scene(problem.with_cost(None), 1)
        picture = svg_document(scene, title=summary, scale=1.0) + "\n"
    rows = [
        [_short(state), number_decimal(share)]
        for state, share in zip(problem.states, map(_plain, problem.prior), strict=True)
    ]
    table = table_html(["state", "prior probability"], _cut(rows))
    return f"<p>{text_of(summary)}</p>\n{picture}{table}"


def decision_problem_html(problem: DecisionProblem) -> str:
    """Return the likelihoods and the losses as one table, a row for each state."""
    counts = (
        counted(len(problem.states), "state"),
        counted(len(problem.readings), "reading"),
        counted(len(problem.actions), "action"),
    )
    readings, actions = problem.readings[:_MOST_COLUMNS], problem.actions[:_MOST_COLUMNS]
    header = [
        "state",
        *(f"P({_short(reading)} | state)" for reading in readings),
        *(f"loss of {_short(action)}" for action in actions),
    ]
    rows = [
        [_short(state), *map(number_decimal, (*chances[:_MOST_COLUMNS], *losses[:_MOST_COLUMNS]))]
        for state, chances, losses in zip(
            problem.states, problem.likelihood, problem.loss, strict=True
        )
    ]
    summary = f"decision problem: {', '.join(counts)}"
    return f"<p>{text_of(summary)}</p>\n{table_html(header, _cut(rows))}"


def sensing_problem_html(problem: SensingProblem) -> str:
    """Return a picture of the part over its orientations and what the sensor reads in them."""
    found = problem.orienting.problem
    name = problem.part.name or "part"
    summary = f"{name}: {_told(found, problem.sensor)}"
    picture = svg_document(part_scene(problem.part), title=name, scale=60.0)
    names = [f"{state}°" for state in found.states]
    table = _sensor_table(["orientation"], [[name] for name in names], found, problem.sensor)
    return f"<p>{text_of(summary)}</p>\n{picture}\n{table}"


def recognition_problem_html(problem: RecognitionProblem) -> str:
    """Return the parts with their orientations and what the sensor reads in them."""
    found = problem.problem
    summary = f"{counted(len(problem.names), 'part')}: {_told(found, problem.sensor)}"
    names = [[_short(part), f"{theta}°"] for part, theta in found.states]
    table = _sensor_table(["part", "orientation"], names, found, problem.sensor)
    return f"<p>{text_of(summary)}</p>\n{table}"


def _told(problem: PlanningProblem, sensor: Sensor) -> str:
    return (
        f"{counted(len(problem.states), 'orientation')}, "
        f"{counted(len(problem.actions), 'squeeze')}, "
        f"a sensor of {counted(len(sensor.readings), 'reading')}"
    )


def _sensor_table(
    header: list[str], names: list[list[str]], problem: PlanningProblem, sensor: Sensor
) -> str:
    """Return a row for each state: its prior probability and the reading that is likeliest."""
    rows = []
    for name, state, share in zip(names, problem.states, problem.prior, strict=True):
        chances = [sensor.probability(reading, state) for reading in sensor.readings]
        best = max(range(len(chances)), key=lambda k: (chances[k], -k))
        reading = f"{_short(sensor.readings[best])} ({number_decimal(chances[best])})"
        rows.append([*name, number_decimal(_plain(share)), reading])
    columns = [*header, "probability", "likeliest reading (probability)"]
    return table_html(columns, _cut(rows))


def sensor_plan_html(plan: SensorPlan) -> str:
    """Return a plan with sensors as a tree, its cost above it."""
    proven = "" if plan.proven else ", not proven optimal"
    summary = f"expected cost {number_decimal(plan.expected_cost)}{proven}"
    nodes = sum(1 for _ in plan.tree.nodes())
    if nodes > _MOST_NODES:
        return f"<p>{text_of(f'{summary}; {plan.tree!r}')}</p>"
    picture = svg_document(tree_scene(plan.tree), title=summary, scale=1.0)
    return f"<p>{text_of(summary)}</p>\n{picture}"


def _short(label: Any) -> str:
    return shortened(str(label), _MOST_LETTERS)


def _plain(share: Any) -> Any:
    """Return a number of numpy as Python's own."""
    return share.item() if hasattr(share, "item") else share


def _cut(rows: Sequence[list[str]]) -> list[list[str]]:
    if len(rows) <= MOST_ROWS:
        return list(rows)
    more = ["…", f"{len(rows) - MOST_ROWS} more"]
    return [*rows[:MOST_ROWS], more + [""] * (len(rows[0]) - 2)]
