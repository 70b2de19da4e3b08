"""Feeding plans as JSON documents: the schema ``stochgeom/plan/1``.

Exact numbers are text, integers as ``"3"`` and rationals as ``"p/q"``; decimals beside them are
correctly rounded. An angle is its canonical form plus degrees.
"""

from __future__ import annotations

from typing import Any, Final

from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.scalars import rational_text
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import Preimage
from stochgeom.geometry.part import Part
from stochgeom.geometry.points import Point

SCHEMA: Final = "stochgeom/plan/1"

Json = dict[str, Any]


def plan_document(
    problem: FeedingProblem, plan: FeedingPlan, geometric: FeedingPlan, digits: int = 4
) -> Json:
    """Return the document of a planned part: transfer function, preimages and both plans.

    Examples
    --------
    >>> problem = FeedingProblem([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> document = plan_document(problem, problem.optimal_plan(), problem.geometric_plan())
    >>> document["plan"]["expected_cost"], document["plan"]["mouth"]["width"]["degrees"]
    ('6.0000', '180.0000')
    """
    transfer = problem.transfer
    return {
        "schema": SCHEMA,
        "part": part_json(problem.part),
        "transfer": {
            "action": problem.action,
            "period": angle_json(transfer.period, digits),
            "breaks": [angle_json(angle, digits) for angle in transfer.breaks],
            "values": [angle_json(angle, digits) for angle in transfer.values],
        },
        "cost_ratio": rational_text(plan.cost_ratio),
        "preimages": [
            _preimage_json(preimage, problem, plan, digits)
            for preimage in problem.preimages.found()
        ],
        "plan": plan_json(plan, digits),
        "geometric_plan": plan_json(geometric, digits),
    }


def part_json(part: Part) -> Json:
    """Return name, vertices and centre of mass of a part (and its holes, if any)."""
    document: Json = {
        "name": part.name,
        "vertices": [_point_json(vertex) for vertex in part.vertices],
        "center_of_mass": _point_json(part.center_of_mass),
    }
    if part.holes:
        document["holes"] = [[_point_json(vertex) for vertex in hole] for hole in part.holes]
    return document


def angle_json(angle: Angle, digits: int = 4) -> Json:
    """Return an angle as its canonical parts and degrees.

    Examples
    --------
    >>> angle_json(Angle(0, (3, 2)))
    {'turns': 0, 'direction': ['3', '2'], 'degrees': '33.6901'}
    >>> angle_json(Angle("1/3"), 1)
    {'turns': '1/3', 'direction': ['1', '0'], 'degrees': '120.0'}
    """
    turns = angle.turn_part
    x, y = angle.direction
    return {
        "turns": int(turns) if turns.denominator == 1 else rational_text(turns),
        "direction": [rational_text(x), rational_text(y)],
        "degrees": angle.degrees(digits),
    }


def plan_json(plan: FeedingPlan, digits: int = 4) -> Json:
    """Return a plan with its actions, mouth and worth."""
    return {
        "steps": plan.steps,
        "actions": [
            {
                "angle": angle_json(action.angle, digits),
                "low": None if action.low is None else angle_json(action.low, digits),
                "high": None if action.high is None else angle_json(action.high, digits),
            }
            for action in plan.actions
        ],
        "mouth": _arc_json(plan.mouth, digits),
        "expected_cost": plan.expected_cost.decimal(digits),
        "probability": plan.probability.decimal(digits),
        "expected_cost_up_to_symmetry": plan.expected_cost_up_to_symmetry.decimal(digits),
        "probability_up_to_symmetry": plan.probability_up_to_symmetry.decimal(digits),
        "orients_up_to_symmetry": plan.orients_up_to_symmetry,
    }


def _preimage_json(
    preimage: Preimage, problem: FeedingProblem, plan: FeedingPlan, digits: int
) -> Json:
    cost = TurnRatio(preimage.steps + plan.cost_ratio, preimage.width, inverse=True)
    return {
        "steps": preimage.steps,
        **_arc_json(preimage.arc, digits),
        "image_width": angle_json(preimage.image_width, digits),
        "expected_cost": cost.decimal(digits),
        "probability": problem.probability(preimage.steps).decimal(digits),
    }


def _arc_json(arc: Arc, digits: int) -> Json:
    return {"start": angle_json(arc.start, digits), "width": angle_json(arc.width, digits)}


def _point_json(point: Point) -> list[str]:
    return [rational_text(point[0]), rational_text(point[1])]
