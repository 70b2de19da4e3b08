"""Planning problems: all plans to a horizon, exact and in floats, and what pruning saves.

12 states, 12 actions, dense random matrices, in floats all plans to horizon 5 (271,452) at once on
arrays and, for comparison, one by one on numpy vectors; exact, with denominators of 16 bits, all
plans to horizon 3 (1,884). Then the same exact problem by best-first branch and bound and breadth
first; a problem whose matrices are sparse, where bounds and merging tell; and parts.

Expected: exhaustive search grows with the number of plans, that is 12-fold with each action more;
branch and bound makes a part of the nodes, which depends on the cost. Exact rational numbers grow
with the depth: each action multiplies the denominators.
"""

from __future__ import annotations

from time import perf_counter

import numpy as np
from gmpy2 import mpq

from benchmarks.report import Report
from stochgeom.decision.additive_costs import AdditiveCost
from stochgeom.decision.exhaustive_plans import count_plans, every_plan
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.plan_search import find_plan
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.feeding.planning_problems import planning_problem_of
from stochgeom.thesis.parts import catalogue_part

SEED = 1990
SIZE = 12
FLOAT_TARGET = 1.0
EXACT_TARGET = 1.0


def dense_problem(size: int = SIZE, seed: int = SEED) -> PlanningProblem:
    """Return an exact problem with random matrices, the same for the same numbers."""
    source = np.random.default_rng(seed)
    counts = source.integers(1, 1 << 12, (size, size, size))
    labels = [str(k) for k in range(size)]
    tables = [[[mpq(int(n), int(row.sum())) for n in row] for row in table] for table in counts]
    costs = {label: int(n) for label, n in zip(labels, source.integers(0, 100, size), strict=True)}
    return PlanningProblem(
        labels, [mpq(1, size)] * size, labels, tables, AdditiveCost(mpq(1, 8), costs)
    )


def as_floats(problem: PlanningProblem) -> PlanningProblem:
    """Return the problem and its cost in floats."""
    cost = problem.cost
    assert isinstance(cost, AdditiveCost)
    return problem.to_float().with_cost(AdditiveCost(float(cost.actions), cost.states))


def slipping_ring() -> PlanningProblem:
    """Return a problem of 12 places on a ring, to be left for the opposite one; moves may fail."""
    ring = [str(k) for k in range(SIZE)]
    steps = {"back": -1, "on": 1, "far": 3}

    def move(place: str, action: str) -> dict[str, mpq]:
        to = ring[(int(place) + steps[action]) % SIZE]
        return {to: mpq(9, 10), place: mpq(1, 10)}

    cost = AdditiveCost(mpq(1, 20), {place: 1 for place in ring if place != "6"})
    return PlanningProblem.from_function(ring, {"0": 1}, list(steps), move, cost)


def one_by_one(problem: PlanningProblem, horizon: int) -> float:
    """Return the least cost by plain numpy vectors, a plan at a time: the naive road."""
    model = problem.cost.on(problem)
    costs = np.array(model.state_costs)
    return min(
        len(plan) * model.prices[0] + float(hyperstate @ costs)
        for plan, hyperstate in every_plan(problem, horizon)
    )


def run(*, quick: bool = False) -> Report:
    report = Report("decision", "plans of planning problems, 12 states and 12 actions")
    exact = dense_problem()
    floats = as_floats(exact)
    horizon = 3 if quick else 5
    report.section(f"floats, horizon {horizon}: {count_plans(SIZE, horizon)} plans")
    fast = _timed(lambda: find_plan(floats, horizon, method="exhaustive"))
    target = None if quick else FLOAT_TARGET
    report.figure("on arrays, all actions at once", fast[0], "s", target)
    slow = _timed(lambda: one_by_one(floats, horizon))
    report.figure("one by one", slow[0], "s")
    report.ratio("  ratio", slow[0] / fast[0])
    report.figure("largest difference of the least cost", abs(slow[1] - fast[1].cost), target=1e-9)
    depth = 2 if quick else 3
    report.section(f"exact, horizon {depth}: {count_plans(SIZE, depth)} plans")
    for method in ("exhaustive", "breadth-first", "best-first"):
        seconds, found = _timed(lambda method=method: find_plan(exact, depth, method=method))
        report.figure(method, seconds, "s", EXACT_TARGET)
        report.figure("  nodes", found.nodes)
    walk, reach = slipping_ring(), 4 if quick else 7
    report.section(f"a ring that slips, 3 actions, horizon {reach}: {count_plans(3, reach)} plans")
    for method in ("exhaustive", "breadth-first", "best-first"):
        seconds, found = _timed(lambda method=method: find_plan(walk, reach, method=method))
        report.figure(method, seconds, "s")
        report.figure("  nodes", found.nodes)
    report.section("parts: the plan of least expected cost, any length")
    for name in ("house", "4gon", "key"):
        part = planning_problem_of(catalogue_part(name), cost=IterativeCost(None, 1, 2)).problem
        seconds, found = _timed(lambda part=part: find_plan(part, shortest=0))
        report.figure(f"{name}: best-first", seconds, "s")
        report.figure("  nodes", found.nodes)
    return report


def _timed(action):
    start = perf_counter()
    result = action()
    return perf_counter() - start, result
