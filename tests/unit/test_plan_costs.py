"""Costs of plans, worked by hand."""

from __future__ import annotations

import cmath
import math

import pytest
from gmpy2 import mpq

from stochgeom.decision.additive_costs import AdditiveCost, distance_cost
from stochgeom.decision.circular_variance import VarianceCost, circular_variance
from stochgeom.decision.entropy import EntropyCost, entropy, information
from stochgeom.decision.goal_costs import GoalCost, GuaranteedCost
from stochgeom.decision.infinity import INFINITE
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.plan_search import find_plan
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.decision.rounds import Rounds
from stochgeom.decision.worst_case_costs import MinimaxCost
from stochgeom.errors import InputError
from stochgeom.exact.angles import Angle
from stochgeom.exact.independent_sums import LogSum, RootSum
from stochgeom.exact.sums import AngleSum
from stochgeom.feeding.planning_problems import planning_problem_of
from stochgeom.geometry.part import Part
from stochgeom.thesis.parts import catalogue_part

# Three bins; "push" moves a part one bin on, and fails one time in four.
PUSH = [["1/4", "3/4", 0], [0, "1/4", "3/4"], [0, 0, 1]]
BINS = PlanningProblem(
    ["a", "b", "c"], ["1/2", "1/2", 0], ["push", "wait"], [PUSH, [[1, 0, 0], [0, 1, 0], [0, 0, 1]]]
)
# After one push: 1/8, 1/2, 3/8; after two: 1/32, 7/32, 3/4.


def test_the_hyperstates_that_are_worked_with():
    assert BINS.run(["push"]) == (mpq(1, 8), mpq(1, 2), mpq(3, 8))
    assert BINS.run(["push", "push"]) == (mpq(1, 32), mpq(7, 32), mpq(3, 4))


def test_additive():
    model = AdditiveCost({"push": "1/10"}, {"a": 2, "b": 1}).on(BINS)
    assert model.of_plan(["push", "wait", "push"]) == mpq(2, 10) + mpq(2, 32) + mpq(7, 32)
    assert model.of_plan([]) == mpq(3, 2)


def test_goal():
    assert GoalCost("c").on(BINS).of_plan(["push", "push"]) == mpq(1, 4)
    assert GoalCost(["b", "c"], "1/8").on(BINS).of_plan(["push"]) == mpq(1, 8) + mpq(1, 8)


def test_zero_times_infinity_is_zero():
    model = GuaranteedCost(["b", "c"]).on(BINS)
    assert model.of_plan(["push"]) is INFINITE
    assert model.value(mpq(3), BINS.vector({"b": 1})) == 3
    assert AdditiveCost(states={"c": math.inf}).on(BINS).of_plan(["wait"]) == 0
    assert AdditiveCost(states={"c": math.inf}).on(BINS.to_float()).of_plan(["push"]) == math.inf


def test_minimax():
    model = MinimaxCost({"push": 1}, {"a": 5, "b": 4, "c": 1}).on(BINS)
    assert model.of_plan(["push"]) == 6  # it may fail
    assert model.value(0, BINS.vector({"b": "1/2", "c": "1/2"})) == 4


def test_iterative():
    model = IterativeCost("c", {"push": 1, "wait": "1/2"}, test=2).on(BINS)
    assert model.of_plan(["push", "push"]) == (2 + 2) / mpq(3, 4)
    assert model.of_plan(["wait"]) is INFINITE
    likely = IterativeCost(None, 1, 1).on(BINS)
    assert likely.of_plan(["push"]) == 2 / mpq(1, 2)
    assert likely.success(BINS.run(["push", "push"])) == mpq(3, 4)


def test_entropy():
    assert entropy([mpq(1, 2), mpq(1, 2)]) == 1
    assert entropy([mpq(1), mpq(0)]) == 0
    third = entropy([mpq(1, 3)] * 3)
    assert third == LogSum(0, [(1, 3)])
    assert third.decimal(10) == "1.5849625007"
    # Two distributions whose floats are the same: one part in 10^20 moved.
    near = [mpq(1, 3) + mpq(1, 10**20), mpq(1, 3) - mpq(1, 10**20), mpq(1, 3)]
    assert entropy(near) < third
    assert float(entropy(near)) == float(third)
    assert EntropyCost("1/8").on(BINS).of_plan(["wait"]) == mpq(9, 8)
    assert information([mpq(1, 4)] * 4, [mpq(1, 2), mpq(1, 2)]) == 1


