"""Plans under priors: Lemma F.1 against every plan at every placement, phase II, gripper errors."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise, product

from hypothesis import assume, given
from hypothesis import strategies as st

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.priors import uniform_prior
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.sums import AngleSum
from stochgeom.feeding.action_classes import ActionClasses
from stochgeom.feeding.exhaustive import search_plans
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.transfer.step_function import StepFunction
from tests.strategies import hulls, transfer_functions


def deg(value):
    return Angle.from_degrees(value)


@st.composite
def discrete_priors(draw, most=5):
    """Draw few weighted orientations on a coarse grid, so that windows often tie."""
    places = draw(st.lists(st.integers(0, 23), min_size=1, max_size=most, unique=True))
    counts = [draw(st.integers(1, 4)) for _ in places]
    return DiscretePrior.from_counts([(15 * k, n) for k, n in zip(places, counts, strict=True)])


@st.composite
def piecewise_priors(draw):
    """Draw a histogram with bins of whole multiples of 30 degrees."""
    edges = sorted(draw(st.sets(st.integers(0, 11), min_size=2, max_size=5)))
    counts = [draw(st.integers(0, 3)) for _ in edges[1:]]
    assume(any(counts))
    return PiecewisePrior.from_histogram([30 * edge for edge in edges], counts)


exact_priors = st.one_of(discrete_priors(), piecewise_priors())


def small_maps():
    """Transfer functions of few steps, some with values far from their steps."""
    return transfer_functions().filter(lambda s: len(s) * s.order <= 8)


# --- Lemma F.1 -----------------------------------------------------------------------------------


def most_caught(s: StepFunction, steps: int, prior: DiscretePrior) -> Fraction:
    """Return the most that any plan of so many steps brings into one final orientation.

    Every sequence of action classes after the first action, and for that one every angle at which
    a point of the prior lies on a break: between two such angles nothing changes, and what the
    half-open steps lose just beside one they keep just on the other side.
    """
    best = Fraction(0)
    classes = ActionClasses(s)
    turns = {
        (point - break_ + s.period * k).reduced()
        for point, _ in prior
        for break_ in s.breaks
        for k in range(s.order)
    }
    words = [
        classes.representatives(word)
        for word in product(range(len(classes.merged)), repeat=steps - 1)
    ]
    for first, word in product(turns, words):
        caught: dict[Angle, Fraction] = {}
        for point, weight in prior:
            state = s(point - first)
            for action in word:
                state = s(state - action.angle)
            final = state.reduced()
            caught[final] = caught.get(final, Fraction(0)) + Fraction(str(weight))
        best = max(best, *caught.values())
    return best


@given(small_maps().filter(lambda s: len(s) <= 3), discrete_priors(most=3), st.integers(1, 2))
def test_no_plan_of_the_same_length_catches_more(s, prior, steps):
    """Lemma F.1; refuted by a plan, of whatever mouth and wherever it stands, that does."""
    problem = FeedingProblem.of_transfer(s, prior=prior)
    assert Fraction(str(problem.probability(steps).rational)) == most_caught(s, steps, prior)


@given(small_maps(), exact_priors, st.sampled_from([0, 1, "1/3", 7]))
def test_the_optimal_plan_is_that_of_the_search(s, prior, c):
    problem = FeedingProblem.of_transfer(s, prior=prior)
    plan = problem.optimal_plan(c)
    found = search_plans(s, cost_ratio=c, prior=prior, node_limit=3000)
    assume(found.solved)
    assert plan.steps == found.optimal_steps(c)
    assert plan.expected_cost.compare(found.expected_cost(plan.steps, c)) == 0


# --- what a placed plan does ---------------------------------------------------------------------


@given(small_maps(), exact_priors, st.integers(1, 4))
def test_the_mouth_catches_what_it_says(s, prior, steps):
    problem = FeedingProblem.of_transfer(s, prior=prior)
    plan = problem.plan_of(problem.preimages.of_steps(steps).steps)
    assert plan.verify()
    assert plan.probability.compare(prior.mass(plan.mouth)) == 0
    assert ZERO <= plan.mouth.start < FULL_TURN
    final = plan.execute(plan.mouth.start)[-1].reduced()
    assert final == plan.final_orientation.reduced()
    masses = plan.distribution()
    place = masses.orientations.index(final)
    assert masses.probability(place).compare(plan.probability) >= 0
    total = sum((masses.probability(k) for k in range(len(masses))), start=AngleSum())
    assert total.compare(1) == 0


@given(small_maps(), discrete_priors(), st.integers(1, 4))
def test_distributions_are_counts_of_points(s, prior, steps):
    problem = FeedingProblem.of_transfer(s, prior=prior)
    plan = problem.plan_of(problem.preimages.of_steps(steps).steps)
    for step in range(1, plan.steps + 1):
        counted: dict[Angle, Fraction] = {}
        for point, weight in prior:
            state = plan.execute(point)[step].reduced()
            counted[state] = counted.get(state, Fraction(0)) + Fraction(str(weight))
        state = plan.distribution(step)
        for k, orientation in enumerate(state.orientations):
            found = Fraction(str(state.probability(k).rational))
            assert found == counted.get(orientation, Fraction(0))
        assert state.probability(state.most_likely()).rational == max(counted.values())


@given(small_maps(), exact_priors)
def test_probabilities_grow_with_the_steps(s, prior):
    problem = FeedingProblem.of_transfer(s, prior=prior)
    found = [problem.probability(p.steps) for p in problem.preimages]
    assert all(later.compare(earlier) >= 0 for earlier, later in pairwise(found))
    assert problem.geometric_plan().probability_up_to_symmetry.compare(1) == 0


@given(hulls())
def test_a_uniform_prior_is_no_prior(part):
    with_prior = FeedingProblem(part, prior=uniform_prior()).optimal_plan()
    without = FeedingProblem(part).optimal_plan()
    assert with_prior.prior is None
    assert with_prior.angles == without.angles
    even = PiecewisePrior([(Arc(ZERO, FULL_TURN), 1)])
    placed = FeedingProblem(part, prior=even).optimal_plan()
    assert placed.steps == without.steps
    assert placed.probability.compare(AngleSum(0, [(1, without.mouth.width)])) == 0


@given(small_maps(), exact_priors, exact_priors, st.sampled_from(["1/2", "1/3"]))
def test_knowing_more_never_hurts(s, one, other, share):
    """The best plan for a mixture does no better than the best plans for what it mixes."""
    from stochgeom.decision.mixture_prior import MixturePrior

    q = Fraction(share)
    mixed = MixturePrior([(share, one), (1 - q, other)])
    steps = 2
    p, a, b = (
        FeedingProblem.of_transfer(s, prior=prior).probability(steps)
        for prior in (mixed, one, other)
    )
    assert p.compare(a.scaled(q) + b.scaled(1 - q)) <= 0


# --- gripper errors ------------------------------------------------------------------------------


@given(small_maps(), exact_priors, st.sampled_from(["1/2", "2", "7.5", "15"]), st.data())
def test_whatever_the_errors_are_the_mouth_is_caught(s, prior, delta, data):
    problem = FeedingProblem.of_transfer(s, prior=prior, gripper_error=delta)
    chain = list(problem.preimages)
    steps = data.draw(st.integers(1, len(chain)))
    assume(problem.placement(steps) is not None)
    plan = problem.plan_of(steps)
    error = deg(delta)
    inside = [plan.mouth.start, plan.mouth.start + plan.mouth.width]
    signs = data.draw(st.lists(st.sampled_from([-1, 0, 1]), min_size=steps, max_size=steps))
    if plan.mouth.width == FULL_TURN:
        signs[0] = 0
    angles = [angle + sign * error for angle, sign in zip(plan.angles, signs, strict=True)]
    first = s(inside[0] - angles[0])
    last = s.lifted_values[s.step_before(inside[1] - angles[0])]
    for angle in angles[1:]:
        first, last = s(first - angle), s(last - angle)
    assert first == last
    assert first.reduced() == plan.final_orientation.reduced()
