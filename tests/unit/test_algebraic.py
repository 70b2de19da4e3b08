"""`Algebraic`: worked values, conversions, refusals."""

from __future__ import annotations

import copy
import pickle
from fractions import Fraction

import pytest
import sympy
from gmpy2 import mpq, mpz

from stochgeom.errors import MixedFieldsError, NotRationalError
from stochgeom.exact.algebraic import Algebraic, simplified
from stochgeom.exact.fields import quadratic_field, regular_polygon_field

ROOT2 = Algebraic(quadratic_field(2), [0, 1])
PENTAGON = regular_polygon_field(5)
G, S = Algebraic(PENTAGON, [0, 1]), Algebraic(PENTAGON, [0], [1])


def test_worked_values():
    assert (ROOT2 + 1) * (ROOT2 - 1) == 1
    assert 1 / (ROOT2 + 1) == ROOT2 - 1
    assert ROOT2**5 == 4 * ROOT2
    assert Fraction(1, 2) == ROOT2**-2
    assert G * G + G == 1  # 2 cos 72 degrees is 1 / the golden ratio
    assert S * S == 4 - G * G
    assert (G + S) * (G - S) == 2 * G * G - 4
    assert (1 / (1 + S)) * (1 + S) == 1


def test_rational_numbers_mix_from_both_sides():
    for one in (1, mpz(1), mpq(1), Fraction(1)):
        assert one + ROOT2 == ROOT2 + one
        assert one - ROOT2 == -(ROOT2 - one)
        assert one * ROOT2 == ROOT2
        assert one < ROOT2
        assert not one > ROOT2
        assert one / ROOT2 == ROOT2 / 2


def test_a_rational_value_equals_and_hashes_as_the_rational_number():
    two = ROOT2 * ROOT2
    assert two == 2
    assert mpq(2) == two
    assert {two: "two"}[2] == "two"
    assert (two.rational, two.numerator, two.denominator) == (mpq(2), 2, 1)
    assert simplified(two) == 2
    assert type(simplified(two)) is type(mpq())
    assert simplified(ROOT2) is ROOT2


def test_signs_of_close_numbers():
    p, q = 1, 1
    for _ in range(400):  # p / q runs through the convergents of sqrt 2, from both sides
        p, q = p + 2 * q, p + q
        assert (q * ROOT2 - p).sign() == (1 if p * p < 2 * q * q else -1)


def test_order_across_the_root():
    assert sorted([S, G, mpq(1), G * 0]) == [0, G, 1, S]
    assert max(abs(-S), S, key=float) == S
    assert not ROOT2 - ROOT2
    assert bool(S)


def test_text_and_repr_read_back():
    assert str(3 * ROOT2 / 4 - 1) == "-1 + 3/4*sqrt(2)"
    assert str(G * S - S / 2) == "-1/2*s + g*s"
    assert str(ROOT2 - ROOT2) == "0"
    names = {
        "Algebraic": Algebraic,
        "quadratic_field": quadratic_field,
        "regular_polygon_field": regular_polygon_field,
    }
    for number in (ROOT2 / 7, G - 1, G * S - 2, S):
        assert eval(repr(number), names) == number
        assert copy.deepcopy(number) == number
        assert pickle.loads(pickle.dumps(number)) == number


def test_conversions():
    assert float(ROOT2) == 2**0.5
    assert float(ROOT2 - ROOT2) == 0.0
    assert sympy.simplify((G * S).to_sympy() - sympy.cos(sympy.pi / 10)) != 0
    assert abs((G * S).to_sympy().evalf(30) - sympy.N(float(G) * float(S))) < 1e-14


def test_two_fields_do_not_mix():
    for act in (lambda: ROOT2 + G, lambda: G * ROOT2, lambda: ROOT2 < G, lambda: ROOT2 - S):
        with pytest.raises(MixedFieldsError, match="numbers of one field"):
            act()
    assert ROOT2 != G
    assert G + ROOT2 * ROOT2 == G + 2  # a rational value is taken as such


def test_refusals():
    with pytest.raises(NotRationalError, match="irrational"):
        _ = ROOT2.numerator
    with pytest.raises(ZeroDivisionError):
        1 / (ROOT2 - ROOT2)
    with pytest.raises(TypeError):
        ROOT2 + 0.5
    with pytest.raises(TypeError):
        _ = ROOT2 < 0.5
    with pytest.raises(AttributeError, match="immutable"):
        ROOT2.field = None
