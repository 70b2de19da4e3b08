"""Experiments of the source repeated on simulated machines: Tables 6.1 and 6.2, and section B.2.

The source's robot, tray and parts are gone; the simulated ones are others. Their numbers stand
beside the printed ones and are not judged.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from gmpy2 import mpq

from stochgeom.geometry.part import Part
from stochgeom.thesis.chapter_6 import (
    PRINTED_MEAN_TILTS,
    PRINTED_PLANS,
    PRINTED_SD_TILTS,
    unanimous_trials,
)
from stochgeom.thesis.number_tables import Entry, ExactNumber, NumberTable, square_root
from stochgeom.tilting.all_plans import best_tilt_plans
from stochgeom.tilting.estimation import TransitionModel
from stochgeom.tilting.experiment import EXECUTIONS, TRIALS, measure_tilt_plans
from stochgeom.tilting.gripper import SimulatedGripper, random_grasps
from stochgeom.tilting.robot import SimulatedRobot
from stochgeom.tilting.tilt_plans import evaluate_tilt_plan

SEED: Final = 6
GRASPS: Final = 250
"""Random grasps of each gripper, as in the source."""

Tell = Callable[[float], None]


def tilt_table(
    title: str, trials: int = TRIALS, executions: int = EXECUTIONS, tell: Tell | None = None
) -> NumberTable:
    """Return the plans of Tables 6.1 and 6.2 on the simulated robot; a minute or two.

    They are estimated from as many trials as the source made, and carried out as often.
    """
    robot = SimulatedRobot(seed=SEED)

    def part(first: float, last: float) -> Tell | None:
        return None if tell is None else lambda share: tell(first + (last - first) * share)

    counts = robot.observe(trials, tell=part(0.0, 0.15))
    model = TransitionModel(counts)
    plans = [evaluate_tilt_plan(model, p.start, p.goal, p.actions) for p in PRINTED_PLANS]
    measured = measure_tilt_plans(robot, plans, executions, tell=part(0.15, 1.0))
    rows: list[tuple[Entry, ...]] = [
        (
            str(printed.start),
            str(printed.goal),
            " ".join(map(str, printed.actions)),
            printed.estimated,
            ExactNumber(found.plan.probability),
            printed.measured or "",
            ExactNumber(mpq(found.successes, found.executions)),
        )
        for printed, found in zip(PRINTED_PLANS, measured, strict=True)
    ]
    rows += _tilts_of_all_instances(model)
    header = ("start", "goal", "plan", "source", "estimated", "source", "measured")
    notes = (
        (
            f"Estimated from {trials} trials, measured in {executions} executions of the simulated "
            f"robot, seed {SEED}: another robot than the source's, so that nothing is judged."
        ),
        (
            f"Of the {model.counts.states**2} pairs of states {model.counts.states} have the start "
            "for goal, and need no plan."
        ),
        _one_tilt_note(),
    )
    return NumberTable(title, header, tuple(rows), notes)


def _tilts_of_all_instances(model: TransitionModel) -> list[tuple[Entry, ...]]:
    """Return the mean and the deviation of the numbers of tilts of the best plans (6.4)."""
    tilts = [plan.steps for plan in best_tilt_plans(model).values()]
    mean = mpq(sum(tilts), len(tilts))
    variance = sum((steps - mean) ** 2 for steps in tilts) / (len(tilts) - 1)
    title = f"mean tilts, best plans of {len(tilts)} instances"
    spread = square_root(variance)
    return [
        ("", "", title, PRINTED_MEAN_TILTS, ExactNumber(mean), "", ""),
        ("", "", "standard deviation of these", PRINTED_SD_TILTS, spread, "", ""),
    ]


def _one_tilt_note() -> str:
    """Return how many trials would explain the printed estimates of plans of one tilt."""
    known = {
        p.estimated: unanimous_trials(p.estimated) for p in PRINTED_PLANS if len(p.actions) == 1
    }
    shown = [
        f"{text} ({found[0]})" if len(found) == 1 else f"{text} ({found[0]} to {found[-1]})"
        for text, found in sorted(known.items())
    ]
    return (
        "Printed estimates of plans of one tilt, and numbers of trials, all with the same outcome, "
        f"that give them: {', '.join(shown)}."
    )


def gripper_table(title: str, grasps: int = GRASPS, tell: Tell | None = None) -> NumberTable:
    """Return the shares of stable grasps of a simulated gripper, with and without a sliding jaw."""
    rows = []
    for place, (sliding, printed) in enumerate(((False, "126/250"), (True, "250/250"))):
        for k, n in enumerate((4, 6)):
            share = random_grasps(
                Part.regular(n), SimulatedGripper(sliding_jaw=sliding), grasps, seed=SEED
            )
            jaw = "sliding" if sliding else "fixed"
            rows.append((jaw, f"regular {n}-gon", f"{share.stable}/{grasps}", printed))
            if tell is not None:
                tell((2 * place + k + 1) / 4)
    notes = (
        (
            f"{grasps} random grasps each, friction 0.25, seed {SEED}. The source does not say "
            "which parts it took, so that nothing is judged."
        ),
    )
    return NumberTable(title, ("jaw", "part", "stable", "source"), tuple(rows), notes)
