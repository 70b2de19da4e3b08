"""Feeding plans as JSON documents: the schema ``stochgeom/plan/1``.

Exact numbers are text, integers as ``"3"`` and rationals as ``"p/q"``; decimals beside them are
correctly rounded. An angle is its canonical form plus degrees. Numbers of a part over a field are
expressions such as ``"1/2*sqrt(3)"``, or in g and s as the part's key ``field`` explains.
"""

from __future__ import annotations

from typing import Any, Final

from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.scalars import rational_text
from stochgeom.exact.surds import scalar_text
from stochgeom.feeding.gripper_error import ErrorBound
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import Preimage
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.geometry.points import Point

SCHEMA: Final = "stochgeom/plan/1"

Json = dict[str, Any]


def plan_document(
    problem: FeedingProblem, plan: FeedingPlan, geometric: FeedingPlan | None, digits: int = 4
) -> Json:
    """Return the document of a planned part: transfer function, preimages and both plans.

    ``geometric`` is None where no plan orients the part with the gripper's error. What was asked
    for beyond the defaults (prior, gripper error, goal) is added under keys of its own.

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
        "part": None if problem.part is None else part_json(problem.part),
        "transfer": {
            "action": problem.action,
            "period": angle_json(transfer.period, digits),
            "breaks": [angle_json(angle, digits) for angle in transfer.breaks],
            "values": [angle_json(angle, digits) for angle in transfer.values],
        },
        "cost_ratio": rational_text(plan.cost_ratio),
        **_asked(problem, digits),
        "preimages": [
            _preimage_json(preimage, problem, plan, digits)
            for preimage in problem.preimages.found()
        ],
        "plan": plan_json(plan, digits),
        "geometric_plan": None if geometric is None else plan_json(geometric, digits),
    }


def _asked(problem: FeedingProblem, digits: int) -> Json:
    """Return the prior, the gripper error and the goal where they are not the defaults."""
    asked: Json = {}
    if problem.prior is not None:
        asked["prior"] = problem.prior.describe()
    if problem.gripper_error is not None:
        bound = problem.largest_gripper_error()
        asked["gripper_error"] = angle_json(problem.gripper_error, digits)
        asked["largest_gripper_error"] = None if bound is None else _bound_json(bound, digits)
    if problem.final_steps is not None:
        values = problem.transfer.values
        asked["goal"] = [
            angle_json(values[k] % problem.transfer.period, digits) for k in problem.final_steps
        ]
    return asked


def _bound_json(bound: ErrorBound, digits: int) -> Json:
    """Return twice the bound, exact, and the bound in degrees, rounded down; not attained."""
    return {"doubled": angle_json(bound.slack, digits), "degrees": bound.decimal(digits)}


def part_json(part: Part) -> Json:
    """Return name, vertices and centre of mass of a part (and its holes, if any)."""
    document: Json = {
        "name": part.name,
        "vertices": [_point_json(vertex) for vertex in part.vertices],
        "center_of_mass": _point_json(part.center_of_mass),
    }
    field = part.field
    if field is not None:
        document["field"] = field.description()
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
        "direction": [scalar_text(x), scalar_text(y)],
        "degrees": angle.degrees(digits),
    }


def plan_json(plan: FeedingPlan, digits: int = 4) -> Json:
    """Return a plan with its actions, mouth, worth, and what it bears of gripper error.

    ``margin`` is that of the nominal angles, ``error_bound`` that of the middles of the ranges.
    """
    bound = plan.error_bound
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
        "margin": None if plan.margin is None else angle_json(plan.margin, digits),
        "error_bound": None if bound is None else _bound_json(bound, digits),
    }


def _preimage_json(
    preimage: Preimage, problem: FeedingProblem, plan: FeedingPlan, digits: int
) -> Json:
    caught = problem.placement(preimage.steps) is not None
    cost = problem.expected_cost(preimage.steps, plan.cost_ratio) if caught else None
    return {
        "steps": preimage.steps,
        **_arc_json(preimage.arc, digits),
        "image_width": angle_json(preimage.image_width, digits),
        "expected_cost": None if cost is None else cost.decimal(digits),
        "probability": problem.probability(preimage.steps).decimal(digits) if caught else "0",
    }


def _arc_json(arc: Arc, digits: int) -> Json:
    return {"start": angle_json(arc.start, digits), "width": angle_json(arc.width, digits)}


def _point_json(point: Point) -> list[str]:
    return [scalar_text(point[0]), scalar_text(point[1])]
