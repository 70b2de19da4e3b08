"""The best of all plans up to a number of tilts, for one instance or for all (thesis 6.4).

An *instance* is a pair of different states, start and goal. For each start the hyperstates of all
plans are made level by level, as arrays of floats. A float may leave a plan out only if it cannot
be the best one:

- Every entry of a matrix is within 2 u of its rational value, u = 2^-53, and a tilt adds up n
  products of numbers from 0 on. So after k tilts a float probability is its exact value times
  (1 + e) with |e| at most about k (n + 3) u, whatever the order of the additions.
- What is within twice that of the largest float is computed again in rationals, and the best of it
  taken. Ties go to the fewest tilts, then to the first in the order of the actions.

Time O(n^2 m^k) for n states, m actions and k tilts for all goals of a start at once; the source
spent it for each pair.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from stochgeom.errors import InputError
from stochgeom.tilting.estimation import TransitionModel
from stochgeom.tilting.tilt_plans import (
    TiltPlan,
    evaluate_tilt_plan,
    read_instance,
    usable_actions,
)

METHOD: Final = "all plans"

MOST_PLANS: Final = 5_000_000
"""Most plans of one start: their hyperstates are held in memory."""

_ROUNDOFF: Final = 2.0**-53
_UNDERFLOW: Final = 1e-290

Floats = NDArray[np.float64]


def best_tilt_plan(
    model: TransitionModel,
    start: int,
    goal: int,
    most_tilts: int = 3,
    *,
    observed_only: bool = False,
) -> TiltPlan:
    """Return the plan of at most `most_tilts` tilts with the highest probability of success.

    Parameters
    ----------
    model : TransitionModel
        The control model; its means are used.
    start, goal : int
        States, from 1.
    most_tilts : int, default 3
        The horizon.
    observed_only : bool, default False
        Leave out actions that were never observed; otherwise the prior speaks for them.

    Raises
    ------
    RecordingError
        If a state does not exist.
    InputError
        If there are more than `MOST_PLANS` plans: `bounded_tilt_search` goes further.

    Examples
    --------
    >>> from stochgeom.tilting.counts import TransitionCounts
    >>> one, two = [[0, 9, 0], [0, 9, 0], [0, 0, 9]], [[9, 0, 0], [0, 0, 9], [9, 0, 0]]
    >>> seen = TransitionCounts([one, two])
    >>> best_tilt_plan(TransitionModel(seen), 1, 3)
    <TiltPlan 1 to 3: (1 2), probability 0.9956>
    """
    start, goal, most_tilts = read_instance(model, start, goal, most_tilts)
    actions = usable_actions(model, observed_only=observed_only)
    levels = plan_levels(model, start, actions, most_tilts)
    return _best_of(model, levels, actions, start, goal)


def best_tilt_plans(
    model: TransitionModel,
    most_tilts: int = 3,
    *,
    observed_only: bool = False,
    tell: Callable[[float], None] | None = None,
) -> dict[tuple[int, int], TiltPlan]:
    """Return the best plan of every instance; see `best_tilt_plan`.

    `tell` is called with the share of work done, for a progress bar.
    """
    _, _, most_tilts = read_instance(model, 1, 1, most_tilts)
    actions = usable_actions(model, observed_only=observed_only)
    states = range(1, model.counts.states + 1)
    found = {}
    for start in states:
        levels = plan_levels(model, start, actions, most_tilts)
        for goal in states:
            if goal != start:
                found[start, goal] = _best_of(model, levels, actions, start, goal)
        if tell is not None:
            tell(start / model.counts.states)
    return found


def plan_levels(
    model: TransitionModel, start: int, actions: Sequence[int], most_tilts: int
) -> list[Floats]:
    """Return for each number of tilts the hyperstates of all plans, a row for each plan.

    Row number r of level k is the plan whose tilts are the k digits of r in base m, the number of
    actions: plans in lexicographic order.
    """
    m = len(actions)
    if sum(m**k for k in range(most_tilts + 1)) > MOST_PLANS:
        raise InputError(
            f"{m} actions and {most_tilts} tilts make more than {MOST_PLANS} plans; accepted: "
            "fewer tilts, or the method branch-and-bound"
        )
    chosen = model.matrices[[action - 1 for action in actions]]
    first = np.zeros((1, chosen.shape[1]))
    first[0, start - 1] = 1.0
    levels = [first]
    for _ in range(most_tilts):
        after = np.einsum("pi,aij->paj", levels[-1], chosen, optimize=True)
        levels.append(after.reshape(-1, chosen.shape[1]))
    return levels


def error_factor(tilts: int, outcomes: int) -> float:
    """Return a bound on the relative error of a float probability after so many tilts."""
    return 2 * tilts * (outcomes + 3) * _ROUNDOFF


def promising_rows(
    model: TransitionModel,
    levels: Sequence[Floats],
    goal: int,
    allowed: Sequence[Sequence[bool]] | None = None,
) -> list[tuple[int, int]]:
    """Return (tilts, row) of every plan that may be the best one, or of those that are allowed."""
    columns = [level[:, goal - 1] for level in levels]
    if allowed is not None:
        columns = [
            np.where(use, column, -1.0) for use, column in zip(allowed, columns, strict=True)
        ]
    top = max(float(column.max()) for column in columns)
    error = error_factor(len(levels) - 1, len(model.counts.outcomes))
    least = top * (1 - 2 * error) - _UNDERFLOW
    return [
        (tilts, int(row))
        for tilts, column in enumerate(columns)
        for row in np.flatnonzero(column >= least)
    ]


def _best_of(
    model: TransitionModel, levels: list[Floats], actions: Sequence[int], start: int, goal: int
) -> TiltPlan:
    return first_best(
        evaluate_tilt_plan(model, start, goal, plan_of(row, tilts, actions), METHOD)
        for tilts, row in promising_rows(model, levels, goal)
    )


def plan_of(row: int, tilts: int, actions: Sequence[int]) -> tuple[int, ...]:
    """Return the plan that stands in a row of a level.

    Examples
    --------
    >>> plan_of(5, 3, (1, 2))
    (2, 1, 2)
    """
    digits = []
    for _ in range(tilts):
        row, digit = divmod(row, len(actions))
        digits.append(actions[digit])
    return tuple(reversed(digits))


def first_best(plans: Iterable[TiltPlan]) -> TiltPlan:
    """Return the most probable plan; of equal ones the shortest, then the first in order."""
    return min(plans, key=lambda plan: (-plan.probability, plan.steps, plan.actions))
