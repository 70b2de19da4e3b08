"""Pictures of any part tell the truth: places in degrees, widths, areas, labels apart."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.exact.angles import HALF_TURN, Angle
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.push_stability import Motion, PushStability
from stochgeom.grasping.squeeze_stability import SqueezeStability
from stochgeom.plotting.bar_numbers import Room, numbers_over_bars
from stochgeom.plotting.curves import bars_of, in_degrees, steps_of, turns_for, wave_of
from stochgeom.plotting.function_scenes import analysis_scene
from stochgeom.plotting.funnel_scenes import funnel_scene, funnels_of
from stochgeom.plotting.grasp_scenes import contact_word, reached_from, stable_scene
from stochgeom.plotting.silhouettes import silhouette
from stochgeom.plotting.stability_scenes import grasp_diagram_scene, push_scene, squeeze_scene
from stochgeom.plotting.svg import svg_document
from stochgeom.plotting.trace_scenes import trace_scene, typical_orientations
from tests.scene_checks import overlapping_labels, parsed
from tests.strategies import angles, parts, pushable_parts, transfer_functions

few = settings(max_examples=60)
"""A scene of a whole plan costs milliseconds, the pairs of its labels more."""


@given(transfer_functions())
@settings(max_examples=200)
def test_steps_cover_the_range_and_have_the_values_of_the_function(transfer):
    steps = steps_of(transfer)
    assert steps.starts[0] == 0
    assert steps.ends[-1] == 360
    assert (steps.starts[1:] == steps.ends[:-1]).all()
    assert (steps.starts < steps.ends).all()
    first = transfer.step_at(transfer.period * 0)
    for k, value in enumerate(steps.values):
        assert value == pytest.approx(in_degrees(transfer.lifted_values[first + k]))


@given(transfer_functions())
@settings(max_examples=200)
def test_bars_are_as_wide_as_they_say(transfer):
    bars = bars_of(FeedingProblem.of_transfer(transfer).preimages)
    turns = turns_for(bars)
    for shorter, longer in pairwise(bars):
        assert shorter.end - shorter.start < longer.end - longer.start
    for bar in bars:
        assert bar.end - bar.start == pytest.approx(float(bar.width_text), abs=0.005001)
        assert bar.start >= 0
        assert bar.end <= 360 * turns + 1e-9


@given(parts())
@settings(max_examples=200)
def test_the_height_between_the_jaws_is_the_diameter(part):
    """The silhouette is scaled by one factor for all orientations."""
    function, body = DiameterFunction(part), silhouette(part)
    thetas = np.linspace(0, np.pi, 7)
    heights = np.array([(b := body.turned(t)).top - b.bottom for t in thetas])
    ratio = function.evaluate(thetas) / heights
    assert ratio == pytest.approx(np.full(7, ratio[0]))


@given(parts())
@settings(max_examples=200)
def test_marks_stand_on_the_curve_at_its_extrema(part):
    wave = wave_of(DiameterFunction(part))
    assert wave.at_minima.min() == pytest.approx(wave.y.min())
    assert wave.at_maxima.max() >= wave.y.max() - 1e-9 * wave.y.max()
    assert (np.diff(wave.x) > 0).all()


@given(parts(), angles())
@settings(max_examples=200)
def test_what_is_stable_is_left_as_it_is(part, theta):
    problem = FeedingProblem(part)
    stays = problem.transfer(theta) == theta
    assert (contact_word(part, theta) == "stable") == stays
    (final,) = reached_from(part, theta, HALF_TURN * 0)
    assert final == problem.transfer(theta)


@given(pushable_parts(), st.sampled_from(["squeeze", "push-grasp"]))
@few
def test_funnels_feed_into_each_other(part, action):
    plan = FeedingProblem(part, action).geometric_plan()
    funnels = funnels_of(plan)
    for funnel in funnels:
        a, b = funnel.mouth
        assert b - a == pytest.approx(in_degrees(funnel.mouth_width))
        assert funnel.foot[1] - funnel.foot[0] == pytest.approx(in_degrees(funnel.foot_width))
    for above, below in pairwise(funnels):
        assert below.mouth[0] < above.foot[0] + 1e-9
        assert above.foot[1] < below.mouth[1] + 1e-9


@given(pushable_parts(), st.sampled_from(["squeeze", "push-grasp"]))
@few
def test_traces_start_in_different_steps_and_end_as_executed(part, action):
    plan = FeedingProblem(part, action).optimal_plan()
    found = typical_orientations(plan)
    assert len({plan.transfer.step_at(theta - plan.angles[0]) for theta in found}) == len(found)
    labels = trace_scene(plan).labels()
    for theta in found:
        final = plan.execute(theta)[-1].reduced().degrees(1)
        assert f"{final}°" in labels


@given(pushable_parts(), st.sampled_from(["squeeze", "push-grasp"]))
@settings(max_examples=25)
def test_labels_stand_apart_and_svg_is_well_formed(part, action):
    problem = FeedingProblem(part, action)
    plan = problem.geometric_plan()
    for scene in (
        trace_scene(plan),
        funnel_scene(plan),
        stable_scene(part),
        analysis_scene(problem.transfer, problem.preimages),
    ):
        assert overlapping_labels(scene) == []
        assert len(parsed(svg_document(scene, title="any"))) == len(scene.shapes) + 2


bars = st.dictionaries(
    st.integers(0, 40), st.tuples(st.integers(0, 8), st.integers(1, 6)), max_size=8
)


@given(bars)
def test_numbers_stand_over_their_own_bars_and_apart(rows):
    centers = [float(center) for center in sorted(rows)]
    tops = [float(rows[center][0]) for center in sorted(rows)]
    widths = [float(rows[center][1]) for center in sorted(rows)]
    room = Room(-1.0, 41.0, 12.0, half=0.2, height=1.0, pad=0.1)
    found = numbers_over_bars(centers, tops, widths, room)
    boxes = {k: (x - widths[k] / 2, y, x + widths[k] / 2, y + 1.0) for k, (x, y) in found.items()}
    for k, (left, low, right, high) in boxes.items():
        assert left >= -1.0 - 1e-9
        assert right <= 41.0 + 1e-9
        assert high <= 12.0 + 1e-9
        assert left - 1e-9 <= centers[k] <= right + 1e-9  # a line straight up meets the number
        assert low >= tops[k]
        for j, (other_left, other_low, other_right, other_high) in boxes.items():
            if j == k:
                continue
            apart = min(right, other_right) - max(left, other_left) <= 1e-9
            assert apart or low >= other_high - 1e-9 or high <= other_low + 1e-9
            if other_left + 0.1 < centers[k] < other_right - 0.1:  # and no other number
                assert low <= other_low + 1e-9 or tops[k] >= other_high - 1e-9
        for center, top in zip(centers, tops, strict=True):
            covered = left + 0.1 < center + 0.2 and center - 0.2 < right - 0.1
            assert not covered or low >= top
    spaced = all(
        b - a >= (v + w) / 2 + 0.4 for (a, v), (b, w) in pairwise(zip(centers, widths, strict=True))
    )
    inside = all(c - w / 2 >= -1 and c + w / 2 <= 41 for c, w in zip(centers, widths, strict=True))
    if spaced and inside:
        assert list(found.values()) == list(zip(centers, tops, strict=True))  # right above


@given(pushable_parts(), st.sampled_from(["0", "1/10", "1/2", "2"]))
@settings(max_examples=40)
def test_arrowheads_point_the_way_the_part_turns(part, mu):
    push, squeeze = PushStability(part), SqueezeStability(part, mu)
    for diagram, scene in ((push, push_scene(push)), (squeeze, squeeze_scene(squeeze))):
        for head in scene.of_style("arrowhead"):
            tip, back = head.points[0][0], head.points[1][0]
            theta = Angle.from_degrees(f"{(tip + back) / 2 * 360 / 560:.6f}")
            ahead = Motion.COUNTERCLOCKWISE if tip > back else Motion.CLOCKWISE
            assert diagram.motion(theta) is ahead


@given(pushable_parts(), st.sampled_from(["0", "1/10", "1/2", "2"]))
@settings(max_examples=40)
def test_the_bars_of_a_grasp_diagram_are_as_long_as_its_bound(part, mu):
    diagram = GraspDiagram(part, mu)
    scene = grasp_diagram_scene(diagram)
    drawn = {
        style: sum(bar.points[1][0] - bar.points[0][0] for bar in scene.of_style(style)) / 560
        for style in ("bar", "funnel")
    }
    assert drawn["bar"] == pytest.approx(float(diagram.bound), abs=1e-9)
    assert drawn["funnel"] <= drawn["bar"] + 1e-9
    assert overlapping_labels(scene) == []
