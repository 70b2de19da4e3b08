"""Estimating a prior from counts of accepted and rejected parts."""

from __future__ import annotations

from itertools import product
from math import comb, log

import numpy as np
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.prior_estimates import PriorEstimate, cells_between
from stochgeom.decision.rejections import Observation, Rejections
from stochgeom.errors import InputError, NumberError, PriorError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc, union_measure
from stochgeom.feeding.planner import plan_feeding
from tests.strategies import arcs


def deg(value):
    return Angle.from_degrees(value)


CELLS = [deg(0), deg(90), deg(180), deg(270)]


def over(first, count, accepted, rejected):
    """A mouth over some cells in a row."""
    return Observation(Arc(deg(90 * first - 5), deg(90 * count)), accepted, rejected)


def brute_force_mean(cells, seen, alphas):
    """Posterior mean by expanding the likelihood: all ways to share out the parts seen."""
    sets = []
    for observation in seen:
        inside = [c for c, cell in enumerate(cells) if observation.mouth.contains(cell)]
        outside = [c for c in range(len(cells)) if c not in inside]
        sets += [inside] * observation.accepted + [outside] * observation.rejected
    total, mean = mpq(0), [mpq(0)] * len(cells)
    for choice in product(*sets):
        powers = [alpha + choice.count(c) for c, alpha in enumerate(alphas)]
        # The Dirichlet integral of the monomial, up to a constant: product of Gamma(power).
        weight = mpq(1)
        for power in powers:
            for k in range(1, power):
                weight *= k
        total += weight
        for c, power in enumerate(powers):
            mean[c] += weight * mpq(power, sum(powers))
    return [m / total for m in mean]


class TestMaximumLikelihood:
    def test_disjoint_mouths_give_the_relative_counts(self):
        seen = Rejections(CELLS[:2], [Observation(Arc(deg(-5), deg(10)), 30, 70)])
        estimate = seen.maximum_likelihood()
        assert estimate.weights == (mpq(3, 10), mpq(7, 10))
        assert (estimate.exact, estimate.cells) == (False, (deg(0), deg(90)))
        assert estimate.gap <= 1e-9
        assert "EM" in estimate.method

    def test_consistent_data_are_fitted(self):
        truth = [mpq(1, 10), mpq(2, 10), mpq(3, 10), mpq(4, 10)]
        seen = []
        for first in range(4):
            share = truth[first] + truth[(first + 1) % 4]
            seen.append(over(first, 2, int(1000 * share), int(1000 * (1 - share))))
        seen.append(over(0, 1, 100, 900))
        rejections = Rejections(CELLS, seen)
        assert rejections.is_identifiable
        estimate = rejections.maximum_likelihood()
        assert [round(float(w), 6) for w in estimate.weights] == [0.1, 0.2, 0.3, 0.4]
        assert estimate.to_prior() == DiscretePrior(zip(CELLS, estimate.weights, strict=True))

    def test_what_is_not_told_apart_keeps_its_proportions(self):
        rejections = Rejections(CELLS, [over(0, 2, 60, 40)])
        assert not rejections.is_identifiable
        even = rejections.maximum_likelihood().weights
        assert even == (mpq(3, 10), mpq(3, 10), mpq(1, 5), mpq(1, 5))
        uneven = rejections.maximum_likelihood(start=[2, 1, 1, 3]).weights
        assert uneven == (mpq(2, 5), mpq(1, 5), mpq(1, 10), mpq(3, 10))

    def test_nothing_is_likelier(self):
        rejections = Rejections(CELLS, [over(0, 2, 30, 5), over(1, 2, 9, 21), over(3, 1, 2, 8)])
        estimate = rejections.maximum_likelihood()
        best = rejections.log_likelihood(estimate.weights)
        random = np.random.default_rng(1)
        for weights in random.dirichlet(np.ones(4), size=200):
            assert rejections.log_likelihood(weights) <= best + 1e-6
        assert rejections.log_likelihood([0, 0, 1, 0]) == -np.inf

    def test_a_round_that_is_cut_short_says_so(self):
        rejections = Rejections(CELLS, [over(0, 2, 30, 5), over(1, 2, 9, 21)])
        estimate = rejections.maximum_likelihood(most_iterations=2)
        assert estimate.iterations == 2
        assert estimate.gap > 1e-9

    def test_the_gap_is_hardly_more_than_what_is_missing(self):
        rejections = Rejections(CELLS[:2], [over(0, 1, 100, 0)])
        estimate = rejections.maximum_likelihood([9, 1], most_iterations=1)
        missing = 100 * log(10 / 9)  # before the round; the best weights are 1 and 0
        assert estimate.gap == pytest.approx(100 * (10 / 9 - 1))
        assert missing < estimate.gap < 1.06 * missing

    @given(
        st.lists(
            st.tuples(st.integers(0, 3), st.integers(1, 3), st.integers(0, 9), st.integers(0, 9)),
            min_size=1,
            max_size=4,
        )
    )
    @settings(max_examples=40)
    def test_every_round_is_likelier(self, rows):
        rejections = Rejections(CELLS, [over(*row) for row in rows])
        if not rejections.total:
            return
        last = -np.inf
        for rounds in (0, 1, 2, 5, 20):
            estimate = rejections.maximum_likelihood(most_iterations=rounds)
            assert sum(estimate.weights) == 1
            now = rejections.log_likelihood([max(float(w), 1e-12) for w in estimate.weights])
            assert now >= last - 1e-5
            last = now


