"""Laws of part errors: what is certain holds for perturbed parts, worst directions among them."""

from __future__ import annotations

from fractions import Fraction

import pytest
from gmpy2 import mpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from stochgeom.errors import InvalidPartError
from stochgeom.exact.angles import HALF_TURN, QUARTER_TURN, Angle
from stochgeom.exact.arcs import ClosedArc
from stochgeom.exact.outer_arcs import units_around
from stochgeom.feeding.execution import composite, run_arc
from stochgeom.feeding.nearby_courses import NearbyCourses
from stochgeom.feeding.part_errors import tolerance_of
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.feeding.verification import verify_plan
from stochgeom.geometry.center_error import CenterError
from stochgeom.geometry.contact_zones import push_zones, squeeze_zones
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.near_contacts import NearbyParts
from stochgeom.geometry.part import Part
from stochgeom.transfer.push import push_function
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import (
    circle_parts,
    hulls,
    nearly_regular,
    parts,
    rational_orientations,
    rational_parts,
)

FEW = settings().max_examples // 4
"""Laws that look for a tolerance."""

WHOLE = [(1, 0, 1), (3, 4, 5), (4, 3, 5), (5, 12, 13), (12, 5, 13)]
QUADRANT = [(Fraction(a, c), Fraction(b, c)) for a, b, c in WHOLE]
DIRECTIONS = [p for x, y in QUADRANT for p in ((x, y), (-y, x), (-x, -y), (y, -x))]
"""Points of the unit circle."""

any_part = st.one_of(parts(), hulls(), rational_parts(), circle_parts(), nearly_regular(most=7))
errors = st.sampled_from([mpq(1, 10**6), mpq(1, 300), mpq(1, 60), mpq(1, 16), mpq(1, 4)])
ACTIONS = {"squeeze": squeeze_function, "push-grasp": push_grasp_function}


@st.composite
def perturbed(draw, part, epsilon):
    """A part whose vertices are at most epsilon off, most of them just as far."""
    moves = st.sampled_from([1, 1, 1, Fraction(1, 2), 0])
    corners, moved = {}, []
    for x, y in part.vertices:
        # Equal vertices move together.
        if (x, y) not in corners:
            dx, dy = draw(st.sampled_from(DIRECTIONS))
            reach = mpq(epsilon) * mpq(draw(moves))
            corners[x, y] = (x + reach * mpq(dx), y + reach * mpq(dy))
        moved.append(corners[x, y])
    center = part.center_of_mass if part.has_given_center else None
    try:
        return Part(moved, center)
    except InvalidPartError:
        assume(False)


def extents(part, theta, *, push):
    """Return the least and the largest one-sided slope at theta, by looking at all vertices."""
    c, s = theta.direction
    turned = [(c * x - s * y, s * x + c * y) for x, y in part.vertices]
    low, high = min(y for _, y in turned), max(y for _, y in turned)
    lower = [x for x, y in turned if y == low]
    if push:
        cx, cy = part.center_of_mass
        upper = [c * cx - s * cy]
    else:
        upper = [x for x, y in turned if y == high]
    return min(upper) - max(lower), max(upper) - min(lower)


@st.composite
def zones_and_a_part(draw):
    """A part, its zones, whether they are those of the push, and a part nearby."""
    part, push = draw(any_part), draw(st.booleans())
    if draw(st.booleans()):
        part = Part(part.vertices, part.hull.points.pairs()[0])  # a given centre, on the hull
        push = False
    size = max(abs(v) for p in part.vertices for v in p)
    epsilon = draw(errors) * size
    near = NearbyParts(part)
    if push:
        assume(part.center_of_mass_side > 0)
        center = CenterError(part).bound(epsilon)
        assume(center is not None)
        zones = push_zones(near, epsilon, center)
    else:
        zones = squeeze_zones(near, epsilon)
    assume(zones is not None)
    return zones, push, draw(perturbed(part, epsilon))


@given(zones_and_a_part(), rational_orientations)
def test_certain_slopes(case, theta):
    zones, push, other = case
    least, largest = extents(other, theta, push=push)
    low, high = units_around(theta)
    if zones.not_rising.around(low) is None and zones.not_rising.around(high) is None:
        assert least > 0
    if zones.not_falling.around(low) is None and zones.not_falling.around(high) is None:
        assert largest < 0


@given(zones_and_a_part())
def test_parts_rest_in_rests(case):
    zones, push, other = case
    minima = push_function(other).values if push else DiameterFunction(other).minima
    for theta in minima:
        low, high = units_around(theta)
        assert zones.rest_arcs.first_from(low) <= high


@given(zones_and_a_part(), rational_orientations, rational_orientations)
def test_images_hold_the_ends_of_all_parts(case, theta, other_theta):
    zones, push, other = case
    first, last = sorted([theta, other_theta])
    s = push_function(other) if push else squeeze_function(other)
    low, high = zones.image((units_around(first)[0], units_around(last)[1]))
    assert low <= units_around(s(first))[1]
    assert units_around(s(last))[0] <= high


@given(any_part, errors, st.data())
def test_the_centroid_moves_no_farther_than_its_bound(part, epsilon, data):
    bound = CenterError(part).bound(epsilon)
    assume(bound is not None)
    other = data.draw(perturbed(part, epsilon))
    dx, dy = (a - b for a, b in zip(other.centroid, part.centroid, strict=True))
    assert dx * dx + dy * dy <= bound * bound


