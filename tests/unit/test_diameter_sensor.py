"""The sensor of the distance between the jaws, and plans with it for parts."""

from __future__ import annotations

from fractions import Fraction

import pytest
from gmpy2 import mpq

from stochgeom.errors import PrecisionLimitError, ProblemError
from stochgeom.exact.angles import Angle
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.sensing.diameter_sensor import (
    JawRange,
    diameter_sensor,
    jaw_range,
    sensor_of_diameters,
)
from stochgeom.sensing.sensing_problem import SensingProblem
from stochgeom.thesis.parts import catalogue_part
from tests.strategies import SPECIAL

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
FOURGON = [(52, 58), (0, 55), (8, 17), (51, 0)]


class TestExactReadings:
    def test_diameters_of_a_rectangle(self):
        assert diameter_sensor(RECTANGLE).blocks == {
            "2": ("0.0000", "180.0000"),
            "3": ("90.0000", "270.0000"),
        }

    def test_equal_diameters_of_different_grasps(self):
        """The square is 1 wide in all four grasps; its mate is wider by 1e-30 one way."""
        assert len(diameter_sensor([(0, 0), (1, 0), (1, 1), (0, 1)]).readings) == 1
        wide = 1 + Fraction(1, 10**30)
        almost = diameter_sensor([(0, 0), (wide, 0), (wide, 1), (0, 1)])
        assert len(almost.readings) == 2
        assert [len(block) for block in almost.blocks.values()] == [2, 2]

    def test_equal_irrational_diameters(self):
        """Sides of 1 and 2 turned by 45 degrees: diameters root 2 and 2 root 2, each twice."""
        part = [(0, 0), (2, 2), (1, 3), (-1, 1)]
        assert diameter_sensor(part).blocks == {
            "1.4142": ("135.0000", "315.0000"),
            "2.8284": ("45.0000", "225.0000"),
        }

    def test_names_tell_near_diameters_apart(self):
        near = sensor_of_diameters({"a": mpq(2), "b": mpq(2) + mpq(1, 10**12)})
        assert len(set(near.readings)) == 2


class TestBins:
    def test_edges_are_equally_spaced(self):
        assert JawRange(mpq(1), mpq(2)).edges(0) == []
        assert JawRange(mpq(0), mpq(1)).edges(2) == [mpq(1, 4), mpq(1, 2), mpq(3, 4)]

    def test_a_diameter_at_an_edge_is_in_the_bin_above(self):
        sensor = sensor_of_diameters({"a": mpq(4), "b": mpq(9, 4), "c": mpq(9)}, 2, between=(1, 3))
        assert sensor.blocks == {
            "below 1.5": (),
            "1.5 to 2": ("b",),
            "2 to 2.5": ("a",),
            "from 2.5": ("c",),
        }

    def test_an_irrational_diameter_beside_an_edge(self):
        root_two = mpq("1.41421356237309504880168872420969807856967187537694")
        for edge, place in ((root_two, 1), (root_two + mpq(1, 10**45), 0)):
            sensor = sensor_of_diameters({"a": mpq(2)}, 1, between=(edge - 1, edge + 1))
            assert sensor.likelihood[0][place] == 1

    def test_beyond_the_range_the_outer_bins_count(self):
        sensor = sensor_of_diameters({"a": mpq(1), "b": mpq(100)}, 1, between=(4, 6))
        assert sensor.blocks == {"below 5": ("a",), "from 5": ("b",)}
        negative = sensor_of_diameters({"a": mpq(1)}, 1, between=(-4, 2))
        assert negative.likelihood == ((0, 1),)

    def test_no_bits_are_no_reading(self):
        assert diameter_sensor(RECTANGLE, 0).readings == ("anything",)
        assert diameter_sensor(RECTANGLE, 0, "1/2").likelihood[0] == (1,)

    @pytest.mark.parametrize(
        ("values", "low", "high"),
        [
            (["4", "9"], "2", "3"),
            (["2", "8"], "1.41", "2.83"),
            (["1", "1.0000000001"], "1", "1.0000000001"),
            (["1e-20", "4e-20"], "0.0000000001", "0.0000000002"),
            (["9"], "0", "6"),
        ],
    )
    def test_the_range_holds_the_diameters(self, values, low, high):
        squares = [mpq(Fraction(value)) for value in values]
        found = jaw_range(squares)
        assert found.low <= mpq(Fraction(low))
        assert found.high >= mpq(Fraction(high)) or found.high**2 >= max(squares)
        if len(squares) > 1:
            true = float(max(squares)) ** 0.5 - float(min(squares)) ** 0.5
            assert float(found.width) <= 1.03 * true
        assert found.low**2 <= min(squares) <= max(squares) <= found.high**2

    def test_noise_as_a_share_or_as_a_length(self):
        share = diameter_sensor(FOURGON, 2, "0.1", between=(50, 60))
        assert share == diameter_sensor(FOURGON, 2, sd=1, between=(50, 60))
        assert share.row_error == mpq(4, 10**15)
        assert diameter_sensor(FOURGON, 2, "0.1").name == "diameter, 2 bits, noise 127/200"

    def test_equal_diameters_have_equal_rows(self):
        rows = diameter_sensor(FOURGON, 3, "0.2").likelihood
        assert rows[:4] == rows[4:]
        assert len(set(rows)) == 4


