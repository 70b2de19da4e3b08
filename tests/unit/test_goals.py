"""`stochgeom.feeding.goals`: which orientation a goal names, and the best plans that end there."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.errors import GoalError, InputError, StochgeomError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.ratios import TurnRatio
from stochgeom.feeding.action_classes import action_classes
from stochgeom.feeding.goals import MOST_STABLE, NEAR, final_steps
from stochgeom.feeding.planner import orient_up_to_symmetry, plan_feeding, plan_transfer
from stochgeom.feeding.preimages import Preimages
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.feeding.stability import most_stable_grasps, stable_grasps
from stochgeom.geometry.part import Part
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction
from tests.strategies import hulls, orientations, parts, step_functions

RECTANGLE = Part([(0, 0), (3, 0), (3, 2), (0, 2)])
S = squeeze_function(RECTANGLE)  # values 90 and 180, period 180

maps = st.one_of(step_functions(), parts().map(squeeze_function), parts().map(push_grasp_function))
FEW = settings().max_examples // 2


def grid(breaks, values):
    return StepFunction(*([Angle.from_degrees(d) for d in row] for row in (breaks, values)))


# --- which orientation is meant ------------------------------------------------------------------


class TestNames:
    @pytest.mark.parametrize("goal", ["90", 90, "270", "-90", QUARTER_TURN, "450", Fraction(90)])
    def test_final_orientations_modulo_the_period(self, goal):
        assert final_steps(goal, S, None) == (0,)

    @pytest.mark.parametrize("goal", ["0", 180, "360", ZERO, FULL_TURN, "-180"])
    def test_the_other_one(self, goal):
        assert final_steps(goal, S, None) == (1,)

    @pytest.mark.parametrize("goal", ["89.5", "90.5", "90.4999", "89.6", "270.5", "-89.5"])
    def test_within_half_a_degree(self, goal):
        assert final_steps(goal, S, None) == (0,)

    @pytest.mark.parametrize("goal", ["179.6", "0.4", "-0.5", "0.5"])
    def test_on_both_sides_of_the_seam(self, goal):
        assert final_steps(goal, S, None) == (1,)

    @pytest.mark.parametrize("goal", ["90.5001", "89.4999", "45", "1", QUARTER_TURN + 2 * NEAR])
    def test_farther_away(self, goal):
        with pytest.raises(GoalError, match="from the nearest final orientation; accepted, mod"):
            final_steps(goal, S, None)

    def test_the_message_lists_what_there_is(self):
        with pytest.raises(GoalError) as caught:
            final_steps("45", S, None)
        assert caught.value.message == (
            "45.0000° is 45.0000° from the nearest final orientation; accepted, modulo "
            "180.0000°: 0.0000°, 90.0000°"
        )
        assert caught.value.where == "goal"

    def test_a_long_list_is_cut(self):
        many = grid(range(0, 360, 20), [5, *range(26, 366, 20)])
        with pytest.raises(GoalError) as caught:
            final_steps("15", many, None)
        listed = caught.value.message.partition(": ")[2].split(", ")
        assert len(listed) == 13
        assert (listed[0], listed[-1]) == ("5.0000°", "...")

    def test_the_nearest_of_close_ones(self):
        close = grid([0, 10, 200], ["90", "90.6", "300"])
        assert final_steps("90.2", close, None) == (0,)
        assert final_steps("90.4", close, None) == (1,)
        assert final_steps("90", close, None) == (0,)

    def test_two_that_are_equally_near(self):
        close = grid([0, 10, 200], ["90", "90.6", "300"])
        assert final_steps("90.3", close, None) == (0, 1)

    def test_as_tables_show_them(self):
        """Every final orientation is named by its degrees, rounded to whole ones at least."""
        for name in ("house", "4gon", "key"):
            s = squeeze_function(catalogue_part(name))
            for k, value in enumerate(s.values):
                for digits in (0, 2, 6):
                    assert k in final_steps(value.degrees(digits), s, None)

    @pytest.mark.parametrize(
        "goal",
        ["north", "", "nan", "inf", 90.0, float("nan"), None, [], "most", "Most stable", "1°"],
    )
    def test_what_is_no_angle(self, goal):
        with pytest.raises(GoalError, match="; accepted: an angle in degrees, or 'most st") as one:
            final_steps(goal, S, RECTANGLE)
        assert str(one.value).count("accepted") == 1

    def test_no_goals_at_all(self):
        with pytest.raises(GoalError, match="no goals; accepted: one or more, or None for any"):
            plan_feeding(RECTANGLE, goal=())

    def test_every_way_in(self):
        for call in (plan_feeding, orient_up_to_symmetry):
            with pytest.raises(GoalError):
                call(RECTANGLE, goal="45")
        with pytest.raises(GoalError):
            plan_transfer(S, goal="45")
        with pytest.raises(GoalError):
            _ = FeedingProblem(RECTANGLE, goal="45").preimages


class TestMostStable:
    def test_of_the_rectangle(self):
        assert final_steps(MOST_STABLE, S, RECTANGLE) == (1,)
        plan = plan_feeding(RECTANGLE, goal="most stable")
        assert plan.final_orientation % HALF_TURN == ZERO

    def test_without_a_part(self):
        with pytest.raises(GoalError, match="there is only a transfer function; accepted: an ang"):
            plan_transfer(S, goal=MOST_STABLE)

    @given(parts(), st.sampled_from(["squeeze", "push-grasp"]))
    def test_plans_end_in_a_most_stable_grasp_that_the_action_reaches(self, part, action):
        """A push-grasp need not reach the most stable grasp of all."""
        plan = orient_up_to_symmetry(part, action=action, goal=MOST_STABLE)
        squeeze = squeeze_function(part)
        psi = {g.orientation: g.stability for g in stable_grasps(part)}
        final = plan.final_orientation % squeeze.period
        assert psi[final] == max(psi[v % squeeze.period] for v in plan.transfer.values)
        if action == "squeeze":
            assert final in {g.orientation for g in most_stable_grasps(part)}
        assert squeeze(final) == final


# --- plans that end there ------------------------------------------------------------------------


@given(maps, st.data(), orientations)
def test_every_start_in_the_mouth_ends_in_the_goal(s, data, theta):
    """Every goal can be reached, from a whole period in the end."""
    k = data.draw(st.integers(0, len(s) - 1))
    problem = FeedingProblem.of_transfer(s, goal=s.values[k])
    assert problem.final_steps == (k,)
    for plan in [problem.geometric_plan(), problem.optimal_plan()]:
        assert (plan.final_orientation - s.values[k]) % s.period == ZERO
        assert plan.verify()
        inside = plan.mouth.start + (theta - plan.mouth.start) % s.period
        if inside < plan.mouth.end:
            assert plan.execute(inside)[-1] == plan.final_orientation
        assert plan.execute(plan.mouth.start)[-1] == plan.final_orientation
    assert problem.geometric_plan().orients_up_to_symmetry


@given(maps, st.data())
def test_without_a_goal_nothing_is_wider(s, data):
    k = data.draw(st.integers(0, len(s) - 1))
    any_end, chosen = Preimages(s), Preimages(s, final_steps=(k,))
    for preimage in chosen:
        assert preimage.width <= any_end.of_steps(preimage.steps).width
    # One more step makes up for any goal: it may begin with the widest step.
    for preimage in any_end:
        assert preimage.width <= chosen.of_steps(preimage.steps + 1).width


def widest_by_hyperstates(s, goal, steps, most=4000):
    """Return the widest arcs that 1 to `steps` actions collapse into a goal, all plans tried.

    After some actions, the initial step j has become state map[j] modulo m. None if there are too
    many maps.
    """
    m, letters = len(s), list(action_classes(s).merged)
    reached, found = {tuple(range(m))}, []
    for _ in range(steps):
        best = ZERO
        for states in reached:
            ends = [s.widths[j] for j, state in enumerate(states) if state == goal]
            best = max(best, sum(ends, start=ZERO))
        found.append(best)
        reached = {
            tuple(letter[state] for state in states) for states in reached for letter in letters
        }
        if len(reached) > most:
            break
    return found


@settings(max_examples=FEW)
@given(st.one_of(hulls(most=6).map(squeeze_function), step_functions()), st.data())
def test_no_search_finds_a_wider_arc_that_ends_there(s, data):
    k = data.draw(st.integers(0, len(s) - 1))
    chosen = Preimages(s, final_steps=(k,))
    for steps, width in enumerate(widest_by_hyperstates(s, k, 4), start=1):
        assert width == chosen.of_steps(steps).width


@settings(max_examples=FEW)
@given(hulls(most=5), st.data(), st.sampled_from([0, Fraction(1, 2), 1, 4]))
def test_the_optimal_plan_is_the_cheapest_of_all_that_end_there(part, data, c):
    s = squeeze_function(part)
    k = data.draw(st.integers(0, len(s) - 1))
    plan = plan_feeding(part, c, goal=s.values[k])
    for steps, width in enumerate(widest_by_hyperstates(s, k, 4), start=1):
        cost = TurnRatio(steps + Fraction(c), width, inverse=True)
        assert plan.expected_cost <= cost
        assert plan.steps <= steps or plan.expected_cost < cost


def test_the_rectangle_upright():
    """One squeeze ends upright for 67.38 degrees only; two steps do it for the whole period."""
    problem = FeedingProblem(RECTANGLE, goal="90")
    assert [p.width.degrees(2) for p in problem.preimages] == ["67.38", "112.62", "180.00"]
    assert [problem.expected_cost(i).decimal(2) for i in (1, 2, 3)] == ["10.69", "9.59", "8.00"]
    assert problem.optimal_plan().steps == 3
    assert problem.geometric_plan().final_orientation == QUARTER_TURN


def test_goals_and_gripper_errors_together():
    plan = orient_up_to_symmetry(RECTANGLE, goal="90", gripper_error=5)
    assert plan.final_orientation % HALF_TURN == QUARTER_TURN
    assert plan.error_bound.allows(Angle.from_degrees(5))
    with pytest.raises(StochgeomError, match="accepted: less than"):
        orient_up_to_symmetry(RECTANGLE, goal="90", gripper_error=12)


# --- any transfer function -----------------------------------------------------------------------


class TestPlanTransfer:
    """Thesis 5.10: all that planning asks is a monotone step map that repeats."""

    @given(maps)
    def test_the_plan_works(self, s):
        plan = plan_transfer(s)
        assert plan.verify()
        assert plan.part is None
        problem = FeedingProblem.of_transfer(s)
        costs = [problem.expected_cost(p.steps) for p in problem.preimages]
        assert plan.expected_cost == min(costs)

    @given(parts())
    def test_a_push_grasp_map_is_planned_like_the_action(self, part):
        by_map, by_name = (
            plan_transfer(push_grasp_function(part)),
            plan_feeding(part, action="push-grasp"),
        )
        assert by_map.preimages == by_name.preimages
        assert by_map.actions == by_name.actions
        assert by_map.expected_cost == by_name.expected_cost
        assert (by_map.action_name, by_name.action_name) == ("action", "push-grasp")

    def test_values_outside_their_own_steps(self):
        s = grid([0, 100, 200], [300, 310, 570])
        for k in range(3):
            assert not s.lifted_breaks[k] <= s.lifted_values[k] < s.lifted_breaks[k + 1]
        plan = plan_transfer(s, 10)
        assert plan.orients_up_to_symmetry
        assert plan.probability.rational == 1
        assert plan.verify()

    @pytest.mark.parametrize("value", [None, 5, "house", [(0, 0), (1, 0), (0, 1)], RECTANGLE])
    def test_what_is_no_step_function(self, value):
        with pytest.raises(InputError, match="is no StepFunction; accepted: one, such as"):
            plan_transfer(value)
