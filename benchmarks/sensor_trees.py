"""The best plan with a noisy jaw sensor: an exact AND/OR tree of 3 moves, beside naive recursion.

The 4gon: 8 orientations over a full turn, 16 classes of squeezes, a sensor of 2 bits whose noise is
a fifth of its range, so that every reading is possible everywhere. A tree of all plans of h moves
has 20^h ways and more; Dinkelbach's iteration goes through it a few times. Expected: time in
proportion to 20^h in the worst case, and less where bounds and equal hyperstates cut. Target: 10 s
for 3 moves, exact.

Beside it the recursion written down as it stands in a few lines, on fractions, at one price: no
bounds, no merging, nothing kept. The library goes through the tree several times (prices from both
sides, for irrational probabilities). Floats take the same road as exact numbers.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import partial
from typing import Any

from benchmarks.harness import Clock, measure_rounds
from benchmarks.report import Report
from stochgeom import (
    FULL_TURN,
    Angle,
    SensingProblem,
    Sensor,
    StepFunction,
    catalogue_part,
    iterative_sensor_plan,
)
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.feeding.action_classes import action_classes

TARGET = 10.0
BITS, NOISE = 2, "0.2"


def problems() -> tuple[PlanningProblem, Sensor]:
    """Return the 4gon's problem with all 16 classes of squeezes, and its sensor."""
    sensing = SensingProblem(catalogue_part("4gon"), BITS, NOISE)
    merged, transfer = sensing.orienting.problem, sensing.orienting.transfer
    order = [
        next(k for k, theta in enumerate(_angles(transfer)) if theta == sensing.states[state])
        for state in merged.states
    ]
    place = {k: j for j, k in enumerate(order)}
    tables = {}
    for each in action_classes(transfer):
        targets = each.targets_on(transfer.order)
        tables[each.number] = [
            [int(j == place[targets[k]]) for j in range(len(order))] for k in order
        ]
    problem = PlanningProblem(merged.states, merged.prior, tables, tables)
    return problem, sensing.sensor


def _angles(transfer: StepFunction) -> list[Angle]:
    return [
        (value + transfer.period * lap) % FULL_TURN
        for lap in range(transfer.order)
        for value in transfer.values
    ]


def naive(problem: PlanningProblem, sensor: Sensor, price: Fraction, moves: int) -> Fraction:
    """Return the least cost - price * success by plain recursion."""
    tables = [
        [[Fraction(p) for p in row] for row in problem.matrix(action)] for action in problem.actions
    ]
    columns = [[Fraction(p) for p in column] for column in sensor.columns]

    def least(weights: list[Fraction], left: int) -> Fraction:
        best = -price * max(weights)
        if not left:
            return best
        mass = sum(weights)
        for table in tables:
            after = [
                sum((w * row[k] for w, row in zip(weights, table, strict=True)), start=Fraction())
                for k in range(len(weights))
            ]
            best = min(best, mass + least(after, left - 1))
        looks = (
            least([w * p for w, p in zip(weights, column, strict=True)], left - 1)
            for column in columns
        )
        return min(best, sum(looks, start=Fraction()))

    return least([Fraction(p) for p in problem.prior], moves)


def run(*, quick: bool = False) -> Report:
    report = Report("sensor_trees", "plans with a 2-bit jaw sensor for the 4gon")
    problem, sensor = problems()
    near = [Fraction(p.decimal(12)) for p in problem.prior]
    near[0] += 1 - sum(near)
    tables = {action: problem.matrix(action) for action in problem.actions}
    rational = PlanningProblem(problem.states, near, problem.actions, tables)
    kinds = {
        "exact, prior of angle sums": (problem, sensor),
        "exact, rational prior": (rational, sensor),
        "float": (problem.to_float(), sensor.to_float()),
    }
    for moves in (2,) if quick else (2, 3):
        report.section(f"{moves} moves")
        found: dict[str, Any] = {}

        def once(clock: Clock, moves: int = moves, found: dict[str, Any] = found) -> None:
            for label, (task, eye) in kinds.items():
                found[label] = clock.time(label, _planner(task, eye, moves))

        samples = measure_rounds(once, 1 if quick else 3)
        for label in kinds:
            target = TARGET if moves == 3 and label.startswith("exact") else None
            report.time(label, samples[label], target)
        price = Fraction(found["exact, rational prior"].expected_cost)
        clock = Clock()
        value = clock.time("naive", partial(naive, rational, sensor, price, moves))
        report.figure("naive recursion at one price", clock.seconds["naive"], "s")
        report.figure("  its value at the library's cost, plus that of a round", float(value + 2))
        plan = found["exact, prior of angle sums"]
        report.figure("expected cost", float(plan.expected_cost))
    return report


def _planner(problem: PlanningProblem, sensor: Sensor, moves: int) -> Callable[[], object]:
    cost = 2 if problem.exact else 2.0
    return lambda: iterative_sensor_plan(problem, sensor, moves, round_cost=cost)
