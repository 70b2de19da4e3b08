"""``stochgeom report``: a plan as one page that shows it, explains it and carries its proof."""

from __future__ import annotations

import argparse
import re
from typing import Any

from gmpy2 import mpq

from stochgeom.cli.layout import count
from stochgeom.cli.options import add_digits, add_json, read_digits
from stochgeom.cli.output import write, write_json
from stochgeom.cli.plan_command import add_problem_options, make_problem, run_phase_one
from stochgeom.decision.costs import as_cost_ratio
from stochgeom.errors import InputError
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.io.embedded import CERTIFICATE, find_block
from stochgeom.io.files import write_whole

_EPILOG = """\
SOURCE and the options are those of `stochgeom plan`. The page is one file that asks for nothing
from outside and runs no script: the part, the plan at work, its tolerances, the distribution after
each action, and the certificate, which `stochgeom verify report.html` reads out.

examples:

  stochgeom report house --steps 2 -o house.html
  stochgeom report outline.txt --action push-grasp -o report.html
"""


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "report",
        help="write a plan as a page with pictures and an animation",
        description="Write the plan of least expected cost as one HTML page that needs no network.",
        epilog=_EPILOG,
    )
    add_problem_options(parser)
    parser.add_argument(
        "--steps",
        metavar="K",
        help="the plan of K actions instead of the one of least expected cost",
    )
    parser.add_argument(
        "-o", "--output", metavar="FILE", default="report.html", help="default report.html"
    )
    add_digits(parser)
    add_json(parser, "say as JSON what was written")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Plan, write the page, return the exit code."""
    from stochgeom.plotting.report import report_html

    digits = read_digits(arguments.digits)
    problem = make_problem(arguments)
    cost_ratio = as_cost_ratio(arguments.cost_ratio)  # refused before the work, if it is bad
    run_phase_one(problem)
    plan = _chosen(problem, arguments.steps, cost_ratio)
    page = report_html(plan, digits=digits)
    write_whole(arguments.output, page)
    size = len(page.encode())
    certified = find_block(page.encode(), CERTIFICATE) is not None
    if arguments.json:
        written = {"file": arguments.output, "bytes": size, "certificate": certified}
        write_json({"schema": "stochgeom/report/1", **written, "steps": plan.steps})
    else:
        proof = "with its certificate" if certified else "without a certificate"
        actions = count(plan.steps, plan.action_name)
        write(f"{arguments.output}: a plan of {actions}, {proof}, {size} bytes")
    return 0


def _chosen(problem: FeedingProblem, steps: str | None, cost_ratio: mpq) -> FeedingPlan:
    if steps is None:
        return problem.optimal_plan(cost_ratio)
    if re.fullmatch(r"[0-9]{1,9}", steps) is None:
        raise InputError(f"{steps[:60]!r} steps; accepted: whole numbers from 1", where="--steps")
    try:
        return problem.plan_of(int(steps), cost_ratio)
    except InputError as error:
        raise InputError(error.message, where="--steps") from None
