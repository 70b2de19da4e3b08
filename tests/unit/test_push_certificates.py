"""Certificates of push-grasp plans: what they say, and that the stand-alone checker agrees."""

from __future__ import annotations

import json
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.priors import uniform_prior
from stochgeom.errors import InputError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO
from stochgeom.feeding import certificate_checker as checker
from stochgeom.feeding.certificate_checker import InvalidClaimError
from stochgeom.feeding.planner import plan_feeding
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import Preimages
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.push import push_function
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import SPECIAL, fractions, pushable_parts

TRIANGLE = Part([(0, 0), (4, 0), (0, 3)], name="triangle")
HOUSE = Part(catalogue_part("house").vertices, (0, "2/5"), "house")
FOUR_GON = Part([(52, 58), (0, 55), (8, 17), (51, 0)], (28, 32), "4gon")
SQUARE = Part([(0, 0), (2, 0), (2, 2), (0, 2)], name="square")
OFF_CENTER = Part([(0, 0), (2, 0), (2, 2), (0, 2)], ("1/2", 1), "square, off centre")
ANCHORS = [TRIANGLE, HOUSE, FOUR_GON, SQUARE, OFF_CENTER]


def plans_for(part, cost_ratio=1):
    """Return the push-grasp plans of every length."""
    transfer = push_grasp_function(part)
    chain = tuple(Preimages(transfer))
    return [
        FeedingPlan(transfer, chain[:steps], mpq(cost_ratio), part, "push-grasp")
        for steps in range(1, len(chain) + 1)
    ]


def certificates_for(part, cost_ratio=1):
    """Return their certificates, as read from files and found valid."""
    documents = [json.dumps(plan.certificate()).encode() for plan in plans_for(part, cost_ratio)]
    for document in documents:
        checker.check(checker.load(document))
    return [checker.load(document) for document in documents]


# --- what it says --------------------------------------------------------------------------------


def angle(turns, x, y):
    return {"turns": turns, "direction": [str(x), str(y)]}


NOTHING, QUARTER, HALF, FULL = angle(0, 1, 0), angle(0, 0, 1), angle(0, -1, 0), angle(1, 1, 0)
GOLDEN = {
    "schema": "stochgeom/certificate/1",
    "action": "push-grasp",
    "part": {
        "name": "triangle",
        "vertices": [["0", "0"], ["4", "0"], ["0", "3"]],
        "center_of_mass": ["4/3", "1"],
    },
    "hull": [0, 1, 2],
    "push": {
        "period": FULL,
        "breaks": [
            {"angle": angle(0, 3, 4), "vertex": 0},
            {"angle": angle(0, -3, 2), "vertex": 2},
            {"angle": angle(0, 3, -8), "vertex": 1},
        ],
        "values": [
            {"angle": QUARTER, "edge": [2, 0]},
            {"angle": angle(0, -4, -3), "edge": [1, 2]},
            {"angle": FULL, "edge": [0, 1]},
        ],
    },
    "squeeze": {
        "period": HALF,
        "breaks": [{"angle": angle(0, -3, 4), "lower": [2], "upper": [1]}],
        "values": [{"angle": angle(0, -4, -3), "lower": [1, 2], "upper": [0]}],
    },
    "period": FULL,
    "breaks": [
        {"angle": angle(0, -3, 2), "push_break": 1},
        {"angle": angle(0, 3, -8), "push_break": 2},
    ],
    "values": [
        {"angle": angle(0, -4, -3), "squeeze_value": 0},
        {"angle": angle(1, 4, 3), "squeeze_value": 1},
    ],
    "preimages": [
        {
            "steps": 1,
            "first": 1,
            "last": 1,
            "start": angle(0, 3, -8),
            "width": angle(0, -25, -18),
            "image_start": angle(1, 4, 3),
            "image_width": NOTHING,
            "rival": {"first": 0, "width": angle(0, -25, 18)},
        },
        {
            "steps": 2,
            "first": 0,
            "last": 1,
            "start": angle(0, -3, 2),
            "width": FULL,
            "image_start": angle(0, -4, -3),
            "image_width": HALF,
            "rival": {"first": 1, "width": FULL},
        },
    ],
    "cost_ratio": "1",
    "costs": [{"numerator": "2", "comparison": 1}, {"numerator": "3", "comparison": 0}],
    "optimal_steps": 2,
    "plan": {
        "steps": 2,
        "mouth": {"start": angle(0, -3, 2), "width": FULL},
        "actions": [
            {"angle": NOTHING, "low": None, "high": None},
            {"angle": angle(-1, 0, -1), "low": angle(-1, -6, -17), "high": angle(-1, 12, -41)},
        ],
        "final_orientation": angle(1, 4, 3),
        "optimal": True,
        "orients_up_to_symmetry": True,
    },
}
"""Worked by hand for the right triangle with sides 3 and 4.

The centroid stands over vertex 0 at 53.1 degrees, over 2 at 146.3 and over 1 at 290.6; all three
edges are stable for the push, at 90, 216.9 and 360. For the jaws only the hypotenuse is, at 36.9
and 216.9: so 90 and 360 = 0 are squeezed to 36.9 both, 360 to 36.9 + 360, and the push break at
53.1 is none of the composite. The widths are 144.2 and 215.8; the second action works above
396.9 - (290.6 + 215.8) = -109.4 degrees and up to 216.9 - 290.6 = -73.7 degrees.
"""