class TestParts:
    @pytest.mark.parametrize("name", ["rectangle", "4gon", "house", "key"])
    def test_without_a_look_costs_are_those_of_table_4_1(self, name):
        part = catalogue_part(name)
        feeding, sensing = FeedingProblem(part), SensingProblem(part)
        for squeezes in (0, 1):
            costs = [feeding.expected_cost(i) for i in range(1, squeezes + 2)]
            plan = sensing.plan(stages=["act"] * squeezes)
            assert plan.decimal(10) == min(costs).decimal(10)

    def test_a_rectangle_needs_one_look(self):
        problem = SensingProblem(RECTANGLE)
        assert problem.plan(1).expected_cost == 4
        assert problem.one_step.expected_cost == 4
        assert problem.plan(2, good_enough="1/2").tree.depth == 1

    def test_a_square_has_nothing_to_read(self):
        problem = SensingProblem([(0, 0), (1, 0), (1, 1), (0, 1)])
        assert problem.plan(2).expected_cost == 8 == problem.plan(0).expected_cost

    def test_a_period_of_a_quarter_turn(self):
        """The sensor could tell grasps apart that squeezes cannot: all squeezes are searched."""
        part = SPECIAL[4]
        assert part.name == "period 90, r = 1"
        problem = SensingProblem(part)
        assert problem.orienting.transfer.order == 4
        angles = [problem.orienting.angle(a) for a in problem.orienting.problem.actions]
        assert max(angles) - min(angles) > Angle.from_degrees(180)
        # But here the diameters are alike too, 2 and 3 / root 2, each four times.
        assert [len(block) for block in problem.sensor.blocks.values()] == [4, 4]
        assert problem.plan(2).expected_cost == 8

    def test_costs_of_filter_and_sensor(self):
        problem = SensingProblem(RECTANGLE, cost_ratio="1/2", sensor_cost="1/4")
        plan = problem.plan(1)
        assert plan.expected_cost == (1 + mpq(1, 2) + mpq(1, 4)) / mpq(1, 2)
        assert problem.one_step.expected_cost == plan.expected_cost
        dear = SensingProblem(RECTANGLE, sensor_cost=2)
        assert dear.plan(1).tree.sensings == 0

    def test_a_chosen_orientation(self):
        problem = SensingProblem(RECTANGLE, accepted=["90.0000"])
        assert problem.plan(1).tree.text().count("accept 90.0000° (") >= 1
        assert problem.plan(0).decimal(4) == "10.6856"

    def test_a_discrete_prior(self):
        import stochgeom as sg

        prior = sg.DiscretePrior([(0, "1/2"), (90, "1/2")])
        problem = SensingProblem(RECTANGLE, prior=prior)
        assert problem.orienting.problem.prior == (mpq(1, 2), mpq(1, 2), 0, 0)
        assert problem.plan(1).expected_cost == 2

    def test_a_prior_without_exact_masses_is_refused(self):
        import stochgeom as sg

        with pytest.raises(ProblemError, match="not exact"):
            SensingProblem(RECTANGLE, prior=sg.WrappedNormal(mean=0, sd=10))

    def test_rounded_likelihoods_leave_the_decimals_certain(self):
        rough = SensingProblem(FOURGON, 2, "0.2", digits=3)
        fine = SensingProblem(FOURGON, 2, "0.2", digits=30)
        low, high = rough.plan(1).cost_bounds
        assert low <= fine.plan(1).expected_cost <= high
        usual = SensingProblem(FOURGON, 2, "0.2")
        assert fine.plan(1).decimal(10) == usual.plan(1).decimal(10)
        with pytest.raises(PrecisionLimitError, match="likelihoods of more digits"):
            rough.plan(1).decimal(8)

    def test_turns_are_named(self):
        text = SensingProblem(FOURGON, 2, "0.05").plan(2).tree.text()
        assert "turn 14.0362°, squeeze" in text
        assert text.startswith("read diameter\n")


TABLE = {
    ("rectangle", 2, "0.2", 1): ("6.0000", "4.0250", "4.0250", "4.0023"),
    ("house", 1, "0.3", 1): ("5.0304", "4.2008", "4.2008", "4.0855"),
    ("4gon", 2, "0.05", 1): ("11.9814", "5.0018", "5.1314", "5.0016"),
    ("4gon", 1, "0.3", 1): ("11.9814", "7.4164", "6.3023", "6.3023"),
}
"""Expected costs for c = 1 and a free sensor: no look, look first, look last, any order."""


class TestOrders:
    """Sense, then act; or act, then sense? The source asks (7.2.5)."""

    @pytest.mark.parametrize(("name", "bits", "noise", "squeezes"), TABLE)
    def test_the_table(self, name, bits, noise, squeezes):
        found = SensingProblem(catalogue_part(name), bits, noise).compare_orders(squeezes)
        plans = (found.blind, found.sense_then_act, found.act_then_sense, found.mixed)
        costs = tuple(plan.decimal(4) for plan in plans)
        assert costs == TABLE[name, bits, noise, squeezes]
        assert all(plan.proven for plan in plans)

    def test_a_known_plan_of_mixed_moves_is_taken(self):
        problem = SensingProblem(Part(RECTANGLE), 1, "0.3")
        plan = problem.plan(2)
        assert problem.compare_orders(1, mixed=plan).mixed is plan
