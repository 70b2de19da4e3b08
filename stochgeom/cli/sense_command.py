"""``stochgeom sense``: plans that look at the distance between the jaws."""

from __future__ import annotations

import argparse
import re
from typing import Any

from stochgeom.cli.options import add_digits, read_digits
from stochgeom.cli.output import write, write_json
from stochgeom.cli.plan_command import read_part
from stochgeom.cli.progress import Progress
from stochgeom.errors import InputError
from stochgeom.io.files import write_whole
from stochgeom.io.priors import load_prior

_EPILOG = """\
A round is a squeeze at a random angle, then moves: squeezes at chosen angles, looks at the sensor;
then the filter accepts one orientation, which may depend on what was read. A part in any other one
falls back. Costs are in units of one squeeze.

examples:

  stochgeom sense 4gon --bits 2 --noise 0.05
  stochgeom sense house --horizon 3 --sensor-cost 1/4
  stochgeom sense outline.txt --bits 3 --sd 0.1 --range 10,25 --tree plan.svg
"""


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "sense",
        help="plan with a sensor of the distance between the jaws",
        description="Print what a jaw-diameter sensor tells about a part, and the plans of least "
        "expected cost that use it.",
        epilog=_EPILOG,
    )
    parser.add_argument("source", nargs="?", metavar="SOURCE", help="the part, as for plan")
    parser.add_argument("--vertices", metavar="LIST", help='the outline itself: "0,0 3,0 3,2"')
    parser.add_argument("--center-of-mass", metavar="X,Y", help="default: uniform centroid")
    parser.add_argument(
        "--bits", metavar="B", help="2^B readings; default: the exact distance is read"
    )
    parser.add_argument(
        "--noise",
        default="0",
        metavar="S",
        help="standard deviation of normal noise, as a share of the sensor's range; default 0",
    )
    parser.add_argument("--sd", metavar="LENGTH", help="the standard deviation as a length instead")
    parser.add_argument(
        "--range",
        metavar="LOW,HIGH",
        help="distances that the readings divide; default: those of the part",
    )
    parser.add_argument(
        "--horizon", default="2", metavar="N", help="most moves after the first squeeze; default 2"
    )
    parser.add_argument(
        "--cost-ratio", default="1", metavar="C", help="cost of the filter; default 1"
    )
    parser.add_argument("--sensor-cost", default="0", metavar="S", help="cost of a look; default 0")
    parser.add_argument("--prior", metavar="PRIOR", help="how parts arrive, as for plan")
    parser.add_argument(
        "--time-limit",
        default="60",
        metavar="SECONDS",
        help="for each plan; then the best one so far is shown, as not proven; default 60",
    )
    parser.add_argument(
        "--node-limit",
        default="1000000",
        metavar="N",
        help="most nodes of the tree of all plans; default 1000000",
    )
    parser.add_argument(
        "--tree", metavar="FILE", help="also write the plan as a drawing, .svg or .dot"
    )
    add_digits(parser)
    parser.add_argument("--json", action="store_true", help="print a stochgeom/sense/1 document")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Plan, print, return the exit code."""
    from stochgeom.cli.sense_text import sense_text
    from stochgeom.io.sensing_json import sensing_document
    from stochgeom.sensing.diameter_sensor import LIKELIHOOD_DIGITS
    from stochgeom.sensing.sensing_problem import SensingProblem

    digits = read_digits(arguments.digits)
    horizon = _whole(arguments.horizon, "--horizon")
    if arguments.tree is not None and not arguments.tree.endswith((".svg", ".dot")):
        raise InputError(f"{arguments.tree!r}; accepted: FILE.svg or FILE.dot", where="--tree")
    problem = SensingProblem(
        read_part(arguments),
        None if arguments.bits is None else _whole(arguments.bits, "--bits"),
        arguments.noise,
        sd=arguments.sd,
        between=_pair(arguments.range),
        cost_ratio=arguments.cost_ratio,
        sensor_cost=arguments.sensor_cost,
        prior=None if arguments.prior is None else load_prior(arguments.prior),
        digits=max(LIKELIHOOD_DIGITS, digits + 8),
    )
    limits: dict[str, Any] = {
        "time_limit": float(_whole(arguments.time_limit, "--time-limit")),
        "node_limit": _whole(arguments.node_limit, "--node-limit"),
    }
    orders = None
    with Progress("searching plans, first moves done") as progress:
        limits["progress"] = progress.show
        plan = problem.plan(horizon, **limits)
        if horizon:
            orders = problem.compare_orders(horizon - 1, mixed=plan, **limits)
            plan = orders.mixed
    if arguments.tree is not None:
        drawn = plan.tree.svg(digits) if arguments.tree.endswith(".svg") else plan.tree.dot(digits)
        write_whole(arguments.tree, drawn + "\n")
    if arguments.json:
        write_json(sensing_document(problem, plan, orders, digits))
    else:
        write(sense_text(problem, plan, orders, horizon, digits))
    return 0


def _whole(text: str, option: str) -> int:
    if re.fullmatch(r"[0-9]{1,9}", text) is None:
        raise InputError(f"{text[:60]!r}; accepted: whole numbers from 0 on", where=option)
    return int(text)


def _pair(text: str | None) -> tuple[str, str] | None:
    if text is None:
        return None
    parts = text.replace(",", " ").split()
    if len(parts) != 2:
        raise InputError(f"{text[:60]!r}; accepted: LOW,HIGH", where="--range")
    return parts[0], parts[1]
