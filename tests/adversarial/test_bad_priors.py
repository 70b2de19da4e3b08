"""Priors that are none: every message names the value, the place and what is accepted."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from stochgeom.decision.density_priors import VonMises, WrappedNormal
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.mixture_prior import MixturePrior
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.priors import uniform_prior
from stochgeom.errors import (
    FloatRefusedError,
    InputError,
    InvalidArcError,
    NumberError,
    PriorError,
    StochgeomError,
)
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding.planner import orient_up_to_symmetry, plan_feeding

HALF, OTHER = Arc(ZERO, HALF_TURN), Arc(HALF_TURN, HALF_TURN)
IRRATIONAL = Arc(ZERO, Angle(0, (3, 2)))

PRIOR_ERRORS = [
    # discrete
    (lambda: DiscretePrior({"0": "1/2", "90": "1/3"}), "2 weights sum to 5/6; accepted"),
    (lambda: DiscretePrior({"0": "3/2"}), "1 weights sum to 3/2"),
    (lambda: DiscretePrior({}), "no points; accepted"),
    (lambda: DiscretePrior({"0": "3/2", "90": "-1/2"}), "point 1: weight -1/2 is negative"),
    (lambda: DiscretePrior.from_counts({}), "0 counts with sum 0"),
    (lambda: DiscretePrior.from_counts({"0": 0, "1": 0}), "2 counts with sum 0"),
    (lambda: DiscretePrior.from_counts({"0": -1}), "count 0: count -1 is negative"),
    (lambda: DiscretePrior.from_measurements([]), "0 counts with sum 0"),
    (lambda: DiscretePrior(5), "points: 5; accepted: pairs, each an orientation and its weight"),
    (lambda: DiscretePrior("90"), "points: '90'; accepted: pairs"),
    (lambda: DiscretePrior(["90"]), "point 0: '90'; accepted: an orientation and its weight"),
    (lambda: DiscretePrior([("0", 1), ("90",)]), "point 1: ('90',); accepted: an orientation"),
    (lambda: DiscretePrior.from_counts([5]), "point 0: 5; accepted: an orientation"),
    # piecewise
    (lambda: PiecewisePrior([]), "no pieces"),
    (lambda: PiecewisePrior([(HALF, 1)]), "integrate to 1/2 over their arcs; accepted"),
    (lambda: PiecewisePrior([(IRRATIONAL, 1)]), "integrate to 0.093584 over"),
    (lambda: PiecewisePrior([(HALF, 3), (OTHER, -1)]), "piece 1: density -1 is negative"),
    (lambda: PiecewisePrior([(HALF, 1), (Arc(ZERO, FULL_TURN), "1/2")]), "piece 1: pieces 0 and 1"),
    (lambda: PiecewisePrior.from_masses([]), "no pieces"),
    (lambda: PiecewisePrior.from_masses([(HALF, "1/2")]), "1 masses sum to 1/2"),
    (lambda: PiecewisePrior.from_masses([(IRRATIONAL, 1)]), "piece 0: an arc of 33.6901° has no"),
    (lambda: PiecewisePrior.from_masses([(HALF, -1)]), "piece 0: mass -1 is negative"),
    (
        lambda: PiecewisePrior.from_histogram(["0", "90", "45"], [1, 1]),
        "edge 2: bin edges 90 and 45",
    ),
    (lambda: PiecewisePrior.from_histogram(["0", "0"], [1]), "edge 1: bin edges 0 and 0 are not"),
    (lambda: PiecewisePrior.from_histogram(["0", "400"], [1]), "edge 1: bins span 400 degrees"),
    (lambda: PiecewisePrior.from_histogram(["0", "40"], [1, 2]), "2 edges and 2 counts"),
    (lambda: PiecewisePrior.from_histogram([], []), "0 edges and 0 counts"),
    (lambda: PiecewisePrior.from_histogram(["0", "40"], [0]), "1 counts with sum 0"),
    (lambda: PiecewisePrior.from_histogram(["0"], []), "0 counts with sum 0"),
    (lambda: PiecewisePrior(HALF), "pieces: Arc("),
    (lambda: PiecewisePrior([HALF]), "accepted: an Arc and its density"),
    (lambda: PiecewisePrior([("0", 1)]), "piece 0: '0' is no Arc; accepted: one"),
    (lambda: PiecewisePrior.from_masses([(90, 1)]), "piece 0: 90 is no Arc; accepted: one"),
    # mixtures
    (lambda: MixturePrior([uniform_prior()]), "component 0: uniform_prior(); accepted: a weight"),
    (lambda: MixturePrior(uniform_prior()), "components: uniform_prior(); accepted: pairs"),
    (lambda: MixturePrior([]), "no components"),
    (lambda: MixturePrior([("1/2", uniform_prior())]), "1 weights sum to 1/2"),
    (lambda: MixturePrior([(2, uniform_prior()), (-1, uniform_prior())]), "component 1: weight -1"),
    # densities
    (lambda: WrappedNormal("10", 0), "standard deviation 0; accepted: more than 0 and"),
    (lambda: WrappedNormal("10", "3600.1"), "at most 3600 degrees (beyond, the uniform"),
    (lambda: WrappedNormal("10", "-1/2"), "standard deviation -1/2"),
    (lambda: VonMises("10", "-0.1"), "kappa -1/10; accepted: 0 to 1000000000"),
    (lambda: VonMises("10", "1e100"), "accepted: 0 to 1000000000 (beyond, a normal"),
]


@pytest.mark.parametrize(("make", "message"), PRIOR_ERRORS, ids=[m for _, m in PRIOR_ERRORS])
def test_what_is_no_distribution(make, message):
    with pytest.raises(PriorError) as caught:
        make()
    assert message in str(caught.value)
    assert "accepted" in str(caught.value)
    assert isinstance(caught.value, InputError)


@pytest.mark.parametrize(
    "make",
    [
        lambda: DiscretePrior({0.5: 1}),
        lambda: DiscretePrior({"0": 1.0}),
        lambda: DiscretePrior.from_counts({"0": 1.0}),
        lambda: DiscretePrior.from_measurements([12.5]),
        lambda: PiecewisePrior([(HALF, 2.0)]),
        lambda: PiecewisePrior.from_masses([(HALF, 1.0)]),
        lambda: PiecewisePrior.from_histogram([0.0, 90.0], [1]),
        lambda: PiecewisePrior.from_histogram(["0", "90"], [1.0]),
        lambda: MixturePrior([(1.0, uniform_prior())]),
        lambda: WrappedNormal(10.0, "5"),
        lambda: WrappedNormal("10", 5.0),
        lambda: VonMises("10", 2.0),
        lambda: VonMises(10.0, "2"),
    ],
)
def test_floats_are_refused(make):
    with pytest.raises(FloatRefusedError, match="is a binary float"):
        make()


@pytest.mark.parametrize(
    "make",
    [
        lambda: DiscretePrior({"north": 1}),
        lambda: DiscretePrior({"0": "nan"}),
        lambda: WrappedNormal("10", "inf"),
        lambda: VonMises("10", None),
        lambda: PiecewisePrior.from_histogram(["0", "x"], [1]),
    ],
)
def test_what_is_no_number(make):
    with pytest.raises(NumberError, match="accepted"):
        make()


def test_a_component_that_is_no_prior():
    with pytest.raises(InputError, match="component 1: 'uniform'; accepted: priors"):
        MixturePrior([("1/2", uniform_prior()), ("1/2", "uniform")])


@pytest.mark.parametrize("prior", ["normal:30,12", {"0": 1}, WrappedNormal, lambda _: 1])
@pytest.mark.parametrize("plan", [plan_feeding, orient_up_to_symmetry])
def test_planning_with_what_is_no_prior(plan, prior):
    with pytest.raises(PriorError, match="is no prior; accepted: one, such as WrappedNormal"):
        plan([(0, 0), (3, 0), (3, 2), (0, 2)], prior=prior)


@pytest.mark.parametrize(
    "prior",
    [
        DiscretePrior({"0": 1}),
        PiecewisePrior([(HALF, 2)]),
        MixturePrior([("1/2", DiscretePrior({"0": 1})), ("1/2", uniform_prior())]),
        uniform_prior(),
        WrappedNormal("0", "5"),
        VonMises("0", 2),
        VonMises("0", 0),
    ],
    ids=lambda prior: prior.describe(),
)
@pytest.mark.parametrize("width", [ZERO, Angle(-1), FULL_TURN + Angle(0, (10**9, 1))])
def test_widths_outside_the_circle(prior, width):
    with pytest.raises(InvalidArcError):
        prior.best_window(width)


def test_text_of_absurd_size_is_refused():
    with pytest.raises(StochgeomError):
        WrappedNormal("10", "1e999999")
    assert DiscretePrior({"1e-300": mpq(1)}).best_window(HALF_TURN).mass.rational == 1
