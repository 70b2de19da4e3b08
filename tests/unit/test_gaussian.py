"""Greatest common divisors and coprime bases of Gaussian integers."""

from __future__ import annotations

from itertools import combinations

import pytest
from gmpy2 import mpz
from hypothesis import assume, given
from hypothesis import strategies as st

from stochgeom.exact.gaussian import Gaussian, coprime_base, divide, exponent, gcd
from tests.strategies import directions, long_directions


def gaussian(pair):
    return Gaussian(mpz(pair[0]), mpz(pair[1]))


def times(a, b):
    return Gaussian(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re)


def power(a, n):
    result = gaussian((1, 0))
    for _ in range(n):
        result = times(result, a)
    return result


def associates(a):
    return {a, Gaussian(-a.re, -a.im), Gaussian(-a.im, a.re), Gaussian(a.im, -a.re)}


numbers = directions.map(gaussian)
long_numbers = long_directions.map(gaussian)
any_numbers = st.one_of(numbers, long_numbers)
nearly_any = st.one_of(numbers, st.just(gaussian((0, 0))))


# --- division ------------------------------------------------------------------------------------


def test_division_by_hand():
    assert divide(gaussian((5, 0)), gaussian((2, 1))) == (Gaussian(2, -1), True)
    assert divide(gaussian((-3, 1)), gaussian((1, 1))) == (Gaussian(-1, 2), True)
    assert divide(gaussian((7, 0)), gaussian((2, 0)))[1] is False
    assert divide(gaussian((0, 0)), gaussian((2, 1))) == (Gaussian(0, 0), True)


@given(any_numbers, any_numbers)
def test_the_rest_of_a_division_is_at_most_half_the_norm(a, b):
    quotient, exact = divide(a, b)
    product = times(quotient, b)
    rest = Gaussian(a.re - product.re, a.im - product.im)
    assert exact == (rest == (0, 0))
    assert 2 * rest.norm <= b.norm


@given(any_numbers, any_numbers)
def test_products_divide_exactly(a, b):
    assert divide(times(a, b), b) == (a, True)


# --- greatest common divisors --------------------------------------------------------------------


def test_gcd_by_hand():
    assert gcd(gaussian((5, 0)), gaussian((3, 1))) in associates(gaussian((2, 1))) | associates(
        gaussian((1, 2))
    )
    assert gcd(gaussian((3, 0)), gaussian((2, 1))).norm == 1
    assert gcd(gaussian((0, 0)), gaussian((3, 4))) in associates(gaussian((3, 4)))
    assert gcd(gaussian((2, 0)), gaussian((1, 1))) in associates(gaussian((1, 1)))


@given(any_numbers, any_numbers, any_numbers)
def test_a_common_factor_is_found(a, b, common):
    a, b = times(a, common), times(b, common)
    found = gcd(a, b)
    assert divide(a, found)[1]
    assert divide(b, found)[1]
    assert divide(found, common)[1]
    assert gcd(divide(a, found)[0], divide(b, found)[0]).norm == 1


@given(nearly_any, nearly_any)
def test_gcd_is_the_largest_common_divisor_of_small_numbers(a, b):
    assume(a != (0, 0) or b != (0, 0))
    candidates = [Gaussian(mpz(x), mpz(y)) for x in range(6) for y in range(-5, 6) if x or y]
    common = [c for c in candidates if divide(a, c)[1] and divide(b, c)[1]]
    assert gcd(a, b).norm == max(c.norm for c in common)


# --- coprime bases -------------------------------------------------------------------------------


@given(st.lists(any_numbers, max_size=4))
def test_a_coprime_base_is_coprime_and_generates(given_numbers):
    base = coprime_base(given_numbers)
    assert all(element.norm > 1 for element in base)
    assert all(gcd(a, b).norm == 1 for a, b in combinations(base, 2))
    for number in given_numbers:
        rest = number
        for element in base:
            for _ in range(exponent(number, element)):
                rest, exact = divide(rest, element)
                assert exact
        assert rest.norm == 1


def test_a_base_of_units_is_empty():
    assert coprime_base([]) == []
    assert coprime_base([gaussian(p) for p in [(1, 0), (0, 1), (-1, 0), (0, -1)]]) == []


def test_a_base_splits_only_what_must_be_split():
    # 65 = (2 + i)(2 - i)(3 + 2i)(3 - 2i) stays whole beside 7; beside 2 + i it does not.
    base = coprime_base([gaussian((65, 0)), gaussian((7, 0))])
    assert sorted(element.norm for element in base) == [49, 65**2]
    base = coprime_base([gaussian((65, 0)), gaussian((2, 1))])
    assert sorted(element.norm for element in base) == [5, 65**2 // 5]


def test_powers_of_one_number_leave_one_element():
    z = gaussian((3, 2))
    base = coprime_base([power(z, 60), power(z, 35), power(z, 96)])
    assert [element.norm for element in base] == [13]
    base = coprime_base([power(z, 60), power(z, 90)])
    assert [element.norm for element in base] == [mpz(13) ** 30]


# --- exponents -----------------------------------------------------------------------------------


@pytest.mark.parametrize("n", [0, 1, 7, 40])
def test_exponents_by_hand(n):
    two_plus_i, three = gaussian((2, 1)), gaussian((3, 0))
    assert exponent(times(power(two_plus_i, n), three), two_plus_i) == n
    assert exponent(times(power(two_plus_i, n), three), three) == 1
    assert exponent(times(power(two_plus_i, n), three), gaussian((2, -1))) == 0
    assert exponent(gaussian((2**n, 0)), gaussian((1, 1))) == 2 * n


@given(any_numbers, st.integers(0, 5), any_numbers)
def test_exponents_add(a, n, element):
    assume(element.norm > 1)
    assert exponent(times(a, power(element, n)), element) == n + exponent(a, element)
