"""`stochgeom.exact.offset_directions`: the same angles as written out, with short numbers."""

from __future__ import annotations

import numpy as np
import pytest
from gmpy2 import mpz
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import Angle
from stochgeom.exact.offset_directions import OffsetDirections
from stochgeom.exact.predicates import dot_signs
from stochgeom.exact.vectors import AngleVector
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.transfer.push import push_function
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import signed

components = st.one_of(st.integers(-3, 3), signed(0, 2**53 - 1))
wholes = st.lists(
    st.tuples(components, components).filter(lambda p: max(map(abs, p)) >= 2),
    min_size=1,
    max_size=8,
)
scales = st.one_of(st.integers(1, 5), st.integers(10**30, 10**31), st.just(10**400))


@st.composite
def vectors(draw):
    """An offset vector and the same one written out."""
    x, y = (np.array(values) for values in zip(*draw(wholes), strict=True))
    scale = draw(scales)
    half = scale // 2
    offset = st.one_of(
        st.sampled_from([0, half, -half, min(1, half), max(-1, -half)]), st.integers(-half, half)
    )
    a, b = mpz(draw(offset)), mpz(draw(offset))
    short = OffsetDirections(x, y, (a, b), mpz(scale))
    long = [(scale * int(p) + a, scale * int(q) + b) for p, q in zip(x, y, strict=True)]
    return short, AngleVector.from_angles([Angle(0, pair) for pair in long])


@given(vectors())
def test_entries_are_those_written_out(pair):
    short, long = pair
    assert list(short) == list(long)
    assert short.equals(long)
    assert short[-1] == long[-1]
    assert short.largest_turn == 0


@given(vectors())
def test_shadows_keep_their_bound(pair):
    short, long = pair
    assert np.abs(short.shadow - [angle.to_float() for angle in long]).max() <= short.error


@given(vectors(), st.lists(st.tuples(components, components), min_size=8, max_size=8))
def test_signs_of_products(pair, others):
    short, _ = pair
    ax, ay = (np.array(values)[: len(short)] for values in zip(*others, strict=True))
    exact = dot_signs(ax, ay, short.x, short.y)
    assert short.dot_signs(ax, ay).tolist() == exact.tolist()
    # Across the vectors themselves, where only the offset decides.
    wx, wy = short._whole
    assert short.dot_signs(-wy, wx).tolist() == dot_signs(-wy, wx, short.x, short.y).tolist()


@pytest.mark.parametrize(
    ("offset", "sign"), [((260, 124), -1), ((260, 80), 1), ((240, 80), 0), ((372, 124), 0)]
)
def test_signs_where_float_components_mislead(offset, sign):
    """In float64 these are x = 3 * 2**50 + 0.5 or so and y = 2**50: their x - 3 y has no sign."""
    short = OffsetDirections(
        np.array([3 * 2**50]), np.array([2**50]), (mpz(offset[0]), mpz(offset[1])), mpz(1000)
    )
    assert short.dot_signs(np.array([1]), np.array([-3])).tolist() == [sign]
    assert short.dot_signs(np.array([-1]), np.array([3])).tolist() == [-sign]


@pytest.mark.parametrize("key", [slice(1, None), np.array([2, 0]), np.array([True, False, True])])
def test_taking_keeps_numbers_short(key):
    x, y = np.array([5, -7, 2]), np.array([0, 3, -2])
    short = OffsetDirections(x, y, (mpz(-1), mpz(4)), mpz(10))
    taken = short.take(key)
    assert isinstance(taken, OffsetDirections)
    assert list(taken) == np.array(list(short), dtype=object)[key].tolist()


def test_slices_and_turns():
    short = OffsetDirections(np.array([5, -7]), np.array([0, 3]), (mpz(0), mpz(-1)), mpz(3))
    assert list(short[:1]) == [Angle(0, (15, -1))]
    turn = Angle(1, (3, 4))
    assert list(short.rotate(turn)) == [angle + turn for angle in short]
    both = AngleVector.concatenate([short, short.rotate(turn)])
    assert list(both) == [*short, *short.rotate(turn)]


def test_a_push_grasp_function_writes_no_components_out(monkeypatch):
    """Written out, those of 10^5 vertices take ten times as long as everything else."""
    turn = 2 * np.pi * np.arange(60) / 60
    outline = np.stack([np.cos(turn), 0.9 * np.sin(turn)], axis=1) * 2**35
    radius = RadiusFunction(Part(outline.astype(np.int64)))
    assert isinstance(radius.unstable.angles, OffsetDirections)

    def refuse(self, axis):
        raise AssertionError("components written out")

    monkeypatch.setattr(OffsetDirections, "_written_out", refuse)
    push = push_function(radius)
    assert len(squeeze_function(radius.part).compose(push)) >= 1
