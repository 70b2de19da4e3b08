"""Laws of plans: what they do at every angle of their ranges, how long they are, what they cost."""

from __future__ import annotations

from itertools import cycle, pairwise

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.errors import VerificationError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.ratios import TurnRatio
from stochgeom.feeding.execution import check_plan, composite, run_angle, run_arc
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import preimages
from tests.strategies import (
    circle_parts,
    directions,
    mixtures,
    nearly_regular,
    parts,
    rational_parts,
    ratios,
    step_functions,
)

any_part = st.one_of(parts(), parts(), rational_parts(), circle_parts(), nearly_regular(most=7))
problems = any_part.map(FeedingProblem)


def plan_for(transfer):
    """Return the shortest plan up to symmetry for a bare transfer function (thesis 5.10)."""
    return FeedingPlan(transfer, preimages(transfer), mpq(1))


plans = st.one_of(problems.map(FeedingProblem.geometric_plan), step_functions().map(plan_for))
long_plans = plans.filter(lambda plan: plan.steps > 1)
cost_ratios = st.one_of(st.sampled_from([0, 1, "1/3", "0.1234567", 10**6]), ratios.map(abs))
weights = st.lists(mixtures, min_size=1, max_size=6).map(cycle)
SLIGHT = Angle(0, (10**9, 1))


def between(low, high, weight):
    """Return an angle in (low, high] by the weights of its two ends."""
    a, b = weight
    span = high - low
    assert span > ZERO
    if span.rational_turns is not None:
        return low + Angle.from_turns(span.rational_turns * b / (a + b))
    assert span < HALF_TURN
    x, y = span.direction
    return low + Angle(0, (a + b * x, b * y))


def collapses(plan, angles, mouth=None):
    """Tell whether actions at these angles take a mouth to the plan's final orientation."""
    last = run_arc(plan.transfer, angles, plan.mouth if mouth is None else mouth)[-1]
    return not last.width and last.start == plan.final_orientation


def reaching_ranges(plan, *, low_side):
    """Return the angles of each action that keep one end of the image in the step of the goal's.

    On the low side these are the angles so near `low` that the last orientation of the image
    still falls into the last step of the next preimage, on the other side those so near `high`
    that the first one falls into the first step.
    """
    s, ranges = plan.transfer, []
    for here, following, action in zip(
        plan.preimages[::-1], plan.preimages[-2::-1], plan.actions[1:], strict=False
    ):
        goal = following.arc
        if low_side:
            last_break = s.lifted_breaks[s.step_before(goal.end)]
            ranges.append((action.low, min(action.high, here.image.end - last_break)))
        else:
            next_break = s.lifted_breaks[s.step_at(goal.start) + 1]
            ranges.append((max(action.low, here.image.start - next_break), action.high))
    return ranges


# --- ranges --------------------------------------------------------------------------------------


@given(plans)
def test_a_plan_collapses_its_mouth_at_nominal_angles_and_at_both_ends(plan):
    """Refuted by a nominal angle, an upper end, or an angle just above `low` that fails."""
    actions = plan.actions[1:]
    assert all(action.low < action.angle < action.high for action in actions)
    assert collapses(plan, plan.angles)
    assert collapses(plan, [ZERO, *(action.high for action in actions)])
    assert collapses(plan, [ZERO, *(between(a.low, a.high, (10**60, 1)) for a in actions)])
    assert plan.verify()


@given(plans, weights)
def test_ranges_are_independent(plan, mix):
    """Refuted by angles, each inside its own range, at which the plan fails together."""
    angles = [between(a.low, a.high, w) for a, w in zip(plan.actions[1:], mix, strict=False)]
    assert collapses(plan, [ZERO, *angles])


