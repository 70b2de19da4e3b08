"""What ``stochgeom sense`` prints for people."""

from __future__ import annotations

from stochgeom.cli.layout import count, table
from stochgeom.exact.quotients import number_decimal
from stochgeom.exact.scalars import rational_text
from stochgeom.sensing.diameter_sensor import root_text
from stochgeom.sensing.sensing_problem import OrderComparison, SensingProblem
from stochgeom.sensing.sensor_plan import SensorPlan

_NOTE = """\
Orientations and turns are degrees counter-clockwise; costs are in units of one squeeze. Half a turn
apart a part looks the same to gripper and sensor, so no round succeeds with more than 0.5 under a
uniform prior."""

MOST_LINES = 60
"""Lines of a tree or a table that are printed."""

MOST_COLUMNS = 8
"""Readings whose likelihoods are printed; the JSON document has all."""


def sense_text(
    problem: SensingProblem,
    plan: SensorPlan,
    orders: OrderComparison | None,
    horizon: int,
    digits: int,
) -> str:
    """Return the sensor, the plan that looks once, the best plan, and the comparison of orders."""
    blocks = [
        _heading(problem),
        _states(problem, digits),
        _one_step(problem, digits),
        _plan(plan, horizon, digits),
    ]
    if orders is not None:
        blocks.append(_orders(orders, digits))
    blocks.append(_NOTE)
    return "\n\n".join(blocks)


def _heading(problem: SensingProblem) -> str:
    name = problem.part.name or "part"
    states = len(problem.states)
    text = [f"{name}: {count(states, 'stable orientation')} in a full turn"]
    if problem.bits is None:
        text.append("sensor: reads the distance between the closed jaws exactly")
        return "\n".join(text)
    low, high = problem.covered.low, problem.covered.high
    noise = "no noise"
    if problem.deviation:
        noise = f"normal noise of standard deviation {rational_text(problem.deviation)}"
    text.append(
        f"sensor: {count(problem.bits, 'bit')} of the distance between the closed jaws, "
        f"from {rational_text(low)} to {rational_text(high)}; {noise}"
    )
    return "\n".join(text)


def _states(problem: SensingProblem, digits: int) -> str:
    readings = problem.sensor.readings
    shown = readings if len(readings) <= MOST_COLUMNS else ()
    rows = [
        [
            str(state),
            root_text(problem.squared_diameters[state], digits),
            number_decimal(share, digits),
            *(number_decimal(p, digits) for p in row[: len(shown)]),
        ]
        for state, share, row in zip(
            problem.states,
            problem.orienting.problem.prior,
            problem.sensor.likelihood,
            strict=True,
        )
    ]
    title = "Orientations after the random first squeeze, and what the sensor reads there"
    if not shown:
        title += f" ({len(readings)} readings: see --json)"
    return f"{title}\n{table(['orientation', 'diameter', 'prior', *shown], rows)}"


def _one_step(problem: SensingProblem, digits: int) -> str:
    plan = problem.one_step
    rows = [
        [
            str(d.reading),
            number_decimal(d.marginal, digits),
            str(d.state),
            number_decimal(d.probability, digits),
        ]
        for d in plan.decisions
    ]
    shown = table(["reading", "probability", "accept", "right with"], rows, left=[0])
    cost = number_decimal(plan.expected_cost, digits)
    round_cost = rational_text(plan.round_cost)
    success = number_decimal(plan.success, digits)
    return (
        "Squeeze, look once, accept\n"
        + "\n".join(_cut(shown.splitlines()))
        + f"\n  expected cost {cost}: a round costs {round_cost} and succeeds with {success}. "
        f"Eq. 7.5 of\n  the source, where a part keeps its reading over all rounds: "
        f"{number_decimal(plan.printed_cost, digits)}."
    )


def _cut(lines: list[str]) -> list[str]:
    """Return lines, of many the first ones and how many more there are."""
    if len(lines) <= MOST_LINES:
        return lines
    return [*lines[:MOST_LINES], f"  ... and {len(lines) - MOST_LINES} lines more: see --json"]


def _plan(plan: SensorPlan, horizon: int, digits: int) -> str:
    cost = plan.decimal(digits)
    cost_of_round = number_decimal(plan.cost_of_round, digits)
    success = number_decimal(plan.success, digits)
    lines = [
        f"Best plan of at most {count(horizon, 'move')} after the first squeeze",
        *_cut([f"  {line}" for line in plan.tree.text(digits).splitlines()]),
        f"  expected cost {cost}: a round costs {cost_of_round} and succeeds with {success}.",
    ]
    if not plan.proven:
        bound = number_decimal(plan.lower_bound, digits)
        lines.append(
            f"  Not proven optimal: the search was cut short. No plan costs below {bound}."
        )
    return "\n".join(lines)


def _orders(orders: OrderComparison, digits: int) -> str:
    squeezes = f", up to {count(orders.actions, 'squeeze')}"
    moves = f"up to {count(orders.actions + 1, 'move')} of any kind"
    rows = [
        (f"first squeeze{squeezes}, no look", orders.blind),
        (f"first squeeze, a look{squeezes}", orders.sense_then_act),
        (f"first squeeze{squeezes}, a look", orders.act_then_sense),
        (f"first squeeze, {moves}", orders.mixed),
    ]
    if not orders.actions:
        rows = [("first squeeze, no look", orders.blind), ("first squeeze, a look", orders.mixed)]
    lines = [[text, plan.decimal(digits) + " *" * (not plan.proven)] for text, plan in rows]
    title = "Look first or squeeze first?" if orders.actions else "With and without a look"
    note = "\n  * not proven to be the least" if any("*" in cost for _, cost in lines) else ""
    return f"{title}\n{table(['plan', 'expected cost'], lines, left=[0])}{note}"