def test_the_certificate_of_a_triangle():
    *_, plan = plans_for(TRIANGLE)
    document = plan.certificate()
    assert document == GOLDEN
    assert list(document) == list(GOLDEN)
    checker.check(GOLDEN)


def test_the_house():
    """The push settles on five edges; the jaws leave three of the five orientations."""
    *_, document = certificates_for(HOUSE)
    corners = [tuple(map(int, vertex)) for vertex in document["part"]["vertices"]]
    assert document["part"]["center_of_mass"] == ["0", "2/5"]
    assert [corners[row["vertex"]] for row in document["push"]["breaks"]] == [
        (-1, -1),
        (-1, 1),
        (0, 2),
        (1, 1),
        (1, -1),
    ]
    assert [row["push_break"] for row in document["breaks"]] == [0, 2, 4]
    assert [row["squeeze_value"] for row in document["values"]] == [0, 2, 3]
    degrees = [row["angle"]["direction"] for row in document["values"]]
    assert degrees == [["0", "1"], ["0", "-1"], ["1", "0"]]
    assert document["period"] == FULL
    assert document["plan"]["orients_up_to_symmetry"] is True


def test_the_4gon():
    """Each push value is squeezed to another orientation: four steps, four actions."""
    documents = certificates_for(FOUR_GON)
    assert len(documents) == 4
    assert documents[0]["part"]["center_of_mass"] == ["28", "32"]
    assert [row["push_break"] for row in documents[0]["breaks"]] == [0, 1, 2, 3]
    assert documents[3]["plan"]["mouth"]["width"] == FULL
    # A value of the composite may lie outside its own step: that of 53 degrees lies at 78, but
    # the last one, of 324 degrees, at 382, with breaks up to 413.
    assert documents[0]["values"][-1]["angle"]["turns"] == 1


def test_a_square_cannot_be_told_from_itself():
    (document,) = certificates_for(SQUARE)
    assert document["period"] == document["push"]["period"] == QUARTER
    assert document["push"]["breaks"] == [{"angle": angle(0, 1, 1), "vertex": 0}]
    assert document["push"]["values"] == [{"angle": QUARTER, "edge": [3, 0]}]
    assert document["breaks"] == [{"angle": angle(0, 1, 1), "push_break": 0}]


def test_a_square_with_its_centre_of_mass_elsewhere():
    *_, document = certificates_for(OFF_CENTER)
    assert document["push"]["period"] == document["period"] == FULL
    assert len(document["push"]["breaks"]) == 4


