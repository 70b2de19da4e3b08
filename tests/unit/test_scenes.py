"""Scenes: what is drawn, where it stands in degrees, what the labels say."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.decision.density_priors import WrappedNormal
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.decision.mixture_prior import MixturePrior
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.priors import uniform_prior
from stochgeom.errors import InputError, PriorError
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding.planner import orient_up_to_symmetry, plan_feeding, plan_transfer
from stochgeom.feeding.preimages import preimages
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.grasping.squeeze_stability import SqueezeStability
from stochgeom.plotting import report_pictures
from stochgeom.plotting.block_scenes import scooped_blocks_scene, sensed_blocks_scene
from stochgeom.plotting.curves import bars_of, steps_of, turns_for, wave_of
from stochgeom.plotting.distributions import distribution_scene, fitted
from stochgeom.plotting.function_scenes import analysis_scene, step_scene, wave_scene
from stochgeom.plotting.funnel_scenes import funnel_scene, funnels_of
from stochgeom.plotting.graph import degree_ticks, round_ticks, value_ticks
from stochgeom.plotting.grasp_scenes import (
    contact_word,
    error_scene,
    grasp_scene,
    reached_from,
    stable_scene,
)
from stochgeom.plotting.gripper_scenes import (
    closing_scene,
    gripper_scene,
    rolling,
    wedged_or_stable_scene,
)
from stochgeom.plotting.part_scenes import part_scene
from stochgeom.plotting.sample_orientations import sample_orientations
from stochgeom.plotting.scene import Disc, Label, Line, Polygon, Scene, box_of, moved, rectangle
from stochgeom.plotting.silhouettes import silhouette
from stochgeom.plotting.styles import STYLES
from stochgeom.plotting.svg import number, svg_document, text_of
from stochgeom.plotting.trace_scenes import trace_scene, typical_orientations
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction
from tests.repo.sources import MODULES
from tests.scene_checks import SVG, overlapping_labels, parsed

RECTANGLE = Part([(0, 0), (3, 0), (3, 2), (0, 2)])
BRACKET = Part([(0, 0), ("7/2", 0), ("7/2", "3/4"), ("5/6", "3/4"), ("5/6", "13/3"), (0, "13/3")])
SLIVER = Part([(0, 0), (1000, 0), (1000, 1), (500, 2), (0, 1)])


def _corner(k: int) -> tuple[int, int]:
    a = 2 * np.pi * k / 30 + 0.1
    return round(1000 * np.cos(a) * (1 + 0.05 * np.sin(3 * a))), round(1000 * np.sin(a))


NUMBERS = {"<.01", "1.00", *(f".{k:02}" for k in range(1, 100))}

GON = Part([_corner(k) for k in range(30)])
"""Nearly round: its orientations lie close together, its diameter hardly varies."""


def degrees(text: str) -> Angle:
    return Angle.from_degrees(text)


class TestSvgText:
    def test_a_document_is_a_picture_by_itself(self):
        scene = Scene([rectangle((0, 0), (2, 1), "part"), Disc((1, 0.5), 0.25, "mass")])
        scene.add(Label((1, 1.5), "a < b & c", 0.3), Line(((0, 0), (2, 1)), "hull"))
        root = parsed(svg_document(scene, title="<title>", description="two & two", scale=10))
        assert root.find(f"{SVG}title").text == "<title>"
        assert root.find(f"{SVG}desc").text == "two & two"
        assert root.find(f"{SVG}text").text == "a < b & c"
        assert [child.tag.removeprefix(SVG) for child in root][-4:] == [
            "polygon", "circle", "text", "polyline"
        ]  # fmt: skip

    def test_y_points_down_in_pixels(self):
        scene = Scene([rectangle((0, 0), (4, 2), "part")])
        root = parsed(svg_document(scene, title="t", scale=10, margin=5))
        assert (root.get("width"), root.get("height")) == ("50", "30")
        assert root.find(f"{SVG}polygon").get("points") == "5,25 45,25 45,5 5,5"

    @pytest.mark.parametrize(
        ("value", "text"), [(0.004, "0"), (-0.004, "0"), (12.345, "12.35"), (-7.0, "-7")]
    )
    def test_numbers_are_short(self, value, text):
        assert number(value) == text

    def test_characters_that_xml_has_not_are_replaced(self):
        assert text_of("a\x00b\x1b\ud800") == "a\ufffdb\ufffd\ufffd"
        parsed(svg_document(Scene([Label((0, 0), "\x07<b>", 1)]), title="\x01"))

    def test_every_style_differs_from_the_others_in_grey(self):
        looks = {
            (style.fill and grey(style.fill), style.stroke and grey(style.stroke), style.width,
             style.dash)
            for style in (STYLES[name] for name in ("part", "jaw", "pushing", "open", "ghost"))
        }  # fmt: skip
        assert len(looks) == 5
        fills = sorted(grey(STYLES[name].fill) for name in ("pushing", "jaw", "part", "open"))
        assert all(b - a > 30 for a, b in pairwise(fills))

    def test_every_style_is_of_something_that_is_drawn(self):
        source = "\n".join(path.read_text(encoding="utf-8") for path in MODULES)
        unused = [name for name in STYLES if source.count(f'"{name}"') < 2]  # one makes it
        assert unused == []

    def test_bounds_hold_the_text(self):
        scene = Scene([Label((0, 0), "wide text", 1.0, "start")])
        left, bottom, right, top = scene.bounds()
        assert left == 0
        assert right > 4
        assert bottom < -0.5
        assert top > 0.5

    def test_moving_scales_everything(self):
        assert moved(Disc((1, 2), 3, "mass"), 10, 20, 2) == Disc((12, 24), 6, "mass")
        assert moved(Label((1, 1), "a", 2), 1, 0, 3) == Label((4, 3), "a", 6)


def grey(color: str) -> float:
    """Return the lightness of ``#rrggbb``, 0 to 255."""
    r, g, b = (int(color[k : k + 2], 16) for k in (1, 3, 5))
    return 0.299 * r + 0.587 * g + 0.114 * b


