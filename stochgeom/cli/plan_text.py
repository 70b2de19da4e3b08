"""A planned part in words and tables."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from gmpy2 import mpq

from stochgeom.cli.layout import count, table
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.scalars import rational_text
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.feeding.plans import Action, FeedingPlan

_T = TypeVar("_T")

MOST_ROWS = 40
"""Longer tables are cut in the middle; ``--json`` has every row."""


def plan_text(
    problem: FeedingProblem, optimal: FeedingPlan, geometric: FeedingPlan, digits: int
) -> str:
    """Return the whole report of ``stochgeom plan``."""
    blocks = [_headline(problem, digits)]
    same = optimal.steps == geometric.steps
    title = "Stochastically optimal plan"
    if same:
        title += ", also the shortest that orients the part up to symmetry"
    blocks.append(_plan_block(title, optimal, digits))
    if not same:
        blocks.append(
            _plan_block("Shortest plan that orients the part up to symmetry", geometric, digits)
        )
    blocks.append(_costs_block(problem, optimal, digits))
    blocks.append(_summary(optimal))
    if not same:
        blocks.append(_summary(geometric))
    return "\n\n".join(blocks)


def _headline(problem: FeedingProblem, digits: int) -> str:
    part, transfer = problem.part, problem.transfer
    name = part.name or "part"
    lines = [
        f"{name}: {len(part)} vertices, {len(part.hull)} on the convex hull",
        (
            f"{problem.action} function: {count(len(transfer), 'step')} in a period of "
            f"{transfer.period.degrees(digits)} degrees, "
            f"{len(transfer) * transfer.order} stable orientations in a full turn"
        ),
    ]
    if part.holes:
        lines.append(
            f"{count(len(part.holes), 'hole')}: jaws touch the convex hull only, so holes just "
            "shift the uniform centroid"
        )
    return "\n".join(lines)


def _plan_block(title: str, plan: FeedingPlan, digits: int) -> str:
    shown = {step for step in _shown(range(1, plan.steps + 1)) if step is not None}
    rows = []
    for step, (action, outcome) in enumerate(
        zip(plan.actions, plan.outcomes(), strict=True), start=1
    ):
        if step not in shown:
            if step - 1 in shown:
                rows.append(["...", "", "", "", ""])
            continue
        rows.append(
            [
                str(step),
                "random" if action.low is None else action.angle.degrees(digits),
                _range_text(action, digits),
                str(len(outcome)),
                outcome.most_likely().decimal(digits),
            ]
        )
    header = ["step", "rotate gripper by", "works for", "states left", "probability"]
    return f"{title} (angles in degrees)\n" + table(header, rows)


def _range_text(action: Action, digits: int) -> str:
    if action.low is None or action.high is None:
        return "any angle"
    return f"({action.low.degrees(digits)}, {action.high.degrees(digits)}]"


def _costs_block(problem: FeedingProblem, plan: FeedingPlan, digits: int) -> str:
    rows = []
    for preimage in _shown(list(problem.preimages.found())):
        if preimage is None:
            rows.append(["...", "", "", ""])
            continue
        steps = preimage.steps
        cost = problem.expected_cost(steps, plan.cost_ratio).decimal(digits)
        best = " <- least" if steps == plan.steps else ""
        probability = problem.probability(steps).decimal(digits)
        rows.append([str(steps), preimage.width.degrees(digits), probability, cost + best])
    header = ["steps", "collapsed arc", "probability", "expected cost"]
    times = "time" if plan.cost_ratio == 1 else "times"
    price = f"{rational_text(plan.cost_ratio)} {plan.action_name} {times}"
    title = f"Best plan of each length (a filter pass costs {price})"
    width = max(len(row[3].removesuffix(" <- least")) for row in rows)
    for row in rows:
        number, mark, rest = row[3].partition(" <- ")
        row[3] = number.rjust(width) + mark + rest
    return f"{title}\n" + table(header, rows, left=[3])


def sentence(plan: FeedingPlan) -> str:
    """Return one line of plain words: what the plan does and what it costs.

    Examples
    --------
    >>> from stochgeom.feeding.planner import orient_up_to_symmetry
    >>> print(sentence(orient_up_to_symmetry([(0, 0), (3, 0), (3, 2), (0, 2)])))
    2 squeezes orient this part up to its 180 degree symmetry; expected cost 6.00 squeeze times: \
4 squeezes and 2 filter passes.
    """
    actions = count(plan.steps, plan.action_name)
    verb = "orients" if plan.steps == 1 else "orient"
    if plan.orients_up_to_symmetry:
        period = plan.transfer.period.degrees(4).rstrip("0").rstrip(".")
        if plan.transfer.order == 1:
            what = f"{actions} {verb} this part uniquely"
        else:
            what = f"{actions} {verb} this part up to its {period} degree symmetry"
    else:
        verb = "brings" if plan.steps == 1 else "bring"
        what = (
            f"{actions} {verb} this part into one orientation with probability "
            f"{plan.probability.decimal(4)}"
        )
    passes = "" if plan.cost_ratio == 1 else f" at {rational_text(plan.cost_ratio)} each"
    rounds = TurnRatio(mpq(1), plan.mouth.width, inverse=True)
    each = TurnRatio(mpq(plan.steps), plan.mouth.width, inverse=True)
    return (
        f"{what}; expected cost {plan.expected_cost.decimal(2)} {plan.action_name} times: "
        f"{_amount(each, plan.action_name)} and {_amount(rounds, 'filter pass')}{passes}."
    )


def _summary(plan: FeedingPlan) -> str:
    """Return the sentence, and a second one for who takes any of the equivalent orientations."""
    order = plan.transfer.order
    if order == 1:
        return sentence(plan)
    cost = plan.expected_cost_up_to_symmetry.decimal(2)
    which = "either of the 2" if order == 2 else f"any of the {order}"
    return (
        f"{sentence(plan)}\nIf the filter accepts {which} equivalent orientations: "
        f"{cost} {plan.action_name} times."
    )


def _amount(number: TurnRatio, noun: str) -> str:
    exact = number.rational
    if exact is not None and exact.denominator == 1:
        return count(int(exact), noun)
    plural = count(2, noun).removeprefix("2 ")
    return f"{number.decimal(2)} {plural}"


def _shown(rows: Sequence[_T]) -> list[_T | None]:
    """Return the rows, or the first and last ones with None between them."""
    if len(rows) <= MOST_ROWS:
        return list(rows)
    half = MOST_ROWS // 2
    return [*rows[:half], None, *rows[-half:]]
