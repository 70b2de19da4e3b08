"""A planned part in words and tables."""

from __future__ import annotations

from gmpy2 import mpq

from stochgeom.cli.layout import count, table
from stochgeom.cli.printed_ranges import error_text
from stochgeom.decision.costs import Number, expected_cost
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.decimals import Rounding, significant
from stochgeom.exact.scalars import rational_text
from stochgeom.feeding.actions import Action
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.feeding.stability import stabilities

MOST_ROWS = 40
"""Longer tables are cut in the middle; ``--json`` has every row."""


def plan_text(
    problem: FeedingProblem, optimal: FeedingPlan, geometric: FeedingPlan | None, digits: int
) -> str:
    """Return the whole report of ``stochgeom plan``.

    ``geometric`` is None if no plan orients the part up to symmetry with the gripper's error.
    """
    blocks = [_headline(problem, digits)]
    same = geometric is not None and optimal.steps == geometric.steps
    title = "Stochastically optimal plan"
    if same:
        title += f", also the shortest that {_orients(optimal)}"
    blocks.append(_plan_block(title, optimal, digits))
    if geometric is not None and not same:
        title = f"Shortest plan that {_orients(geometric)}"
        blocks.append(_plan_block(title, geometric, digits))
    blocks.append(_convention(optimal))
    blocks.append(error_text(problem, optimal, geometric, digits))
    blocks.append(_costs_block(problem, optimal, digits))
    blocks.append(_summary(optimal))
    if geometric is not None and not same:
        blocks.append(_summary(geometric))
    return "\n\n".join(blocks)


def _orients(plan: FeedingPlan) -> str:
    how = "uniquely" if plan.transfer.order == 1 else "up to symmetry"
    return f"orients the part {how}"


def _convention(plan: FeedingPlan) -> str:
    lines = [
        "Angles are degrees counter-clockwise, each relative to the gripper's last pose; ranges",
        "are rounded inwards, so they work as printed.",
    ]
    if plan.transfer.order > 1:
        lines[1] += " Up to symmetry means: of the"
        lines.append(f"{plan.action_name} function, which cannot tell those orientations apart.")
    return "\n".join(lines)


def _headline(problem: FeedingProblem, digits: int) -> str:
    part, transfer = problem.part, problem.transfer
    lines = []
    if part is not None:
        name = part.name or "part"
        lines.append(f"{name}: {len(part)} vertices, {len(part.hull)} on the convex hull")
    states = len(transfer) * transfer.order
    kind = "stable" if problem.action == "squeeze" else "final"
    lines.append(
        f"{problem.action} function: {count(len(transfer), 'step')} in a period of "
        f"{transfer.period.degrees(digits)} degrees, "
        f"{states} {kind} orientations in a full turn"
    )
    if part is not None and part.has_given_center and part.center_of_mass_side < 0:
        lines.append("the centre of mass lies outside the hull; squeezing does not depend on it")
    if part is not None and part.holes:
        lines.append(
            f"{count(len(part.holes), 'hole')}: jaws touch the convex hull only, so holes just "
            "shift the uniform centroid"
        )
    if problem.prior is not None:
        lines.append(f"prior: {problem.prior.describe()}")
    if problem.goal is not None:
        finals = [transfer.values[k] % transfer.period for k in problem.final_steps or ()]
        angles = ", ".join(angle.degrees(digits) for angle in finals)
        line = f"goal: {_goal_words(problem)}, the final orientation at {angles} degrees"
        if part is not None:
            psi = ", ".join(_rounded_down(p, digits) for p in stabilities(part, finals))
            line += f"; it bears a disturbance below {psi} degrees"
        lines.append(line)
    return "\n".join(lines)


def _rounded_down(angle: Angle, digits: int) -> str:
    """Return degrees, rounded down, 0 only if they are."""

    def printed(places: int) -> str:
        return angle.degrees(places, Rounding.DOWN)

    return significant(printed, digits) if angle else printed(digits)


