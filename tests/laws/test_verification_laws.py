"""Laws of `verify_plan`: reports agree with plans, with forward execution, and with phase I."""

from __future__ import annotations

from itertools import accumulate, pairwise

import pytest
from gmpy2 import mpq
from hypothesis import Phase, assume, find, given, settings
from hypothesis import strategies as st

from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding.execution import composite, run_angle
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import preimages
from stochgeom.feeding.verification import parse_angles, verify_plan
from tests.strategies import (
    TINY,
    angles,
    circle_parts,
    nearly_regular,
    necklaces,
    parts,
    rational_parts,
    ratios,
    transfer_functions,
)

FEW = settings().max_examples // 4
"""Laws that run a plan many times."""

any_part = st.one_of(parts(), parts(), rational_parts(), circle_parts(), nearly_regular(most=7))
problems = any_part.map(FeedingProblem)
transfers = st.one_of(transfer_functions(), necklaces())
sequences = st.lists(angles(), min_size=1, max_size=5)


@st.composite
def promising(draw):
    """A transfer function and angles, some of which put an image into a wide step.

    Random angles seldom collapse anything; these turn a value to the end or middle of a step.
    """
    s = draw(transfers)
    count = draw(st.integers(1, 5))
    places = st.integers(-len(s), 2 * len(s))
    found = []
    for _ in range(count):
        value, last = s.lifted_values[draw(places)], s.lifted_breaks[draw(places)]
        found.append(value - last + draw(st.sampled_from([ZERO, ZERO, TINY, -TINY])))
    others = draw(st.lists(angles(), max_size=2))
    return s, draw(st.permutations(found + others))


@st.composite
def spoiled(draw):
    """A plan that orients, with one angle turned by something, and perhaps more actions."""
    s = draw(transfers)
    turns = list(FeedingPlan(s, preimages(s), mpq(1)).angles)
    turns += draw(st.lists(st.sampled_from([ZERO, *turns]), max_size=2))
    k = draw(st.integers(0, len(turns) - 1))
    turns[k] += draw(angles())
    return s, turns


cases = st.one_of(st.tuples(transfers, sequences), promising(), spoiled())


def final_orientations(transfer, turns, arc):
    """Return where a plan takes an arc, by the composite of its actions (Eq. 4.2)."""
    whole = composite(transfer, turns)
    first, last = whole.step_at(arc.start), whole.step_before(arc.end)
    return {whole.lifted_values[k].reduced() for k in range(first, last + 1)}


@pytest.mark.parametrize(
    "kind",
    [
        lambda report: report.orients_up_to_symmetry and report.steps > 2,
        lambda report: report.mouth.width == FULL_TURN and report.transfer.order == 1,
        lambda report: not report.better_exists and report.mouth.width < report.transfer.period,
        lambda report: report.first_misfit == 1,
        lambda report: report.steps - 2 > (report.first_misfit or 0) > 1,
        lambda report: report.better_exists and report.best_width == report.transfer.period,
    ],
    ids=["orients", "full turn", "best, not all", "misfit 1", "misfit 2 to k - 3", "could orient"],
)
def test_the_cases_are_of_all_kinds(kind):
    """Found, not made small."""
    quickly = settings(max_examples=5000, phases=[Phase.generate])
    find(cases, lambda case: kind(verify_plan(*case)), settings=quickly)


# --- the orientations ----------------------------------------------------------------------------


@given(cases)
def test_the_collapsed_arcs_divide_a_period(case):
    transfer, turns = case
    report = verify_plan(transfer, turns)
    arcs = [item.arc for item in report.collapsed]
    for arc, following in pairwise([*arcs, arcs[0].rotate(transfer.period)]):
        assert ZERO <= arc.start < transfer.period
        assert arc.end == following.start


@settings(max_examples=FEW)
@given(cases, st.lists(angles(), max_size=6))
def test_forward_execution_ends_where_the_report_says(case, samples):
    """Sampled orientations, the first of each arc and those just before its end."""
    transfer, turns = case
    report = verify_plan(transfer, turns)
    ends = [theta for item in report.collapsed for theta in (item.arc.start, item.arc.end - TINY)]
    for theta in samples + ends:
        laps, rest = divmod(theta - report.collapsed[0].arc.start, transfer.period)
        rest += report.collapsed[0].arc.start
        (item,) = (c for c in report.collapsed if c.arc.start <= rest < c.arc.end)
        expected = item.orientation + laps * transfer.period
        assert run_angle(transfer, turns, theta)[-1].reduced() == expected.reduced()


