"""``stochgeom grasp``: what parallel jaws with friction make of a part."""

from __future__ import annotations

import argparse
from typing import Any

from stochgeom.cli.grasp_text import grasp_text
from stochgeom.cli.options import add_digits, read_digits
from stochgeom.cli.output import write, write_json
from stochgeom.cli.plan_command import read_part
from stochgeom.cli.progress import Progress
from stochgeom.errors import FrictionError
from stochgeom.exact.angles import Angle
from stochgeom.exact.scalars import rational
from stochgeom.grasping.friction import Friction
from stochgeom.grasping.grasp_report import GraspReport
from stochgeom.io.grasp_json import grasp_document
from stochgeom.io.priors import load_prior

_EPILOG = """\
SOURCE is the same as for stochgeom plan. Exit code 1 if a tolerance is asked for and no grasp
bears it.

examples:

  stochgeom grasp house --mu 0.25
  stochgeom grasp rectangle --mu 1/10 --tolerance 10
  stochgeom grasp --vertices "0,0 3,0 3,2 0,2" --mu 0.25 --probability 0.9
"""


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "grasp",
        help="grasp a part with friction: guarantees and probabilities",
        description="Print which orientations of a part end stable in a single grasp with friction,"
        "\nthe largest error of the orientation that a grasp bears, and lower bounds on the\n"
        "probability that a random grasp ends stable.",
        epilog=_EPILOG,
    )
    parser.add_argument("source", nargs="?", metavar="SOURCE", help="what to grasp")
    parser.add_argument("--vertices", metavar="LIST", help='the outline itself: "0,0 3,0 3,2"')
    parser.add_argument("--center-of-mass", metavar="X,Y", help="default: uniform centroid")
    parser.add_argument(
        "--mu", metavar="MU", help="coefficient of friction, a rational >= 0 such as 0.25 or 1/4"
    )
    parser.add_argument(
        "--friction-angle", metavar="DEGREES", help="instead of --mu: arctan mu, exact degrees"
    )
    parser.add_argument(
        "--tolerance",
        metavar="DEGREES",
        help="the part's orientation may be off by so much either way: which grasps bear it?",
    )
    parser.add_argument(
        "--prior",
        metavar="PRIOR",
        help='how parts arrive, relative to the gripper: "normal:MEAN,SD" in degrees, or a file; '
        "for the bound under it",
    )
    parser.add_argument(
        "--probability",
        metavar="P",
        help="also print the largest mu for which a stable grasp has at least this probability",
    )
    add_digits(parser)
    parser.add_argument("--json", action="store_true", help="print a stochgeom/grasp/1 document")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Analyse, print; exit code 1 if no grasp bears the tolerance asked for."""
    digits = read_digits(arguments.digits)
    report = GraspReport(
        read_part(arguments),
        _friction(arguments),
        tolerance=arguments.tolerance,
        prior=None if arguments.prior is None else load_prior(arguments.prior),
        probability=arguments.probability,
    )
    with Progress("grasp: diagrams and bounds") as progress:
        for share in report.compute():
            progress.show(share)
    if arguments.json:
        write_json(grasp_document(report, digits))
    else:
        write(grasp_text(report, digits))
    return 1 if report.tolerance is not None and not report.grasps else 0


def _friction(arguments: argparse.Namespace) -> Friction:
    if (arguments.mu is None) == (arguments.friction_angle is None):
        given = "neither --mu nor" if arguments.mu is None else "both --mu and"
        raise FrictionError(f"{given} --friction-angle given; accepted: one of them")
    if arguments.mu is not None:
        return Friction.of(arguments.mu)
    degrees = rational(arguments.friction_angle, where="--friction-angle")
    return Friction(Angle.from_degrees(degrees))
