"""`MixturePrior`: worked cases, exact and not."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from stochgeom.decision.density_priors import VonMises, WrappedNormal
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.mixture_prior import MixturePrior
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.priors import uniform_prior
from stochgeom.exact.angles import FULL_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.sums import AngleSum

SLOPE = Angle(0, (3, 2))


def deg(value):
    return Angle.from_degrees(value)


POINT = DiscretePrior({"90": 1})
SPREAD = PiecewisePrior([(Arc(ZERO, QUARTER_TURN), 4)])


def test_a_point_and_the_rest():
    prior = MixturePrior([("3/4", DiscretePrior({"200": 1})), ("1/4", uniform_prior())])
    window = prior.best_window(SLOPE)
    assert window.exact
    # Every window with the point in it is as good; compared are those that begin at 0, at the
    # point, or end where the density changes (nowhere).
    assert window.start == deg(200)
    assert window.mass == AngleSum("3/4", [("1/4", SLOPE)])


def test_a_supremum_that_is_not_attained():
    prior = MixturePrior([("1/2", POINT), ("1/2", SPREAD)])
    window = prior.best_window(QUARTER_TURN)
    assert not window.exact
    assert window.at_most.rational == 1
    assert ZERO < window.start < deg("0.001")
    assert window.mass == prior.mass(Arc(window.start, QUARTER_TURN)) < AngleSum(1)
    assert prior.mass(Arc(ZERO, QUARTER_TURN)).rational == mpq(1, 2)


def test_one_kind_only_is_as_without_a_mixture():
    points = DiscretePrior({"0": "1/2", "30": "1/2"})
    alone = MixturePrior([(1, points), (0, uniform_prior())])
    assert len(alone.components) == 1
    assert alone.best_window(SLOPE) == points.best_window(SLOPE)
    assert MixturePrior([(1, SPREAD)]).best_window(SLOPE) == SPREAD.best_window(SLOPE)
    assert MixturePrior([(1, uniform_prior())]).best_window(SLOPE).mass == AngleSum(0, [(1, SLOPE)])


def test_two_normals():
    prior = MixturePrior([("1/2", WrappedNormal("10", "5")), ("1/2", WrappedNormal("30", "5"))])
    window = prior.best_window(deg(30))
    assert abs(window.start.to_float() - deg(5).to_float()) < 1e-6
    assert window.mass.decimal(6) == "0.841344"
    assert not window.exact
    assert window.at_most.compare(window.mass) == 1
    assert prior.best_window(FULL_TURN).mass.rational == 1


def test_a_point_and_a_normal():
    prior = MixturePrior([("9/10", POINT), ("1/10", VonMises("200", 50))])
    window = prior.best_window(deg(10))
    assert prior.mass(Arc(window.start, deg(10))).compare("9/10") >= 0
    mass = prior.mass(Arc(deg(90), deg(120)))
    assert mass.compare(AngleSum("9/10")) == 1


def test_descriptions():
    prior = MixturePrior([("1/2", POINT), ("1/2", uniform_prior())])
    assert prior.describe() == "mixture: 1/2 of (discrete, 1 orientation), 1/2 of (uniform)"
    assert prior.kind == "mixture"
    again = eval(repr(prior), {**globals(), "uniform_prior": uniform_prior})
    assert again.components == prior.components


@pytest.mark.parametrize("start", [0, 45, 300])
def test_mass_is_the_weighted_sum(start):
    arc = Arc(deg(start), deg(100))
    prior = MixturePrior([("1/3", POINT), ("2/3", SPREAD)])
    assert prior.mass(arc) == POINT.mass(arc).scaled("1/3") + SPREAD.mass(arc).scaled("2/3")


def test_weights_beyond_the_largest_float():
    tiny = mpq(1, 10**400)
    points = DiscretePrior({"0": tiny, "10": 1 - tiny})
    prior = MixturePrior([("1/2", points), ("1/2", uniform_prior())])
    assert prior.best_window(deg(11)).mass.rational == mpq(1, 2) + mpq(11, 720)


def test_points_alone_are_begun_with():
    prior = MixturePrior([("1/2", DiscretePrior({"10": 1})), ("1/2", DiscretePrior({"20": 1}))])
    assert prior.best_window(deg(15)).start == deg(10)  # not 0, which misses 20
    assert prior.best_window(deg(30)).start == ZERO