class TestSilhouettes:
    def test_all_parts_have_radius_one(self):
        for part in (RECTANGLE, SLIVER, Part.regular(7), Part([(0, 0), (10**400, 0), (0, 1)])):
            hull = silhouette(part).hull
            assert np.hypot(hull[:, 0], hull[:, 1]).max() == pytest.approx(1)

    def test_a_large_outline_is_thinned(self):
        part = Part([(k, k * k) for k in range(-2000, 2001)])
        body = silhouette(part, 100)
        assert 10 < len(body.outline) < 200

    def test_turning_is_counter_clockwise(self):
        turned = silhouette(RECTANGLE).turned(np.pi / 2)
        assert turned.top == pytest.approx(silhouette(RECTANGLE).hull[:, 0].max())

    def test_a_part_with_everything(self):
        part = Part(
            [(0, 0), (9, 0), (9, 9), (5, 3)],
            holes=[[(6, 1), (8, 1), (8, 2)]],
            center_of_mass=(7, 3),
        )
        scene = part_scene(part)
        assert [len(scene.of_style(s)) for s in ("part", "hole", "hull", "mass")] == [1, 1, 1, 1]
        assert not part_scene(RECTANGLE).of_style("hull")  # the hull is the outline


class TestCurves:
    def test_steps_of_the_rectangle(self):
        steps = steps_of(squeeze_function(RECTANGLE))
        assert steps.values.tolist() == [0, 90, 180, 270, 360]
        assert steps.starts[0] == 0
        assert steps.cut_at_start
        assert steps.ends[-1] == 360
        assert steps.starts[1] == pytest.approx(56.3099, abs=1e-4)

    def test_a_step_that_begins_at_zero_is_not_cut(self):
        steps = steps_of(StepFunction([Angle()], [degrees("45")], degrees("90")), turns=2)
        assert not steps.cut_at_start
        assert len(steps.values) == 8

    def test_values_outside_their_step_are_drawn_where_they_are(self):
        s = StepFunction([degrees("10"), degrees("200")], [degrees("-100"), degrees("250")])
        assert steps_of(s).values.tolist() == [-110, -100, 250]

    def test_the_wave_of_the_house(self):
        wave = wave_of(RadiusFunction(catalogue_part("house", appendix="E")))
        assert wave.minima.tolist() == [0, 90, 135, 225, 270, 360]
        assert len(wave.maxima) == 5
        assert wave.at_minima[0] == pytest.approx(1.4)

    def test_a_function_that_hardly_varies_is_enlarged_and_says_so(self):
        """Found with 30 corners, whose diameter had been a flat line without marks."""
        scene = wave_scene(DiameterFunction(GON), height=150.0)
        (curve,) = scene.of_style("curve")
        heights = [y for _, y in curve.points]
        assert max(heights) - min(heights) > 75
        assert "axis not from 0; 56 minima, not marked" in scene.labels()
        assert overlapping_labels(scene) == []
        bounds = scene.of_style("frame")[-1].points
        assert bounds[0][1] < min(heights) < max(heights) < bounds[2][1]
        ends = step_scene(squeeze_function(GON)).labels()
        assert "56 steps, ends not marked" in ends
        # A minimum at 0 degrees is one again at 360.
        assert "62 minima, not marked" in wave_of(DiameterFunction(Part.regular(62))).remark

    def test_other_functions_begin_at_0_and_need_no_remark(self):
        for part in (RECTANGLE, catalogue_part("key")):
            wave = wave_of(DiameterFunction(part))
            assert wave.limits[0] == 0
            assert wave.remark == ""

    def test_bars_are_in_degrees_and_carry_exact_widths(self):
        bars = bars_of(preimages(squeeze_function(RECTANGLE)))
        assert [bar.width_text for bar in bars] == ["112.62", "180.00"]
        assert bars[0].end - bars[0].start == pytest.approx(112.6199, abs=1e-4)
        assert bars[1].image == (90.0, 180.0)
        assert turns_for(bars) == 1

    def test_two_turns_where_a_bar_ends_beyond_one(self):
        transfer = push_grasp_function(catalogue_part("4gon"))
        assert turns_for(bars_of(preimages(transfer))) == 2

    @pytest.mark.parametrize("most", range(2, 20))
    @pytest.mark.parametrize("end", [360.0, 720.0])
    def test_ticks_are_not_more_than_asked_for(self, end, most):
        assert 1 <= len(degree_ticks(end, most)) <= most

    def test_ticks_are_round(self):
        assert value_ticks(-200, 500) == [-180, 0, 180, 360]
        assert round_ticks(0, 0.013) == [0, 0.005, 0.01]
        assert round_ticks(0, 7e30) == [0, 2e30, 4e30, 6e30]


