"""Certificates: a plan and everything that proves it, as a document anyone can check.

The schema ``stochgeom/certificate/1`` holds no decimal and no checksum: every field is an exact
claim, and `stochgeom.feeding.certificate_checker`, a single file that shares nothing with the
planner, computes each one anew.
"""

from __future__ import annotations

from typing import Any, Final, Protocol

import numpy as np
from gmpy2 import mpq

from stochgeom.errors import InputError
from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.scalars import rational_text
from stochgeom.feeding.actions import Action
from stochgeom.feeding.preimages import Preimage, Preimages
from stochgeom.geometry.calipers import NO_EDGE
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.transfer.step_function import StepFunction

SCHEMA: Final = "stochgeom/certificate/1"

Json = dict[str, Any]


class CertifiablePlan(Protocol):
    """What a certificate needs of a plan, such as `stochgeom.feeding.plans.FeedingPlan`."""

    transfer: StepFunction
    cost_ratio: mpq
    part: Part | None
    action_name: str

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
    """Return the certificate of a squeeze plan.

    Runs phase I on to a whole period, since the cost of every plan length is compared.

    Raises
    ------
    InputError
        If the plan has no part, or another action than squeezing.

    Examples
    --------
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> document = certificate(plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> document["optimal_steps"], [cost["comparison"] for cost in document["costs"]]
    (2, [1, 0])
    """
    if plan.part is None or plan.action_name != "squeeze":
        raise InputError("certificates need a part and the action squeeze")
    diameter, transfer = DiameterFunction(plan.part), plan.transfer
    chain = list(Preimages(transfer))
    optimal, costs = _costs(chain, plan)
    return {
        "schema": SCHEMA,
        "action": plan.action_name,
        "part": {
            "name": plan.part.name,
            "vertices": [[rational_text(x), rational_text(y)] for x, y in plan.part.vertices],
        },
        "hull": _hull_numbers(plan.part),
        "period": _angle(transfer.period),
        "breaks": _breaks(diameter, len(transfer), plan.part),
        "values": _values(diameter, transfer, plan.part),
        "preimages": [
            _preimage(preimage, before, transfer)
            for before, preimage in zip([None, *chain], chain, strict=False)
        ],
        "cost_ratio": rational_text(plan.cost_ratio),
        "costs": costs,
        "optimal_steps": optimal,
        "plan": _plan(plan, optimal, len(chain)),
    }


def _angle(angle: Angle) -> Json:
    x, y = angle.direction
    return {"turns": int(angle.turn_part), "direction": [rational_text(x), rational_text(y)]}


def _first_numbers(part: Part) -> list[int]:
    """Return for each hull vertex the first vertex of the outline at its point."""
    first: dict[object, int] = {}
    for k, vertex in enumerate(part.vertices):
        first.setdefault(vertex, k)
    return [first[part.vertices[int(k)]] for k in part.hull.indices]


def _hull_numbers(part: Part) -> list[int]:
    numbers = _first_numbers(part)
    start = numbers.index(min(numbers))
    return numbers[start:] + numbers[:start]


def _breaks(diameter: DiameterFunction, count: int, part: Part) -> list[Json]:
    """Return the maxima of one period with the antipodal vertices that touch the jaws."""
    numbers, calipers, maxima = _first_numbers(part), diameter.calipers, diameter.unstable
    rows = []
    for k, piece in enumerate(maxima.places[:count].tolist()):
        angle = maxima.angles[k]
        jaws = [numbers[calipers.lower[piece]]], [numbers[calipers.upper[piece]]]
        # A maximum of the last piece beyond 180 degrees is listed half a turn before.
        lower, upper = jaws if angle > diameter.transitions[piece] else jaws[::-1]
        rows.append({"angle": _angle(angle), "lower": lower, "upper": upper})
    return rows


def _values(diameter: DiameterFunction, transfer: StepFunction, part: Part) -> list[Json]:
    """Return the minima that follow the breaks of one period, with the flush edge."""
    stable = diameter.stable
    # Minima and maxima alternate; the first break may be followed by the second minimum.
    shift = int(stable.angles[0] < transfer.breaks[0])
    rows = []
    for k, angle in enumerate(transfer.values):
        lap, place = divmod(k + shift, len(stable.angles))
        lower, upper = _jaws(diameter, int(stable.places[place]), part)
        if lap:  # half a turn on, the jaws are exchanged, and left and right as well
            lower, upper = upper[::-1], lower[::-1]
        rows.append({"angle": _angle(angle), "lower": lower, "upper": upper})
    return rows


def _jaws(diameter: DiameterFunction, place: int, part: Part) -> tuple[list[int], list[int]]:
    """Return the vertices on both jaws at a transition, from left to right."""
    numbers, calipers = _first_numbers(part), diameter.calipers
    # An edge on the lower jaw is touched at its right end before and at its left end after.
    lower = [numbers[calipers.lower[place]], numbers[calipers.lower_before[place]]]
    upper = [numbers[calipers.upper_before[place]], numbers[calipers.upper[place]]]
    return (
        lower if calipers.lower_edge[place] != NO_EDGE else lower[:1],
        upper if calipers.upper_edge[place] != NO_EDGE else upper[:1],
    )


def _preimage(preimage: Preimage, before: Preimage | None, transfer: StepFunction) -> Json:
    first, last = preimage.first, preimage.last
    rival = _rival(before.width if before else None, first, transfer)
    return {
        "steps": preimage.steps,
        "first": first,
        "last": last,
        "start": _angle(preimage.arc.start),
        "width": _angle(preimage.width),
        "image_start": _angle(preimage.image.start),
        "image_width": _angle(preimage.image_width),
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
    return {"first": best, "width": _angle(breaks[int(last[best]) + 1] - breaks[best])}


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
        "mouth": {"start": _angle(plan.mouth.start), "width": _angle(plan.mouth.width)},
        "actions": [
            {
                "angle": _angle(action.angle),
                "low": None if action.low is None else _angle(action.low),
                "high": None if action.high is None else _angle(action.high),
            }
            for action in plan.actions
        ],
        "final_orientation": _angle(plan.final_orientation),
        "optimal": plan.steps == optimal,
        "orients_up_to_symmetry": plan.steps == longest,
    }
