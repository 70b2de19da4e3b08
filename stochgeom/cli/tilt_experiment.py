"""``stochgeom tilt experiment`` and ``stochgeom tilt grasp``."""

from __future__ import annotations

import argparse
import json
from typing import TYPE_CHECKING, Any

from stochgeom.cli.layout import count, table
from stochgeom.cli.options import read_count
from stochgeom.cli.output import write, write_json
from stochgeom.cli.progress import Progress
from stochgeom.cli.tilt_simulate import describe, read_robot
from stochgeom.exact.scalars import parse_rational

if TYPE_CHECKING:  # loaded when the command runs: other commands start without them
    from stochgeom.tilting.experiment import Calibration, MeasuredPlan
    from stochgeom.tilting.gripper import GraspShare

_EDGES = (0.0, 0.7, 0.8, 0.9, 0.95, 0.97, 0.98, 0.985, 0.99, 1.0)
_SAMPLES = ((1, 3), (1, 2), (1, 4), (1, 7), (1, 10), (8, 1), (2, 1), (2, 3))
"""Pairs of Tables 6.1 and 6.2 that are shown one by one."""


def run(arguments: argparse.Namespace) -> int:
    """Run the experiment, print and write it, return the exit code."""
    from stochgeom.io.files import write_whole
    from stochgeom.tilting.experiment import trials_study

    robot, trials = read_robot(arguments), read_count(arguments.trials, "--trials")
    sizes: tuple[int, ...] = (trials,)
    if arguments.sizes is not None:
        sizes = tuple(read_count(text.strip(), "--sizes") for text in arguments.sizes.split(","))
    executions = read_count(arguments.executions, "--executions")
    jobs = read_count(arguments.jobs, "--jobs")
    with Progress("trials and executions") as progress:
        study = trials_study(robot, sizes, executions, jobs=jobs, tell=progress.show)
    document = {
        "schema": "stochgeom/tilt-experiment/1",
        "simulation": describe(robot, max(sizes)),
        "executions": executions,
        "runs": [_run_document(size, calibration) for size, calibration in study.items()],
    }
    if arguments.out is not None:
        write_whole(arguments.out, json.dumps(document) + "\n")
    if arguments.json:
        write_json(document, indent=None)
    else:
        parts = [_calibration_text(max(study), study[max(study)])]
        if len(study) > 1:
            parts.append(_study_text(study))
        write("\n\n".join(parts))
    return 0


def _run_document(trials: int, calibration: Calibration) -> dict[str, Any]:
    return {
        "trials": trials,
        "others": calibration.model.counts.others,
        "unobserved": len(calibration.model.undefined_rows),
        "mean_estimated": _decimal(calibration.estimated),
        "mean_measured": _decimal(calibration.measured),
        "covered": _decimal(calibration.covered),
        "mean_tilts": _decimal(calibration.mean_tilts),
        "sd_tilts": _decimal(calibration.sd_tilts),
        "plans": [
            {
                "from": row.plan.start,
                "to": row.plan.goal,
                "tilts": list(row.plan.actions),
                "estimated": _decimal(row.estimated),
                "executions": row.executions,
                "successes": row.successes,
                "others": row.others,
            }
            for row in calibration.rows
        ],
    }


def _decimal(value: float) -> str:
    """Return an estimate, a float, as text: machine-read files hold no number with a point."""
    return f"{value:.6f}"


def _plan_row(row: MeasuredPlan) -> list[str]:
    low, high = row.interval()
    return [
        str(row.plan.start),
        str(row.plan.goal),
        " ".join(map(str, row.plan.actions)),
        f"{row.estimated:.3f}",
        f"{row.share:.3f}",
        f"{low:.3f} to {high:.3f}",
    ]