class TestTraces:
    def test_a_pose_for_every_orientation_and_action(self):
        plan = orient_up_to_symmetry(catalogue_part("4gon"))
        scene = trace_scene(plan)
        assert len(scene.of_style("part")) == 8 * (1 + 4)
        assert len(scene.of_style("open")) == 8 * 2  # before the first action
        assert len(scene.of_style("jaw")) == 8 * 4 * 2

    def test_the_pushing_jaw_is_dark(self):
        plan = orient_up_to_symmetry(catalogue_part("house"), action="push-grasp")
        scene = trace_scene(plan, [degrees("10"), degrees("100")])
        assert len(scene.of_style("pushing")) == 2 * (1 + plan.steps)

    def test_the_gripper_moves_alike_in_every_column(self):
        """The jaws of a row are parallel: the plan does not look at the part."""
        scene = trace_scene(plan_feeding(RECTANGLE), distribution=False)
        jaws = [shape for shape in scene.of_style("jaw") if isinstance(shape, Polygon)]
        by_row: dict[int, set[float]] = {}
        for jaw in jaws:
            (x, y), (u, v) = jaw.points[0], jaw.points[1]
            row = round(-np.mean([p[1] for p in jaw.points]) / 3.52)
            by_row.setdefault(row, set()).add(round(float(np.arctan2(v - y, u - x)), 9))
        assert {row: len(angles) for row, angles in by_row.items()} == {1: 1, 2: 1}
        assert by_row[2] == {round(-np.pi / 4, 9)}  # the second action turns by -45 degrees

    def test_the_part_lies_between_the_closed_jaws(self):
        """In the frame of the picture: the part's height is the diameter at its orientation."""
        plan = plan_feeding(RECTANGLE)
        scene = trace_scene(plan, [degrees("30")], distribution=False)
        part = scene.of_style("part")[1]
        jaws = scene.of_style("jaw")[:2]
        assert min(y for _, y in part.points) == pytest.approx(max(y for _, y in jaws[0].points))
        assert max(y for _, y in part.points) == pytest.approx(min(y for _, y in jaws[1].points))

    def test_final_orientations_are_written_heavily_where_the_mouth_ends(self):
        plan = plan_feeding(RECTANGLE)
        scene = trace_scene(plan, [degrees("100"), degrees("10")])
        finals = [s for s in scene.shapes if isinstance(s, Label) and s.text in {"180.0°", "0.0°"}]
        assert [(label.text, label.bold) for label in finals] == [
            ("180.0°", True),
            ("0.0°", False),
        ]

    def test_captions(self):
        labels = trace_scene(orient_up_to_symmetry(catalogue_part("4gon"))).labels()
        for text in ("squeeze 2", "turned by 153.4°", "turned by −33.7°", "gripper at 119.7°",
                     "uniform", "any angle, here 0°"):  # fmt: skip
            assert text in labels

    def test_probabilities_stand_beside(self):
        labels = trace_scene(orient_up_to_symmetry(catalogue_part("4gon"))).labels()
        # Fig. 4.6 of the source prints them, in the opposite order of states.
        assert labels.count(".50") == 2
        assert labels.count(".25") == 2

    def test_a_prior_is_described(self):
        plan = plan_feeding(catalogue_part("key"), prior=WrappedNormal("40", "30"))
        labels = trace_scene(plan).labels()
        assert any(text.startswith("normal, mean 40") for text in labels)
        atoms = plan_feeding(RECTANGLE, prior=DiscretePrior.from_counts({"10": 1, "200": 3}))
        assert len(trace_scene(atoms).of_style("density")) == 2

    def test_orientations_are_inside_the_steps_and_all_different(self):
        plan = plan_feeding(catalogue_part("key"))
        found = typical_orientations(plan)
        assert len(found) == 8
        steps = {plan.transfer.step_at(theta) for theta in found}
        assert len(steps) == 8

    def test_only_what_arrives_is_traced(self):
        """Found with two orientations, of which six had been drawn."""
        prior = DiscretePrior.from_counts({"0": 50, "90": 30})
        plan = plan_feeding(BRACKET, prior=prior)
        assert typical_orientations(plan) == (degrees("0"), degrees("90"))
        scene = trace_scene(plan)
        assert len(scene.of_style("part")) == 2 * (1 + plan.steps)
        assert "(all that arrive)" in scene.labels()
        assert "<.01" not in scene.labels()

    def test_a_normal_prior_is_traced_about_its_mean(self):
        plan = plan_feeding(catalogue_part("house"), prior=WrappedNormal("30", "12"))
        found = [float(theta.degrees(1)) for theta in typical_orientations(plan)]
        # The middles of fifths: 10, 30, 50, 70 and 90 percent.
        assert found == pytest.approx([30 + 12 * z for z in (-1.28, -0.52, 0, 0.52, 1.28)], abs=3)

    def test_many_points_are_traced_by_equal_shares(self):
        prior = DiscretePrior.from_counts({f"{k}": 1 + 99 * (k == 50) for k in range(40, 60)})
        plan = plan_feeding(BRACKET, prior=prior)
        found = sample_orientations(plan, 4)
        assert degrees("50") in found.orientations
        assert set(found.orientations) <= set(prior.orientations)
        assert found.words == "4 of 20 that arrive"

    @pytest.mark.parametrize("narrow", [False, True])
    def test_orientations_lie_where_the_prior_has_a_density(self, narrow):
        arc = Arc(degrees("10"), degrees("1/8" if narrow else "100"))
        pieces = PiecewisePrior.from_masses(
            [(arc, "3/4"), (Arc(degrees("200"), degrees("9")), "1/4")]
        )
        mixed = MixturePrior([("1/2", pieces), ("1/2", DiscretePrior({"123.4": 1}))])
        for prior in (pieces, mixed):
            for theta in typical_orientations(plan_feeding(BRACKET, prior=prior)):
                assert pieces.density_at(theta) or prior.mass_at(theta)

    def test_a_uniform_prior_is_none(self):
        plan = plan_feeding(RECTANGLE, prior=uniform_prior())
        assert len(typical_orientations(plan)) == 4

    def test_a_stub_tells_the_lower_jaw_at_every_angle_of_the_gripper(self):
        scene = trace_scene(plan_feeding(BRACKET), [degrees("0")], distribution=False)
        jaws = [jaw.points for jaw in scene.of_style("jaw")]
        assert [len(points) for points in jaws] == [8, 4] * 3
        last_lower, last_upper = (np.mean(points, axis=0) for points in jaws[-2:])
        assert last_lower[1] > last_upper[1]  # the gripper stands at 180 degrees there

    def test_what_the_angles_are_relative_to(self):
        labels = trace_scene(plan_feeding(BRACKET)).labels()
        assert {"(one in each step)", "relative to the gripper"} <= set(labels)
        assert "(in 4 of 6 steps)" in trace_scene(plan_feeding(BRACKET), most=4).labels()

    def test_few_of_many_steps(self):
        plan = plan_feeding(Part.regular(30))
        assert len(typical_orientations(plan)) == 8
        assert len(typical_orientations(plan, 3)) == 3

    @pytest.mark.parametrize("most", [0, -1])
    def test_no_traces_are_refused(self, most):
        with pytest.raises(InputError, match="accepted: 1 or more"):
            typical_orientations(plan_feeding(RECTANGLE), most)
        with pytest.raises(InputError, match="0 traces"):
            trace_scene(plan_feeding(RECTANGLE), [])

    def test_a_plan_without_a_part_is_refused(self):
        plan = plan_transfer(squeeze_function(RECTANGLE))
        with pytest.raises(InputError, match="no part to draw"):
            trace_scene(plan)


