"""Planning problems: the five-tuple, its numbers, and what actions do to hyperstates."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.decision.goal_costs import GoalCost
from stochgeom.decision.number_kinds import NumberKind
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.exact.angles import Angle
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.sums import AngleSum

THIRD = mpq(1, 3)

COIN = PlanningProblem(
    ["heads", "tails"],
    ["2/3", "1/3"],
    ["turn", "throw"],
    {"turn": [[0, 1], [1, 0]], "throw": [["1/2", "0.5"], [Decimal("0.5"), Fraction(1, 2)]]},
)


def test_after_an_action():
    assert COIN.after(COIN.prior, "turn") == (THIRD, 2 * THIRD)
    assert COIN.run(["turn", "throw", "turn"]) == (mpq(1, 2), mpq(1, 2))
    assert COIN.run([]) == COIN.prior
    assert COIN.run(["turn"], (mpq(1), mpq(0))) == (0, 1)


def test_entries_are_transition_probabilities_from_row_to_column():
    # Worked by hand (Eq. 2.2): state 1 is reached from 0 with 1/4 and from 1 with 2/3.
    problem = PlanningProblem.from_matrices(
        ["1/2", "1/3", "1/6"], [[["1/4", "1/4", "1/2"], ["1/3", "2/3", 0], [0, 0, 1]]]
    )
    assert problem.after(problem.prior, "0") == (
        mpq(1, 2) * mpq(1, 4) + mpq(1, 3) * mpq(1, 3),
        mpq(1, 2) * mpq(1, 4) + mpq(1, 3) * mpq(2, 3),
        mpq(1, 2) * mpq(1, 2) + mpq(1, 6),
    )


def test_matrices_and_labels():
    assert COIN.matrix("turn") == ((0, 1), (1, 0))
    assert (COIN.states, COIN.actions) == (("heads", "tails"), ("turn", "throw"))
    assert (COIN.state_number("tails"), COIN.action_number("throw")) == (1, 1)
    assert COIN.exact
    assert not COIN.deterministic
    assert repr(COIN) == "<PlanningProblem: 2 states, 2 actions, rational numbers>"


def test_labels_may_be_any_hashable_values():
    problem = PlanningProblem([(0, 1), None], {None: 1}, [Angle()], [[[0, 1], [1, 0]]])
    assert problem.after(problem.prior, Angle()) == (1, 0)


def test_the_order_of_a_mapping_does_not_matter():
    tables = {"throw": [["1/2", "1/2"]] * 2, "turn": [{"tails": 1}, {"heads": 1}]}
    assert (
        PlanningProblem(COIN.states, {"heads": "2/3", "tails": "1/3"}, COIN.actions, tables) == COIN
    )


def test_from_a_function():
    problem = PlanningProblem.from_function(
        COIN.states,
        COIN.prior,
        COIN.actions,
        lambda state, action: (
            {"heads": "1/2", "tails": "1/2"}
            if action == "throw"
            else ("tails" if state == "heads" else "heads")
        ),
    )
    assert problem == COIN
    assert hash(problem) == hash(COIN)


def test_floats():
    problem = COIN.to_float()
    assert problem.numbers is NumberKind.FLOAT
    assert not problem.exact
    after = problem.after(problem.prior, "turn")
    assert isinstance(after, np.ndarray)
    assert after.tolist() == [1 / 3, 2 / 3]
    with pytest.raises(ValueError, match="read-only"):
        problem.prior[0] = 1


def test_whole_numbers_suit_floats():
    problem = PlanningProblem.from_matrices([1, 0], [[[0.1, 0.9], [0, 1]]])
    assert problem.numbers is NumberKind.FLOAT
    assert PlanningProblem.from_matrices(np.array([1, 0]), np.eye(2, dtype=int)[np.newaxis]).exact


def test_float_rows_may_be_off_by_their_rounding():
    tenth = [[0.1] * 10] * 10  # its sum is 0.9999999999999999
    assert PlanningProblem.from_matrices([0.1] * 10, [tenth]).numbers is NumberKind.FLOAT


def test_angle_sums():
    width = Angle(0, (3, 2))
    rest = AngleSum(1) - AngleSum(0, [(1, width)])
    problem = PlanningProblem.from_matrices(
        [TurnRatio(mpq(1), width), rest], [[["1/2", "1/2"], [0, 1]]]
    )
    assert problem.numbers is NumberKind.ANGLE_SUMS
    assert problem.exact
    after = problem.run(["0"])
    assert after == (AngleSum(0, [("1/2", width)]), AngleSum(1, [("-1/2", width)]))
    assert sum(after, start=mpq(0)) == 1


def test_an_angle_stands_for_its_number_of_turns():
    half = Angle.from_degrees(180)
    prior = PlanningProblem.from_matrices([half, half], [np.eye(2, dtype=int)]).prior
    assert [p.rational for p in prior] == [mpq(1, 2)] * 2


def test_vectors_are_checked_like_the_prior():
    assert COIN.vector({"tails": 1}) == (0, 1)
    assert COIN.vector(["1/4", "3/4"]) == (mpq(1, 4), mpq(3, 4))


def test_the_cost_belongs_to_the_problem():
    problem = COIN.with_cost(GoalCost("heads"))
    assert problem.cost == GoalCost("heads")
    assert problem != COIN
    assert problem.with_cost(None) == COIN
