"""`CallablePrior`: numerical, and honest about it."""

from __future__ import annotations

import sys
from math import cos, exp, inf, nan, pi, sin

import pytest

from stochgeom.decision.density_priors import VonMises
from stochgeom.errors import MissingExtraError, PriorError
from stochgeom.exact.angles import FULL_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc

SLOPE = Angle(0, (3, 2))


def flat(_theta):
    return 1 / (2 * pi)


def test_a_missing_scipy_names_the_extra(monkeypatch):
    from stochgeom.decision.callable_prior import CallablePrior

    monkeypatch.setitem(sys.modules, "scipy.integrate", None)
    with pytest.raises(MissingExtraError, match=r"stochgeom\[numeric\]"):
        CallablePrior(flat)


class TestWithScipy:
    @pytest.fixture(autouse=True)
    def _scipy(self):
        pytest.importorskip("scipy")

    @staticmethod
    def make(density, **options):
        from stochgeom.decision.callable_prior import CallablePrior

        return CallablePrior(density, **options)

    def test_a_cosine(self):
        prior = self.make(lambda theta: (1 + cos(theta - 1)) / (2 * pi))
        window = prior.best_window(SLOPE)
        middle = window.start.to_float() + SLOPE.to_float() / 2
        assert abs(middle - 1) < 1e-6
        assert not window.exact
        assert window.at_most is None
        h = SLOPE.to_float()
        assert abs(float(window.mass) - (h + 2 * sin(h / 2)) / (2 * pi)) < 1e-12
        assert window.mass.error < 1e-10

    def test_both_ends_have_the_same_density(self):
        """Eq. F.5."""
        prior = self.make(
            lambda theta: (1 + 0.5 * cos(theta) + 0.25 * cos(2 * theta + 1)) / (2 * pi)
        )
        start = prior.best_window(SLOPE).start
        assert abs(prior.density_at(start) - prior.density_at(start + SLOPE)) < 1e-6

    def test_against_the_certified_prior(self):
        certified = VonMises("57", 3)
        scale = float(certified.density_at(Angle.from_degrees(57))) / (2 * pi)
        mean = Angle.from_degrees(57).to_float()
        prior = self.make(lambda theta: scale * exp(3 * (cos(theta - mean) - 1)))
        for start in (0, 50, 200, 350):
            arc = Arc(Angle.from_degrees(start), SLOPE)
            assert abs(float(prior.mass(arc)) - float(certified.mass(arc))) < 1e-9
            assert prior.mass(arc).compare(certified.mass(arc)) == 0
        mine, best = prior.best_window(SLOPE), certified.best_window(SLOPE)
        assert abs(mine.start.to_float() - best.start.to_float()) < 1e-5
        assert abs(float(mine.mass) - float(best.mass)) < 1e-9

    def test_a_flat_density_begins_at_zero(self):
        window = self.make(flat).best_window(QUARTER_TURN)
        assert window.start == ZERO
        assert window.mass.decimal(6) == "0.250000"

    def test_a_full_turn_is_certain(self):
        prior = self.make(flat)
        assert prior.mass(Arc(SLOPE, FULL_TURN)).rational == 1
        assert prior.best_window(FULL_TURN).mass.rational == 1

    def test_a_density_with_jumps(self):
        prior = self.make(lambda theta: 2 / pi if 1 <= theta < 1 + pi / 2 else 0.0)
        window = prior.best_window(Angle.from_degrees(30))
        assert abs(float(window.mass) - 1 / 3) < 1e-6
        assert abs(float(prior.best_window(QUARTER_TURN).mass) - 1) < 1e-6

    def test_an_integral_close_to_one_is_scaled(self):
        prior = self.make(lambda _: 1.001 / (2 * pi), tolerance=0.01, name="drifting")
        assert abs(prior.integral - 1.001) < 1e-9
        assert prior.mass(Arc(ZERO, QUARTER_TURN)).decimal(6) == "0.250000"
        assert prior.describe().startswith("drifting, numerical, error about ")
        assert prior.kind == "callable"
        assert abs(prior.density_at(SLOPE) - 1) < 1e-12

    @pytest.mark.parametrize(
        ("density", "complaint"),
        [
            (lambda _: 1.0, "integrates to 6.283"),
            (lambda _: 0.0, "integrates to 0 "),
            (lambda _: nan, "density is nan"),
            (lambda _: inf, "density is inf"),
            (lambda theta: cos(theta), "density is -"),
            (lambda theta: nan if 1 < theta < 1.1 else 1 / (2 * pi), "density is nan"),
            (lambda _: "high", "density fails"),
            (lambda _: None, "density fails"),
            (lambda _: 1 / 0, "density fails: division by zero"),
            (0.159, "is no function"),
        ],
    )
    def test_bad_densities(self, density, complaint):
        with pytest.raises(PriorError, match=complaint):
            self.make(density)
