"""Certificates: a plan and everything that proves it, as a document anyone can check.

The schema ``stochgeom/certificate/1`` holds no decimal and no checksum: every field is an exact
claim, and `stochgeom.feeding.certificate_checker`, a single file that shares nothing with the
planner, computes each one anew. Parts over a field have ``stochgeom/certificate/2``, which
`stochgeom.feeding.field_certificate_checker` checks.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final, Protocol

import numpy as np
from gmpy2 import mpq

from stochgeom.errors import InputError
from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.scalars import rational_text
from stochgeom.feeding.actions import Action
from stochgeom.feeding.certified_transfer import (
    CERTIFIED_ACTIONS,
    angle_claim,
    hull_numbers,
    part_claims,
    transfer_claims,
)
from stochgeom.feeding.preimages import Preimage, Preimages
from stochgeom.geometry.part import Part
from stochgeom.transfer.step_function import StepFunction

SCHEMA: Final = "stochgeom/certificate/1"

FIELD_SCHEMA: Final = "stochgeom/certificate/2"
"""That of parts over a real algebraic field."""

Json = dict[str, Any]


class CertifiablePlan(Protocol):
    """What a certificate needs of a plan, such as `stochgeom.feeding.plans.FeedingPlan`."""

    transfer: StepFunction
    cost_ratio: mpq
    part: Part | None
    action_name: str

    @property
    def prior(self) -> object | None:
        """What is known of the orientations before the first action; None if nothing is."""

    @property
    def preimages(self) -> tuple[Preimage, ...]:
        """The preimages of 1, 2, ..., k steps."""

    @property
    def steps(self) -> int:
        """The number of actions."""

    @property
    def mouth(self) -> Arc:
        """The orientations that are collapsed."""

    @property
    def actions(self) -> tuple[Action, ...]:
        """The actions with their ranges."""

    @property
    def final_orientation(self) -> Angle:
        """Where the mouth ends up."""


def certificate(plan: CertifiablePlan) -> Json:
    """Return the certificate of a plan of squeezes or push-grasps.

    Runs phase I on to a whole period, since the cost of every plan length is compared. That of a
    push-grasp plan states the centre of mass, be it given or the centroid, as part of what is
    given: the checker takes it as it is.

    Parameters
    ----------
    plan : FeedingPlan
        For a part that arrives in any orientation, all equally likely. A goal or a gripper error
        may have been asked for, if the plan is the same without: no plan of an exact gripper with
        any final orientation is better, so none with this goal or error is. Where the plan ends is
        a claim, and the ranges are, from which the error follows that the plan bears; neither the
        goal nor the error is written down.

    Returns
    -------
    dict
        Plain JSON values, the schema ``stochgeom/certificate/1``, or 2 for a part over a field.

    Raises
    ------
    InputError
        If the plan has no part or another action, if its transfer function is not what this action
        does to the part, or if its mouths are not the widest: because of a prior, a goal or an
        error of the gripper.

    Examples
    --------
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> document = certificate(plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> document["optimal_steps"], [cost["comparison"] for cost in document["costs"]]
    (2, [1, 0])
    """
    part, action, transfer = plan.part, plan.action_name, plan.transfer
    if part is None or action not in CERTIFIED_ACTIONS:
        raise InputError(
            f"certificates need a part and the action {' or '.join(CERTIFIED_ACTIONS)}"
        )
    chain = list(Preimages(transfer))
    if plan.prior is not None:
        raise InputError(
            "this plan is for a prior; accepted: plans for parts that arrive in any orientation, "
            "all equally likely"
        )
    if _steps(plan.preimages) != _steps(chain[: plan.steps]):
        raise InputError(
            "a goal or an inexact gripper makes this another plan than the one for any final "
            "orientation and an exact gripper; accepted: plans that are the same with and without"
        )
    optimal, costs = _costs(chain, plan)
    return {
        "schema": SCHEMA if part.field is None else FIELD_SCHEMA,
        "action": action,
        "part": part_claims(part, action),
        "hull": hull_numbers(part),
        **transfer_claims(part, transfer, action),
        "preimages": [
            _preimage(preimage, before, transfer)
            for before, preimage in zip([None, *chain], chain, strict=False)
        ],
        "cost_ratio": rational_text(plan.cost_ratio),
        "costs": costs,
        "optimal_steps": optimal,
        "plan": _plan(plan, optimal, len(chain)),
    }


def _steps(chain: Sequence[Preimage]) -> list[tuple[int, int]]:
    """Return what tells chains of preimages apart."""
    return [(preimage.first, preimage.last) for preimage in chain]


def _preimage(preimage: Preimage, before: Preimage | None, transfer: StepFunction) -> Json:
    first, last = preimage.first, preimage.last
    rival = _rival(before.width if before else None, first, transfer)
    return {
        "steps": preimage.steps,
        "first": first,
        "last": last,
        "start": angle_claim(preimage.arc.start),
        "width": angle_claim(preimage.width),
        "image_start": angle_claim(preimage.image.start),
        "image_width": angle_claim(preimage.image_width),
        "rival": rival,
    }


def _rival(limit: Angle | None, winner: int, transfer: StepFunction) -> Json | None:
    """Return the best of the starts that lost, by the same rules."""
    starts = np.flatnonzero(np.arange(len(transfer)) != winner)
    if not len(starts):
        return None
    breaks, values = transfer.lifted_breaks, transfer.lifted_values
    last = np.arange(len(transfer)) if limit is None else values.last_below(limit)
    widest = starts[breaks.widest(starts, last[starts] + 1)]
    best = min(widest.tolist(), key=lambda k: (values[int(last[k])] - values[k], k))
    return {"first": best, "width": angle_claim(breaks[int(last[best]) + 1] - breaks[best])}


def _costs(chain: list[Preimage], plan: CertifiablePlan) -> tuple[int, list[Json]]:
    """Return the best number of steps, and how each length's cost compares with it."""
    costs = [TurnRatio(p.steps + plan.cost_ratio, p.width, inverse=True) for p in chain]
    best = 0
    for k, cost in enumerate(costs):
        if cost < costs[best]:
            best = k
    rows = [
        {
            "numerator": rational_text(preimage.steps + plan.cost_ratio),
            "comparison": cost.compare(costs[best]),
        }
        for preimage, cost in zip(chain, costs, strict=True)
    ]
    return best + 1, rows


def _plan(plan: CertifiablePlan, optimal: int, longest: int) -> Json:
    return {
        "steps": plan.steps,
        "mouth": {"start": angle_claim(plan.mouth.start), "width": angle_claim(plan.mouth.width)},
        "actions": [
            {
                "angle": angle_claim(action.angle),
                "low": None if action.low is None else angle_claim(action.low),
                "high": None if action.high is None else angle_claim(action.high),
            }
            for action in plan.actions
        ],
        "final_orientation": angle_claim(plan.final_orientation),
        "optimal": plan.steps == optimal,
        "orients_up_to_symmetry": plan.steps == longest,
    }
