"""What holds for the masses and best windows of every prior (thesis App. F)."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.density_priors import VonMises, WrappedNormal
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.mixture_prior import MixturePrior
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.priors import uniform_prior
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.balls import working_precision
from stochgeom.exact.halves import HalfAngle
from stochgeom.exact.sums import AngleSum
from tests.strategies import circle_points, grid_degrees, grid_widths, histograms, orientations

discrete = circle_points().map(DiscretePrior)
piecewise = histograms().map(lambda bins: PiecewisePrior.from_histogram(*bins))
mixed = st.builds(
    lambda a, b: MixturePrior([("1/3", a), ("1/3", b), ("1/3", uniform_prior())]),
    discrete,
    piecewise,
)
exact_priors = st.one_of(discrete, piecewise, mixed, st.just(uniform_prior()))
means = st.integers(0, 359).map(str)
deviations = st.sampled_from(["1/10", "5", "30", "90", "120", "720"])
concentrations = st.sampled_from(["1/10", "1", "5", "100"])
symmetric_priors = st.one_of(
    st.builds(WrappedNormal, means, deviations), st.builds(VonMises, means, concentrations)
)
widths = orientations.map(lambda a: a.reduced()).filter(lambda a: a > ZERO)


def turned(prior, angle):
    """The same prior, turned."""
    if isinstance(prior, DiscretePrior):
        return DiscretePrior([(place + angle, weight) for place, weight in prior])
    if isinstance(prior, WrappedNormal):
        return WrappedNormal(prior.mean + angle, prior.sd)
    return VonMises(prior.mean + angle, prior.kappa)


@given(exact_priors, orientations, widths, widths)
def test_masses_add_up(prior, start, first, second):
    if first + second > FULL_TURN:
        second = FULL_TURN - first
        if second == ZERO:
            return
    whole = prior.mass(Arc(start, first + second))
    assert prior.mass(Arc(start, first)) + prior.mass(Arc(start + first, second)) == whole
    assert whole.compare(0) >= 0
    assert whole.compare(1) <= 0


def spans(ends):
    """Return start and width of each arc between some orientations, once around the circle."""
    points = sorted({end.reduced() for end in ends})
    return [(one, other - one) for one, other in pairwise([*points, points[0] + FULL_TURN])]


@given(discrete, orientations, widths)
@settings(max_examples=80)
def test_theorem_3_1_for_points(prior, start, width):
    """The gripper turned at random: the part is in an arc, seen from it, with |A| / 2 pi.

    Between two turns that bring a point to an end of the arc the mass does not change; so the mean
    is a sum, exactly. Refuted by another mean for any prior, as only a uniform angle has.
    """
    ends = [theta - end for theta in prior.orientations for end in (start, start + width)]
    masses = []
    for turn, span in spans(ends):
        between = turn + (span if span == FULL_TURN else HalfAngle(span).nearby)
        masses.append((prior.mass(Arc(start + between, width)).rational, span))
    assert AngleSum(0, masses).compare(AngleSum(0, [(1, width)])) == 0


@given(piecewise, grid_degrees, grid_widths)
@settings(max_examples=80)
def test_theorem_3_1_for_densities(prior, start, width):
    """The mass is linear in the turn between boundaries: the mean is a sum of trapezoids.

    Refuted by a mean other than |A| / 2 pi.
    """
    first, arc = Angle.from_degrees(start), min(Angle.from_degrees(width), FULL_TURN)
    total = Fraction(0)
    for turn, span in spans(
        [b - end for b in prior.density.breaks for end in (first, first + arc)]
    ):
        sides = [prior.mass(Arc(first + turn + by, arc)).rational for by in (ZERO, span)]
        total += sum(sides) / 2 * span.rational_turns
    assert total == arc.rational_turns


@given(exact_priors, orientations)
def test_a_full_turn_is_certain(prior, start):
    assert prior.mass(Arc(start, FULL_TURN)).rational == 1
    assert prior.best_window(FULL_TURN).mass.rational == 1


@given(exact_priors, widths)
def test_a_window_is_what_it_says(prior, width):
    window = prior.best_window(width)
    assert ZERO <= window.start < FULL_TURN
    assert prior.mass(Arc(window.start, width)) == window.mass
    if not window.exact:
        assert window.mass < window.at_most


@given(exact_priors, widths, orientations)
def test_no_start_is_better(prior, width, start):
    window = prior.best_window(width)
    bound = window.mass if window.exact else window.at_most
    assert prior.mass(Arc(start, width)) <= bound


@given(exact_priors, widths, widths)
def test_lemma_f_1_wider_windows_catch_more(prior, one, other):
    """No narrower mouth catches more, wherever it stands: the heart of Lemma F.1."""
    narrow, wide = sorted([one, other])
    best, worse = prior.best_window(wide), prior.best_window(narrow)
    assert worse.mass <= (best.mass if best.exact else best.at_most)


@given(discrete, orientations, orientations, widths)
def test_turning_prior_and_arc_changes_nothing(prior, angle, start, width):
    again = turned(prior, angle)
    assert again.mass(Arc(start + angle, width)) == prior.mass(Arc(start, width))
    assert again.best_window(width).mass == prior.best_window(width).mass


@given(piecewise, orientations, widths)
def test_the_derivative_is_the_difference_of_the_densities(prior, start, width):
    """dp/dtheta = f(theta + h) - f(theta), exactly on a step short enough to meet no break."""
    step = Angle(0, (10**60, 1))
    gain = prior.mass(Arc(start + step, width)) - prior.mass(Arc(start, width))
    near = [prior.density_at(place) for place in (start, start + step)]
    far = [prior.density_at(place) for place in (start + width, start + width + step)]
    if near[0] == near[1] and far[0] == far[1]:
        share = uniform_prior().mass(Arc(ZERO, step))
        assert gain == share.scaled(far[0] - near[0])


@given(piecewise, widths)
def test_eq_f_5_in_its_form_for_steps(prior, width):
    """At the best window neither direction gains: one-sided derivatives have the right signs."""
    start = prior.best_window(width).start
    tiny = Angle(0, (10**60, 1))
    after = prior.density_at(start + width) - prior.density_at(start)
    before = prior.density_at(start + width - tiny) - prior.density_at(start - tiny)
    assert after <= 0 <= before or width == FULL_TURN


@given(symmetric_priors, widths)
@settings(max_examples=50)
def test_eq_f_5_both_ends_have_one_density(prior, width):
    window = prior.best_window(width)
    near, far = prior.density_at(window.start), prior.density_at(window.start + width)
    if window.exact:
        assert near.compare(far) == 0
    else:
        # The ends are off by 2**-20 of the width: apart by the slope times that.
        peak = float(prior.density_at(prior.mean))
        assert abs(float(near) - float(far)) <= 2.0**-17 * peak * max(peak, 1)


@given(symmetric_priors, orientations, widths, widths)
@settings(max_examples=30)
def test_certified_masses_add_up(prior, start, first, second):
    if first + second >= FULL_TURN:
        return
    parts = prior.mass(Arc(start, first)) + prior.mass(Arc(start + first, second))
    with working_precision(128):
        assert parts.ball().overlaps(prior.mass(Arc(start, first + second)).ball())


@given(symmetric_priors, orientations, orientations, widths)
@settings(max_examples=30)
def test_turning_a_symmetric_prior(prior, angle, start, width):
    again = turned(prior, angle)
    with working_precision(128):
        mine = prior.mass(Arc(start, width)).ball()
        assert mine.overlaps(again.mass(Arc(start + angle, width)).ball())
        assert mine.rad() < 2.0**-100


@given(symmetric_priors, widths, widths)
@settings(max_examples=30)
def test_wider_centred_windows_catch_more(prior, one, other):
    narrow, wide = (float(prior.best_window(width).mass) for width in sorted([one, other]))
    assert narrow <= wide + 1e-9


@pytest.mark.parametrize("share", [Fraction(1, 7), Fraction(1, 2)])
def test_the_derivative_of_a_normal_mass(share):
    """The sign of dp/dtheta by finite differences: plus f(theta + h), minus f(theta)."""
    prior, width = WrappedNormal("100", "20"), Angle.from_turns(share)
    step = Angle.from_degrees("0.0001")
    for start in (Angle.from_degrees(d) for d in (10, 60, 99, 150, 300)):
        gain = float(prior.mass(Arc(start + step, width))) - float(prior.mass(Arc(start, width)))
        slope = float(prior.density_at(start + width)) - float(prior.density_at(start))
        assert abs(gain * 360 / 0.0001 - slope) < 1e-3
