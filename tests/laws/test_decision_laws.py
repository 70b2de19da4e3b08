"""Laws of hyperstates, costs and plans, on whatever hypothesis finds."""

from __future__ import annotations

from fractions import Fraction

from gmpy2 import mpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from stochgeom.decision.additive_costs import AdditiveCost
from stochgeom.decision.circular_variance import circular_variance
from stochgeom.decision.entropy import entropy
from stochgeom.decision.goal_costs import GoalCost, GuaranteedCost
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.plan_search import find_plan
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.decision.rounds import Rounds
from stochgeom.decision.two_argmins import two_argmins
from stochgeom.decision.uniform_difference import cyclic_difference
from stochgeom.decision.worst_case_costs import MinimaxCost
from stochgeom.exact.angles import Angle
from stochgeom.exact.sums import AngleSum
from tests.strategies import directions, distributions, problem_tables, rational_orientations

FEW = settings(max_examples=60)

sizes = st.integers(1, 5)


@FEW
@given(problem_tables(), st.lists(st.integers(0, 2), max_size=4))
def test_a_plan_keeps_the_sum_of_a_hyperstate(tables, word):
    problem = PlanningProblem.from_matrices(*tables)
    plan = [problem.actions[k % len(problem.actions)] for k in word]
    after = problem.run(plan)
    assert sum(after) == 1
    assert min(after) >= 0


@FEW
@given(problem_tables(), st.data())
def test_actions_are_linear(tables, data):
    problem = PlanningProblem.from_matrices(*tables)
    other = [mpq(p) for p in data.draw(distributions(len(problem.states)))]
    weight = mpq(data.draw(st.fractions(0, 1, max_denominator=5)))
    mixed = tuple(weight * a + (1 - weight) * b for a, b in zip(problem.prior, other, strict=True))
    for action in problem.actions:
        one, two = problem.after(problem.prior, action), problem.after(tuple(other), action)
        assert problem.after(mixed, action) == tuple(
            weight * a + (1 - weight) * b for a, b in zip(one, two, strict=True)
        )


@FEW
@given(problem_tables(), st.data())
def test_angle_sums_are_what_rational_numbers_are(tables, data):
    """The same problem, with its prior written as sums of angles that cancel in the end."""
    prior, matrices = tables
    assume(len(prior) > 1)
    tilt = AngleSum(0, [("1/100", Angle(0, (3, 2)))])
    big = max(range(len(prior)), key=prior.__getitem__)
    small = (big + 1) % len(prior)
    mixed = [AngleSum(p) for p in prior]
    mixed[big], mixed[small] = mixed[big] - tilt, mixed[small] + tilt
    problem = PlanningProblem.from_matrices(mixed, matrices)
    plain = PlanningProblem.from_matrices(*tables)
    plan = data.draw(st.lists(st.sampled_from(problem.actions), max_size=3))
    after, rational = problem.run(plan), plain.run(plan)
    assert sum(after, start=mpq(0)) == 1
    for p, q in zip(after, rational, strict=True):
        assert abs(float(p) - float(q)) < 2e-3
    cost = AdditiveCost("1/8", {s: k for k, s in enumerate(problem.states)})
    found = find_plan(problem, 2, cost)
    for method in ("breadth-first", "exhaustive"):
        assert find_plan(problem, 2, cost, method=method).cost == found.cost


@FEW
@given(problem_tables(), st.integers(0, 3))
def test_a_longer_horizon_is_never_worse(tables, goal):
    problem = PlanningProblem.from_matrices(*tables)
    state = problem.states[goal % len(problem.states)]
    for cost in (GoalCost(state), GuaranteedCost(state), IterativeCost(state), MinimaxCost(1)):
        costs = [find_plan(problem, horizon, cost).cost for horizon in (1, 2, 3)]
        assert not costs[0] < costs[1]
        assert not costs[1] < costs[2]


@FEW
@given(problem_tables())
def test_guaranteed_plans_are_those_that_cannot_miss(tables):
    problem = PlanningProblem.from_matrices(*tables)
    state = problem.states[0]
    sure = find_plan(problem, 3, GuaranteedCost(state))
    likely = find_plan(problem, 3, GoalCost(state))
    worst = find_plan(problem, 3, MinimaxCost(1, {s: 9 for s in problem.states if s != state}))
    assert sure.feasible == (likely.cost == 0)
    if sure.feasible:
        assert worst.cost == sure.cost
        assert len(sure.plan) == len(likely.plan)  # every action costs the same


@FEW
@given(sizes.flatmap(distributions))
def test_entropy_is_between_that_of_one_state_and_of_equal_ones(shares):
    p = [mpq(share) for share in shares]
    bits = entropy(p)
    assert bits >= 0
    assert (bits == 0) == (max(p) == 1)
    most = entropy([mpq(1, len(p))] * len(p))
    assert bits <= most
    assert (bits == most) == (len(set(p)) == 1)


