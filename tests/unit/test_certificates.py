"""`stochgeom.feeding.certificates`: what a certificate says, and that the checker agrees."""

from __future__ import annotations

import copy
import json
import math

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.errors import InputError
from stochgeom.exact.angles import EIGHTH_TURN, HALF_TURN, QUARTER_TURN
from stochgeom.feeding import certificate_checker as checker
from stochgeom.feeding.certificates import SCHEMA, certificate
from stochgeom.feeding.planner import FeedingProblem, plan_feeding
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.geometry.part import Part
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from tests.strategies import (
    SPECIAL,
    circle_parts,
    fractions,
    hulls,
    nearly_regular,
    parts,
    rational_parts,
    symmetric_hulls,
)

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
COSTS = [0, 1, "5/3", "0.1234567", 100, 10**9]

any_part = st.one_of(parts(), parts(), rational_parts(), circle_parts(), nearly_regular())
cost_ratios = st.one_of(st.sampled_from(COSTS), fractions.map(abs))


def through_a_file(document):
    """Return a document as the checker reads it from a file."""
    return checker.load(json.dumps(document).encode())


def assert_valid(plan):
    checker.check(through_a_file(plan.certificate()))


def assert_all_valid(problem, cost_ratio=1):
    """Check the plans of every length, the cheapest and the shortest up to symmetry."""
    for steps in range(1, problem.geometric_plan().steps + 1):
        assert_valid(problem.plan_of(steps, cost_ratio))
    assert_valid(problem.optimal_plan(cost_ratio))


# --- what it says --------------------------------------------------------------------------------


def angle(turns, x, y):
    return {"turns": turns, "direction": [str(x), str(y)]}


NOTHING, QUARTER, HALF = angle(0, 1, 0), angle(0, 0, 1), angle(0, -1, 0)
GOLDEN = {
    "schema": "stochgeom/certificate/1",
    "action": "squeeze",
    "part": {"name": "tray", "vertices": [["0", "0"], ["3", "0"], ["3", "2"], ["0", "2"]]},
    "hull": [0, 1, 2, 3],
    "period": HALF,
    "breaks": [
        {"angle": angle(0, 2, 3), "lower": [0], "upper": [2]},
        {"angle": angle(0, -2, 3), "lower": [3], "upper": [1]},
    ],
    "values": [
        {"angle": QUARTER, "lower": [3, 0], "upper": [2, 1]},
        {"angle": HALF, "lower": [2, 3], "upper": [1, 0]},
    ],
    "preimages": [
        {
            "steps": 1,
            "first": 1,
            "last": 1,
            "start": angle(0, -2, 3),
            "width": angle(0, -5, 12),
            "image_start": HALF,
            "image_width": NOTHING,
            "rival": {"first": 0, "width": angle(0, 5, 12)},
        },
        {
            "steps": 2,
            "first": 0,
            "last": 1,
            "start": angle(0, 2, 3),
            "width": HALF,
            "image_start": QUARTER,
            "image_width": QUARTER,
            "rival": {"first": 1, "width": HALF},
        },
    ],
    "cost_ratio": "1",
    "costs": [{"numerator": "2", "comparison": 1}, {"numerator": "3", "comparison": 0}],
    "optimal_steps": 2,
    "plan": {
        "steps": 2,
        "mouth": {"start": angle(0, 2, 3), "width": HALF},
        "actions": [
            {"angle": NOTHING, "low": None, "high": None},
            {"angle": angle(-1, 1, -1), "low": angle(-1, 2, -3), "high": angle(-1, 3, -2)},
        ],
        "final_orientation": HALF,
        "optimal": True,
        "orients_up_to_symmetry": True,
    },
}
"""Worked by hand: the diagonals are upright at 56.3 and 123.7 degrees, the sides flush at 90, 180.

(2, 3) is 56.3 degrees, (-2, 3) is 123.7, (5, 12) is 67.4 and (-5, 12) is 112.6; the second action
works above 180 - (123.7 + 112.6) = -56.3 degrees and up to 90 - 123.7 = -33.7 degrees.
"""


def test_the_certificate_of_a_rectangle():
    plan = plan_feeding(Part(RECTANGLE, name="tray"))
    assert plan.certificate() == certificate(plan) == GOLDEN
    assert list(plan.certificate()) == list(GOLDEN)
    assert GOLDEN["schema"] == SCHEMA == checker.SCHEMA
    checker.check(GOLDEN)


