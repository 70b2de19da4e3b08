"""Sketches drawn from real data: a tilted tray, a closed set and its images, a feeder."""

from __future__ import annotations

import math
from itertools import combinations

import numpy as np
import pytest

from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.plotting.source_figures import NINE_SIDED, SOURCE_FIGURES
from stochgeom.plotting.tilting_scenes import does_slide, tilting_scene
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from stochgeom.tilting.tray import TraySetup
from tests.scene_checks import overlapping_labels

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
