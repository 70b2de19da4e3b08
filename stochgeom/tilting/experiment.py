"""The source's experiment, with a simulated robot: estimate, plan, carry out (thesis 6.4).

A plan is made from a model, and the model from trials; whether the estimated probability is that
of the robot is seen when the plan is carried out. Two things stand between them: few trials, and
the state itself, which does not tell where in a state the tile lies (the source's "aliasing").
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import fmean, stdev
from typing import Final, final

from stochgeom.arguments import as_count, as_list, expect
from stochgeom.errors import InputError
from stochgeom.tilting.all_plans import best_tilt_plans
from stochgeom.tilting.counts import OTHER, TransitionCounts
from stochgeom.tilting.estimation import ALPHA, AlphaLike, TransitionModel
from stochgeom.tilting.intervals import wilson_interval
from stochgeom.tilting.robot import SimulatedRobot
from stochgeom.tilting.tilt_plans import TiltPlan

TRIALS: Final = 2000
"""Trials of the source's robot."""

EXECUTIONS: Final = 400
"""Times that it carried out a plan."""

Tell = Callable[[float], None]


@final
@dataclass(frozen=True, slots=True)
class MeasuredPlan:
    """A plan and what came of it.

    Attributes
    ----------
    plan : TiltPlan
        The plan, with its estimated probability.
    executions, successes, others : int
        Times it was carried out, ended in the goal, ended in none of the states.
    """

    plan: TiltPlan
    executions: int
    successes: int
    others: int

    @property
    def estimated(self) -> float:
        """The estimated probability."""
        return float(self.plan.probability)

    @property
    def share(self) -> float:
        """The measured share of successes."""
        return self.successes / self.executions

    def interval(self, level: float = 0.95) -> tuple[float, float]:
        """Return Wilson's confidence interval of the probability measured."""
        return wilson_interval(self.successes, self.executions, level)

    @property
    def is_covered(self) -> bool:
        """Whether the 95 % interval holds the estimate."""
        low, high = self.interval()
        return low <= self.estimated <= high


@final
@dataclass(frozen=True, slots=True)
class Calibration:
    """Estimated beside measured probabilities of many plans.

    Attributes
    ----------
    model : TransitionModel
        What the plans were made from.
    rows : tuple of MeasuredPlan
        One for each instance.
    """

    model: TransitionModel
    rows: tuple[MeasuredPlan, ...]

    @property
    def estimated(self) -> float:
        """Mean of the estimated probabilities."""
        return fmean(row.estimated for row in self.rows)

    @property
    def measured(self) -> float:
        """Mean of the measured shares."""
        return fmean(row.share for row in self.rows)

    @property
    def covered(self) -> float:
        """Share of the plans whose 95 % interval holds the estimate."""
        return fmean(row.is_covered for row in self.rows)

    @property
    def mean_tilts(self) -> float:
        """Mean number of tilts; the source has 2.4."""
        return fmean(row.plan.steps for row in self.rows)

    @property
    def sd_tilts(self) -> float:
        """Standard deviation of the number of tilts; the source has .75."""
        return stdev([row.plan.steps for row in self.rows]) if len(self.rows) > 1 else 0.0

    def bins(self, edges: Sequence[float]) -> list[tuple[float, float, int]]:
        """Return mean estimate, mean share and number of the plans between neighbouring edges.

        An edge belongs to the bin above it, the last one to the bin below; empty bins are left out.
        """
        found = []
        for low, high in pairwise(edges):
            last = high == edges[-1]
            inside = [
                row
                for row in self.rows
                if low <= row.estimated < high or (last and row.estimated == high)
            ]
            if inside:
                mean = fmean(row.estimated for row in inside)
                found.append((mean, fmean(row.share for row in inside), len(inside)))
        return found


def measure_tilt_plans(
    robot: SimulatedRobot,
    plans: Iterable[TiltPlan],
    executions: int = EXECUTIONS,
    *,
    jobs: int = 1,
    tell: Tell | None = None,
) -> tuple[MeasuredPlan, ...]:
    """Carry plans out and count successes (Table 6.2).

    Examples
    --------
    >>> from stochgeom.tilting.tilt_plans import evaluate_tilt_plan
    >>> robot = SimulatedRobot(seed=2)
    >>> plan = evaluate_tilt_plan(TransitionModel(robot.observe(100)), 1, 3, (4,))
    >>> measure_tilt_plans(robot, [plan], 50)[0].share > 0.8
    True
    """
    expect(robot, SimulatedRobot, "a SimulatedRobot")
    listed = tuple(as_list(plans, "a list of tilt plans", "plans"))
    for k, plan in enumerate(listed):
        expect(plan, TiltPlan, "a tilt plan, such as best_tilt_plan gives", f"plan {k}")
    if not listed:
        return ()
    pairs = [(plan.start, plan.actions) for plan in listed]
    ends = robot.execute_all(pairs, executions, jobs=jobs, tell=tell)
    return tuple(
        MeasuredPlan(plan, executions, end[plan.goal], end[OTHER])
        for plan, end in zip(listed, ends, strict=True)
    )


def calibrate_tilt_plans(
    robot: SimulatedRobot,
    counts: TransitionCounts,
    executions: int = EXECUTIONS,
    most_tilts: int = 3,
    *,
    alpha: AlphaLike = ALPHA,
    jobs: int = 1,
    tell: Tell | None = None,
) -> Calibration:
    """Plan every instance from the counts, and carry every plan out.

    Time: 132 plans x executions x tilts; at 400 tilts a second, some five minutes for 400.
    """
    expect(robot, SimulatedRobot, "a SimulatedRobot")
    model = TransitionModel(counts, alpha)
    plans = best_tilt_plans(model, most_tilts).values()
    return Calibration(model, measure_tilt_plans(robot, plans, executions, jobs=jobs, tell=tell))


def trials_study(
    robot: SimulatedRobot,
    sizes: Sequence[int] = (250, 500, 1000, 2000, 4000, 8000),
    executions: int = EXECUTIONS,
    *,
    jobs: int = 1,
    tell: Tell | None = None,
) -> dict[int, Calibration]:
    """Return the calibration for each number of trials: each recording continues the one before.

    Raises
    ------
    InputError
        If no number is given.
    """
    expect(robot, SimulatedRobot, "a SimulatedRobot")
    sizes = [as_count(size, "trials") for size in as_list(sizes, "numbers of trials", "sizes")]
    executions = as_count(executions, "executions")
    if not sizes:
        raise InputError("no numbers of trials; accepted: one or more")
    steps, done = len(sizes) + 1, 0

    def tell_part(share: float) -> None:
        if tell is not None:
            tell((done + share) / steps)

    trials = robot.trials(max(sizes), jobs=jobs, tell=tell_part)
    found = {}
    for size in sizes:
        done += 1
        counts = TransitionCounts.from_trials(trials[:size])
        found[size] = calibrate_tilt_plans(robot, counts, executions, jobs=jobs, tell=tell_part)
    return found
