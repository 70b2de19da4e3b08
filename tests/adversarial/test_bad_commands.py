"""Commands that cannot be done: exit code 2, one line that says what, where and what is accepted.

Every call is made with ``--json`` as well, which adds the error as a document on stdout.
"""

from __future__ import annotations

import json
import sys

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from stochgeom.cli.main import main
from stochgeom.thesis.parts import catalogue_names
from tests.commands import call, start

NUMBERS = "accepted: whole numbers, fractions and decimals"


def assert_refuses(capsys, arguments, kind, where, *words):
    """Both ways of calling refuse in the same words; nothing else is printed.

    Of several pairs of edges that meet, any may be named: `where` may be a tuple.
    """
    plain = call(capsys, *arguments)
    assert plain.code == 2
    assert plain.out == ""
    assert plain.err.startswith("stochgeom: ")
    assert plain.err.count("\n") == 1
    assert plain.err[:-1].isprintable()
    for word in words:
        assert word in plain.err
    result = call(capsys, *arguments, "--json")
    assert (result.code, result.err) == (2, plain.err)
    assert list(result.document) == ["error"]
    error = result.document["error"]
    assert list(error) == ["type", "message", "where"]
    assert error["type"] == kind
    assert error["where"] in (where if isinstance(where, tuple) else (where,))
    assert "accepted: " in error["message"] or kind == "UsageError"
    prefix = "" if where is None else f"{error['where']}: "
    assert len(plain.err) > 1000 or plain.err == f"stochgeom: {prefix}{error['message']}\n"


@pytest.mark.parametrize(
    ("vertices", "kind", "where", "words"),
    [
        ("", "FormatError", "--vertices", ["empty; accepted: "]),
        (" ", "FormatError", "--vertices", ["empty; accepted: "]),
        (
            "0,0",
            "TooFewVerticesError",
            "outline",
            ["no 3 distinct vertices, only 1; accepted: at least 3"],
        ),
        (
            "0,0 1,1",
            "TooFewVerticesError",
            "outline",
            ["no 3 distinct vertices, only 2; accepted: at least 3"],
        ),
        ("0,0 1,1 0,0 1,1", "TooFewVerticesError", "outline", ["only 2"]),
        ("0,0 0,0 1,1 1,1 1,1", "TooFewVerticesError", "outline", ["only 2"]),
        (
            "0,0 1,1 2,2",
            "CollinearOutlineError",
            "outline",
            ["all 3 vertices lie on one line; acc"],
        ),
        ("-1,0 5,0 1/3,0 0.1,0", "CollinearOutlineError", "outline", ["all 4 vertices"]),
        (
            "0,0 1,1 1,0 0,1",
            "SelfIntersectionError",
            "edges 0 and 2",
            ["edge 0 from (0, 0) to (1, 1) and edge 2 from (1, 0) to (0, 1) cross; accepted: "],
        ),
        (
            "0,0 4,0 4,4 2,0 0,4",
            "SelfIntersectionError",
            ("edges 0 and 2", "edges 0 and 3"),
            ["touch; accepted: an outline that does not meet itself"],
        ),
        (
            "0,0 4,0 4,4 3,0 1,0 0,4",
            "SelfIntersectionError",
            ("edges 0 and 2", "edges 0 and 3", "edges 0 and 4"),
            ["; accepted: an outline that does not meet itself"],
        ),
        ("0,0 2,0 1,0 1,1", "SelfIntersectionError", "edges 0 and 1", ["overlap"]),
        ("0,0 1,0 1,nan", "NumberError", "--vertices, vertex 2, y", ["'nan' is not", NUMBERS]),
        ("0,0 NaN,0 1,1", "NumberError", "--vertices, vertex 1, x", ["'NaN' is not", NUMBERS]),
        ("0,0 inf,0 1,1", "NumberError", "--vertices, vertex 1, x", ["'inf' is not", NUMBERS]),
        ("-inf,0 1,0 1,1", "NumberError", "--vertices, vertex 0, x", ["'-inf' is not", NUMBERS]),
        ("0,0 1,0 1,Infinity", "NumberError", "--vertices, vertex 2, y", ["'Infinity' is not"]),
        (
            "0,0 1,0 1,1e999999999",
            "NumberLimitError",
            "--vertices, vertex 2, y",
            ["'1e999999999' has the exponent 999999999; accepted: exponents from -10000 to 10000"],
        ),
        (
            "0,0 1,0 1," + "7" * 20_001,
            "NumberLimitError",
            "--vertices, vertex 2, y",
            ["number text of 20001 characters", "accepted: at most 20000 characters"],
        ),
        ("0,0 1,0 1,1/0", "NumberError", "--vertices, vertex 2, y", ["divides by zero; accepted"]),
        ("0,0 1,0 1", "FormatError", "--vertices, vertex 2", ["'1' has 1 field; accepted: "]),
        ("0,0,3,0", "FormatError", "--vertices, vertex 0", ["4 fields; accepted: "]),
        ("0,0 1,0 \x1b[31m,\x07", "NumberError", "--vertices, vertex 2, x", ["\\x1b[31m"]),
        ("0,0 1,0 \udcff,1", "NumberError", "--vertices, vertex 2, x", ["\\udcff"]),
    ],
    ids=lambda value: value[:40] if isinstance(value, str) else None,
)
def test_vertices(capsys, vertices, kind, where, words):
    assert_refuses(capsys, ["plan", "--vertices", vertices], kind, where, *words)
    assert_refuses(capsys, ["plan", f"--vertices={vertices}"], kind, where, *words)


