"""Randomised minimax rules: the game between the decider and nature (thesis app. A).

A randomised rule draws a rule with certain probabilities; its risk is the mean. The least of the
largest risks is the value of a matrix game, whose other side is nature's least favourable prior:

    max over priors of min over rules of r(pi, delta) = min over mixtures of max over states of R

Linear programming finds both sides in floats (scipy, the extra `numeric`). Floats decide nothing
here: they only say which rules are mixed and which states the prior gives weight to; the two
systems of equations for these are solved exactly, and if the mixture's largest risk equals the
least Bayes risk under the prior, both are optimal, which is the proof. If that fails, the two
numbers, computed exactly for rounded mixtures, enclose the value.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, final

import flint
from gmpy2 import mpq

from stochgeom.decision.number_kinds import NumberKind
from stochgeom.errors import MissingExtraError
from stochgeom.exact.scalars import from_float_exact

if TYPE_CHECKING:
    from stochgeom.decision.decision_rules import DecisionProblem, Rule

_SUPPORT: Final = 1e-9
"""Probabilities below it are taken for none when the equations are set up."""


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
        return _enclosure(rules, risks, weights, prior)
    exact = _exact_solution(rules, risks, weights, prior)
    if exact is not None and exact.proven:
        return exact
    return _enclosure(rules, risks, _rounded(weights), _rounded(prior))


def _float_solution(risks: Sequence[Sequence[Any]]) -> tuple[list[float], list[float]]:
    """Return the mixture and the prior: minimise v with sum w R(theta) <= v, sum w = 1."""
    try:
        from scipy.optimize import linprog
    except ImportError as error:
        raise MissingExtraError(
            "randomised rules need scipy; install stochgeom[numeric]"
        ) from error
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


def _exact_solution(
    rules: list[Rule], risks: list[Any], weights: list[float], prior: list[float]
) -> RandomisedRule | None:
    """Solve for the mixture and the prior on the supports that the floats show."""
    mixed = [k for k, weight in enumerate(weights) if weight > _SUPPORT]
    states = [s for s, share in enumerate(prior) if share > _SUPPORT]
    if len(mixed) != len(states):
        return None
    table = [[risks[k][s] for k in mixed] for s in states]
    mixture = _equalised(table)
    shares = _equalised([list(column) for column in zip(*table, strict=True)])
    if mixture is None or shares is None:
        return None
    full_mixture, full_prior = [mpq(0)] * len(rules), [mpq(0)] * len(prior)
    for k, value in zip(mixed, mixture, strict=True):
        full_mixture[k] = value
    for s, value in zip(states, shares, strict=True):
        full_prior[s] = value
    if min(full_mixture) < 0 or min(full_prior) < 0:
        return None
    return _enclosure(rules, risks, full_mixture, full_prior)


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


def _rounded(weights: list[float]) -> list[mpq]:
    """Return exact probabilities near floats."""
    exact = [from_float_exact(max(weight, 0.0)) for weight in weights]
    total = sum(exact)
    return [value / total for value in exact]


def _enclosure(
    rules: list[Rule], risks: list[Any], weights: list[Any], prior: list[Any]
) -> RandomisedRule:
    low = min(sum(p * r for p, r in zip(prior, risk, strict=True)) for risk in risks)
    states = range(len(prior))
    high = max(sum(w * risk[s] for w, risk in zip(weights, risks, strict=True)) for s in states)
    mixture = {rule: weight for rule, weight in zip(rules, weights, strict=True) if weight}
    return RandomisedRule(mixture, tuple(prior), low, high)
