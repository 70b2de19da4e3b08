"""Text with square roots: what is read, what is refused."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from stochgeom.errors import FloatRefusedError, MixedFieldsError, NumberError, NumberLimitError
from stochgeom.exact.algebraic import Algebraic
from stochgeom.exact.fields import quadratic_field, regular_polygon_field
from stochgeom.exact.surds import exact_scalar, field_symbols, rational_bounds, scalar_text

ROOT3 = Algebraic(quadratic_field(3), [0, 1])


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("sqrt(3)", ROOT3),
        (" 1/2 * sqrt( 3 ) ", ROOT3 / 2),
        ("sqrt(12) - sqrt(27)/3", ROOT3),
        ("-(1 - sqrt(3))/.5e1", (ROOT3 - 1) / 5),
        ("2 - -sqrt(3)", ROOT3 + 2),
        ("-sqrt(3)^2", -3),
        ("(1+sqrt(3))^2", 4 + 2 * ROOT3),
        ("1/sqrt(1/3)", ROOT3),
        ("sqrt(0.75)", ROOT3 / 2),
        ("sqrt(16)/sqrt(9)", mpq(4, 3)),
        ("sqrt(10000000000000000000000000000000000000000)", 10**20),
        ("3/4", mpq(3, 4)),
        (ROOT3, ROOT3),
        (ROOT3 * ROOT3, 3),
        (7, 7),
    ],
)
def test_what_is_read(text, value):
    assert exact_scalar(text) == value


@pytest.mark.parametrize(
    ("text", "error", "words"),
    [
        ("sqrt(-1)", NumberError, "square root of -1; accepted: of 0 and positive numbers"),
        ("sqrt(2) + sqrt(3)", MixedFieldsError, "numbers of one field"),
        ("sqrt(2)*sqrt(3)", MixedFieldsError, "numbers of one field"),
        ("sqrt(sqrt(2))", NumberError, "accepted: of rational numbers"),
        ("sqrt 2", NumberError, "'sqrt' without '('"),
        ("sqrt(2", NumberError, "')' is missing"),
        ("sqrt()", NumberError, "a number is missing before ')'"),
        ("2 sqrt(3)", NumberError, "'sqrt' is not expected there"),
        ("sqrt(2)*pi", NumberError, "'pi' is not known"),
        ("sqrt(2)^-1", NumberError, "exponent '-'; accepted: 0 to 1000"),
        ("sqrt(2)^9999", NumberError, "exponent '9999'"),
        ("1/(sqrt(4) - 2)", NumberError, "divides by 0"),
        ("sqrt(2)#", NumberError, "'#' is not expected"),
        ("sqrt(999999999999999999)", NumberLimitError, "at most 1000000000000, or a square"),
        ("(" * 200 + "sqrt(2)" + ")" * 200, NumberLimitError, "more than 100 parentheses"),
        ("sqrt(2)+" + "1+" * 20_000 + "1", NumberLimitError, "at most 20000"),
        ("g + 1", NumberError, "is not a number"),
    ],
)
def test_what_is_refused_names_the_place(text, error, words):
    with pytest.raises(error) as caught:
        exact_scalar(text, where="vertex 7, x")
    assert words in str(caught.value)
    assert caught.value.where == "vertex 7, x"


def test_floats_stay_refused():
    with pytest.raises(FloatRefusedError):
        exact_scalar(2**0.5)


@pytest.mark.parametrize("n", [5, 7, 16])
def test_text_of_a_field_reads_back(n):
    field = regular_polygon_field(n)
    symbols = field_symbols(field)
    for number in (symbols["g"] / 3 - 1, symbols["g"] ** 2 * symbols["s"] - symbols["s"]):
        assert exact_scalar(scalar_text(number), symbols=symbols) == number


def test_rational_bounds_enclose():
    low, high = rational_bounds(ROOT3, 100)
    assert low * low < 3 < high * high
    assert high - low < mpq(1, 2**99)
    assert rational_bounds(mpq(1, 3)) == (mpq(1, 3), mpq(1, 3))