def ends_in(report, plan, transfer, turns=None):
    """Assert that a part ends where the report says, after other turns if they are given."""
    turns = plan.angles if turns is None else turns
    finals = report.finals
    if plan.action_name == "squeeze":  # half a turn on, the same
        finals = (*finals, *(ClosedArc(f.start + HALF_TURN, f.width) for f in finals))
    if plan.orients_up_to_symmetry:
        whole = composite(transfer, turns)
        ends = {whole.lifted_values[k].reduced() for k in range(len(whole) * whole.order)}
        reached = [sum((end - f.start).reduced() <= f.width for end in ends) for f in finals]
        assert sum(reached) == len(ends)
        assert not report.one_orientation or set(reached) == {1}
        return
    for starts, final in zip(report.starts, report.finals, strict=True):
        last = run_arc(transfer, turns, starts)[-1]
        assert (last.start - final.start).reduced() + last.width <= final.width
        assert not report.one_orientation or not last.width


@st.composite
def plans(draw, pool=any_part):
    """An optimal plan, or one that orients up to symmetry, and its part."""
    part, action = draw(pool), draw(st.sampled_from(sorted(ACTIONS)))
    assume(action == "squeeze" or part.center_of_mass_side > 0)
    problem = FeedingProblem(part, action)
    assume(problem.preimages.of_steps(9).is_period)
    return problem.optimal_plan() if draw(st.booleans()) else problem.geometric_plan()


@settings(max_examples=FEW)
@given(plans(), st.sampled_from([1, 1, Fraction(1, 2), Fraction(1, 16)]), st.data())
def test_plans_work_for_all_parts_within_their_tolerance(plan, share, data):
    epsilon = tolerance_of(plan) * mpq(share)
    assume(epsilon)
    report = NearbyCourses.of_plan(plan, plan.part).report(epsilon)
    assert report.proven
    for _ in range(3):
        other = data.draw(perturbed(plan.part, epsilon))
        ends_in(report, plan, ACTIONS[plan.action_name](other))


@settings(max_examples=FEW)
@given(any_part, st.sampled_from(sorted(ACTIONS)), st.data())
def test_gripper_errors_come_on_top(part, action, data):
    assume(action == "squeeze" or part.center_of_mass_side > 0)
    delta = Angle.from_degrees(data.draw(st.sampled_from(["1/100", "1/2", 3])))
    problem = FeedingProblem(part, action, gripper_error=delta)
    bound = problem.largest_gripper_error()
    assume(bound is None or bound.allows(delta))
    plan = problem.optimal_plan()
    epsilon = tolerance_of(plan)
    assume(epsilon)
    report = NearbyCourses.of_plan(plan, part).report(epsilon)
    off = [data.draw(st.sampled_from([-delta, Angle(), delta])) for _ in plan.angles[1:]]
    turns = [plan.angles[0], *(a + b for a, b in zip(plan.angles[1:], off, strict=True))]
    transfer = ACTIONS[action](data.draw(perturbed(part, epsilon)))
    ends_in(report, plan, transfer, turns)


@settings(max_examples=FEW)
@given(plans())
def test_a_whole_period_works_without_exception(plan):
    assume(plan.mouth.width == plan.transfer.period)
    epsilon = tolerance_of(plan)
    assume(epsilon)
    report = NearbyCourses.of_plan(plan, plan.part).report(epsilon)
    turn = HALF_TURN if plan.action_name == "squeeze" else HALF_TURN + HALF_TURN
    assert sum((arc.width for arc in report.starts), Angle()) == turn
    assert report.probability == mpq(1, plan.transfer.order)


@settings(max_examples=FEW)
@given(plans(), st.sampled_from([Fraction(1, 3), Fraction(9, 10), Fraction(101, 100), 2]))
def test_the_tolerance_divides_what_is_proven(plan, share):
    epsilon, courses = tolerance_of(plan), NearbyCourses.of_plan(plan, plan.part)
    assert tolerance_of(plan, one_orientation=True) <= epsilon
    if epsilon:
        assert courses.report(epsilon * mpq(share)).proven == (share < 1)
    else:
        assert not courses.report(mpq(1, 10**9)).proven


@settings(max_examples=FEW)
@given(plans(), st.sampled_from([Fraction(1, 2), 1, 2]))
def test_verification_agrees(plan, share):
    epsilon = tolerance_of(plan) * mpq(share)
    report = verify_plan(plan.part, plan, vertex_error=epsilon).part_errors
    assert report == NearbyCourses.of_plan(plan, plan.part).report(epsilon)
    assert report.proven == (share <= 1 or not epsilon)
    assert bool(report.starts) == report.proven == (report.reason is None)


@settings(max_examples=FEW)
@given(
    plans(), st.sampled_from([(1, 0), (3, 4), (-5, 12)]), st.sampled_from([1, 3, Fraction(1, 7)])
)
def test_tolerances_scale_with_the_part(plan, direction, factor):
    x, y = direction
    larger = plan.part.multiply((x * factor, y * factor)).translate(5, "1/3")
    problem = FeedingProblem(larger, plan.action_name)
    turned = problem.plan_of(plan.steps)
    # Ties may choose another plan for the turned part; the same plan has the same tolerance.
    assume(turned.angles == plan.angles)
    shift = turned.mouth.start - plan.mouth.start
    assume((shift + Angle(0, direction)).reduced() == Angle())
    length = mpq(factor) * {1: 1, 25: 5, 169: 13}[x * x + y * y]
    ratio = tolerance_of(turned) / (length * (tolerance_of(plan) or 1))
    assert not ratio or mpq(1023, 1025) <= ratio <= mpq(1025, 1023)


@pytest.mark.parametrize("action", sorted(ACTIONS))
def test_ends_of_exact_reports(action):
    plan = FeedingProblem([(0, 0), (9, 0), (10, 4), (2, 5)], action).geometric_plan()
    report = NearbyCourses.of_plan(plan, plan.part).report(0)
    assert report.proven
    assert report.one_orientation
    ends_in(report, plan, plan.transfer)
    assert all(final.width < QUARTER_TURN for final in report.finals)
