"""The tree of all plans with sensors: what it holds, what it refuses, how it is drawn."""

from __future__ import annotations

from itertools import combinations

import pytest
from gmpy2 import mpq

import stochgeom as sg
from stochgeom.errors import InputError, NodeLimitError, ProblemError, SensorError
from stochgeom.plotting.and_or_scenes import and_or_scene
from stochgeom.plotting.scene import Label
from tests.scene_checks import overlapping_labels, parsed

COIN = sg.PlanningProblem(
    ["heads", "tails"],
    ["1/2", "1/2"],
    ["turn"],
    [[[0, 1], [1, 0]]],
    sg.AdditiveCost(actions="1/8", states={"tails": 1}),
)
EYE = sg.Sensor.perfect(COIN.states, cost="1/16", name="eye")
DIM = sg.Sensor.noisy(COIN.states, "1/10", cost="1/32", name="dim")


class TestTheTree:
    def test_what_follows_moves(self):
        root = sg.all_sensor_plans(COIN, EYE, 1).root
        turn, look = root.moves
        assert (turn.senses, turn.label, look.senses, look.label) == (False, "turn", True, "eye")
        assert [reading for reading, _ in turn.branches] == [None]
        assert [reading for reading, _ in look.branches] == ["heads", "tails"]
        assert look.branches[0][1].end.weights == (mpq(1, 2), 0)

    def test_the_best_moves_are_told(self):
        root = sg.all_sensor_plans(COIN, EYE, 2).root
        assert root.best == (1,)  # to look
        heads, tails = (child for _, child in root.moves[1].branches)
        assert (heads.best, tails.best) == ((-1,), (0,))

    def test_impossible_readings_have_no_branch(self):
        certain = sg.PlanningProblem(["heads", "tails"], [1, 0], ["turn"], [[[0, 1], [1, 0]]])
        (_, look) = sg.all_sensor_plans(certain, EYE, 1).root.moves
        assert [reading for reading, _ in look.branches] == ["heads"]

    def test_without_a_cost_there_are_no_values(self):
        tree = sg.all_sensor_plans(COIN.with_cost(None), [EYE, DIM], 1)
        assert (tree.expected_cost, tree.best_plans, tree.plans) == (None, 0, 4)
        assert all(node.least is None and node.best == () for node in tree.nodes())

    def test_no_moves(self):
        tree = sg.all_sensor_plans(COIN, EYE, 0)
        assert (tree.plans, tree.expected_cost, tree.root.moves) == (1, mpq(1, 2), ())

    def test_an_irrational_price(self):
        width = sg.AngleSum(0, [(1, sg.Angle(0, (3, 2)))])
        problem = sg.PlanningProblem(
            COIN.states, [width, 1 - width], ["turn"], [[[0, 1], [1, 0]]], sg.IterativeCost()
        )
        tree = sg.all_sensor_plans(problem, DIM, 2)
        cost = sg.plan_for_cost(problem, DIM, 2).expected_cost
        assert not isinstance(cost, type(mpq()))
        assert tree.expected_cost == cost
        assert tree.best_plans == 1

    def test_of_a_float_problem(self):
        cost = sg.AdditiveCost(actions=0.125, states={"tails": 1.0})
        tree = sg.all_sensor_plans(COIN.to_float().with_cost(cost), EYE, 2)
        assert tree.expected_cost == 0.125


class TestRefusals:
    def test_too_many_nodes(self):
        with pytest.raises(NodeLimitError, match="tree of 88573 nodes; accepted: up to 10000"):
            sg.all_sensor_plans(COIN, EYE, 10)

    def test_a_horizon_beyond_all_trees_is_refused_at_once(self):
        with pytest.raises(InputError, match="1000000000000 moves; accepted"):
            sg.all_sensor_plans(COIN, EYE, 10**12)

    @pytest.mark.parametrize("horizon", [-1, "2", 1.0, True, None])
    def test_bad_horizons(self, horizon):
        with pytest.raises(InputError):
            sg.all_sensor_plans(COIN, EYE, horizon)

    @pytest.mark.parametrize("limit", [0, "9", 9.5, True, None])
    def test_bad_node_limits(self, limit):
        with pytest.raises(InputError, match=r"^node limit: .* nodes; accepted: whole numbers"):
            sg.all_sensor_plans(COIN, EYE, 1, node_limit=limit)

    @pytest.mark.parametrize("problem", [5, "coin", None, sg.catalogue_part("house")])
    def test_no_problem(self, problem):
        with pytest.raises(ProblemError, match="accepted: a PlanningProblem"):
            sg.all_sensor_plans(problem, EYE, 1)

    def test_no_sensor(self):
        with pytest.raises(SensorError, match="is no sensor"):
            sg.all_sensor_plans(COIN, ["eye"], 1)


class TestPictures:
    def test_every_node_and_every_branch_is_drawn(self):
        tree = sg.all_sensor_plans(COIN, [EYE, DIM], 2)
        scene = and_or_scene(tree)
        nodes = sum(1 for _ in tree.nodes())
        assert len(scene.of_style("act")) + len(scene.of_style("chosen")) == nodes
        assert len(scene.of_style("branch")) + len(scene.of_style("best")) == nodes - 1
        bundles = [m for node in tree.nodes() for m in node.moves if len(m.branches) > 1]
        assert len(scene.of_style("both")) == len(bundles)

    def test_the_best_plan_is_heavy(self):
        scene = and_or_scene(sg.all_sensor_plans(COIN, EYE, 2))
        assert len(scene.of_style("best")) == 3  # heads; tails, turn
        bold = [s.text for s in scene.shapes if isinstance(s, Label) and s.bold]
        assert sorted(bold) == [
            "end (0.0000)", "end (0.0000)", "heads (0.5000)", "tails (0.5000)", "turn",
        ]  # fmt: skip
        assert "13 plans; least expected cost 0.1250" in scene.labels()

    def test_of_several_sensors_readings_name_theirs(self):
        labels = and_or_scene(sg.all_sensor_plans(COIN, [EYE, DIM], 1), 2).labels()
        assert {"eye: heads (0.50)", "dim: tails (0.50)"} <= set(labels)

    def test_boxes_and_labels_stand_apart(self):
        tree = sg.all_sensor_plans(COIN, [EYE, DIM], 2)
        scene = and_or_scene(tree)
        assert overlapping_labels(scene) == []
        boxes = [box.points for style in ("act", "chosen") for box in scene.of_style(style)]
        for one, other in combinations(boxes, 2):
            assert one[0][0] >= other[1][0] or other[0][0] >= one[1][0] or (
                one[0][1] >= other[2][1] or other[0][1] >= one[2][1]
            )  # fmt: skip

    def test_too_large_for_a_picture(self):
        tree = sg.all_sensor_plans(COIN, DIM, 5)
        with pytest.raises(NodeLimitError, match="at the horizon"):
            and_or_scene(tree)
        assert tree._repr_svg_() is None
        assert "nodes" in repr(tree)

    def test_twice_the_same(self):
        one, two = (sg.all_sensor_plans(COIN, EYE, 2)._repr_svg_() for _ in range(2))
        assert one == two
        parsed(one)
