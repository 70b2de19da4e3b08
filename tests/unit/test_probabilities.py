"""Certified and estimated probabilities, and their comparison with each other and exact ones."""

from __future__ import annotations

import flint
import pytest
from gmpy2 import mpq

from stochgeom.decision.costs import CostOverProbability
from stochgeom.decision.density_priors import VonMises, WrappedNormal
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.probabilities import Enclosed, Estimated
from stochgeom.errors import InputError, PrecisionLimitError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.sums import AngleSum
from stochgeom.feeding.problem import FeedingProblem

ROOT = Enclosed.of(lambda: flint.arb(2).sqrt() / 2, "root")
ROOT_AGAIN = Enclosed.of(lambda: flint.arb(2).sqrt() / 2, "root")
OTHER_ROOT = Enclosed.of(lambda: 1 / flint.arb(2).sqrt())
THIRD = AngleSum("1/3")


class TestEnclosed:
    def test_worked_values(self):
        assert ROOT.decimal(10) == "0.7071067812"
        assert str(ROOT) == "0.7071"
        assert float(ROOT) == 0.7071067811865476
        assert (ROOT.exact, ROOT.rational) == (False, None)
        assert repr(ROOT) == "<Enclosed 0.707107>"

    def test_multiples_and_sums(self):
        assert ROOT.scaled("1/2").decimal(6) == "0.353553"
        assert (ROOT + THIRD).decimal(6) == "1.040440" == (THIRD + ROOT).decimal(6)
        assert (ROOT + OTHER_ROOT).decimal(6) == "1.414214"
        assert ROOT.scaled(0).decimal(2) == "0.00"
        assert (ROOT + ROOT.scaled(-1) + THIRD).decimal(2) == "0.33"

    def test_order(self):
        assert ROOT.compare("0.70710678118654752440084436210484903928") == 1
        assert ROOT.compare(THIRD) == 1 == -THIRD.compare(ROOT)
        assert ROOT.scaled("1/3").compare(ROOT.scaled("1/2")) == -1

    def test_equal_numbers_made_alike_are_equal(self):
        assert ROOT.compare(ROOT_AGAIN) == 0
        assert (ROOT + ROOT_AGAIN).compare(ROOT.scaled(2)) == 0
        assert (ROOT + THIRD).compare(THIRD + ROOT) == 0

    def test_equal_numbers_made_otherwise_are_not_told_apart(self):
        with pytest.raises(PrecisionLimitError, match="may be equal"):
            ROOT.compare(OTHER_ROOT)

    def test_no_sympy_form(self):
        with pytest.raises(InputError, match="no sympy form"):
            ROOT.to_sympy()

    def test_adds_no_strangers(self):
        with pytest.raises(TypeError):
            ROOT + 1


class TestEstimated:
    def test_only_certain_digits_are_shown(self):
        assert Estimated(0.123456, 1e-9).decimal(4) == "0.1235"
        assert Estimated(0.123456, 2e-5).decimal(6) == "0.123"
        assert Estimated(0.5, 1e-3).decimal(4) == "0.50"
        assert Estimated(0.96, 0.1).decimal(4) == "1"
        assert str(Estimated(0.25, 0.0)) == "0.2500"

    def test_order_within_the_errors(self):
        a, b = Estimated(0.5, 1e-6), Estimated(0.500001, 1e-6)
        assert a.compare(b) == 0 == b.compare(a)
        assert a.compare(Estimated(0.51, 1e-6)) == -1
        assert Estimated(0.51, 1e-6).compare(a) == 1
        assert a.compare(AngleSum("1/2")) == 0 == AngleSum("1/2").compare(a)
        assert a.compare("1/3") == 1
        assert a.compare(AngleSum("2/3")) == -1
        assert a.compare(ROOT) == -1
        assert ROOT.compare(a) == 1

    def test_sums_carry_the_errors(self):
        total = Estimated(0.25, 1e-6) + Estimated(0.5, 1e-7) + THIRD + ROOT
        assert abs(total.value - (0.75 + 1 / 3 + 2**-0.5)) < 1e-15
        assert 1.1e-6 <= total.error < 1.2e-6
        assert (THIRD + total).decimal(3) == "2.124"
        assert Estimated(0.5, 1e-6).scaled("-1/2") == Estimated(-0.25, 5e-7)

    def test_the_ball_is_the_interval(self):
        ball = Estimated(0.5, 0.25).ball()
        assert ball.contains(0.25)
        assert ball.contains(0.75)
        assert not ball.contains(0.76)

    @pytest.mark.parametrize(
        ("value", "error"),
        [(float("nan"), 0.0), (0.5, -1.0), (0.5, float("inf")), (0.5, float("nan"))],
    )
    def test_bad_numbers(self, value, error):
        with pytest.raises(InputError, match="accepted: finite"):
            Estimated(value, error)

    def test_no_sympy_form(self):
        with pytest.raises(InputError, match="no sympy form"):
            Estimated(0.5, 0.0).to_sympy()


@pytest.mark.parametrize(
    "number", [AngleSum("1/2"), AngleSum(0, [(1, Angle(0, (3, 2)))]), ROOT, Estimated(0.5, 1e-9)]
)
def test_all_kinds_answer_the_same_questions(number):
    assert isinstance(number.exact, bool)
    assert number.rational in {None, mpq(1, 2)}
    assert (
        number.ball().contains(float(number))
        or abs(float(number.ball().mid()) - float(number)) < 1e-15
    )
    assert number.decimal(2)[0] == "0"
    assert number.scaled(mpq(1, 2)).compare(number) == -1
    assert number.compare(number) == 0


# --- numbers of different kinds ------------------------------------------------------------------


PENTAGON = [(0, 0), (7, 0), (9, 3), (4, 8), (1, 6)]


@pytest.mark.parametrize(
    "prior",
    [
        DiscretePrior({"0": "1/2", "90": "1/2"}),
        PiecewisePrior.from_histogram(["0", "100", "300"], [1, 2]),
        WrappedNormal("0", "20"),
        VonMises("3", 2),
    ],
    ids=lambda prior: prior.kind,
)
def test_plans_for_different_priors_compare(prior):
    usual = FeedingProblem(PENTAGON).plan_of(2)
    aimed = FeedingProblem(PENTAGON, prior=prior).plan_of(2)
    assert aimed.expected_cost < usual.expected_cost
    assert usual.expected_cost > aimed.expected_cost
    assert not usual.expected_cost < aimed.expected_cost
    assert usual.expected_cost != aimed.expected_cost
    assert aimed.expected_cost.compare(usual.expected_cost) == -1
    assert usual.expected_cost.compare(aimed.expected_cost) == 1
    assert usual.probability.compare(aimed.probability) == -1
    assert aimed.probability.compare(usual.probability) == 1


def test_equal_costs_of_different_kinds_are_equal():
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    whole = PiecewisePrior([(Arc(ZERO, FULL_TURN), 1)])
    usual, aimed = (FeedingProblem(square, prior=p).plan_of(1) for p in (None, whole))
    slope = TurnRatio(mpq(3), Angle(0, (3, 2)), inverse=True)
    same = CostOverProbability(mpq(3), AngleSum(0, [(1, Angle(0, (3, 2)))]))
    for one, other in ((usual.expected_cost, aimed.expected_cost), (slope, same)):
        assert one == other
        assert other == one
        assert hash(one) == hash(other)
        assert not one < other
        assert one <= other
    assert usual.probability == aimed.probability
    assert (slope == 5, same == "5", same == aimed.probability) == (False, False, False)
    with pytest.raises(InputError, match="is no expected cost; accepted: one"):
        same.compare(usual.probability)
