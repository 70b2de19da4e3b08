"""Laws of sections 6.3 and 6.4: urns, Dirichlet posteriors, least squared error, frequencies.

Moments of a posterior are integrals of likelihood times prior over the simplex, taken term by term:
no formula for a Dirichlet distribution is used.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from math import comb, factorial, prod

from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.additive_costs import AdditiveCost
from stochgeom.decision.plan_search import find_plan
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.tilting.all_plans import best_tilt_plan, plan_levels
from stochgeom.tilting.counts import TransitionCounts
from stochgeom.tilting.estimation import TransitionModel
from tests.strategies import distributions, tilt_instances, transition_models

some = settings(max_examples=100)

trials = st.integers(2, 3).flatmap(lambda k: st.lists(st.integers(0, 3), min_size=k, max_size=k))
"""Counts of two or three outcomes."""


@st.composite
def observed(draw, *, whole=False):
    """Counts of one row, and an alpha for each outcome: whole numbers, or rational ones too."""
    counts = draw(trials)
    values = [1, 2, 3] if whole else [1, 2, 3, "1/100", "7/3"]
    alphas = st.lists(st.sampled_from(values), min_size=len(counts), max_size=len(counts))
    return counts, [mpq(alpha) for alpha in draw(alphas)]


def row_model(counts, alpha):
    """Return the model whose first row has these counts, with as many states as outcomes."""
    nothing = [[0] * len(counts)] * (len(counts) - 1)
    return TransitionModel(TransitionCounts([[list(counts), *nothing]]), list(alpha))


def segment(a, b):
    """Integral of p^a (1 - p)^b over [0, 1], the power of 1 - p multiplied out."""
    return sum(Fraction((-1) ** j * comb(b, j), a + j + 1) for j in range(b + 1))


def simplex(powers):
    """Integral of the product of p_j^powers[j] over all p of sum 1, one variable after another."""
    first, *rest = powers
    if not rest:
        return Fraction(1)
    # With p_1 fixed the rest is a simplex of size 1 - p_1, in len(rest) - 1 variables.
    return segment(first, sum(rest) + len(rest) - 1) * simplex(rest)


def posterior_mean(counts, alpha, *factors):
    """Mean of the product of some entries of p under likelihood times prior (Eq. 6.5 to 6.7)."""
    powers = [int(a) - 1 + x for a, x in zip(alpha, counts, strict=True)]
    raised = [power + factors.count(j) for j, power in enumerate(powers)]
    return simplex(raised) / simplex(powers)


def plain(value):
    """Return a library's number as a fraction of Python's."""
    return Fraction(int(value.numerator), int(value.denominator))


# --- Eq. 6.2, 6.3: urns --------------------------------------------------------------------------


def urn_after(shares, n):
    """Return the distribution of counts after n draws with replacement, as the planner has it."""
    colors = range(len(shares))
    drawn = [k for k in product(range(n + 1), repeat=len(shares)) if sum(k) <= n]

    def draw(counts, _):
        if sum(counts) == n:
            return counts
        more = [tuple(c + (i == j) for j, c in enumerate(counts)) for i in colors]
        return dict(zip(more, shares, strict=True))

    urn = PlanningProblem.from_function(drawn, {(0,) * len(shares): 1}, ["draw"], draw)
    after = urn.run(["draw"] * n)
    return {counts: after[urn.state_number(counts)] for counts in drawn}


@given(st.integers(2, 3).flatmap(distributions), st.integers(1, 4))
@settings(max_examples=50)
def test_counts_of_draws_are_multinomial(shares, n):
    """Eq. 6.2 and the moments below it; refuted by another probability, mean or covariance."""
    after = urn_after(shares, n)
    colors = range(len(shares))
    for counts, found in after.items():
        ways = Fraction(factorial(n), prod(map(factorial, counts))) if sum(counts) == n else 0
        assert found == ways * prod(p**x for p, x in zip(shares, counts, strict=True))
    means = [sum(p * counts[i] for counts, p in after.items()) for i in colors]
    assert means == [n * p for p in shares]
    for i, j in product(colors, repeat=2):
        both = sum(p * counts[i] * counts[j] for counts, p in after.items())
        expected = n * shares[i] * (1 - shares[i]) if i == j else -n * shares[i] * shares[j]
        assert both - means[i] * means[j] == expected


# --- Eq. 6.4 to 6.11: the posterior --------------------------------------------------------------


@given(observed(whole=True))
@some
def test_moments_of_the_posterior_are_integrals(case):
    """Eq. 6.10, 6.11 and, where nothing was seen, the mean and covariances of a Dirichlet.

    Refuted by a mean, variance or covariance that likelihood times prior does not have.
    """
    counts, alpha = case
    model, k = row_model(counts, alpha), range(len(counts))
    mean = [posterior_mean(counts, alpha, j) for j in k]
    assert [plain(entry) for entry in model.row(1, 1)] == mean
    for i, j in product(k, repeat=2):
        expected = posterior_mean(counts, alpha, i, j) - mean[i] * mean[j]
        assert plain(model.covariance(1, 1, i + 1, j + 1)) == expected
        if i == j:
            assert plain(model.variance(1, 1, i + 1)) == expected


@given(observed(), st.data())
@some
def test_a_posterior_is_the_next_prior(case, data):
    """Conjugacy (Eq. 6.8): refuted by data in two parts that say something else than at once."""
    counts, alpha = case
    size = len(counts)
    more = data.draw(st.lists(st.integers(0, 3), min_size=size, max_size=size))
    at_once = row_model([x + y for x, y in zip(counts, more, strict=True)], alpha)
    later = row_model(more, row_model(counts, alpha).parameters(1, 1))
    assert at_once.row(1, 1) == later.row(1, 1)
    for i, j in product(range(1, size + 1), repeat=2):
        assert at_once.covariance(1, 1, i, j) == later.covariance(1, 1, i, j)


@given(observed())
@some
def test_covariances_are_what_two_trials_tell(case):
    """The chance of outcome i and then j is E(p_i p_j): by the row, and the row after an i.

    Refuted by a covariance that is not that less the product of the means, or an order of the two
    that matters.
    """
    counts, alpha = case
    model, k = row_model(counts, alpha), range(len(counts))
    mean = model.row(1, 1)
    after = [row_model([x + (j == i) for j, x in enumerate(counts)], alpha).row(1, 1) for i in k]
    for i, j in product(k, repeat=2):
        both = mean[i] * after[i][j]
        assert both == mean[j] * after[j][i]
        assert model.covariance(1, 1, i + 1, j + 1) == both - mean[i] * mean[j]


@given(observed())
@some
def test_the_variance_falls_in_expectation(case):
    """After Eq. 6.11: by the factor A / (A + 1), A the sum of the parameters; not with every trial.

    Refuted by a row whose variances are another number, weighted by the outcomes of one trial more.
    """
    counts, alpha = case
    model, k = row_model(counts, alpha), range(len(counts))
    mean, whole = model.row(1, 1), sum(alpha) + sum(counts)
    after = [row_model([x + (j == i) for j, x in enumerate(counts)], alpha) for i in k]
    for j in range(1, len(counts) + 1):
        expected = sum(p * m.variance(1, 1, j) for p, m in zip(mean, after, strict=True))
        assert expected == model.variance(1, 1, j) * whole / (whole + 1)


# --- squared error, Eq. 6.9 ----------------------------------------------------------------------


@given(observed(whole=True), st.fractions(0, 1, max_denominator=12))
@some
def test_the_mean_has_the_least_squared_error(case, guess):
    """E (P - g)^2 = E P^2 - 2 g mu + g^2 by integration, and no g but the mean has so little.

    Refuted by an estimate of an entry that is better than the row's.
    """
    counts, alpha = case
    model = row_model(counts, alpha)
    for j in range(len(counts)):
        mean, second = posterior_mean(counts, alpha, j), posterior_mean(counts, alpha, j, j)

        def loss(estimate, mean=mean, second=second):
            return second - 2 * estimate * mean + estimate * estimate

        best = plain(model.row(1, 1)[j])
        assert loss(best) == plain(model.variance(1, 1, j + 1))
        assert loss(guess) > loss(best) or guess == best


# --- Eq. 6.12: frequencies -----------------------------------------------------------------------


@given(trials, st.data())
@some
def test_frequencies_are_the_likeliest_parameters(counts, data):
    """Refuted by other parameters that make the observed counts as likely."""
    found = row_model(counts, [1] * len(counts)).maximum_likelihood(1, 1)
    if not any(counts):
        assert found is None
        return
    other = data.draw(distributions(len(counts)))

    def likelihood(p):
        return prod((plain(entry) ** x for entry, x in zip(p, counts, strict=True)), start=1)

    assert sum(found) == 1
    assert likelihood(found) > likelihood(map(mpq, other)) or list(found) == other


@given(observed(), st.integers(0, 12))
@some
def test_frequencies_and_means_come_together(case, power):
    """They differ by A / (A + n) at most, A the sum of alpha: both tend to the same as n grows.

    Refuted by a row that is farther away, with the counts multiplied as well.
    """
    counts, alpha = case
    counts = [x * 10**power for x in counts]
    if any(counts):
        model = row_model(counts, alpha)
        most = sum(alpha) / (sum(alpha) + sum(counts))
        pairs = zip(model.row(1, 1), model.maximum_likelihood(1, 1), strict=True)
        assert all(abs(mean - share) <= most for mean, share in pairs)


# --- 6.4: all plans ------------------------------------------------------------------------------


@given(transition_models(), st.integers(0, 3))
@some
def test_a_level_has_a_hyperstate_for_every_plan(model, most):
    """O(n^2 m^k), as a product with a matrix makes each; refuted by other than m^k for k tilts."""
    actions = range(1, model.counts.actions + 1)
    levels = plan_levels(model, 1, actions, most)
    assert [len(level) for level in levels] == [len(actions) ** k for k in range(most + 1)]


def test_three_tilts_of_twelve_are_1728_hyperstates():
    model = TransitionModel(TransitionCounts([[[1, 0], [0, 1]]] * 12))
    assert [len(level) for level in plan_levels(model, 1, range(1, 13), 3)] == [1, 12, 144, 1728]


@given(tilt_instances())
@some
def test_the_best_tilt_plan_costs_least(instance):
    """C = -p(goal) for the planner of chapter 2: refuted by another cost, or fewer tilts."""
    model, start, goal = instance
    names = [str(outcome) for outcome in model.counts.outcomes]
    lost = [[mpq(name == other) for other in names] for name in names[model.counts.states :]]
    actions = range(1, model.counts.actions + 1)
    matrices = {str(a): [*map(list, model.matrix(a)), *lost] for a in actions}
    problem = PlanningProblem(names, {str(start): 1}, list(matrices), matrices)
    found = find_plan(problem, 3, AdditiveCost(0, {str(goal): -1}), shortest=0)
    plan = best_tilt_plan(model, start, goal, 3)
    assert found.proven
    assert (found.cost, len(found.plan)) == (-plan.probability, plan.steps)
