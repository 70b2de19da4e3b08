"""Open-loop tilt plans and what a model says of them (thesis 6.4)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias, final

from gmpy2 import mpq

from stochgeom.arguments import as_count, as_list, expect
from stochgeom.errors import RecordingError
from stochgeom.exact.decimals import rational_decimal
from stochgeom.tilting.counts import numbered
from stochgeom.tilting.estimation import TransitionModel

Distribution: TypeAlias = tuple[mpq, ...]


@final
@dataclass(frozen=True, slots=True)
class TiltPlan:
    """A sequence of tilts that should take the tile from one state to another.

    Attributes
    ----------
    start, goal : int
        States, from 1.
    actions : tuple of int
        The tilts, from 1; empty if the tile is there already.
    probability : mpq
        Of ending in the goal, by the means of the model.
    method : str
        How the plan was found.
    bound : mpq or None
        A lower bound on the probability that the method found first.
    unobserved : tuple of (int, int)
        The pairs (action, state) that the plan may come to and nobody has tried: what the model
        says of them is its prior alone.
    """

    start: int
    goal: int
    actions: tuple[int, ...]
    probability: mpq
    method: str
    bound: mpq | None = None
    unobserved: tuple[tuple[int, int], ...] = ()

    @property
    def steps(self) -> int:
        """The number of tilts."""
        return len(self.actions)

    @property
    def cost(self) -> mpq:
        """The cost of the final hyperstate, -p(goal) (6.4): the number of tilts costs nothing."""
        return -self.probability

    def __repr__(self) -> str:
        return (
            f"<TiltPlan {self.start} to {self.goal}: ({' '.join(map(str, self.actions))}), "
            f"probability {rational_decimal(self.probability, 4)}>"
        )


def hyperstates(
    model: TransitionModel, start: int, actions: Sequence[int]
) -> tuple[Distribution, ...]:
    """Return the distributions over the outcomes before the first and after every tilt, exactly.

    What ended in another outcome stays there, as nobody tried an action from it; where such a tile
    finds its way back, plans do better than told.  O(tilts x states x outcomes).

    Examples
    --------
    >>> from stochgeom.tilting.counts import TransitionCounts
    >>> model = TransitionModel(TransitionCounts([[[1, 1], [0, 2]]]), alpha=1)
    >>> hyperstates(model, 1, (1, 1))[-1]
    (mpq(3,8), mpq(5,8))
    """
    first = numbered(start, model.counts.states, "start")
    width = len(model.counts.outcomes)
    found = [tuple(mpq(j == first - 1) for j in range(width))]
    for action in actions:
        found.append(_after(model, found[-1], action))
    return tuple(found)


def _after(model: TransitionModel, before: Distribution, action: int) -> Distribution:
    n = model.counts.states
    after = [mpq(0)] * n + list(before[n:])
    for state, weight in enumerate(before[:n], start=1):
        if weight:
            for j, entry in enumerate(model.row(action, state)):
                after[j] += weight * entry
    return tuple(after)


def evaluate_tilt_plan(
    model: TransitionModel,
    start: int,
    goal: int,
    actions: Sequence[int],
    method: str = "given",
    bound: mpq | None = None,
) -> TiltPlan:
    """Return a plan with its exact probability of ending in the goal.

    Raises
    ------
    RecordingError
        If a state or an action does not exist.

    Examples
    --------
    >>> from stochgeom.tilting.counts import TransitionCounts
    >>> model = TransitionModel(TransitionCounts([[[1, 1], [0, 2]]]), alpha=1)
    >>> evaluate_tilt_plan(model, 1, 2, (1, 1))
    <TiltPlan 1 to 2: (1 1), probability 0.6250>
    """
    expect(model, TransitionModel, "TransitionModel(counts)")
    end = numbered(goal, model.counts.states, "goal")
    listed = as_list(actions, "a list of tilts", "actions")
    tilts = tuple(numbered(a, model.counts.actions, "action") for a in listed)
    passed = hyperstates(model, start, tilts)
    untried = frozenset(model.undefined_rows)
    unobserved = dict.fromkeys(
        (action, state)
        for action, before in zip(tilts, passed, strict=False)
        for state in range(1, model.counts.states + 1)
        if before[state - 1] and (action, state) in untried
    )
    return TiltPlan(
        passed[0].index(1) + 1, end, tilts, passed[-1][end - 1], method, bound, tuple(unobserved)
    )


def read_instance(
    model: TransitionModel, start: int, goal: int, most_tilts: int
) -> tuple[int, int, int]:
    """Return the states and the number of tilts as int; refuse what is none."""
    expect(model, TransitionModel, "TransitionModel(counts)")
    first = numbered(start, model.counts.states, "start")
    last = numbered(goal, model.counts.states, "goal")
    return first, last, as_count(most_tilts, "tilts", least=0, where="most tilts")


def usable_actions(model: TransitionModel, *, observed_only: bool) -> tuple[int, ...]:
    """Return the actions to plan with: all, or those observed at least once.

    Raises
    ------
    RecordingError
        If none is left.
    """
    left_out = frozenset(model.unobserved_actions) if observed_only else frozenset()
    actions = tuple(a for a in range(1, model.counts.actions + 1) if a not in left_out)
    if not actions:
        raise RecordingError(
            "no action was ever observed; accepted: a recording of one trial or more, or planning "
            "with the prior alone"
        )
    return actions