@pytest.mark.parametrize(
    ("outline", "center", "periods"),
    [
        ([(0, 0), (2, 0), (2, 2), (0, 2)], (1, 1), [QUARTER, QUARTER, QUARTER]),
        ([(0, 0), (2, 0), (2, 2), (0, 2)], (1, "1/2"), [FULL, QUARTER, FULL]),
        ([(0, 0), (3, 0), (3, 2), (0, 2)], ("3/2", 1), [HALF, HALF, HALF]),
        # What the push tells apart, the squeeze brings together again.
        ([(0, -1), (2, 1), (0, 1), (-2, -1)], (1, "1/2"), [FULL, HALF, HALF]),
        ([(1, 3), (-3, 1), (-2, -2), (-1, -3), (2, -2), (3, -1)], (0, 0), [FULL, QUARTER, QUARTER]),
    ],
)
def test_periods(outline, center, periods):
    """The push has that of the squeeze, or 360 degrees."""
    *_, document = certificates_for(Part(outline, center))
    assert [document[of]["period"] for of in ("push", "squeeze")] == periods[:2]
    assert document["period"] == periods[2]


def test_a_centre_of_mass_over_the_end_of_an_edge_adds_no_extremum():
    """Over vertex 1 with the edge 0-1 flush: neither is that edge stable nor the vertex upright."""
    part = Part([(0, 0), (2, 0), (6, 4), (0, 4)], (2, 2))
    *_, document = certificates_for(part)
    assert [0, 1] not in [row["edge"] for row in document["push"]["values"]]
    assert 1 not in [row["vertex"] for row in document["push"]["breaks"]]


def test_the_centroid_is_stated_if_no_centre_was_given():
    """It is an input of the checker: another point inside would be taken as well."""
    holed = Part([(0, 0), (6, 0), (6, 4), (0, 4)], holes=[[(4, 1), (5, 1), (5, 2)]])
    *_, document = certificates_for(holed)
    x, y = holed.center_of_mass
    assert document["part"]["center_of_mass"] == [str(x), str(y)] != ["3", "2"]
    assert "holes" not in document["part"]


def test_the_first_of_repeated_vertices_is_named():
    outline = [(0, 0), (0, 0), (1, 0), (3, 0), (3, 2), (3, 2), (0, 2), (0, 1), (0, 0)]
    *_, document = certificates_for(Part(outline, (1, 1)))
    assert document["hull"] == [0, 3, 4, 6]
    assert {row["vertex"] for row in document["push"]["breaks"]} == {0, 3, 4, 6}
    ends = [row["edge"] for row in document["push"]["values"]]
    assert sorted(ends) == [[0, 3], [3, 4], [4, 6], [6, 0]]


def test_numbers_of_thousands_of_digits():
    big = 10**5000
    part = Part(
        [(0, 0), (3 * big, 1), (3 * big, 2 * big), (1, 2 * big - 1)], (big, Fraction(big, 7))
    )
    assert certificates_for(part)


# --- valid for every part ------------------------------------------------------------------------


@pytest.mark.parametrize("cost_ratio", [0, 1, Fraction(5, 3), 10**9], ids=str)
@pytest.mark.parametrize("part", [*ANCHORS, *SPECIAL], ids=lambda part: part.name)
def test_corners_of_the_input_space(part, cost_ratio):
    assert certificates_for(part, cost_ratio)


@given(pushable_parts(), fractions.map(abs))
def test_plans_of_every_length(part, cost_ratio):
    for steps, document in enumerate(certificates_for(part, cost_ratio), start=1):
        assert document["plan"]["steps"] == steps


@given(pushable_parts())
def test_the_sources_of_the_composite(part):
    """Push break and squeeze value of each step are the lifted ones of the two functions."""
    push, squeeze = push_function(part), squeeze_function(part)
    transfer = push_grasp_function(part)
    document = plans_for(part)[-1].certificate()
    for row, expected in zip(document["breaks"], transfer.breaks, strict=True):
        assert push.lifted_breaks[row["push_break"]] == expected
    for row, expected in zip(document["values"], transfer.values, strict=True):
        assert squeeze.lifted_values[row["squeeze_value"]] == expected


@given(pushable_parts(), st.data())
def test_any_first_vertex_and_clockwise_outlines(part, data):
    vertices = list(part.vertices)
    first = data.draw(st.integers(0, len(vertices) - 1))
    for outline in (vertices[first:] + vertices[:first], vertices[::-1]):
        assert certificates_for(Part(outline, part.center_of_mass))


