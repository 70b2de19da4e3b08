"""Evolutions of a distribution under a plan, computed beside what a figure prints.

How the source prints: states by increasing angle of the jaws in the part's frame, which is
decreasing theta here; gripper angles from the first action on, each increment the middle of the
range of its action.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate
from typing import final

from gmpy2 import mpq

from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.balls import Ball
from stochgeom.exact.decimals import certified_decimal, rational_decimal
from stochgeom.exact.ratios import TurnRatio
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.thesis.errata import Erratum
from stochgeom.thesis.tables import Cell, Shown


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
    cells : tuple of Cell or Shown
        The probability of each state; a cell where it is printed.
    """

    angle: Cell | None
    cells: tuple[Cell | Shown, ...]


@final
@dataclass(frozen=True, slots=True)
class Evolution:
    """A plan and what it makes of the distribution, computed and printed.

    Attributes
    ----------
    figure : str
        Its number, such as ``"E.5"``.
    plan : FeedingPlan
        The plan that the figure shows.
    orientations : tuple of Angle
        The states, in the printed order.
    rows : tuple of EvolutionRow
        One for each action.
    costs : tuple of Cell or Shown
        Expected costs of the best plans of 1, 2, ... steps, filter cost 1; a cell where a cost is
        printed.
    rounds : tuple of Cell
        Mean numbers of rounds of these plans, from one step on, as far as they are printed.
    """

    figure: str
    plan: FeedingPlan
    orientations: tuple[Angle, ...]
    rows: tuple[EvolutionRow, ...]
    costs: tuple[Cell | Shown, ...]
    rounds: tuple[Cell, ...] = ()

    @property
    def cells(self) -> tuple[Cell, ...]:
        """Everything that is printed."""
        found = [row.angle for row in self.rows if row.angle is not None]
        entries = [*(entry for row in self.rows for entry in row.cells), *self.costs]
        found += [entry for entry in entries if isinstance(entry, Cell)]
        return (*found, *self.rounds)


@final
@dataclass(frozen=True, slots=True)
class PrintedEvolution:
    """What a figure prints.

    Attributes
    ----------
    figure : str
        Its number.
    first : int
        Which state is printed first, by decreasing theta, from 0.
    angles : tuple of str
        Gripper angles of the second action and those that follow, from the first one on.
    rows : tuple of tuple of str
        The distribution after each action; empty where a probability is not printed.
    costs : dict of int to str
        The costs that are printed, by number of steps.
    angle_erratum, cost_erratum : Erratum or None
        Why these do not hold.
    rounds : tuple of str
        Mean numbers of rounds of the plans of one step, two steps and so on.
    """

    figure: str
    first: int
    angles: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    costs: dict[int, str]
    angle_erratum: Erratum | None = None
    cost_erratum: Erratum | None = None
    rounds: tuple[str, ...] = ()


def evolution(
    printed: PrintedEvolution, problem: FeedingProblem, plan: FeedingPlan | None = None
) -> Evolution:
    """Return the evolution under a plan (default: the shortest one up to symmetry)."""
    plan = problem.geometric_plan() if plan is None else plan
    transfer = problem.transfer
    states = sorted(
        (
            (value + transfer.period * k) % FULL_TURN
            for value in transfer.values
            for k in range(transfer.order)
        ),
        reverse=True,
    )
    states = states[printed.first :] + states[: printed.first]
    angles: list[Cell | None] = [None]
    for middle, text in zip(_cumulative_middles(plan), printed.angles, strict=True):
        angles.append(Cell(middle, text, printed.angle_erratum))
    rows = []
    for angle, outcome, texts in zip(angles, plan.outcomes(), printed.rows, strict=True):
        hyperstate = outcome.hyperstate()
        widths = dict(zip(hyperstate.orientations, hyperstate.widths, strict=True))
        cells = (
            _beside(Probability(widths.get(state, ZERO)), text)
            for state, text in zip(states, texts, strict=True)
        )
        rows.append(EvolutionRow(angle, tuple(cells)))
    costs: list[Cell | Shown] = []
    for steps in range(1, plan.steps + 1):
        cost, price = problem.expected_cost(steps), printed.costs.get(steps)
        costs.append(_beside(cost, price, printed.cost_erratum))
    rounds = tuple(
        Cell(TurnRatio(mpq(1), preimage.width, inverse=True), text, None)
        for preimage, text in zip(problem.preimages, printed.rounds, strict=False)
    )
    return Evolution(printed.figure, plan, tuple(states), tuple(rows), tuple(costs), rounds)


def _beside(number: Shown, printed: str | None, erratum: Erratum | None = None) -> Cell | Shown:
    """Return a cell where something is printed, and otherwise the number alone."""
    return Cell(number, printed, erratum) if printed else number


def _cumulative_middles(plan: FeedingPlan) -> list[HalfAngle]:
    """Return the sums of the middles of the ranges, each in (-180, 180] degrees."""
    ends = [a.low + a.high for a in plan.actions if a.low is not None and a.high is not None]
    return [HalfAngle(_centred(total)) for total in accumulate(ends)]


def _centred(doubled: Angle) -> Angle:
    rest = doubled % (2 * FULL_TURN)
    return rest if rest <= FULL_TURN else rest - 2 * FULL_TURN