class TestPosterior:
    def test_a_single_mouth_is_exact(self):
        estimate = Rejections(CELLS, [over(0, 1, 3, 1)]).posterior_mean()
        assert estimate.exact
        assert estimate.weights == (mpq(1, 2), mpq(1, 6), mpq(1, 6), mpq(1, 6))
        assert estimate.standard_errors == ()

    def test_no_data_leave_the_dirichlet_prior(self):
        estimate = Rejections(CELLS, []).posterior_mean(["1", "2", "3", "2"])
        assert estimate.weights == (mpq(1, 8), mpq(1, 4), mpq(3, 8), mpq(1, 4))

    @pytest.mark.parametrize(
        "seen",
        [
            [over(0, 1, 2, 1)],
            [over(0, 2, 1, 3)],
            [over(0, 2, 2, 0), over(2, 1, 2, 0)],
            [over(0, 2, 2, 1), over(0, 2, 1, 0)],
        ],
    )
    def test_exact_means_by_brute_force(self, seen):
        estimate = Rejections(CELLS, seen).posterior_mean([1, 2, 1, 1])
        assert estimate.exact
        assert list(estimate.weights) == brute_force_mean(CELLS, seen, [1, 2, 1, 1])

    def test_sampled_means_by_brute_force(self):
        seen = [over(0, 2, 2, 1), over(1, 2, 3, 1)]
        estimate = Rejections(CELLS, seen).posterior_mean([1, 2, 1, 1], seed=3)
        assert not estimate.exact
        assert "seed 3" in estimate.method
        expected = brute_force_mean(CELLS, seen, [1, 2, 1, 1])
        for weight, error, truth in zip(
            estimate.weights, estimate.standard_errors, expected, strict=True
        ):
            assert 0 < error < 0.01
            assert abs(float(weight) - float(truth)) < 5 * error

    def test_a_seed_repeats_the_sample(self):
        rejections = Rejections(CELLS, [over(0, 2, 2, 1), over(1, 2, 3, 1)])
        one, two = (rejections.posterior_mean(seed=5, sweeps=100) for _ in range(2))
        assert one == two
        assert one != rejections.posterior_mean(seed=6, sweeps=100)


def test_arcs_as_cells():
    quarters = [Arc(deg(90 * k), deg(90)) for k in range(4)]
    seen = Rejections(quarters, [Observation(Arc(deg(270), deg(180)), 75, 25)])
    prior = seen.posterior_mean().to_prior()
    assert isinstance(prior, PiecewisePrior)
    assert prior.mass(Arc(deg(270), deg(180))).rational == mpq(77, 104)
    full = Rejections(quarters, [Observation(Arc(deg(10), FULL_TURN), 5, 0)])
    assert full.total == 5


def test_the_likelihood_is_binomial():
    rejections = Rejections(CELLS, [over(0, 1, 3, 2)])
    value = rejections.log_likelihood([mpq(1, 4)] * 4)
    assert abs(value - log(0.25**3 * 0.75**2)) < 1e-12
    assert comb(5, 3) == 10  # the number of orders in which they come is left out