def test_entropy_of_angle_sums():
    p = AngleSum(0, [(1, Angle(0, (3, 2)))])
    one, other = entropy([p, 1 - p]), entropy([1 - p, p])
    assert one.compare(other) == 0
    x = float(p)
    assert abs(float(one) + x * math.log2(x) + (1 - x) * math.log2(1 - x)) < 1e-15
    assert one.decimal(8) == f"{float(one):.8f}"


def test_circular_variance():
    right, up, left = Angle(), Angle.from_degrees(90), Angle.from_degrees(180)
    half = [mpq(1, 2), mpq(1, 2)]
    assert circular_variance([right, left], half) == 1
    assert circular_variance([right, up], half) == mpq(1, 2)
    assert circular_variance([right, right], half) == 0
    # 45 degrees apart: (1 - cos 45) / 2, exactly.
    assert circular_variance([right, Angle(0, (1, 1))], half) == RootSum("1/2", [("-1/4", 2)])
    # 30 degrees apart are no rational direction, and still exact: (1 - root 3 / 2) / 2.
    assert circular_variance([up, Angle.from_degrees(60)], half) == RootSum("1/2", [("-1/4", 3)])
    near = circular_variance([right, Angle.from_degrees("0.01")], half)
    assert near.decimal(12) == "0.000000007615"  # (half of the angle in radians) squared
    directions = {"a": right, "b": up, "c": left}
    assert VarianceCost(directions, "1/4").on(BINS).of_plan(["wait"]) == mpq(3, 4)


def test_a_mean_across_the_cut_of_the_circle():
    angles = [Angle.from_degrees(350), Angle.from_degrees(10)]
    turned = [Angle.from_degrees(170), Angle.from_degrees(190)]
    half = [mpq(1, 2), mpq(1, 2)]
    assert circular_variance(angles, half).compare(circular_variance(turned, half)) == 0


def test_variance_of_a_part():
    # Squeezes cannot tell half a turn: every hyperstate is balanced, whatever its probabilities.
    found = planning_problem_of(Part([(0, 0), (7, 0), (9, 4), (3, 6), (-1, 3)]))
    model = VarianceCost(found.orientations).on(found.problem)
    for plan in ([], ["45.0000"], ["45.0000", "45.0000"]):
        assert model.of_plan(plan).compare(1) == 0
    pushed = planning_problem_of(catalogue_part("4gon"), "push-grasp")
    model = VarianceCost(pushed.orientations).on(pushed.problem)
    for plan in ([], pushed.problem.actions[2:3], pushed.problem.actions[5:7]):
        after = pushed.problem.run(plan)
        vectors = [cmath.exp(1j * angle.to_float()) for angle in pushed.orientations.values()]
        mean = sum(float(p) * u for p, u in zip(after, vectors, strict=True))
        assert abs(float(model.of_plan(plan)) - (1 - abs(mean) ** 2)) < 1e-12


def test_distance():
    cost = distance_cost(
        {"a": Angle(), "b": Angle.from_degrees(200), "c": Angle(0, (3, 2))}, Angle.from_degrees(10)
    )
    model = cost.on(BINS)
    assert model.of_plan(["wait"]) == (10 + 170) / mpq(2)
    assert model.value(0, BINS.vector({"c": 1})).decimal(4) == "23.6901"


