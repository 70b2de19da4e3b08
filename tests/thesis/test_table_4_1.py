"""Table 4.1: expected cost of the best plans of 1 to 4 squeezes, and the two cells that fail.

The errata's proofs are carried out here with exact rationals, from the printed digits alone: a
number printed with two decimals stands for an interval of half a unit to either side.
"""

from __future__ import annotations

from fractions import Fraction

import pytest

from stochgeom.exact.angles import HALF_TURN, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.thesis.errata import TABLE_4_1
from stochgeom.thesis.parts import catalogue_entry, catalogue_names, catalogue_part
from stochgeom.thesis.tables import STEPS, table_4_1

PRINTED = {
    "triangle": (3, "9.5", "8.2", "8.0", "10.0"),
    "rectangle": (4, "6.4", "6.0", "8.0", "10.0"),
    "house": (5, "5.0", "6.0", "8.0", "10.0"),
    "4gon": (4, "14.3", "12.0", "16.0", "10.0"),
    "5gon": (5, "8.6", "6.5", "8.0", "10.0"),
    "wrench": (6, "9.1", "7.4", "8.0", "10.0"),
    "tuning-fork": (6, "4.9", "6.0", "8.0", "10.0"),
    "key": (11, "9.0", "6.2", "8.2", "10.0"),
}
"""Sides and costs, as the source prints them."""

BOLDFACE = {
    "triangle": 3,
    "rectangle": 2,
    "house": 1,
    "4gon": 4,
    "5gon": 2,
    "wrench": 2,
    "tuning-fork": 1,
    "key": 2,
}
"""Steps of the plan that the source marks as optimal."""

WRONG = {("4gon", 3), ("key", 3)}

ROWS = {row.name: row for row in table_4_1()}
CELLS = [(name, steps) for name in PRINTED for steps in STEPS]


def cell(name, steps):
    return ROWS[name].cells[steps - 1]


def test_the_table_is_the_printed_one():
    assert tuple(ROWS) == tuple(PRINTED)
    for name, row in ROWS.items():
        assert (row.sides, *(c.printed for c in row.cells)) == PRINTED[name]


@pytest.mark.parametrize(("name", "steps"), CELLS)
def test_a_cell_agrees_if_the_catalogue_says_so(name, steps):
    reproduced = catalogue_entry(name).reproduced[f"T4.1 {steps}-step"]
    assert reproduced is ((name, steps) not in WRONG)
    assert cell(name, steps).agrees is reproduced
    # The margin, once more and without decimals of ours.
    half_unit = Fraction(1, 20)
    printed = Fraction(cell(name, steps).printed)
    above = cell(name, steps).computed >= printed - half_unit
    below = cell(name, steps).computed <= printed + half_unit
    assert (above and below) is reproduced


@pytest.mark.parametrize("name", PRINTED)
def test_the_optimal_plan_is_the_one_in_boldface(name):
    assert ROWS[name].best == BOLDFACE[name]
    costs = [c.computed for c in ROWS[name].cells]
    assert min(costs) == costs[BOLDFACE[name] - 1]
    assert costs.count(min(costs)) == 1
    assert FeedingProblem(catalogue_part(name)).optimal_plan().steps == BOLDFACE[name]


def test_only_the_cells_that_differ_have_an_erratum():
    assert set(TABLE_4_1) == WRONG
    for place in CELLS:
        assert cell(*place).erratum is TABLE_4_1.get(place)
    for (name, steps), erratum in TABLE_4_1.items():
        assert erratum.where == f"Table 4.1, {name}, {steps}-step"
        assert erratum.printed == PRINTED[name][steps]


@pytest.mark.parametrize(
    ("name", "costs"),
    [
        ("triangle", ["9.5327", "8.2408", "8.0000", "10.0000"]),
        ("rectangle", ["6.3932", "6.0000", "8.0000", "10.0000"]),
        ("house", ["5.0304", "6.0000", "8.0000", "10.0000"]),
        ("4gon", ["14.2679", "11.9814", "10.5748", "10.0000"]),
        ("key", ["8.9688", "6.1567", "8.0000", "10.0000"]),
    ],
)
def test_computed_costs_literally(name, costs):
    assert [c.computed.decimal(4) for c in ROWS[name].cells] == costs