@pytest.mark.parametrize(
    ("content", "kind", "where", "words"),
    [
        ("", "FormatError", None, ["the text is empty; accepted: JSON, WKT POLYGON, or a vertex"]),
        (
            "0 0\n1 0\n",
            "TooFewVerticesError",
            "outline",
            ["no 3 distinct vertices, only 2; accepted: at least 3"],
        ),
        ("0 0\n1 0\n\nx 1\n", "NumberError", "line 4, x", ["'x' is not a number", NUMBERS]),
        (
            "0 0\n1 1\n1 0\n0 1\n",
            "SelfIntersectionError",
            "edges 0 and 2 (which begin at line 1 and line 3)",
            ["cross; accepted: "],
        ),
        (
            '{"vertices": [[0, 0], [1, 0], [0',
            "FormatError",
            "line 1, column 33",
            ["broken JSON: ", "(the text ends here); accepted: "],
        ),
        ('{"vertices": [[0, 0], [1, 0], [0, NaN]]}', "NumberError", "vertex 2, y", ["'NaN' is"]),
        ("[[0, 0], [1, 0], [0, 1e999999999]]", "NumberLimitError", "vertex 2, y", ["exponent"]),
        ('{"vertexes": [[0, 0]]}', "FormatError", "key 'vertexes'", ['close to "vertices"; acc']),
        ("{}", "FormatError", None, ['no key "vertices"', "accepted: "]),
        (
            "LINESTRING (0 0, 1 0, 0 1)",
            "FormatError",
            "line 1, column 1",
            ["'LINESTRING' is not read; accepted: ", "POLYGON (("],
        ),
        ("MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)))", "FormatError", "line 1, column 1", ["'MULTI"]),
        ("POLYGON Z ((0 0 0, 1 0 0, 0 1 0))", "FormatError", "line 1, column 1", ["POLYGON Z"]),
        ("POLYGON ((0 0, 1 0, 0 1", "FormatError", "line 1, column 24", ["the end of the text"]),
        (
            "POLYGON ((0 0, 4 0, 4 4, 0 4), (5 5, 6 5, 5 6))",
            "InvalidHoleError",
            "hole 0",
            ["it lies outside the outline; accepted: holes inside it"],
        ),
        (
            "POLYGON ((0 0, 4 0, 4 4, 0 4), (1 1, 2 2, 3 3))",
            "CollinearOutlineError",
            "hole 0",
            ["all 3 vertices lie on one line; accepted: "],
        ),
        ("<svg/>", "FormatError", "line 1", ["'<svg/>' begins no outline; accepted: "]),
    ],
    ids=lambda value: value[:40] if isinstance(value, str) else None,
)
def test_files(capsys, tmp_path, content, kind, where, words):
    path = tmp_path / "outline"
    path.write_text(content)
    assert_refuses(capsys, ["plan", str(path)], kind, where, *words)


@pytest.mark.parametrize(
    ("content", "where"),
    [(b"\x89PNG\r\n\x1a\n", "byte 0"), (b"0 0\n1 0\n\xff\xfe", "byte 8"), (b"\0\xc0", "byte 1")],
)
def test_files_that_are_no_text(capsys, tmp_path, content, where):
    path = tmp_path / "outline"
    path.write_bytes(content)
    assert_refuses(capsys, ["plan", str(path)], "FormatError", where, "accepted: UTF-8 text")


