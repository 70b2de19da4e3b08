"""What somebody's plan does, in words and tables, and as a document."""

from __future__ import annotations

from typing import Any

from stochgeom.cli.layout import count, table
from stochgeom.exact.decimals import Rounding
from stochgeom.exact.scalars import rational_text
from stochgeom.feeding.nearby_courses import PartErrorReport
from stochgeom.feeding.reports import Margin, PlanReport
from stochgeom.io.plan_json import angle_json

MOST_ROWS = 40
"""More actions or arcs are not listed; ``--json`` has all of them."""


def report_text(report: PlanReport, name: str, digits: int) -> str:
    """Return the report for people."""
    order = report.transfer.order
    up_to = " (up to symmetry)" if report.orients_up_to_symmetry and order > 1 else ""
    either = (
        report.probability_up_to_symmetry.decimal(digits),
        report.expected_cost_up_to_symmetry.decimal(digits),
    )
    what = f"{count(report.final_orientations, 'final orientation')}{up_to}"
    mouth = f"{report.mouth.width.degrees(digits)} wide from {report.mouth.start.degrees(digits)}"
    worth = f"probability {report.probability.decimal(digits)}"
    cost = f"expected cost {report.expected_cost.decimal(digits)}"
    if order > 1:
        cost += f" (any of {order} equivalent ones: {either[0]} and {either[1]})"
    lines = [
        f"{count(report.steps, 'action')} on {name}: {what}",
        f"widest arc that is collapsed: {mouth}, to {report.final_orientation.degrees(digits)}",
        f"{worth}, {cost}",
        _comparison(report, digits),
    ]
    blocks = ["\n".join(lines), _margins(report, digits), _arcs(report, digits)]
    if report.part_errors is not None:
        blocks.append(_part_errors(report.part_errors, digits))
    return "\n\n".join(blocks)


def _comparison(report: PlanReport, digits: int) -> str:
    best = report.best_probability.decimal(digits)
    if not report.better_exists:
        return f"no plan of {count(report.steps, 'action')} does better"
    return (
        f"a plan of {count(report.steps, 'action')} reaches probability {best}; the first action "
        f"whose image does not fit is action {(report.first_misfit or 0) + 1}"
    )


def _margins(report: PlanReport, digits: int) -> str:
    rows = [
        [str(k), margin.angle.degrees(digits), _range(margin, digits)]
        for k, margin in enumerate(report.margins[:MOST_ROWS], start=1)
    ]
    title = "Margins: each angle alone may move within its range, and the arc still ends there"
    return title + "\n" + table(["action", "angle", "range"], rows) + _more(report.steps)


def _range(margin: Margin, digits: int) -> str:
    if margin.low is None or margin.high is None:
        return "any angle"
    _, low, high = margin.decimals(digits)
    return f"({low}, {high}]"


def _arcs(report: PlanReport, digits: int) -> str:
    rows = [
        [
            item.arc.start.degrees(digits),
            item.arc.width.degrees(digits),
            item.orientation.degrees(digits),
        ]
        for item in report.collapsed[:MOST_ROWS]
    ]
    period = report.transfer.period.degrees(digits)
    title = f"What goes where (one period of {period} degrees; degrees counter-clockwise)"
    return title + "\n" + table(["from", "width", "ends in"], rows) + _more(len(report.collapsed))


def _part_errors(proof: PartErrorReport, digits: int) -> str:
    """Return what is proven for parts whose vertices are off."""
    near = f"every part with vertices within {rational_text(proof.vertex_error)} of the given ones"
    if not proof.proven:
        return f"Not proven for {near}: {proof.reason}."
    rows = [
        [
            start.start.degrees(digits, Rounding.UP),
            start.end.degrees(digits, Rounding.DOWN),
            final.start.degrees(digits, Rounding.DOWN),
            final.end.degrees(digits, Rounding.UP),
        ]
        for start, final in zip(proof.starts, proof.finals, strict=True)
    ]
    same = "in one orientation each" if proof.one_orientation else "with the same edges flush"
    title = f"Proven for {near}, which end {same}"
    header = ["from", "to", "ends from", "to"]
    return title + "\n" + table(header, rows[:MOST_ROWS]) + _more(len(rows))


def _more(rows: int) -> str:
    return f"\n  ... and {rows - MOST_ROWS} more" if rows > MOST_ROWS else ""


def report_document(report: PlanReport, digits: int) -> dict[str, Any]:
    """Return the report for machines, a ``stochgeom/report/1`` document."""
    return {
        "schema": "stochgeom/report/1",
        "steps": report.steps,
        "final_orientations": report.final_orientations,
        "orients_up_to_symmetry": report.orients_up_to_symmetry,
        "mouth": {
            "start": angle_json(report.mouth.start, digits),
            "width": angle_json(report.mouth.width, digits),
        },
        "final_orientation": angle_json(report.final_orientation, digits),
        "probability": report.probability.decimal(digits),
        "expected_cost": report.expected_cost.decimal(digits),
        "better_exists": report.better_exists,
        "best_probability": report.best_probability.decimal(digits),
        "first_misfit": report.first_misfit,
        "margins": [
            {
                "angle": angle_json(margin.angle, digits),
                "low": None if margin.low is None else angle_json(margin.low, digits),
                "high": None if margin.high is None else angle_json(margin.high, digits),
            }
            for margin in report.margins
        ],
        "collapsed": [
            {
                "start": angle_json(item.arc.start, digits),
                "width": angle_json(item.arc.width, digits),
                "orientation": angle_json(item.orientation, digits),
            }
            for item in report.collapsed
        ],
        **_proof_json(report.part_errors, digits),
    }


def _proof_json(proof: PartErrorReport | None, digits: int) -> dict[str, Any]:
    if proof is None:
        return {}
    arcs = [
        {
            "start": angle_json(start.start, digits),
            "width": angle_json(start.width, digits),
            "final": {
                "start": angle_json(final.start, digits),
                "width": angle_json(final.width, digits),
            },
        }
        for start, final in zip(proof.starts, proof.finals, strict=True)
    ]
    found = {
        "vertex_error": rational_text(proof.vertex_error),
        "proven": proof.proven,
        "reason": proof.reason,
        "one_orientation": proof.one_orientation,
        "arcs": arcs,
    }
    return {"part_errors": found}