@FEW
@given(sizes.flatmap(lambda n: st.tuples(distributions(n), distributions(n))))
def test_entropy_is_concave(pair):
    p, q = ([mpq(x) for x in shares] for shares in pair)
    middle = [(a + b) / 2 for a, b in zip(p, q, strict=True)]
    assert not entropy(middle) < (entropy(p) + entropy(q)).scaled(Fraction(1, 2))


@FEW
@given(
    st.integers(1, 4).flatmap(
        lambda n: st.tuples(
            distributions(n), st.lists(rational_orientations, min_size=n, max_size=n)
        )
    ),
    directions,
)
def test_variance_does_not_change_under_rotation_and_reflection(case, direction):
    shares, angles = case
    p = [mpq(share) for share in shares]
    here = circular_variance(angles, p)
    assert here >= 0
    assert here <= 1
    turned = [angle + Angle(0, direction) for angle in angles]
    assert circular_variance(turned, p) == here
    assert circular_variance([Angle() - angle for angle in angles], p) == here
    assert circular_variance([angle + Angle(3) for angle in angles], p) == here


@FEW
@given(st.integers(1, 9).map(lambda k: Fraction(k, 9)), st.fractions(0, Fraction(999, 1000)))
def test_a_quantile_of_rounds_is_the_first_that_is_enough(p, share):
    rounds = Rounds(mpq(p))
    n = rounds.quantile(share)
    assert rounds.probability_within(n) >= share
    assert n == 1 or rounds.probability_within(n - 1) < share


@FEW
@given(st.fractions(Fraction(1, 99), 1, max_denominator=99), st.integers(1, 30))
def test_section_2_3_the_mean_of_rounds(p, n):
    """Some rounds added up, and those after them, of which each success is n rounds late.

    Refuted by a mean, or a variance, that is not that of this sum; both are determined by it.
    """
    rounds, still = Rounds(mpq(p)), (1 - mpq(p)) ** n
    chances = [rounds.probability_of(k) for k in range(1, n + 1)]
    assert chances == [mpq(p) * (1 - mpq(p)) ** (k - 1) for k in range(1, n + 1)]
    assert sum(chances) == rounds.probability_within(n) == 1 - still
    seen = sum(k * chance for k, chance in enumerate(chances, 1))
    assert rounds.mean == seen + still * (n + rounds.mean)
    assert rounds.mean == 1 / mpq(p)


@FEW
@given(sizes.flatmap(lambda n: st.tuples(distributions(n), st.just(n))))
def test_theorem_3_1_on_cyclic_groups(case):
    """A uniform X makes Y - X uniform whatever Y is, and so does a uniform Y; only uniform ones."""
    shares, n = case
    uniform = [Fraction(1, n)] * n
    assert (
        cyclic_difference(uniform, shares) == cyclic_difference(shares, uniform) == tuple(uniform)
    )
    certain = [1] + [0] * (n - 1)
    # From a certain Y the difference is X reversed: uniform only if X is.
    assert (cyclic_difference(shares, certain) == tuple(uniform)) == (shares == uniform)


@FEW
@given(sizes.flatmap(lambda n: st.tuples(distributions(n), distributions(n))))
def test_the_difference_by_pairs(pair):
    x, y = pair
    n = len(x)
    plain = [Fraction(0)] * n
    for i, p in enumerate(x):
        for j, q in enumerate(y):
            plain[(j - i) % n] += p * q
    assert list(cyclic_difference(x, y)) == plain


@FEW
@given(problem_tables(), st.data())
def test_the_two_argmins_agree_if_nothing_moves(tables, data):
    prior, matrices = tables
    n = len(prior)
    still = [[[int(i == j) for j in range(n)] for i in range(n)] for _ in matrices]
    problem = PlanningProblem.from_matrices(prior, still)
    table = data.draw(
        st.lists(st.lists(st.integers(-2, 2), min_size=n, max_size=n), min_size=3, max_size=3)
    )
    found = two_argmins(problem, lambda action, state: table[int(action)][int(state)])
    assert found.decision_costs == found.manipulation_costs
    moving = two_argmins(
        PlanningProblem.from_matrices(*tables), lambda action, state: table[int(action)][int(state)]
    )
    assert moving.decision_costs == found.decision_costs
    for action in problem.actions:
        end = PlanningProblem.from_matrices(*tables).run([action])
        costs = [table[int(action)][k] for k in range(n)]
        assert moving.manipulation_costs[action] == sum(
            p * c for p, c in zip(end, costs, strict=True)
        )
