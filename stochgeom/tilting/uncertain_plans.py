"""Planning when the transition probabilities themselves are uncertain.

The plug-in probability of a plan multiplies posterior means. What may be expected under the
posterior is the mean of the product. Rows of different tilts, or of different states, are
independent, and for them both are the same; a plan that comes to the same row twice multiplies an
uncertain number with itself or with a rival, and there they differ.

Along one path of states the mean of the product is that of an urn: each time a row is drawn from,
the outcome drawn gains one count (Polya). The expectation is the sum over the paths: exact, in
O(n^(k-1)) for n states and k tilts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from gmpy2 import mpq

from stochgeom.arguments import expect
from stochgeom.errors import InputError
from stochgeom.tilting.all_plans import first_best, plan_levels, plan_of, promising_rows
from stochgeom.tilting.counts import numbered
from stochgeom.tilting.estimation import Row, TransitionModel
from stochgeom.tilting.tilt_plans import (
    TiltPlan,
    evaluate_tilt_plan,
    read_instance,
    usable_actions,
)

METHOD: Final = "expected under the posterior"

MOST_REPEATING: Final = 20_000
"""Most plans with a repeated tilt that are compared: each is a sum over paths."""


def expected_probability(
    model: TransitionModel, start: int, goal: int, actions: Sequence[int]
) -> mpq:
    """Return the probability of success to be expected under the posterior, exactly.

    O(n^(k-1)) for n states and k tilts, O(k n^2) if no tilt is repeated.

    Examples
    --------
    Nothing observed, two states, one tilt: p is uniform, and two tilts from 1 succeed with
    probability E(p^2 + (1 - p) q), where q belongs to another row.

    >>> from stochgeom.tilting.counts import TransitionCounts
    >>> model = TransitionModel(TransitionCounts([[[0, 0], [0, 0]]]), alpha=1)
    >>> expected_probability(model, 1, 1, (1, 1))
    mpq(7,12)
    >>> evaluate_tilt_plan(model, 1, 1, (1, 1)).probability
    mpq(1,2)
    """
    expect(model, TransitionModel, "TransitionModel(counts)")
    first = numbered(start, model.counts.states, "start")
    last = numbered(goal, model.counts.states, "goal")
    tilts = tuple(numbered(action, model.counts.actions, "action") for action in actions)
    if len(set(tilts)) == len(tilts):
        return evaluate_tilt_plan(model, first, last, tilts).probability
    return _Urns(model, tilts, last - 1).expect(first - 1)


class _Urns:
    """The sum over the paths of one plan, each row an urn that its own past fills."""

    def __init__(self, model: TransitionModel, tilts: tuple[int, ...], goal: int) -> None:
        self._tilts, self._goal, self._states = tilts, goal, model.counts.states
        self._rows: dict[tuple[int, int], tuple[Row, mpq]] = {}
        for action in set(tilts):
            for state in range(self._states):
                row = model.parameters(action, state + 1)
                self._rows[action, state] = row, sum(row)
        self._drawn: dict[tuple[int, int], list[int]] = {}

    def expect(self, state: int, step: int = 0) -> mpq:
        """Return the expectation over the rest of the plan, given what was drawn before."""
        if step == len(self._tilts):
            return mpq(state == self._goal)
        key = self._tilts[step], state
        (row, total), drawn = self._rows[key], self._drawn.setdefault(key, [])
        last = step == len(self._tilts) - 1
        found = mpq(0)
        for outcome in (self._goal,) if last else range(self._states):
            weight = (row[outcome] + drawn.count(outcome)) / (total + len(drawn))
            drawn.append(outcome)
            found += weight * self.expect(outcome, step + 1)
            drawn.pop()
        return found


def best_expected_tilt_plan(
    model: TransitionModel,
    start: int,
    goal: int,
    most_tilts: int = 3,
    *,
    observed_only: bool = False,
) -> TiltPlan:
    """Return the plan whose success is to be expected most; its `bound` stays empty.

    Parameters
    ----------
    model, start, goal, most_tilts, observed_only
        As for `best_tilt_plan`. The plan's `probability` is the expected one.

    Raises
    ------
    InputError
        If more than `MOST_REPEATING` plans repeat a tilt.

    Notes
    -----
    Where no tilt is repeated the plug-in probability is the expected one, and plans are compared as
    in `best_tilt_plan`; the others are summed over their paths.
    """
    start, goal, most_tilts = read_instance(model, start, goal, most_tilts)
    usable = usable_actions(model, observed_only=observed_only)
    levels = plan_levels(model, start, usable, most_tilts)
    words = [
        [plan_of(row, tilts, usable) for row in range(len(level))]
        for tilts, level in enumerate(levels)
    ]
    repeating = [word for level in words for word in level if len(set(word)) < len(word)]
    if len(repeating) > MOST_REPEATING:
        raise InputError(
            f"{len(repeating)} plans repeat a tilt; accepted: at most {MOST_REPEATING}, so fewer "
            "tilts or actions"
        )
    once = [[len(set(word)) == len(word) for word in level] for level in words]
    promising = promising_rows(model, levels, goal, once)
    plans = [
        evaluate_tilt_plan(model, start, goal, words[tilts][row], METHOD)
        for tilts, row in promising
    ]
    for word in repeating:
        expected = expected_probability(model, start, goal, word)
        if all(expected >= plan.probability for plan in plans):
            plan = evaluate_tilt_plan(model, start, goal, word, METHOD)
            plans.append(replace(plan, probability=expected))
    return first_best(plans)