def test_a_plan_of_one_step():
    document = FeedingProblem(RECTANGLE).plan_of(1, 2).certificate()
    assert document["part"]["name"] is None
    assert document["cost_ratio"] == "2"
    assert document["costs"] == [
        {"numerator": "3", "comparison": 1},
        {"numerator": "4", "comparison": 0},
    ]
    assert document["plan"]["steps"] == 1
    assert document["plan"]["mouth"] == {"start": angle(0, -2, 3), "width": angle(0, -5, 12)}
    assert document["plan"]["actions"] == [{"angle": NOTHING, "low": None, "high": None}]
    assert document["plan"]["optimal"] is False
    assert document["plan"]["orients_up_to_symmetry"] is False
    assert document["preimages"] == GOLDEN["preimages"]
    checker.check(document)


@pytest.mark.parametrize(
    ("outline", "cost_ratio", "widths", "signs"),
    [
        ([(-3, 3), (-1, -2), (2, 1)], 0, ["66.801", "133.603", "180.000"], [0, 0, 1]),
        (
            [(-1, -1), (3, -3), (3, 3), (-1, 1), (2, 0)],
            1,
            ["90.000", "135.000", "180.000"],
            [0, 0, 0],
        ),
    ],
    ids=["1 / h = 2 / 2 h, h irrational", "2 / 90 = 3 / 135 = 4 / 180"],
)
def test_a_tie_of_costs_goes_to_fewer_steps(outline, cost_ratio, widths, signs):
    problem = FeedingProblem(outline)
    assert [preimage.width.degrees(3) for preimage in problem.preimages] == widths
    document = problem.optimal_plan(cost_ratio).certificate()
    assert [cost["comparison"] for cost in document["costs"]] == signs
    assert document["optimal_steps"] == document["plan"]["steps"] == 1
    checker.check(document)
    # A plan as cheap, of more steps, is not called optimal.
    assert problem.plan_of(2, cost_ratio).certificate()["plan"]["optimal"] is False


def test_a_step_over_a_whole_period():
    """An obtuse triangle has one step (m = 1): no start has a rival."""
    plan = plan_feeding([(0, 0), (5, 0), (-1, 1)])
    document = plan.certificate()
    assert len(plan.transfer) == 1
    assert [preimage["rival"] for preimage in document["preimages"]] == [None]
    assert document["plan"]["orients_up_to_symmetry"] is True
    checker.check(document)


QUARTER_OF_16_GON = [(12000, 5000), (7000, 10000), (4949, 12019), (-2000, 12019)]
"""Upright chords at 45 k + 67.38 degrees, stable edges at 45 k, exactly, all of them rational.

A regular octagon is not rational. Here two corners of each quarter lie on the rays of (12, 5) and
(12 - 5, 12 + 5), though not equally far away; the other two make room for edges flush at multiples
of 45 degrees, and add no extremum of their own.
"""
EIGHTH_PERIOD = [
    corner
    for x, y in [(1, 0), (0, 1), (-1, 0), (0, -1)]
    for corner in [(x * a - y * b, x * b + y * a) for a, b in QUARTER_OF_16_GON]
]


@pytest.mark.parametrize(
    ("outline", "period", "m"),
    [
        ([(0, 0), (1, 0), (0, 1)], HALF_TURN, 1),
        ([(0, 0), (3, 0), (3, 2), (0, 2)], HALF_TURN, 2),
        ([(0, 0), (1, 0), (1, 1), (0, 1)], QUARTER_TURN, 1),
        ([(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)], QUARTER_TURN, 2),
        ([(3, 1), (1, 3), (-1, 3), (-3, 1), (-3, -1), (-1, -3), (1, -3), (3, -1)], QUARTER_TURN, 2),
        (EIGHTH_PERIOD, EIGHTH_TURN, 1),
    ],
    ids=["right triangle", "rectangle", "square", "cut square", "octagon", "period 45"],
)
def test_periods(outline, period, m):
    problem = FeedingProblem(outline)
    assert problem.transfer.period == period
    assert len(problem.transfer) == m
    assert_all_valid(problem)


# --- valid for every part ------------------------------------------------------------------------


@pytest.mark.parametrize("cost_ratio", COSTS, ids=str)
@pytest.mark.parametrize("name", catalogue_names())
def test_parts_of_the_catalogue(name, cost_ratio):
    problem = FeedingProblem(catalogue_part(name))
    assert_valid(problem.optimal_plan(cost_ratio))
    assert_valid(problem.geometric_plan(cost_ratio))


