"""The simulated robot: trials with a known start, and plans carried out.

Trial number n draws its start, its tilt and its variation from a generator of its own, made of the
seed and n. So the same seed gives the same trials, whichever process runs them and in whatever
order, and the first thousand of two thousand trials are a recording of a thousand.

What follows from here needs no simulation: a recording of a real robot is a `TransitionCounts` too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass, field
from multiprocessing import get_context
from typing import Final, TypeAlias, final

import numpy as np

from stochgeom.arguments import as_count, expect
from stochgeom.errors import SimulationError, TrayError
from stochgeom.tilting.counts import OTHER, Outcome, TransitionCounts, Trial, numbered
from stochgeom.tilting.physics import Tilt, load_engine, slide_tile
from stochgeom.tilting.states import (
    ACTIONS,
    STATES,
    TilePose,
    azimuth,
    random_tile_pose,
    tile_state,
)
from stochgeom.tilting.tray import TraySetup

Job: TypeAlias = "tuple[TraySetup, int, int, tuple[int, ...], range]"
"""Setup, seed, start (0: random), tilts, numbers of the trials."""

_OBSERVE, _EXECUTE = 0, 1
_BATCH: Final = 50
"""Trials that a process runs before it reports."""


@final
@dataclass(frozen=True, slots=True)
class SimulatedRobot:
    """A robot that tilts a tray, in the engine.

    Parameters
    ----------
    setup : TraySetup, optional
        Tray, tile, friction, variation, solver.
    seed : int, default 0
        Of everything random, from 0.

    Examples
    --------
    >>> robot = SimulatedRobot(seed=1)
    >>> robot.observe(40).total
    40
    >>> robot.execute(1, [4], 20)[3] > 15
    True
    """

    setup: TraySetup = field(default_factory=TraySetup)
    seed: int = 0

    def __post_init__(self) -> None:
        expect(self.setup, TraySetup, "a TraySetup", "setup")
        as_count(self.seed, "as a seed", least=0, error=TrayError, where="seed")

    def trials(
        self, count: int, *, jobs: int = 1, tell: Callable[[float], None] | None = None
    ) -> tuple[Trial, ...]:
        """Run trials: a random start, a random tilt, and where the tile comes to rest.

        Parameters
        ----------
        count : int
            How many, at least 1.
        jobs : int, default 1
            Processes that share them; the result does not depend on it. In a script, start more
            than one under ``if __name__ == "__main__":``, as Python's `multiprocessing` asks for.
        tell : callable, optional
            Called with the share of work done.

        Raises
        ------
        TrayError
            If there are no trials or no processes.
        MissingExtraError
            If pymunk is not installed.
        SimulationError
            If a tile leaves the tray or does not come to rest; the trial is named.
        """
        found = _run(self, [(0, ())], count, jobs, tell)[0]
        return tuple((path[0], path[1], path[2]) for path in found)  # type: ignore[misc]

    def observe(
        self, count: int, *, jobs: int = 1, tell: Callable[[float], None] | None = None
    ) -> TransitionCounts:
        """Run trials and count them; see `trials`."""
        return TransitionCounts.from_trials(self.trials(count, jobs=jobs, tell=tell))

    def execute(
        self,
        start: int,
        actions: Sequence[int],
        count: int,
        *,
        jobs: int = 1,
        tell: Callable[[float], None] | None = None,
    ) -> dict[Outcome, int]:
        """Carry a plan out again and again; return how often it ended in each outcome.

        Each time the tile is put down in the start state; after that it stays where it came to
        rest, and the next tilt begins there.
        """
        return self.execute_all([(start, actions)], count, jobs=jobs, tell=tell)[0]

    def execute_all(
        self,
        plans: Sequence[tuple[int, Sequence[int]]],
        count: int,
        *,
        jobs: int = 1,
        tell: Callable[[float], None] | None = None,
    ) -> list[dict[Outcome, int]]:
        """Carry out each of several plans `count` times; a plan is a start and its tilts."""
        work = [
            (
                numbered(start, STATES, "start"),
                tuple(numbered(action, ACTIONS, "action") for action in actions),
            )
            for start, actions in plans
        ]
        ends = [[path[-1] for path in paths] for paths in _run(self, work, count, jobs, tell)]
        return [
            {outcome: end.count(outcome) for outcome in (*range(1, STATES + 1), OTHER)}
            for end in ends
        ]


def run_trial(
    setup: TraySetup, seed: int, start: int, actions: Sequence[int], number: int
) -> tuple[Outcome, ...]:
    """Run one trial; return (start, tilt, outcome), or (start, outcome) if the tilts are given."""
    key = (_EXECUTE, start, *actions, number) if start else (_OBSERVE, number)
    random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=key))
    state = start or int(random.integers(1, STATES + 1))
    tilts = tuple(actions) if start else (int(random.integers(1, ACTIONS + 1)),)
    pose = random_tile_pose(setup, state, random)
    for action in tilts:
        pose = tilt_once(setup, pose, action, random)
    return (state, *(() if start else tilts), tile_state(setup, pose))


def tilt_once(
    setup: TraySetup, pose: TilePose, action: int, random: np.random.Generator
) -> TilePose:
    """Tilt by a nominal action, with its random variation; return where the tile comes to rest."""
    return slide_tile(setup, pose, vary(setup, action, random)).pose


def vary(setup: TraySetup, action: int, random: np.random.Generator) -> Tilt:
    """Draw a tilt around its nominal values."""
    turn, lift = random.normal(0.0, 1.0, 2)
    floor, wall = 1 + setup.friction_spread * random.uniform(-1.0, 1.0, 2)
    return Tilt(
        azimuth(action) + setup.azimuth_sd * turn,
        min(max(setup.tilt + setup.tilt_sd * lift, 0.0), 90.0),
        setup.support_friction * floor,
        setup.wall_friction * wall,
    )


def _run(
    robot: SimulatedRobot,
    plans: Sequence[tuple[int, tuple[int, ...]]],
    count: int,
    jobs: int,
    tell: Callable[[float], None] | None,
) -> list[list[tuple[Outcome, ...]]]:
    """Run `count` trials of each plan, in batches that any process may take."""
    count = as_count(count, "trials", error=TrayError, where="trials")
    jobs = as_count(jobs, "processes", error=TrayError, where="jobs")
    load_engine()  # its absence is better told here than by a process
    batches = [range(k, min(k + _BATCH, count)) for k in range(0, count, _BATCH)]
    work: list[Job] = [
        (robot.setup, robot.seed, *plan, batch) for plan in plans for batch in batches
    ]
    found: list[list[tuple[Outcome, ...]]] = [[] for _ in work]
    for done, (k, paths) in enumerate(_finished(work, jobs), start=1):
        found[k] = paths
        if tell is not None:
            tell(done / len(work))
    each = len(batches)
    return [
        [path for paths in found[k : k + each] for path in paths]
        for k in range(0, len(found), each)
    ]


def _finished(work: list[Job], jobs: int) -> Iterator[tuple[int, list[tuple[Outcome, ...]]]]:
    """Yield the number and the result of each job as it ends."""
    if min(jobs, len(work)) == 1:
        yield from enumerate(map(run_batch, work))
        return
    # Fresh processes: a fork would copy locks and threads in any state.
    with ProcessPoolExecutor(min(jobs, len(work)), get_context("spawn")) as pool:
        waiting = {pool.submit(run_batch, job): k for k, job in enumerate(work)}
        for future in as_completed(waiting):
            yield waiting[future], future.result()


def run_batch(job: Job) -> list[tuple[Outcome, ...]]:
    """Run consecutive trials in this process."""
    setup, seed, start, actions, numbers = job
    found = []
    for number in numbers:
        try:
            found.append(run_trial(setup, seed, start, actions, number))
        except SimulationError as error:
            raise SimulationError(error.message, where=f"seed {seed}, trial {number}") from None
    return found
