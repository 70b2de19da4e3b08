"""`near_half`: exact halves, and close ones."""

from __future__ import annotations

import pytest
from gmpy2 import mpq
from hypothesis import given

from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle
from stochgeom.exact.forms import sign_of_form
from stochgeom.exact.halves import HALF_BITS, near_half
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
