"""Grasps with friction as JSON documents: the schema ``stochgeom/grasp/1``.

Exact numbers are text beside correctly rounded decimals, as in ``stochgeom/plan/1``. A tolerance
may be half of an angle that has no exact half: then ``turns`` and ``direction`` are null, and
``doubled`` is exact all the same. Tolerances are rounded down.
"""

from __future__ import annotations

from typing import Any, Final

from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.cells import CellSet
from stochgeom.exact.decimals import Rounding
from stochgeom.exact.halves import HalfAngle
from stochgeom.exact.intervals import Interval
from stochgeom.exact.scalars import rational_text
from stochgeom.grasping.grasp_diagram import GraspDiagram, GraspTolerance
from stochgeom.grasping.grasp_report import GraspReport
from stochgeom.grasping.push_stability import PushStability
from stochgeom.io.plan_json import angle_json, part_json

SCHEMA: Final = "stochgeom/grasp/1"

Json = dict[str, Any]


def grasp_document(report: GraspReport, digits: int = 4) -> Json:
    """Return the document of a part grasped with friction.

    Examples
    --------
    >>> square = GraspReport([(0, 0), (1, 0), (1, 1), (0, 1)], "0.25")
    >>> document = grasp_document(square)
    >>> document["mu"], document["bound"], document["largest_tolerance"]["degrees"]
    ('1/4', '0.6881', '30.9637')
    """
    diagram = report.diagram
    best = report.tolerances
    document: Json = {
        "schema": SCHEMA,
        "part": part_json(diagram.part),
        "mu": _mu_json(diagram),
        "friction_angle": angle_json(diagram.friction.angle, digits),
        "push": {push.jaw.value: _push_json(push, digits) for push in diagram.jaws},
        "stable": _stable_json(report, digits),
        "wedged": [
            {**_arc_json(wedge.arc, digits), "vertices": list(wedge.vertices)}
            for wedge in diagram.wedging
        ],
        **_set_json("strong_preimage", diagram.guaranteed, digits),
        "bound": diagram.bound.decimal(digits),
        "bound_angle": angle_json(_total_width(diagram.guaranteed), digits),
        "strict_bound": diagram.strict_bound.decimal(digits),
        "pushing_bound": report.pushing_bound.decimal(digits),
        "largest_tolerance": _tolerance_json(best[0], digits) if best else None,
        "grasp_angle": half_json(best[0].grasp_angle, digits) if best else None,
        "grasp_angles": [half_json(item.grasp_angle, digits) for item in best],
    }
    if report.prior is not None:
        document["prior"] = report.prior.describe()
        document["prior_bound"] = report.prior_bound.decimal(digits)
    if report.tolerance is not None:
        document["tolerance"] = {
            "asked": angle_json(report.tolerance, digits),
            "guaranteed": bool(report.grasps),
            **_set_json("grasps", report.grasps, digits),
        }
    if report.probability is not None:
        document["largest_mu"] = _largest_json(report, digits)
    return document


def _mu_json(diagram: GraspDiagram) -> str:
    mu = diagram.friction.coefficient
    return diagram.friction.decimal(16) if mu is None else rational_text(mu)


def _push_json(push: PushStability, digits: int) -> Json:
    return {
        "stable": [angle_json(theta, digits) for theta in push.stable],
        "unstable": [angle_json(theta, digits) for theta in push.unstable],
    }


def _stable_json(report: GraspReport, digits: int) -> list[Json]:
    return [
        {
            "orientation": angle_json(edge.orientation, digits),
            "lower_edge": None if edge.lower_edge is None else list(edge.lower_edge),
            "upper_edge": None if edge.upper_edge is None else list(edge.upper_edge),
            "by_friction": edge.by_friction,
            "pushing_bound": bound.decimal(digits),
        }
        for edge, bound in report.pushing_bounds
    ]


def _set_json(name: str, cells: CellSet, digits: int) -> Json:
    """Return the intervals of positive width, and the single orientations apart."""
    found = cells.intervals()
    return {
        name: [_interval_json(item, digits) for item in found if item.width],
        f"{name}_points": [angle_json(item.start, digits) for item in found if not item.width],
    }


def _interval_json(item: Interval, digits: int) -> Json:
    return {
        "start": angle_json(item.start, digits),
        "width": angle_json(item.width, digits),
        "includes_start": item.includes_start,
        "includes_end": item.includes_end,
    }


def _arc_json(arc: Arc, digits: int) -> Json:
    return {"start": angle_json(arc.start, digits), "width": angle_json(arc.width, digits)}


def _total_width(cells: CellSet) -> Angle:
    total = ZERO
    for item in cells.intervals():
        total += item.width
    return total


def _tolerance_json(best: GraspTolerance, digits: int) -> Json:
    return {**half_json(best.margin, digits, Rounding.DOWN), "attained": best.attained}


def half_json(half: HalfAngle, digits: int = 4, rounding: Rounding = Rounding.NEAREST) -> Json:
    """Return half of an angle: its own parts if it has any, its degrees, its exact double.

    Examples
    --------
    >>> half_json(HalfAngle(Angle(0, (3, 2))), 2)["degrees"]
    '16.85'
    """
    degrees = half.degrees(digits, rounding)
    exact = half.angle
    own: Json = {"turns": None, "direction": None} if exact is None else angle_json(exact, digits)
    return {**own, "degrees": degrees, "doubled": angle_json(half.doubled, digits)}


def _largest_json(report: GraspReport, digits: int) -> Json:
    limits = {"bound": report.largest_mu, "pushing_bound": report.largest_mu_pushing}
    return {
        "probability": rational_text(report.probability or 0),
        "bound_limit": report.limit.decimal(digits),
        **{
            name: None
            if limit is None
            else {"mu": limit.decimal(digits), "degrees": limit.degrees(digits)}
            for name, limit in limits.items()
        },
    }
