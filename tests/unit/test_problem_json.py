"""Problems as JSON and as POMDP files: exact round trips, and a reader written apart."""

from __future__ import annotations

import json

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.additive_costs import AdditiveCost
from stochgeom.decision.circular_variance import VarianceCost
from stochgeom.decision.entropy import EntropyCost
from stochgeom.decision.goal_costs import GoalCost, GuaranteedCost
from stochgeom.decision.infinity import INFINITE
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.number_kinds import NumberKind
from stochgeom.decision.plan_search import find_plan
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.decision.worst_case_costs import MinimaxCost
from stochgeom.errors import ProblemError
from stochgeom.exact.angles import Angle
from stochgeom.feeding.planning_problems import planning_problem_of
from stochgeom.io.pomdp_file import write_pomdp
from stochgeom.io.problem_json import load_problem, parse_problem, problem_document
from stochgeom.thesis.parts import catalogue_part
from tests.strategies import problem_tables

TURN = PlanningProblem(["a", "b"], ["1/3", "2/3"], ["turn"], [[["1/10", "9/10"], [1, 0]]])
ENDS = {"a": Angle(), "b": Angle.from_degrees(71)}
COSTS = [
    AdditiveCost("1/2", {"a": INFINITE, "b": mpq(-2, 3)}),
    AdditiveCost({"turn": mpq(1, 7)}, 0),
    MinimaxCost(0, {"a": 1}),
    GoalCost(["a"], mpq(1, 8)),
    GuaranteedCost(["a", "b"]),
    IterativeCost(["b"], 1, mpq(3, 2)),
    IterativeCost(),
    EntropyCost(mpq(1, 9)),
    VarianceCost(ENDS, 0),
]


def round_trip(problem):
    return parse_problem(json.dumps(problem_document(problem)))


@pytest.mark.parametrize("cost", COSTS, ids=lambda cost: type(cost).__name__)
def test_costs_survive(cost):
    problem = TURN.with_cost(cost)
    again = round_trip(problem)
    assert type(again.cost) is type(cost)
    plans = [[], ["turn"], ["turn", "turn"]]
    for plan in plans:
        one, two = (p.cost.on(p).of_plan(plan) for p in (problem, again))
        assert one == two or one.compare(two) == 0
    assert round_trip(again) == again


@settings(max_examples=60)
@given(problem_tables(), st.booleans())
def test_problems_survive(tables, rounded):
    problem = PlanningProblem.from_matrices(*tables, name="some problem")
    problem = problem.to_float() if rounded else problem
    again = round_trip(problem)
    assert again.name == problem.name
    assert again.numbers is problem.numbers
    for action in problem.actions:
        assert [list(row) for row in again.matrix(action)] == [
            list(row) for row in problem.matrix(action)
        ]
    assert list(again.prior) == list(problem.prior)


def test_angle_sums_survive():
    problem = planning_problem_of(catalogue_part("4gon")).problem
    again = round_trip(problem)
    assert again.numbers is NumberKind.ANGLE_SUMS
    assert again == problem


def test_numbers_are_exact_unless_floats_are_asked_for():
    text = '{"states": ["a", "b"], "prior": [0.1, 0.9], "actions": ["x"], "transitions": \
{"x": {"a": {"b": 1}, "b": [0, 1]}}%s}'
    assert parse_problem(text % "").prior == (mpq(1, 10), mpq(9, 10))
    floats = parse_problem(text % ', "numbers": "float", "cost": {"kind": "goal", "goal": "b"}')
    assert floats.prior.tolist() == [0.1, 0.9]
    assert floats.cost.on(floats).of_plan(["x"]) == 0.0


def test_files_are_read(tmp_path):
    path = tmp_path / "turn.json"
    path.write_text("\ufeff" + json.dumps(problem_document(TURN)), encoding="utf-8")
    assert load_problem(str(path)) == TURN