class TestFunnels:
    def test_feet_stand_in_the_next_mouth(self):
        for action in ("squeeze", "push-grasp"):
            for name in catalogue_names():
                funnels = funnels_of(orient_up_to_symmetry(catalogue_part(name), action=action))
                for above, below in pairwise(funnels):
                    assert below.mouth[0] < above.foot[0] + 1e-9
                    assert above.foot[1] < below.mouth[1] + 1e-9

    def test_the_last_foot_is_a_point(self):
        funnels = funnels_of(plan_feeding(RECTANGLE))
        assert not funnels[-1].foot_width
        assert [f.steps for f in funnels] == [2, 1]

    def test_drawn_with_widths(self):
        scene = funnel_scene(plan_feeding(RECTANGLE))
        assert len(scene.of_style("funnel")) == 2
        assert "180.00° to 90.00°" in scene.labels()
        assert "gripper at −45.00°" in scene.labels()

    def test_under_a_prior_the_caught_mass_is_shaded_and_written(self):
        plan = plan_feeding(catalogue_part("key"), prior=WrappedNormal("40", "30"))
        scene = funnel_scene(plan)
        assert len(scene.of_style("caught")) == 1
        assert f"caught: {plan.probability.decimal(4)}" in scene.labels()

    def test_another_prior_than_the_plans_own(self):
        plan = plan_feeding(RECTANGLE)
        prior = DiscretePrior.from_counts({"60": 1, "300": 1})
        scene = funnel_scene(plan, prior)
        assert "caught: 0.5000" in scene.labels()
        assert len(scene.of_style("caught")) == 1

    def test_the_closed_end_of_the_mouth_is_shaded_and_the_open_one_is_not(self):
        mouth = plan_feeding(RECTANGLE).mouth
        prior = DiscretePrior([(mouth.start, "3/4"), (mouth.end.reduced(), "1/4")])
        scene = funnel_scene(plan_feeding(RECTANGLE), prior)
        assert "caught: 0.7500" in scene.labels()
        assert len(scene.of_style("caught")) == 1
        assert len(scene.of_style("density")) == 1

    def test_the_caught_area_is_the_caught_share(self):
        """Area of the shaded polygon over that of the histogram of one turn: the probability."""
        plan = plan_feeding(RECTANGLE, prior=WrappedNormal("100", "40"))
        scene = funnel_scene(plan)
        caught, whole = scene.of_style("caught")[0], scene.of_style("density")[0]
        share = area(caught) / area(whole)
        assert share == pytest.approx(float(plan.probability.decimal(4)), abs=0.01)