class TestTheFourGon:
    """16.0 at three steps cannot be: Fig. 4.6 shows a plan of three squeezes for 11.0 at most."""

    # States 1 to 4 of Fig. 4.6 after the random squeeze; 5 to 8 repeat them half a turn on.
    prior = tuple(Fraction(text) for text in ("0.12", "0.14", "0.11", "0.13"))
    rounding = Fraction(1, 200)

    def merged(self, first, last):
        """Return the printed states from `first` to `last`, counted from 1, past 4 as well."""
        return [self.prior[(k - 1) % 4] for k in range(first, last + 1)]

    def test_the_last_two_squeezes_merge_at_least_three_states(self):
        """They take states 2 and 4 to one, so all between: 2 to 4, or 4 to 6 (Lemma 5.1)."""
        least = min(sum(self.merged(2, 4)), sum(self.merged(4, 6))) - 3 * self.rounding
        assert least == Fraction("0.365")
        assert Fraction(3 + 1) / least < 11
        assert least > Fraction(1, 4)  # what 16.0 = 4 / .25 takes it for

    def test_states_of_half_a_turn_add_up_to_one_half(self):
        """That gives a sharper bound: one state is left out, and rounds to at most .12."""
        assert sum(self.prior) == Fraction(1, 2)
        most_left_out = max(self.prior[0], self.prior[2]) + self.rounding
        assert Fraction(3 + 1) / (Fraction(1, 2) - most_left_out) == Fraction(32, 3)

    def test_the_rebuilt_part_keeps_both_bounds(self):
        cost = cell("4gon", 3).computed
        assert cost.decimal(2) == "10.57"
        assert cost < Fraction(32, 3) < Fraction(4) / Fraction("0.365") < 11


class TestTheKey:
    """8.2 at three steps cannot be: with 6.2 at two steps it is exactly 8.0."""

    sides = 11
    widest_cost_at_two = Fraction("6.2") + Fraction(1, 20)

    def test_the_second_preimage_leaves_little(self):
        """From (2 + 1) 360 / h_2 <= 6.25."""
        least_width = Fraction(3 * 360) / self.widest_cost_at_two
        assert least_width == Fraction("172.8")
        assert 180 - least_width == Fraction("7.2")

    def test_the_widest_gap_is_wider(self):
        """At most 11 stable orientations share half a turn."""
        assert Fraction(180, self.sides) > Fraction("7.2")
        assert Fraction("16.3") < Fraction(180, self.sides) < Fraction("16.4")

    @pytest.mark.parametrize("name", catalogue_names())
    def test_the_image_of_a_period_misses_one_gap(self, name):
        """So a period is a preimage as soon as a gap exceeds what is left of the period."""
        transfer = FeedingProblem(catalogue_part(name)).transfer
        values, breaks = transfer.lifted_values, transfer.lifted_breaks
        for j in range(len(transfer)):
            image = transfer.image(Arc(breaks[j], transfer.period))
            assert image.width == transfer.period - (values[j] - values[j - 1])

    def test_the_rebuilt_part(self):
        problem = FeedingProblem(catalogue_part("key"))
        assert problem.transfer.period == HALF_TURN
        second = problem.preimages.of_steps(2).width
        assert Angle.from_degrees("172.8") <= second < HALF_TURN
        assert problem.preimages.of_steps(3).width == HALF_TURN
        assert problem.expected_cost(3).rational == 8

    def test_the_period_is_half_a_turn(self):
        """A shorter one would be 90 degrees at most, and h_2 no more than that."""
        next_period = HALF_TURN - Angle.from_degrees(90)
        assert next_period * 2 == HALF_TURN
        assert next_period < Angle.from_degrees("172.8")
