"""`WrappedNormal` and `VonMises`: literal values, symmetry, extremes."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from stochgeom.decision.density_priors import VonMises, WrappedNormal
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.balls import working_precision
from stochgeom.exact.sums import AngleSum

SLOPE = Angle(0, (3, 2))


def deg(value):
    return Angle.from_degrees(value)


class TestNormal:
    def test_one_two_three_standard_deviations(self):
        prior = WrappedNormal("100", "10")
        for k, expected in ((1, "0.682689492137"), (2, "0.954499736104"), (3, "0.997300203937")):
            window = prior.best_window(deg(20 * k))
            assert window.start == deg(100 - 10 * k)
            assert window.mass.decimal(12) == expected
            assert (window.exact, window.at_most) == (True, None)

    def test_half_of_a_direction_is_close(self):
        window = WrappedNormal("100", "10").best_window(SLOPE)
        assert not window.exact
        off = (window.start + SLOPE - deg(100)) - (deg(100) - window.start)
        assert abs(off.to_float()) < 2**-19
        assert window.mass.compare(window.at_most) == -1
        assert float(window.at_most) - float(window.mass) < 1e-12

    def test_half_of_a_direction_of_whole_length_is_exact(self):
        window = WrappedNormal(ZERO, "10").best_window(Angle(0, (3, 4)))
        assert window.exact
        assert window.start == FULL_TURN - Angle(0, (2, 1))

    def test_both_roads_meet_at_90_degrees(self):
        arc = Arc(deg(30), SLOPE)
        below, above = (WrappedNormal("10", sd) for sd in ("89.9999999", "90.0000001"))
        assert abs(float(below.mass(arc)) - float(above.mass(arc))) < 1e-9
        assert abs(float(below.density_at(ZERO)) - float(above.density_at(ZERO))) < 1e-8

    @pytest.mark.parametrize("sd", ["1e-400", "1/1000", "3600"])
    def test_extreme_deviations(self, sd):
        prior = WrappedNormal("10", sd)
        mass = prior.mass(Arc(deg(0), deg(20)))
        assert mass.decimal(4) == ("0.0556" if sd == "3600" else "1.0000")

    def test_tiny_masses_are_compared(self):
        prior = WrappedNormal("0", "1/10")
        near, far = (prior.mass(Arc(deg(start), deg(5))) for start in (90, 91))
        assert near.compare(far) == 1
        assert near.compare(0) == 1

    def test_nearly_uniform_masses_are_compared(self):
        prior = WrappedNormal("0", "3600")
        near, far = (prior.mass(Arc(deg(start), deg(5))) for start in (90, 91))
        assert near.compare(far) == 1

    @pytest.mark.parametrize("sd", ["30", "60", "90", "91", "150"])
    def test_what_a_sum_leaves_out_is_enclosed(self, monkeypatch, sd):
        """With far too few terms a ball is wide, and holds the number all the same."""
        prior, arc = WrappedNormal("10", sd), Arc(deg(100), SLOPE)
        with working_precision(64):
            mass, density = prior.mass(arc).ball(), prior.density_at(deg(100)).ball()
            monkeypatch.setattr(WrappedNormal, "_copies", lambda _: 1)
            monkeypatch.setattr(WrappedNormal, "_terms", lambda _: 1)
            assert prior.mass(arc).ball().overlaps(mass)
            assert prior.density_at(deg(100)).ball().overlaps(density)

    def test_describe(self):
        assert WrappedNormal("10", "5.25").describe() == (
            "normal, mean 10.0000°, standard deviation 5.2500°"
        )
        assert WrappedNormal("-10", "5").mean == deg(350)


class TestVonMises:
    def test_literal_values(self):
        # scipy.stats.vonmises(3).cdf(pi/4) - cdf(-pi/4)
        mass = VonMises(0, 3).best_window(QUARTER_TURN).mass
        assert mass.decimal(6) == "0.788342"

    def test_no_concentration_is_uniform(self):
        prior = VonMises("10", 0)
        window = prior.best_window(SLOPE)
        assert (window.start, window.exact) == (ZERO, True)
        assert window.mass == AngleSum(0, [(1, SLOPE)])

    def test_strong_concentration(self):
        prior = VonMises("10", 10**4)
        assert prior.mass(Arc(deg(5), deg(10))).decimal(4) == "1.0000"
        near, far = (prior.mass(Arc(deg(start), deg(5))) for start in (100, 101))
        assert near.compare(far) == 1

    def test_close_to_a_normal(self):
        sd = Angle.from_degrees(1).to_float()
        kappa = round(1 / sd**2)
        one = VonMises(0, kappa).best_window(deg(2)).mass
        assert abs(float(one) - 0.682689) < 1e-3

    def test_describe(self):
        assert VonMises("10", "5/2").describe() == "von Mises, mean 10.0000°, concentration 5/2"


@pytest.mark.parametrize("prior", [WrappedNormal("33", "50"), VonMises("33", 2)], ids=str)
class TestBoth:
    def test_a_full_turn_is_certain(self, prior):
        assert prior.mass(Arc(deg(77), FULL_TURN)).rational == 1
        window = prior.best_window(FULL_TURN)
        assert (window.start, window.mass.rational, window.exact) == (ZERO, mpq(1), True)

    def test_halves_about_the_mean_are_equal(self, prior):
        left = prior.mass(Arc(deg(33) - SLOPE, SLOPE))
        right = prior.mass(Arc(deg(33), SLOPE))
        assert left.compare(right) == 0
        assert (left + right).compare(left.scaled(2)) == 0
        whole = prior.mass(Arc(deg(33) - SLOPE, SLOPE + SLOPE))
        assert (left + right).decimal(15) == whole.decimal(15)

    def test_half_of_everything(self, prior):
        with working_precision(200):
            assert abs(prior.mass(Arc(deg(33), HALF_TURN)).ball() - 0.5) < 2.0**-150

    def test_repr_equality(self, prior):
        again = eval(repr(prior))
        assert again == prior
        assert hash(again) == hash(prior)
        assert prior != WrappedNormal("1", "2")
        assert prior != VonMises("1", "2")
        arc = Arc(ZERO, SLOPE)
        assert prior.mass(arc).compare(again.mass(arc)) == 0
