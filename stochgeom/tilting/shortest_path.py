"""The shortest-path heuristic for tilt plans (thesis 7.1.2).

Take for each pair of states the tilt that leads most probably from one to the other. The states and
these tilts are a graph; an edge of probability p has the length -log p, so that the shortest path
from start to goal is the one with the greatest product. The tilts along the path make a plan, and
the product is a lower bound on its probability: the tile may reach the goal off the path as well.
(The source says that this bound is minimised; it has to be maximised.)

Products are compared as rationals, without logarithms. Of equal products the path with fewer tilts
is taken, then the first in the order of the actions. The bound never takes `OTHER` for a station.

Time O(m n^2) for the edges, and O(n^2) for each tilt of the path: polynomial, where looking at all
plans of k tilts takes O(n^2 m^k).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from gmpy2 import mpq

from stochgeom.arguments import as_list, expect
from stochgeom.errors import InputError, NoPlanError
from stochgeom.tilting.estimation import TransitionModel
from stochgeom.tilting.tilt_plans import (
    TiltPlan,
    evaluate_tilt_plan,
    read_instance,
    usable_actions,
)

METHOD: Final = "shortest path"

Edge = tuple[mpq, int]


def likeliest_tilts(model: TransitionModel, actions: Sequence[int]) -> tuple[tuple[Edge, ...], ...]:
    """Return for each pair of states the highest probability of a tilt, and the tilt.

    Of equally probable tilts the first one.

    Examples
    --------
    >>> from stochgeom.tilting.counts import TransitionCounts
    >>> model = TransitionModel(TransitionCounts([[[1, 1], [0, 2]]]), alpha=1)
    >>> likeliest_tilts(model, [1])[0]
    ((mpq(1,2), 1), (mpq(1,2), 1))
    """
    expect(model, TransitionModel, "TransitionModel(counts)")
    n = model.counts.states
    actions = as_list(actions, "a list of tilts", "actions")
    if not actions:
        raise InputError("no tilts; accepted: at least one", where="actions")
    matrices = {action: model.matrix(action) for action in actions}
    return tuple(
        tuple(
            max(((matrices[a][i][j], a) for a in actions), key=lambda edge: (edge[0], -edge[1]))
            for j in range(n)
        )
        for i in range(n)
    )


def shortest_path_tilt_plan(
    model: TransitionModel,
    start: int,
    goal: int,
    most_tilts: int | None = None,
    *,
    observed_only: bool = False,
    edges: tuple[tuple[Edge, ...], ...] | None = None,
) -> TiltPlan:
    """Return the plan along the most probable path; its `bound` is the product of the path.

    Parameters
    ----------
    model, start, goal, observed_only
        As for `best_tilt_plan`.
    most_tilts : int, optional
        Longest path; by default any: a path visits no state twice, as that would not help.
    edges : optional
        What `likeliest_tilts` returned, when many instances are planned with one model.

    Raises
    ------
    NoPlanError
        If no path of positive probability is that short.

    Examples
    --------
    >>> from stochgeom.tilting.counts import TransitionCounts
    >>> one, two = [[0, 9, 0], [0, 9, 0], [0, 0, 9]], [[9, 0, 0], [0, 0, 9], [9, 0, 0]]
    >>> seen = TransitionCounts([one, two])
    >>> plan = shortest_path_tilt_plan(TransitionModel(seen), 1, 3)
    >>> plan, plan.bound < plan.probability
    (<TiltPlan 1 to 3: (1 2), probability 0.9956>, True)
    """
    expect(model, TransitionModel, "TransitionModel(counts)")
    n = model.counts.states
    horizon = n - 1 if most_tilts is None else most_tilts
    start, goal, horizon = read_instance(model, start, goal, horizon)
    if edges is None:
        edges = likeliest_tilts(model, usable_actions(model, observed_only=observed_only))
    # Invariant: reached[i] is the best path of at most so many tilts, as (-product, tilts, plan).
    reached: dict[int, tuple[mpq, int, tuple[int, ...]]] = {start - 1: (mpq(-1), 0, ())}
    for _ in range(min(horizon, n - 1)):
        further = dict(reached)
        for i, (product, tilts, plan) in reached.items():
            for j, (chance, action) in enumerate(edges[i]):
                path = (product * chance, tilts + 1, (*plan, action))
                if chance and (j not in further or path < further[j]):
                    further[j] = path
        if further == reached:
            break
        reached = further
    if goal - 1 not in reached:
        raise NoPlanError(f"no path of at most {horizon} tilts leads from {start} to {goal}")
    product, _, actions = reached[goal - 1]
    return evaluate_tilt_plan(model, start, goal, actions, METHOD, -product)
