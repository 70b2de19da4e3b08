"""``stochgeom tilt simulate``, and what the other simulations share with it."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from stochgeom.cli.layout import count, table
from stochgeom.cli.options import read_count
from stochgeom.cli.output import write, write_json
from stochgeom.cli.progress import Progress
from stochgeom.errors import TrayError

if TYPE_CHECKING:  # loaded when the command runs: other commands start without them
    from stochgeom.tilting.counts import TransitionCounts
    from stochgeom.tilting.robot import SimulatedRobot


def run(arguments: argparse.Namespace) -> int:
    """Simulate, write the recording, return the exit code."""
    from stochgeom.io.recordings import recording_document, save_recording

    robot, trials = read_robot(arguments), read_count(arguments.trials, "--trials")
    jobs = read_count(arguments.jobs, "--jobs")
    with Progress("trials") as progress:
        counts = robot.observe(trials, jobs=jobs, tell=progress.show)
    document = recording_document(counts, simulation=describe(robot, trials))
    if arguments.out is not None:
        save_recording(arguments.out, document)
    if arguments.json:
        write_json(document, indent=None)
    else:
        write(_text(counts, robot, arguments.out))
    return 0


def describe(robot: SimulatedRobot, trials: int) -> dict[str, Any]:
    """Return what a document says of a simulation."""
    return {"trials": trials, "seed": robot.seed, "setup": robot.setup.as_texts()}


def _text(counts: TransitionCounts, robot: SimulatedRobot, out: str | None) -> str:
    table_of = counts.table
    rows = [
        [
            str(outcome),
            *(str(int(number)) for number in (table_of[:, k, :].sum(), table_of[:, :, k].sum())),
        ]
        if k < counts.states
        else [str(outcome), "", str(counts.others)]
        for k, outcome in enumerate(counts.outcomes)
    ]
    unseen = int((table_of.sum(axis=2) == 0).sum())
    pairs = counts.states * counts.actions
    lines = [
        (
            f"{count(counts.total, 'trial')}, seed {robot.seed}: a random state, a random tilt, "
            "and where the tile came to rest"
        ),
        "",
        table(["state", "began there", "ended there"], rows, left=[0]),
        "",
        f"{counts.others} ended in none of the twelve states: short edge at a wall, or jammed.",
        f"{unseen} of {pairs} pairs of state and tilt were never tried.",
    ]
    if out is not None:
        lines.append(
            f"The recording is in {out}; stochgeom tilt plan {out} --from 1 --to 3 uses it."
        )
    return "\n".join(lines)


def read_robot(arguments: argparse.Namespace) -> SimulatedRobot:
    """Return the robot that --seed and --set describe."""
    from stochgeom.tilting.robot import SimulatedRobot
    from stochgeom.tilting.tray import setup_from_texts

    return SimulatedRobot(
        setup_from_texts(_settings(arguments.settings)), read_count(arguments.seed, "--seed", 0)
    )


def _settings(pairs: Sequence[str]) -> dict[str, str]:
    found = {}
    for pair in pairs:
        name, equals, value = pair.partition("=")
        if not equals:
            raise TrayError(f"{pair[:60]!r}; accepted: NAME=VALUE", where="--set")
        found[name.strip()] = value.strip()
    return found