class TestNamesOfSources:
    def test_an_unknown_part(self, capsys):
        words = (
            f"accepted: {', '.join(catalogue_names())}, regular-N, a file, or - for standard input"
        )
        assert_refuses(capsys, ["plan", "hous"], "ReadError", "hous", words)

    def test_a_missing_file(self, capsys, tmp_path):
        path = str(tmp_path / "missing.txt")
        assert_refuses(capsys, ["plan", path], "ReadError", path, "accepted: ")

    def test_an_unreadable_file(self, capsys, tmp_path):
        """A directory: mode bits do not keep root from reading."""
        path = str(tmp_path)
        assert_refuses(capsys, ["plan", path], "ReadError", path, "accepted: a readable text file")

    def test_a_file_for_a_directory(self, capsys, tmp_path):
        (tmp_path / "file").touch()
        path = str(tmp_path / "file" / "outline")
        assert_refuses(capsys, ["plan", path], "ReadError", path, "accepted: a readable text file")

    def test_nothing(self, capsys):
        assert_refuses(capsys, ["plan", ""], "ReadError", None, "the name is empty; accepted: ")

    def test_a_null_in_a_path(self, capsys):
        assert_refuses(capsys, ["plan", "a\0b"], "ReadError", "a?b", "accepted: ")

    def test_a_line_break_in_a_path(self, capsys):
        assert_refuses(capsys, ["plan", "a\nb"], "ReadError", "a?b", "accepted: ")

    def test_an_escape_sequence_in_a_path(self, capsys):
        assert_refuses(capsys, ["plan", "\x1b[2J"], "ReadError", "?[2J", "accepted: ")

    def test_a_very_long_path(self, capsys):
        path = "x" * 10_000
        assert_refuses(capsys, ["plan", path], "ReadError", path, "accepted: ")

    @pytest.mark.parametrize("path", ["a\udcffb", "\ud800", "\udcff" * 5000])
    def test_surrogates(self, capsys, path):
        shown = "".join("?" if "\ud800" <= c <= "\udfff" else c for c in path)
        assert_refuses(capsys, ["plan", path], "ReadError", shown, "accepted: ")


@pytest.mark.parametrize(
    ("options", "kind", "where", "words"),
    [
        ([], "InputError", None, ["neither SOURCE nor --vertices given; accepted: one of them"]),
        (
            ["house", "--vertices", "0,0 1,0 0,1"],
            "InputError",
            None,
            ["both SOURCE and --vertices given; accepted: one of them"],
        ),
        (["house", "--cost-ratio", "-1"], "CostError", "cost ratio", ["-1 is negative; accepted"]),
        (["house", "--cost-ratio=-1/3"], "CostError", "cost ratio", ["-1/3 is negative; acc"]),
        (["house", "--cost-ratio", "-1e-9"], "CostError", "cost ratio", ["is negative; accepted"]),
        (["house", "--cost-ratio", "nan"], "CostError", "cost ratio", ["'nan' is not", NUMBERS]),
        (["house", "--cost-ratio", "inf"], "CostError", "cost ratio", ["'inf' is not", NUMBERS]),
        (["house", "--cost-ratio", "-inf"], "CostError", "cost ratio", ["'-inf' is not", NUMBERS]),
        (["house", "--cost-ratio", ""], "CostError", "cost ratio", ["'' is not", NUMBERS]),
        (["house", "--cost-ratio", "1e999999999"], "CostError", "cost ratio", ["exponents from"]),
        (["house", "--center-of-mass", "1"], "FormatError", "center of mass", ["1 field; accept"]),
        (["house", "--center-of-mass", "-nan,2"], "NumberError", "center of mass, x", [NUMBERS]),
        (["house", "--center-of-mass", "1,2,3"], "FormatError", "center of mass", ["3 fields"]),
        (["house", "--center-of-mass", ""], "FormatError", "center of mass", ["0 fields"]),
        (["house", "--digits", "-1"], "InputError", "--digits", ["'-1' decimals; accepted: "]),
        (["house", "--digits", "abc"], "InputError", "--digits", ["whole numbers from 0 to 1000"]),
        (["house", "--digits", "1.5"], "InputError", "--digits", ["whole numbers from 0 to 1000"]),
        (["house", "--digits", "1000000000"], "InputError", "--digits", ["from 0 to 100000"]),
        (["house", "--digits", "9" * 5000], "InputError", "--digits", ["from 0 to 100000"]),
        (
            ["house", "--digits"],
            "UsageError",
            "--digits",
            ["expected one argument; see stochgeom "],
        ),
        (["house", "key"], "UsageError", None, ["unrecognized arguments: key; see stochgeom --h"]),
        (["house", "--frobnicate"], "UsageError", None, ["--frobnicate; see stochgeom --help"]),
        (["house", "-v"], "UsageError", None, ["unrecognized arguments: -v"]),
        (
            ["house", "--action", "push"],
            "UsageError",
            "--action",
            ["'push' (choose from", "squeeze"],
        ),
        (["house", "--json=yes"], "UsageError", "--json", ["'yes'; see stochgeom plan --help"]),
    ],
    ids=lambda value: " ".join(value)[:40] if isinstance(value, list) else None,
)
def test_options(capsys, options, kind, where, words):
    assert_refuses(capsys, ["plan", *options], kind, where, *words)