def area(polygon: Polygon) -> float:
    points = np.array(polygon.points)
    x, y = points[:, 0], points[:, 1]
    return abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))) / 2


class TestGrasps:
    @pytest.mark.parametrize(
        ("theta", "word"), [("0", "stable"), ("90", "stable"), ("71", "wedged"), ("270", "stable")]
    )
    def test_what_holds_of_the_rectangle(self, theta, word):
        assert contact_word(RECTANGLE, degrees(theta)) == word

    def test_a_flush_edge_that_slips(self):
        slipping = Part([(0, 0), (1, 0), (4, 3), (1, 2)])  # the foot of (4, 3) misses the edge
        assert contact_word(slipping, Angle()) == "flush, not stable"

    def test_a_right_angle_at_the_end_of_an_edge_is_not_stable(self):
        """One one-sided slope is zero there: no extremum."""
        triangle = Part([(0, 0), (4, 0), (0, 3)])
        assert contact_word(triangle, Angle()) == "flush, not stable"

    def test_contacts_are_marked(self):
        assert len(grasp_scene(RECTANGLE, Angle()).of_style("contact")) == 4
        assert len(grasp_scene(RECTANGLE, degrees("30")).of_style("contact")) == 2

    def test_stable_grasps_in_order_of_stability(self):
        labels = [s for s in stable_scene(catalogue_part("4gon")).shapes if isinstance(s, Label)]
        values = [float(s.text[4:-1]) for s in labels if s.text.startswith("Ψ")]
        assert values == sorted(values)
        assert len(values) == 4
        assert [s.text for s in labels if s.bold] == ["at 21.57°", "Ψ = 20.58°"]

    def test_all_equal_grasps_are_best(self):
        bold = [s for s in stable_scene(Part.regular(6)).shapes if isinstance(s, Label) and s.bold]
        assert len(bold) == 2 * 1  # one grasp in a period of 60 degrees

    def test_more_grasps_than_asked_for(self):
        labels = stable_scene(catalogue_part("key"), most=2).labels()
        assert labels[-1] == "the 2 most stable of 4 grasps"
        with pytest.raises(InputError, match="accepted: whole numbers from 1 on"):
            stable_scene(RECTANGLE, 0)

    def test_an_error_is_cancelled_exactly_up_to_the_break(self):
        """The break at 56.31 degrees belongs to the step on its right."""
        start = squeeze_function(RECTANGLE).breaks[0]
        theta = degrees("30")
        assert len(reached_from(RECTANGLE, theta, start - theta)) == 2
        assert "the error is cancelled" in error_scene(RECTANGLE, degrees("20"), "15").labels()

    def test_an_error_is_not_cancelled(self):
        scene = error_scene(RECTANGLE, degrees("50"), "25")
        assert "2 final orientations: the error is not cancelled" in scene.labels()
        assert len(scene.of_style("part")) == 2

    def test_all_outcomes_are_drawn(self):
        scene = error_scene(GON, degrees("20"), "15")
        assert "6 final orientations: the error is not cancelled" in scene.labels()
        assert len(scene.of_style("part")) == 6

    def test_of_many_outcomes_the_first_the_last_and_some_between_are_drawn(self):
        finals = reached_from(GON, degrees("20"), degrees("100"))
        scene = error_scene(GON, degrees("20"), "100")
        words = f"{len(finals)} final orientations, 12 of them drawn: the error is not cancelled"
        assert words in scene.labels()
        assert len(scene.of_style("part")) == 12 < len(finals)
        assert {f"{a.degrees(2)}°".replace("-", "−") for a in (finals[0], finals[-1])} <= set(
            scene.labels()
        )
        assert overlapping_labels(scene) == []

    def test_an_outcome_at_both_ends_of_the_range_counts_once(self):
        finals = reached_from(RECTANGLE, degrees("20"), degrees("170"))
        assert len(finals) == len({theta.reduced() for theta in finals}) == 4


