"""Plans with sensors, worked by hand."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest
from gmpy2 import mpq

from stochgeom.decision.additive_costs import AdditiveCost
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.exact.angles import Angle
from stochgeom.exact.quotients import quotient
from stochgeom.exact.sums import AngleSum
from stochgeom.sensing.decisions import Decisions, accept_groups, lose_by_table
from stochgeom.sensing.one_step import one_step_plan
from stochgeom.sensing.plan_tree import PlanTree
from stochgeom.sensing.planners import iterative_sensor_plan, sensor_plan
from stochgeom.sensing.sensors import Sensor
from stochgeom.sensing.tree_nodes import Act, Leaf, Sense, posterior_of
from stochgeom.sensing.tree_search import tree_size

STATES = ("u", "v", "w")
MERGE = [[1, 0, 0], [1, 0, 0], [0, 0, 1]]
"""Brings v to u."""
MIX = [[0, 0, 1], [0, 1, 0], [0, 1, 0]]
"""Brings u to w, and w to v."""
PARTS = PlanningProblem(STATES, ["1/2", "1/4", "1/4"], ["merge", "mix"], [MERGE, MIX])
EYE = Sensor.from_function(STATES, lambda state: "w" if state == "w" else "not w", name="eye")


class TestOneStep:
    def test_the_erratum_of_equation_7_5(self):
        """Printed 2.2; without a sensor 1.667; in truth 1.429."""
        prior = ["0.6", "0.1", "0.1", "0.1", "0.1"]
        sensor = Sensor.from_function(range(5), lambda state: state == 0)
        plan = one_step_plan(sensor, prior)
        assert plan.printed_cost == mpq("2.2")
        assert plan.success == mpq("0.7")
        assert plan.expected_cost == mpq(10, 7)
        assert one_step_plan(Sensor.blind(range(5)), prior).expected_cost == mpq(5, 3)

    def test_decisions_are_the_most_likely_states(self):
        plan = one_step_plan(EYE, ["1/2", "1/4", "1/4"], 2)
        assert [(d.reading, d.state, d.marginal, d.probability) for d in plan.decisions] == [
            ("not w", "u", mpq(3, 4), mpq(2, 3)),
            ("w", "w", mpq(1, 4), 1),
        ]
        assert plan.expected_cost == mpq(8, 3)

    def test_of_equal_states_the_first_is_accepted(self):
        assert one_step_plan(Sensor.blind(STATES), ["1/3"] * 3).decisions[0].state == "u"

    def test_impossible_readings_are_left_out(self):
        assert [d.reading for d in one_step_plan(EYE, [1, 0, 0]).decisions] == ["not w"]

    def test_only_some_states_accepted(self):
        plan = one_step_plan(EYE, ["1/2", "1/4", "1/4"], accepted=["v"])
        assert plan.success == mpq(1, 4)

    def test_equation_7_5_of_angle_sums_is_enclosed(self):
        width = AngleSum(0, [(1, Angle(0, (3, 2)))])
        plan = one_step_plan(Sensor.perfect(["a", "b"]), [width, 1 - width])
        assert plan.expected_cost == 1
        assert plan.printed_cost.decimal(6) == "1.000000"
        blind = one_step_plan(Sensor.blind(["a", "b"]), [width, 1 - width])
        assert blind.printed_cost.decimal(6) == blind.expected_cost.decimal(6)


class TestIterative:
    def test_no_move(self):
        plan = iterative_sensor_plan(PARTS, EYE, 0)
        assert plan.expected_cost == 2
        assert isinstance(plan.tree.root, Leaf)

    def test_looking_once(self):
        """3/4 of the parts are accepted: u if not w is read, w otherwise."""
        plan = iterative_sensor_plan(PARTS, EYE, 1)
        assert plan.expected_cost == mpq(4, 3)
        assert plan.tree.text() == (
            "read eye\n  not w (0.7500): accept u (0.6667)\n  w (0.2500): accept w (1.0000)"
        )

    def test_an_action_in_one_branch_only(self):
        """Free actions: look, and where it is not w, merge. Then every part is accepted."""
        plan = iterative_sensor_plan(PARTS, EYE, 2, action_costs=0)
        assert plan.expected_cost == 1
        assert isinstance(plan.tree.root, Sense)
        first, second = (child for _, child in plan.tree.root.branches)
        assert isinstance(first, Act)
        assert isinstance(second, Leaf)

    def test_an_action_must_pay_for_all_branches(self):
        """The action costs 1 in 3 of 4 rounds and catches 1/4 more: (1 + 3/4) / 1 > 4/3."""
        assert iterative_sensor_plan(PARTS, EYE, 2).expected_cost == mpq(4, 3)
        cheap = iterative_sensor_plan(PARTS, EYE, 2, action_costs="1/4")
        assert cheap.expected_cost == 1 + mpq(3, 16)

    def test_the_price_of_a_look_counts(self):
        plan = iterative_sensor_plan(PARTS, EYE.with_cost("1/3"), 1)
        assert plan.expected_cost == mpq(16, 9)
        assert iterative_sensor_plan(PARTS, EYE.with_cost("1/2"), 1).expected_cost == 2

    def test_no_sensor_is_an_open_loop_plan(self):
        assert iterative_sensor_plan(PARTS, [], 1, round_cost=3).expected_cost == mpq(16, 3)

    def test_stages(self):
        free = {"action_costs": 0}
        orders = [["sense", "act"], ["act", "sense"], ["act"], ["sense"], []]
        costs = [iterative_sensor_plan(PARTS, EYE, stages=s, **free).expected_cost for s in orders]
        assert costs == [1, 1, mpq(4, 3), mpq(4, 3), 2]

    def test_groups_are_accepted_as_one(self):
        groups = accept_groups(STATES, {"uv": ["u", "v"]})
        plan = iterative_sensor_plan(PARTS, [], 0, accepted=groups)
        assert plan.success == mpq(3, 4)
        assert plan.tree.text() == "accept uv (0.7500)"

    def test_a_goal_that_needs_an_action(self):
        """Nothing is in state b at first, so there is no quotient to begin with."""
        problem = PlanningProblem(
            ["a", "b"], [1, 0], ["try"], [[["2/3", "1/3"], [0, 1]]], name="latch"
        )
        plan = iterative_sensor_plan(problem, Sensor.perfect(["a", "b"]), 3, accepted=["b"])
        assert plan.success == mpq(5, 9)
        assert plan.expected_cost == (1 + 1 + mpq(2, 3)) / mpq(5, 9)

    def test_good_enough_subplans_are_cut(self):
        free = {"action_costs": 0, "stages": ["sense", "act"]}
        assert iterative_sensor_plan(PARTS, EYE, **free).expected_cost == 1
        plan = iterative_sensor_plan(PARTS, EYE, **free, good_enough="2/3")
        assert plan.expected_cost == mpq(4, 3)
        assert plan.tree.truncated
        assert not plan.proven
        assert plan.lower_bound == 1
        assert "good enough" in plan.tree.text()

    def test_out_of_time(self):
        plan = iterative_sensor_plan(PARTS, EYE, 3, time_limit=-1)
        assert not plan.proven
        assert plan.expected_cost == 2
        assert plan.lower_bound == 1
        assert "not proven optimal" in repr(plan)

    def test_more_time_is_never_worse(self, monkeypatch):
        """With a clock that counts how often it is asked."""
        sensor = Sensor.noisy(STATES, "1/4", cost="1/20")
        best = iterative_sensor_plan(PARTS, sensor, 3, action_costs="1/8")
        costs, proven = [], []
        for limit in (*range(0, 60, 3), 10**6):
            ticks = iter(range(10**7))
            monkeypatch.setattr("stochgeom.sensing.plan_tasks.monotonic", lambda: 0)
            monkeypatch.setattr("stochgeom.sensing.tree_search.monotonic", lambda t=ticks: next(t))
            plan = iterative_sensor_plan(PARTS, sensor, 3, action_costs="1/8", time_limit=limit)
            costs.append(plan.expected_cost)
            proven.append(plan.proven)
            assert plan.lower_bound <= best.expected_cost <= plan.expected_cost
        assert costs == sorted(costs, reverse=True)
        assert costs[0] > costs[-1] == best.expected_cost
        assert proven == sorted(proven)
        assert (proven[0], proven[-1]) == (False, True)

    def test_in_time(self):
        plan = iterative_sensor_plan(PARTS, EYE, 2, action_costs=0, time_limit=60)
        assert (plan.expected_cost, plan.proven, plan.lower_bound) == (1, True, 1)

    def test_progress_is_told(self):
        shares = []
        iterative_sensor_plan(PARTS, EYE, 2, progress=shares.append)
        assert shares[0] == 0
        assert all(0 <= share < 1 for share in shares)

    def test_floats(self):
        exact = iterative_sensor_plan(PARTS, EYE, 2, action_costs="1/4")
        rounded = iterative_sensor_plan(PARTS.to_float(), EYE, 2, action_costs=0.25, round_cost=1.0)
        assert isinstance(rounded.expected_cost, float)
        assert rounded.expected_cost == pytest.approx(float(exact.expected_cost))
        assert rounded.decimal(4) == exact.decimal(4)

    def test_equal_irrational_quotients_are_decided(self):
        """Two plans of cost 1 / p and 2 / (2 p), with p irrational."""
        p = AngleSum(0, [(1, Angle(0, (3, 2)))])
        rest = 1 - p * 2
        problem = PlanningProblem(
            ["a", "b", "c", "d"],
            [p, p, rest * mpq(1, 2), rest * mpq(1, 2)],
            ["join"],
            [[[1, 0, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]],
        )
        plan = iterative_sensor_plan(problem, [], 1, accepted=["a"])
        assert plan.expected_cost.decimal(4) == "10.6856"
        assert plan.expected_cost == quotient(1, p)
        assert plan.proven

    def test_a_plan_that_is_better_by_a_hair_is_found(self):
        """Between two plans of one irrational quotient, less than a price of 20 decimals sees."""
        p, hair = AngleSum(0, [(1, Angle(0, (3, 2)))]), mpq(1, 10**30)
        states = ["a", "b", "c", "d", "hair", "rest"]
        stay = [[int(j == k) for j in range(6)] for k in range(6)]
        four = [stay[0]] * 4 + stay[4:]
        two = [stay[0], stay[0], *stay[2:4], stay[0], stay[5]]
        problem = PlanningProblem(
            states, [p, p, p, p, hair, 1 - hair - p * 4], ["four", "two"], [four, two]
        )
        plan = iterative_sensor_plan(
            problem, [], 1, action_costs={"four": 3, "two": 1}, accepted=["a"]
        )
        assert plan.expected_cost == quotient(2, p * 2 + hair)
        assert plan.expected_cost < quotient(1, p)

    def test_one_price_is_not_enough(self):
        """Ending costs 10; at that price 5 / .9 looks best, and at its price 2 / .5 is better."""
        problem = PlanningProblem(
            ["a", "b"],
            ["0.1", "0.9"],
            ["dear", "cheap"],
            [[["0.9", "0.1"]] * 2, [["0.5", "0.5"]] * 2],
        )
        plan = iterative_sensor_plan(
            problem, [], 1, action_costs={"dear": 4, "cheap": 1}, accepted=["a"]
        )
        assert plan.expected_cost == 4


class TestOnce:
    def test_look_before_you_pay(self):
        cost = AdditiveCost(actions="1/8", states={"v": 1, "w": 2})
        plan = sensor_plan(PARTS.with_cost(cost), EYE.with_cost("1/100"), 3)
        # not w: merge for 1/8; w: mix and merge for 1/4.
        assert plan.expected_cost == mpq(1, 100) + mpq(3, 4) / 8 + mpq(1, 4) / 4
        assert plan.tree.depth == 3
        assert plan.proven

    def test_a_look_in_one_branch_costs_its_share(self):
        """Half of the parts need the second look, at 0.3 each: cheaper than a mistake in 1/4."""
        states = ["a", "b", "c"]
        problem = PlanningProblem(
            states, ["1/4", "1/4", "1/2"], ["wait"], [[[1, 0, 0], [0, 1, 0], [0, 0, 1]]]
        )
        coarse = Sensor.from_function(states, lambda state: state == "c")
        fine = Sensor.from_function(states, lambda state: state == "a", cost="0.3")
        losses = {s: {other: 1 for other in states if other != s} for s in states}
        plan = sensor_plan(
            problem,
            {"coarse": coarse, "fine": fine},
            2,
            decisions=lose_by_table(problem, losses),
        )
        assert plan.expected_cost == mpq("0.15")
        assert plan.tree.sensings == 2

    def test_losses_of_decisions(self):
        losses = {"left": {"w": 10}, "right": {"u": 1, "v": 1}}
        decisions = lose_by_table(PARTS, losses)
        plan = sensor_plan(PARTS, [], 0, decisions=decisions)
        assert plan.expected_cost == mpq(3, 4)
        assert plan.tree.text() == "right (0.7500)"
        assert sensor_plan(PARTS, EYE, 1, decisions=decisions).expected_cost == 0

    def test_good_enough(self):
        losses = lose_by_table(PARTS, {"x": {"u": 1}, "y": {"v": 1}})
        plan = sensor_plan(PARTS, EYE, 1, decisions=losses, good_enough="1/4")
        assert plan.expected_cost == mpq(1, 4)
        assert not plan.proven

    def test_rounded_likelihoods_bound_the_cost(self):
        rough = Sensor.noisy(STATES, "1/3", row_error="1/1000")
        plan = iterative_sensor_plan(PARTS, rough, 1)
        low, high = plan.cost_bounds
        assert low < plan.expected_cost < high
        assert high - low < mpq(1, 100)
        # |P| off by 1/1000: cost 1 / (P +- 1/1000).
        assert low == 1 / (plan.success + mpq(1, 1000))


class TestTrees:
    def tree(self) -> PlanTree:
        return iterative_sensor_plan(PARTS, EYE, 2, action_costs="1/8").tree

    def test_cost_by_recursion(self):
        tree = self.tree()
        assert tree.cost == mpq(3, 4) / 8
        assert tree.gain == 1
        assert (tree.depth, tree.sensings, tree.highest_cost) == (2, 1, mpq(1, 8))

    def test_joint_hyperstates_add_up(self):
        for node in self.tree().nodes():
            if isinstance(node, Sense):
                for k, weight in enumerate(node.weights):
                    assert weight == sum(child.weights[k] for _, child in node.branches)

    def test_posteriors(self):
        root = self.tree().root
        assert posterior_of(root.branches[0][1]) == (mpq(2, 3), mpq(1, 3), 0)

    def test_neighbours_that_end_alike_share_a_line(self):
        """And what they are worth is taken together; readings 3 and 4 lead to v and to u."""
        problem = PlanningProblem(["u", "v"], ["6/10", "4/10"], ["wait"], [[[1, 0], [0, 1]]])
        sensor = Sensor(
            range(5),
            [["5/6", 0, 0, 0, "1/6"], [0, "1/4", "1/4", "1/4", "1/4"]],
            states=["u", "v"],
        )
        lines = iterative_sensor_plan(problem, sensor, 1).tree.text(2).splitlines()
        assert lines == [
            "read sensor",
            "  0 (0.50): accept u (1.00)",
            "  1, 2, 3 (0.30): accept v (1.00)",
            "  4 (0.20): accept u (0.50)",
        ]
        four = Sensor(range(5), [[1, 0, 0, 0, 0], [0, *["1/4"] * 4]], states=["u", "v"])
        text = iterative_sensor_plan(problem, four, 1).tree.text(2)
        assert text.endswith("\n  1, ..., 4 [4 readings] (0.40): accept v (1.00)")

    def test_dot(self):
        assert self.tree().dot(2) == (
            "digraph plan {\n"
            "  rankdir=LR;\n"
            '  n0 [shape=diamond, label="read eye"];\n'
            '  n1 [shape=box, label="do merge"];\n'
            '  n2 [shape=ellipse, label="accept u (1.00)"];\n'
            "  n1 -> n2;\n"
            '  n0 -> n1 [label="not w (0.75)"];\n'
            '  n3 [shape=ellipse, label="accept w (1.00)"];\n'
            '  n0 -> n3 [label="w (0.25)"];\n'
            "}"
        )

    def test_dot_quotes_labels(self):
        problem = PlanningProblem(['say "a"\\'], [1], ["x"], [[[1]]])
        assert 'accept say \\"a\\"\\\\ (1.0)' in iterative_sensor_plan(problem, [], 0).tree.dot(1)

    def test_svg_is_well_formed_and_shows_every_node(self):
        picture = ET.fromstring(self.tree().svg())
        space = "{http://www.w3.org/2000/svg}"
        texts = [element.text for element in picture.iter(f"{space}text")]
        boxes = ["read eye", "do merge", "accept u (1.0000)", "accept w (1.0000)"]
        assert sorted(texts) == sorted([*boxes, "not w (0.7500)", "w (0.2500)"])
        kinds = [element.get("class") for element in picture.iter(f"{space}polygon")]
        assert sorted(kinds) == ["sg-act", "sg-leaf", "sg-leaf", "sg-sense"]
        lines = [element.get("class") for element in picture.iter(f"{space}polyline")]
        assert sorted(lines) == ["sg-both", "sg-branch", "sg-branch", "sg-branch"]

    def test_svg_boxes_do_not_overlap(self):
        problem = PlanningProblem.from_matrices(["1/4"] * 4, [[[1, 0, 0, 0]] * 4])
        tree = iterative_sensor_plan(problem, Sensor.noisy(problem.states, "1/10"), 2).tree
        picture = ET.fromstring(tree._repr_svg_())
        boxes = []
        for box in picture.iter("{http://www.w3.org/2000/svg}polygon"):
            points = [tuple(map(float, pair.split(","))) for pair in box.get("points").split()]
            xs, ys = zip(*points, strict=True)
            boxes.append((min(xs), min(ys), max(xs), max(ys)))
        assert len(boxes) == sum(1 for _ in tree.nodes()) > 4
        for k, (left, top, right, bottom) in enumerate(boxes):
            assert 0 < left < right <= float(picture.get("width"))
            assert 0 < top < bottom <= float(picture.get("height"))
            for a, b, c, d in boxes[:k]:
                assert left >= c or a >= right or top >= d or b >= bottom

    def test_markup_in_labels_is_escaped(self):
        problem = PlanningProblem(["<a> & b"], [1], ["x"], [[[1]]])
        picture = ET.fromstring(iterative_sensor_plan(problem, [], 0).tree.svg(0))
        assert any("<a> & b" in (element.text or "") for element in picture.iter())

    def test_size_of_the_tree_of_all_plans(self):
        assert tree_size([], 3, 2) == 1
        assert tree_size(["any", "any"], 3, 2) == 1 + 5 + 25
        assert tree_size(["sense", "act"], 3, 2) == 1 + 2 + 6

    def test_decisions_of_all_kinds_choose_the_best(self):
        table = Decisions(("x", "y"), ((0, 2, 0), (1, 0, 0)), accepts=False)
        assert table.best((mpq(1, 2), mpq(1, 8), 0)) == (mpq(1, 2), 1)
        assert table.best_gains == (1, 2, 0)
