"""Push-grasps of the 4gon and the house: Figs. E.1 to E.8, recomputed beside what is printed.

The source draws the transfer functions (Figs. E.1-E.3, E.6) and the preimages (E.4, E.7) without
numbers; `push_grasp_analysis` has them. It prints the plans and the evolution of the distribution
(E.5, E.8); `figure_e_5` and `figure_e_8` set them beside ours.

Fig. E.8 is one of two mirror images. The two widest steps of the house are exactly equally wide,
with final orientations 90 and 270; the printed plan ends in the second, ours in the one of smaller
start, at the same cost and with ranges of the same widths. So the figure is the plan for the goal
270.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, final

from stochgeom.feeding.preimages import Preimage
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.thesis.errata import APPENDIX_E
from stochgeom.thesis.evolutions import Evolution, PrintedEvolution, evolution
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.push import push_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

# --- Figs. E.1-E.4, E.6, E.7 ---------------------------------------------------------------------


@final
@dataclass(frozen=True, slots=True)
class PushGraspAnalysis:
    """All functions of Fig. E.3 or E.6, and the preimages of Fig. E.4 or E.7."""

    part: Part
    radius: RadiusFunction
    push: StepFunction
    diameter: DiameterFunction
    squeeze: StepFunction
    push_grasp: StepFunction
    preimages: tuple[Preimage, ...]


def push_grasp_analysis(name: str) -> PushGraspAnalysis:
    """Return what Figs. E.1 to E.4 (4gon) or E.6 and E.7 (house) draw, of any catalogue part.

    Examples
    --------
    >>> found = push_grasp_analysis("house")
    >>> [v.degrees(0) for v in found.push.values], [v.degrees(0) for v in found.push_grasp.values]
    (['90', '135', '225', '270', '360'], ['90', '270', '360'])
    """
    part = catalogue_part(name, appendix="E")
    problem = FeedingProblem(part, "push-grasp")
    return PushGraspAnalysis(
        part,
        RadiusFunction(part),
        push_function(part),
        DiameterFunction(part),
        squeeze_function(part),
        problem.transfer,
        tuple(problem.preimages),
    )


# --- Figs. E.5, E.8 ------------------------------------------------------------------------------


_E_5: Final = PrintedEvolution(
    "E.5",
    1,
    ("25", "79", "-23"),
    (
        ("0.26", "0.21", "0.25", "0.28"),
        ("0.26", "0.46", "0.00", "0.28"),
        ("0.46", "0.00", "0.00", "0.54"),
        ("0.00", "0.00", "0.00", "1.0"),
    ),
    {1: "3.7"},
    APPENDIX_E["angles"],
    APPENDIX_E["cost"],
)

_E_8: Final = PrintedEvolution(
    "E.8",
    2,
    ("72", "135"),
    (("0.20", "0.40", "0.40"), ("0.40", "0.60", "0.00"), ("0.00", "1.0", "0.00")),
    {3: "4"},
)


def figure_e_5() -> Evolution:
    """Recompute Fig. E.5: push-grasps of the 4gon; the angles and the cost have errata.

    Examples
    --------
    >>> for row in figure_e_5().rows:
    ...     print([cell.computed.decimal(2) for cell in row.cells])
    ['0.26', '0.21', '0.25', '0.28']
    ['0.26', '0.46', '0.00', '0.28']
    ['0.46', '0.00', '0.00', '0.54']
    ['0.00', '0.00', '0.00', '1.00']
    """
    return evolution(_E_5, _problem("4gon"))


def figure_e_8() -> Evolution:
    """Recompute Fig. E.8: push-grasps of the house; all that is printed holds.

    Examples
    --------
    >>> [row.angle.computed.decimal(2) for row in figure_e_8().rows[1:]]
    ['72.23', '135.00']
    """
    return evolution(_E_8, _problem("house", goal="270"))


def _problem(name: str, goal: str | None = None) -> FeedingProblem:
    return FeedingProblem(catalogue_part(name, appendix="E"), "push-grasp", goal=goal)
