"""``stochgeom plan``: from an outline to a feeding plan."""

from __future__ import annotations

import argparse
import json
from typing import Any

from gmpy2 import mpq

from stochgeom.cli.options import add_digits, add_json, add_part, read_digits
from stochgeom.cli.output import write, write_json
from stochgeom.cli.plan_text import plan_text
from stochgeom.cli.progress import Progress
from stochgeom.decision.costs import as_cost_ratio
from stochgeom.decision.priors import Prior
from stochgeom.errors import FormatError, InputError
from stochgeom.exact.ratios import TurnRatio
from stochgeom.feeding.problem import TRANSFER_FUNCTIONS, FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.io.files import write_whole
from stochgeom.io.load import load_part, part_of
from stochgeom.io.outlines import Outline, parse_vertices
from stochgeom.io.plan_json import plan_document
from stochgeom.io.priors import load_prior

_EPILOG = """\
SOURCE is a part of the catalogue (see: stochgeom parts), a file, or - for standard input. Files
hold JSON, WKT POLYGON, or a vertex per line such as "3 2" or "3,2". Numbers are exact: 0.1 is one
tenth.

examples:

  stochgeom plan house
  stochgeom plan outline.txt --cost-ratio 1/2 --certificate plan.json
  stochgeom plan --vertices "0,0 3,0 3,2 0,2" --json
  stochgeom plan house --action push-grasp --gripper-error 2
  stochgeom plan house --center-of-mass "0,2/5"
  stochgeom plan outline.txt --prior normal:30,12 --goal "most stable"
"""


_ABOUT_CERTIFICATES = """
Without goal and gripper error the plan is the same, and as such it is certified:
neither the goal nor the gripper error is part of the certificate.
Its claims are where the plan ends and which ranges work; stochgeom verify tells what follows."""


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "plan",
        help="plan how to feed a part",
        description="Print the plan of least expected cost and the shortest plan that orients "
        "the part up to symmetry.",
        epilog=_EPILOG,
    )
    add_problem_options(parser)
    parser.add_argument(
        "--certificate",
        metavar="FILE",
        help="also write the optimal plan with its proof; stochgeom verify FILE checks it",
    )
    add_digits(parser)
    add_json(parser, "print a stochgeom/plan/1 document")
    parser.set_defaults(run=run)


def add_problem_options(parser: argparse.ArgumentParser) -> None:
    """Add what says for which part and under which conditions to plan."""
    add_part(parser, "what to plan for")
    parser.add_argument(
        "--action",
        default="squeeze",
        choices=sorted(TRANSFER_FUNCTIONS),
        help="what the gripper does; default squeeze. A push-grasp pushes with the lower jaw first",
    )
    parser.add_argument(
        "--prior",
        metavar="PRIOR",
        help='how parts arrive: uniform (default), "normal:MEAN,SD" in degrees, or a file with a '
        "measured orientation to a line, or JSON",
    )
    parser.add_argument(
        "--gripper-error",
        metavar="DEGREES",
        help="every action may be off by so much either way; default 0. Also tells how much may be",
    )
    parser.add_argument(
        "--goal",
        metavar="ANGLE",
        help='final orientation in degrees, or "most stable"; default any',
    )
    parser.add_argument(
        "--cost-ratio",
        default="1",
        metavar="C",
        help="cost of the filter over the cost of an action, a rational >= 0; default 1",
    )


def run(arguments: argparse.Namespace) -> int:
    """Plan, print, return the exit code."""
    digits = read_digits(arguments.digits)
    problem = make_problem(arguments)
    cost_ratio = as_cost_ratio(arguments.cost_ratio)  # refused before the work, if it is bad
    run_phase_one(problem)
    optimal = problem.optimal_plan(cost_ratio)
    geometric = problem.geometric_plan(cost_ratio) if problem.preimages.complete else None
    if arguments.certificate is not None:
        write_whole(arguments.certificate, json.dumps(optimal.certificate(), indent=1) + "\n")
    if arguments.json:
        write_json(plan_document(problem, optimal, geometric, digits))
    else:
        write(plan_text(problem, optimal, geometric, digits))
        asked = problem.goal is not None or problem.gripper_error is not None
        if arguments.certificate is not None and asked:
            write(_ABOUT_CERTIFICATES)
    return 0


def run_phase_one(problem: FeedingProblem) -> None:
    """Find all preimages, which the problem keeps, and show how far it is."""
    with Progress("phase I: width of the last preimage, of a period") as progress:
        for preimage in problem.preimages:
            progress.show(float(TurnRatio(mpq(problem.transfer.order), preimage.width)))


def make_problem(arguments: argparse.Namespace) -> FeedingProblem:
    """Return the problem that the options of `add_problem_options` state."""
    return FeedingProblem(
        read_part(arguments),
        arguments.action,
        prior=read_prior(arguments),
        gripper_error=arguments.gripper_error,
        goal=arguments.goal,
    )


def read_prior(arguments: argparse.Namespace) -> Prior | None:
    """Return the prior that ``--prior`` names, None without it."""
    if arguments.prior is None:
        return None
    with Progress("reading the prior") as progress:
        return load_prior(arguments.prior, progress.show)


def read_part(arguments: argparse.Namespace) -> Part:
    """Return the part that SOURCE or ``--vertices`` names.

    Raises
    ------
    InputError
        If neither or both are given.
    """
    if (arguments.source is None) == (arguments.vertices is None):
        given = "neither SOURCE nor" if arguments.source is None else "both SOURCE and"
        raise InputError(f"{given} --vertices given; accepted: one of them")
    if arguments.vertices is None:
        return load_part(arguments.source, center_of_mass=arguments.center_of_mass)
    if not arguments.vertices.strip():
        raise FormatError('empty; accepted: "0,0 3,0 3,2 0,2"', where="--vertices")
    vertices = parse_vertices(arguments.vertices, where="--vertices")
    return part_of(Outline(vertices), arguments.center_of_mass)
