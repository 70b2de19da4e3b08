"""Planning problems in the file format of A. Cassandra's POMDP solvers.

The format knows costs of actions, not of the state that a plan ends in. So the cost C of the states
is written as differences: an action that leads from i to j costs its price plus C(j) - C(i). The
costs of a plan telescope: they add up to its cost here less the expected C of the prior, a constant
that a comment tells. A plan may end early: the action ``stop`` leads from every state to
``stopped``, where everything is free. There is one observation, which tells nothing: ``none``.

That holds for a finite horizon and the discount 1; with another discount a solver compares
something else.

Numbers are decimals in that format, so they are rounded to the nearest float. Labels that are no
words of the format (letters, digits, ``_`` and ``-``, beginning with a letter) become ``s0``,
``s1``, ... or ``a0``, ``a1``, ...; comments tell which is which.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, Final

from stochgeom.decision.additive_costs import AdditiveModel
from stochgeom.decision.infinity import is_infinite
from stochgeom.decision.plan_costs import PlanCost
from stochgeom.decision.plan_results import model_of
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.errors import ProblemError
from stochgeom.exact.scalars import RationalLike, rational

STOP, STOPPED, NONE = "stop", "stopped", "none"

_WORD: Final = re.compile(r"[A-Za-z][A-Za-z0-9_-]*\Z")
_KEYWORDS: Final = frozenset(
    {"discount", "values", "states", "actions", "observations", "start", "include", "exclude"}
    | {"T", "O", "R", "uniform", "identity", "reward", "cost", "reset"}
)


def write_pomdp(
    problem: PlanningProblem, cost: PlanCost | None = None, *, discount: RationalLike = 1
) -> str:
    """Return a problem as the text of a ``.POMDP`` file.

    Parameters
    ----------
    problem : PlanningProblem
        What is written.
    cost : PlanCost, optional
        An additive one, finite in every state; default: the problem's own.
    discount : rational in (0, 1], default 1
        Solvers for infinite horizons want less than 1.

    Raises
    ------
    ProblemError
        If the cost is not additive or not finite, or the discount is out of range.

    Examples
    --------
    >>> from stochgeom.decision.goal_costs import GoalCost
    >>> turn = PlanningProblem(["a", "b"], ["1/4", "3/4"], ["turn"], [[[0, 1], [1, 0]]])
    >>> print(write_pomdp(turn, GoalCost("a")))
    # cost of a plan: what a solver finds, plus 0.75
    discount: 1.0
    values: cost
    states: a b stopped
    actions: turn stop
    observations: none
    start: 0.25 0.75 0.0
    <BLANKLINE>
    T: turn
    0.0 1.0 0.0
    1.0 0.0 0.0
    0.0 0.0 1.0
    <BLANKLINE>
    T: stop
    0.0 0.0 1.0
    0.0 0.0 1.0
    0.0 0.0 1.0
    <BLANKLINE>
    O: * : * : none 1.0
    <BLANKLINE>
    R: * : * : * : * 0.0
    R: turn : a : b : * 1.0
    R: turn : b : a : * -1.0
    <BLANKLINE>
    """
    model = model_of(problem, cost)
    if not isinstance(model, AdditiveModel) or any(map(is_infinite, model.state_costs)):
        raise ProblemError("the cost is not additive or not finite; accepted: one that is both")
    factor = rational(discount, where="discount")
    if not 0 < factor <= 1:
        raise ProblemError(f"discount {factor}; accepted: more than 0, at most 1")
    states, state_notes = _words(problem.states, "s", STOPPED)
    actions, action_notes = _words(problem.actions, "a", STOP)
    lines = [
        f"# cost of a plan: what a solver finds, plus {float(model.of_plan([]))!r}",
        *state_notes,
        *action_notes,
        f"discount: {float(factor)!r}",
        "values: cost",
        f"states: {' '.join([*states, STOPPED])}",
        f"actions: {' '.join([*actions, STOP])}",
        f"observations: {NONE}",
        f"start: {_row([*problem.prior, 0])}",
    ]
    end = [0] * len(states)
    for word, action in zip(actions, problem.actions, strict=True):
        rows = [_row([*row, 0]) for row in problem.matrix(action)]
        lines += ["", f"T: {word}", *rows, _row([*end, 1])]
    lines += ["", f"T: {STOP}", *[_row([*end, 1])] * (len(states) + 1)]
    lines += ["", f"O: * : * : {NONE} 1.0", "", "R: * : * : * : * 0.0"]
    for number, (word, price) in enumerate(zip(actions, model.prices, strict=True)):
        for i, state in enumerate(states):
            for j, _ in problem.successors(number, i):
                value = float(price + model.state_costs[j] - model.state_costs[i])
                lines.append(f"R: {word} : {state} : {states[j]} : * {value!r}")
    return "\n".join(lines) + "\n"


def _row(values: Sequence[Any]) -> str:
    return " ".join(repr(float(value)) for value in values)


def _words(labels: Sequence[Any], letter: str, taken: str) -> tuple[list[str], list[str]]:
    """Return a word for each label, and comments if they are not the labels."""
    texts = [str(label) for label in labels]
    fit = all(_WORD.match(text) and text not in {*_KEYWORDS, taken} for text in texts)
    if fit and len(set(texts)) == len(texts):
        return texts, []
    words = [f"{letter}{k}" for k in range(len(texts))]
    notes = [
        f"# {word}: {' '.join(text.split())[:60]}" for word, text in zip(words, texts, strict=True)
    ]
    return words, notes
