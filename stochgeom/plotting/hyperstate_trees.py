"""All open-loop plans of a problem as a tree of hyperstates (thesis Fig. 2.1).

The bars in a box are the probabilities of the states, in their order; a branch is an action. Every
way from the left to the right is a plan. Of a problem with a cost, the cost of each plan stands at
its end and the ways of the cheapest plans are heavy, all that tie.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import Any, Final

from stochgeom.arguments import expect
from stochgeom.decision.infinity import is_infinite
from stochgeom.decision.planning_problem import PlanningProblem, Vector
from stochgeom.errors import InputError, NodeLimitError
from stochgeom.exact.quotients import number_decimal
from stochgeom.plotting.graph import TEXT
from stochgeom.plotting.scene import XY, Label, Line, Scene, rectangle, shortened, text_width

MOST_PLANS: Final = 81
"""Trees of more plans are not drawn."""

_ROW: Final = 36.0
BOX: Final = 52.0
HALF: Final = 14.0
"""Width and half the height of the box of a hyperstate, in pixels like everything here."""

_LETTERS_OF_ACTION: Final = 18

_Word = tuple[int, ...]
"""The numbers of the actions on the way to a node."""


def open_loop_scene(problem: PlanningProblem, stages: int, digits: int = 4) -> Scene:
    """Return the tree of all plans of so many actions.

    Parameters
    ----------
    problem : PlanningProblem
        Its cost, if it has one, tells the best plans.
    stages : int
        The number of actions of each plan, 1 or more.
    digits : int
        Decimals of the costs.

    Raises
    ------
    InputError
        If the number of actions is none.
    NodeLimitError
        If there are more than `MOST_PLANS` plans.
    """
    problem = expect(problem, PlanningProblem, "a PlanningProblem")
    if type(stages) is not int or stages < 1:
        raise InputError(f"{stages!r:.60} stages; accepted: whole numbers from 1 on")
    numbers = range(len(problem.actions))
    if len(numbers) ** min(stages, MOST_PLANS) > MOST_PLANS:
        raise NodeLimitError(
            f"{len(numbers)} actions in {stages} stages make {len(numbers)}^{stages} plans; "
            f"accepted: at most {MOST_PLANS}"
        )
    plans = list(product(numbers, repeat=stages))
    costs, best = _costs(problem, plans)
    texts = [short_label(str(action)) for action in problem.actions]
    pitch = BOX + 40.0 + max(text_width(text, TEXT) for text in texts)
    scene = Scene()
    for depth in range(stages):
        for word in product(numbers, repeat=depth + 1):
            _add_branch(scene, word, len(numbers), stages, pitch, texts[word[-1]], best)
    for depth in range(stages + 1):
        for word in product(numbers, repeat=depth):
            y = _height(word, len(numbers), stages)
            hyperstate = problem.run(problem.actions[a] for a in word)
            add_hyperstate(scene, (depth * pitch, y), hyperstate)
    for word, cost in zip(plans, costs, strict=False):
        at = (stages * pitch + BOX + 8, _height(word, len(numbers), stages))
        text = "cost infinite" if is_infinite(cost) else f"cost {number_decimal(cost, digits)}"
        scene.add(Label(at, text, TEXT, "start", bold=word in best))
    return scene


def _costs(problem: PlanningProblem, plans: Sequence[_Word]) -> tuple[list[Any], set[_Word]]:
    """Return the costs of the plans, and the cheapest plans; nothing without a cost."""
    if problem.cost is None:
        return [], set()
    model = problem.cost.on(problem)
    costs = [model.of_plan(problem.actions[a] for a in word) for word in plans]
    least = min(costs)
    return costs, {word for word, cost in zip(plans, costs, strict=True) if cost == least}


def short_label(text: str) -> str:
    """Return what a branch has room for."""
    return shortened(text, _LETTERS_OF_ACTION)


def _height(word: _Word, actions: int, stages: int) -> float:
    """Return where a node stands: in the middle of the plans that begin like it."""
    first = 0
    for number in word:
        first = first * actions + number
    count: int = actions ** (stages - len(word))
    return -_ROW * (first * count + (count - 1) / 2)


def _add_branch(
    scene: Scene,
    word: _Word,
    actions: int,
    stages: int,
    pitch: float,
    text: str,
    best: set[_Word],
) -> None:
    start = ((len(word) - 1) * pitch + BOX, _height(word[:-1], actions, stages))
    y = _height(word, actions, stages)
    heavy = any(plan[: len(word)] == word for plan in best)
    way = (start, (start[0] + 20, y), (len(word) * pitch, y))
    scene.add(Line(way, "best" if heavy else "branch"))
    scene.add(Label((start[0] + 26, y + 0.7 * TEXT), text, TEXT, "start", bold=heavy))


def add_hyperstate(scene: Scene, at: XY, hyperstate: Vector, style: str = "act") -> None:
    """Draw a box with a bar for each state; ``at`` is the middle of its left side."""
    x, y = at
    scene.add(rectangle((x, y - HALF), (x + BOX, y + HALF), style))
    width = (BOX - 6) / len(hyperstate)
    for k, share in enumerate(map(float, hyperstate)):
        if share:
            left, low = x + 3 + k * width, y - HALF + 2
            top = low + share * (2 * HALF - 4)
            scene.add(rectangle((left, low), (left + 0.86 * width, top), "probable"))
