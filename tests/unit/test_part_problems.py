"""A part as a planning problem: its matrices are what the transfer function does."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from stochgeom.decision.density_priors import WrappedNormal
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.errors import InputError, ProblemError
from stochgeom.exact.angles import EIGHTH_TURN, FULL_TURN, QUARTER_TURN, Angle
from stochgeom.exact.sums import AngleSum
from stochgeom.feeding.planning_problems import planning_problem_of, planning_problem_of_transfer
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from stochgeom.transfer.step_function import StepFunction

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


@pytest.mark.parametrize("all_periods", [False, True])
@pytest.mark.parametrize("action", ["squeeze", "push-grasp"])
@pytest.mark.parametrize("name", catalogue_names())
def test_every_action_does_what_the_transfer_function_does(name, action, all_periods):
    part = catalogue_part(name)
    found = planning_problem_of(part, action, all_periods=all_periods)
    for label in found.problem.actions:
        alpha = found.angle(label)
        for state, theta in found.orientations.items():
            end = found.transfer(theta - alpha) % FULL_TURN
            row = found.problem.matrix(label)[found.problem.state_number(state)]
            assert found.orientations[found.problem.states[row.index(1)]] == end


def test_the_prior_is_the_widths_of_the_steps():
    found = planning_problem_of(catalogue_part("house"))
    assert sum(found.problem.prior, start=mpq(0)) == 1
    widths = {AngleSum(0, [(1, width)]) for width in found.transfer.widths}
    assert set(found.problem.prior) == widths
    assert found.problem.exact
    assert found.problem.deterministic


def test_a_rational_prior_is_rational():
    assert planning_problem_of(SQUARE).problem.prior == (mpq(1, 4),) * 4


def test_all_periods_tell_equivalent_orientations_apart():
    one, two = (planning_problem_of(RECTANGLE, all_periods=every) for every in (False, True))
    assert (len(one.problem.actions), len(two.problem.actions)) == (4, 8)
    assert two.problem.run(["180.0000"])[0] == two.problem.prior[2]


def test_labels_have_the_decimals_that_tell_them_apart():
    # The stable orientations are 0 and 90 degrees, and 90 less an angle of some 1e-6 degrees.
    s = StepFunction(
        [Angle(), Angle(0, (10**8, 10**8 - 1)), EIGHTH_TURN],
        [Angle(), Angle(0, (1, 10**8)), QUARTER_TURN],
    )
    labels = planning_problem_of_transfer(s).problem.states
    assert labels == ("0.00000000", "89.99999943", "90.00000000")


def test_a_discrete_prior_is_squeezed_first():
    found = planning_problem_of(RECTANGLE, prior=DiscretePrior({"10": "1/3", "80": "2/3"}))
    assert found.problem.prior == (mpq(1, 3), mpq(2, 3), mpq(0), mpq(0))


def test_priors_that_are_not_exact_are_refused():
    with pytest.raises(ProblemError, match="is not exact; accepted: uniform, discrete"):
        planning_problem_of(RECTANGLE, prior=WrappedNormal(mean="30", sd="12"))


def test_an_unknown_action_is_refused():
    with pytest.raises(InputError, match="'throw'; accepted: push-grasp, squeeze"):
        planning_problem_of(RECTANGLE, "throw")
