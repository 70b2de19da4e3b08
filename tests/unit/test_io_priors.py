"""Priors read from words, text and JSON, and the messages for what is none."""

from __future__ import annotations

import json

import pytest

from stochgeom.errors import (
    FormatError,
    InputError,
    InvalidArcError,
    NumberError,
    PriorError,
    ReadError,
)
from stochgeom.exact.angles import HALF_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.io.priors import load_prior, parse_prior

QUARTER = Arc(ZERO, Angle.from_degrees(90))


def parse(document):
    return parse_prior(json.dumps(document))


def refusal(call, *arguments):
    with pytest.raises(InputError) as caught:
        call(*arguments)
    assert "accepted" in str(caught.value)
    return caught.value


class TestWords:
    def test_uniform(self):
        assert load_prior("uniform").kind == "uniform"

    def test_normal(self):
        prior = load_prior("normal:-10,1/2")
        assert prior.mean == Angle.from_degrees(350)
        assert prior.sd == 1 / 2

    def test_von_mises(self):
        assert load_prior("von-mises:0,2.5").kappa == 5 / 2

    @pytest.mark.parametrize("word", ["normal:1", "normal:1,2,3", "von-mises:", "normal:1 2"])
    def test_other_counts_of_numbers(self, word):
        assert isinstance(refusal(load_prior, word), FormatError)

    @pytest.mark.parametrize(
        ("word", "error", "where"),
        [
            ("normal:x,1", NumberError, "prior normal"),
            ("normal:0,0", PriorError, None),
            ("normal:0,-1", PriorError, None),
            ("von-mises:0,-1", PriorError, None),
            ("normal:0,nan", NumberError, "prior normal"),
        ],
    )
    def test_bad_numbers(self, word, error, where):
        found = refusal(load_prior, word)
        assert type(found) is error
        assert found.where == where

    @pytest.mark.parametrize("word", ["no/such/file", "Normal:1,2", "gauss:1,2", "", "\0"])
    def test_neither_word_nor_file(self, word):
        assert isinstance(refusal(load_prior, word), ReadError)


class TestLines:
    def test_orientations_and_counts(self):
        prior = parse_prior("\ufeff# seen\n\n 12.5 \n372.5\n40, 2 # twice\n")
        assert [(a.degrees(1), w) for a, w in prior] == [("12.5", 1 / 2), ("40.0", 1 / 2)]

    @pytest.mark.parametrize(
        ("text", "error", "where"),
        [
            ("", FormatError, None),
            ("# nothing\n", FormatError, None),
            ("1\n2 3 4\n", FormatError, "line 2"),
            ("1\nabc\n", NumberError, "line 2"),
            ("# seen\n1\n2 -3\n", PriorError, "line 3"),
            ("1 x\n", NumberError, "line 1"),
            ("1 0\n2 0\n", PriorError, None),
            ("1 1e999999999", NumberError, "line 1"),
        ],
    )
    def test_bad_lines(self, text, error, where):
        found = refusal(parse_prior, text)
        assert isinstance(found, error)
        assert found.where == where


