"""Sensors, decisions and horizons that are not acceptable: the error says what and where."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from stochgeom.decision.additive_costs import AdditiveCost
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.errors import (
    CostError,
    DuplicateLabelError,
    EmptyProblemError,
    ImpossibleReadingError,
    InputError,
    MixedNumbersError,
    NodeLimitError,
    NoPlanError,
    NotStochasticError,
    ProblemError,
    SensorError,
    ShapeMismatchError,
    UnknownLabelError,
)
from stochgeom.sensing.and_or_tree import all_sensor_plans
from stochgeom.sensing.calibration import calibration_problem
from stochgeom.sensing.decisions import accept_groups, accept_one_of, lose_by_table
from stochgeom.sensing.diameter_sensor import diameter_sensor
from stochgeom.sensing.one_step import one_step_plan
from stochgeom.sensing.plan_tasks import MOST_MOVES
from stochgeom.sensing.planners import iterative_sensor_plan, plan_for_cost, sensor_plan
from stochgeom.sensing.recognition import RecognitionProblem
from stochgeom.sensing.sensing_problem import SensingProblem
from stochgeom.sensing.sensor_design import fuse_sensors
from stochgeom.sensing.sensors import Sensor

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
COIN = PlanningProblem(["a", "b"], ["1/2", "1/2"], ["turn"], [[[0, 1], [1, 0]]])


class TestLikelihoods:
    def test_a_row_that_does_not_sum_to_one(self):
        with pytest.raises(NotStochasticError, match=r"likelihood of state 'b': the sum is 11/10"):
            Sensor(["x", "y"], {"a": ["0.5", "0.5"], "b": ["0.5", "0.6"]})

    def test_a_float_row_that_does_not_sum_to_one(self):
        with pytest.raises(NotStochasticError, match=r"state 0: the sum is 0\.9"):
            Sensor(["x", "y"], [[0.5, 0.4]])

    def test_a_negative_probability(self):
        with pytest.raises(NotStochasticError, match="state 'a', entry 1: probability -1/2"):
            Sensor(["x", "y"], {"a": ["3/2", "-1/2"]})

    def test_a_row_that_does_not_cover_the_readings(self):
        with pytest.raises(ShapeMismatchError, match="state 'a': nothing for the reading 'y'"):
            Sensor(["x", "y"], {"a": {"x": 1}})
        with pytest.raises(ShapeMismatchError, match="state 'a': 1 likelihoods; accepted: 2"):
            Sensor(["x", "y"], {"a": [1]})

    def test_a_reading_that_is_none(self):
        with pytest.raises(UnknownLabelError, match="state 'a': 'z' is no reading; accepted: 'x'"):
            Sensor(["x"], {"a": {"x": 1, "z": 0}})

    def test_labels_given_twice_or_not_at_all(self):
        with pytest.raises(DuplicateLabelError, match="reading 1: the label 'x'"):
            Sensor(["x", "x"], {"a": [1, 0]})
        with pytest.raises(EmptyProblemError, match="no reading"):
            Sensor([], {"a": []})
        with pytest.raises(EmptyProblemError, match="no state"):
            Sensor(["x"], {})

    def test_floats_among_exact_numbers(self):
        with pytest.raises(MixedNumbersError, match=r"state 'b', entry 0: 0\.5 is a float"):
            Sensor(["x", "y"], {"a": ["1/3", "2/3"], "b": [0.5, 0.5]})

    @pytest.mark.parametrize("likelihood", ["ab", 3, None])
    def test_no_table(self, likelihood):
        with pytest.raises(ProblemError):
            Sensor(["x"], likelihood)

    def test_states_and_rows_that_differ(self):
        with pytest.raises(ShapeMismatchError, match="1 rows; accepted: 2"):
            Sensor(["x"], [[1]], states=["a", "b"])
        with pytest.raises(ShapeMismatchError, match="state 'b' has no likelihood"):
            Sensor(["x"], {"a": [1]}, states=["a", "b"])

    @pytest.mark.parametrize("cost", ["-1", 0.5, float("nan"), "x"])
    def test_a_cost_that_is_none(self, cost):
        with pytest.raises(InputError):
            Sensor(["x"], [[1]], cost=cost)

    def test_a_noisy_sensor_of_one_state(self):
        with pytest.raises(SensorError, match="one state"):
            Sensor.noisy(["a"], "1/10")


class TestReadings:
    def test_a_reading_of_probability_zero_has_no_posterior(self):
        with pytest.raises(
            ImpossibleReadingError, match="reading 'b': its probability is 0"
        ) as told:
            Sensor.perfect(["a", "b"]).posterior([1, 0], "b")
        assert told.value.where == "reading 'b'"
        assert "accepted: 'a'" in told.value.message

    def test_a_hyperstate_that_is_zero(self):
        with pytest.raises(ImpossibleReadingError, match="none, the hyperstate is 0"):
            Sensor.perfect(["a", "b"]).posterior([0, 0], "b")

    def test_an_unknown_reading(self):
        with pytest.raises(UnknownLabelError, match="'c' is no reading; accepted: 'a', 'b'"):
            Sensor.perfect(["a", "b"]).column("c")

    def test_a_hyperstate_of_another_length(self):
        with pytest.raises(ShapeMismatchError, match="hyperstate: 3 probabilities; accepted: 2"):
            Sensor.perfect(["a", "b"]).marginal([1, 0, 0])

    def test_a_state_that_is_none(self):
        with pytest.raises(UnknownLabelError, match="hyperstate: 'c' is no state"):
            Sensor.perfect(["a", "b"]).marginal({"c": 1})


class TestPlans:
    def test_what_is_no_sensor(self):
        with pytest.raises(SensorError, match="sensor 'eye': 3 is no sensor"):
            iterative_sensor_plan(COIN, {"eye": 3}, 1)

    def test_two_sensors_of_one_name(self):
        sensor = Sensor.perfect(["a", "b"], name="eye")
        with pytest.raises(DuplicateLabelError, match="'eye'"):
            iterative_sensor_plan(COIN, [sensor, sensor], 1)

    def test_a_sensor_of_other_states(self):
        with pytest.raises(UnknownLabelError, match="'c' is no state"):
            iterative_sensor_plan(COIN, Sensor.perfect(["a", "c"]), 1)
        with pytest.raises(ShapeMismatchError, match="in its order"):
            iterative_sensor_plan(COIN, Sensor.perfect(["b", "a"]), 1)

    def test_numbers_of_two_kinds(self):
        with pytest.raises(MixedNumbersError):
            iterative_sensor_plan(COIN, Sensor.noisy(["a", "b"], 0.25), 1)
        with pytest.raises(MixedNumbersError):
            iterative_sensor_plan(COIN.to_float(), Sensor.noisy(["a", "b"], "1/4"), 1)

    def test_a_tree_beyond_the_limit_tells_its_size(self):
        with pytest.raises(NodeLimitError, match="a tree of 88573 nodes; accepted: up to 1000"):
            iterative_sensor_plan(COIN, Sensor.perfect(["a", "b"]), 10, node_limit=1000)

    @pytest.mark.parametrize("horizon", [-1, 1.5, "2", True])
    def test_a_horizon_that_is_none(self, horizon):
        with pytest.raises(InputError, match="horizon"):
            iterative_sensor_plan(COIN, Sensor.perfect(["a", "b"]), horizon)

    def test_as_many_moves_as_the_stack_bears(self):
        """One move at each node: the node limit does not end this tree, its depth does."""
        halving = PlanningProblem(
            ["away", "goal"],
            [1, 0],
            ["try"],
            [[["1/2", "1/2"], [0, 1]]],
            AdditiveCost(states={"away": 1}),
        )
        assert plan_for_cost(halving, {}, MOST_MOVES).expected_cost == mpq(1, 2**MOST_MOVES)
        assert all_sensor_plans(halving, {}, MOST_MOVES).plans == MOST_MOVES + 1
        stages = ["act"] * (MOST_MOVES + 1)
        for planner in (plan_for_cost, all_sensor_plans):
            with pytest.raises(InputError, match=r"horizon: 301 moves; accepted: .* from 0 to 300"):
                planner(halving, {}, MOST_MOVES + 1)
        with pytest.raises(InputError, match=r"stages: 301 of them; accepted: .* to 300"):
            plan_for_cost(halving, {}, stages=stages)

    def test_a_size_of_hundreds_of_digits_is_not_written_out(self):
        with pytest.raises(NodeLimitError, match=r"a tree of more than 10\^143 nodes; accepted"):
            iterative_sensor_plan(COIN, Sensor.perfect(["a", "b"]), 300)

    def test_horizon_and_stages(self):
        sensor = Sensor.perfect(["a", "b"])
        with pytest.raises(InputError, match="one of them"):
            iterative_sensor_plan(COIN, sensor)
        with pytest.raises(InputError, match="one of them"):
            iterative_sensor_plan(COIN, sensor, 1, stages=["any"])
        with pytest.raises(InputError, match="stages: 'look'; accepted: any, act, sense"):
            iterative_sensor_plan(COIN, sensor, stages=["look"])

    @pytest.mark.parametrize("cost", [0, "-1"])
    def test_a_round_that_costs_nothing(self, cost):
        with pytest.raises(CostError, match="more than 0"):
            iterative_sensor_plan(COIN, Sensor.perfect(["a", "b"]), 1, round_cost=cost)
        with pytest.raises(CostError, match="more than 0"):
            one_step_plan(Sensor.perfect(["a", "b"]), ["1/2", "1/2"], cost)

    def test_a_goal_that_is_never_reached(self):
        problem = PlanningProblem(["a", "b"], [1, 0], ["wait"], [[[1, 0], [0, 1]]])
        sensor = Sensor.perfect(["a", "b"])
        with pytest.raises(NoPlanError, match="no plan of 2 moves ever succeeds"):
            iterative_sensor_plan(problem, sensor, 2, accepted=["b"])
        with pytest.raises(NoPlanError, match="no state that may be accepted"):
            one_step_plan(sensor, [1, 0], accepted=["b"])

    def test_a_state_that_cannot_be_accepted(self):
        with pytest.raises(UnknownLabelError, match="'c' is no state"):
            accept_one_of(["a", "b"], ["c"])
        with pytest.raises(UnknownLabelError, match="group 'g': 'c' is no state"):
            accept_groups(["a", "b"], {"g": ["c"]})

    def test_losses_of_another_kind(self):
        with pytest.raises(MixedNumbersError, match="losses are float"):
            lose_by_table(COIN, {"x": [0.5, 0]})

    def test_costs_without_end(self):
        with pytest.raises(SensorError, match="no additive cost"):
            sensor_plan(COIN, Sensor.perfect(["a", "b"]), 1)
        endless = COIN.with_cost(AdditiveCost(states={"b": "infinite"}))
        with pytest.raises(SensorError, match="state 'b': an infinite cost"):
            sensor_plan(endless, Sensor.perfect(["a", "b"]), 1)


class TestParts:
    @pytest.mark.parametrize("bits", [-1, 11, 1.0, "2", True])
    def test_bits_that_are_none(self, bits):
        with pytest.raises(SensorError, match="whole numbers from 0 to 10"):
            diameter_sensor(RECTANGLE, bits)

    def test_noise_that_is_none(self):
        with pytest.raises(SensorError, match="standard deviation -1"):
            diameter_sensor(RECTANGLE, 2, "-1")
        with pytest.raises(SensorError, match="noise without bits"):
            diameter_sensor(RECTANGLE, noise="0.1")
        with pytest.raises(SensorError, match="one of them"):
            diameter_sensor(RECTANGLE, 2, "0.1", sd="0.1")
        with pytest.raises(InputError, match="noise"):
            diameter_sensor(RECTANGLE, 2, 0.1)

    def test_a_range_that_is_empty(self):
        with pytest.raises(SensorError, match="from 3 to 3; accepted: an increasing pair"):
            diameter_sensor(RECTANGLE, 2, between=(3, 3))

    @pytest.mark.parametrize("actions", [-1, 300, 10**12])
    def test_squeezes_that_no_plan_has(self, actions):
        with pytest.raises(InputError, match=f"{actions} actions; accepted: .* from 0 to 299"):
            SensingProblem(RECTANGLE).compare_orders(actions)

    def test_sensors_that_cannot_be_fused(self):
        a = Sensor.perfect(["a", "b"])
        with pytest.raises(ShapeMismatchError, match="same states"):
            fuse_sensors(a, Sensor.perfect(["a", "c"]))
        with pytest.raises(MixedNumbersError, match="one kind"):
            fuse_sensors(a, a.to_float())

    def test_parts_to_recognise(self):
        with pytest.raises(SensorError, match="one part; accepted: two or more"):
            RecognitionProblem({"a": RECTANGLE})
        two = {"a": RECTANGLE, "b": [(0, 0), (1, 0), (0, 1)]}
        with pytest.raises(UnknownLabelError, match="'c' is no part"):
            RecognitionProblem(two, {"c": 1})
        with pytest.raises(SensorError, match="all shares are 0"):
            RecognitionProblem(two, {"a": 0})
        with pytest.raises(InputError, match="negative"):
            RecognitionProblem(two, {"a": -1, "b": 2})

    def test_sensors_to_calibrate(self):
        sound = Sensor.noisy(["a", "b"], "1/10")
        with pytest.raises(ShapeMismatchError, match="sensor for 'broken'"):
            calibration_problem(COIN, {"sound": sound, "broken": Sensor.blind(["a", "b"])})
        with pytest.raises(NotStochasticError):
            calibration_problem(COIN, {"x": sound, "y": sound}, {"x": mpq(1, 2), "y": mpq(1, 3)})
        with pytest.raises(UnknownLabelError, match="weights: 'z' is no value"):
            calibration_problem(COIN, {"x": sound, "y": sound}, {"z": 1})
