"""`AngleSum`: rational combinations of angles, exact."""

from __future__ import annotations

import copy
import pickle

import flint
import pytest
import sympy
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.errors import FloatRefusedError, InputError
from stochgeom.exact.angles import FULL_TURN, QUARTER_TURN, Angle
from stochgeom.exact.balls import working_precision
from stochgeom.exact.forms import rational_form, sign_of_form
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.sums import AngleSum
from tests.strategies import TINY, fractions, orientations

A, B, C = Angle(0, (5, 1)), Angle(0, (239, 1)), Angle(0, (3, 2))

sums = st.builds(AngleSum, fractions, st.lists(st.tuples(fractions, orientations), max_size=4))

# --- worked cases --------------------------------------------------------------------------------


def test_arithmetic_with_rational_numbers():
    third = AngleSum(0, [(1, C)])
    assert 2 * third == third * 2 == third + third
    assert 1 - third == AngleSum(1, [(-1, C)])
    assert third + mpq(1, 2) == mpq(1, 2) + third
    assert (third - third).terms == ()
    assert third * 0 == 0
    assert third < 1
    assert mpq(0) < third
    assert sum([third, 1 - third], start=mpq(0)) == 1
    for wrong in (0.5, "1/2", None):
        with pytest.raises(TypeError):
            third + wrong
        with pytest.raises(TypeError):
            third * wrong
        assert third != wrong


def test_truth_is_not_being_zero():
    machin = AngleSum("-1/8", [(4, A), (-1, B)])  # zero, though it does not look so
    assert not machin
    assert not AngleSum()
    assert AngleSum(0, [(1, C)])
    assert AngleSum("-1/9")


def test_what_is_plainly_rational_is_gathered():
    total = AngleSum("1/3", [(2, QUARTER_TURN), ("1/2", Angle.from_degrees(71)), (0, A)])
    assert total.constant == mpq(1, 3) + mpq(1, 2) + mpq(71, 720)
    assert total.terms == ()
    assert total.rational == total.constant


def test_angles_an_eighth_apart_are_one_term():
    turned = Angle(0, (-2, 3))
    assert turned == C + QUARTER_TURN
    total = AngleSum(0, [(1, C), (2, turned), (-3, C)])
    assert (total.constant, total.terms) == (mpq(1, 2), ())


def test_hidden_rational_values_are_found():
    machin = AngleSum(0, [(4, A), (-1, B)])
    assert machin.terms != ()
    assert machin.rational == mpq(1, 8)
    assert machin.decimal(2) == "0.12"  # a tie, to even: no enclosure would settle it
    assert machin == AngleSum("1/8")
    assert hash(machin) == hash(AngleSum("1/8"))
    assert AngleSum(0, [(1, A)]).rational is None
    assert rational_form("1/8", []) == mpq(1, 8)


def test_decimals_and_floats():
    third = AngleSum("1/3", [("1/2", C)])
    assert third.decimal() == "0.3801" == str(third)
    assert float(third) == 0.38012509378608306
    assert float(AngleSum()) == 0.0
    assert AngleSum("-1/3").decimal(3) == "-0.333"


def test_sympy():
    assert AngleSum("1/3", [("1/2", C)]).to_sympy() == sympy.Rational(1, 3) + sympy.atan(
        sympy.Rational(2, 3)
    ) / (4 * sympy.pi)


def test_comparison_is_exact_beyond_floats():
    small = AngleSum(0, [(1, TINY)])
    assert small.sign() == 1
    assert AngleSum(1).compare(AngleSum(1) + small) == -1
    assert AngleSum(1) < AngleSum(1) + small
    assert AngleSum("1/2").compare("1/2") == 0
    assert AngleSum("1/2").compare(TurnRatio(mpq(1), A)) == 1
    assert AngleSum(1) != "1"


def test_makers():
    total = AngleSum.of(TurnRatio(mpq(2), A))
    assert total == AngleSum(0, [(2, A)])
    assert AngleSum.of(total) is total
    with pytest.raises(InputError):
        AngleSum.of(TurnRatio(mpq(2), A, inverse=True))
    with pytest.raises(FloatRefusedError):
        AngleSum(0.5)


def test_immutable_and_copied_by_value():
    total = AngleSum("1/3", [("1/2", C)])
    with pytest.raises(AttributeError):
        total.constant = mpq(0)
    with pytest.raises(AttributeError):
        del total.terms
    assert pickle.loads(pickle.dumps(total)) == total == copy.copy(total)
    assert eval(repr(total)) == total


# --- laws ----------------------------------------------------------------------------------------


@given(sums, sums, fractions)
def test_arithmetic_agrees_with_balls(a, b, q):
    for exact, enclose in (
        (a + b, lambda: a.ball() + b.ball()),
        (a - b, lambda: a.ball() - b.ball()),
        (a.scaled(q), lambda: a.ball() * flint.arb(q.numerator) / q.denominator),
    ):
        with working_precision(100):
            assert exact.ball().overlaps(enclose())


@given(sums, sums)
def test_order_is_the_sign_of_the_difference(a, b):
    terms = [*a.terms, *((-q, angle) for q, angle in b.terms)]
    assert a.compare(b) == sign_of_form(a.constant - b.constant, terms) == -b.compare(a)
    assert (a == b) == (a.compare(b) == 0)
    assert (a < b) == (a.compare(b) < 0)


@given(orientations, orientations)
def test_the_sum_of_angles_is_their_angle(a, b):
    assert AngleSum(0, [(1, a), (1, b)]) == AngleSum(0, [(1, a + b)])
    assert AngleSum(0, [(1, a + FULL_TURN)]) == AngleSum(1, [(1, a)])


@given(sums)
def test_a_rational_value_is_the_value(a):
    if a.rational is not None:
        assert (a - AngleSum(a.rational)).sign() == 0
        assert hash(a) == hash(AngleSum(a.rational))
