"""Quotients of sums of angles, and the order of their products."""

from __future__ import annotations

import pickle

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.errors import InputError, PrecisionLimitError
from stochgeom.exact import quotients
from stochgeom.exact.angles import Angle
from stochgeom.exact.quotients import (
    SumQuotient,
    number_decimal,
    number_sign,
    quotient,
    sign_of_products,
)
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.sums import AngleSum
from tests.strategies import directions, ratios

A = AngleSum(0, [(1, Angle(0, (2, 1)))])
B = AngleSum(0, [(1, Angle(0, (3, 4)))])
"""B = 2 A, for (2 + i)^2 = 3 + 4 i; but their terms differ."""
C = AngleSum(0, [(1, Angle(0, (3, 2)))])


class TestQuotients:
    def test_decimals_are_certified(self):
        assert SumQuotient(1, C).decimal(10) == "10.6856419840"
        assert str(SumQuotient(A, C)) == "0.7885"

    def test_the_same_as_a_turn_ratio(self):
        ratio = TurnRatio(mpq(2), Angle(0, (3, 2)), inverse=True)
        assert SumQuotient(2, C).decimal(20) == ratio.decimal(20)
        assert SumQuotient(2, C).to_sympy() == ratio.to_sympy()

    def test_rational_values_are_found(self):
        assert SumQuotient(C * 4, C * 6).rational == mpq(2, 3)
        assert SumQuotient(C * 4 + 2, C * 2 + 1).rational == 2
        assert SumQuotient(0, C).rational == 0
        assert SumQuotient(C * 4 + 2, C * 2).rational is None
        assert SumQuotient(C, 2).rational is None

    def test_order(self):
        small, large = SumQuotient(A, C), SumQuotient(A + mpq(1, 10**40), C)
        assert small < large
        assert large > small
        assert small < 1
        assert small > mpq(7885, 10**4)
        assert mpq(1, 2) < small

    def test_equal_by_cancelling(self):
        assert SumQuotient(A, C) == SumQuotient(A * 2, C * 2)
        assert SumQuotient(A * A.constant, C) == 0
        assert hash(SumQuotient(A, C)) == hash(SumQuotient(A * 3, C * 3))
        assert SumQuotient(A, C) != "0.7884"

    def test_equal_through_a_relation_between_angles(self):
        assert A * 2 == B
        assert SumQuotient(B, C).compare(SumQuotient(A * 2, C)) == 0
        assert SumQuotient(C, B).compare(SumQuotient(C, A * 2)) == 0
        assert sign_of_products(A, B, A * 2, A) == 0
        assert sign_of_products(A, B, A * 2, A + mpq(1, 10**30)) == -1

    def test_a_denominator_is_positive(self):
        for bottom in (0, -1, A - A, A * -1):
            with pytest.raises(InputError, match="accepted: a positive number"):
                SumQuotient(1, bottom)

    def test_what_cannot_be_decided_is_an_error(self, monkeypatch):
        monkeypatch.setattr(quotients, "COMPARE_BITS", 64)
        near = A + mpq(1, 10**60)
        with pytest.raises(PrecisionLimitError, match="may be equal"):
            sign_of_products(A, C, near, C)

    def test_kinds_of_numbers(self):
        assert quotient(0.5, 0.25) == 2.0
        assert quotient(mpq(1), mpq(4)) == mpq(1, 4)
        assert isinstance(quotient(1, C), SumQuotient)
        assert [number_sign(x) for x in (A - C, mpq(-1), 0.0)] == [-1, -1, 0]
        assert number_decimal(SumQuotient(A, C), 2) == "0.79"
        assert number_decimal(0.1, 20) == "0.10000000000000000555"

    def test_repr_is_the_constructor_call(self):
        value = SumQuotient(A + 1, C)
        assert eval(repr(value)) == value

    def test_float_and_pickle(self):
        value = SumQuotient(1, C)
        assert float(value) == pytest.approx(10.685641984)
        assert pickle.loads(pickle.dumps(value)) == value


sums = st.lists(st.tuples(ratios, directions), max_size=3).map(
    lambda terms: AngleSum(terms[0][0] if terms else 0, [(q, Angle(0, d)) for q, d in terms])
)


FEW = settings(max_examples=min(200, settings.default.max_examples))


class TestProducts:
    @FEW
    @given(sums, sums, sums, sums)
    def test_the_order_of_products_is_that_of_floats(self, a, b, c, d):
        off = float(a) * float(b) - float(c) * float(d)
        found = sign_of_products(a, b, c, d)
        if abs(off) > 1e-9:
            assert found == (1 if off > 0 else -1)
        assert sign_of_products(c, d, a, b) == -found
        assert sign_of_products(a, b, b, a) == 0
