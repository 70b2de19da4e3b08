"""A part as a planning problem: the five-tuple of thesis 4.4.3 to 4.4.5.

The states are the stable orientations over a full turn. The prior is what a random first action
leaves: state j has the width of its step as probability, an exact angle sum and in general no
rational number. The actions are the classes of equivalent actions, at most m^2 for m states of one
period; their matrices have entries 0 and 1. So exact hyperstates need no more than sums of the
prior's numbers.

Aliasing: angles alpha and alpha + T do the same but for a shift of all states by a period T. With
one period of angles all that can be reached up to that symmetry is reached; an action of another
period matters only to costs that tell equivalent orientations apart.
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, final

from stochgeom.arguments import expect
from stochgeom.decision.planning_problem import Cost, PlanningProblem
from stochgeom.errors import InputError, ProblemError
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.sums import AngleSum
from stochgeom.feeding.action_classes import ActionClass, action_classes
from stochgeom.feeding.problem import TRANSFER_FUNCTIONS
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from stochgeom.decision.priors import Prior
    from stochgeom.exact.sums import Probability


@final
@dataclass(frozen=True)
class OrientingProblem:
    """A part's planning problem, and what its labels stand for.

    Attributes
    ----------
    problem : PlanningProblem
        States and actions are labelled by their angles in degrees, ``"33.6901"``, with as many
        decimals as tell them apart.
    transfer : StepFunction
        What one action does.
    orientations : dict from state labels to Angle
        The stable orientations in [0, 360) degrees, increasing.
    classes : dict from action labels to ActionClass
        The first class with the action's effect; its representative is the label.
    turns : dict from action labels to Angle
        What has to be added to the angles of the class: whole periods.
    """

    problem: PlanningProblem
    transfer: StepFunction
    orientations: dict[Hashable, Angle]
    classes: dict[Hashable, ActionClass]
    turns: dict[Hashable, Angle]

    def angle(self, action: Hashable) -> Angle:
        """Return the representative angle of an action: relative to the gripper's last pose."""
        self.problem.action_number(action)
        return self.classes[action].angle + self.turns[action]


def planning_problem_of(
    part: PartLike,
    action: str = "squeeze",
    cost: Cost | None = None,
    *,
    prior: Prior | None = None,
    all_periods: bool = False,
) -> OrientingProblem:
    """Return the planning problem of orienting a part.

    Parameters
    ----------
    part : Part, or its vertices
        What is oriented.
    action : str, default "squeeze"
        What the gripper does: ``"squeeze"`` or ``"push-grasp"``.
    cost : PlanCost, optional
        What plans are compared by.
    prior : Prior, optional
        Of the orientations before the first action, which is then made at angle 0. Default: any
        orientation alike, or a first action at a random angle. Its masses must be exact.
    all_periods : bool, default False
        Whether there are actions for the angles of a full turn, not only of one period.

    Raises
    ------
    InputError
        For an action that is none.
    ProblemError
        If a mass of the prior is not exact.

    Notes
    -----
    The first, random action is part of the prior: a plan of the problem with k actions stands for
    one of k + 1 steps of `plan_feeding`.

    Examples
    --------
    >>> found = planning_problem_of([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> found.problem.states
    ('0.0000', '90.0000', '180.0000', '270.0000')
    >>> found.problem.actions
    ('0.0000', '45.0000', '90.0000', '135.0000')
    >>> [str(p) for p in found.problem.prior]
    ['0.3128', '0.1872', '0.3128', '0.1872']
    """
    if action not in sorted(TRANSFER_FUNCTIONS):  # a list, as what is given may not be hashable
        raise InputError(
            f"action {action!r:.60}; accepted: {', '.join(sorted(TRANSFER_FUNCTIONS))}"
        )
    shape = as_part(part)
    return planning_problem_of_transfer(
        TRANSFER_FUNCTIONS[action](shape),
        cost,
        prior=prior,
        all_periods=all_periods,
        name=shape.name,
    )


def planning_problem_of_transfer(
    transfer: StepFunction,
    cost: Cost | None = None,
    *,
    prior: Prior | None = None,
    all_periods: bool = False,
    name: str | None = None,
) -> OrientingProblem:
    """Return the planning problem of any monotone step map; see `planning_problem_of`.

    Examples
    --------
    >>> s = StepFunction([Angle.from_degrees(d) for d in (0, 100)], [Angle(), Angle(0, (0, 1))])
    >>> planning_problem_of_transfer(s).problem.prior
    (mpq(5,18), mpq(13,18))
    """
    steps, order = len(transfer), transfer.order
    places = [(j, lap) for lap in range(order) for j in range(steps)]
    where = [(transfer.values[j] + transfer.period * lap) % FULL_TURN for j, lap in places]
    by_angle = sorted(range(len(places)), key=where.__getitem__)
    rank = {state: place for place, state in enumerate(by_angle)}
    angles = [where[state] for state in by_angle]
    labels = _told_apart(angles)

    found: dict[tuple[int, ...], tuple[ActionClass, Angle]] = {}
    for lap in range(order if all_periods else 1):
        for each in action_classes(transfer):
            targets = each.targets_on(order)
            # A gripper turned by whole periods more sees every state so many periods before.
            shifted = [(k - lap * steps) % len(places) for k in targets]
            key = tuple(rank[shifted[state]] for state in by_angle)
            found.setdefault(key, (each, transfer.period * lap))
    actions = _told_apart([each.angle + turn for each, turn in found.values()])
    problem = PlanningProblem(
        labels,
        _prior(transfer, prior, [places[state] for state in by_angle]),
        actions,
        [[{labels[target]: 1} for target in targets] for targets in found],
        cost,
        name=name,
    )
    return OrientingProblem(
        problem,
        transfer,
        dict(zip(labels, angles, strict=True)),
        {label: each for label, (each, _) in zip(actions, found.values(), strict=True)},
        {label: turn for label, (_, turn) in zip(actions, found.values(), strict=True)},
    )


def _prior(transfer: StepFunction, prior: Prior | None, places: list[tuple[int, int]]) -> list[Any]:
    """Return the probability of each state after the first action, rational if all are."""
    if prior is not None:
        from stochgeom.decision.priors import Prior  # loaded for those who use one

        expect(prior, Prior, "a prior, such as DiscretePrior.from_measurements(degrees)", "prior")
    masses: list[Probability] = []
    for j, lap in places:
        arc = Arc(transfer.breaks[j] + transfer.period * lap, transfer.widths[j])
        masses.append(AngleSum(0, [(1, arc.width)]) if prior is None else prior.mass(arc))
    for mass in masses:
        if not mass.exact:
            raise ProblemError(
                f"the prior's probability {mass.decimal(4)} is not exact; accepted: uniform, "
                "discrete, piecewise constant and mixtures of them",
                where="prior",
            )
    exact = [mass.rational for mass in masses]
    return list(masses) if None in exact else exact


def _told_apart(angles: list[Angle]) -> list[str]:
    """Return different angles in degrees, with as many decimals as make them different."""
    digits = 4
    while True:
        texts = [angle.degrees(digits) for angle in angles]
        if len(set(texts)) == len(texts):
            return texts
        digits *= 2