class TestGrippers:
    def test_the_plate_is_there_only_where_it_slides(self):
        assert len(gripper_scene(sliding=True).of_style("slide")) == 1
        assert not gripper_scene().of_style("slide")
        assert len(gripper_scene().of_style("jaw")) == 2

    def test_a_square_rolls_as_worked_by_hand(self):
        """Its half diagonal is 1; from 30 degrees to level the diagonals turn from 75 to 45."""
        found = rolling(silhouette([(0, 0), (2, 0), (2, 2), (0, 2)]), np.pi / 6, 0.0)
        slide = 2 * (np.cos(np.pi / 4) - np.cos(5 * np.pi / 12))
        assert found.slide == pytest.approx(slide, rel=1e-4)
        assert found.shift == pytest.approx(slide / 2, rel=1e-4)

    def test_the_point_of_the_sliding_jaw_ends_on_the_flush_edge(self):
        scene = closing_scene(Part.regular(6), degrees("15"))
        assert scene.labels()[-1] == "3: stable, 0.00°"
        assert len(scene.of_style("slide")) == 3
        assert len(scene.of_style("contact")) == 2 + 2 + 4
        assert scene.labels()[1] == "2: the plate slides, the part rolls"

    def test_from_a_stable_orientation_nothing_moves(self):
        scene = closing_scene(Part.regular(6), degrees("60"))
        assert scene.labels() == [
            "1: first contact, 60.00°",
            "2: nothing moves",
            "3: stable, 60.00°",
        ]

    def test_with_and_without(self):
        labels = wedged_or_stable_scene(Part.regular(6), degrees("20")).labels()
        assert labels == [
            "friction: wedged at 20.00° if μ > 0.1764",
            "sliding jaw: stable at 0.00°",
        ]

    @pytest.mark.parametrize("theta", ["20", "45", "-33", "100", "200.5"])
    @pytest.mark.parametrize("part", [RECTANGLE, BRACKET, Part([(0, 0), (1000, 1), (3, 4)])])
    def test_the_friction_that_a_wedge_takes(self, part, theta):
        """With a little more than said the grasp diagram wedges the part there, with less not."""
        (caption, _), place = wedged_or_stable_scene(part, degrees(theta)).labels(), degrees(theta)
        mu = mpq(caption.split("μ > ")[1])
        assert place in SqueezeStability(part, mu + mpq(1, 10**6)).wedged
        assert mu < mpq(2, 10**4) or place not in SqueezeStability(part, mu - mpq(2, 10**4)).wedged

    def test_what_needs_no_friction_or_any(self):
        assert wedged_or_stable_scene(RECTANGLE, Angle()).labels()[0] == "friction: stable at 0.00°"
        square = Part([(0, 0), (1, 0), (1, 1), (0, 1)])
        caption = wedged_or_stable_scene(square, degrees("45")).labels()[0]
        assert caption == "friction: wedged at 45.00° by any friction"

    def test_the_friction_that_holds_a_flush_edge(self):
        slipping = Part([(0, 0), (1, 0), (4, 3), (1, 2)])
        caption = wedged_or_stable_scene(slipping, Angle()).labels()[0]
        assert caption == "friction: flush, not stable at 0.00°, held if μ > 1.0000"
        edges = [SqueezeStability(slipping, mu).stable for mu in ("1", "1001/1000")]
        assert [ZERO in {edge.orientation for edge in found} for found in edges] == [False, True]


