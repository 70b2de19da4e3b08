"""Decision rules: risks, and the rules that are best in one sense or another."""

from __future__ import annotations

import builtins
from itertools import product

import pytest
from gmpy2 import mpq
from hypothesis import given, settings

from stochgeom.decision.decision_rules import DecisionProblem
from stochgeom.decision.randomised_rules import randomised_minimax
from stochgeom.errors import (
    MissingExtraError,
    MixedNumbersError,
    NodeLimitError,
    NotStochasticError,
    ProblemError,
    ShapeMismatchError,
    UnknownLabelError,
)
from stochgeom.exact.angles import Angle
from tests.strategies import decision_problems

FEW = settings(max_examples=80)

# Good or bad part, test right nine times in ten.
PART = DecisionProblem(
    ["good", "bad"],
    ["pass", "fail"],
    ["keep", "throw"],
    [["9/10", "1/10"], ["1/10", "9/10"]],
    [[0, 1], [5, 0]],
)


def test_the_risk_table_by_hand():
    keep, throw = 0, 1
    assert PART.risk_table == {
        (keep, keep): (0, 5),
        (keep, throw): (mpq(1, 10), mpq(1, 2)),
        (throw, keep): (mpq(9, 10), mpq(9, 2)),
        (throw, throw): (1, 0),
    }


def test_the_best_rules_by_hand():
    assert PART.dominating_rules() == []
    assert PART.admissible_rules() == [(0, 0), (0, 1), (1, 1)]
    assert PART.minimax_rules() == (mpq(1, 2), [(0, 1)])
    assert PART.bayes_rules(["9/10", "1/10"]) == [(0, 1)]
    assert PART.bayes_rules(["999/1000", "1/1000"]) == [(0, 0)]
    assert PART.bayes_risk(["9/10", "1/10"], (0, 1)) == mpq(9, 100) + mpq(1, 20)
    # The posterior of "pass" is 81/82, of "fail" 1/2.
    assert PART.expected_loss(["81/82", "1/82"], "keep") == mpq(5, 82)


def test_minimax_differs_from_bayes_as_in_figure_a_1():
    # Rule 1 has the lower risk in most states, rule 2 the lower worst risk.
    rules = DecisionProblem(range(4), ["none"], [1, 2], [[1]] * 4, [[1, 3], [1, 3], [1, 3], [5, 4]])
    assert rules.minimax_rules() == (4, [(1,)])
    assert rules.bayes_rules(["1/4"] * 4) == [(0,)]
    assert rules.bayes_rules([0, 0, 0, 1]) == [(1,)]


def test_a_rule_that_dominates_all():
    better = DecisionProblem(["a", "b"], ["x"], ["good", "bad"], [[1], [1]], [[0, 1], [1, 1]])
    assert better.dominating_rules() == better.admissible_rules() == [(0,)]


def test_a_reading_that_cannot_occur_may_be_answered_anyhow():
    problem = DecisionProblem(["a"], ["x", "y"], [0, 1], [[1, 0]], [[0, 1]])
    assert problem.bayes_rules([1]) == [(0, 0), (0, 1)]


def test_a_loss_may_be_a_function():
    problem = DecisionProblem(
        range(3), ["none"], range(3), [[1]] * 3, lambda state, action: abs(state - action)
    )
    assert problem.loss == ((0, 1, 2), (1, 0, 1), (2, 1, 0))


def test_rules_by_labels():
    rule = PART.rule({"fail": "throw", "pass": "keep"})
    assert PART.answers(rule) == {"pass": "keep", "fail": "throw"}
    with pytest.raises(UnknownLabelError, match="'maybe' is no reading"):
        PART.rule({"maybe": "keep"})
    with pytest.raises(ShapeMismatchError, match="reading 'fail': no answer"):
        PART.rule({"pass": "keep"})


@FEW
@given(decision_problems())
def test_posterior_expected_loss_gives_the_bayes_rules(case):
    """Equivalence of A.3 and A.4: the same set of rules, one by the risk, one by posteriors."""
    problem, prior = case
    risks = {rule: problem.bayes_risk(prior, rule) for rule in problem.rules()}
    least = min(risks.values())
    assert set(problem.bayes_rules(prior)) == {r for r, risk in risks.items() if risk == least}