@pytest.mark.parametrize("part", SPECIAL, ids=lambda part: part.name)
def test_corners_of_the_input_space(part):
    for cost_ratio in COSTS:
        assert_all_valid(FeedingProblem(part), cost_ratio)


@given(any_part, cost_ratios)
def test_all_parts(part, cost_ratio):
    problem = FeedingProblem(part)
    assert_valid(problem.optimal_plan(cost_ratio))
    assert_valid(problem.geometric_plan(cost_ratio))


@given(st.one_of(hulls(), symmetric_hulls()))
def test_plans_of_every_length(part):
    assert_all_valid(FeedingProblem(part))


@given(parts(), st.data())
def test_clockwise_outlines_and_any_first_vertex(part, data):
    vertices = list(part.vertices)
    first = data.draw(st.integers(0, len(vertices) - 1))
    for outline in (vertices[first:] + vertices[:first], vertices[::-1]):
        assert_all_valid(FeedingProblem(outline))


@given(parts(), st.data())
def test_repeated_and_collinear_vertices(part, data):
    outline = []
    vertices = list(part.vertices)
    for (ax, ay), (bx, by) in zip(vertices, vertices[1:] + vertices[:1], strict=True):
        outline += [(ax, ay)] * data.draw(st.integers(1, 2))
        if data.draw(st.booleans()):
            outline.append(((ax + bx) / 2, (ay + by) / 2))
    problem = FeedingProblem(outline)
    document = problem.geometric_plan().certificate()
    corners = [outline[k] for k in document["hull"]]
    assert all(outline.index(corner) in document["hull"] for corner in corners)
    assert_all_valid(problem)


def test_the_first_of_repeated_vertices_is_named():
    outline = [(0, 0), (0, 0), (1, 0), (3, 0), (3, 2), (3, 2), (0, 2), (0, 1), (0, 0)]
    document = plan_feeding(outline).certificate()
    assert document["hull"] == [0, 3, 4, 6]
    assert document["breaks"][0]["lower"] == [0]
    assert document["breaks"][0]["upper"] == [4]
    checker.check(document)


def test_a_clockwise_outline_has_its_hull_counter_clockwise():
    document = plan_feeding(RECTANGLE[::-1]).certificate()
    assert document["hull"] == [0, 3, 2, 1]
    checker.check(document)


def test_long_numbers():
    """Coordinates of thousands of digits, whole and not; Python's `str` refuses more than 4300."""
    big = 10**5000
    for outline in (
        [(0, 0), (3 * big, 1), (3 * big, 2 * big), (1, 2 * big - 1)],
        [("0", "0"), ("3e-10000", "0"), ("3e-10000", "2e-10000"), ("0", "2.123456789e-10000")],
    ):
        assert_all_valid(FeedingProblem(outline))


@pytest.mark.parametrize("n", [25, 200])
def test_long_plans(n):
    """Points on a circle, and a regular polygon with one corner moved: its plan has n steps."""
    n_odd = n - 1 + n % 2
    turns = [2 * math.pi * k / n_odd + (0.005 if k == 0 else 0) for k in range(n_odd)]
    regular = [(round(10**7 * math.cos(t)), round(10**7 * math.sin(t))) for t in turns]
    problem = FeedingProblem(regular)
    assert problem.geometric_plan().steps == n_odd
    assert_valid(problem.geometric_plan())
    spiral = [2.4 * k % (2 * math.pi) for k in range(n)]
    cloud = sorted(spiral)
    circle = [(round(10**6 * math.cos(t)), round(10**6 * math.sin(t))) for t in cloud]
    assert_valid(plan_feeding(circle))


# --- what is refused -----------------------------------------------------------------------------


def test_a_plan_without_a_part():
    problem = FeedingProblem(RECTANGLE)
    bare = FeedingPlan(problem.transfer, problem.preimages, mpq(1))
    with pytest.raises(InputError, match="certificates need a part and the action squeeze"):
        bare.certificate()


def test_another_action():
    problem = FeedingProblem(RECTANGLE)
    other = FeedingPlan(problem.transfer, problem.preimages, mpq(1), problem.part, "push")
    with pytest.raises(InputError, match="the action squeeze or push-grasp"):
        other.certificate()


def test_a_document_is_not_shared():
    plan = plan_feeding(RECTANGLE)
    first = plan.certificate()
    second = copy.deepcopy(plan.certificate())
    first["plan"]["actions"].clear()
    assert plan.certificate() == second