def test_distance_with_irrational_probabilities():
    # The house ends in one of two orientations, 90 degrees apart, up to symmetry; its distance to
    # the first is 90 degrees with the probability of the second.
    found = planning_problem_of(catalogue_part("house"))
    cost = distance_cost(found.orientations, Angle())
    model = cost.on(found.problem)
    p = found.problem.prior
    assert model.of_plan([]) == 180 * p[2] + 90 * (p[1] + p[3])
    key = planning_problem_of(catalogue_part("key"))
    model = distance_cost(key.orientations, key.orientations[key.problem.states[0]]).on(key.problem)
    plain = sum(
        float(p) * float(c) for p, c in zip(key.problem.prior, model.state_costs, strict=True)
    )
    assert abs(float(model.of_plan([])) - plain) < 1e-10
    costs = dict(zip(key.problem.states, model.state_costs, strict=True))
    best = find_plan(key.problem, 2, AdditiveCost(0, costs))
    assert best.proven
    # The two halves of the circle are alike, so that every plan is 90 degrees off, exactly.
    assert best.cost.compare(90) == 0
    assert len(best.plan) == 1


def test_depth_bounds():
    model = IterativeCost("c", 1, test=2).on(BINS)
    # A plan of k actions costs k + 2 or more, so more than 14/3 actions are too many for 20/3.
    assert model.longest(mpq(20, 3)) == 4
    assert GoalCost("c", "1/10").on(BINS).longest(mpq(1, 4)) == 2
    assert GoalCost("c").on(BINS).longest(mpq(1, 4)) is None
    assert model.longest(INFINITE) is None


class TestRounds:
    def test_mean_and_distribution(self):
        rounds = Rounds(mpq(1, 6))
        assert (rounds.mean, rounds.variance) == (6, 30)
        assert rounds.probability_of(3) == mpq(25, 216)
        assert rounds.probability_within(3) == mpq(91, 216)

    def test_the_distribution_sums_to_what_is_within(self):
        rounds = Rounds(mpq(2, 7))
        assert sum(rounds.probability_of(n) for n in range(1, 9)) == rounds.probability_within(8)

    @pytest.mark.parametrize(
        ("p", "share", "expected"),
        [
            ("1/2", "1/2", 1),
            ("1/2", "3/4", 2),
            ("1/2", "0.7500000000000000000000001", 3),
            ("1/2", "1/4", 1),
            ("1/3", "19/27", 3),
            ("1", "99/100", 1),
            ("1/6", "0", 1),
        ],
    )
    def test_quantiles_and_their_ties(self, p, share, expected):
        assert Rounds(mpq(p)).quantile(share) == expected

    def test_long_ties(self):
        tie = 1 - mpq(2, 3) ** 500
        assert Rounds(mpq(1, 3)).quantile(tie) == 500
        assert Rounds(mpq(1, 3)).quantile(tie + mpq(1, 3**700)) == 501
        assert Rounds(mpq(1, 3)).quantile(tie - mpq(1, 3**700)) == 500

    def test_an_irrational_probability(self):
        rounds = Rounds(AngleSum(0, [(1, Angle(0, (3, 2)))]))  # 0.0936
        assert rounds.mean.decimal(4) == "10.6856"
        assert rounds.probability_within(1).decimal(4) == "0.0936"
        n = rounds.quantile("1/2")
        assert rounds.probability_within(n - 1).compare(mpq(1, 2)) < 0
        assert rounds.probability_within(n).compare(mpq(1, 2)) > 0
        assert rounds.variance.compare(mpq(103)) > 0

    @pytest.mark.parametrize("p", [mpq(0), mpq(-1, 2), mpq(3, 2)])
    def test_no_probability(self, p):
        with pytest.raises(InputError, match="accepted: more than 0, at most 1"):
            Rounds(p)

    def test_bad_questions(self):
        with pytest.raises(InputError, match="0 rounds; accepted: 1 or more"):
            Rounds(mpq(1, 2)).probability_of(0)
        with pytest.raises(InputError, match="share 1; accepted: from 0 up to"):
            Rounds(mpq(1, 2)).quantile(1)


def test_infinity_compares_with_everything():
    numbers = [mpq(10**30), AngleSum(5), LogSum(1, [(1, 3)]), 7]
    for number in numbers:
        assert number < INFINITE
        assert number < INFINITE
        assert number != INFINITE
        assert INFINITE + number is INFINITE
        assert number + INFINITE is INFINITE
    assert math.inf == INFINITE
    assert not math.inf > INFINITE
    assert min(INFINITE, mpq(1)) == 1
    assert hash(INFINITE) == hash(math.inf)
