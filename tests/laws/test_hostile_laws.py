"""Laws of hostile parts: nothing about them is too hostile for any claim to be checked."""

from __future__ import annotations

import json

from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.lifted import LiftedAngles
from stochgeom.feeding.adversarial import FAMILIES
from stochgeom.feeding.audit import Case, audit_case, compare_with_search
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.feeding.preimages import preimages
from stochgeom.geometry.part import Part
from stochgeom.io.outlines import parse_outline
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction
from tests.strategies import rational_points, rotations


@st.composite
def cases(draw):
    """Any family, in its usual sizes."""
    family = draw(st.sampled_from(list(FAMILIES.values())))
    return Case(family.name, draw(st.integers(*family.usual)), draw(st.integers(0, 10**6)))


cost_ratios = st.fractions(0, 30, max_denominator=20)


def widths(part):
    return [p.width for p in preimages(squeeze_function(part))]


@given(cases(), cost_ratios)
def test_every_answer_is_confirmed(case, c):
    """Refuted by a certificate the checker rejects, or a search that knows a better plan."""
    row = audit_case(case, cost_ratio=c, exhaustive=compare_with_search)
    assert row.disagreement is None
    assert row.certificates == 1 + (row.optimal_steps != row.shortest_steps)


@given(cases())
def test_generators_are_functions_of_size_and_seed(case):
    """Refuted by a part that is another when it is made again."""
    part = case.part()
    assert part == case.part()
    assert isinstance(part, Part)


@given(cases())
def test_plans_verify_forward(case):
    """Refuted by a plan of any length that forward execution does not confirm."""
    problem = FeedingProblem(case.part())
    for steps in range(1, problem.geometric_plan().steps + 1):
        assert problem.plan_of(steps).verify()


@given(cases())
def test_floats_choose_nothing(case):
    """Refuted by a preimage that is another when no float is trusted at all."""
    s = squeeze_function(case.part())
    again = StepFunction(s.breaks, s.values, s.period)
    again.lifted_breaks = LiftedAngles(again.breaks, again.period, error=1e9)
    again.lifted_values = LiftedAngles(again.values, again.period, error=1e9)
    assert list(preimages(again)) == list(preimages(s))


@given(cases(), rotations, rational_points, st.sampled_from([1, "1/7", 10**30]))
def test_where_a_part_lies_does_not_matter(case, turn, shift, size):
    """Refuted by widths that change when a part is turned, moved, scaled or reflected."""
    part = case.part()
    expected = widths(part)
    moved = part.multiply(turn).scale(size).translate(*shift)
    assert widths(moved) == expected
    assert widths(moved.reflect()) == expected


@given(cases(), st.integers(0, 50))
def test_which_vertex_comes_first_does_not_matter(case, k):
    """Refuted by a squeeze function that depends on the numbers of the vertices."""
    part = case.part()
    k %= len(part)
    turned = [*part.vertices[k:], *part.vertices[:k]]
    assert squeeze_function(turned) == squeeze_function(part)
    assert squeeze_function(turned[::-1]) == squeeze_function(part)


@given(cases())
def test_findings_can_be_repeated(case):
    """Refuted by a finding from which another part is read."""
    row = audit_case(case)
    document = json.loads(row.reproduction())
    assert Case(document["family"], document["size"], document["seed"]) == case
    assert parse_outline(row.reproduction()).vertices == row.part.vertices