class TestJson:
    @pytest.mark.parametrize(
        ("document", "mass"),
        [
            ({"kind": "uniform"}, 1 / 4),
            ({"kind": "discrete", "points": [[0, "3/8"], ["90", 0.625]]}, 3 / 8),
            ({"kind": "measurements", "degrees": ["10.5", 20, 200, 300]}, 1 / 2),
            ({"kind": "binned measurements", "degrees": [1, "44.5", 45, 200], "bins": 8}, 3 / 4),
            ({"kind": "histogram", "edges": [0, 180, 360], "counts": [3, 1]}, 3 / 8),
            ({"kind": "piecewise", "pieces": [[45, "90", 4]]}, 1 / 2),
            (
                {
                    "kind": "mixture",
                    "components": [
                        ["1/2", {"kind": "uniform"}],
                        [0.5, {"kind": "discrete", "points": [[5, 1]]}],
                    ],
                },
                5 / 8,
            ),
        ],
    )
    def test_exact_kinds(self, document, mass):
        assert parse(document).mass(QUARTER).rational == mass

    @pytest.mark.parametrize(
        "document",
        [
            {"kind": "normal", "mean": 90, "sd": "30"},
            {"kind": "von mises", "mean": "90", "kappa": 2},
        ],
    )
    def test_certified_kinds(self, document):
        half = Arc(ZERO, HALF_TURN)
        assert parse(document).mass(half).compare("1/2") == 1

    @pytest.mark.parametrize(
        ("document", "error", "where", "word"),
        [
            ([1, 2], FormatError, None, "a list of 2"),
            ({}, FormatError, "kind", "null"),
            ({"kind": 3}, FormatError, "kind", "the number 3"),
            ({"kind": "gauss"}, FormatError, "kind", "'gauss'"),
            ({"kind": "normal", "mean": 1}, FormatError, "kind", "mean, sd"),
            ({"kind": "uniform", "x": 1}, FormatError, "kind", "'x'"),
            ({"kind": "normal", "mean": [], "sd": 1}, FormatError, "mean", "a list of 0"),
            ({"kind": "normal", "mean": "a", "sd": 1}, NumberError, "mean", "'a'"),
            ({"kind": "discrete", "points": 3}, FormatError, "points", "the number 3"),
            ({"kind": "discrete", "points": [[1]]}, FormatError, "points 0", "a list of 1"),
            ({"kind": "discrete", "points": [[1, None]]}, FormatError, "points 0 1", "null"),
            ({"kind": "discrete", "points": []}, PriorError, None, "no points"),
            ({"kind": "discrete", "points": [[0, "1/3"]]}, PriorError, None, "sum to 1/3"),
            ({"kind": "measurements", "degrees": []}, PriorError, None, ""),
            ({"kind": "binned measurements", "degrees": [1], "bins": 0}, PriorError, "bins", "0 b"),
            ({"kind": "binned measurements", "degrees": [1], "bins": 1.5}, PriorError, "bins", ""),
            ({"kind": "binned measurements", "degrees": [], "bins": 8}, PriorError, "degrees", ""),
            ({"kind": "histogram", "edges": [9, 5], "counts": [1]}, PriorError, None, ""),
            ({"kind": "histogram", "edges": [1], "counts": [1]}, PriorError, None, ""),
            ({"kind": "piecewise", "pieces": [[0, 90, 1]]}, PriorError, None, "1/4"),
            ({"kind": "piecewise", "pieces": [[0, 0, 1]]}, InvalidArcError, "pieces 0 1", "0.0000"),
            (
                {"kind": "mixture", "components": [[1, {"kind": "normal", "mean": 0, "sd": -1}]]},
                PriorError,
                "components 0 1",
                "standard deviation -1",
            ),
            (
                {"kind": "mixture", "components": [[1, {"kind": "discrete", "points": [[0, -1]]}]]},
                PriorError,
                "components 0 1, point 0",
                "weight -1 is negative",
            ),
            (
                {"kind": "mixture", "components": [[1, {"kind": "normal", "mean": 0, "sd": "x"}]]},
                NumberError,
                "components 0 1, sd",
                "'x'",
            ),
        ],
    )
    def test_refused(self, document, error, where, word):
        found = refusal(parse, document)
        assert isinstance(found, error)
        assert word in found.message
        assert where is None or found.where == where

    def test_broken_json(self):
        assert refusal(parse_prior, '{"kind": ').where == "line 1, column 10"

    def test_nested_mixtures_end(self):
        document = {"kind": "uniform"}
        for _ in range(30):
            document = {"kind": "mixture", "components": [[1, document]]}
        assert "deep" in refusal(parse, document).message


class TestFiles:
    def test_a_file(self, tmp_path):
        path = tmp_path / "seen.txt"
        path.write_text("10\n20\n", encoding="utf-8")
        assert load_prior(str(path)).mass(QUARTER).rational == 1

    def test_the_file_is_named(self, tmp_path):
        path = tmp_path / "seen.txt"
        path.write_text("10\nx\n", encoding="utf-8")
        assert refusal(load_prior, str(path)).where == f"{path}, line 2"

    def test_a_folder(self, tmp_path):
        assert "directory" in str(refusal(load_prior, str(tmp_path)))

    def test_other_bytes(self, tmp_path):
        path = tmp_path / "seen.bin"
        path.write_bytes(b"\xff\xfe")
        assert refusal(load_prior, str(path)).where == f"{path}, byte 0"