class TestBadInput:
    @pytest.mark.parametrize("count", [-1, 1.5, "3", None])
    def test_counts(self, count):
        with pytest.raises(PriorError, match="accepted: whole numbers"):
            Observation(Arc(ZERO, deg(10)), count, 0)

    def test_no_cells(self):
        with pytest.raises(PriorError, match="0 cells"):
            Rejections([], [])

    def test_mixed_cells(self):
        with pytest.raises(PriorError, match="all angles or all arcs"):
            Rejections([ZERO, Arc(ZERO, deg(10))], [])

    def test_a_mouth_that_cuts_a_cell(self):
        with pytest.raises(PriorError, match="observation 0: the mouth cuts cell 0"):
            Rejections([Arc(ZERO, deg(10))], [Observation(Arc(deg(5), deg(90)), 1, 1)])

    def test_impossible_counts(self):
        with pytest.raises(PriorError, match="observation 0: 3 parts accepted by a mouth without"):
            Rejections(CELLS, [Observation(Arc(deg(10), deg(10)), 3, 1)])
        with pytest.raises(PriorError, match="1 parts rejected by a mouth with all"):
            Rejections(CELLS, [Observation(Arc(deg(10), FULL_TURN), 3, 1)])

    def test_nothing_counted(self):
        with pytest.raises(PriorError, match="no parts were counted"):
            Rejections(CELLS, [over(0, 1, 0, 0)]).maximum_likelihood()

    @pytest.mark.parametrize("alphas", [[1, 2, 3], [1, 2, 3, 0], []])
    def test_alphas(self, alphas):
        with pytest.raises(PriorError, match="4, all positive"):
            Rejections(CELLS, []).posterior_mean(alphas)

    def test_negative_and_float_alphas(self):
        with pytest.raises(PriorError, match="alpha -1 is negative"):
            Rejections(CELLS, []).posterior_mean([1, -1, 1, 1])
        with pytest.raises(NumberError, match="float"):
            Rejections(CELLS, []).posterior_mean([1, 0.5, 1, 1])

    def test_too_few_sweeps(self):
        rejections = Rejections(CELLS, [over(0, 2, 2, 1), over(1, 2, 3, 1)])
        with pytest.raises(InputError, match="20 or more"):
            rejections.posterior_mean(sweeps=3)

    @pytest.mark.parametrize("bins", [0, -1, 1.5, "4", None])
    def test_bins(self, bins):
        with pytest.raises(PriorError, match="bins; accepted: whole numbers from 1 to"):
            cells_between([], bins)


# --- cells ---------------------------------------------------------------------------------------


@settings(max_examples=60)
@given(st.lists(arcs(), max_size=4), st.integers(1, 6))
def test_no_mouth_cuts_a_cell_between_mouths(mouths, bins):
    cells = cells_between(mouths, bins)
    assert union_measure(cells) == FULL_TURN == sum((cell.width for cell in cells), ZERO)
    rejections = Rejections(cells, [Observation(mouth, 0, 0) for mouth in mouths])
    assert rejections.total == 0


def test_ends_move_to_rational_degrees():
    slope, hair = Angle(0, (3, 2)), Angle(0, (10**15, 1))
    cells = cells_between([Arc(slope, hair), Arc(deg(90), deg(90))])
    weights = tuple(mpq(k + 1, 15) for k in range(5))
    prior = PriorEstimate(cells, weights, "made up", exact=True).to_prior()
    assert len(prior.density.breaks) == 5
    for cell, place in zip(cells, prior.density.breaks, strict=True):
        assert abs((place - cell.start).to_float()) < 1e-15
        assert place == cell.start or cell.start.rational_turns is None
    ends = (*prior.density.breaks[1:], FULL_TURN)
    for start, end, weight in zip(prior.density.breaks, ends, weights, strict=True):
        assert prior.mass(Arc(start, end - start)).rational == weight


def test_from_rejections_to_a_better_plan():
    """Counts of two mouths of a real plan make a prior under which the plan costs less."""
    house = [(-1, -1), (1, -1), (1, 1), (0, 2), (-1, 1)]
    plan = plan_feeding(house)
    mouths = [plan.mouth.rotate(deg(angle)) for angle in (0, 100)]
    cells = cells_between(mouths, bins=12)
    seen = Rejections(cells, [Observation(mouths[0], 90, 10), Observation(mouths[1], 30, 70)])
    prior = seen.maximum_likelihood().to_prior()
    better = plan_feeding(house, prior=prior)
    assert better.expected_cost < plan.expected_cost
    assert better.verify()
