"""Sums of logarithms and of square roots: exact signs, by relations that floats do not see."""

from __future__ import annotations

import math

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.errors import FloatRefusedError, NumberError
from stochgeom.exact.independent_sums import LogSum, RootSum
from tests.strategies import fractions

terms = st.lists(st.tuples(fractions, st.integers(1, 60)), max_size=5)
KINDS = [(LogSum, math.log2), (RootSum, math.sqrt)]
both = pytest.mark.parametrize(("kind", "function"), KINDS)
FEW = settings(max_examples=100)


def test_relations_between_logarithms():
    assert LogSum(0, [(1, 6), (1, 10), (-1, 15)]) == 2
    assert LogSum(0, [("1/2", 9), (-1, 3)]).terms == ()
    assert LogSum(0, [(1, 12), (-1, 18)]) == LogSum(1, [(-1, 3)])
    assert LogSum(0, [(1, 2**64), (1, 1)]).rational == 64


def test_relations_between_roots():
    assert RootSum(0, [(1, 50), (1, 8), (-7, 2)]).terms == ()
    assert RootSum(0, [(1, 9), ("1/2", 16)]).rational == 5
    assert RootSum(0, [(1, 12)]) == RootSum(0, [(2, 3)])
    # root 2 + root 3 and root 5 + root (24 / 10) are near, root 10 is between.
    assert RootSum(0, [(1, 2), (1, 3)]) < RootSum(0, [(1, 10)])


def test_signs_beyond_floats():
    # 2^1054 and 3^665 differ by a factor of 1.00005; raised by a million, floats of logs agree.
    tiny = LogSum(0, [(665 * 10**12, 3), (-1054 * 10**12, 2)])
    assert tiny.sign() == (1 if 3**665 > 2**1054 else -1)
    # root(n^2 + 1) - n = 5e-41 for n = 10^40.
    n = 10**40
    assert RootSum(-n, [(1, n * n + 1)]).sign() == 1
    assert float(RootSum(-n, [(1, n * n + 1)])) == pytest.approx(0.5e-40)


@both
@FEW
@given(a=terms, b=terms, c=fractions, q=fractions)
def test_arithmetic_agrees_with_floats(kind, function, a, b, c, q):
    x, y = kind(c, a), kind(0, b)
    plain = [float(c) + sum(float(r) * function(n) for r, n in a)]
    plain.append(sum(float(r) * function(n) for r, n in b))
    for number, value in (
        (x, plain[0]),
        (x + y, plain[0] + plain[1]),
        (x - y, plain[0] - plain[1]),
        (x.scaled(q), plain[0] * float(q)),
        (1 + x, 1 + plain[0]),
    ):
        assert abs(float(number) - value) < 1e-9
    if abs(plain[0] - plain[1]) > 1e-9:
        assert x.compare(y) == (1 if plain[0] > plain[1] else -1)
        assert (x < y) == (plain[0] < plain[1])


@both
@FEW
@given(a=terms, n=st.integers(1, 30), q=fractions)
def test_a_number_written_otherwise_is_the_same(kind, function, a, n, q):
    number = kind(0, [*a, (q, n)])
    # log n^2 = 2 log n; root (9 n) = 3 root n.
    rest = [(q / 2, n * n)] if kind is LogSum else [(q / 3, 9 * n)]
    other = kind(0, [*rest, *reversed(a)])
    assert number == other
    assert hash(number) == hash(other)
    assert (number - other).terms == ()


@both
def test_what_is_refused(kind, function):
    with pytest.raises(NumberError, match="0 in a sum; accepted: whole numbers above 0"):
        kind(0, [(1, 0)])
    with pytest.raises(FloatRefusedError):
        kind(0.5)
    assert kind(1) != "1"
    with pytest.raises(TypeError):
        kind(1) < 0.5  # noqa: B015


def test_repr_is_the_constructor_call():
    number = LogSum("1/3", [("1/2", 3)])
    assert repr(number) == "LogSum('1/3', [('1/2', 3)])"
    assert eval(repr(number)) == number
    assert RootSum(mpq(1, 2)).decimal(2) == "0.50"
