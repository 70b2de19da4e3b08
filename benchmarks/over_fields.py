"""Parts over real algebraic fields: single numbers, regular polygons, cut regular polygons.

Targets: an outline of 97 vertices over a field of degree 48 to its squeeze function and plan in 5
seconds; the sign of one of its numbers in 10 microseconds. Products are counted, each being worth
many rational ones. Expected: O(n) products for the squeeze function of a regular n-gon, each
O(d^2) for the degree d, so about O(n^3).

The other road: the same numbers as sympy's algebraic expressions, whose signs are decided by
evaluating them.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from unittest import mock

from gmpy2 import mpq

from benchmarks.harness import measure_small
from benchmarks.report import Report
from stochgeom import Part, plan_feeding, squeeze_function
from stochgeom.exact.algebraic import Algebraic
from stochgeom.exact.surds import field_symbols

SIZES = (12, 24, 48, 97)


def run(*, quick: bool = False) -> Report:
    report = Report("over_fields", "numbers and parts over real algebraic fields")
    rounds = 2 if quick else 11
    _numbers(report, 97, rounds)
    for n in SIZES[:2] if quick else SIZES:
        _polygon(report, n, rounds)
    return report


def _numbers(report: Report, n: int, rounds: int) -> None:
    part = Part.regular(n)
    field = part.field
    assert field is not None
    report.section(f"field of the regular {n}-gon, degree {field.degree}, for one")
    g, s = field_symbols(field).values()
    dense = [sum((k % 7 - 3) * g**k for k in range(field.degree)) + j for j in range(20)]
    pairs = list(pairwise(dense))
    symbolic = [a.to_sympy() for a in dense[:1]]
    actions: dict[str, tuple[Callable[[], object], int]] = {
        "sign": (lambda: [(a + 0).sign() for a in dense], len(dense)),
        "product": (lambda: [a * b for a, b in pairs], len(pairs)),
        "product with s": (lambda: [a * s for a in dense], len(dense)),
        "inverse": (lambda: [1 / a for a in dense[:2]], 2),
        "sign by sympy": (lambda: [bool(a > 0) for a in symbolic], 1),
    }
    for label, (action, count) in actions.items():
        samples = measure_small({label: action}, rounds)[label].per(count)
        report.time(label, samples, 10e-6 if label == "sign" else None)


def _polygon(report: Report, n: int, rounds: int) -> None:
    report.section(f"{n} vertices")
    regular = list(Part.regular(n).vertices)
    cut = [(regular[0][0] * mpq(9, 10), regular[0][1] * mpq(9, 10)), *regular[1:]]
    for label, vertices in (("regular", regular), ("one vertex cut", cut)):
        actions = {
            f"{label}: vertices to squeeze function": lambda v=vertices: squeeze_function(Part(v)),
            f"{label}: vertices to plan": lambda v=vertices: plan_feeding(Part(v)).actions,
        }
        for name, samples in measure_small(actions, rounds).items():
            report.time(f"  {name}", samples, 5.0 if n == max(SIZES) else None)
        report.figure(f"  {label}: products for the plan", count_products(vertices), "")


def count_products(vertices: list[tuple[object, object]]) -> int:
    """Return how many products of numbers of the field a plan takes."""
    product, count = Algebraic.__mul__, 0

    def counted(self: Algebraic, other: object) -> Algebraic:
        nonlocal count
        count += isinstance(other, Algebraic)
        return product(self, other)

    with mock.patch.object(Algebraic, "__mul__", counted):
        _ = plan_feeding(Part(vertices)).actions
    return count
