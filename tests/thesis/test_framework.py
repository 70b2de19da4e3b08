"""Chapter 2, section 7.3 and appendix A: what the source works out, and what it says."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.decision.additive_costs import AdditiveCost
from stochgeom.decision.entropy import EntropyCost
from stochgeom.decision.exhaustive_plans import count_plans
from stochgeom.decision.goal_costs import GoalCost, GuaranteedCost
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.perfect_information import observed_policy
from stochgeom.decision.plan_search import best_action, find_plan
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.decision.rounds import Rounds
from stochgeom.decision.two_argmins import two_argmins
from stochgeom.decision.uniform_difference import simulated_difference


def test_section_2_2_by_hand():
    """Eq. 2.4: the matrix of a plan is the product of its matrices, in the order of the actions."""
    first = [["1/2", "1/2"], [0, 1]]
    second = [["1/3", "2/3"], ["1/4", "3/4"]]
    problem = PlanningProblem(["1", "2"], ["2/3", "1/3"], ["a", "b"], [first, second])
    # (2/3, 1/3) -> a -> (1/3, 2/3) -> b -> (1/9 + 1/6, 2/9 + 1/2); the other order differs.
    assert problem.run(["a"]) == (mpq(1, 3), mpq(2, 3))
    assert problem.run(["a", "b"]) == (mpq(5, 18), mpq(13, 18))
    # (2/3, 1/3) -> b -> (11/36, 25/36) -> a -> (11/72, 61/72).
    assert problem.run(["b", "a"]) == (mpq(11, 72), mpq(61, 72))
    # Eq. 2.5 over all plans of one and two actions: state 1 is the goal, an action costs 1/20.
    cost = GoalCost("1", "1/20")
    by_hand = {
        ("a",): mpq(1, 20) + mpq(2, 3),
        ("b",): mpq(1, 20) + mpq(25, 36),
        ("a", "b"): mpq(1, 10) + mpq(13, 18),
        ("b", "a"): mpq(1, 10) + mpq(61, 72),
    }
    assert {plan: cost.on(problem).of_plan(plan) for plan in by_hand} == by_hand
    assert find_plan(problem, 2, cost).plan == ("a",)
    assert best_action(problem, cost).cost == mpq(1, 20) + mpq(2, 3)


def test_section_2_3_the_die():
    """A die shows a three with 1/6 and is thrown 6 times on average."""
    throw = [["1/6"] * 6] * 6
    die = PlanningProblem(range(1, 7), {1: 1}, ["throw"], [throw], IterativeCost(3, 1, 0))
    found = find_plan(die, 4)
    assert (found.plan, found.cost) == (("throw",), 6)
    rounds = found.model.rounds(found.hyperstate)
    assert rounds.mean == 6
    # The sum of the source: p 1 + p (1 - p) 2 + ..., to 400 terms.
    partial = sum(n * rounds.probability_of(n) for n in range(1, 400))
    assert 6 - partial < mpq(1, 10**28)


def test_section_4_1_one_step_or_two():
    """A step that succeeds with .8 takes 1 / .8 = 1.25 rounds and time units; two steps take 2."""
    one, two = Rounds(mpq(4, 5)), Rounds(mpq(1))
    assert one.mean == mpq(5, 4)
    assert (1 * one.mean, 2 * two.mean) == (mpq("1.25"), 2)
    # By adding up what the mean stands for: 1 with .8, 2 with .2 .8, ...
    partial = sum(n * mpq(4, 5) * mpq(1, 5) ** (n - 1) for n in range(1, 60))
    assert 0 < one.mean - partial < mpq(1, 10**38)


def test_equation_6_3_an_urn():
    """One red and one black ball in two draws with replacement: .12, as the source has it."""
    colors = {"red": mpq(3, 10), "black": mpq(2, 10), "white": mpq(5, 10)}
    drawn = sorted(k for k in product(range(3), repeat=3) if sum(k) <= 2)

    def draw(counts, _):
        if sum(counts) == 2:
            return counts
        more = [tuple(n + (i == j) for j, n in enumerate(counts)) for i in range(3)]
        return dict(zip(more, colors.values(), strict=True))

    urn = PlanningProblem.from_function(drawn, {(0, 0, 0): 1}, ["draw"], draw)
    after = urn.run(["draw", "draw"])
    assert after[urn.state_number((1, 1, 0))] == mpq(12, 100)


def test_section_2_4_the_number_of_plans():
    assert count_plans(12, 3) == 12 + 144 + 1728
    assert count_plans(12, 3) - count_plans(12, 2) == 12**3  # section 6.4


def test_section_2_5_1_perfect_information():
    """A certain state and binary matrices: a plan is a path, and dynamic programming finds it."""
    places = [(x, y) for x in range(4) for y in range(3)]
    steps = {"e": (1, 0), "w": (-1, 0), "n": (0, 1), "s": (0, -1)}

    def move(place, way):
        to = tuple(a + b for a, b in zip(place, steps[way], strict=True))
        return to if to in places else place

    grid = PlanningProblem.from_function(places, {(0, 0): 1}, steps, move)
    assert grid.deterministic
    goal = AdditiveCost(1, {place: 100 for place in places if place != (3, 2)})
    found = find_plan(grid, 7, goal)
    assert found.cost == observed_policy(grid, 7, goal).expected_cost == 5
    assert sorted(found.plan) == ["e", "e", "e", "n", "n"]
    assert found.nodes < 200


def test_section_2_5_2_the_two_argmins():
    """Eq. 2.6 weighs by what is known, Eq. 2.8 by where the action leads: they can contradict."""
    problem = PlanningProblem(
        ["left", "right"],
        ["9/10", "1/10"],
        ["keep", "swap"],
        [[[1, 0], [0, 1]], [[0, 1], [1, 0]]],
    )
    # To be left costs 1, to swap 1/4: it is no use to decide for it, and it is right to do it.
    cost = {"keep": mpq(0), "swap": mpq(1, 4)}
    found = two_argmins(problem, lambda action, state: cost[action] + int(state == "left"))
    assert found.decisions == ("keep",)
    assert found.manipulations == ("swap",)
    assert found.manipulation_costs["swap"] == mpq(1, 4) + mpq(1, 10)


def test_section_2_5_3_guaranteed_plans():
    """Uniform over what is possible, infinite off the goal: a plan of finite cost cannot fail."""
    half = ["1/2", "1/2", 0]
    problem = PlanningProblem(
        ["a", "b", "c"],
        half,
        ["risky", "safe"],
        [[[0, "1/2", "1/2"], [0, 0, 1], [0, 0, 1]], [[0, 1, 0], [0, 0, 1], [0, 0, 1]]],
    )
    found = find_plan(problem, 3, GuaranteedCost("c", {"risky": 1, "safe": 5}))
    # Ranked by cost (7.1.1): two risky steps are sure as well, and cheaper.
    assert (found.plan, found.cost) == (("risky", "risky"), 2)
    free = find_plan(problem, 1, GuaranteedCost("c", 0))
    assert not free.feasible


def test_section_7_3_entropy_misleads():
    """(.5 .5) is better than (.01 .99) if the first state is the good one; entropy says not."""
    problem = PlanningProblem(
        ["good", "bad"],
        ["1/2", "1/2"],
        ["wait", "spoil"],
        [[[1, 0], [0, 1]], [["1/100", "99/100"]] * 2],
    )
    assert best_action(problem, EntropyCost()).plan == ("spoil",)
    assert best_action(problem, GoalCost("good")).plan == ("wait",)
    assert EntropyCost().on(problem).of_plan(["spoil"]).decimal(3) == "0.081"


@pytest.mark.parametrize("kind", ["point", "narrow", "two heaps"])
def test_theorem_3_1_by_simulation(kind):
    """Twenty thousand random turns: no bin of thirty-six is off by more than five deviations."""
    makers = {
        "point": lambda _, n: np.full(n, 1.25),
        "narrow": lambda source, n: source.normal(2, 0.01, n),
        "two heaps": lambda source, n: source.choice([0.5, 3.0], n, p=[0.9, 0.1]),
    }
    found = simulated_difference(makers[kind], 20_000, seed=1990)
    counts, _ = np.histogram(found, 36, (0, 2 * np.pi))
    expected = 20_000 / 36
    assert np.abs(counts - expected).max() < 5 * np.sqrt(expected)
    assert abs(np.exp(1j * found).mean()) < 5 / np.sqrt(20_000)