@given(long_plans, st.data(), weights)
def test_a_plan_fails_at_a_lower_end_that_is_reached(plan, data, mix):
    """Refuted by an action at `low`, its predecessors near their own, that does no harm.

    Near means: the last orientation of each image stays in the last step of the preimage that
    holds it. What follows may be anywhere in its range.
    """
    k = data.draw(st.integers(1, plan.steps - 1))
    before = reaching_ranges(plan, low_side=True)[: k - 1]
    after = [(a.low, a.high) for a in plan.actions[k + 1 :]]
    angles = [between(low, high, w) for (low, high), w in zip(before + after, mix, strict=False)]
    assert collapses(plan, [ZERO, *angles[: k - 1], plan.actions[k].high, *angles[k - 1 :]])
    assert not collapses(plan, [ZERO, *angles[: k - 1], plan.actions[k].low, *angles[k - 1 :]])


@given(long_plans, st.data(), weights)
def test_a_plan_fails_above_an_upper_end_that_is_reached(plan, data, mix):
    """Refuted by an action above `high`, its predecessors near their own, that does no harm."""
    k = data.draw(st.integers(1, plan.steps - 1))
    before = reaching_ranges(plan, low_side=False)[: k - 1]
    after = [(a.low, a.high) for a in plan.actions[k + 1 :]]
    angles = [between(low, high, w) for (low, high), w in zip(before + after, mix, strict=False)]
    above = plan.actions[k].high + SLIGHT
    assert not collapses(plan, [ZERO, *angles[: k - 1], above, *angles[k - 1 :]])


@given(long_plans, st.data(), weights)
def test_an_action_at_its_lower_end_does_not_collapse_the_whole_preimage(plan, data, mix):
    """Refuted by a preimage that survives the action at `low`, whatever follows inside ranges."""
    k = data.draw(st.integers(2, plan.steps))
    plan = FeedingPlan(plan.transfer, plan.preimages[:k], mpq(1))
    rest = [between(a.low, a.high, w) for a, w in zip(plan.actions[2:], mix, strict=False)]
    assert collapses(plan, [ZERO, plan.actions[1].high, *rest])
    assert not collapses(plan, [ZERO, plan.actions[1].low, *rest])
    assert not collapses(plan, [ZERO, plan.actions[1].high + SLIGHT, *rest])


@given(problems)
def test_tolerances_are_what_a_preimage_leaves_around_an_image(problem):
    """Refuted by a tolerance that is not h_(i-1) less the image, or plans that do not nest."""
    plan = problem.geometric_plan()
    for here, action in zip(plan.preimages[:0:-1], plan.actions[1:], strict=True):
        assert action.tolerance == problem.preimages.of_steps(here.steps - 1).width - (
            here.image_width
        )
    for k in range(1, plan.steps):
        assert problem.plan_of(k).actions[1:] == plan.actions[plan.steps - k + 1 :]


# --- certificates of failure ---------------------------------------------------------------------


@given(plans, st.data())
def test_wider_claims_are_found_out(plan, data):
    """Refuted by a mouth or a range, a little wider than it is, that passes the check."""
    ranges = [(a.low, a.angle, a.high) for a in plan.actions]
    mouth, e = plan.mouth, SLIGHT
    k = data.draw(st.integers(0, plan.steps - 1))
    if k == 0:
        if mouth.width == FULL_TURN:
            return
        mouth = data.draw(
            st.sampled_from(
                [Arc(mouth.start - e, mouth.width + e), Arc(mouth.start, mouth.width + e)]
            )
        )
    else:
        low, angle, high = ranges[k]
        ranges[k] = data.draw(
            st.sampled_from(
                [(low - e, angle, high), (low, angle, high + e), (low, low, high)]
                + [(low, high + e, high), (low + e, high, high)] * (e < high - low)
            )
        )
    with pytest.raises(VerificationError):
        check_plan(plan.transfer, mouth, ranges)


# --- length --------------------------------------------------------------------------------------


@given(any_part)
def test_shortest_plans_up_to_symmetry_are_linear(part):
    """Chen and Ierardi: at most 2 n - 1 steps for n hull edges; refuted by a longer plan."""
    assert FeedingProblem(part).geometric_plan().steps <= 2 * len(part.hull) - 1


