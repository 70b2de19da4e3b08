"""Float values of single angles: within their bound of Arb's, on this platform's arctan2."""

from __future__ import annotations

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.errors import NumberLimitError
from stochgeom.exact import forms
from stochgeom.exact.angles import HALF_TURN, ZERO, Angle
from stochgeom.exact.balls import full_turn_ball, rational_ball, working_precision
from stochgeom.exact.forms import sign_of_form
from stochgeom.exact.shadows import shadow, shadow_error
from tests.strategies import TINY, angles

HUGE = 10**400
BIG = st.integers(1, HUGE) | st.integers(1, 2**70) | st.integers(1, 50)
COMPONENT = st.builds(lambda sign, v: sign * v, st.sampled_from([-1, 0, 1]), BIG)


def excess(angle):
    """Return how far the shadow is from the angle, as a share of the bound."""
    value = shadow(angle)
    with working_precision(2000):
        off = abs(angle.ball() * full_turn_ball() - rational_ball(mpq(value)))
        return float(off) / shadow_error(angle)


@given(
    st.tuples(COMPONENT, COMPONENT).filter(any),
    st.sampled_from([0, 1, -1, mpq(1, 3), 10**6, -(2**31), mpq(10**9, 7)]),
)
def test_shadows_are_within_their_bound(direction, turns):
    assert excess(Angle(turns, direction)) < 1


@pytest.mark.parametrize(
    "direction", [(10**400, 1), (10**400, -1), (-(10**400), -1), (1, -(2**70))]
)
def test_shadows_of_lopsided_directions(direction):
    assert excess(Angle(0, direction)) < 1


def test_an_angle_beyond_floats():
    with pytest.raises(NumberLimitError, match="accepted: below"):
        shadow(Angle(10**400))
    assert sign_of_form(0, [(1, Angle(10**400))]) == 1  # which the filter leaves to the others


TERMS = st.lists(
    st.tuples(st.fractions(max_denominator=50), angles() | st.just(TINY)), min_size=1, max_size=4
)


@given(TERMS, st.fractions(max_denominator=16))
def test_forms_have_one_sign_by_both_roads(terms, turns):
    quick = sign_of_form(turns, terms)
    saved = forms._filtered
    forms._filtered = lambda *_: 0
    try:
        assert sign_of_form(turns, terms) == quick
    finally:
        forms._filtered = saved


@pytest.mark.parametrize("little", [mpq(1, 10**14), mpq(1, 10**17), mpq(1, 10**300)])
def test_the_filter_believes_no_difference_it_cannot_see(little):
    a = Angle(0, (3, 2))
    close = [(1, a), (-1 - little, a)]
    assert forms._filtered(mpq(0), close) in {0, -1}
    assert sign_of_form(0, close) == -1
    assert forms._filtered(mpq(0), [(mpq(1), a), (mpq(-1), a)]) == 0
    assert sign_of_form(0, [(1, a), (-1, a)]) == 0


@pytest.mark.parametrize(
    "scale", [mpq(10) ** 300, mpq(1, 10**300), mpq(10) ** 400, mpq(1, 10**400)]
)
def test_coefficients_at_the_ends_of_the_range_of_floats(scale):
    for sign in (1, -1):
        assert sign_of_form(0, [(sign * scale, HALF_TURN), (-sign * scale / 2, HALF_TURN)]) == sign
    assert sign_of_form(scale, [(scale, ZERO), (-2 * scale, HALF_TURN)]) == 0
