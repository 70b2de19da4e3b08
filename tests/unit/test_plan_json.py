"""Documents of schema stochgeom/plan/1: literal, by the contract, and read back."""

from __future__ import annotations

import json
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import Angle
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.io.load import part_of
from stochgeom.io.outlines import parse_outline
from stochgeom.io.plan_json import angle_json, part_json, plan_document
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from tests.plan_documents import (
    Transfer,
    angle_of,
    check_document,
    decimal_of,
    exact,
    final_orientations,
)
from tests.strategies import angles, parts, rational_parts

HALF = {"turns": 0, "direction": ["-1", "0"], "degrees": "180.0000"}
RIGHT = {"turns": 0, "direction": ["0", "1"], "degrees": "90.0000"}
ZERO = {"turns": 0, "direction": ["1", "0"], "degrees": "0.0000"}
LOW_BREAK = {"turns": 0, "direction": ["2", "3"], "degrees": "56.3099"}
HIGH_BREAK = {"turns": 0, "direction": ["-2", "3"], "degrees": "123.6901"}

RECTANGLE_PLAN = {
    "steps": 2,
    "actions": [
        {"angle": ZERO, "low": None, "high": None},
        {
            "angle": {"turns": -1, "direction": ["1", "-1"], "degrees": "-45.0000"},
            "low": {"turns": -1, "direction": ["2", "-3"], "degrees": "-56.3099"},
            "high": {"turns": -1, "direction": ["3", "-2"], "degrees": "-33.6901"},
        },
    ],
    "mouth": {"start": LOW_BREAK, "width": HALF},
    "expected_cost": "6.0000",
    "probability": "0.5000",
    "expected_cost_up_to_symmetry": "3.0000",
    "probability_up_to_symmetry": "1.0000",
    "orients_up_to_symmetry": True,
    "margin": {"turns": 0, "direction": ["5", "1"], "degrees": "11.3099"},
    "error_bound": {
        "doubled": {"turns": 0, "direction": ["12", "5"], "degrees": "22.6199"},
        "degrees": "11.3099",
    },
}

RECTANGLE = {
    "schema": "stochgeom/plan/1",
    "part": {
        "name": "rectangle",
        "vertices": [["0", "0"], ["3", "0"], ["3", "2"], ["0", "2"]],
        "center_of_mass": ["3/2", "1"],
    },
    "transfer": {
        "action": "squeeze",
        "period": HALF,
        "breaks": [LOW_BREAK, HIGH_BREAK],
        "values": [RIGHT, HALF],
    },
    "cost_ratio": "1",
    "preimages": [
        {
            "steps": 1,
            "start": HIGH_BREAK,
            "width": {"turns": 0, "direction": ["-5", "12"], "degrees": "112.6199"},
            "image_width": ZERO,
            "expected_cost": "6.3932",
            "probability": "0.3128",
        },
        {
            "steps": 2,
            "start": LOW_BREAK,
            "width": HALF,
            "image_width": RIGHT,
            "expected_cost": "6.0000",
            "probability": "0.5000",
        },
    ],
    "plan": RECTANGLE_PLAN,
    "geometric_plan": RECTANGLE_PLAN,
}


def document_of(part, cost_ratio=1, digits=4):
    """Return the document as its reader sees it."""
    problem = FeedingProblem(part)
    optimal = problem.optimal_plan(cost_ratio)
    document = plan_document(problem, optimal, problem.geometric_plan(cost_ratio), digits)
    return json.loads(json.dumps(document))


def test_the_rectangle_literally():
    assert document_of(catalogue_part("rectangle")) == RECTANGLE


def test_keys_stand_in_the_order_of_the_contract():
    text = json.dumps(document_of(catalogue_part("rectangle")))
    assert text == json.dumps(RECTANGLE)


@pytest.mark.parametrize("name", catalogue_names())
@pytest.mark.parametrize("cost_ratio", ["0", "1", "1/3", "7.25"])
@pytest.mark.parametrize("digits", [0, 4, 12])
def test_the_contract_holds_for_the_catalogue(name, cost_ratio, digits):
    document = document_of(catalogue_part(name), cost_ratio, digits)
    check_document(document, digits, Fraction(cost_ratio))


@given(parts(), st.fractions(0, 3, max_denominator=9))
def test_the_contract_holds(part, cost_ratio):
    check_document(document_of(part, cost_ratio), cost_ratio=cost_ratio)


@given(rational_parts(), st.booleans())
def test_a_document_is_a_source_of_the_same_document(part, whole):
    document = document_of(part)
    text = json.dumps(document if whole else document["part"])
    assert document_of(part_of(parse_outline(text))) == document


@given(parts())
def test_a_transfer_function_is_read_back(part):
    problem = FeedingProblem(part)
    document = document_of(part)
    read = Transfer(document["transfer"])
    assert read.period == problem.transfer.period
    assert read.order == problem.transfer.order
    assert read.breaks == list(problem.transfer.breaks)
    assert read.values == list(problem.transfer.values)
    for theta in [*read.breaks, *read.values, Angle(-3, (7, -2)), Angle("13/7")]:
        assert read(theta) == problem.transfer(theta)


@given(angles(), st.integers(0, 15))
def test_an_angle_is_read_back(angle, digits):
    assert angle_of(json.loads(json.dumps(angle_json(angle, digits))), digits) == angle


