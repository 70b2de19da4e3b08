"""Key frames of the animation, and the CSS that is made of them."""

from __future__ import annotations

import re
from fractions import Fraction
from itertools import pairwise

import pytest

import stochgeom as sg
from stochgeom.plotting.animation_motion import OPEN, Hold, KeyFrame, Trace
from stochgeom.plotting.animation_stage import (
    MOST_ACTIONS,
    MOST_PARTS,
    ramps,
    shown_actions,
    traces,
)

PLANS = {
    "rectangle": sg.orient_up_to_symmetry([(0, 0), (3, 0), (3, 2), (0, 2)]),
    "4gon": sg.plan_feeding(sg.load_part("4gon")),
    "push-grasp": sg.plan_feeding(sg.load_part("wrench"), action="push-grasp"),
    "prior": sg.plan_feeding(sg.load_part("key"), prior=sg.WrappedNormal(mean="40", sd="70")),
}
each_plan = pytest.mark.parametrize("plan", PLANS.values(), ids=PLANS)


def value_at(css: str, time: Fraction) -> Fraction:
    """Evaluate ``calc(a + b*clamp(0,(var(--t) - c)*d,1) ...)`` at a time, exactly."""
    start, rest = re.fullmatch(r"calc\((-?[\d.]+)(?:deg|px)(.*)\)", css).groups()
    total = Fraction(start)
    term = r" ([+-]) ([\d.]+)(?:deg|px)\*clamp\(0,\(var\(--t\) - ([\d.]+)\)\*([\d.]+),1\)"
    assert re.fullmatch(f"(?:{term})*", rest)
    for sign, size, begin, speed in re.findall(term, rest):
        share = min(Fraction(1), max(Fraction(0), (time - Fraction(begin)) * Fraction(speed)))
        total += (1 if sign == "+" else -1) * Fraction(size) * share
    return total


@each_plan
def test_times_increase_and_end_with_each_action(plan):
    for trace in traces(plan):
        times = [frame.time for frame in trace.frames(plan.steps)]
        assert times == sorted(set(times))
        assert set(range(plan.steps + 1)) <= set(times)


@each_plan
def test_at_whole_times_the_css_gives_the_exact_decimals(plan):
    for trace in traces(plan):
        frames = trace.frames(plan.steps)
        part = ramps(frames, lambda frame: frame.part, "deg")
        gripper = ramps(frames, lambda frame: frame.gripper, "deg")
        for step in range(plan.steps + 1):
            assert value_at(part, Fraction(step)) == Fraction(trace.poses[step].degrees(4))
            assert value_at(gripper, Fraction(step)) == Fraction(trace.grippers[step].degrees(4))


@each_plan
def test_between_whole_times_the_css_runs_through_the_key_frames(plan):
    trace = traces(plan)[0]
    frames = trace.frames(plan.steps)
    css = ramps(frames, lambda frame: frame.part, "deg")
    jaw = ramps(frames, lambda frame: f"{frame.lower:.2f}", "px")
    for frame in frames:
        time = Fraction(frame.time)
        assert abs(value_at(jaw, time) - Fraction(f"{frame.lower:.2f}")) < Fraction(1, 50)
        if frame.part is not None:
            assert abs(value_at(css, time) - Fraction(frame.part)) < Fraction(1, 20)


@each_plan
def test_the_gripper_turns_with_open_jaws_and_the_part_only_between_closed_ones(plan):
    for trace in traces(plan):
        known = [frame for frame in trace.frames(plan.steps) if frame.part is not None]
        for before, after in pairwise(known):
            if before.gripper != after.gripper:
                assert {before.lower, before.upper, after.lower, after.upper} == {OPEN}
                assert before.part == after.part
            if before.part != after.part:
                assert before.gripper == after.gripper
                assert OPEN not in {before.lower, after.lower}


@each_plan
def test_closed_jaws_are_as_far_apart_as_the_diameter(plan):
    diameter = sg.DiameterFunction(plan.part)
    trace = traces(plan)[0]
    # The silhouette has radius 1; the ratio of two diameters does not depend on the unit.
    lower, upper = trace.hold.touching(0.3)
    unit = float(diameter.evaluate(0.3)) / (lower + upper)
    for frame in trace.frames(plan.steps):
        if OPEN not in {frame.lower, frame.upper} and frame.part is not None:
            theta = sg.Angle.from_degrees(frame.part) - sg.Angle.from_degrees(frame.gripper)
            apart = unit * (frame.lower + frame.upper)
            assert apart == pytest.approx(float(diameter.evaluate(theta.to_float())), rel=1e-5)


def test_a_push_comes_before_the_squeeze():
    plan = PLANS["push-grasp"]
    push, squeeze = sg.push_function(plan.part), sg.squeeze_function(plan.part)
    turned_twice = 0
    for trace in traces(plan):
        state = trace.states[0] - plan.angles[0]
        first = [f for f in trace.frames(1) if f.part is not None and f.lower < OPEN]
        poses = [sg.Angle.from_degrees(f.part) for f in first]
        pushed = [p for p, f in zip(poses, first, strict=True) if f.upper == OPEN]
        gripper = plan.angles[0]
        assert pushed[-1].degrees(3) == (push(state) + gripper).degrees(3)
        assert poses[-1].degrees(3) == (squeeze(push(state)) + gripper).degrees(3)
        turned_twice += push(state) not in (state, squeeze(push(state)))
    assert turned_twice


def test_a_part_that_fits_turns_inside_the_open_jaws():
    for plan in PLANS.values():
        hold = Hold(plan.part)
        assert all(max(hold.touching(0.1 * k)) < OPEN for k in range(63))


def test_long_plans_are_cut():
    class Long:
        steps = MOST_ACTIONS + 60

    assert shown_actions(Long()) == MOST_ACTIONS
    assert shown_actions(PLANS["4gon"]) == 4


def test_parts_on_the_stage_begin_in_different_steps():
    plan = PLANS["rectangle"]
    first = [trace.states[1] for trace in traces(plan)]
    assert len(set(first)) == len(first) == 4
    assert len(traces(PLANS["4gon"])) == MOST_PARTS < 8


def test_a_value_that_stands_still_is_a_constant():
    frames = [KeyFrame(float(k), "7.500", None, 1.0, 1.0) for k in range(3)]
    assert ramps(frames, lambda frame: frame.gripper, "deg") == "calc(7.5deg)"
    trace = Trace(PLANS["rectangle"], Hold(PLANS["rectangle"].part), sg.ZERO)
    assert {frame.part for frame in trace.frames(1)} == {"0.0000"}


@pytest.mark.parametrize(
    ("start", "end", "css"),
    [
        ("0.0000", "-720.0000", "calc(0deg - 720deg*clamp(0,(var(--t) - 0)*0.5,1))"),
        ("-0.0001", "0.0000", "calc(-0.0001deg + 0.0001deg*clamp(0,(var(--t) - 0)*0.5,1))"),
        ("100.0000", "200.0000", "calc(100deg + 100deg*clamp(0,(var(--t) - 0)*0.5,1))"),
    ],
)
def test_numbers_of_css_have_no_exponent_and_no_idle_zeros(start, end, css):
    frames = [KeyFrame(0.0, start, None, 1.0, 1.0), KeyFrame(2.0, end, None, 1.0, 1.0)]
    assert ramps(frames, lambda frame: frame.gripper, "deg") == css
