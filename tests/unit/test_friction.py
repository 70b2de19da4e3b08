"""Friction given as a coefficient or as an angle, and the limits that come out as friction."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import flint
import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.decision.probabilities import Enclosed
from stochgeom.errors import (
    FloatRefusedError,
    FrictionError,
    NumberError,
    PrecisionLimitError,
    PriorError,
)
from stochgeom.exact.angles import QUARTER_TURN, ZERO, Angle
from stochgeom.exact.sums import AngleSum
from stochgeom.grasping.friction import Friction
from stochgeom.grasping.friction_limits import FrictionLimit, as_probability


class TestFriction:
    @pytest.mark.parametrize(
        "value", ["0.25", "1/4", Fraction(1, 4), Decimal("0.25"), mpq(1, 4), Angle(0, (4, 1))]
    )
    def test_one_friction_in_many_notations(self, value):
        friction = Friction.of(value)
        assert friction == Friction(Angle(0, (4, 1)))
        assert (friction.coefficient, str(friction), friction.decimal()) == (
            mpq(1, 4),
            "1/4",
            "0.2500",
        )
        assert Friction.of(friction) is friction

    def test_no_friction(self):
        assert Friction.of(0) == Friction(ZERO)
        assert Friction.of(0).coefficient == 0

    def test_an_angle_without_a_rational_tangent(self):
        friction = Friction(Angle.from_degrees(15))
        assert friction.coefficient is None
        assert friction.decimal(8) == "0.26794919"  # 2 - sqrt 3
        assert str(friction) == "0.2679"

    @pytest.mark.parametrize("value", [-1, "-1/4", "-1e-9"])
    def test_negative(self, value):
        with pytest.raises(FrictionError, match=r"mu: .*negative; accepted: 0 or more"):
            Friction.of(value)

    @pytest.mark.parametrize("value", [0.25, float("nan"), float("inf"), np.float64(0.1)])
    def test_floats(self, value):
        with pytest.raises(FloatRefusedError, match=r"mu: .*binary float"):
            Friction.of(value)

    @pytest.mark.parametrize(
        "value", ["nan", "inf", "sqrt(2)", "1/0", "", None, True, "0.25 degrees"]
    )
    def test_what_is_no_number(self, value):
        with pytest.raises(NumberError, match="mu: "):
            Friction.of(value)

    @pytest.mark.parametrize("angle", [QUARTER_TURN, Angle.from_degrees(-1), Angle(1)])
    def test_angles_that_are_none(self, angle):
        with pytest.raises(FrictionError, match="from 0 to below 90"):
            Friction.of(angle)


class TestFrictionLimit:
    def test_rounded_down(self):
        third = FrictionLimit(AngleSum("1/12"))  # tan 30 degrees = .57735
        assert (third.decimal(), third.decimal(2), third.degrees(0)) == ("0.5773", "0.57", "30")

    def test_exact_decimals_are_recognised(self):
        quarter = FrictionLimit(AngleSum(0, [(1, Angle(0, (4, 1)))]))
        assert (quarter.decimal(1), quarter.decimal(2), quarter.decimal(3)) == (
            "0.2",
            "0.25",
            "0.250",
        )
        assert quarter.compare("1/4") == 0
        assert str(FrictionLimit(AngleSum(0))) == "0.0000"

    def test_exact_though_no_single_angle_tells(self):
        """arctan 1/2 + arctan 1/3 = 45 degrees."""
        limit = FrictionLimit(AngleSum(0, [(1, Angle(0, (2, 1))), (1, Angle(0, (3, 1)))]))
        assert limit.decimal(3) == "1.000"

    def test_hardly_less_than_a_decimal(self):
        below = Angle(0, (4, 1)) - Angle(0, (10**400, 1))
        assert FrictionLimit(AngleSum(0, [(1, below)])).decimal(2) == "0.24"

    def test_a_wide_enclosure_is_no_answer(self):
        wide = Enclosed.of(lambda: flint.arb("0.1", "0.05"))
        with pytest.raises(PrecisionLimitError):
            FrictionLimit(wide).decimal(2)


@pytest.mark.parametrize("value", ["-1/2", "1.01", 2])
def test_probabilities_beyond_0_and_1(value):
    with pytest.raises(PriorError, match="accepted: from 0 to 1"):
        as_probability(value)