@given(any_part, cost_ratios)
def test_optimal_plans_are_linear(part, c):
    """Theorem 4.1, k <= 2 n (c + 1), and for squeezes k <= n (c + 1) - c; refuted by more."""
    steps, n, ratio = FeedingProblem(part).optimal_plan(c).steps, len(part.hull), mpq(c)
    assert steps <= 2 * n * (ratio + 1)
    assert steps <= n * (ratio + 1) - ratio


@given(any_part, cost_ratios)
@settings(max_examples=150)
def test_what_theorem_4_1_rests_on(part, c):
    """Eq. 4.9 to 4.13, with c_a = 1: refuted by a part for which one of the inequalities fails."""
    problem = FeedingProblem(part)
    n, ratio, best = len(part.hull), mpq(c), problem.optimal_plan(c)
    assert problem.probability(1) >= mpq(1, 2 * n)  # 4.9
    assert problem.expected_cost(1, c) <= 2 * n * (1 + ratio)  # 4.10
    assert best.expected_cost <= problem.expected_cost(1, c)  # 4.11
    assert best.expected_cost >= best.steps  # 4.12
    assert best.probability >= (best.steps + ratio) / (2 * n * (1 + ratio))  # 4.13
    assert problem.probability(best.steps) == best.probability


@given(problems, cost_ratios)
@settings(max_examples=150)
def test_the_bound_of_section_5_4_1(problem, c):
    """N = (2 pi / h_1) (c + 1): phase I need not go on beyond so many actions.

    Refuted by an optimal plan with more. As no plan succeeds with more than T / 2 pi, one of
    (T / h_1) (c + 1) - c actions is enough, which is asked as well.
    """
    best, widest = problem.optimal_plan(c), problem.preimages.of_steps(1).width
    assert TurnRatio(mpq(c) + 1, widest, inverse=True) >= best.steps
    order = problem.transfer.order
    assert TurnRatio((mpq(c) + 1) / order, widest, inverse=True) >= best.steps + mpq(c)


# --- cost ----------------------------------------------------------------------------------------


@given(problems, cost_ratios)
def test_no_plan_costs_less_than_the_optimal_one(problem, c):
    """Theorem 5.2; refuted by a number of steps that costs less, or fewer that cost as much."""
    best = problem.optimal_plan(c)
    assert best.expected_cost == problem.expected_cost(best.steps, c)
    for k in range(1, 2 * len(problem.part.hull) + 2):
        cost = problem.expected_cost(k, c)
        assert cost >= best.expected_cost
        assert k >= best.steps or cost > best.expected_cost


@given(problems, cost_ratios, cost_ratios)
def test_a_dearer_filter_never_asks_for_a_shorter_plan(problem, one, other):
    """Refuted by c <= d with a longer optimal plan for c."""
    low, high = sorted((mpq(one), mpq(other)))
    assert problem.optimal_plan(low).steps <= problem.optimal_plan(high).steps
    assert problem.optimal_plan(low).expected_cost <= problem.optimal_plan(high).expected_cost
    # In the end the plan that always succeeds is worth its length.
    surest = problem.geometric_plan()
    assert problem.optimal_plan(10**40).steps == surest.steps
    assert surest.orients_up_to_symmetry
    assert surest.probability_up_to_symmetry.rational == 1


@given(problems, cost_ratios)
def test_costs_and_probabilities_are_inverse(problem, c):
    """Refuted by a plan with cost * probability != k + c, one orientation accepted or any."""
    plan = problem.optimal_plan(c)
    order = plan.transfer.order
    for cost, probability in (
        (plan.expected_cost, plan.probability),
        (plan.expected_cost_up_to_symmetry, plan.probability_up_to_symmetry),
    ):
        assert cost.coefficient * probability.coefficient == plan.steps + mpq(c)
        assert cost.angle == probability.angle == plan.mouth.width
        assert cost.inverse
        assert not probability.inverse
    assert plan.probability_up_to_symmetry.coefficient == order


# --- forward -------------------------------------------------------------------------------------


