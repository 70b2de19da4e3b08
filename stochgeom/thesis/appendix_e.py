"""Push-grasps of the 4gon and the house: Figs. E.1 to E.8, recomputed beside what is printed.

The source draws the transfer functions (Figs. E.1-E.3, E.6) and the preimages (E.4, E.7) without
numbers; `push_grasp_analysis` has them. It prints the plans and the evolution of the distribution
(E.5, E.8); `figure_e_5` and `figure_e_8` set them beside ours.

How the source prints: states by increasing angle of the jaws in the part's frame, which is
decreasing theta here; gripper angles from the first action on, each increment the middle of the
range of its action.

Fig. E.8 is one of two mirror images. The two widest steps of the house are exactly equally wide,
with final orientations 90 and 270; the printed plan ends in the second, ours in the one of smaller
start, at the same cost and with ranges of the same widths. So the figure is the plan for the goal
270.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate
from typing import Final, final

from gmpy2 import mpq

from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.balls import Ball
from stochgeom.exact.decimals import certified_decimal, rational_decimal
from stochgeom.exact.ratios import TurnRatio
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import Preimage
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.thesis.errata import APPENDIX_E, Erratum
from stochgeom.thesis.parts import catalogue_part
from stochgeom.thesis.tables import Cell, Shown
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


@final
@dataclass(frozen=True, slots=True)
class HalfAngle:
    """Half of a lifted angle, which is in general no rational direction, in degrees.

    Examples
    --------
    >>> HalfAngle(Angle.from_degrees(145)).decimal(2)
    '72.50'
    """

    doubled: Angle

    def decimal(self, digits: int = 4) -> str:
        """Return the angle in degrees as a correctly rounded decimal."""
        exact = self.doubled.rational_turns
        if exact is not None:
            return rational_decimal(exact * 180, digits)
        return certified_decimal(self._ball, digits)

    def _ball(self) -> Ball:
        return self.doubled.ball() * 180


@final
@dataclass(frozen=True, slots=True)
class Probability:
    """The share of a full turn that an angle has; zero as well."""

    width: Angle

    def decimal(self, digits: int = 4) -> str:
        """Return the probability as a correctly rounded decimal."""
        return TurnRatio(mpq(1), self.width).decimal(digits) if self.width else f"{0:.{digits}f}"


@final
@dataclass(frozen=True, slots=True)
class EvolutionRow:
    """The distribution after an action.

    Attributes
    ----------
    angle : Cell or None
        Of the gripper, from the first action on; None at the first, which is random.
    cells : tuple of Cell
        The probability of each state.
    """

    angle: Cell | None
    cells: tuple[Cell, ...]


@final
@dataclass(frozen=True, slots=True)
class Evolution:
    """A plan and what it makes of the distribution, computed and printed.

    Attributes
    ----------
    figure : str
        ``"E.5"`` or ``"E.8"``.
    plan : FeedingPlan
        The plan that the figure shows.
    orientations : tuple of Angle
        The states, in the printed order.
    rows : tuple of EvolutionRow
        One for each action.
    costs : tuple of Cell or Shown
        Expected costs of the best plans of 1, 2, ... steps, filter cost 1; a cell where a cost is
        printed.
    """

    figure: str
    plan: FeedingPlan
    orientations: tuple[Angle, ...]
    rows: tuple[EvolutionRow, ...]
    costs: tuple[Cell | Shown, ...]

    @property
    def cells(self) -> tuple[Cell, ...]:
        """Everything that is printed."""
        found = [row.angle for row in self.rows if row.angle is not None]
        found += [cell for row in self.rows for cell in row.cells]
        return (*found, *(cost for cost in self.costs if isinstance(cost, Cell)))


@final
@dataclass(frozen=True, slots=True)
class _Printed:
    """What a figure prints; `first` is the largest-to-smallest place of the state printed first."""

    figure: str
    part: str
    goal: str | None
    first: int
    angles: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    costs: dict[int, str]
    angle_erratum: Erratum | None = None
    cost_erratum: Erratum | None = None


_E_5: Final = _Printed(
    "E.5",
    "4gon",
    None,
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

_E_8: Final = _Printed(
    "E.8",
    "house",
    "270",
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
    return _evolution(_E_5)


def figure_e_8() -> Evolution:
    """Recompute Fig. E.8: push-grasps of the house; all that is printed holds.

    Examples
    --------
    >>> [row.angle.computed.decimal(2) for row in figure_e_8().rows[1:]]
    ['72.23', '135.00']
    """
    return _evolution(_E_8)


def _evolution(printed: _Printed) -> Evolution:
    problem = FeedingProblem(
        catalogue_part(printed.part, appendix="E"), "push-grasp", goal=printed.goal
    )
    plan = problem.geometric_plan()
    states = sorted((value % FULL_TURN for value in problem.transfer.values), reverse=True)
    states = states[printed.first :] + states[: printed.first]
    angles: list[Cell | None] = [None]
    for middle, text in zip(_cumulative_middles(plan), printed.angles, strict=True):
        angles.append(Cell(middle, text, printed.angle_erratum))
    rows = []
    for angle, outcome, texts in zip(angles, plan.outcomes(), printed.rows, strict=True):
        hyperstate = outcome.hyperstate()
        widths = dict(zip(hyperstate.orientations, hyperstate.widths, strict=True))
        cells = (
            Cell(Probability(widths.get(state, ZERO)), text, None)
            for state, text in zip(states, texts, strict=True)
        )
        rows.append(EvolutionRow(angle, tuple(cells)))
    costs: list[Cell | Shown] = []
    for steps in range(1, plan.steps + 1):
        cost, price = problem.expected_cost(steps), printed.costs.get(steps)
        costs.append(cost if price is None else Cell(cost, price, printed.cost_erratum))
    return Evolution(printed.figure, plan, tuple(states), tuple(rows), tuple(costs))


def _cumulative_middles(plan: FeedingPlan) -> list[HalfAngle]:
    """Return the sums of the middles of the ranges, each in (-180, 180] degrees."""
    ends = [a.low + a.high for a in plan.actions if a.low is not None and a.high is not None]
    return [HalfAngle(_centred(total)) for total in accumulate(ends)]


def _centred(doubled: Angle) -> Angle:
    rest = doubled % (2 * FULL_TURN)
    return rest if rest <= FULL_TURN else rest - 2 * FULL_TURN
