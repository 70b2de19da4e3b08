"""`RealField`: which fields there are, and their roots of unity."""

from __future__ import annotations

import pickle

import mpmath
import pytest

from stochgeom.errors import NumberError, NumberLimitError
from stochgeom.exact.algebraic import make_algebraic
from stochgeom.exact.balls import working_precision
from stochgeom.exact.fields import quadratic_field, regular_polygon_field, squarefree_part
from tests.strategies import FIELDS


@pytest.mark.parametrize("field", FIELDS, ids=str)
def test_generator_and_root_are_what_the_polynomials_say(field):
    with working_precision(200):
        g, s = field.generator_ball(), field.root_ball()
        assert field.modulus.numer()(g).contains(0)
        if field.square is not None:
            assert (field.square.numer()(g) - s * s).contains(0)
            assert s > 0


@pytest.mark.parametrize("field", FIELDS, ids=str)
def test_roots_of_unity_by_mpmath(field):
    with mpmath.workdps(30):
        for j in range(-3, field.unity + 3):
            cosine, sine = (make_algebraic(field, *part) for part in field.unity_parts(j))
            turn = 2 * mpmath.pi * j / field.unity
            assert abs(mpmath.cos(turn) - float(cosine)) < 1e-15
            assert abs(mpmath.sin(turn) - float(sine)) < 1e-15
            assert cosine * cosine + sine * sine == 1


@pytest.mark.parametrize(
    ("n", "degree", "unity"),
    [(5, 2, 20), (7, 3, 28), (9, 3, 36), (16, 4, 16), (20, 4, 20), (97, 48, 388), (100, 20, 100)],
)
def test_degree_and_number_of_roots_of_unity(n, degree, unity):
    field = regular_polygon_field(n)
    assert (field.degree, field.unity) == (degree, unity)


def test_polygons_share_fields():
    assert regular_polygon_field(4) is None
    assert regular_polygon_field(10) is regular_polygon_field(5)
    assert regular_polygon_field(3) is regular_polygon_field(12) is quadratic_field(3)
    assert regular_polygon_field(8) is quadratic_field(2)


@pytest.mark.parametrize("field", FIELDS, ids=str)
def test_there_is_one_of_each_after_pickling(field):
    assert pickle.loads(pickle.dumps(field)) is field


@pytest.mark.parametrize("d", [-3, 0, 1, 4, 12, 18])
def test_no_quadratic_field(d):
    with pytest.raises(NumberError, match="squarefree numbers from 2 on"):
        quadratic_field(d)


def test_the_limit_of_regular_polygons():
    with pytest.raises(NumberLimitError, match="3 to 1000 vertices"):
        regular_polygon_field(1001)


@pytest.mark.parametrize(
    ("n", "expected"),
    [
        (1, (1, 1)),
        (8, (2, 2)),
        (72, (6, 2)),
        (999_983 * 1_000_003, (1, 999_983 * 1_000_003)),
        (999_983**2, (999_983, 1)),
        (4 * 499_979 * 499_957, (2, 499_979 * 499_957)),
    ],
)
def test_squarefree_part(n, expected):
    assert squarefree_part(n) == expected


@pytest.mark.parametrize("n", [-7, 0, 2, 1001])
def test_polygons_without_a_field(n):
    with pytest.raises(NumberLimitError, match=rf"the regular {n}-gon; accepted: 3 to 1000 ver"):
        regular_polygon_field(n)
