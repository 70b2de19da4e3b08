"""Randomised minimax rules: the game between the decider and nature (thesis app. A).

A randomised rule draws a rule with certain probabilities; its risk is the mean. The least of the
largest risks is the value of a matrix game, whose other side is nature's least favourable prior:

    max over priors of min over rules of r(pi, delta) = min over mixtures of max over states of R

Linear programming finds both sides in floats (scipy, the extra `numeric`). Floats decide nothing
here: they only propose. They say which rules are mixed and which states the prior gives weight to,
and the equations for these are solved exactly; and they are rounded to fractions. Of all mixtures
and priors proposed the best are taken, judged in exact numbers. If the mixture's largest risk
equals the least Bayes risk under the prior, both are optimal, which is the proof; otherwise the two
numbers enclose the value.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Final, final

import flint
from gmpy2 import mpq

from stochgeom.decision.number_kinds import NumberKind
from stochgeom.errors import MissingExtraError

if TYPE_CHECKING:
    from stochgeom.decision.decision_rules import DecisionProblem, Rule

_SUPPORT: Final = 1e-9
"""Probabilities below it are taken for none when the equations are set up."""

_SCALES: Final = (10, 1000, 10**6, 10**15)
"""Largest denominators of the rounded probabilities that are tried as well."""


@final
@dataclass(frozen=True)
class RandomisedRule:
    """A minimax mixture of rules, and nature's answer.

    Attributes
    ----------
    mixture : dict from rules to numbers
        The probabilities of the rules that are mixed.
    prior : tuple of numbers
        A least favourable prior.
    low, high : numbers
        The value of the game is between them: the least Bayes risk under `prior`, and the largest
        risk of `mixture`.
    proven : bool
        Whether the two are one number, exactly.
    """

    mixture: dict[Rule, Any]
    prior: tuple[Any, ...]
    low: Any
    high: Any

    @property
    def proven(self) -> bool:
        """Whether mixture and prior are exactly optimal."""
        return bool(self.low == self.high)


def randomised_minimax(problem: DecisionProblem) -> RandomisedRule:
    """Return a randomised rule whose largest risk is the least.

    Raises
    ------
    MissingExtraError
        If scipy is not installed.

    Examples
    --------
    Heads or tails, to be guessed without any reading: the toss of a coin halves the worst loss.

    >>> from stochgeom.decision.decision_rules import DecisionProblem
    >>> guess = DecisionProblem(["h", "t"], ["none"], ["h", "t"], [[1], [1]], [[0, 1], [1, 0]])
    >>> guess.minimax_rules()[0], randomised_minimax(guess).high
    (mpq(1,1), mpq(1,2))
    """
    # Of rules of equal risk one is enough, and dominated ones are never needed.
    by_risk = {problem.risk_table[rule]: rule for rule in problem.admissible_rules()[::-1]}
    rules, risks = list(by_risk.values()), list(by_risk)
    weights, prior = _float_solution(risks)
    if problem.numbers is NumberKind.FLOAT:
        return _game(rules, risks, [weights], [prior])
    mixtures, priors = _solved(risks, weights, prior)
    for scale in _SCALES:
        mixtures.append(_rounded(weights, scale))
        priors.append(_rounded(prior, scale))
    return _game(rules, risks, mixtures, priors)


def _float_solution(risks: Sequence[Sequence[Any]]) -> tuple[list[float], list[float]]:
    """Return the mixture and the prior: minimise v with sum w R(theta) <= v, sum w = 1."""
    try:
        from scipy.optimize import linprog
    except ImportError as error:
        raise MissingExtraError.of("randomised rules", "scipy", "numeric") from error
    states = range(len(risks[0]))
    table = [[float(risk[s]) for risk in risks] + [-1.0] for s in states]
    found = linprog(
        [0.0] * len(risks) + [1.0],
        A_ub=table,
        b_ub=[0.0] * len(states),
        A_eq=[[1.0] * len(risks) + [0.0]],
        b_eq=[1.0],
        bounds=[(0, None)] * len(risks) + [(None, None)],
        method="highs-ds",
    )
    return list(found.x[:-1]), [-float(value) for value in found.ineqlin.marginals]


def _solved(
    risks: list[Any], weights: list[float], prior: list[float]
) -> tuple[list[list[mpq]], list[list[mpq]]]:
    """Return the mixture and the prior that the supports of the floats determine, if they do."""
    mixed = [k for k, weight in enumerate(weights) if weight > _SUPPORT]
    states = [s for s, share in enumerate(prior) if share > _SUPPORT]
    if len(mixed) != len(states):
        return [], []
    table = [[risks[k][s] for k in mixed] for s in states]
    columns = [list(column) for column in zip(*table, strict=True)]
    return (
        _spread(_equalised(table), mixed, len(weights)),
        _spread(_equalised(columns), states, len(prior)),
    )


def _spread(values: list[mpq] | None, places: list[int], size: int) -> list[list[mpq]]:
    """Return probabilities at some places as a list of one vector; none if they are none."""
    if values is None or min(values) < 0:
        return []
    full = [mpq(0)] * size
    for place, value in zip(places, values, strict=True):
        full[place] = value
    return [full]


def _equalised(table: list[list[mpq]]) -> list[mpq] | None:
    """Return x of sum 1 with table x = (v, v, ...) for some v, None if that is not one x."""
    n = len(table)
    rows = [[*_fractions(row), flint.fmpq(-1)] for row in table]
    rows.append([flint.fmpq(1)] * n + [flint.fmpq(0)])
    right = flint.fmpq_mat(n + 1, 1, [flint.fmpq(0)] * n + [flint.fmpq(1)])
    try:
        found = flint.fmpq_mat(rows).solve(right)
    except ZeroDivisionError:  # singular
        return None
    return [mpq(int(found[i, 0].p), int(found[i, 0].q)) for i in range(n)]


def _fractions(row: list[mpq]) -> list[Any]:
    return [flint.fmpq(int(value.numerator), int(value.denominator)) for value in row]


def _rounded(weights: list[float], scale: int) -> list[mpq]:
    """Return exact probabilities near floats, with small denominators if the scale is small."""
    exact = [mpq(Fraction(max(weight, 0.0)).limit_denominator(scale)) for weight in weights]
    total = sum(exact)
    return [value / total for value in exact] if total else [mpq(1, len(exact))] * len(exact)


def _game(
    rules: list[Rule], risks: list[Any], mixtures: list[list[Any]], priors: list[list[Any]]
) -> RandomisedRule:
    """Return the best of some mixtures and the best of some priors: either is judged by itself."""

    def largest_risk(weights: list[Any]) -> Any:
        columns = zip(*risks, strict=True)
        return max(sum(w * r for w, r in zip(weights, column, strict=True)) for column in columns)

    def least_bayes_risk(prior: list[Any]) -> Any:
        return min(sum(p * r for p, r in zip(prior, risk, strict=True)) for risk in risks)

    weights = min(mixtures, key=largest_risk)
    prior = max(priors, key=least_bayes_risk)
    mixture = {rule: weight for rule, weight in zip(rules, weights, strict=True) if weight}
    return RandomisedRule(mixture, tuple(prior), least_bayes_risk(prior), largest_risk(weights))
