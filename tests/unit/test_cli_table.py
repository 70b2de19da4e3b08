"""``stochgeom table``: computed beside printed, and what is said where they differ."""

from __future__ import annotations

from dataclasses import replace

import pytest
from gmpy2 import mpq

from stochgeom.cli import table_command
from stochgeom.cli.table_command import table_document, table_text
from stochgeom.exact.angles import HALF_TURN
from stochgeom.exact.ratios import TurnRatio
from stochgeom.thesis.errata import TABLE_4_1
from stochgeom.thesis.tables import Cell, table_4_1
from tests.commands import call

PARTS = ["triangle", "rectangle", "house", "4gon", "5gon", "wrench", "tuning-fork", "key"]


def test_the_table(capsys):
    result = call(capsys, "table", "4.1")
    assert (result.code, result.err) == (0, "")
    lines = result.out.splitlines()
    assert lines[0].startswith("Table 4.1: ")
    rows = {line.split()[0]: " ".join(line.split()) for line in lines if line.startswith("  ")}
    assert list(rows) == ["part", *PARTS]
    assert rows["house"] == ("house 5 5.0304* [ 5.0] 6.0000 [ 6.0] 8.0000 [ 8.0] 10.0000 [10.0]")
    assert rows["4gon"] == (
        "4gon 4 14.2679 [14.3] 11.9814 [12.0] 10.5748 [16.0](1) 10.0000* [10.0]"
    )
    assert "[ 8.2](2)" in rows["key"]
    assert sum("*" in row for row in rows.values()) == 8


def test_the_notes_explain_what_differs(capsys):
    text = call(capsys, "table", "4.1").out
    for number, erratum in enumerate(TABLE_4_1.values(), start=1):
        note = next(line for line in text.splitlines() if line.startswith(f"({number}) "))
        for word in (erratum.where, f"printed {erratum.printed}", erratum.holds, erratum.reason):
            assert word in note
    assert "(3)" not in text


def test_columns_are_aligned(capsys):
    lines = [line for line in call(capsys, "table", "4.1").out.splitlines() if line[:2] == "  "]
    brackets = {tuple(k for k, c in enumerate(line) if c == "[") for line in lines[1:]}
    assert len(brackets) == 1


def test_digits(capsys):
    text = call(capsys, "table", "4.1", "--digits", "1").out
    assert "  9.5  [ 9.5]" in text
    assert "6.3932" not in text
    assert " 10* [10.0]" in call(capsys, "table", "4.1", "--digits", "0").out


def test_the_document(capsys):
    result = call(capsys, "table", "4.1", "--json", "--digits", "2")
    assert (result.code, result.err) == (0, "")
    document = result.document
    assert document["schema"] == "stochgeom/table/1"
    assert document["table"] == "4.1"
    assert [row["part"] for row in document["rows"]] == PARTS
    assert document["rows"][1] == {
        "part": "rectangle",
        "sides": 4,
        "best_steps": 2,
        "cells": [
            {"steps": 1, "computed": "6.39", "printed": "6.4", "agrees": True, "erratum": None},
            {"steps": 2, "computed": "6.00", "printed": "6.0", "agrees": True, "erratum": None},
            {"steps": 3, "computed": "8.00", "printed": "8.0", "agrees": True, "erratum": None},
            {"steps": 4, "computed": "10.00", "printed": "10.0", "agrees": True, "erratum": None},
        ],
    }
    differing = {
        (row["part"], cell["steps"]): cell["erratum"]
        for row in document["rows"]
        for cell in row["cells"]
        if not cell["agrees"]
    }
    assert differing == {place: erratum.reason for place, erratum in TABLE_4_1.items()}


@pytest.fixture
def wrong_rows(monkeypatch):
    """Exchange the first cell for one that nothing explains."""
    first, *others = table_4_1()
    cell = Cell(TurnRatio(mpq(2), HALF_TURN, inverse=True), "9.5", None)
    rows = (replace(first, cells=(cell, *first.cells[1:])), *others)
    monkeypatch.setitem(table_command._TABLES, "4.1", lambda: rows)
    return rows


def test_a_difference_that_nothing_explains_is_a_failed_check(capsys, wrong_rows):
    result = call(capsys, "table", "4.1")
    assert result.code == 1
    assert "(1) differs, and no erratum explains it" in result.out
    assert "4.0000  [ 9.5](1)" in table_text("4.1", wrong_rows, 4)
    assert call(capsys, "table", "4.1", "--json").code == 1
    cell = table_document("4.1", wrong_rows, 4)["rows"][0]["cells"][0]
    assert (cell["agrees"], cell["erratum"]) == (False, None)