@given(pushable_parts())
def test_the_checkers_push_function_is_that_of_the_library(part):
    corners = [*part.vertices, part.center_of_mass]
    corners = checker.whole([(Fraction(x), Fraction(y)) for x, y in corners])
    hull = checker.convex_hull(corners[:-1])
    radius, push = RadiusFunction(part), push_function(part)
    maxima, minima = checker.radius_extrema(hull, corners[-1])
    assert maxima == [plain(theta) for theta in radius.maxima]
    assert minima == [plain(theta) for theta in radius.minima]
    for found, expected in (
        (checker.push(hull, corners[-1])[0], push),
        (checker.push_grasp(hull, corners[-1])[0], push_grasp_function(part)),
    ):
        assert found.breaks == [plain(theta) for theta in expected.breaks]
        assert found.values == [plain(theta) for theta in expected.values]
        assert found.period == plain(expected.period)
        for theta in (*expected.breaks, *expected.values):
            before = expected.lifted_values[expected.step_before(theta)]
            assert found.apply(plain(theta)) == plain(expected(theta))
            assert found.apply(plain(theta), from_left=True) == plain(before)


def plain(theta):
    """Return the checker's notation for an angle of the library."""
    return int(theta.turn_part), *map(int, theta.direction)


# --- the checker's step map ----------------------------------------------------------------------