@given(angles(), st.integers(-4, 4), st.integers(1, 40))
def test_unequal_angles_are_written_differently(angle, numerator, denominator):
    other = angle + Angle(Fraction(numerator, denominator))
    assert (exact(angle_json(other)) == exact(angle_json(angle))) is (numerator == 0)


@pytest.mark.parametrize(
    ("angle", "document"),
    [
        (Angle(0, (3, 2)), {"turns": 0, "direction": ["3", "2"], "degrees": "33.6901"}),
        (Angle("1/3"), {"turns": "1/3", "direction": ["1", "0"], "degrees": "120.0000"}),
        (Angle("-1/3"), {"turns": "-1/3", "direction": ["1", "0"], "degrees": "-120.0000"}),
        (Angle("5/8"), {"turns": 0, "direction": ["-1", "-1"], "degrees": "225.0000"}),
        (Angle("1/3", (0, 1)), {"turns": "7/12", "direction": ["1", "0"], "degrees": "210.0000"}),
        (Angle(1), {"turns": 1, "direction": ["1", "0"], "degrees": "360.0000"}),
    ],
)
def test_angles_literally(angle, document):
    assert angle_json(angle) == document
    assert angle_of(document) == angle


def test_ties_are_rounded_to_even():
    eighth = [Angle.from_degrees(text) for text in ("0.5", "1.5", "-0.5", "2.25", "2.35")]
    assert [angle_json(a, 0)["degrees"] for a in eighth] == ["0", "2", "0", "2", "2"]
    assert [angle_json(a, 1)["degrees"] for a in eighth[3:]] == ["2.2", "2.4"]


def test_at_its_lower_end_a_second_action_fails():
    """The image of the mouth is exact before the second action, so `low` is the limit."""
    document = document_of(catalogue_part("rectangle"))
    plan, transfer = document["plan"], Transfer(document["transfer"])
    nominal, low = (exact(plan["actions"][1][key]) for key in ("angle", "low"))
    assert len(final_orientations(plan, transfer, [Angle(), nominal])) == 1
    assert len(final_orientations(plan, transfer, [Angle(), low])) == 2


def test_a_part_without_a_name_and_with_a_hole():
    outline, hole = [(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (2, 1), (2, 2)]
    document = part_json(Part(outline, holes=[hole]))
    assert document == {
        "name": None,
        "vertices": [["0", "0"], ["4", "0"], ["4", "4"], ["0", "4"]],
        # (16 (2, 2) - 1/2 (5/3, 4/3)) / (31/2)
        "center_of_mass": ["187/93", "188/93"],
        "holes": [[["1", "1"], ["2", "1"], ["2", "2"]]],
    }
    assert (
        part_of(parse_outline(json.dumps(document))).center_of_mass
        == Part(outline, holes=[hole]).center_of_mass
    )


def test_rational_coordinates_are_text_in_lowest_terms():
    part = Part([("1/3", "0.5"), ("2/4", 0), (10**30, "-1e-3")], center_of_mass=("6/4", -2))
    document = part_json(part)
    assert document["vertices"] == [["1/3", "1/2"], ["1/2", "0"], [f"1{'0' * 30}", "-1/1000"]]
    assert document["center_of_mass"] == ["3/2", "-2"]


class TestTheReaderOfDocuments:
    """The checker refuses what it should."""

    @pytest.mark.parametrize(
        "change",
        [
            {"turns": 0.0},
            {"turns": "0"},
            {"turns": "2/6", "direction": ["1", "0"]},
            {"direction": ["6", "4"]},
            {"direction": [3, 2]},
            {"direction": ["3", "2.0"]},
            {"degrees": "33.6900"},
            {"degrees": "33.690"},
            {"degrees": 33.6901},
            {"turns": "1/3", "direction": ["3", "4"]},
            {"radians": "1"},
        ],
    )
    def test_angles_out_of_form(self, change):
        document = {"turns": 0, "direction": ["3", "2"], "degrees": "33.6901", **change}
        with pytest.raises(AssertionError):
            angle_of(document)

    @pytest.mark.parametrize(
        ("path", "value"),
        [
            (["schema"], "stochgeom/plan/2"),
            (["part", "vertices", 0], [0, 0]),
            (["part", "center_of_mass"], ["6/4", "1"]),
            (["transfer", "values", 0], LOW_BREAK),
            (["preimages", 0, "expected_cost"], "6.3933"),
            (["preimages", 0, "image_width"], RIGHT),
            (["plan", "probability"], "0.5"),
            (["plan", "orients_up_to_symmetry"], False),
            (["plan", "actions", 0, "low"], ZERO),
            (["plan", "actions", 1, "angle"], ZERO),
            (["plan", "actions", 1, "high"], ZERO),
            (["plan", "mouth", "start"], RIGHT),
        ],
    )
    def test_documents_out_of_form(self, path, value):
        document = json.loads(json.dumps(RECTANGLE))
        check_document(document)
        place = document
        for key in path[:-1]:
            place = place[key]
        place[path[-1]] = value
        with pytest.raises(AssertionError):
            check_document(document)

    def test_decimals(self):
        assert decimal_of(Fraction(1, 8), 2) == "0.12"
        assert decimal_of(Fraction(3, 8), 2) == "0.38"
        assert decimal_of(Fraction(-1, 3), 0) == "0"
        assert decimal_of(Fraction(-7, 2), 0) == "-4"