def _calibration_text(trials: int, found: Calibration) -> str:
    chosen = {(row.plan.start, row.plan.goal): row for row in found.rows}
    rows = [_plan_row(chosen[pair]) for pair in _SAMPLES]
    executions = found.rows[0].executions
    bins = [
        [f"{estimate:.3f}", f"{share:.3f}", str(plans)]
        for estimate, share, plans in found.bins(_EDGES)
    ]
    header = ["from", "to", "tilts", "estimated", "measured", "95 % interval"]
    return "\n".join(
        [
            (
                f"{count(trials, 'trial')}, {count(executions, 'execution')} of each of "
                f"{len(found.rows)} plans"
            ),
            "",
            table(header, rows, left=[2, 5]),
            "",
            "All plans, by their estimated probability:",
            "",
            table(["estimated", "measured", "plans"], bins),
            "",
            (
                f"mean estimated probability {found.estimated:.3f}, measured {found.measured:.3f}; "
                f"{found.covered:.0%} of the 95 % intervals hold the estimate"
            ),
            (
                f"mean number of tilts {found.mean_tilts:.2f}, standard deviation "
                f"{found.sd_tilts:.2f} (source: 2.4 and .75, another robot)"
            ),
        ]
    )


def _study_text(study: dict[int, Calibration]) -> str:
    rows = [
        [
            str(size),
            str(len(found.model.undefined_rows)),
            f"{found.estimated:.3f}",
            f"{found.measured:.3f}",
            f"{min(row.share for row in found.rows):.3f}",
            f"{found.mean_tilts:.2f}",
        ]
        for size, found in study.items()
    ]
    header = ["trials", "pairs never tried", "estimated", "measured", "worst plan", "tilts"]
    return "By the number of trials:\n\n" + table(header, rows)


# --- the gripper ---------------------------------------------------------------------------------


def run_grasp(arguments: argparse.Namespace) -> int:
    """Grasp with both grippers, print, return the exit code."""
    from stochgeom.grasping.squeeze_stability import SqueezeStability
    from stochgeom.io.load import load_part
    from stochgeom.tilting.gripper import SimulatedGripper, random_grasps

    part = load_part(arguments.source)
    exact_friction = parse_rational(arguments.friction, where="--friction")
    # Between fixed jaws a random squeeze ends stable unless it begins, or ends, wedged.
    exact = 1 - SqueezeStability(part, exact_friction).wedged.measure
    friction = float(exact_friction)
    trials, seed = read_count(arguments.trials, "--trials"), read_count(arguments.seed, "--seed", 0)
    found: dict[str, GraspShare] = {}
    with Progress("grasps") as progress:
        for sliding in (False, True):
            gripper = SimulatedGripper(friction=friction, sliding_jaw=sliding)
            name = "one jaw slides" if sliding else "both jaws fixed"

            def tell(share: float, done: int = len(found)) -> None:
                progress.show((done + share) / 2)

            found[name] = random_grasps(part, gripper, trials, seed, tell=tell)
    if arguments.json:
        write_json(
            {
                "schema": "stochgeom/grasp-experiment/1",
                "friction": arguments.friction,
                "trials": trials,
                "seed": seed,
                "stable": [found["both jaws fixed"].stable, found["one jaw slides"].stable],
                "exact_share": [exact.decimal(6), "1.000000"],
            },
            indent=None,
        )
    else:
        shares = [exact.decimal(3), "1.000"]
        write(_grasp_text(part.name or "the part", arguments.friction, found, shares))
    return 0


def _grasp_text(name: str, friction: str, found: dict[str, GraspShare], exact: list[str]) -> str:
    rows = []
    for (gripper, share), truth in zip(found.items(), exact, strict=True):
        low, high = share.interval()
        rows.append(
            [
                gripper,
                f"{share.stable} of {len(share.grasps)}",
                f"{share.share:.3f}",
                f"{low:.3f} to {high:.3f}",
                truth,
            ]
        )
    return (
        f"{name}, friction {friction}: grasps at random orientations that end with an edge flush"
        "\n\n"
        + table(["gripper", "stable", "share", "95 % interval", "exact"], rows, left=[0, 3])
        + "\n\nExact: the share that friction cones give (stochgeom grasp)."
        "\nThe source counted 126 of 250 and 250 of 250, with several shapes."
    )
