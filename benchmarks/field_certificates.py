"""Certificates of parts over fields: written by the planner, checked by the second file.

The regular 97-gon, whose field has degree 48 (96 with its metric factor), and regular polygons with
one corner moved inwards, whose plans are long. Expected: checking takes O(n^2) enclosures of 128
bits for the extrema and a few per step and stage of the chain; a number that is zero takes as many
bits as the degree of the field times those of its bound. A rational part of as many steps is given
for comparison. Cosines are kept from round to round: the first check of a process takes longer.
"""

from __future__ import annotations

from gmpy2 import mpq

from benchmarks.harness import Clock, measure_rounds
from benchmarks.report import Report
from stochgeom import Part, plan_feeding
from stochgeom.feeding import field_certificate_checker as checker
from stochgeom.feeding.plans import FeedingPlan


def cut_polygon(n: int) -> Part:
    """Return a regular polygon with one corner moved inwards by a tenth."""
    vertices = list(Part.regular(n).vertices)
    x, y = vertices[1]
    vertices[1] = x * mpq(9, 10), y * mpq(9, 10)
    return Part(vertices, name=f"cut {n}-gon")


def rounded_polygon(n: int) -> Part:
    """Return a cut polygon whose coordinates are rounded to millionths."""
    vertices = cut_polygon(n).vertices
    return Part(
        [
            (mpq(round(float(x) * 10**6), 10**6), mpq(round(float(y) * 10**6), 10**6))
            for x, y in vertices
        ],
        name=f"rounded cut {n}-gon",
    )


def run(*, quick: bool = False) -> Report:
    report = Report("field_certificates", "certificates over fields: written, and checked")
    cases: list[tuple[Part, str, float | None]] = [
        (cut_polygon(12), "squeeze", 1),
        (cut_polygon(12), "push-grasp", 1),
        (rounded_polygon(12), "squeeze", None),
    ]
    if not quick:
        cases += [
            (cut_polygon(31), "squeeze", None),
            (Part.regular(97), "squeeze", 5),
            (Part.regular(97), "push-grasp", 5),
        ]
    for part, action, target in cases:
        plan = plan_feeding(part, action=action)
        found = measure_rounds(lambda clock, plan=plan: _one_round(clock, plan), 1 if quick else 7)
        report.section(f"{part.name}, {action}, a plan of {plan.steps}")
        report.time("certificate written", found["written"])
        report.time("certificate checked", found["checked"], target)
    return report


def _one_round(clock: Clock, plan: FeedingPlan) -> None:
    document = clock.time("written", plan.certificate)
    clock.time("checked", lambda: checker.check(document))
