"""Sums of angles over independent angles: the same numbers, and equal exactly if equal by terms."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.exact.angle_base import AngleBase
from stochgeom.exact.angles import Angle
from stochgeom.exact.sums import AngleSum
from tests.strategies import fractions, orientations

sums = st.lists(
    st.builds(AngleSum, fractions, st.lists(st.tuples(fractions, orientations), max_size=3)),
    min_size=1,
    max_size=4,
)
FEW = settings(max_examples=80)


def parts_of(value):
    return value.constant, {(q, angle) for q, angle in value.terms}


@FEW
@given(sums)
def test_the_numbers_stay_what_they_are(listed):
    base = AngleBase(listed)
    for each in listed:
        assert base.write(each) == each


@FEW
@given(sums)
def test_equal_numbers_have_equal_terms(listed):
    base = AngleBase(listed)
    written = [base.write(each) for each in listed]
    for a, one in zip(listed, written, strict=True):
        for b, two in zip(listed, written, strict=True):
            assert (a == b) == (parts_of(one) == parts_of(two))
        assert (one.rational is None) == bool(one.terms)


@FEW
@given(sums)
def test_writing_twice_changes_nothing(listed):
    base = AngleBase(listed)
    written = [base.write(each) for each in listed]
    again = AngleBase(written)
    for each in written:
        assert parts_of(again.write(each)) == parts_of(each)


def test_machin():
    a, b = AngleSum(0, [(4, Angle(0, (5, 1)))]), AngleSum(0, [(1, Angle(0, (239, 1)))])
    base = AngleBase([a, b])
    assert base.write(a - b).terms == ()
    assert base.write(a - b).constant == AngleSum("1/8").constant
    # One prime direction is enough: 26 = 2 * 13, 239^2 + 1 = 2 * 13^4.
    assert len(base.write(a).terms) == len(base.write(b).terms) == 1
