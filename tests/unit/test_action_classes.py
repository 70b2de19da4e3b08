"""Classes of equivalent actions, by worked cases and by applying the transfer function."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.directions import just_above
from stochgeom.feeding.action_classes import action_classes
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction
from tests.strategies import angles, transfer_functions

RECTANGLE = squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])
SQUARE = squeeze_function([(0, 0), (1, 0), (1, 1), (0, 1)])


def applied(s, alpha):
    """Return for each state the number of the state that an action at alpha sends it to."""
    return tuple(s.step_at(v - alpha) for v in s.values)


class TestTheRectangle:
    classes = action_classes(RECTANGLE)

    def test_classes_are_bounded_by_differences_of_values_and_breaks(self):
        found = [(c.low.degrees(2), c.high.degrees(2), c.targets) for c in self.classes]
        assert found == [
            ("-33.69", "33.69", (0, 1)),
            ("33.69", "56.31", (1, 1)),
            ("56.31", "123.69", (1, 0)),
            ("123.69", "146.31", (1, 1)),
        ]
        assert self.classes[0].high == RECTANGLE.values[0] - RECTANGLE.breaks[0]

    def test_two_classes_have_the_same_map_and_different_lifts(self):
        assert {m: [c.number for c in cs] for m, cs in self.classes.merged.items()} == {
            (0, 1): [0],
            (1, 1): [1, 3],
            (1, 0): [2],
        }
        assert self.classes[1].steps == (-1, 1)  # around the far side
        assert self.classes[3].steps == (-1, -1)

    def test_representatives_are_inside(self):
        assert [c.angle.degrees(1) for c in self.classes] == ["0.0", "45.0", "90.0", "135.0"]

    def test_matrices_on_a_period_and_on_a_full_turn(self):
        assert self.classes[2].matrix().tolist() == [[0, 1], [1, 0]]
        turn = self.classes[2].matrix(RECTANGLE.order)
        # States 90, 180, 270, 360: a turn by 90 sends 90 to 0, which is 360, and 180 to 90.
        assert turn.tolist() == [[0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]

    def test_the_automaton_has_a_letter_for_each_map(self):
        assert self.classes.automaton().maps == ((0, 1), (1, 1), (1, 0))
        assert [c.number for c in self.classes.representatives((2, 1, 1))] == [2, 1, 1]

    def test_as_a_sequence(self):
        assert len(self.classes) == 4
        assert [c.number for c in self.classes[1:3]] == [1, 2]
        assert [c.number for c in self.classes] == [0, 1, 2, 3]
        assert repr(self.classes) == "<4 classes of actions, 3 different maps>"


def test_one_state_has_one_class_all_around():
    (only,) = action_classes(SQUARE)
    assert only.targets == (0,)
    assert only.high - only.low == SQUARE.period == Angle.from_degrees(90)
    assert only.targets_on(4) == (0, 1, 2, 3)


@pytest.mark.parametrize(
    ("name", "states", "classes"), [("triangle", 3, 7), ("house", 2, 4), ("key", 4, 16)]
)
def test_number_of_classes(name, states, classes):
    s = squeeze_function(catalogue_part(name))
    assert (len(s), len(action_classes(s))) == (states, classes)


# --- by application ------------------------------------------------------------------------------


@given(transfer_functions())
def test_classes_are_the_arcs_between_critical_angles(s):
    """Refuted by a gap, an overlap, a class too many, or neighbours that do the same."""
    classes = action_classes(s)
    critical = {(v - b) % s.period for v in s.values for b in s.breaks}
    assert [c.high for c in classes] == sorted(critical)
    assert classes[0].low == classes[-1].high - s.period
    assert all(before.high == after.low for before, after in pairwise(classes))
    assert [c.number for c in classes] == list(range(len(classes)))
    assert len(classes) <= len(s) ** 2
    if len(s) > 1:
        assert all(one.targets != other.targets for one, other in pairwise(classes))
    assert sum(map(len, classes.merged.values())) == len(classes)


@given(transfer_functions(), st.data())
def test_every_angle_of_a_class_does_what_the_class_says(s, data):
    """Refuted by an angle in (low, high] that moves a state otherwise, or by `low` if it does not.

    The class is open below, since `low` belongs to the class before.
    """
    classes = action_classes(s)
    c = data.draw(st.sampled_from(list(classes)))
    assert c.low < c.angle < c.high
    for alpha in (c.high, c.angle, just_above(c.low, c.high)):
        assert applied(s, alpha) == c.steps
        assert [s(v - alpha) for v in s.values] == [s.lifted_values[k] for k in c.steps]
        assert classes.at(alpha) is c
    if len(s) > 1:
        assert applied(s, c.low) != c.steps
        assert classes.at(c.low) is classes[c.number - 1]


@given(transfer_functions(), angles())
def test_every_angle_is_in_a_class(s, alpha):
    """Refuted by an angle whose map modulo the period is not that of its class."""
    m = len(s)
    c = action_classes(s).at(alpha)
    assert c.targets == tuple(k % m for k in applied(s, alpha))
    laps = (alpha - c.low) // s.period - ((alpha - c.low) % s.period == ZERO)
    assert c.low < alpha - laps * s.period <= c.high
    assert tuple(k - laps * m for k in c.steps) == applied(s, alpha)


@given(transfer_functions(), st.data())
def test_states_of_a_full_turn_move_as_those_of_one_period(s, data):
    """Refuted by a state of a full turn that goes where the class does not send it."""
    c = data.draw(st.sampled_from(list(action_classes(s))))
    m, q = len(s), s.order
    on_turn = c.targets_on(q)
    for k in range(m * q):
        reached = s(s.lifted_values[k] - c.angle)
        assert (s.lifted_values[on_turn[k]] - reached) % FULL_TURN == ZERO
    matrix = c.matrix(q)
    assert (matrix.sum(axis=1) == 1).all()
    assert (np.arange(m * q) @ matrix.T == np.array(on_turn)).all()


@given(transfer_functions(), angles())
def test_turning_a_part_leaves_its_classes(s, angle):
    """Refuted by a rotation that changes an arc: differences of values and breaks stay."""
    turned = s.rotate(angle)
    arcs = {(c.low, c.high) for c in action_classes(s)}
    assert {(c.low, c.high) for c in action_classes(turned)} == arcs


def test_values_may_lie_outside_their_own_steps():
    deg = Angle.from_degrees
    s = StepFunction([deg(0), deg(100)], [deg(350), deg(460)], deg(360))
    assert [c.high.degrees(0) for c in action_classes(s)] == ["0", "100", "250", "350"]
    for c in action_classes(s):
        assert applied(s, c.angle) == c.steps
