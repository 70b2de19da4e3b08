"""Section 7.2: sensors, and plans that sense and act."""

from __future__ import annotations

from fractions import Fraction

import pytest
from gmpy2 import mpq

from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.exact.quotients import number_decimal
from stochgeom.sensing.diameter_sensor import sensor_of_diameters
from stochgeom.sensing.one_step import one_step_plan
from stochgeom.sensing.planners import iterative_sensor_plan
from stochgeom.sensing.sensing_problem import SensingProblem
from stochgeom.sensing.sensors import Sensor
from stochgeom.thesis.errata import SENSORS
from stochgeom.thesis.parts import catalogue_names, catalogue_part

PRIOR = [Fraction(k, 10) for k in (6, 1, 1, 1, 1)]


def recycled(success_by_reading, marginal, rounds):
    """Return the mean number of rounds of a part that is sensed anew in each, added up."""
    succeeds = sum(m * p for m, p in zip(marginal, success_by_reading, strict=True))
    mean, still = Fraction(0), Fraction(1)
    for n in range(1, rounds + 1):
        mean += n * still * succeeds
        still *= 1 - succeeds
    return mean, still


class TestEquation75:
    SENSOR = Sensor.from_function(range(5), lambda state: "first" if state == 0 else "other")

    def test_what_the_source_prints(self):
        plan = one_step_plan(self.SENSOR, PRIOR)
        assert number_decimal(plan.printed_cost, 1) == "2.2"
        assert "2.2" in SENSORS["7.5"].reason

    def test_what_holds(self):
        """Rounds added up one by one, not by the formula."""
        mean, rest = recycled([Fraction(1), Fraction(1, 4)], [Fraction(3, 5), Fraction(2, 5)], 120)
        assert rest < Fraction(1, 10**60)
        plan = one_step_plan(self.SENSOR, PRIOR)
        assert abs(Fraction(plan.expected_cost) - mean) < Fraction(1, 10**50)
        assert number_decimal(plan.expected_cost, 3) == "1.429"
        assert "1.429" in SENSORS["7.5"].reason

    def test_no_sensor_at_all(self):
        blind = one_step_plan(Sensor.blind(range(5)), PRIOR)
        assert number_decimal(blind.expected_cost, 3) == "1.667"
        # Where nothing is read, both are the same.
        assert blind.printed_cost == blind.expected_cost


class TestWorkedByHand:
    """Fig. 7.1: a tree of one sensing; two bits; the recursion of 7.2.4."""

    def test_a_two_bit_reading(self):
        """Fig. 7.3, distances 2.4 and 2.6 of a range from 2 to 3, noise of 0.1.

        A normal table at -1.5, 1 and 3.5 gives .0668, .7745, .1584, .0002; what is missing from 1
        goes to the largest.
        """
        squares = {"a": mpq("2.4") ** 2, "b": mpq("2.6") ** 2}
        sensor = sensor_of_diameters(squares, 2, "0.1", between=(2, 3), digits=4)
        assert [str(float(p)) for p in sensor.likelihood[0]] == [
            "0.0668",
            "0.7746",
            "0.1584",
            "0.0002",
        ]
        assert sensor.likelihood[1] == tuple(reversed(sensor.likelihood[0]))

    def test_subplans_weighted_with_their_readings(self):
        """Look; after x try again at 1/2, after y accept: 3/4 (1 + ...) + 1/4 ..."""
        problem = PlanningProblem(
            ["good", "bad"],
            ["1/4", "3/4"],
            ["mend"],
            [[[1, 0], ["1/2", "1/2"]]],
        )
        sensor = Sensor.perfect(["good", "bad"], cost="1/10")
        plan = iterative_sensor_plan(problem, sensor, 2, accepted=["good"], action_costs="1/5")
        # Sense for .1; in 3/4 of the rounds mend for .2, which works half of the time.
        sense_first = (1 + mpq("0.1") + mpq(3, 4) * mpq("0.2")) / (mpq(1, 4) + mpq(3, 8))
        # Or mend blindly, twice: 1.4 / (1 - 3/4 / 4).
        mend_twice = mpq("1.4") / (1 - mpq(3, 16))
        assert plan.expected_cost == min(sense_first, mend_twice) == mend_twice
        free = iterative_sensor_plan(
            problem,
            sensor.with_cost(0),
            stages=["sense", "act"],
            accepted=["good"],
            action_costs="1/5",
        )
        assert free.expected_cost == (1 + mpq(3, 4) / 5) / mpq(5, 8)


@pytest.mark.parametrize("name", catalogue_names())
def test_a_look_at_the_jaws_helps_every_part_of_the_source(name):
    """With an exact sensor, one look does at least as well as any two squeezes of Table 4.1."""
    problem = SensingProblem(catalogue_part(name))
    look, squeeze, none = (
        problem.plan(stages=stages).expected_cost for stages in (["sense"], ["act"], [])
    )
    assert look <= squeeze <= none
    assert problem.one_step.expected_cost == look
    # Half a turn is never told: no less than two rounds, each 2.
    assert look >= 4