@pytest.mark.parametrize(
    ("arguments", "kind", "where", "words"),
    [
        ([], "UsageError", None, ["required: COMMAND; see stochgeom --help"]),
        (["frobnicate"], "UsageError", "COMMAND", ["'frobnicate' (choose from", "plan", "table"]),
        ([""], "UsageError", "COMMAND", ["(choose from"]),
        (["\udcff"], "UsageError", "COMMAND", ["(choose from"]),
        (["--frobnicate"], "UsageError", None, ["COMMAND; see stochgeom --help"]),
        (["table"], "UsageError", None, ["required: NUMBER; see stochgeom table --help"]),
        (
            ["table", "9"],
            "UnknownReproductionError",
            "NUMBER",
            ["no table '9'", "3.1, 4.1"],
        ),
        (["table", "4.1", "--digits", "x"], "InputError", "--digits", ["'x' decimals; accepted: "]),
        (["table", "4.1", "--digits", "-1"], "InputError", "--digits", ["'-1' decimals; accepted"]),
        (["table", "4.1", "4.1"], "UsageError", None, ["unrecognized arguments: 4.1"]),
        (["parts", "house"], "UsageError", None, ["unrecognized arguments: house"]),
    ],
    ids=lambda value: " ".join(value)[:40] if isinstance(value, list) else None,
)
def test_commands(capsys, arguments, kind, where, words):
    assert_refuses(capsys, arguments, kind, where, *words)


class TestProcesses:
    """What only a process of its own can be given."""

    @pytest.mark.parametrize(
        ("content", "words"),
        [
            (b"", b"the text is empty; accepted: "),
            (bytes(range(256)), b"byte 128: byte 0x80 is not UTF-8; accepted: UTF-8 text"),
            (b'{"vertices": [[0, 0], ', b"broken JSON"),
            (b"[" * 100_000, b"nested too deeply; accepted: "),
        ],
    )
    def test_standard_input(self, content, words):
        done = start("plan", "-", "--json", input=content)
        assert done.returncode == 2
        assert done.stderr.startswith(b"stochgeom: ")
        assert done.stderr.count(b"\n") == 1
        assert words in done.stderr
        assert json.loads(done.stdout)["error"]["type"] == "FormatError"

    @pytest.mark.skipif(sys.platform == "win32", reason="arguments are no bytes there")
    @pytest.mark.parametrize("encoding", ["utf-8", "ascii"])
    def test_arguments_that_are_no_text(self, encoding):
        done = start(b"plan", b"\xff\xfe", b"--json", environment={"PYTHONIOENCODING": encoding})
        assert done.returncode == 2
        assert done.stderr.startswith(b"stochgeom: ??: neither a part of the catalogue nor a file;")
        assert json.loads(done.stdout)["error"]["where"] == "??"


WORDS = [
    "plan",
    "table",
    "parts",
    "house",
    "4.1",
    "-",
    "--",
    "--json",
    "--digits",
    "--vertices",
    "--center-of-mass",
    "--cost-ratio",
    "--action",
    "squeeze",
    "--version",
    "-h",
    "0,0 1,0 0,1",
    "-1,-1 1,0 0,1",
    "-1",
    "1/3",
    "=",
    "--digits=3",
    "--cost-ratio=nan",
    "\udcff",
    "\0",
    "\n",
    "",
]


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    arguments=st.lists(
        st.one_of(st.sampled_from(WORDS), st.text(st.characters(), max_size=8)), max_size=6
    )
)
def test_any_arguments_are_done_or_refused_in_one_line(capsys, monkeypatch, arguments):
    monkeypatch.setattr(sys, "stdin", None)
    capsys.readouterr()
    code = main(arguments)
    captured = capsys.readouterr()
    assert code in {0, 2}
    if code == 0:
        assert captured.out
        assert not captured.err
    else:
        assert captured.err.startswith("stochgeom: ")
        assert captured.err.count("\n") == 1
        assert bool(captured.out) is ("--json" in arguments)
