"""`PiecewisePrior`: worked masses and windows, ways to make one."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.priors import uniform_prior
from stochgeom.errors import PriorError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.sums import AngleSum
from tests.strategies import TINY

SLOPE = Angle(0, (3, 2))  # 33.69 degrees
STEPS = PiecewisePrior.from_histogram(["0", "90", "180", "360"], [1, 2, 1])


def deg(value):
    return Angle.from_degrees(value)


def test_masses():
    assert STEPS.mass(Arc(ZERO, QUARTER_TURN)).rational == mpq(1, 4)
    assert STEPS.mass(Arc(deg(45), QUARTER_TURN)).rational == mpq(3, 8)
    assert STEPS.mass(Arc(deg(270), HALF_TURN)).rational == mpq(3, 8)
    assert STEPS.mass(Arc(deg(100), FULL_TURN)).rational == 1
    assert STEPS.mass(Arc(ZERO, SLOPE)) == AngleSum(0, [(1, SLOPE)])
    assert STEPS.mass(Arc(deg(90), SLOPE)) == AngleSum(0, [(2, SLOPE)])


def test_windows():
    window = STEPS.best_window(deg(45))
    assert (window.start, window.mass.rational) == (deg(90), mpq(1, 4))
    window = STEPS.best_window(deg(135))
    assert (window.start, window.mass.rational) == (deg(45), mpq(5, 8))  # before 90, not after
    window = STEPS.best_window(SLOPE)
    assert (window.start, window.mass) == (deg(90), AngleSum(0, [(2, SLOPE)]))
    assert STEPS.best_window(FULL_TURN).start == ZERO


def test_a_window_may_pass_zero():
    prior = PiecewisePrior([(Arc(deg(340), deg(40)), 9)])
    window = prior.best_window(deg(30))
    assert (window.start, window.mass.rational) == (ZERO - deg(20) + FULL_TURN, mpq(3, 4))
    assert prior.best_window(deg(20)).start == ZERO  # [0, 20) and [340, 360) tie


def test_pieces_at_angles_that_are_no_rational_degrees():
    wide = FULL_TURN - SLOPE
    prior = PiecewisePrior([(Arc(ZERO, SLOPE), 1), (Arc(SLOPE, wide), 1)])
    assert prior.describe() == "piecewise constant, 1 piece"
    assert prior.mass(Arc(ZERO, wide)) == uniform_prior().mass(Arc(ZERO, wide))
    # 4 arctan(1/5) - arctan(1/239) is an eighth of a turn: the integral is exactly 1.
    a, b = Angle(0, (5, 1)), Angle(0, (239, 1))
    eight = PiecewisePrior([(Arc(ZERO, a), 8), (Arc(a, 3 * a - b), 8)])
    assert eight.mass(Arc(ZERO, HALF_TURN)).rational == 1


def test_ties_that_no_float_decides():
    prior = PiecewisePrior([(Arc(ZERO, QUARTER_TURN), 2), (Arc(HALF_TURN, QUARTER_TURN), 2)])
    assert prior.best_window(deg(50)).start == ZERO
    moved = PiecewisePrior(
        [(Arc(ZERO, QUARTER_TURN - TINY), 2), (Arc(HALF_TURN - TINY, QUARTER_TURN + TINY), 2)]
    )
    assert moved.best_window(QUARTER_TURN).start == HALF_TURN - TINY


def test_equal_densities_are_one_piece():
    prior = PiecewisePrior.from_histogram(["0", "120", "240", "360"], [1, 1, 1])
    assert prior.density.breaks == (ZERO,)
    assert prior.density_at(deg(77)) == 1
    assert STEPS.density_at(deg(90)) == 2
    assert STEPS.density_at(deg(-1)) == mpq(1, 2)


def test_negative_edges_and_gaps():
    prior = PiecewisePrior.from_histogram(["-30", "30", "50"], [3, 1])
    assert prior.mass(Arc(deg(330), deg(60))).rational == mpq(3, 4)
    assert prior.mass(Arc(deg(50), deg(280))).rational == 0


def test_measurements_in_bins():
    measured = ["0", "89.999", "90", "360", "-1/3", SLOPE, deg(-90)]
    prior = PiecewisePrior.from_measurements(measured, bins=4)
    assert prior == PiecewisePrior.from_histogram(["0", "90", "180", "270", "360"], [4, 1, 0, 2])
    tenths = PiecewisePrior.from_measurements(["10", "19.9", "20"])
    assert tenths.mass(Arc(deg(10), deg(10))).rational == mpq(2, 3)
    assert PiecewisePrior.from_measurements(["7"], bins=1) == PiecewisePrior(
        [(Arc(ZERO, FULL_TURN), 1)]
    )


@pytest.mark.parametrize("bins", [0, -1, 100_001, 1.5, "36", None])
def test_other_numbers_of_bins(bins):
    with pytest.raises(PriorError, match="bins; accepted: whole numbers from 1 to 100000"):
        PiecewisePrior.from_measurements(["7"], bins)


def test_masses_on_arcs():
    halves = [(Arc(ZERO, HALF_TURN), "1/3"), (Arc(HALF_TURN, HALF_TURN), "2/3")]
    assert PiecewisePrior.from_masses(halves).density.densities == (mpq(2, 3), mpq(4, 3))


def test_equality_and_repr():
    assert eval(repr(STEPS)) == STEPS
    assert hash(eval(repr(STEPS))) == hash(STEPS)
    assert PiecewisePrior([(Arc(ZERO, FULL_TURN), 1)]) != STEPS
    assert STEPS.kind == "piecewise"
    assert uniform_prior() == uniform_prior() != STEPS
    assert hash(uniform_prior()) == hash(uniform_prior())
    assert repr(uniform_prior()) == "uniform_prior()"
    assert (uniform_prior().kind, uniform_prior().describe()) == ("uniform", "uniform")
