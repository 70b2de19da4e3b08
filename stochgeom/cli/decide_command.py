"""``stochgeom decide``: the best plan of a planning problem."""

from __future__ import annotations

import argparse
import re
from typing import TYPE_CHECKING, Any

from stochgeom.cli.options import add_digits, read_digits
from stochgeom.cli.output import write, write_json
from stochgeom.cli.progress import Progress
from stochgeom.decision.plan_results import METHODS, NODE_LIMIT
from stochgeom.errors import FormatError, InputError
from stochgeom.exact.scalars import parse_rational

if TYPE_CHECKING:
    from stochgeom.decision.planning_problem import PlanningProblem

_EPILOG = """\
PROBLEM.json holds states, a prior, actions, a stochastic matrix for each, and a cost:

  {"states": ["heads", "tails"], "prior": [1, 0], "actions": ["turn", "throw"],
   "transitions": {"turn": [[0, 1], [1, 0]],
                   "throw": [["1/2", "1/2"], [0.5, 0.5]]},
   "cost": {"kind": "goal", "goal": ["tails"], "actions": {"turn": "1/10"}}}

It may hold sensors, "sensors": {"eye": {"readings": [...], "likelihood": {STATE: [...]},
"cost": C}}; then the plan is a tree, and the cost is additive, goal or iterative.

Numbers are exact: 0.5 is one half. With "numbers": "float" they are floats. Kinds of cost:
additive, minimax, goal, guaranteed, iterative, entropy, variance, distance.

examples:

  stochgeom decide coin.json --horizon 3
  stochgeom decide coin.json --horizon 3 --all --json
  stochgeom decide walk.json --horizon 20 --time-limit 10
"""


_HELP = "stochgeom decide --help"


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "decide",
        help="find the best plan of a planning problem",
        description="Print the plan of least cost among those of at most so many actions. Exit "
        "code 1 if every plan has infinite cost: no plan is certain to succeed.",
        epilog=_EPILOG,
    )
    parser.add_argument("file", metavar="PROBLEM.json", help="the problem")
    parser.add_argument(
        "--horizon", metavar="K", help="most actions of a plan; default any number, if priced"
    )
    parser.add_argument("--method", choices=METHODS, help="default: the one that fits")
    parser.add_argument("--all", action="store_true", help="print all optimal plans")
    parser.add_argument(
        "--allow-empty", action="store_true", help="the plan that does nothing counts as one"
    )
    parser.add_argument(
        "--threshold", metavar="COST", help="a plan that costs no more is good enough"
    )
    parser.add_argument(
        "--node-limit", metavar="N", default=str(NODE_LIMIT), help=f"default {NODE_LIMIT}"
    )
    parser.add_argument("--time-limit", metavar="SECONDS", help="default none")
    parser.add_argument(
        "--pomdp", metavar="FILE", help="also write the problem for Cassandra's POMDP solvers"
    )
    add_digits(parser)
    parser.add_argument("--json", action="store_true", help="print a stochgeom/decision/1 document")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Search, print, return the exit code."""
    # The searches are loaded here: other commands do not wait for them.
    from stochgeom.io.sensors_json import load_sensed_problem

    digits = read_digits(arguments.digits)
    horizon = None if arguments.horizon is None else _whole(arguments.horizon, "--horizon")
    node_limit = _whole(arguments.node_limit, "--node-limit")
    time_limit = _number(arguments.time_limit, "--time-limit", exact=False)
    problem, sensors = load_sensed_problem(arguments.file)
    if problem.cost is None:
        raise FormatError(
            f'missing; accepted: "cost": {{"kind": KIND, ...}}, see {_HELP}',
            where=f"{arguments.file}, key cost",
        )
    if sensors:
        from stochgeom.cli.decide_sensors import decide_with_sensors

        _refuse_for_trees(arguments)
        return decide_with_sensors(
            problem,
            sensors,
            horizon,
            digits=digits,
            as_json=arguments.json,
            node_limit=node_limit,
            time_limit=time_limit,
        )
    return _decide(arguments, problem, horizon, digits, node_limit, time_limit)


def _decide(
    arguments: argparse.Namespace,
    problem: PlanningProblem,
    horizon: int | None,
    digits: int,
    node_limit: int,
    time_limit: float | None,
) -> int:
    from stochgeom.cli.decide_text import result_document, result_text
    from stochgeom.decision.plan_search import find_plan
    from stochgeom.io.files import write_whole
    from stochgeom.io.pomdp_file import write_pomdp

    if arguments.pomdp is not None:
        write_whole(arguments.pomdp, write_pomdp(problem))
    with Progress("search: share of the limit") as progress:
        found = find_plan(
            problem,
            horizon,
            method=arguments.method,
            shortest=0 if arguments.allow_empty else 1,
            all_optimal=arguments.all,
            threshold=_number(arguments.threshold, "--threshold", exact=problem.exact),
            node_limit=node_limit,
            time_limit=time_limit,
            progress=progress.show,
        )
    if arguments.json:
        write_json(result_document(found, horizon, digits))
    else:
        write(result_text(found, horizon, digits))
    return 0 if found.feasible else 1


def _refuse_for_trees(arguments: argparse.Namespace) -> None:
    """Refuse options that a problem with sensors has no use for."""
    for option in ("method", "all", "allow_empty", "threshold", "pomdp"):
        if getattr(arguments, option):
            raise InputError(
                "not for problems with sensors; accepted: --horizon, --node-limit, --time-limit",
                where=f"--{option.replace('_', '-')}",
            )


def _number(text: str | None, where: str, *, exact: bool) -> Any:
    if text is None:
        return None
    from stochgeom.decision.number_kinds import as_float

    value = parse_rational(text, where=where)
    return value if exact else as_float(value, where)


def _whole(text: str, where: str) -> int:
    if re.fullmatch(r"[0-9]{1,9}", text) is None:
        raise InputError(f"{text[:60]!r}; accepted: a whole number from 0 on", where=where)
    return int(text)
