"""Laws of sensors and of plans with them."""

from __future__ import annotations

from fractions import Fraction

from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.entropy import entropy
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.sensing.calibration import expected_entropy
from stochgeom.sensing.diameter_sensor import sensor_of_diameters
from stochgeom.sensing.one_step import one_step_plan
from stochgeom.sensing.planners import iterative_sensor_plan
from stochgeom.sensing.sensing_problem import SensingProblem
from stochgeom.sensing.sensor_design import fuse_sensors
from stochgeom.sensing.sensors import Sensor
from stochgeom.sensing.tree_nodes import Act, Leaf
from tests.strategies import (
    PYTHAGOREAN,
    distributions,
    hulls,
    likelihoods,
    problem_tables,
    ratios,
)

FEW = settings(max_examples=min(300, settings.default.max_examples))
FEWER = settings(max_examples=min(60, settings.default.max_examples))


@st.composite
def watched(draw, *, sensors=1):
    """A problem and some free sensors of its states."""
    prior, tables = draw(problem_tables(states=4, actions=2))
    problem = PlanningProblem.from_matrices(prior, tables)
    found = []
    for _ in range(sensors):
        table = draw(likelihoods(len(prior)))
        found.append(Sensor(range(len(table[0])), table, states=problem.states))
    return problem, *found


# --- Bayes ---------------------------------------------------------------------------------------


@FEW
@given(watched())
def test_posteriors_average_to_the_prior(case):
    problem, sensor = case
    marginal = sensor.marginal(problem.prior)
    assert sum(marginal.values()) == 1
    mean = [mpq(0)] * len(problem.prior)
    for reading, m in marginal.items():
        if m:
            posterior = sensor.posterior(problem.prior, reading)
            assert sum(posterior) == 1
            mean = [a + m * p for a, p in zip(mean, posterior, strict=True)]
    assert tuple(mean) == problem.prior


@FEWER
@given(watched())
def test_bayes_is_conditioning_on_the_reading(case):
    """Eq. 7.1 to 7.3 from the table of all pairs of a state and a reading, cell by cell.

    Refuted by a marginal that is no sum of a column, a posterior that is not its shares, or a
    matrix by which the hyperstate does not become them.
    """
    problem, sensor = case
    states = range(len(problem.states))
    pairs = [[p * q for q in sensor.likelihood[i]] for i, p in enumerate(problem.prior)]
    for k, reading in enumerate(sensor.readings):
        column = [row[k] for row in pairs]
        assert sensor.marginal(problem.prior)[reading] == sum(column)
        matrix = sensor.matrix(reading)
        product = [sum(problem.prior[i] * matrix[i][j] for i in states) for j in states]
        assert product == column
        if sum(column):
            shares = tuple(cell / sum(column) for cell in column)
            assert sensor.posterior(problem.prior, reading) == shares


@FEW
@given(watched(sensors=2))
def test_the_order_of_two_readings_does_not_matter(case):
    problem, first, second = case
    for x in first.readings:
        for y in second.readings:
            one = second.joint(first.joint(problem.prior, x), y)
            assert one == first.joint(second.joint(problem.prior, y), x)


# --- information never hurts ---------------------------------------------------------------------


@FEW
@given(watched(), st.integers(0, 2))
def test_a_free_sensor_never_raises_the_cost(case, moves):
    problem, sensor = case
    without = iterative_sensor_plan(problem, [], moves)
    plan = iterative_sensor_plan(problem, sensor, moves)
    assert plan.expected_cost <= without.expected_cost


@FEW
@given(watched())
def test_looking_before_accepting_never_costs_more(case):
    """Even where the look is forced: the sum of maxima is at least the maximum of the sum."""
    problem, sensor = case
    blind = one_step_plan(Sensor.blind(problem.states), problem.prior)
    assert one_step_plan(sensor, problem.prior).expected_cost <= blind.expected_cost


@FEW
@given(watched(sensors=2))
def test_two_sensors_are_no_worse_than_one(case):
    problem, first, second = case
    both = one_step_plan(fuse_sensors(first, second), problem.prior)
    for sensor in (first, second):
        assert both.expected_cost <= one_step_plan(sensor, problem.prior).expected_cost


@FEW
@given(watched(), st.data())
def test_garbled_readings_are_no_better(case, data):
    """What is read through a noisy line of any kind (Blackwell)."""
    problem, sensor = case
    count = len(sensor.readings)
    line = [data.draw(distributions(2)) for _ in range(count)]
    garbled = Sensor(
        ["0", "1"],
        [
            [sum(row[x] * mpq(line[x][y]) for x in range(count)) for y in (0, 1)]
            for row in sensor.likelihood
        ],
        states=problem.states,
    )
    for moves in (1, 2):
        clear, worse = (
            iterative_sensor_plan(problem, s, moves, action_costs="1/2") for s in (sensor, garbled)
        )
        assert clear.expected_cost <= worse.expected_cost


@FEW
@given(watched())
def test_a_perfect_sensor_is_the_best(case):
    problem, sensor = case
    plan = iterative_sensor_plan(problem, sensor, 1)
    perfect = iterative_sensor_plan(problem, Sensor.perfect(problem.states), 1)
    assert perfect.expected_cost == 1 <= plan.expected_cost


