"""`near_half`: exact halves, and close ones."""

from __future__ import annotations

import pytest
from gmpy2 import mpq
from hypothesis import given

from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle
from stochgeom.exact.balls import working_precision
from stochgeom.exact.decimals import Rounding
from stochgeom.exact.forms import sign_of_form
from stochgeom.exact.halves import HALF_BITS, HalfAngle, near_half
from tests.strategies import TINY, orientations


@pytest.mark.parametrize(
    ("angle", "half"),
    [
        (ZERO, ZERO),
        (FULL_TURN, HALF_TURN),
        (Angle.from_degrees(45), Angle.from_degrees("22.5")),
        (Angle.from_degrees("71"), Angle.from_degrees("35.5")),
        (Angle(0, (3, 4)), Angle(0, (2, 1))),
        (Angle(0, (-3, 4)), Angle(0, (1, 2))),
        (Angle(0, (-3, -4)), Angle(0, (-1, 2))),
        (Angle(0, (3, -4)), Angle(0, (-2, 1))),
        (Angle(1, (3, 4)), Angle(0, (-2, -1))),
    ],
)
def test_exact_halves(angle, half):
    assert near_half(angle) == (half, True)
    assert half + half == angle


@given(orientations.filter(lambda a: a > ZERO))
def test_a_half_is_close(angle):
    half, exact = near_half(angle)
    if exact:
        assert half + half == angle
    share = mpq(1, 2**HALF_BITS)
    assert sign_of_form(0, [(1, half), (-mpq(1, 2) * (1 - share), angle)]) >= 0
    assert sign_of_form(0, [(1, half), (-mpq(1, 2) * (1 + share), angle)]) <= 0


def test_half_of_something_tiny():
    half, exact = near_half(TINY)
    assert not exact
    assert ZERO < half < TINY


class TestHalfAngle:
    def test_degrees_of_a_half_that_is_no_angle(self):
        half = HalfAngle(Angle(0, (3, 2)))
        assert half.angle is None
        assert half.degrees(4) == "16.8450"
        assert half.degrees(3, Rounding.DOWN) == "16.845"
        assert half.degrees(2, Rounding.DOWN) == "16.84"
        assert str(half) == "16.8450°"
        assert abs(half.to_float() - 0.2940013018) < 1e-9
        with working_precision(64):
            assert half.ball() * 360 > 16

    def test_exact_halves(self):
        assert HalfAngle.of(Angle(0, (5, 2))).angle == Angle(0, (5, 2))
        assert HalfAngle(Angle.from_degrees("71")).angle == Angle.from_degrees("35.5")
        assert HalfAngle(Angle.from_degrees(-90)).angle == Angle.from_degrees(-45)
        assert HalfAngle(-Angle(0, (3, 2))).angle is None
        assert HalfAngle(Angle.from_degrees(5)).degrees(0, Rounding.UP) == "3"

    def test_order(self):
        halves = [HalfAngle(Angle.from_degrees(k)) for k in (30, -4, 7)]
        assert [half.doubled.degrees(0) for half in sorted(halves)] == ["-4", "7", "30"]
        assert halves[0] == HalfAngle(Angle.from_degrees(30))

    def test_nearby_is_near(self):
        half = HalfAngle(Angle(0, (3, 2)))
        off = half.nearby + half.nearby - half.doubled
        assert abs(off.to_float() if off else 0.0) < 2.0**-19