def test_what_cannot_be_written():
    with pytest.raises(ProblemError, match="state: the label 0 is no text"):
        problem_document(PlanningProblem([0], [1], ["x"], [[[1]]]))

    class Other:
        def on(self, problem): ...
        def describe(self): ...

    with pytest.raises(ProblemError, match="has no document; accepted: additive, minimax"):
        problem_document(TURN.with_cost(Other()))


# --- Cassandra's format --------------------------------------------------------------------------


def read_pomdp(text):
    """Read the subset of the format that is written: header, matrices, costs."""
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    header, matrices, costs = {}, {}, {}
    rows = iter(lines)
    for line in rows:
        key, _, rest = line.partition(": ")
        if key == "T":
            count = len(header["states"].split())
            matrices[rest] = [list(map(float, next(rows).split())) for _ in range(count)]
        elif key == "R":
            action, start, end, tail = rest.split(" : ")
            costs[action, start, end] = float(tail.split()[1])
        else:
            header[key] = rest
    return header, matrices, costs


def least_cost(text, horizon):
    """Return the least cost of all sequences of so many actions, by the file alone."""
    header, matrices, costs = read_pomdp(text)
    states = header["states"].split()

    def best(belief, left):
        if not left:
            return 0.0
        values = []
        for action, matrix in matrices.items():
            steps = [
                (p * q, costs.get((action, s, t), costs["*", "*", "*"]), t)
                for p, s, row in zip(belief, states, matrix, strict=True)
                for q, t in zip(row, states, strict=True)
            ]
            after = [sum(share for share, _, end in steps if end == t) for t in states]
            now = sum(share * cost for share, cost, _ in steps)
            values.append(now + best(after, left - 1))
        return min(values)

    return best(list(map(float, header["start"].split())), horizon)


def test_the_file_by_hand():
    text = write_pomdp(TURN, AdditiveCost("1/20", {"a": 5, "b": 7}), discount="0.95")
    header, matrices, costs = read_pomdp(text)
    assert header["discount"] == "0.95"
    assert header["actions"].split() == ["turn", "stop"]
    assert matrices["turn"] == [[0.1, 0.9, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
    assert all(row == [0.0, 0.0, 1.0] for row in matrices["stop"])
    assert costs == {
        ("*", "*", "*"): 0.0,
        ("turn", "a", "a"): 0.05,
        ("turn", "a", "b"): 2.05,
        ("turn", "b", "a"): -1.95,
    }


@settings(max_examples=40)
@given(problem_tables(states=3, actions=2), st.data())
def test_the_file_has_the_least_cost_of_the_problem(tables, data):
    problem = PlanningProblem.from_matrices(*tables)
    costs = data.draw(st.lists(st.integers(-2, 3), min_size=4, max_size=4))
    cost = AdditiveCost(mpq(1, 8), dict(zip(problem.states, costs, strict=False)))
    text = write_pomdp(problem, cost)
    constant = float(text.splitlines()[0].rpartition(" ")[2])
    best = find_plan(problem, 3, cost, shortest=0).cost
    assert abs(least_cost(text, 3) + constant - float(best)) < 1e-12


def test_labels_that_are_no_words_are_replaced():
    problem = PlanningProblem(["0.5", "stopped"], [1, 0], ["reset"], [[[1, 0], [0, 1]]])
    text = write_pomdp(problem, GoalCost("0.5"))
    assert "\n# s0: 0.5\n# s1: stopped\n# a0: reset\n" in text
    assert "states: s0 s1 stopped\n" in text


def test_costs_that_the_format_cannot_hold():
    with pytest.raises(ProblemError, match="not additive or not finite"):
        write_pomdp(TURN, IterativeCost())
    with pytest.raises(ProblemError, match="not additive or not finite"):
        write_pomdp(TURN, GuaranteedCost("a"))
    with pytest.raises(ProblemError, match="discount 2; accepted"):
        write_pomdp(TURN, GoalCost("a"), discount=2)