def _goal_words(problem: FeedingProblem) -> str:
    goal = problem.goal
    return f"{goal.degrees(4)} degrees" if isinstance(goal, Angle) else str(goal)


def _plan_block(title: str, plan: FeedingPlan, digits: int) -> str:
    steps = _shown_steps(plan.steps)
    rows: dict[int | None, list[str]] = {None: ["...", "", "", "", ""]}
    for step, (action, outcome) in enumerate(
        zip(plan.actions, plan.outcomes(), strict=True), start=1
    ):
        if step in steps:
            rows[step] = [
                str(step),
                *_angle_and_range(plan, action, digits),
                str(outcome.possible),
                outcome.most_likely().decimal(digits),
            ]
    header = ["step", "rotate gripper by", "works for", "states left", "probability"]
    lines = [title, table(header, [rows[step] for step in steps])]
    if plan.prior is not None:
        lines.append(_caught(plan, digits))
    return "\n".join(lines)


def _caught(plan: FeedingPlan, digits: int) -> str:
    """Return where the mouth stands, which the first action aims at what the prior expects."""
    mouth = plan.mouth
    if mouth.width == FULL_TURN:
        return "  catches every orientation"
    _, low, high = plan.mouth_decimals(digits)
    sure = " for sure" if plan.gripper_error else ""
    return f"  catches{sure} what arrives from {low} to {high} degrees"


def _angle_and_range(plan: FeedingPlan, action: Action, digits: int) -> tuple[str, str]:
    """Return the angle of an action and what it works for, in words."""
    if action.low is None:
        if plan.prior is None:
            return "random", "any angle"
        return plan.mouth_decimals(digits)[0], "the prior"
    angle, low, high = action.decimals(digits)
    return angle, f"({low}, {high}]"


def _costs_block(problem: FeedingProblem, plan: FeedingPlan, digits: int) -> str:
    found = problem.preimages.found()
    rows = []
    for steps in _shown_steps(len(found), plan.steps):
        if steps is None:
            rows.append(["...", "", "", ""])
            continue
        width = found[steps - 1].width.degrees(digits)
        if problem.placement(steps) is None:
            rows.append([str(steps), width, "0", "none"])
            continue
        probability = problem.probability(steps).decimal(digits)
        cost = problem.expected_cost(steps, plan.cost_ratio).decimal(digits)
        rows.append([str(steps), width, probability, cost])
    column = max(len(row[3]) for row in rows)
    for row in rows:
        mark = " <- least" if row[0] == str(plan.steps) else ""
        row[3] = row[3].rjust(column) + mark
    header = ["steps", "collapsed arc", "probability", "expected cost"]
    times = "time" if plan.cost_ratio == 1 else "times"
    price = f"{rational_text(plan.cost_ratio)} {plan.action_name} {times}"
    title = f"Best plan of each length (a filter pass costs {price})"
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
    rounds = expected_cost(mpq(1), plan.probability)
    each = expected_cost(mpq(plan.steps), plan.probability)
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


def _amount(number: Number, noun: str) -> str:
    exact = number.rational
    if exact is not None and exact.denominator == 1:
        return count(int(exact), noun)
    plural = count(2, noun).removeprefix("2 ")
    return f"{number.decimal(2)} {plural}"


def _shown_steps(count: int, *also: int) -> list[int | None]:
    """Return 1 to `count`, or the first, the last and the ones in `also`, with None for gaps.

    Examples
    --------
    >>> [step for step in _shown_steps(100, 50) if step is None or 19 < step < 83]
    [20, None, 50, None, 81, 82]
    """
    half = MOST_ROWS // 2
    if count <= MOST_ROWS:
        return [*range(1, count + 1)]
    shown: list[int | None] = []
    last = 0
    for step in sorted({*range(1, half + 1), *also, *range(count - half + 1, count + 1)}):
        if step > last + 1:
            shown.append(None)
        shown.append(step)
        last = step
    return shown
