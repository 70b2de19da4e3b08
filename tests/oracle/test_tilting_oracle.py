"""Estimates beside scipy's distributions, plans beside a plain search over all of them."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from math import prod

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import integrate, stats

from stochgeom.tilting.all_plans import best_tilt_plan, best_tilt_plans
from stochgeom.tilting.beta_density import BetaDensity
from stochgeom.tilting.bounded_search import bounded_tilt_search
from stochgeom.tilting.counts import TransitionCounts
from stochgeom.tilting.estimation import TransitionModel
from stochgeom.tilting.intervals import wilson_interval
from stochgeom.tilting.posterior import (
    credible_interval,
    posterior_median,
    predictive_check,
    sample_matrices,
    sampled_probabilities,
)
from stochgeom.tilting.shortest_path import shortest_path_tilt_plan
from stochgeom.tilting.tilt_plans import evaluate_tilt_plan
from stochgeom.tilting.uncertain_plans import best_expected_tilt_plan, expected_probability
from tests.strategies import long_ways, tilt_instances, transition_models

some = settings(max_examples=60)


# --- a second road, in fractions and without the library's own sums -------------------------------


def rows_of(model):
    """Parameters alpha + x by (action, state), as fractions, straight from the counts."""
    return {
        (a, i): [
            Fraction(int(alpha.numerator), int(alpha.denominator)) + int(x)
            for alpha, x in zip(model.alpha[i], model.counts.table[a, i], strict=True)
        ]
        for a in range(model.counts.actions)
        for i in range(model.counts.states)
    }


def rising(base, times):
    return prod((base + k for k in range(times)), start=Fraction(1))


def by_paths(model, start, goal, actions, *, expected):
    """Sum over all paths: of products of means, or of means of products (Dirichlet moments)."""
    rows, n, total = rows_of(model), model.counts.states, Fraction(0)
    if not actions:
        return Fraction(start == goal)
    for middle in product(range(n), repeat=len(actions) - 1):
        path = (start - 1, *middle, goal - 1)
        used = {}
        for a, i, j in zip(actions, path, path[1:], strict=False):
            used.setdefault((a - 1, i), []).append(j)
        chance = Fraction(1)
        for key, drawn in used.items():
            row = rows[key]
            if expected:
                chance *= prod(rising(row[j], drawn.count(j)) for j in set(drawn))
                chance /= rising(sum(row), len(drawn))
            else:
                chance *= prod(row[j] / sum(row) for j in drawn)
        total += chance
    return total


def best_by_search(model, start, goal, most, value):
    words = (
        word
        for tilts in range(most + 1)
        for word in product(range(1, model.counts.actions + 1), repeat=tilts)
    )
    return min((-value(word), len(word), word) for word in words)


@given(tilt_instances())
@some
def test_the_best_plan_is_the_best_of_all(instance):
    model, start, goal = instance

    def value(word):
        return by_paths(model, start, goal, word, expected=False)

    probability, _, word = best_by_search(model, start, goal, 3, value)
    for plan in (
        best_tilt_plan(model, start, goal),
        bounded_tilt_search(model, start, goal).plan,
        best_tilt_plans(model).get((start, goal), best_tilt_plan(model, start, goal)),
    ):
        assert (plan.actions, plan.probability) == (word, -probability)


@given(tilt_instances())
@some
def test_the_plan_of_highest_expectation_is_the_best_of_all(instance):
    model, start, goal = instance

    def value(word):
        return by_paths(model, start, goal, word, expected=True)

    probability, _, word = best_by_search(model, start, goal, 3, value)
    plan = best_expected_tilt_plan(model, start, goal)
    assert (plan.actions, plan.probability) == (word, -probability)
    assert expected_probability(model, start, goal, word) == -probability


def likeliest_path(model, start, goal, most):
    """Product, tilts and words of the best of all paths of states under all words of tilts."""
    rows, n = rows_of(model), model.counts.states
    found = [(Fraction(1), 0, ())] if start == goal else []
    for tilts in range(1, most + 1):
        for word in product(range(model.counts.actions), repeat=tilts):
            for middle in product(range(n), repeat=tilts - 1):
                path = (start - 1, *middle, goal - 1)
                steps = zip(word, path, path[1:], strict=False)
                chance = prod(rows[a, i][j] / sum(rows[a, i]) for a, i, j in steps)
                found.append((chance, tilts, tuple(a + 1 for a in word)))
    best = max(chance for chance, _, _ in found)
    fewest = min(tilts for chance, tilts, _ in found if chance == best)
    return best, fewest, {word for chance, k, word in found if (chance, k) == (best, fewest)}


@given(st.one_of(tilt_instances(), long_ways()), st.integers(1, 3))
@some
def test_the_bound_is_the_product_of_the_likeliest_path(instance, most):
    """7.1.2: the heuristic finds a shortest path of lengths -log p, so that it maximises its bound.

    Refuted by a path, under any tilts, of a larger product, or as large a one with fewer tilts.
    """
    model, start, goal = instance
    plan = shortest_path_tilt_plan(model, start, goal, most)
    best, fewest, words = likeliest_path(model, start, goal, most)
    assert plan.bound == best
    assert plan.steps == fewest
    assert plan.actions in words
    if most >= model.counts.states - 1:  # no longer path helps
        assert shortest_path_tilt_plan(model, start, goal).bound == best


def test_a_path_of_three_tilts_may_be_the_likeliest():
    """.9 x .9 x 1 along all four states; short cuts are taken once in ten times."""
    ring = [[0, 9, 1, 0], [0, 0, 9, 1], [0, 0, 0, 10], [10, 0, 0, 0]]
    model = TransitionModel(TransitionCounts([ring]), "1/1000")
    plan = shortest_path_tilt_plan(model, 1, 4)
    assert plan.actions == (1, 1, 1)
    assert plan.bound > Fraction(8, 10)
    assert shortest_path_tilt_plan(model, 1, 4, 2).bound < Fraction(11, 100)


def test_expectation_is_what_sampling_tends_to():
    """The same tilt twice over a row seen once: plug-in and expectation are far apart."""
    model = TransitionModel(TransitionCounts([[[1, 0], [0, 1]]]), 1)
    expected = float(expected_probability(model, 1, 2, (1, 1)))
    plug_in = float(evaluate_tilt_plan(model, 1, 2, (1, 1)).probability)
    sampled = sampled_probabilities(sample_matrices(model, 40_000, seed=5), 1, 2, (1, 1))
    error = 5 * sampled.std() / 200
    assert abs(sampled.mean() - expected) < error < abs(plug_in - expected)


# --- scipy ----------------------------------------------------------------------------------------


@given(transition_models())
@some
def test_means_and_variances_are_those_of_scipys_dirichlet(model):
    for a in range(1, model.counts.actions + 1):
        for i in range(1, model.counts.states + 1):
            parameters = [float(value) for value in model.parameters(a, i)]
            if len(parameters) == 1:
                assert model.row(a, i) == (1,)
                continue
            mean = stats.dirichlet.mean(parameters)
            variance = stats.dirichlet.var(parameters)
            for j, outcome in enumerate(model.counts.outcomes):
                assert float(model.probability(a, i, outcome)) == pytest.approx(mean[j], rel=1e-12)
                assert float(model.variance(a, i, outcome)) == pytest.approx(variance[j], rel=1e-10)


def test_quantiles_are_those_of_the_marginal():
    model = TransitionModel(TransitionCounts([[[3, 1, 0], [0, 2, 2]]]), "1/2")
    marginal = stats.beta(3.5, 2.0)
    median = posterior_median(model, 1, 1, 1)
    low, high = credible_interval(model, 1, 1, 1, 0.9)
    assert marginal.cdf([median, low, high]) == pytest.approx([0.5, 0.05, 0.95], abs=1e-12)


def test_the_median_has_the_least_absolute_error():
    model = TransitionModel(TransitionCounts([[[1, 4]]]), 1)
    marginal = stats.beta(*map(float, model.marginal(1, 1, 1)))

    def absolute_error(guess):
        return integrate.quad(lambda p: abs(p - guess) * marginal.pdf(p), 0, 1, points=[guess])[0]

    median = posterior_median(model, 1, 1, 1)
    own = absolute_error(median)
    assert own < min(absolute_error(median + step) for step in (-0.01, 0.01))
    assert own < absolute_error(float(model.probability(1, 1, 1)))


def test_samples_have_the_moments_of_the_posterior():
    model = TransitionModel(TransitionCounts([[[3, 1, 0], [0, 0, 0]]]), "1/100")
    draws = 20_000
    matrices = sample_matrices(model, draws, seed=3)
    assert matrices.sum(axis=3).min() == pytest.approx(1)
    for state in (1, 2):
        for j, outcome in enumerate(model.counts.outcomes):
            variance = float(model.variance(1, state, outcome))
            error = abs(matrices[:, 0, state - 1, j].mean() - model.probability(1, state, outcome))
            assert error < 5 * np.sqrt(variance / draws)
    assert (matrices[:, 0, 2] == [0, 0, 1]).all()


def test_the_same_seed_draws_the_same():
    model = TransitionModel(TransitionCounts([[[3, 1, 0], [0, 0, 0]]]))
    assert (sample_matrices(model, 5, seed=1) == sample_matrices(model, 5, seed=1)).all()
    assert not (sample_matrices(model, 5, seed=1) == sample_matrices(model, 5, seed=2)).all()


def test_p_values_are_those_of_all_outcomes():
    """Two outcomes, five trials: six possible counts, and their Dirichlet-multinomial masses."""
    model = TransitionModel(TransitionCounts([[[6, 2]]]), 1)
    law = stats.dirichlet_multinomial([7, 3], 5)
    masses = {k: law.pmf([k, 5 - k]) for k in range(6)}
    for k in range(6):
        expected = sum(mass for mass in masses.values() if mass <= masses[k] + 1e-12)
        row = predictive_check(model, TransitionCounts([[[k, 5 - k]]]), draws=4000, seed=k)[0]
        assert row.p_value == pytest.approx(expected, abs=0.03)


def test_the_check_is_calibrated():
    """Counts drawn from the model itself give small p-values as seldom as they are small."""
    model = TransitionModel(TransitionCounts([[[20, 5, 1], [2, 9, 4]]]), 1)
    random = np.random.default_rng(8)
    values = []
    for number in range(150):
        matrices = sample_matrices(model, 1, seed=number)[0, 0, :2]
        counts = [[random.multinomial(12, row) for row in matrices]]
        seen = TransitionCounts(np.array(counts))
        values += [row.p_value for row in predictive_check(model, seen, draws=99, seed=number)]
    assert 0.02 < np.mean(np.array(values) <= 0.1) < 0.16


@pytest.mark.parametrize(("a", "b"), [(1, 1), ("0.1", "0.1"), (8, 8), (16, 16), (4, 1), (1, 4)])
def test_the_beta_density_is_scipys(a, b):
    density = BetaDensity(a, b)
    law = stats.beta(float(density.alpha_2), float(density.alpha_1))
    for p in (0.001, 0.2, 0.5, 0.77, 0.999):
        assert density(p) == pytest.approx(law.pdf(p), rel=1e-10)
    for end in (0.0, 1.0):
        assert density(end) == pytest.approx(law.pdf(end))
    assert float(density.mean) == pytest.approx(law.mean())
    assert float(density.variance) == pytest.approx(law.var())


@pytest.mark.parametrize(("k", "n"), [(0, 1), (1, 1), (0, 250), (126, 250), (249, 250), (250, 250)])
def test_wilsons_interval_is_scipys(k, n):
    for level in (0.9, 0.95, 0.99):
        found = stats.binomtest(k, n).proportion_ci(level, method="wilson")
        assert wilson_interval(k, n, level) == pytest.approx(tuple(found), abs=1e-12)
