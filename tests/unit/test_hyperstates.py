"""`stochgeom.decision.hyperstates`: distributions over orientations."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle

WIDE = Angle(0, (-5, 12))  # 112.62 degrees
NARROW = HALF_TURN - WIDE
RECTANGLE = Hyperstate(
    (ZERO, QUARTER_TURN, HALF_TURN, HALF_TURN + QUARTER_TURN), (WIDE, NARROW, WIDE, NARROW)
)


def test_probabilities():
    assert len(RECTANGLE) == 4
    assert RECTANGLE.probabilities() == ("0.3128", "0.1872", "0.3128", "0.1872")
    assert RECTANGLE.probabilities(1) == ("0.3", "0.2", "0.3", "0.2")
    assert RECTANGLE.probability(1).rational is None
    assert RECTANGLE.probability(1) < mpq(1872, 9999) < RECTANGLE.probability(0)


def test_the_sum_is_a_full_turn():
    assert RECTANGLE.total == FULL_TURN
    assert Hyperstate((ZERO,), (FULL_TURN,)).total == FULL_TURN
    assert Hyperstate((ZERO,), (FULL_TURN,)).probability(0).rational == 1


@pytest.mark.parametrize(
    ("widths", "likeliest"),
    [((90, 90, 90, 90), 0), ((80, 100, 100, 80), 1), ((60, 60, 60, 180), 3), ((360,), 0)],
)
def test_of_equally_likely_states_the_first_is_named(widths, likeliest):
    """Eq. 4.4."""
    angles = tuple(Angle.from_degrees(width) for width in widths)
    assert Hyperstate(tuple(range(len(angles))), angles).most_likely() == likeliest


def test_nearly_equal_states_are_told_apart():
    more = HALF_TURN + Angle(0, (10**60, 1))
    assert Hyperstate((ZERO, HALF_TURN), (FULL_TURN - more, more)).most_likely() == 1


def test_states_are_values():
    again = Hyperstate(RECTANGLE.orientations, RECTANGLE.widths)
    assert again == RECTANGLE
    assert hash(again) == hash(RECTANGLE)
    assert eval(repr(RECTANGLE)) == RECTANGLE
    with pytest.raises(AttributeError):
        RECTANGLE.widths = ()
