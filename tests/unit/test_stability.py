"""`stochgeom.feeding.stability`: Psi by hand, by brute force, and under motions."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.errors import TooFewVerticesError
from stochgeom.exact.angles import EIGHTH_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.feeding.stability import StableGrasp, most_stable_grasps, stable_grasps
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import circle_parts, factors, nearly_regular, parts, shifts

any_part = st.one_of(parts(), parts(), circle_parts(), nearly_regular(most=7))

# --- by hand -------------------------------------------------------------------------------------


def test_the_rectangle():
    """The diagonals lie 33.69 degrees from the long side and 56.31 from the short one."""
    flat, upright = stable_grasps([(0, 0), (3, 0), (3, 2), (0, 2)])
    assert flat == StableGrasp(ZERO, Angle(0, (2, 3)))
    assert upright == StableGrasp(QUARTER_TURN, Angle(0, (3, 2)))


def test_the_square():
    assert stable_grasps([(0, 0), (1, 0), (1, 1), (0, 1)]) == (StableGrasp(ZERO, EIGHTH_TURN),)


@pytest.mark.parametrize("corners", [[(0, 0), (5, 0), (-1, 1)], [(0, 0), (4, 0), (0, 3)]])
def test_an_obtuse_or_right_triangle_has_one_grasp_as_stable_as_can_be(corners):
    (grasp,) = stable_grasps(corners)
    assert grasp.stability == QUARTER_TURN


def test_the_nearer_maximum_counts():
    """Fig. D.2: the smaller of two distances. For an acute triangle all can be read off."""
    corners = [(0, 0), (8, 0), (3, 6)]
    squeeze = squeeze_function(corners)
    assert [b.degrees(2) for b in squeeze.breaks] == ["26.57", "90.00", "140.19"]
    assert [v.degrees(2) for v in squeeze.values] == ["50.19", "116.57", "180.00"]
    found = [(g.orientation.degrees(2), g.stability.degrees(2)) for g in stable_grasps(corners)]
    # 50.19 - 26.57, 140.19 - 116.57, 206.57 - 180
    assert found == [("0.00", "26.57"), ("50.19", "23.63"), ("116.57", "23.63")]


@pytest.mark.parametrize(
    ("name", "best"),
    [("house", ("90.0", "71.6")), ("4gon", ("21.6", "20.6")), ("tuning-fork", ("0.0", "73.7"))],
)
def test_the_catalogue(name, best):
    (grasp,) = most_stable_grasps(catalogue_part(name))
    assert (grasp.orientation.degrees(1), grasp.stability.degrees(1)) == best


def test_several_grasps_may_be_equally_stable():
    best = most_stable_grasps([(2, 0), (0, 1), (-2, 0), (0, -1)])  # a rhombus: two mirror images
    assert len(best) == 2
    assert best[0].stability == best[1].stability


# --- brute force ---------------------------------------------------------------------------------


def slow_grasps(part):
    """Return (minimum, Psi) by Eq. D.4, every maximum of three half turns tried for each."""
    diameter = DiameterFunction(part)
    turns = [HALF_TURN * k for k in (-1, 0, 1)]
    maxima = [m + turn for m in diameter.maxima for turn in turns]
    return {
        theta.reduced(): min(
            min(theta - m for m in maxima if m < theta), min(m - theta for m in maxima if m > theta)
        )
        for theta in diameter.minima
    }


@given(any_part)
def test_by_all_maxima(part):
    """One period of the squeeze function holds half a turn of minima once or twice."""
    slow, grasps = slow_grasps(part), stable_grasps(part)
    period = squeeze_function(part).period
    fast = {g.orientation: g.stability for g in grasps}
    assert len(fast) == len(grasps)
    assert fast == {theta % period: psi for theta, psi in slow.items()}
    assert [g.orientation for g in grasps] == sorted(fast)
    best = max(slow.values())
    assert {g.orientation for g in most_stable_grasps(part)} == {
        theta % period for theta, psi in slow.items() if psi == best
    }


@given(any_part)
def test_stability_is_at_most_half_a_step(part):
    s = squeeze_function(part)
    for grasp in stable_grasps(part):
        assert grasp.stability > ZERO
        assert 2 * grasp.stability <= max(s.widths) <= s.period


# --- motions -------------------------------------------------------------------------------------


@given(any_part, factors, shifts)
def test_turning_scaling_and_moving(part, factor, shift):
    moved = part.multiply(factor).translate(*shift)
    period = squeeze_function(part).period
    turn = Angle(0, factor)
    assert {(g.orientation, g.stability) for g in stable_grasps(moved)} == {
        ((g.orientation - turn) % period, g.stability) for g in stable_grasps(part)
    }


@given(any_part)
def test_reflection(part):
    period = squeeze_function(part).period
    assert {(g.orientation, g.stability) for g in stable_grasps(part.reflect())} == {
        (-g.orientation % period, g.stability) for g in stable_grasps(part)
    }


@given(any_part)
def test_only_the_hull_counts(part):
    corners = [part.vertices[k] for k in part.hull.indices]
    assert stable_grasps(part) == stable_grasps(corners)


def test_bad_input():
    with pytest.raises(TooFewVerticesError):
        stable_grasps([(0, 0), (1, 1)])
    with pytest.raises(TooFewVerticesError):
        most_stable_grasps([])
