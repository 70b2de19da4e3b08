"""Diagrams of grasps, trees of plans, trays: what stands where, and which way it points."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from gmpy2 import mpq

import stochgeom as sg
from stochgeom.exact.intervals import Interval
from stochgeom.plotting.hyperstate_trees import open_loop_scene
from stochgeom.plotting.scene import Label, Polygon, Scene
from stochgeom.plotting.stability_scenes import (
    cells_scene,
    grasp_diagram_scene,
    push_scene,
    squeeze_scene,
)
from stochgeom.plotting.styles import STYLES
from stochgeom.plotting.tray_scenes import tilt_plan_scene, tray_scene
from stochgeom.plotting.tree_scenes import tree_scene
from tests.scene_checks import overlapping_labels

SQUARE = sg.Part([(0, 0), (1, 0), (1, 1), (0, 1)])
HOUSE = sg.catalogue_part("house")
WIDTH = 560.0


def degrees(text: str) -> sg.Angle:
    return sg.Angle.from_degrees(text)


def spans(scene: Scene, style: str) -> list[tuple[float, float]]:
    """Return from where to where the polygons of a style reach, in degrees, from left to right."""
    found = []
    for shape in scene.of_style(style):
        xs = [x for x, _ in shape.points]
        found.append((min(xs) * 360 / WIDTH, max(xs) * 360 / WIDTH))
    return sorted(found)


def heads(scene: Scene) -> dict[int, int]:
    """Return which way each arrowhead points, 1 to the right, by its middle in whole degrees."""
    found = {}
    for head in scene.of_style("arrowhead"):
        tip, back = head.points[0][0], head.points[1][0]
        found[round((tip + back) / 2 * 360 / WIDTH)] = 1 if tip > back else -1
    return found


class TestGraspDiagrams:
    def test_the_push_of_a_square_turns_to_the_nearest_edge(self):
        scene = push_scene(sg.PushStability(SQUARE))
        assert heads(scene) == {
            22: -1, 68: 1, 112: -1, 158: 1, 202: -1, 248: 1, 292: -1, 338: 1
        }  # fmt: skip
        assert len(scene.of_style("arrow")) == 5 + 1  # and one in the legend
        middles = {round((a + b) / 2) for a, b in spans(scene, "mass")}
        assert {45, 135, 225, 315} < middles

    def test_the_squeeze_of_a_square_wedges_about_its_diagonals(self):
        scene = squeeze_scene(sg.SqueezeStability(SQUARE, "0.25"))
        alpha = math.degrees(math.atan(0.25))
        legend, *wedges = sorted(scene.of_style("palm"), key=lambda s: -max(s.points)[1])
        assert spans(Scene(wedges), "palm") == [
            pytest.approx((k - alpha, k + alpha)) for k in (45, 135, 225, 315)
        ]
        assert legend.points[0][1] > max(y for wedge in wedges for _, y in wedge.points)
        assert heads(scene)[15] == -1
        assert heads(scene)[75] == 1

    def test_without_friction_a_squeeze_has_unstable_orientations_and_no_wedges(self):
        scene = squeeze_scene(sg.SqueezeStability(SQUARE, 0))
        assert scene.of_style("palm") == []
        assert len(scene.of_style("mass")) == 4 + 1
        assert scene.labels()[-2:] == ["stable", "unstable"]

    def test_figure_3_7(self):
        """The strong preimage of 90 degrees reaches to the wedging intervals on both sides."""
        scene = grasp_diagram_scene(sg.GraspDiagram(SQUARE, "0.25"))
        beta = 45 - math.degrees(math.atan(0.25))
        bars = [(0, beta), *((k - beta, k + beta) for k in (90, 180, 270)), (360 - beta, 360)]
        assert spans(scene, "funnel") == [pytest.approx(bar) for bar in bars]
        assert spans(scene, "bar") == [pytest.approx(bar) for bar in bars]
        assert {"90.0°", "180.0°", "270.0°", "61.93°"} <= set(scene.labels())

    def test_an_edge_that_only_friction_holds_has_its_own_mark(self):
        diagram = sg.GraspDiagram(HOUSE, "1/10")
        held = sum(edge.by_friction for edge in diagram.stable)
        assert held > 0
        assert "held by friction alone" in grasp_diagram_scene(diagram).labels()
        scene = squeeze_scene(diagram.squeeze)
        level = [s for s in scene.of_style("arrow") if s.points[0][1] == s.points[1][1]]
        assert len(level) == held + 1

    @pytest.mark.parametrize("mu", ["0", "1/10", "1/4", "3"])
    @pytest.mark.parametrize("name", ["house", "4gon", "5gon"])
    def test_labels_stand_apart(self, name, mu):
        scene = grasp_diagram_scene(sg.GraspDiagram(sg.catalogue_part(name), mu))
        assert overlapping_labels(scene) == []

    def test_a_part_of_many_edges_has_no_bars_for_each(self):
        few = grasp_diagram_scene(sg.GraspDiagram(sg.Part.regular(40), "1/100"))
        many = grasp_diagram_scene(sg.GraspDiagram(sg.Part.regular(44), "1/100"))
        assert "sure to end at" in few.labels()
        assert "sure to end at" not in many.labels()
        assert ("unstable" in few.labels(), "unstable" in many.labels()) == (True, False)
        assert len(spans(many, "bar")) >= 44


class TestSetsOfOrientations:
    def test_ends_that_belong_to_a_set_are_dots(self):
        cells = sg.CellSet.of([Interval(degrees("270"), degrees("180"), True, False)])
        scene = cells_scene(cells, width=WIDTH)
        assert spans(scene, "bar") == [(0, 90), (270, 360)]
        assert [disc.center[0] * 360 / WIDTH for disc in scene.of_style("closed")] == [270]
        assert [disc.center[0] * 360 / WIDTH for disc in scene.of_style("hollow")] == [90]

    def test_single_orientations_are_dots_and_0_stands_at_both_ends(self):
        scene = cells_scene(sg.CellSet.at([sg.ZERO, degrees("90")]), width=WIDTH)
        places = sorted({disc.center[0] * 360 / WIDTH for disc in scene.of_style("closed")})
        assert places == [0, 90, 360]
        assert scene.of_style("bar") == []

    def test_nothing_and_everything(self):
        assert cells_scene(sg.CellSet.empty()).of_style("bar") == []
        whole = cells_scene(sg.CellSet.whole(), width=WIDTH)
        assert spans(whole, "bar") == [(0, 360)]
        assert whole.of_style("closed") == []


class TestTreesOfPlans:
    COST = sg.AdditiveCost(actions={"left": 1, "right": 1}, states={"b": 3, "c": 9})
    PROBLEM = sg.PlanningProblem(
        ["a", "b", "c"],
        ["1/2", "1/4", "1/4"],
        ["left", "right"],
        {
            "left": [[1, 0, 0], [1, 0, 0], [0, 1, 0]],
            "right": [[0, 1, 0], [0, 0, 1], [0, 0, 1]],
        },
        COST,
    )

    def test_every_plan_has_its_cost_and_the_best_are_heavy(self):
        scene = open_loop_scene(self.PROBLEM, 2)
        assert len(scene.of_style("act")) == 1 + 2 + 4
        model = self.COST.on(self.PROBLEM)
        costs = {
            (one, two): model.of_plan([one, two])
            for one in ("left", "right")
            for two in ("left", "right")
        }
        ends = [s for s in scene.shapes if isinstance(s, Label) and s.text.startswith("cost")]
        assert [float(s.text.removeprefix("cost ")) for s in ends] == [
            float(cost) for cost in costs.values()
        ]
        best = [cost == min(costs.values()) for cost in costs.values()]
        assert [s.bold for s in ends] == best
        assert len(scene.of_style("best")) == 2  # the branches of left, left

    def test_plans_that_tie_are_all_heavy(self):
        turn = sg.PlanningProblem.from_matrices(
            [1, 0], {"x": [[0, 1], [1, 0]], "y": [[0, 1], [1, 0]]}, cost=sg.AdditiveCost(actions=1)
        )
        scene = open_loop_scene(turn, 2)
        assert len(scene.of_style("best")) == 6
        assert scene.of_style("branch") == []

    def test_the_bars_are_the_probabilities(self):
        bars = open_loop_scene(self.PROBLEM.with_cost(None), 1).of_style("probable")
        heights = [bar.points[2][1] - bar.points[0][1] for bar in bars]
        unit = heights[0] / 0.5
        assert [h / unit for h in heights] == pytest.approx(
            [1 / 2, 1 / 4, 1 / 4, 3 / 4, 1 / 4, 1 / 2, 1 / 2]
        )

    def test_infinite_costs_are_called_so(self):
        problem = self.PROBLEM.with_cost(sg.GuaranteedCost(["a"]))
        assert "cost infinite" in open_loop_scene(problem, 1).labels()

    def test_labels_stand_apart(self):
        assert overlapping_labels(open_loop_scene(self.PROBLEM, 4)) == []
        sensor = sg.Sensor.noisy(self.PROBLEM.states, "1/10")
        plan = sg.iterative_sensor_plan(self.PROBLEM, sensor, stages=["sense", "act", "sense"])
        assert overlapping_labels(tree_scene(plan.tree)) == []

    def test_angles_are_told_from_probabilities_and_distances(self):
        """States and squeezes of a part are labelled by degrees, and say so."""
        part = [(52, 58), (0, 55), (8, 17), (51, 0)]
        tree = sg.SensingProblem(part, 1, "0.3").plan(stages=["act", "sense"]).tree
        moves = [text for text in tree_scene(tree).labels() if text.startswith(("accept", "turn"))]
        assert {text.split()[0] for text in moves} == {"accept", "turn"}
        assert all("°" in text.split(" (")[0] for text in moves)

    def test_an_arc_spans_the_branches_of_a_sensing(self):
        sensor = sg.Sensor.perfect(["a", "b", "c"])
        tree = sg.iterative_sensor_plan(self.PROBLEM, sensor, stages=["sense"]).tree
        scene = tree_scene(tree)
        (arc,) = scene.of_style("both")
        branches = scene.of_style("branch")
        slopes = [(s.points[1][1] - s.points[0][1]) / 17.0 for s in branches]
        (x, y), start = arc.points[0], branches[0].points[0]
        assert (y - start[1]) / (x - start[0]) == pytest.approx(slopes[0])
        assert len(branches) == 3


class TestTrays:
    @pytest.mark.parametrize("sizes", [(90, 40), (150, 140), (200, 30), (60, 20)])
    def test_each_tile_is_in_the_state_that_it_is_numbered(self, sizes):
        """What the physics says of the middle of each tile drawn."""
        setup = sg.TraySetup(tile_length=sizes[0], tile_width=sizes[1])
        scene = tray_scene(setup)
        tiles = scene.of_style("tile") or scene.of_style("likely")
        frames = scene.of_style("tray")
        assert len(tiles) == 12
        for number, tile in enumerate(tiles, 1):
            frame = frames[number - 1] if len(frames) > 1 else frames[0]
            assert sg.tile_state(setup, pose_in(tile, frame, setup)) == number

    def test_arrows_point_the_way_the_tile_slides(self):
        scene = tray_scene(sg.TraySetup())
        for k, head in enumerate(scene.of_style("arrowhead")):
            x, y = head.points[0]
            aim = math.radians(90 + 30 * k)
            assert (x, y) == pytest.approx((9 * math.cos(aim), 9 * math.sin(aim)))

    @pytest.mark.parametrize("sizes", [(90, 40), (150, 140), (200, 30), (60, 20)])
    def test_labels_stand_apart(self, sizes):
        setup = sg.TraySetup(tile_length=sizes[0], tile_width=sizes[1])
        assert overlapping_labels(tray_scene(setup)) == []
        tilts = tilt_plan_scene(sg.figure_6_4_model(), 7, [1, 1], setup)
        assert overlapping_labels(tilts) == []

    def test_figure_6_3(self):
        """From state 7 tilt 1 leads to 1, 3 and 12; the likeliest is filled."""
        scene = tilt_plan_scene(sg.figure_6_4_model(), 7, [1], sg.TraySetup())
        assert len(scene.of_style("likely")) == 2
        assert len(scene.of_style("unlikely")) == 2
        shares = [text for text in scene.labels() if text.startswith(("state", "others"))]
        assert [text.split(":")[0] for text in shares] == [
            "state 7", "state 1", "state 3", "state 12", "others"
        ]  # fmt: skip
        total = sum(mpq(text.split(": ")[1]) for text in shares[1:])
        assert abs(total - 1) <= mpq(4, 2000)


def pose_in(tile: Polygon, frame: Polygon, setup: sg.TraySetup) -> sg.TilePose:
    """Return a tile drawn in a frame as a pose in millimetres."""
    corners = np.array(tile.points)
    outer = np.array(frame.points)
    unit = setup.side / np.ptp(outer[:, 0])
    x, y = (corners.mean(axis=0) - outer.mean(axis=0)) * unit
    width, height = np.ptp(corners, axis=0)
    return sg.TilePose(float(x), float(y), 0.0 if width > height else math.pi / 2)


class TestCurves:
    @pytest.fixture(autouse=True)
    def _matplotlib(self):
        pytest.importorskip("matplotlib")
        yield
        import matplotlib.pyplot as plt

        plt.close("all")

    @staticmethod
    def axes():
        from matplotlib.figure import Figure

        return Figure().subplots()

    @pytest.mark.parametrize("part", [SQUARE, HOUSE, sg.catalogue_part("5gon")])
    def test_the_bound_is_that_of_the_diagram_at_each_friction(self, part):
        ax = sg.draw_friction_bounds(part, self.axes(), largest="1/2")
        curve = [line for line in ax.lines if line.get_color() == "#23527c"]
        pieces = [line.get_xydata() for line in curve if len(line.get_xdata()) > 1]
        for mu in ("1/50", "13/100", "29/100", "47/100"):
            exact, x = float(sg.GraspDiagram(part, mu).bound), float(mpq(mu))
            (piece,) = [p for p in pieces if p[0, 0] < x < p[-1, 0]]
            assert np.interp(x, *piece.T) == pytest.approx(exact, abs=2e-3)

    def test_a_jump_has_the_value_as_a_dot_and_the_limit_as_a_circle(self):
        ax = sg.draw_friction_bounds(HOUSE, self.axes())
        dots = [line for line in ax.lines if line.get_marker() == "o"]
        assert [tuple(dot.get_xydata()[0]) for dot in dots[:2]] == [
            (0, 1), (0, pytest.approx(float(sg.GuaranteedBound(HOUSE).limit)))
        ]  # fmt: skip
        fills = [dot.get_markerfacecolor() for dot in dots[:2]]
        assert fills == [STYLES["closed"].fill, STYLES["hollow"].fill]

    @pytest.mark.parametrize("part", [SQUARE, HOUSE])
    def test_the_dashed_curve_is_the_bound_of_the_pushing_model(self, part):
        ax = sg.draw_friction_bounds(part, self.axes(), largest="1/2")
        (curve,) = [line for line in ax.lines if line.get_linestyle() == "--"]
        for mu in ("0", "1/8", "1/3", "1/2"):
            exact = float(sg.pushing_bound(sg.GraspDiagram(part, mu)))
            assert np.interp(float(mpq(mu)), *curve.get_data()) == pytest.approx(exact, abs=1e-3)

    @pytest.mark.parametrize("jaw", list(sg.Jaw))
    def test_the_density_after_a_push_is_equation_c_4(self, jaw):
        push = sg.PushStability(HOUSE, jaw)
        ax = sg.draw_push_density(push, self.axes())
        lines = [line.get_xydata() for line in ax.lines if len(line.get_xdata()) > 20]
        for theta in ("11", "60", "100", "200", "261.5", "350"):
            exact = float(sg.density_after_push(push, degrees(theta)))
            found = [
                np.interp(float(theta), *line[np.argsort(line[:, 0])].T)
                for line in lines
                if line[:, 0].min() < float(theta) < line[:, 0].max()
            ]
            assert max(found) == pytest.approx(exact, rel=5e-3, abs=5e-3)

    def test_the_density_of_data_has_area_1_and_its_bins_their_shares(self):
        ax = sg.draw_sensor_density(2, "1/4", ["3/2", 2, "9/4"], self.axes())
        x, y = ax.lines[0].get_data()
        assert np.trapezoid(y, x) == pytest.approx(1, abs=2e-4)
        shares = [float(text.get_text().split("\n")[1]) for text in ax.texts]
        edges = [-np.inf, 1.5, 2, 2.25, np.inf]
        for share, low, high in zip(shares, edges, edges[1:], strict=False):
            inside = (x >= low) & (x <= high)
            assert np.trapezoid(y[inside], x[inside]) == pytest.approx(share, abs=2e-3)

    def test_narrow_bins_are_named_upright_and_the_narrowest_counted(self):
        """Found with 17 bins, of which 15 had no probability."""
        ax = sg.draw_sensor_density(10, "3", range(0, 32, 2))
        assert len(ax.texts) == 17
        assert {text.get_rotation() for text in ax.texts} == {0, 90}
        assert "named" not in ax.get_xlabel()
        fine = sg.draw_sensor_density(10, "3", [mpq(k, 10) for k in range(90, 111)])
        assert (
            fine.get_xlabel() == f"data ({22 - len(fine.texts)} of 22 bins too narrow to be named)"
        )
        for axes in (ax, fine):
            axes.get_figure().draw_without_rendering()
            boxes = sorted(text.get_window_extent().extents.tolist() for text in axes.texts)
            assert all(one[2] <= other[0] + 0.5 for one, other in pairwise(boxes))

    def test_long_rules_are_told_whole_beside_the_axes(self):
        """Found with a legend that ended in "throw it awa; at most" and left the picture."""
        test = sg.DecisionProblem(
            ["readable", "unreadable"],
            ["short", "long", "none"],
            ["keep it", "unreadable: throw it away"],
            [["8/10", "1/10", "1/10"], ["1/10", "2/10", "7/10"]],
            [[0, 5], [8, 0]],
        )
        for ax in (None, self.axes()):
            drawn = sg.draw_risks(test, None, ax)
            figure = drawn.get_figure()
            figure.draw_without_rendering()
            legend = drawn.get_legend()
            rules = [text.get_text() for text in legend.get_texts()]
            assert all(rule.count("keep it") + rule.count("throw it away") == 3
                       for rule in (rule.replace("\n", " ") for rule in rules))  # fmt: skip
            assert all("at most" in rule for rule in rules)
            assert legend.get_window_extent().x1 <= figure.bbox.x1

    def test_probabilities_of_bins_are_rounded_one_by_one(self):
        """Seven edges a deviation apart; rounded to a sum of 1 one of them would be .3415."""
        edges = [mpq(k, 4) for k in range(5, 12)]
        ax = sg.draw_sensor_density(2, "1/4", edges, self.axes())
        shares = [text.get_text().split("\n")[1] for text in ax.texts]
        assert shares == [
            "0.0013", "0.0214", "0.1359", "0.3413", "0.3413", "0.1359", "0.0214", "0.0013"
        ]  # fmt: skip

    def test_narrow_bins_are_not_named(self):
        ax = sg.draw_sensor_density(2, 1, [mpq(k, 10) for k in range(41)], self.axes())
        assert len(ax.texts) < 5
        assert len(ax.collections[1].get_segments()) == 41

    def test_figure_a_1(self):
        """Rule 1 is better in most states, rule 2 has the smaller largest risk."""
        states = [str(k) for k in range(5)]
        problem = sg.DecisionProblem(
            states, ["x"], ["one", "two"], [[1]] * 5, [[1, 3], [1, 3], [1, 3], [1, 3], [5, 4]]
        )
        ax = sg.draw_risks(problem, [{"x": "one"}, {"x": "two"}], self.axes())
        curves = [line for line in ax.lines if not line.get_label().startswith("_")]
        assert [line.get_label() for line in curves] == [
            "x: one; at most 5.0000",
            "x: two; at most 4.0000, minimax",
        ]
        assert [line.get_ydata().tolist() for line in curves] == [[1, 1, 1, 1, 5], [3, 3, 3, 3, 4]]
        assert curves[1].get_linewidth() > curves[0].get_linewidth()

    def test_of_rules_of_equal_risk_one_is_drawn(self):
        """Two readings that tell nothing: four rules, but only the curves of three mixtures."""
        blind = sg.DecisionProblem(
            ["h", "t"], ["x", "y"], ["h", "t"], [["1/2", "1/2"]] * 2, [[0, 1], [1, 0]]
        )
        ax = sg.draw_risks(blind, None, self.axes())
        assert sum(line.get_label()[0] != "_" for line in ax.lines) == 3

    def test_risks_that_tie_are_all_heavy(self):
        guess = sg.DecisionProblem(["h", "t"], ["x"], ["h", "t"], [[1], [1]], [[0, 1], [1, 0]])
        ax = sg.draw_risks(guess, None, self.axes())
        labels = [line.get_label() for line in ax.lines if line.get_label()[0] != "_"]
        assert all(label.endswith("minimax") for label in labels)
        assert len(labels) == 2