class TestBlocks:
    def test_bayes(self):
        labels = sensed_blocks_scene([1, 1, 1, 1], [1, 2, 4, 3]).labels()
        assert labels[-4:] == ["1/10", "1/5", "2/5", "3/10"]

    def test_scooping_adds(self):
        scene = scooped_blocks_scene([1, 2, 3, 4], [0, 1, 3, 3])
        assert scene.labels()[-4:] == ["1/10", "1/5", "0", "7/10"]
        assert len(scene.of_style("ghost")) == 4 + 3  # no block where none can be

    def test_fractions_and_decimals_are_not_mixed(self):
        labels = scooped_blocks_scene([7, 13, 1, 480], [0, 1, 1, 3]).labels()
        assert labels[-4:] == ["0.014", "0.028", "0.000", "0.958"]
        assert {"0.026", "0.002"} <= set(labels)
        assert not any("/" in text for text in labels)

    def test_nothing_moves(self):
        assert not scooped_blocks_scene([1, 1], [0, 1]).of_style("jaw")

    @pytest.mark.parametrize(
        ("call", "error", "message"),
        [
            (lambda: sensed_blocks_scene([1, 1], [1]), InputError, "accepted: 2"),
            (lambda: sensed_blocks_scene([1, 0], [0, 1]), InputError, "impossible"),
            (lambda: sensed_blocks_scene([1, 1], [-1, 1]), PriorError, "likelihood 0"),
            (lambda: sensed_blocks_scene([0, 0], [1, 1]), PriorError, "positive sum"),
            (lambda: scooped_blocks_scene([1, 1], [0]), InputError, "accepted: 2"),
            (
                lambda: scooped_blocks_scene([1, 1], [0, 2]),
                InputError,
                "landing place 1: 2 as a place",
            ),
        ],
    )
    def test_bad_input(self, call, error, message):
        with pytest.raises(error, match=message):
            call()


