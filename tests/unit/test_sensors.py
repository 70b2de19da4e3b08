"""Sensors, worked by hand."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.decision.number_kinds import NumberKind
from stochgeom.errors import MixedNumbersError, SensorError
from stochgeom.exact.angles import Angle
from stochgeom.exact.quotients import SumQuotient
from stochgeom.exact.sums import AngleSum
from stochgeom.sensing.sampling import sampled_sensor, sensor_from_counts
from stochgeom.sensing.sensor_design import fuse_sensors
from stochgeom.sensing.sensors import Sensor

URNS = Sensor(
    ["red", "white"],
    {"A": {"red": "1/2", "white": "1/2"}, "B": {"red": "1/3", "white": "2/3"}},
    name="ball",
)


class TestBayes:
    def test_marginal_and_posterior(self):
        """Two urns, A twice as likely: m(red) = 2/3 1/2 + 1/3 1/3 = 4/9, P(A | red) = 3/4."""
        prior = {"A": "2/3", "B": "1/3"}
        assert URNS.marginal(prior) == {"red": mpq(4, 9), "white": mpq(5, 9)}
        assert URNS.posterior(prior, "red") == (mpq(3, 4), mpq(1, 4))
        assert URNS.posterior(prior, "white") == (mpq(3, 5), mpq(2, 5))

    def test_the_posterior_is_the_hyperstate_times_the_diagonal_matrix(self):
        """Eq. 7.3, up to the marginal."""
        matrix = URNS.matrix("red")
        assert matrix == ((mpq(1, 2), 0), (0, mpq(1, 3)))
        prior = (mpq(2, 3), mpq(1, 3))
        times = tuple(sum(p * row[k] for p, row in zip(prior, matrix, strict=True)) for k in (0, 1))
        assert times == URNS.joint(prior, "red") == (mpq(1, 3), mpq(1, 9))

    def test_two_readings_are_two_updates(self):
        once = URNS.posterior(["1/2", "1/2"], "red")
        assert URNS.posterior(once, "red") == (mpq(9, 13), mpq(4, 13))

    def test_a_hyperstate_need_not_sum_to_one(self):
        assert URNS.posterior([2, 1], "red") == (mpq(3, 4), mpq(1, 4))

    def test_irrational_priors_stay_exact(self):
        width = AngleSum(0, [(1, Angle(0, (3, 2)))])
        joint = URNS.joint([width, 1 - width], "red")
        assert joint == (width * mpq(1, 2), (1 - width) * mpq(1, 3))
        posterior = URNS.posterior([width, 1 - width], "red")
        assert all(isinstance(p, SumQuotient) for p in posterior)
        assert posterior[0] < posterior[1]
        assert sum(float(p) for p in posterior) == pytest.approx(1)

    def test_floats_stay_floats(self):
        sensor = URNS.to_float()
        assert sensor.numbers is NumberKind.FLOAT
        posterior = sensor.posterior(np.array([0.5, 0.5]), "red")
        assert posterior == pytest.approx((0.6, 0.4))

    def test_floats_and_exact_numbers_are_not_mixed(self):
        with pytest.raises(MixedNumbersError, match="likelihood of the sensor"):
            URNS.marginal([0.5, 0.5])
        with pytest.raises(MixedNumbersError, match="float"):
            URNS.to_float().marginal(["1/2", "1/2"])

    def test_a_sensor_of_zeros_and_ones_suits_both(self):
        sensor = Sensor.perfect(["a", "b"])
        assert sensor.marginal([0.25, 0.75]) == {"a": 0.25, "b": 0.75}
        assert sensor.marginal(["1/4", "3/4"]) == {"a": mpq(1, 4), "b": mpq(3, 4)}


class TestKinds:
    def test_perfect_blind_and_partition(self):
        assert Sensor.perfect(range(3)).blocks == {0: (0,), 1: (1,), 2: (2,)}
        assert Sensor.blind(range(3)).blocks == {"nothing": (0, 1, 2)}
        parity = Sensor.from_function(range(4), lambda state: state % 2)
        assert parity.blocks == {0: (0, 2), 1: (1, 3)}

    def test_noise_has_no_blocks(self):
        assert URNS.blocks is None

    def test_a_noisy_sensor_spreads_its_error(self):
        sensor = Sensor.noisy(["a", "b", "c"], "0.3")
        assert sensor.probability("b", "a") == mpq(3, 20)
        assert sensor.column("a") == (mpq(7, 10), mpq(3, 20), mpq(3, 20))

    def test_rows_and_mappings_are_the_same(self):
        rows = Sensor(["red", "white"], [["1/2", "1/2"], ["1/3", "2/3"]], states=["A", "B"])
        assert rows == URNS
        assert hash(rows) == hash(URNS)
        assert Sensor(["x"], [[1], [1]]).states == (0, 1)

    def test_an_array_of_floats(self):
        sensor = Sensor(["x", "y"], np.array([[0.25, 0.75], [1.0, 0.0]]))
        assert sensor.likelihood == ((0.25, 0.75), (1.0, 0.0))

    def test_fractions_are_read(self):
        assert Sensor(["x", "y"], [[Fraction(1, 3), Fraction(2, 3)]]).exact

    def test_repr_tells_the_size(self):
        assert repr(URNS) == "<Sensor ball: 2 readings of 2 states, rational numbers>"


class TestFusion:
    def test_readings_multiply(self):
        both = fuse_sensors(URNS, URNS)
        assert both.readings[1] == ("red", "white")
        assert both.likelihood[1] == (mpq(1, 9), mpq(2, 9), mpq(2, 9), mpq(4, 9))

    def test_costs_and_errors_add(self):
        a = Sensor(["x"], [[1]], cost="1/4", row_error="1/100")
        both = fuse_sensors(a, Sensor(["y"], [[1]], cost="1/2", row_error="1/50"))
        assert (both.cost, both.row_error) == (mpq(3, 4), mpq(3, 100))

    def test_the_posterior_is_that_of_one_after_the_other(self):
        prior = ["1/4", "3/4"]
        once = URNS.posterior(prior, "red")
        assert fuse_sensors(URNS, URNS).posterior(prior, ("red", "white")) == URNS.posterior(
            once, "white"
        )


class TestCounts:
    def test_frequencies(self):
        sensor = sensor_from_counts(["x", "y"], {"a": {"x": 3, "y": 1}, "b": {"y": 5}})
        assert sensor.likelihood == ((mpq(3, 4), mpq(1, 4)), (0, 1))

    def test_a_pseudo_count_keeps_every_reading_possible(self):
        sensor = sensor_from_counts(["x", "y"], {"a": {"x": 3}}, pseudo_count=1)
        assert sensor.likelihood == ((mpq(4, 5), mpq(1, 5)),)

    def test_samples_come_near_the_model(self):
        model = Sensor.noisy(["a", "b", "c"], "3/10")
        found = sampled_sensor(model, 4000, seed=7)
        for row, true in zip(found.likelihood, model.likelihood, strict=True):
            assert max(abs(p - q) for p, q in zip(row, true, strict=True)) < mpq(1, 40)
            assert sum(row) == 1

    def test_the_same_seed_gives_the_same_sensor(self):
        model = Sensor.noisy(["a", "b"], "1/3")
        assert sampled_sensor(model, 50, seed=1) == sampled_sensor(model, 50, seed=1)
        assert sampled_sensor(model, 50, seed=1) != sampled_sensor(model, 50, seed=2)

    def test_impossible_readings_are_never_drawn(self):
        model = Sensor.from_function(["a", "b"], lambda state: state)
        assert sampled_sensor(model, 100).likelihood == ((1, 0), (0, 1))

    def test_no_readings_are_refused(self):
        with pytest.raises(SensorError, match="0 readings; accepted: whole numbers from 1 on"):
            sampled_sensor(URNS, 0)
        with pytest.raises(SensorError, match="counts of state 'a': counts 0, 0"):
            sensor_from_counts(["x", "y"], {"a": {}})
