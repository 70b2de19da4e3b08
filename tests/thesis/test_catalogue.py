"""The catalogue: eight parts, each with everything printed about it."""

from __future__ import annotations

import json
import re
from importlib.resources import files

import pytest
from gmpy2 import mpq

from stochgeom.errors import UnknownPartError
from stochgeom.geometry.part import Part
from stochgeom.io.load import part_of
from stochgeom.io.outlines import parse_outline
from stochgeom.io.plan_json import part_json
from stochgeom.thesis.errata import TABLE_4_1
from stochgeom.thesis.parts import catalogue_entry, catalogue_names, catalogue_part

DATA = json.loads(files("stochgeom.thesis").joinpath("data/parts.json").read_text(encoding="utf-8"))

SIDES = {
    "triangle": 3,
    "rectangle": 4,
    "house": 5,
    "4gon": 4,
    "5gon": 5,
    "wrench": 6,
    "tuning-fork": 6,
    "key": 11,
}

NOT_REPRODUCED = {
    ("rectangle", "C.1 mu=0.05"),
    ("4gon", "T4.1 3-step"),
    ("4gon", "E.5 plan angle 1 (cumulative, mid-slack, sense that yields the trace)"),
    ("4gon", "E.5 plan angle 2 (cumulative, mid-slack, sense that yields the trace)"),
    ("4gon", "E.5 plan angle 3 (cumulative, mid-slack, sense that yields the trace)"),
    ("4gon", "E text: 1-step cost = minimum"),
    ("key", "T4.1 3-step"),
}
"""Cells that no part with the rest of the printed numbers can have; the errata name each."""

each_part = pytest.mark.parametrize("name", catalogue_names())


def test_the_names_are_those_of_the_source():
    assert catalogue_names() == tuple(SIDES) == tuple(DATA)


@each_part
def test_a_part_is_valid(name):
    part = catalogue_part(name)
    assert part.name == name
    assert len(part) == catalogue_entry(name).sides_printed == SIDES[name]
    assert part.area > 0
    assert part.center_of_mass_side == 1
    assert part == catalogue_entry(name).part
    # Made anew, so that nothing rests on what was kept.
    assert Part(part.vertices, part.center_of_mass, name) == part


@each_part
def test_all_parts_but_the_key_are_convex(name):
    part = catalogue_part(name)
    assert (len(part.hull) == len(part)) is (name != "key")
    assert len(catalogue_part("key").hull) == 7


@each_part
def test_cells_are_text_and_flags(name):
    entry = catalogue_entry(name)
    assert isinstance(entry.center_of_mass_is, str)
    assert entry.center_of_mass_is
    assert type(entry.sides_printed) is int
    assert set(entry.printed) == set(entry.reproduced)
    for cell, text in entry.printed.items():
        assert isinstance(cell, str)
        assert isinstance(text, str)
        assert re.fullmatch(r"-?[0-9]+(\.[0-9]+)?", text)
    assert all(type(flag) is bool for flag in entry.reproduced.values())
    shared = {f"T4.1 {steps}-step" for steps in (1, 2, 3, 4)}
    shared |= {f"{table} mu={mu}" for table in ("T3.1", "C.1") for mu in ("0.25", "0.1", "0.05")}
    assert shared <= set(entry.printed)


def test_what_is_not_reproduced():
    found = {
        (name, cell)
        for name in catalogue_names()
        for cell, flag in catalogue_entry(name).reproduced.items()
        if not flag
    }
    assert found == NOT_REPRODUCED
    in_table = {(name, int(cell[5])) for name, cell in found if cell.startswith("T4.1 ")}
    assert in_table == set(TABLE_4_1)


@pytest.mark.parametrize(
    ("name", "center"),
    [
        ("triangle", ("31/3", 7)),
        ("rectangle", ("3/2", 1)),
        ("house", (0, 0)),
        ("tuning-fork", (12, 6)),
    ],
)
def test_centres_of_mass(name, center):
    assert catalogue_part(name).center_of_mass == (mpq(center[0]), mpq(center[1]))


@each_part
def test_how_the_centre_of_mass_was_chosen(name):
    part, how = catalogue_part(name), catalogue_entry(name).center_of_mass_is
    assert part.has_given_center
    assert (part.center_of_mass == part.centroid) is (how == "uniform centroid")
    if how == "centre of the bounding box":
        columns = list(zip(*part.vertices, strict=True))
        assert part.center_of_mass == tuple((min(c) + max(c)) / 2 for c in columns)
    if "coordinate origin" in how:
        assert part.center_of_mass == (0, 0)


def test_the_walls_of_the_house_are_as_long_as_its_base():
    corners = catalogue_part("house").vertices
    squares = [
        (x - u) ** 2 + (y - v) ** 2
        for (x, y), (u, v) in zip(corners, corners[1:] + corners[:1], strict=True)
    ]
    assert squares[0] == squares[1] == squares[4] == 4


def test_the_side_ratio_of_the_rectangle_is_in_the_range_the_numbers_allow():
    (_, _), (width, _), (_, height), _ = catalogue_part("rectangle").vertices
    assert mpq(1472, 1000) < width / height < mpq(1522, 1000)


@each_part
def test_the_data_file_round_trip(name):
    """What the file holds, the catalogue gives; what the catalogue gives, a file holds."""
    part, entry = catalogue_part(name), DATA[name]
    document = part_json(part)
    assert document == {
        "name": name,
        "vertices": entry["vertices"],
        "center_of_mass": entry["center_of_mass"],
    }
    assert part_of(parse_outline(json.dumps(document))) == part
    bare = {key: entry[key] for key in ("vertices", "center_of_mass")}
    assert part_of(parse_outline(json.dumps(bare), name=name)) == part


@each_part
def test_coordinates_are_text_in_lowest_terms(name):
    for x, y in [*DATA[name]["vertices"], DATA[name]["center_of_mass"]]:
        assert (x, y) == (str(mpq(x)), str(mpq(y)))


@pytest.mark.parametrize("name", ["hexagon", "", "House", "tuning fork"])
def test_an_unknown_name(name):
    with pytest.raises(UnknownPartError, match="accepted: triangle, rectangle, house, 4gon, "):
        catalogue_part(name)


def test_an_entry_is_made_once():
    assert catalogue_part("key") is catalogue_part("key")