class TestLabels:
    """Labels do not overlap, on the parts of the source and on ugly ones."""

    @pytest.mark.parametrize("action", ["squeeze", "push-grasp"])
    @pytest.mark.parametrize("name", catalogue_names())
    def test_on_the_parts_of_the_source(self, name, action):
        problem = FeedingProblem(catalogue_part(name), action)
        plan = problem.geometric_plan()
        for scene in (
            trace_scene(plan),
            funnel_scene(plan),
            analysis_scene(problem.transfer, problem.preimages, DiameterFunction(problem.part)),
            stable_scene(problem.part),
            error_scene(problem.part, degrees("50"), "100"),
            distribution_scene(plan.distribution(1)),
        ):
            assert overlapping_labels(scene) == []

    @pytest.mark.parametrize("part", [SLIVER, Part.regular(15), Part.regular(40)])
    def test_on_ugly_parts(self, part):
        problem = FeedingProblem(part)
        plan = problem.geometric_plan()
        for scene in (
            trace_scene(plan),
            funnel_scene(plan),
            stable_scene(part),
            closing_scene(part, degrees("20")),
            grasp_scene(part, degrees("1")),
            step_scene(problem.transfer),
            distribution_scene(plan.distribution(1)),
        ):
            assert overlapping_labels(scene) == []

    def test_a_bar_from_one_end_to_the_other_has_its_width_inside(self):
        """Found by the law of labels: beside such a bar there is no room."""
        part = Part([(-1, 0), (0, -1), (1, 0), (0, 1)], center_of_mass=(0, "1/5"))
        problem = FeedingProblem(part, "push-grasp")
        scene = analysis_scene(problem.transfer, problem.preimages)
        assert "360.00°" in scene.labels()
        assert overlapping_labels(scene) == []

    def test_on_blocks_and_grippers(self):
        for scene in (
            sensed_blocks_scene([1, 1, 1, 1], [1, 2, 4, 3]),
            scooped_blocks_scene([1, 1, 1, 1], [0, 1, 3, 3]),
            gripper_scene(sliding=True),
            wedged_or_stable_scene(Part.regular(6), degrees("20")),
        ):
            assert overlapping_labels(scene) == []

    def test_the_check_finds_an_overlap(self):
        scene = Scene([Label((0, 0), "one", 1.0), Label((1, 0.5), "two", 1.0)])
        assert overlapping_labels(scene) == [("one", "two")]
        (low, _), (high, _) = box_of(scene.shapes[0])
        assert low < 0 < high

    @pytest.mark.parametrize("shares", [(1, 8, 1), (1, 1, 8), (8, 1, 1), (5, 1, 9)])
    @pytest.mark.parametrize("places", [(100, 101, 102), (0, 1, 4), (350, 352, 359)])
    def test_numbers_stand_above_the_bars_that_they_cover(self, places, shares):
        state = Hyperstate(
            tuple(Angle.from_degrees(place) for place in places),
            tuple(Angle.from_turns(f"{share}/{sum(shares)}") for share in shares),
        )
        scene = distribution_scene(state)
        bars = [bar.points for bar in scene.of_style("bar")]
        numbers = [s for s in scene.shapes if isinstance(s, Label) and "°" not in s.text]
        assert len(numbers) == 3
        for label in numbers:
            (left, bottom), (right, _) = box_of(label)
            reach = 0.2 * label.size  # the box is wider than the letters
            covered = [b for b in bars if b[0][0] < right - reach and b[1][0] > left + reach]
            assert all(bottom >= bar[2][1] - 0.1 * label.size for bar in covered)

    @pytest.mark.parametrize("part", [GON, catalogue_part("key"), catalogue_part("4gon")])
    def test_a_probability_stands_over_its_own_bar(self, part):
        """Found with 30 corners, where numbers had drifted by 70 degrees from their bars."""
        plan = orient_up_to_symmetry(part)
        seen = 0
        for step in range(1, plan.steps + 1):
            state = plan.distribution(step)
            scene = distribution_scene(state)
            rows = list(zip(scene.of_style("bar"), state.probabilities(2), strict=True))
            for label in (s for s in scene.shapes if isinstance(s, Label) and s.text in NUMBERS):
                seen += 1
                (left, _), (right, _) = box_of(label)
                slack = 0.25 * label.size
                texts = {
                    text.removeprefix("0").replace(".00", "<.01") if text[0] == "0" else text
                    for bar, text in rows
                    if left - slack <= (bar.points[0][0] + bar.points[1][0]) / 2 <= right + slack
                }
                assert label.text in texts
        assert seen > plan.steps

    def test_the_rows_of_a_report_are_legible(self):
        """Found with 30 corners, where bars hid numbers and numbers touched."""
        plan = orient_up_to_symmetry(GON)
        rows = [(step, plan.distribution(step)) for step in range(1, plan.steps + 1)]
        scene = report_pictures.distributions_scene(rows, plan.final_orientation)
        assert overlapping_labels(scene) == []
        shown = [s for s in scene.shapes if isinstance(s, Label) and s.text.startswith("0.")]
        bars = [bar.points for style in ("bar", "image") for bar in scene.of_style(style)]
        assert len(shown) > 40
        for label in shown:
            (left, bottom), (right, top) = box_of(label)
            reach = 0.2 * label.size  # the box is wider than the letters
            hidden = [b for b in bars if b[0][0] < right - reach and b[1][0] > left + reach]
            assert all(bottom > b[2][1] - 0.1 * label.size or top < b[0][1] for b in hidden)

    def test_bars_do_not_cover_each_other(self):
        """Found with 30 corners, of which two orientations are a third of a degree apart."""
        state = orient_up_to_symmetry(GON).distribution(1)
        spans = [
            (bar.points[0][0], bar.points[1][0])
            for bar in distribution_scene(state).of_style("bar")
        ]
        assert all(one[1] <= other[0] + 0.001 for one, other in pairwise(spans))

    def test_what_has_no_probability_is_not_drawn(self):
        prior = DiscretePrior.from_counts({"0": 50, "90": 30})
        state = plan_feeding(BRACKET, prior=prior).distribution(1)
        assert [mass.rational for mass in state.masses].count(0) > 0
        scene = distribution_scene(state)
        assert len(scene.of_style("bar")) == 2
        assert {".62", ".38"} <= set(scene.labels())
        assert "<.01" not in scene.labels()

    def test_long_text_shrinks_and_then_ends(self):
        text, size = fitted("a description that never ends", 1.0, 6.0)
        assert size == 0.7
        assert text.endswith("…")
        assert 0.62 * size * len(text) <= 6.0 + 1e-9
