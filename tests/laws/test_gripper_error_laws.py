"""Laws of inexact grippers: adversarial execution, monotony, and sharp bounds by brute force."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise, product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.errors import NoPlanError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding.execution import run_arc
from stochgeom.feeding.gripper_error import (
    ErrorBound,
    largest_gripper_error,
    least_slack,
    most_tolerant_chain,
)
from stochgeom.feeding.preimages import Preimages
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import hulls, orientations, parts, step_functions

SLIGHT = Angle(0, (2**40, 1))
"""An angle of about 2**-40: less than any slack on these grids differs from another."""

FEW = settings().max_examples // 2
"""Brute force takes long."""

maps = st.one_of(step_functions(), parts().map(squeeze_function), parts().map(push_grasp_function))
small_maps = maps.filter(lambda s: len(s) <= 6)
errors = st.sampled_from(
    [Angle.from_degrees(d) for d in (0, "0.5", 1, "2.5", 5, "7.5", 10, 15, 22, 30)]
    + [Angle(0, (7, 1)), Angle(0, (31, 2))]
)


@st.composite
def goals(draw, s):
    """Some steps that the last action may end with, mostly all."""
    if draw(st.integers(0, 2)):
        return None
    return tuple(sorted(draw(st.sets(st.integers(0, len(s) - 1), min_size=1, max_size=2))))


@st.composite
def situations(draw, of=maps):
    """A map, an error, and final steps."""
    s = draw(of)
    return s, draw(errors), draw(goals(s))


def problem_of(s, delta, final=None):
    """Return the problem with the final steps set, whatever angles they are at."""
    problem = FeedingProblem.of_transfer(s, gripper_error=delta)
    problem.__dict__["final_steps"] = final
    return problem


# --- adversarial execution -----------------------------------------------------------------------


def sign_patterns(count, data):
    """Return every pattern of signs for a few actions, eight random ones for more."""
    if count <= 5:
        return list(product((-1, 1), repeat=count))
    signs = st.lists(st.sampled_from((-1, 1)), min_size=count, max_size=count)
    return [data.draw(signs) for _ in range(8)]


@given(situations(), st.data(), orientations)
def test_every_action_may_be_off_by_delta_either_way(situation, data, first_error):
    s, delta, final = situation
    problem = problem_of(s, delta, final)
    for preimage in problem.preimages:
        plan = problem.plan_of(preimage.steps)
        assert plan.verify()
        for signs in sign_patterns(plan.steps - 1, data):
            angles = [a + sign * delta for a, sign in zip(plan.angles[1:], signs, strict=True)]
            # The first turn is random, so that its error only moves the mouth.
            mouth = plan.mouth.rotate(first_error)
            last = run_arc(s, [first_error, *angles], mouth)[-1]
            assert last.width == ZERO
            assert last.start == plan.final_orientation


@given(situations(), st.data())
def test_an_error_almost_as_large_as_the_bound_is_borne(situation, data):
    """The angles have to be the middles of their ranges to nine decimals then."""
    s, _, final = situation
    bound = largest_gripper_error(s, final)
    if bound is None:
        return
    delta = Angle.from_degrees(bound.degrees(9)) - Angle.from_degrees("0.000000001")
    if delta < ZERO:
        return
    plan = problem_of(s, delta, final).geometric_plan()
    for signs in sign_patterns(plan.steps - 1, data):
        angles = [a + sign * delta for a, sign in zip(plan.angles[1:], signs, strict=True)]
        last = run_arc(s, [ZERO, *angles], plan.mouth)[-1]
        assert (last.width, last.start) == (ZERO, plan.final_orientation)


@given(situations(), st.lists(st.integers(0, 71), min_size=1, max_size=4), st.data())
def test_under_another_prior_the_first_action_may_be_off_as_well(situation, places, data):
    s, delta, final = situation
    weight = Fraction(1, len(places))
    prior = DiscretePrior([(str(5 * k), weight) for k in places])
    problem = FeedingProblem.of_transfer(s, gripper_error=delta, prior=prior)
    problem.__dict__["final_steps"] = final
    for preimage in problem.preimages:
        if problem.placement(preimage.steps) is None:
            assert preimage.width <= 2 * delta
            continue
        plan = problem.plan_of(preimage.steps)
        assert plan.verify()
        whole = preimage.width == FULL_TURN
        assert plan.mouth.width == preimage.width - (ZERO if whole else 2 * delta)
        for signs in sign_patterns(plan.steps, data):
            angles = [a + sign * delta for a, sign in zip(plan.angles, signs, strict=True)]
            # A mouth of a full turn begins where its first action makes it begin.
            mouth = Arc(angles[0] + preimage.arc.start, FULL_TURN) if whole else plan.mouth
            last = run_arc(s, angles, mouth)[-1]
            assert last.width == ZERO
            assert last.start == plan.final_orientation


@given(situations())
def test_nominal_angles_leave_room_on_both_sides(situation):
    s, delta, final = situation
    problem = problem_of(s, delta, final)
    for preimage in problem.preimages:
        plan = problem.plan_of(preimage.steps)
        for action in plan.actions[1:]:
            assert action.low < action.angle - delta
            assert action.angle + delta <= action.high
        if plan.steps > 1:
            assert plan.margin >= delta
            assert plan.error_bound.allows(delta)
            assert plan.error_bound.slack >= 2 * plan.margin
        else:
            assert plan.margin is plan.error_bound is None


@given(situations(), st.data())
def test_errors_below_the_margin_are_borne(situation, data):
    s, delta, final = situation
    problem = problem_of(s, delta, final)
    plan = problem.plan_of(len(list(problem.preimages)))
    if plan.steps == 1:
        return
    lower = min(a.angle - a.low for a in plan.actions[1:])
    upper = min(a.high - a.angle for a in plan.actions[1:])
    assert plan.margin == min(lower, upper)
    error = plan.margin if upper < lower else plan.margin - SLIGHT
    for signs in sign_patterns(plan.steps - 1, data):
        angles = [a + sign * error for a, sign in zip(plan.angles[1:], signs, strict=True)]
        last = run_arc(s, [ZERO, *angles], plan.mouth)[-1]
        assert (last.width, last.start) == (ZERO, plan.final_orientation)


# --- larger errors -------------------------------------------------------------------------------


@given(maps, errors, errors, st.data())
def test_a_larger_error_never_does_better(s, one, other, data):
    """No cheaper plan, no wider preimage, no plan up to symmetry where there was none."""
    smaller, larger = sorted((one, other))
    final = data.draw(goals(s))
    better, worse = problem_of(s, smaller, final), problem_of(s, larger, final)
    for steps in range(1, len(list(worse.preimages)) + 2):
        assert worse.preimages.of_steps(steps).width <= better.preimages.of_steps(steps).width
    for c in (0, 1, 10):
        assert better.optimal_plan(c).expected_cost <= worse.optimal_plan(c).expected_cost
    assert better.preimages.complete >= worse.preimages.complete


@given(situations())
def test_the_chain_changes_at_its_least_slack_and_not_before(situation):
    s, delta, final = situation
    found = list(Preimages(s, 2 * delta, final))
    slack = least_slack(found)
    if slack is None:
        return
    assert slack > 2 * delta
    before = list(Preimages(s, max(2 * delta, slack - SLIGHT), final))
    assert [p.width for p in before] == [p.width for p in found]
    after = list(Preimages(s, slack, final))
    assert after != found
    new = least_slack(after)
    assert new is None or new > slack


@given(situations())
def test_the_largest_error_is_told_when_there_is_no_plan(situation):
    s, delta, final = situation
    problem, bound = problem_of(s, delta, final), largest_gripper_error(s, final)
    if bound is None or bound.allows(delta):
        plan = problem.geometric_plan()
        assert plan.orients_up_to_symmetry
        assert plan.probability_up_to_symmetry.rational == 1
        return
    with pytest.raises(NoPlanError, match="accepted: less than") as caught:
        problem.geometric_plan()
    told = caught.value.message.rpartition("less than ")[2].rstrip("°")
    assert told == bound.degrees()
    if Fraction(told):
        enough = Angle.from_degrees(told) - SLIGHT
        assert problem_of(s, enough, final).geometric_plan().verify()


# --- phase I by brute force ----------------------------------------------------------------------


class Arcs:
    """All arcs between breaks, from each break of one period, with exact angles only."""

    def __init__(self, s, final=None):
        m, period = len(s), s.period
        breaks, values = list(s.breaks), list(s.values)
        breaks += [b + period for b in breaks] + [b + period + period for b in breaks]
        values += [v + period for v in values]
        self.period = period
        self.all = [
            (breaks[j + 1] - breaks[i], values[j] - values[i])
            for i in range(m)
            for j in range(i, i + m)
        ]
        self.arcs = [(breaks[i], *self.all[i * m + d]) for i in range(m) for d in range(m)]
        self.first = [
            (breaks[i], breaks[i + 1] - breaks[i]) for i in (range(m) if final is None else final)
        ]

    def widths(self, spread, fits, longest):
        """Return the widest arcs of 1, 2, ... steps, of images that fit with the spread."""
        found = [max(width for _, width in self.first)]
        while len(found) < longest:
            fitting = [width for width, image in self.all if fits(image + spread, found[-1])]
            if not fitting or max(fitting) <= found[-1]:
                break
            found.append(max(fitting))
        return found

    def chain(self, spread):
        """Return (start, width, image width) for each stage, by the stated rules."""
        width = max(width for _, width in self.first)
        found = [(min(b for b, w in self.first if w == width), width, ZERO)]
        while found[-1][1] < self.period:
            fitting = [arc for arc in self.arcs if arc[2] + spread < found[-1][1]]
            best = max((width for _, width, _ in fitting), default=ZERO)
            if best <= found[-1][1]:
                break
            image, start = min((image, start) for start, width, image in fitting if width == best)
            found.append((start, best, image))
        return found

    def critical(self):
        """Return every slack that any action can have, decreasing."""
        slacks = {width - image for width, _ in self.all for _, image in self.all}
        return sorted((slack for slack in slacks if slack > ZERO), reverse=True)


def strictly(image, width):
    return image < width


def just(image, width):
    """With every smaller spread it is strictly."""
    return image <= width


@given(situations(small_maps))
def test_phase_one_with_error_and_goal_by_brute_force(situation):
    s, delta, final = situation
    found = [(p.arc.start, p.width, p.image_width) for p in Preimages(s, 2 * delta, final)]
    assert found == Arcs(s, final).chain(2 * delta)


@settings(max_examples=FEW)
@given(situations(small_maps))
def test_the_largest_error_is_sharp(situation):
    """A chain to a period for spreads just below it, none at it; no other critical slack is."""
    s, _, final = situation
    bound, arcs = largest_gripper_error(s, final), Arcs(s, final)
    if bound is None:
        assert arcs.widths(ZERO, strictly, 1) == [s.period]
        return
    assert arcs.widths(bound.slack - SLIGHT, strictly, 10**6)[-1] == s.period
    assert arcs.widths(bound.slack, strictly, 10**6)[-1] < s.period
    best = next(c for c in arcs.critical() if arcs.widths(c, just, 10**6)[-1] == s.period)
    assert bound == ErrorBound(best)


@settings(max_examples=FEW)
@given(st.one_of(hulls(most=7).map(squeeze_function), step_functions()), st.data())
def test_most_tolerant_plans_by_all_critical_slacks(s, data):
    final = data.draw(goals(s))
    arcs = Arcs(s, final)
    for preimage in Preimages(s, final_steps=final):
        steps = preimage.steps
        chain = most_tolerant_chain(s, steps, final)
        assert [p.steps for p in chain] == list(range(1, steps + 1))
        assert chain[-1].width == preimage.width
        assert final is None or chain[0].first in final
        if steps == 1:
            assert least_slack(chain) is None
            continue
        for best in arcs.critical():
            widths = arcs.widths(best, just, steps)
            if len(widths) == steps and widths[-1] == preimage.width:
                break
        assert least_slack(chain) == best
        assert all(here.image_width < goal.width for goal, here in pairwise(chain))


# --- decimals ------------------------------------------------------------------------------------


@given(maps, st.integers(0, 12))
def test_bounds_are_rounded_down(s, digits):
    bound = largest_gripper_error(s)
    if bound is None:
        return
    shown = Fraction(bound.degrees(digits))
    unit = Fraction(1, 10**digits)
    assert Angle.from_degrees(2 * shown) <= bound.slack < Angle.from_degrees(2 * (shown + unit))
    assert len(bound.degrees(digits).partition(".")[2]) == digits
