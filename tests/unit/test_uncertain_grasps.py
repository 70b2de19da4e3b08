"""Grasps as uncertain actions: matrices, classes, plans."""

from __future__ import annotations

from itertools import pairwise, product

import numpy as np
import pytest

from stochgeom.errors import CostError, InputError, NoPlanError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle
from stochgeom.exact.cells import CellSet
from stochgeom.exact.intervals import Interval
from stochgeom.geometry.part import Part
from stochgeom.grasping.pushed_rows import PushedRows
from stochgeom.grasping.uncertain_grasps import UncertainGrasps
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.squeeze import squeeze_function

RECTANGLE = Part([(0, 0), (3, 0), (3, 2), (0, 2)])
HOUSE = catalogue_part("house")


@pytest.fixture(scope="module")
def rectangle():
    return UncertainGrasps(RECTANGLE, "1/4")


@pytest.fixture(scope="module")
def house():
    return UncertainGrasps(HOUSE, "1/4")


def floats(matrix):
    return np.array([[float(p) for p in row] for row in matrix])


class TestRows:
    def test_a_row_by_hand(self, rectangle):
        """At 50 degrees either jaw pushes to 0, and wedged are those above arctan 3/2 - arctan 1/4:
        1 - (50 - 42.2737) / 50."""
        first, *zeros, wedged = rectangle.row(Angle.from_degrees(50))
        assert first.decimal(6) == "0.845474"
        assert wedged.decimal(6) == "0.154526"
        assert all(p.rational == 0 for p in zeros)

    def test_a_stable_orientation_stays(self, rectangle):
        assert [p.rational for p in rectangle.row(HALF_TURN)] == [0, 0, 1, 0, 0]

    def test_the_two_jaws_may_differ(self, house):
        """At 170 degrees the lower jaw turns the house down from its roof, the upper one up."""
        row = [float(p) for p in house.row(Angle.from_degrees(170))]
        assert sum(p > 0 for p in row[:-1]) > 1

    @pytest.mark.parametrize("name", ["house", "wrench", "key"])
    def test_shares_are_those_of_the_sets(self, name):
        """A second road: the way as a set, met with the preimages as sets."""
        grasps = UncertainGrasps(catalogue_part(name), "1/4")
        diagram = grasps.diagram
        for push, jaw in zip(diagram.jaws, grasps._jaws, strict=True):
            assert isinstance(jaw, PushedRows)
            for k in range(0, 360, 23):
                theta = Angle.from_degrees(k) + Angle(0, (1000, 1))
                arc = push.image(theta)
                way = CellSet.of([Interval(arc.start, arc.width, True, True)])
                shares = jaw.shares(theta)
                for outcome, (part, whole) in shares.items():
                    target = (
                        diagram.wedged_set
                        if outcome < 0
                        else CellSet.at([diagram.squeeze.contacts.starts[outcome]])
                    )
                    inside = way & diagram.squeeze.weak_preimage(target)
                    assert (
                        inside.measure.compare(
                            CellSet.of([Interval(ZERO, part, True, True)]).measure
                        )
                        == 0
                    )
                    assert whole == arc.width
                assert sum((part for part, _ in shares.values()), start=ZERO) == arc.width


class TestClasses:
    def test_classes_fill_the_circle(self, rectangle):
        classes = rectangle.classes
        assert classes[-1].high == classes[0].low + FULL_TURN
        for before, after in pairwise(classes):
            assert before.high == after.low
        assert all(c.low < c.angle < c.high for c in classes)

    def test_support_is_the_same_all_over_a_class(self, house):
        for action in house.classes[::7]:
            support = floats(house.matrix(action)) > 0
            near = Angle(0, (10**9, 1))
            for angle in (action.low + near, action.high - near):
                other = type(action)(angle, action.low, action.high)
                assert (floats(house.matrix(other)) > 0).tolist() == support.tolist()

    def test_matrices_are_stochastic(self, house):
        for matrix in house.matrices:
            rows = floats(matrix)
            assert (rows >= 0).all()
            assert np.abs(rows.sum(axis=1) - 1).max() < 1e-14
            assert matrix[-1][-1].rational == 1  # wedged is never left

    def test_without_friction_the_matrices_are_nearly_those_of_squeezes(self):
        """Nothing wedges: each row is a mixture of the ends of both pushes' ways."""
        grasps = UncertainGrasps(RECTANGLE, 0)
        squeeze = squeeze_function(RECTANGLE)
        for action in grasps.classes:
            for edge, row in zip(grasps.states, grasps.matrix(action), strict=False):
                end = squeeze(edge.orientation - action.angle).reduced()
                place = [e.orientation for e in grasps.states].index(end)
                # The rectangle's pushes never cross a maximum of its diameter.
                assert row[place].rational == 1


class TestPlans:
    def test_the_first_grasp_is_random(self, rectangle):
        plan = rectangle.best_plan(1)
        assert (plan.actions, plan.steps, plan.complete) == ((), 1, True)
        assert plan.probability.decimal() == max(p.decimal() for p in rectangle.first[:-1])

    @pytest.mark.parametrize("steps", [2, 3])
    def test_the_best_plan_is_that_of_all_words(self, rectangle, steps):
        matrices = [floats(matrix) for matrix in rectangle.matrices]
        start = np.array([float(p) for p in rectangle.first])
        best = 0.0
        for word in product(matrices, repeat=steps - 1):
            state = start
            for matrix in word:
                state = state @ matrix
            best = max(best, state[:-1].max())
        plan = rectangle.best_plan(steps)
        assert abs(float(plan.probability) - best) < 1e-12
        assert plan.complete
        assert len(plan.actions) == steps - 1

    def test_the_probability_is_certified(self, house):
        plan = house.best_plan(2)
        row = floats(house.matrix(plan.actions[0]))
        start = np.array([float(p) for p in house.first])
        place = house.states.index(plan.state)
        assert abs(float((start @ row)[place]) - float(plan.probability)) < 1e-12
        assert plan.probability.decimal(30).startswith(plan.probability.decimal(20)[:18])

    def test_a_node_limit_is_told(self, rectangle):
        assert not rectangle.best_plan(3, node_limit=30).complete
        assert rectangle.best_plan(2, node_limit=28).complete

    def test_the_cheapest_plan(self):
        """5gon: two grasps pay. (1 + 1) / .2187 = 9.1, (2 + 1) / .4236 = 7.1."""
        grasps = UncertainGrasps(catalogue_part("5gon"), "1/4")
        assert grasps.cheapest_plan(3).steps == 2
        assert grasps.cheapest_plan(3, 0).steps == 1 + (
            2 / float(grasps.best_plan(2).probability) < 1 / float(grasps.best_plan(1).probability)
        )

    def test_endless_friction_has_no_plan(self):
        with pytest.raises(NoPlanError, match="wedged"):
            UncertainGrasps(RECTANGLE, 10**6).cheapest_plan(2)

    def test_bad_input(self, rectangle):
        for steps, nodes in ((0, 1), (1, 0)):
            with pytest.raises(InputError, match="accepted: 1 or more"):
                rectangle.best_plan(steps, node_limit=nodes)
        with pytest.raises(InputError, match="accepted: 1 or more"):
            rectangle.cheapest_plan(0)
        with pytest.raises(CostError):
            rectangle.cheapest_plan(1, -1)