@settings(max_examples=FEW)
@given(cases)
def test_arcs_are_those_of_the_composite(case):
    """No arc of the report can be widened, and each ends in one orientation."""
    transfer, turns = case
    report = verify_plan(transfer, turns)
    whole = composite(transfer, turns)
    assert report.final_orientations == len(whole) * whole.order
    if len(report.collapsed) == len(whole):  # the composite may have a smaller period
        assert [item.arc.start for item in report.collapsed] == list(whole.breaks)
    for item in report.collapsed:
        assert final_orientations(transfer, turns, item.arc) == {item.orientation}
        wider = Arc(item.arc.start - TINY, item.arc.width)
        if item.arc.width < FULL_TURN:
            assert len(final_orientations(transfer, turns, wider)) == 2


@given(cases)
def test_the_mouth_is_the_widest_arc(case):
    transfer, turns = case
    report = verify_plan(transfer, turns)
    widest = max(item.arc.width for item in report.collapsed)
    mouth = next(item for item in report.collapsed if item.arc.width == widest)
    assert (report.mouth, report.final_orientation) == (mouth.arc, mouth.orientation)
    state = report.hyperstate
    assert max(state.widths) == widest
    assert len(state) == report.final_orientations
    assert state.total == FULL_TURN
    assert {item.orientation for item in report.collapsed} <= set(state.orientations)
    assert report.probability == state.probability(state.most_likely())
    assert report.orients_up_to_symmetry is (widest == transfer.period)


@given(cases, st.integers(-3, 3))
def test_full_turns_of_the_gripper_change_nothing(case, laps):
    transfer, turns = case
    report = verify_plan(transfer, turns)
    turned = verify_plan(transfer, [angle + FULL_TURN * laps for angle in turns])
    assert turned.collapsed == report.collapsed
    assert turned.first_misfit == report.first_misfit
    for mine, other in zip(report.margins, turned.margins, strict=True):
        assert (mine.below, mine.above) == (other.below, other.above)


@given(cases, angles())
def test_the_first_angle_only_moves_the_arcs(case, beta):
    transfer, turns = case
    report = verify_plan(transfer, turns)
    turned = verify_plan(transfer, [turns[0] + beta, *turns[1:]])
    found = {item.orientation: item.arc for item in turned.collapsed}
    for item in report.collapsed:
        laps, start = divmod(item.arc.start + beta, transfer.period)
        orientation = (item.orientation - laps * transfer.period).reduced()
        assert found[orientation] == Arc(start, item.arc.width)
    assert turned.probability == report.probability
    assert turned.first_misfit == report.first_misfit


@given(cases)
def test_cumulative_angles_are_sums(case):
    transfer, turns = case
    poses = list(accumulate(turns))
    report = verify_plan(transfer, poses, cumulative=True)
    assert list(report.angles) == turns


# --- margins -------------------------------------------------------------------------------------


@settings(max_examples=FEW)
@given(cases)
def test_margins_are_sharp(case):
    """At `high` and just above `low` the mouth ends where it does; beyond either end, not."""
    transfer, turns = case
    report = verify_plan(transfer, turns)
    goal = {report.final_orientation}
    assert report.margins[0].low is report.margins[0].high is None

    def ends(j, alpha):
        return final_orientations(transfer, [*turns[:j], alpha, *turns[j + 1 :]], report.mouth)

    for j, margin in enumerate(report.margins[1:], start=1):
        assert margin.angle == turns[j]
        assert margin.low < margin.angle <= margin.high
        assert margin.below + margin.above == margin.high - margin.low
        assert ends(j, margin.high) == goal
        assert ends(j, margin.low + TINY) == goal
        if margin.high - margin.low < FULL_TURN:
            assert ends(j, margin.low) != goal
            assert ends(j, margin.high + TINY) != goal
        else:
            assert margin.high - margin.low == FULL_TURN


@given(cases, st.data())
def test_within_a_margin_nothing_changes_and_outside_it_does(case, data):
    transfer, turns = case
    assume(len(turns) > 1)
    report = verify_plan(transfer, turns)
    j = data.draw(st.integers(1, len(turns) - 1))
    alpha, margin = data.draw(angles()), report.margins[j]
    inside = (margin.high - alpha).reduced() < margin.high - margin.low
    found = final_orientations(transfer, [*turns[:j], alpha, *turns[j + 1 :]], report.mouth)
    works = found == {report.final_orientation}
    # A mouth of a full turn has no ends, and may be collapsed in other ranges as well.
    assert works is inside or (works and report.mouth.width == FULL_TURN)


# --- plans of the planner ------------------------------------------------------------------------