@given(plans, directions)
def test_every_orientation_of_the_mouth_ends_in_the_final_one(plan, offset):
    """Refuted by a theta in the mouth that ends elsewhere, or one outside that ends there."""
    theta = plan.mouth.start + Angle(0, offset)
    trace = plan.execute(theta)
    assert len(trace) == plan.steps + 1
    assert trace[0] == theta
    for state, following, alpha in zip(trace, trace[1:], plan.angles, strict=False):
        assert following == plan.transfer(state - alpha)
    assert (trace[-1] == plan.final_orientation) == (theta < plan.mouth.end)
    arcs = plan.execute_arc()
    assert [arc.start for arc in arcs] == list(plan.execute(plan.mouth.start)[1:])
    assert arcs[-1].width == ZERO


# --- distributions -------------------------------------------------------------------------------


def slow_distribution(plan, steps):
    """Run one orientation of every step of the first action forward and add up the widths."""
    s, found = plan.transfer, {}
    for k in range(len(s) * s.order):
        start, end = s.lifted_breaks[k] + plan.angles[0], s.lifted_breaks[k + 1] + plan.angles[0]
        state = run_angle(s, plan.angles[:steps], start)[-1].reduced()
        found[state] = found.get(state, ZERO) + (end - start)
    return sorted(found.items(), key=lambda item: item[0])


@given(plans)
def test_distributions_are_forward_execution(plan):
    """Refuted by a state or a width, after any step, that running the steps forward lacks."""
    for steps in range(1, plan.steps + 1):
        state = plan.distribution(steps)
        assert list(zip(state.orientations, state.widths, strict=True)) == slow_distribution(
            plan, steps
        )
        assert state.total == FULL_TURN
        assert all(ZERO <= angle < FULL_TURN for angle in state.orientations)
        assert all(one < other for one, other in pairwise(state.orientations))


@given(plans, st.lists(directions, min_size=1, max_size=5))
def test_sampled_orientations_are_in_the_distribution(plan, sample):
    """Refuted by an orientation that ends in none of the states."""
    states = plan.distribution().orientations
    for direction in sample:
        assert plan.execute(Angle(0, direction))[-1].reduced() in states


@given(plans)
def test_distributions_are_the_steps_of_the_composite(plan):
    """Eq. 4.2; refuted by a state whose arc is no step of the composition of all actions."""
    state, whole = plan.distribution(), composite(plan.transfer, plan.angles)
    steps = range(len(whole) * whole.order)
    pairs = [(whole.lifted_values[k].reduced(), whole.widths[k % len(whole)]) for k in steps]
    assert sorted(pairs) == list(zip(state.orientations, state.widths, strict=True))


@given(plans)
def test_the_most_likely_state_is_the_final_orientation(plan):
    """Lemma 5.4: its probability is h / 2 pi, and no state is likelier; refuted by another one."""
    for k in range(1, plan.steps + 1):
        plan = FeedingPlan(plan.transfer, plan.preimages[:k], mpq(1))
        state = plan.distribution()
        place = state.orientations.index(plan.final_orientation.reduced())
        assert state.widths[place] == max(state.widths) == plan.mouth.width
        assert state.widths[state.most_likely()] == plan.mouth.width
        *_, outcome = plan.outcomes()
        assert outcome.most_likely() == plan.probability
        assert len(outcome) == len(state)


@given(plans)
def test_orienting_up_to_symmetry_leaves_equally_spaced_states(plan):
    """Def. 4.3: exactly 2 pi / T states, T apart; refuted by another number or spacing."""
    state, period = plan.distribution(), plan.transfer.period
    assert len(state) == plan.transfer.order
    assert all(other - one == period for one, other in pairwise(state.orientations))
    assert set(state.widths) == {period}


@given(plans)
def test_states_never_split(plan):
    """Refuted by an action after which there are more states, or one too many at the end."""
    counts = [len(plan.distribution(k)) for k in range(1, plan.steps + 1)]
    assert counts == sorted(counts, reverse=True)
    assert counts[-1] == plan.transfer.order
    assert plan.steps == 1 or counts[-2] > counts[-1]
