"""``stochgeom tilt``: a tile in a tray: trials, estimates, plans, experiments, grasps."""

from __future__ import annotations

import argparse
import os
from typing import Any

from stochgeom.cli import tilt_experiment, tilt_plan, tilt_simulate
from stochgeom.cli.options import add_digits


def add_parser(commands: Any) -> None:
    """Register the command and its five subcommands."""
    parser = commands.add_parser(
        "tilt",
        help="estimate a robot that tilts a tray, and plan with it",
        description="Simulate a robot that tilts a tray, estimate its transition matrices from "
        "trials, plan tilts and put the plans to the test (Goldberg 1990, chapter 6 and appendix "
        "B).",
    )
    parts = parser.add_subparsers(dest="part", required=True, metavar="WHAT")
    _add_simulate(parts)
    _add_estimate(parts)
    _add_plan(parts)
    _add_experiment(parts)
    _add_grasp(parts)


def _add_simulate(parts: Any) -> None:
    parser = parts.add_parser(
        "simulate",
        help="trials of the simulated robot",
        description="Run trials: a random state, a random tilt, and the state in which the tile "
        "comes to rest. The same seed gives the same trials, however many processes share them.",
    )
    _add_trials(parser, "2000")
    _add_setup(parser)
    parser.add_argument("--out", metavar="FILE", help="write the recording there")
    _add_json(parser, "print the recording")
    parser.set_defaults(run=tilt_simulate.run)


def _add_estimate(parts: Any) -> None:
    parser = parts.add_parser(
        "estimate",
        help="transition matrices from a recording",
        description="Print the transition matrix of a tilt, estimated from a recording: posterior "
        "means under a Dirichlet prior.",
    )
    _add_model(parser)
    parser.add_argument("--tilt", default="1", metavar="A", help="which tilt; default 1")
    add_digits(parser)
    _add_json(parser, "print a stochgeom/tilt-estimate/1 document")
    parser.set_defaults(run=tilt_plan.run_estimate)


def _add_plan(parts: Any) -> None:
    parser = parts.add_parser(
        "plan",
        help="the best tilts from one state to another",
        description="Plan with a model: the sequence of tilts that most probably takes the tile "
        "from one state to another, without looking in between.",
    )
    _add_model(parser)
    parser.add_argument("--from", dest="start", metavar="STATE", help="where the tile is")
    parser.add_argument("--to", dest="goal", metavar="STATE", help="where it should go")
    parser.add_argument("--all", action="store_true", help="plan every pair of states")
    parser.add_argument("--max-tilts", default="3", metavar="K", help="longest plan; default 3")
    parser.add_argument(
        "--method",
        default="all-plans",
        choices=sorted(tilt_plan.METHODS),
        help="all-plans (default), branch-and-bound, shortest-path (a heuristic), or expected: "
        "the probability expected under the posterior instead of that of the mean",
    )
    parser.add_argument(
        "--observed-only", action="store_true", help="leave out tilts that were never observed"
    )
    add_digits(parser)
    _add_json(parser, "print a stochgeom/tilt-plan/1 document")
    parser.set_defaults(run=tilt_plan.run)


def _add_experiment(parts: Any) -> None:
    parser = parts.add_parser(
        "experiment",
        help="estimate, plan, carry out, compare",
        description="Estimate the simulated robot from trials, plan all 132 pairs of states, carry "
        "each plan out, and compare estimated with measured probabilities. Some six minutes of "
        "one core as it stands; --executions 50 takes one.",
    )
    _add_trials(parser, "2000")
    _add_setup(parser)
    parser.add_argument(
        "--executions", default="400", metavar="N", help="times a plan is carried out; default 400"
    )
    parser.add_argument(
        "--sizes", metavar="LIST", help="numbers of trials to compare, such as 250,500,1000"
    )
    parser.add_argument("--out", metavar="FILE", help="write the stochgeom/tilt-experiment/1 there")
    _add_json(parser, "print a stochgeom/tilt-experiment/1 document")
    parser.set_defaults(run=tilt_experiment.run)


def _add_grasp(parts: Any) -> None:
    parser = parts.add_parser(
        "grasp",
        help="a simulated gripper at random orientations",
        description="Close two jaws on a part at random orientations and count the grasps that "
        "end with an edge flush, with both jaws fixed and with one that slides (appendix B).",
    )
    parser.add_argument("source", metavar="PART", help="a part of the catalogue, a file, or -")
    parser.add_argument("--friction", default="1/4", metavar="MU", help="of the jaws; default 1/4")
    parser.add_argument("--trials", default="250", metavar="N", help="grasps; default 250")
    parser.add_argument("--seed", default="0", metavar="S", help="default 0")
    _add_json(parser, "print a stochgeom/grasp-experiment/1 document")
    parser.set_defaults(run=tilt_experiment.run_grasp)


def _add_trials(parser: argparse.ArgumentParser, trials: str) -> None:
    parser.add_argument("--trials", default=trials, metavar="N", help=f"default {trials}")
    parser.add_argument("--seed", default="0", metavar="S", help="default 0")
    parser.add_argument(
        "--jobs",
        default=str(os.cpu_count() or 1),
        metavar="N",
        help="processes; default: all processors",
    )


def _add_setup(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        dest="settings",
        metavar="NAME=VALUE",
        help="another tray, tile or solver, such as --set tilt=30 --set tile_length=100",
    )


def _add_model(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "source", metavar="MODEL", help="a recording (JSON or CSV), or figure-6.4 for the source's"
    )
    parser.add_argument(
        "--alpha", metavar="A", help="Dirichlet parameter; default: the file's, else 1/100"
    )
    parser.add_argument("--states", metavar="N", help="of the recording; default: its own, else 12")
    parser.add_argument("--actions", metavar="N", help="likewise")


def _add_json(parser: argparse.ArgumentParser, what: str) -> None:
    parser.add_argument("--json", action="store_true", help=what)