@given(problems, ratios.map(abs), st.data())
def test_plans_do_what_they_say(problem, cost_ratio, data):
    steps = data.draw(st.integers(1, problem.geometric_plan().steps))
    plan = problem.plan_of(steps, cost_ratio)
    report = verify_plan(problem.part, plan.angles, cost_ratio)
    assert report.transfer == plan.transfer
    assert report.steps == plan.steps
    assert report.mouth.width == plan.mouth.width
    found = {item.arc: item.orientation for item in report.collapsed}
    assert found[plan.mouth] == plan.final_orientation.reduced()
    assert report.probability == plan.probability
    assert report.probability_up_to_symmetry == plan.probability_up_to_symmetry
    assert report.expected_cost == plan.expected_cost
    assert report.expected_cost_up_to_symmetry == plan.expected_cost_up_to_symmetry
    assert report.orients_up_to_symmetry is plan.orients_up_to_symmetry
    assert report.hyperstate == plan.distribution()
    assert report.best_width == plan.mouth.width
    assert not report.better_exists
    assert report.first_misfit is None
    if report.mouth == plan.mouth:  # there may be another arc as wide
        for margin, action in zip(report.margins[1:], plan.actions[1:], strict=True):
            assert margin.low <= action.low < action.angle <= action.high <= margin.high


@given(problems)
def test_the_other_ends_of_the_ranges_do_as_well(problem):
    plan = problem.geometric_plan()
    highest = [ZERO, *(action.high for action in plan.actions[1:])]
    report = verify_plan(plan.transfer, highest)
    assert report.orients_up_to_symmetry
    assert report.first_misfit is None


# --- against phase I -----------------------------------------------------------------------------


@given(cases)
def test_no_plan_of_the_same_length_collapses_more(case):
    """Thm 5.1; refuted by any list of angles that does better."""
    transfer, turns = case
    report = verify_plan(transfer, turns)
    assert report.mouth.width <= report.best_width
    assert report.better_exists is (report.mouth.width != report.best_width)
    assert report.best_probability >= report.probability
    assert (report.first_misfit is None) is not report.better_exists


def slow_misfit(transfer, turns):
    """Return the first misfit by its definition, on arcs of exact angles."""
    steps, period = len(turns), transfer.period
    breaks, values = transfer.lifted_breaks, transfer.lifted_values
    widest, bound = {}, None
    for i in range(1, steps + 1):
        arcs = []
        for first in range(len(transfer)):
            last = first
            while bound is not None and values[last + 1] - values[first] < bound:
                last += 1
            arcs.append((breaks[last + 1] - breaks[first], first, last))
        bound = max(width for width, _, _ in arcs)
        widest[i] = [(first, last) for width, first, last in arcs if width == bound]
    images = [(values[first], values[last]) for first, last in widest[steps]]
    for j in range(1, steps):
        kept = []
        for start, end in images:
            for first, last in widest[steps - j]:
                width = breaks[last + 1] - breaks[first]
                offset = (start - turns[j] - breaks[first]) % period
                if offset + (end - start) < width:
                    kept.append((transfer(start - turns[j]), transfer(end - turns[j])))
        if not kept:
            return j
        images = kept
    return None


@given(cases)
def test_the_first_misfit_is_the_one_defined(case):
    transfer, turns = case
    report = verify_plan(transfer, turns)
    if report.better_exists:
        assert report.first_misfit == slow_misfit(transfer, turns)
        assert 1 <= report.first_misfit < len(turns)


@given(problems, st.data())
def test_a_misplaced_angle_is_named_not_an_earlier_one(problem, data):
    """One angle of a plan is moved out of its range; those before it are not to blame."""
    plan = problem.geometric_plan()
    assume(plan.steps > 1)
    j = data.draw(st.integers(1, plan.steps - 1))
    action = plan.actions[j]
    wrong = data.draw(st.sampled_from([action.low, action.high + TINY, action.angle + TINY]))
    report = verify_plan(plan.transfer, [*plan.angles[:j], wrong, *plan.angles[j + 1 :]])
    assert report.first_misfit is None or report.first_misfit >= j
    if wrong == action.angle + TINY:
        assert report.orients_up_to_symmetry


# --- text ----------------------------------------------------------------------------------------


def as_text(angle):
    exact = angle.rational_turns
    if exact is not None:
        return str(exact * 360)
    x, y = angle.direction
    return f"({x}, {y})"


@given(st.lists(angles(), min_size=1), st.sampled_from([",", ", ", " ", "\n", " , "]))
def test_angles_are_read_back(listed, separator):
    listed = [
        angle if angle.rational_turns is not None else Angle(0, angle.direction) for angle in listed
    ]
    rational = [angle for angle in listed if angle.turn_part.denominator == 1]
    text = separator.join(map(as_text, rational))
    if rational:
        assert list(parse_angles(text)) == rational
