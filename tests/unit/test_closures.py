"""The closure of two arcs that a plan collapses (thesis Lemma 5.1 and Def. 5.3), exactly."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.errors import InputError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.directions import nominal_angle
from stochgeom.feeding.closures import closure_of
from stochgeom.feeding.planner import plan_feeding, plan_transfer
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from tests.strategies import pushable_parts, transfer_functions

RECTANGLE = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
"""Of the mouth from 56.3 to 236.3 degrees, to 180 degrees."""


def arc(start: int, end: int) -> Arc:
    return Arc(Angle.from_degrees(start), Angle.from_degrees(end - start))


def cut_up(start: Angle, end: Angle, halvings: int) -> list[Angle]:
    """Return the ends and places between them, in order."""
    if not halvings:
        return [start, end]
    middle = nominal_angle(start, end)
    return cut_up(start, middle, halvings - 1)[:-1] + cut_up(middle, end, halvings - 1)


def check(plan, closure):
    """Check Eq. 5.5 at every stage, Eq. 5.6 at the last, each orientation run by itself as well."""
    parts = (closure.first, closure.gap, closure.last)
    assert closure.first.end == closure.gap.start
    assert closure.gap.end == closure.last.start
    assert closure.arc.width == parts[0].width + parts[1].width + parts[2].width <= FULL_TURN
    for a, b, c in closure.images:
        assert a.start <= a.end <= b.start <= b.end <= c.start <= c.end
    for image in closure.images[-1]:
        assert not image.width
        assert image.start == closure.final_orientation
    assert not plan.execute_arc(closure.arc)[-1].width
    for part in parts:
        inside = nominal_angle(part.start, part.end)
        for theta in (part.start, inside, nominal_angle(inside, part.end)):
            states = plan.execute(theta)[1:]
            assert states[-1] == closure.final_orientation
            for state, images in zip(states, closure.images, strict=True):
                image = images[parts.index(part)]
                assert image.start <= state <= image.end


class TestOfThePlan:
    @pytest.mark.parametrize("action", ["squeeze", "push-grasp"])
    @pytest.mark.parametrize("name", catalogue_names())
    def test_ends_of_the_mouth(self, name, action):
        plan = FeedingProblem(catalogue_part(name), action).geometric_plan()
        closure = closure_of(plan)
        assert closure.arc.start == plan.mouth.start
        assert closure.arc.width == min(plan.mouth.width, HALF_TURN)
        check(plan, closure)

    def test_the_4gon(self):
        """The first squeeze takes the ends of the mouth to 177 and 271 degrees, the gap between."""
        plan = FeedingProblem(catalogue_part("4gon")).geometric_plan()
        closure = closure_of(plan)
        assert [part.width.degrees(2) for part in (closure.first, closure.gap, closure.last)] == [
            "43.83", "85.71", "50.46"
        ]  # fmt: skip
        ends = [(i.start.degrees(2), i.end.degrees(2)) for i in closure.images[0]]
        assert ends == [("176.70", "176.70"), ("201.57", "258.11"), ("270.99", "270.99")]

    @given(pushable_parts(), st.sampled_from(["squeeze", "push-grasp"]))
    @settings(max_examples=60)
    def test_of_any_part(self, part, action):
        plan = FeedingProblem(part, action).optimal_plan()
        check(plan, closure_of(plan))

    @given(transfer_functions(), st.data())
    @settings(max_examples=100)
    def test_of_any_two_arcs_of_the_mouth_in_either_order(self, transfer, data):
        plan = plan_transfer(transfer)
        mouth = plan.mouth
        places = data.draw(st.sets(st.integers(0, 8), min_size=4, max_size=4))
        grid = cut_up(mouth.start, mouth.end, 3)
        cuts = [grid[place] for place in sorted(places)]
        first, last = Arc(cuts[0], cuts[1] - cuts[0]), Arc(cuts[2], cuts[3] - cuts[2])
        turned = first.rotate(FULL_TURN * data.draw(st.integers(-2, 2)))
        arcs = data.draw(st.permutations([turned, last]))
        closure = closure_of(plan, arcs)
        check(plan, closure)
        if mouth.width < FULL_TURN:
            assert closure.arc.start.reduced() == first.start.reduced()
            assert closure.arc.width == last.end - first.start


class TestWhichGap:
    def test_the_order_in_which_arcs_are_given_does_not_matter(self):
        one = closure_of(RECTANGLE, [arc(60, 70), arc(200, 210)])
        other = closure_of(RECTANGLE, [arc(200, 210), arc(60, 70)])
        assert one.first.start.reduced() == other.first.start.reduced() == Angle.from_degrees(60)
        assert one.gap.width == other.gap.width == Angle.from_degrees(130)
        check(RECTANGLE, other)

    def test_push_grasps_may_close_the_larger_gap(self):
        """Def. 5.3 takes the smallest contiguous set: of push-grasps that is not always collapsed.

        Three push-grasps collapse 271 degrees of the 4gon. Of the two ends of that arc the smaller
        gap is the rest of the circle, which ends elsewhere.
        """
        plan = FeedingProblem(catalogue_part("4gon"), "push-grasp").plan_of(3)
        mouth, ten = plan.mouth, Angle.from_degrees(10)
        closure = closure_of(plan, [Arc(mouth.start, ten), Arc(mouth.end - ten, ten)])
        check(plan, closure)
        assert closure.arc.width == mouth.width
        assert mouth.width.degrees(1) == "271.2"
        outside = plan.execute(nominal_angle(mouth.end, mouth.start + FULL_TURN))[-1]
        assert (outside - closure.final_orientation).reduced()


class TestBadInput:
    @pytest.mark.parametrize(
        ("arcs", "message"),
        [
            ([arc(60, 70)], r"arcs: .* no pair of Arcs; accepted: two arcs apart"),
            (arc(60, 70), "arcs: Arc.*; accepted: two arcs"),
            (7, "arcs: 7; accepted: two arcs"),
            ([arc(60, 70), (80, 90)], "no pair of Arcs"),
            ([arc(60, 80), arc(70, 90)], r"both hold 70\.0000°; accepted"),
            ([arc(70, 90), arc(60, 80)], r"both hold 70\.0000°"),
            ([arc(60, 80), arc(420, 430)], r"both hold 60\.0000°"),
            ([arc(60, 80), arc(80, 90)], r"touch at 80\.0000°; accepted"),
            ([arc(80, 90), arc(60, 80)], r"touch at 80\.0000°"),
            ([arc(60, 70), arc(300, 310)], r"one arc to 180\.0000°, the other to 0\.0000°"),
            (
                [arc(50, 70), arc(80, 90)],
                r"does not collapse the arc of 20\.0000° from 50\..*: its image is 180",
            ),
            ([arc(80, 90), arc(50, 70)], r"does not collapse the arc of 20\.0000° from 50"),
        ],
    )
    def test_arcs(self, arcs, message):
        with pytest.raises(InputError, match=message):
            closure_of(RECTANGLE, arcs)

    def test_no_plan(self):
        with pytest.raises(InputError, match="plan: 'house' is of type str, not FeedingPlan"):
            closure_of("house")