@FEW
@given(watched())
def test_more_moves_never_cost_more(case):
    problem, sensor = case
    costs = [iterative_sensor_plan(problem, sensor, moves).expected_cost for moves in (0, 1, 2)]
    assert costs == sorted(costs, reverse=True)


@FEW
@given(watched())
def test_equation_7_5_is_never_less(case):
    problem, sensor = case
    plan = one_step_plan(sensor, problem.prior)
    assert plan.printed_cost >= plan.expected_cost


@FEW
@given(watched())
def test_a_look_leaves_no_more_entropy(case):
    problem, sensor = case
    plan = iterative_sensor_plan(problem, sensor, stages=["sense"])
    assert (expected_entropy(plan.tree) - entropy(problem.prior)).sign() <= 0


# --- what a tree says of itself ------------------------------------------------------------------


def forecast(problem, sensor, node, state):
    """Return (cost, success) of a subplan for a hidden state, without any hyperstate."""
    if isinstance(node, Leaf):
        return mpq(0), mpq(problem.states[state] == node.decision)
    if isinstance(node, Act):
        row = problem.matrix(node.action)[state]
        pairs = [(p, forecast(problem, sensor, node.child, k)) for k, p in enumerate(row) if p]
    else:
        branches = dict(node.branches)
        pairs = [
            (p, forecast(problem, sensor, branches[x], state))
            for x, p in zip(sensor.readings, sensor.likelihood[state], strict=True)
            if p
        ]
    return (
        node.cost + sum(p * cost for p, (cost, _) in pairs),
        sum((p * success for p, (_, success) in pairs), start=mpq(0)),
    )


@FEW
@given(watched(), st.integers(0, 3), st.sampled_from([0, Fraction(1, 4)]))
def test_a_tree_does_what_it_says(case, moves, price):
    """Followed with the state in view, it costs and succeeds as its hyperstates say."""
    problem, sensor = case
    plan = iterative_sensor_plan(problem, sensor.with_cost(price), moves, action_costs="1/8")
    cost = success = mpq(0)
    for state, p in enumerate(problem.prior):
        if p:
            one = forecast(problem, sensor, plan.tree.root, state)
            cost, success = cost + p * one[0], success + p * one[1]
    assert (plan.tree.cost, plan.tree.gain) == (cost, success)


# --- parts ---------------------------------------------------------------------------------------


@FEWER
@given(hulls(most=6), st.integers(0, 2), ratios.filter(lambda c: c >= 0))
def test_plans_that_never_look_are_feeding_plans(part, squeezes, cost_ratio):
    """The search over trees against phase I, which knows no hyperstates."""
    plan = SensingProblem(part, cost_ratio=cost_ratio).plan(stages=["act"] * squeezes)
    feeding = FeedingProblem(part)
    costs = [feeding.expected_cost(steps, cost_ratio) for steps in range(1, squeezes + 2)]
    least = min(costs)
    if least.rational is not None:
        assert plan.expected_cost == least.rational
    else:
        assert plan.decimal(12) == least.decimal(12)


@FEWER
@given(hulls(most=6), st.sampled_from(PYTHAGOREAN), st.integers(1, 5))
def test_costs_do_not_depend_on_the_frame(part, turn, scale):
    moved = part.multiply((scale * turn[0], scale * turn[1])).translate(3, -2)
    first, second = (SensingProblem(p).plan(1) for p in (part, moved))
    assert first.decimal(12) == second.decimal(12)


@FEWER
@given(hulls(most=6))
def test_the_exact_sensor_reads_equal_diameters_alike(part):
    problem = SensingProblem(part)
    states = list(problem.states)
    row = dict(zip(problem.sensor.states, problem.sensor.likelihood, strict=True))
    for a in states:
        for b in states:
            same = problem.squared_diameters[a] == problem.squared_diameters[b]
            assert (row[a] == row[b]) == same
    # Half a turn apart nothing differs.
    half = len(states) // 2
    assert all(row[states[k]] == row[states[k + half]] for k in range(half))


squares = st.lists(st.sampled_from([mpq(k, 4) for k in range(1, 60)]), min_size=1, max_size=6).map(
    lambda values: {str(k): value for k, value in enumerate(values)}
)


@given(squares, st.integers(0, 4))
def test_one_bit_more_refines_the_bins(values, bits):
    coarse, fine = (sensor_of_diameters(values, b).blocks for b in (bits, bits + 1))
    for block in fine.values():
        assert sum(bool(set(block) & set(other)) for other in coarse.values()) == bool(block)


@FEWER
@given(squares, st.integers(0, 3), st.sampled_from(["0.01", "0.1", "1/3", "2"]))
def test_noisy_bins_add_up(values, bits, noise):
    """Two neighbouring bins of b + 1 bits are one of b bits, up to the rounding."""
    coarse, fine = (sensor_of_diameters(values, b, noise) for b in (bits, bits + 1))
    for one, two in zip(coarse.likelihood, fine.likelihood, strict=True):
        together = [two[k] + two[k + 1] for k in range(0, len(two), 2)]
        assert sum(one) == sum(two) == 1
        off = sum(abs(a - b) for a, b in zip(one, together, strict=True))
        assert off <= coarse.row_error + fine.row_error
