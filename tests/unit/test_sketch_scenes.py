"""Sketches drawn from real data: a tilted tray, a closed set and its images, a feeder."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import combinations, pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.exact.angles import Angle
from stochgeom.feeding.closures import closure_of
from stochgeom.feeding.planner import plan_transfer
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.plotting.closure_scenes import closure_scene
from stochgeom.plotting.curves import in_degrees
from stochgeom.plotting.monotone_scenes import monotone_step_scene
from stochgeom.plotting.scene import Disc
from stochgeom.plotting.source_figures import NINE_SIDED, SOURCE_FIGURES
from stochgeom.plotting.tilting_scenes import does_slide, tilting_scene
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from stochgeom.tilting.tray import TraySetup
from stochgeom.transfer.step_function import StepFunction
from tests.scene_checks import overlapping_labels
from tests.strategies import pushable_parts

SETUPS = [
    TraySetup(),
    TraySetup(tilt=5),
    TraySetup(tilt=90, tile_length=150, tile_width=140),
    TraySetup(tilt=0.5, tile_length=2, tile_width=1, support_friction=0),
]


class TestTilting:
    """Thesis Fig. 6.1."""

    @pytest.mark.parametrize("setup", SETUPS)
    def test_lengths_and_the_tilt_are_those_of_the_setup(self, setup):
        scene = tilting_scene(setup)
        # Floor, left wall and right wall of each view.
        palms = [np.array(shape.points) for shape in scene.of_style("palm")]
        tiles = [np.array(shape.points) for shape in scene.of_style("likely")]
        assert (len(palms), len(tiles)) == (9, 3)
        for view, turn in enumerate((0.0, -setup.tilt, 0.0)):
            _, left, right = palms[3 * view : 3 * view + 3]
            tile = tiles[view]
            along = tile[1] - tile[0]
            assert math.degrees(math.atan2(along[1], along[0])) == pytest.approx(turn)
            inner = math.dist(left[1], right[0])
            assert math.hypot(*along) / inner == pytest.approx(setup.tile_length / setup.side)
            gaps = math.dist(left[1], tile[0]), math.dist(tile[1], right[0])
            moved = view > 0 and does_slide(setup)
            assert gaps[0 if not moved else 1] == pytest.approx(0, abs=1e-9)

    @pytest.mark.parametrize("setup", SETUPS)
    def test_nothing_sinks_into_the_ground_and_labels_stand_apart(self, setup):
        scene = tilting_scene(setup)
        ground = min(y for line in scene.of_style("tray") for _, y in line.points)
        drawn = [*scene.of_style("palm"), *scene.of_style("likely")]
        assert all(y > ground for shape in drawn for _, y in shape.points)
        assert overlapping_labels(scene) == []

    def test_the_tile_slides_where_the_slope_is_above_the_friction(self):
        """A slope of 1 and a friction of 1 hold it."""
        assert not does_slide(TraySetup(tilt=45, support_friction=1))
        assert does_slide(TraySetup(tilt=45.001, support_friction=1))
        assert not does_slide(TraySetup(tilt=44.999, support_friction=1))
        stays = tilting_scene(TraySetup(tilt=5))
        assert stays.of_style("unlikely") == []
        assert "the tile stays: slope 0.087, friction 0.100" in stays.labels()
        assert len(tilting_scene(TraySetup()).of_style("unlikely")) == 1

    def test_gravity_points_down_whatever_the_tilt(self):
        for setup in SETUPS:
            tip, *back = tilting_scene(setup).of_style("arrowhead")[-1].points
            assert all(tip[1] < y for _, y in back)
            assert tip[0] == pytest.approx(sum(x for x, _ in back) / 2)


class TestNineSided:
    """The stand-in for the part of Fig. 5.11."""

    def test_it_is_generic(self):
        part = Part(NINE_SIDED)
        assert len(part) == len(part.hull) == 9
        edges = [
            (a - c, b - d)
            for (a, b), (c, d) in zip(NINE_SIDED, NINE_SIDED[1:] + NINE_SIDED[:1], strict=True)
        ]
        assert all(x * v != y * u for (x, y), (u, v) in combinations(edges, 2))
        problem = FeedingProblem(part)
        assert (len(problem.transfer), problem.transfer.order) == (7, 2)
        assert [p.width.degrees(1) for p in problem.preimages] == [
            "37.2", "70.8", "124.6", "165.0", "180.0"
        ]  # fmt: skip
        assert problem.geometric_plan().verify()

    def test_it_is_said_to_be_a_stand_in(self):
        assert Part(NINE_SIDED) not in [catalogue_part(name) for name in catalogue_names()]
        figure = SOURCE_FIGURES["fig5.11"]
        assert "stand-in" in figure.title
        pytest.importorskip("matplotlib")
        import matplotlib as mpl

        mpl.use("Agg")
        import matplotlib.pyplot as plt

        axes = figure.draw()
        assert "stand-in" in axes.get_title()
        plt.close(axes.get_figure())


def sweep(polygon) -> tuple[float, float]:
    """Return where a sector drawn about the origin begins, and how wide it is, in degrees."""
    outer = polygon.points[: len(polygon.points) // 2]
    angles = np.unwrap([math.atan2(y, x) for x, y in outer])
    return math.degrees(angles[0]) % 360, math.degrees(angles[-1] - angles[0])


def across(shape, axis: int) -> tuple[float, float]:
    """Return the extent of a bar or of the middle of a dot along an axis."""
    points = [shape.center] if isinstance(shape, Disc) else shape.points
    values = [point[axis] for point in points]
    return min(values), max(values)


class TestClosures:
    """Thesis Figs. 5.5 and 5.6."""

    @given(pushable_parts(), st.sampled_from(["squeeze", "push-grasp"]))
    @settings(max_examples=40)
    def test_of_any_part(self, part, action):
        plan = FeedingProblem(part, action).optimal_plan()
        closure = closure_of(plan)
        scene = closure_scene(plan, closure)
        assert overlapping_labels(scene) == []
        assert any("Θb as well" in text for text in scene.labels())
        # The gap among the bars of the set, then the swatches.
        first, last, *_ = scene.of_style("bar")
        gap, *_ = scene.of_style("funnel")
        parts = ((closure.first, first), (closure.gap, gap), (closure.last, last))
        for arc, sector in parts:
            start, width = sweep(sector)
            off = (start - in_degrees(arc.start) + 180) % 360 - 180
            assert off == pytest.approx(0, abs=1e-6)
            assert width == pytest.approx(in_degrees(arc.width))
        for step in range(1, plan.steps + 1):
            assert overlapping_labels(monotone_step_scene(plan, closure, step)) == []

    @given(pushable_parts(), st.sampled_from(["squeeze", "push-grasp"]))
    @settings(max_examples=40)
    def test_the_graph_brings_what_is_below_to_what_is_beside(self, part, action):
        """Read off the picture: the steps drawn over a bar have the heights of its image."""
        plan = FeedingProblem(part, action).geometric_plan()
        for step in range(1, plan.steps + 1):
            scene = monotone_step_scene(plan, closure_of(plan), step)
            steps = [(*across(line, 0), line.points[0][1]) for line in scene.of_style("step")]
            before, after = rows_and_columns(scene)
            # The first arcs lack their ends, images have both; steps have their left ends.
            more = 1e-6 if step > 1 else -1e-6
            for row, column in zip(before, after, strict=True):
                low, high = across(row, 0)
                over = [y for a, b, y in steps if a <= high + more and low + 1e-6 < b]
                assert (min(over), max(over)) == pytest.approx(across(column, 1))
            for one, other in pairwise(before):
                assert across(one, 0)[1] <= across(other, 0)[0] + 1e-9
            for one, other in pairwise(after):
                assert across(one, 1)[1] <= across(other, 1)[0] + 1e-9

    def test_what_an_action_leaves_the_next_one_takes(self):
        plan = FeedingProblem(catalogue_part("4gon")).geometric_plan()
        told = []
        for step in range(1, 5):
            scene = monotone_step_scene(plan, closure_of(plan), step)
            texts = [text for text in scene.labels() if text.startswith("Θ")]
            assert len(texts) == 6
            told.append((texts[:3], texts[3:]))
            assert scene.labels().index("before") < scene.labels().index("after")
        assert told[0][1] == ["Θa: 176.70°", "Θb: 201.57° to 258.11°", "Θc: 270.99°"]
        for (_, after), (before, _) in pairwise(told):
            assert after == before
        assert told[-1][1] == ["Θa: 90.99°", "Θb: 90.99°", "Θc: 90.99°"]

    def test_the_text_does_not_take_the_lemma_for_granted(self):
        """A closure that no plan makes: its gap ends elsewhere, and the picture says so."""
        plan = FeedingProblem(catalogue_part("4gon")).geometric_plan()
        closure = closure_of(plan)
        *others, (first, gap, last) = closure.images
        moved = (first, gap.rotate(Angle.from_degrees(1)), last)
        wrong = replace(closure, images=(*others, moved))
        assert "to 90.99°, but not Θb" in closure_scene(plan, wrong).labels()

    def test_many_steps_are_one_line(self):
        """Seventy steps of 5 degrees that rise by one: half a turn has more than are marked."""
        breaks = [Angle.from_degrees(5 * k) for k in range(70)]
        plan = plan_transfer(StepFunction(breaks, [Angle.from_degrees(k) for k in range(70)]))
        scene = monotone_step_scene(plan, closure_of(plan))
        assert len(scene.of_style("step")) == 1
        assert overlapping_labels(scene) == []
        assert "3 actions bring Θa and Θc" in closure_scene(plan, closure_of(plan)).labels()


def rows_and_columns(scene):
    """Return the three arcs under a graph and the three beside it."""
    side = max(y for polygon in scene.of_style("frame") for _, y in polygon.points)
    marks = [*scene.of_style("bar"), *scene.of_style("funnel")]
    before = sorted(
        (mark for mark in marks if across(mark, 1)[1] < 0), key=lambda mark: -across(mark, 1)[0]
    )
    after = sorted(
        (mark for mark in marks if across(mark, 0)[0] > side), key=lambda mark: across(mark, 0)[0]
    )
    return before, after