def degrees(*numbers):
    """Return multiples of 45 degrees in the checker's notation."""
    return [checker.eighths(number // 45) for number in numbers]


class TestStepMap:
    def test_equal_values_are_one_step(self):
        s = checker.StepMap(degrees(0, 90, 180), degrees(45, 45, 270), 8)
        assert (s.kept, s.breaks, s.values) == ([0, 2], degrees(0, 180), degrees(45, 270))

    def test_the_last_value_may_be_the_first_a_period_on(self):
        s = checker.StepMap(degrees(0, 90, 180), degrees(-45, 90, 315), 8)
        assert (s.kept, s.breaks, s.values) == ([1, 2], degrees(90, 180), degrees(90, 315))

    def test_one_value_only(self):
        s = checker.StepMap(degrees(0, 90, 180), degrees(45, 45, 405), 8)
        assert (s.kept, s.breaks, s.values) == ([2], degrees(180), degrees(405))
        assert s.apply((0, 1, 0)) == checker.eighths(1)

    @pytest.mark.parametrize("parts", [1, 2, 4, 8])
    def test_the_smallest_period_is_found(self, parts):
        count = 8 // parts
        values = [k // count * count * 45 for k in range(8)]
        s = checker.StepMap(degrees(*range(0, 360, 45)), degrees(*values), 8)
        assert (s.period, s.m) == (checker.eighths(count), 1)

    def test_a_full_turn_apart_is_not_together(self):
        """Both ends of the mouth go to 0, a turn apart: what is between them goes to 180."""
        s = checker.StepMap(degrees(0, 90), degrees(0, 180), 8)
        arc = {"start": checker.eighths(1), "width": checker.eighths(8), "image_start": (0, 1, 0)}
        assert s.apply(checker.eighths(9), from_left=True) == (1, 1, 0)
        with pytest.raises(InvalidClaimError, match=r"^plan: does not collapse the mouth"):
            checker.run_forward(s, [arc], [{"angle": (0, 1, 0), "low": None, "high": None}])


@pytest.mark.parametrize(
    "center",
    [(0, 0), (2, 0), (4, 0), (2, Fraction(3, 2)), (2, Fraction(8, 5)), (-1, 1), (50, 50), (-1, 0)],
    ids=str,
)
def test_a_centre_of_mass_that_is_not_inside(center):
    """Corner, edges, just beyond an edge, beside the part, far away, in line with an edge."""
    document = json.loads(json.dumps(GOLDEN))
    document["part"]["center_of_mass"] = [str(Fraction(number)) for number in center]
    with pytest.raises(InvalidClaimError) as caught:
        checker.check(document)
    assert str(caught.value) == "part.center_of_mass: not strictly inside the hull"
    assert not isinstance(caught.value, checker.NoCertificateError)


# --- what is refused -----------------------------------------------------------------------------


def test_a_transfer_function_of_another_action():
    plan = plans_for(HOUSE)[0]
    for name, transfer in (
        ("push-grasp", squeeze_function(HOUSE)),
        ("push-grasp", push_grasp_function(HOUSE, upper_jaw=True)),
        ("squeeze", plan.transfer),
    ):
        other = FeedingPlan(transfer, Preimages(transfer), mpq(1), HOUSE, name)
        with pytest.raises(InputError, match=f"is not that of {name}; accepted: plans for what"):
            other.certificate()


def test_the_upper_jaw_of_a_part_that_looks_the_same_upside_down():
    transfer = push_grasp_function(SQUARE, upper_jaw=True)
    plan = FeedingPlan(transfer, Preimages(transfer), mpq(1), SQUARE, "push-grasp")
    checker.check(plan.certificate())


def test_an_action_the_checker_does_not_know():
    transfer = push_function(HOUSE)
    plan = FeedingPlan(transfer, Preimages(transfer), mpq(1), HOUSE, "push")
    with pytest.raises(InputError, match="need a part and the action squeeze or push-grasp"):
        plan.certificate()


class TestOtherPlans:
    """Plans that are not the best for a uniform prior, any orientation and an exact gripper."""

    def test_a_prior(self):
        prior = DiscretePrior([("10", "1/2"), ("20", "1/2")])
        for action in ("squeeze", "push-grasp"):
            plan = plan_feeding(HOUSE, action=action, prior=prior)
            with pytest.raises(InputError, match="this plan is for a prior; accepted"):
                plan.certificate()

    def test_a_uniform_prior_is_none(self):
        plan = plan_feeding(HOUSE, action="push-grasp", prior=uniform_prior())
        checker.check(plan.certificate())

    @given(pushable_parts(), st.sampled_from(["0", "1/2", "3", "10", "20"]))
    def test_errors_of_the_gripper(self, part, degrees):
        """Where the mouths are the widest nevertheless, so is the proof."""
        for action in ("squeeze", "push-grasp"):
            problem = FeedingProblem(part, action, gripper_error=degrees)
            plan = problem.optimal_plan()
            widest = list(Preimages(problem.transfer))[: plan.steps]
            if [p.arc for p in plan.preimages] == [p.arc for p in widest]:
                checker.check(plan.certificate())
            else:
                with pytest.raises(InputError, match="or an inexact gripper"):
                    plan.certificate()

    def test_an_error_that_is_too_large_for_the_best_mouths(self):
        plan = plan_feeding(FOUR_GON, action="push-grasp", gripper_error="10")
        with pytest.raises(InputError, match="or an inexact gripper"):
            plan.certificate()

    def test_other_mouths(self):
        transfer = push_grasp_function(HOUSE)
        widest, second = list(Preimages(transfer))[:2]
        plan = FeedingPlan(transfer, [second], mpq(1), HOUSE, "push-grasp")
        assert widest.arc != second.arc
        with pytest.raises(
            InputError, match="a goal or an inexact gripper makes this another plan"
        ):
            plan.certificate()


# --- by itself -----------------------------------------------------------------------------------


@pytest.fixture(params=ANCHORS, ids=lambda part: part.name)
def file(request, tmp_path):
    path = tmp_path / "plan.json"
    *_, plan = plans_for(request.param)
    path.write_text(json.dumps(plan.certificate()))
    return path


def alone(file):
    """Run a copy of the checker with the standard library only."""
    script = file.with_name("alone.py")
    script.write_bytes(Path(checker.__file__).read_bytes())
    command = [sys.executable, "-I", "-S", script.name, file.name]
    done = subprocess.run(command, cwd=file.parent, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def test_the_checker_alone(file):
    assert alone(file) == (0, "valid\n", "")
    document = json.loads(file.read_text())
    document["push"]["values"][0]["edge"].reverse()
    file.write_text(json.dumps(document))
    code, out, err = alone(file)
    assert (code, err) == (1, "")
    assert out.startswith("invalid: push.values.0.edge.0: claimed ")


def test_symmetries_of_the_anchors():
    """The parts above have composites of all the periods they are there for."""
    periods = {part.name: push_grasp_function(part).period for part in ANCHORS}
    assert periods["square"] == QUARTER_TURN
    assert all(periods[part.name] == FULL_TURN for part in ANCHORS if part is not SQUARE)
    assert push_grasp_function(SPECIAL[1]).period == HALF_TURN
    assert ZERO not in push_grasp_function(SQUARE).breaks