@FEW
@given(decision_problems())
def test_admissible_rules_are_those_that_none_dominates(case):
    problem, _ = case
    table = problem.risk_table
    kept = set(problem.admissible_rules())
    for rule, risk in table.items():
        dominated = any(
            other != risk and all(a <= b for a, b in zip(other, risk, strict=True))
            for other in table.values()
        )
        assert (rule in kept) != dominated
    classical = set(problem.dominating_rules())
    assert classical <= kept
    if classical:
        assert classical == kept


@FEW
@given(decision_problems())
def test_randomised_minimax(case):
    """The mixture's largest risk is the least Bayes risk under nature's prior, exactly."""
    problem, prior = case
    found = randomised_minimax(problem)
    assert sum(found.mixture.values()) == sum(found.prior) == 1
    assert min(found.mixture.values()) > 0
    assert found.proven
    assert found.high <= problem.minimax_rules()[0]
    assert found.low >= min(problem.bayes_risk(prior, rule) for rule in problem.rules())
    risks = [problem.risk(rule) for rule in found.mixture]
    mixed = [
        sum(w * risk[s] for w, risk in zip(found.mixture.values(), risks, strict=True))
        for s in range(len(problem.states))
    ]
    assert max(mixed) == found.high
    assert found.low == min(problem.bayes_risk(found.prior, rule) for rule in problem.rules())


def test_rock_paper_scissors():
    beats = [[0, -1, 1], [1, 0, -1], [-1, 1, 0]]
    game = DecisionProblem(list("rps"), ["none"], list("rps"), [[1]] * 3, beats)
    found = randomised_minimax(game)
    assert found.proven
    assert set(found.mixture.values()) == {mpq(1, 3)}
    assert found.high == 0


def test_floats_stay_floats():
    problem = DecisionProblem(
        ["a", "b"], ["x", "y"], [0, 1], [[0.75, 0.25], [0.25, 0.75]], [[0, 1], [1, 0]]
    )
    assert problem.risk((0, 1)) == (0.25, 0.25)
    assert isinstance(problem.bayes_risk([0.5, 0.5], (0, 1)), float)
    assert problem.bayes_rules([0.5, 0.5]) == [(0, 1)]
    assert isinstance(randomised_minimax(problem).high, float)


def test_bad_tables():
    with pytest.raises(NotStochasticError, match="likelihood, row 'a': the sum is 3/4"):
        DecisionProblem(["a"], ["x", "y"], [0], [["1/2", "1/4"]], [[0]])
    with pytest.raises(ShapeMismatchError, match="likelihood, row 'a': 1 probabilities"):
        DecisionProblem(["a"], ["x", "y"], [0], [[1]], [[0]])
    with pytest.raises(ShapeMismatchError, match="loss: 2 rows; accepted: 1"):
        DecisionProblem(["a"], ["x"], [0], [[1]], [[0], [0]])
    with pytest.raises(MixedNumbersError, match="loss, row 'a', entry 0: '1/3' is exact"):
        DecisionProblem(["a"], ["x", "y"], [0], [[0.5, 0.5]], [["1/3"]])
    with pytest.raises(ProblemError, match="angle sum"):
        DecisionProblem(["a"], ["x"], [0], [[1]], [[Angle(0, (3, 2))]])
    with pytest.raises(MixedNumbersError, match="prior, entry 0"):
        PART.bayes_rules([0.5, 0.5])


def test_too_many_rules():
    many = DecisionProblem(["a"], range(20), range(3), [[1] + [0] * 19], [[0, 1, 2]])
    with pytest.raises(NodeLimitError, match="3 actions for 20 readings make 3486784401 rules"):
        many.rules()
    assert many.bayes_actions([1])[0] == [0]  # needs no table


def test_without_scipy(monkeypatch):
    plain = builtins.__import__

    def without(name, *rest, **named):
        if name.startswith("scipy"):
            raise ImportError(name)
        return plain(name, *rest, **named)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(MissingExtraError, match=r"stochgeom\[numeric\]"):
        randomised_minimax(PART)


def test_every_mixture_is_at_least_the_value():
    found = randomised_minimax(PART)
    assert found.proven
    grid = [mpq(k, 12) for k in range(13)]
    for weights in product(grid, repeat=3):
        if sum(weights) == 1:
            mixed = zip(*(PART.risk(rule) for rule in PART.admissible_rules()), strict=True)
            worst = max(sum(w * r for w, r in zip(weights, row, strict=True)) for row in mixed)
            assert worst >= found.high
