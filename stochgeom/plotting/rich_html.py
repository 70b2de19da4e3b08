"""Plans and problems as short pieces of HTML: a picture and a table."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice
from typing import Final

from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.plotting.function_scenes import analysis_scene, function_behind
from stochgeom.plotting.funnel_scenes import funnel_scene
from stochgeom.plotting.scene import shown_degrees
from stochgeom.plotting.svg import svg_document, text_of
from stochgeom.plotting.trace_scenes import trace_scene

MOST_ROWS: Final = 12
"""Longer tables are cut in a notebook."""

_MOST_TRACED: Final = 5
_COLUMNS: Final = 4
MOST_PREIMAGES: Final = 40
"""A longer chain is not computed, or drawn, to its end."""


def plan_html(plan: FeedingPlan) -> str:
    """Return a plan's traces, or its funnel if it is long, over the table of its actions."""
    what = plan.counted_actions
    name = plan.part.name if plan.part is not None and plan.part.name else "plan"
    summary = (
        f"{name}: {what}, expected cost {plan.expected_cost.decimal(4)}, "
        f"probability {plan.probability.decimal(4)}"
    )
    rows = []
    for k, action in enumerate(plan.actions[:MOST_ROWS], 1):
        if action.low is None:
            free = "any" if plan.prior is None else shown_degrees(plan.mouth_decimals()[0])
            rows.append([str(k), free, "", ""])
        else:
            rows.append([str(k), *map(shown_degrees, action.decimals())])
    if plan.steps > MOST_ROWS:
        rows.append(["…", f"{plan.steps - MOST_ROWS} more", "", ""])
    header = ["action", "turn the gripper by", "works above", "up to"]
    return f"<p>{text_of(summary)}</p>\n{_plan_picture(plan, summary)}{table_html(header, rows)}"


def _plan_picture(plan: FeedingPlan, title: str) -> str:
    if plan.part is not None and plan.steps <= _MOST_TRACED:
        scene = trace_scene(plan, most=_COLUMNS)
        return svg_document(scene, title=title, scale=20.0) + "\n"
    if plan.steps <= MOST_ROWS:
        return svg_document(funnel_scene(plan), title=title, scale=1.0) + "\n"
    return ""


def problem_html(problem: FeedingProblem) -> str:
    """Return a problem's functions and preimages over a table of what each plan length catches."""
    name = problem.part.name if problem.part is not None and problem.part.name else "part"
    period = problem.transfer.period
    steps = counted(len(problem.transfer), "step")
    summary = f"{name}, {problem.action}: {steps} in a period of {period}"
    chain = list(islice(problem.preimages, MOST_PREIMAGES))
    wave = function_behind(problem.part, problem.action)
    scene = analysis_scene(problem.transfer, chain, wave, name=problem.action, width=460.0)
    rows = []
    for preimage in chain[:MOST_ROWS]:
        placed = problem.placement(preimage.steps)
        share = "none for sure" if placed is None else placed.probability.decimal(4)
        rows.append([str(preimage.steps), f"{preimage.width.degrees()}°", share])
    if len(chain) > MOST_ROWS:
        rows.append(["…", "and more", ""])
    header = ["actions", "width of the preimage", "probability"]
    picture = svg_document(scene, title=summary, scale=1.0)
    return f"<p>{text_of(summary)}</p>\n{picture}\n{table_html(header, rows)}"


def counted(count: int, what: str) -> str:
    """Return a number of things in words.

    Examples
    --------
    >>> counted(1, "step"), counted(2, "step")
    ('1 step', '2 steps')
    """
    return f"{count} {what}{'s' if count != 1 else ''}"


def table_html(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a table of text."""
    head = "".join(f'<th scope="col">{text_of(cell)}</th>' for cell in header)
    body = "\n".join(
        "<tr>" + "".join(f"<td>{text_of(cell)}</td>" for cell in row) + "</tr>" for row in rows
    )
    return f"<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody>\n</table>"
