"""Outlines that cannot be read: the error's class, its place, and what it says is accepted."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.errors import (
    FormatError,
    InputError,
    NumberError,
    NumberLimitError,
    ReadError,
    TooFewVerticesError,
)
from stochgeom.io import files, outlines
from stochgeom.io.files import decode_text
from stochgeom.io.outlines import (
    parse_outline,
    parse_point,
    parse_vertices,
    read_outline,
)

PAIRS = [[0, 0], [3, 0], [3, 2]]


def assert_refuses(function, argument, kind, where, *words):
    """The error is exactly of this class and place, on one line, and says what is accepted."""
    with pytest.raises(InputError) as caught:
        function(argument)
    error = caught.value
    assert type(error) is kind
    assert error.where == where
    assert "accepted: " in error.message
    assert "\n" not in str(error)
    for word in words:
        assert word in error.message


@pytest.mark.parametrize(
    ("text", "kind", "where", "word"),
    [
        ("", FormatError, None, "empty"),
        (" \r\n\t ", FormatError, None, "empty"),
        ("\ufeff", FormatError, None, "empty"),
        ("# only a comment\n\n", FormatError, None, "no vertices"),
        ("0 0\n3\n3 2\n", FormatError, "line 2", "'3' has 1 field"),
        ("0 0\r\n3\r\n", FormatError, "line 2", "1 field"),
        ("0 0\r3\r", FormatError, "line 2", "1 field"),
        ("0 0\x0b\n3\n", FormatError, "line 2", "1 field"),
        ("# one\n\n0 0\n1 2 3\n", FormatError, "line 4", "'1 2 3' has 3 fields"),
        ("0,0 3,0 3,2\n", FormatError, "line 1", "6 fields"),
        ("0,5 1,5\n", FormatError, "line 1", "decimal point"),
        ("0 0\n3,,2\n", FormatError, "line 2", "3 fields"),
        ("0 0\n3,2,\n", FormatError, "line 2", "3 fields"),
        ("0 0\n,2\n", FormatError, "line 2", "2 fields"),
        ("(0, 0)\n", NumberError, "line 1, x", "'(0'"),
        ("M 0,0 L 3,0 3,2 z\n", FormatError, "line 1", "vertex per line"),
        ("0 0\nnan 3\n", NumberError, "line 2, x", "'nan'"),
        ("nan 3\n", NumberError, "line 1, x", "'nan'"),
        ("x,y\n0,0\n", NumberError, "line 1, x", "'x'"),
        ("0 0\n3 Infinity\n", NumberError, "line 2, y", "'Infinity'"),
        ("0 0\n3 1_000\n", NumberError, "line 2, y", "'1_000'"),
        ("0 0\n3 0x10\n", NumberError, "line 2, y", "'0x10'"),
        ("0 0\n3 \u0663\n", NumberError, "line 2, y", "'\u0663'"),
        ("0 0\n3 \u22122\n", NumberError, "line 2, y", "'\u22122'"),
        ("0 0\n3 1/0\n", NumberError, "line 2, y", "zero"),
        ("0 0\n3 1e999999999\n", NumberLimitError, "line 2, y", "1e999999999"),
        ("0 0\n3 -1e-10001\n", NumberLimitError, "line 2, y", "exponent"),
        (f"0 0\n3 {'9' * 20_001}\n", NumberLimitError, "line 2, y", "20001 characters"),
        ("0 0\n3 2\x00\n", NumberError, "line 2, y", "\\x00"),
        ("0 0\n\ufeff3 2\n", NumberError, "line 2, x", "\\ufeff3"),
        ("<svg>\n</svg>", FormatError, "line 1", "'<svg>'"),
        ("\n\nhello, wide world\n", FormatError, "line 3", "hello"),
        ("\x1b[31m\n", FormatError, "line 1", "\\x1b"),
        ("0\nSECTION\n", FormatError, "line 1", "1 field"),
    ],
)
def test_plain(text, kind, where, word):
    assert_refuses(parse_outline, text, kind, where, word)


@pytest.mark.parametrize(
    ("text", "kind", "where", "word"),
    [
        ("POINT (1 2)", FormatError, "line 1, column 1", "'POINT' is not read"),
        ("\n  linestring (0 0, 1 1)", FormatError, "line 2, column 3", "LINESTRING"),
        ("MULTIPOLYGON (((0 0, 1 0, 0 1)))", FormatError, "line 1, column 1", "one POLYGON (("),
        ("GEOMETRYCOLLECTION EMPTY", FormatError, "line 1, column 1", "GEOMETRYCOLLECTION"),
        ("SRID=4326;TRIANGLE ((0 0, 1 0, 0 1))", FormatError, "line 1, column 11", "TRIANGLE"),
        ("SRID=x;POLYGON ((0 0, 1 0, 0 1))", FormatError, "line 1, column 1", "SRID"),
        ("SRID=4326;", FormatError, "line 1, column 11", "end of the text"),
        ("SRID=4326; 0 0", FormatError, "line 1, column 12", "'0'"),
        ("POLYGO ((0 0, 1 0, 0 1))", FormatError, "line 1, column 1", "POLYGO"),
        ("POLYGON EMPTY", TooFewVerticesError, "line 1, column 1", "at least 3"),
        ("SRID=1; polygon empty", TooFewVerticesError, "line 1, column 9", "at least 3"),
        ("POLYGON Z ((0 0 0, 1 0 0, 0 1 0))", FormatError, "line 1, column 1", "POLYGON Z"),
        ("POLYGONZ ((0 0 0, 1 0 0, 0 1 0))", FormatError, "line 1, column 1", "POLYGON Z"),
        ("POLYGON M ((0 0 0))", FormatError, "line 1, column 1", "POLYGON M"),
        ("polygon zm ((0 0 0 0))", FormatError, "line 1, column 1", "POLYGON ZM"),
        ("POINT Z (1 2 3)", FormatError, "line 1, column 1", "POINT"),
        ("POINTZ(1 2 3)", FormatError, "line 1, column 1", "POINTZ"),
        ("POLYGON", FormatError, "line 1, column 8", "end of the text"),
        ("POLYGON (", FormatError, "line 1, column 10", "end of the text"),
        ("POLYGON ()", FormatError, "line 1, column 10", "')'"),
        ("POLYGON (0 0, 1 0, 0 1)", FormatError, "line 1, column 10", "'0' where '('"),
        ("POLYGON ((0 0, 1 0", FormatError, "line 1, column 19", "end of the text inside"),
        ("POLYGON ((0 0, 1 0, 0 1)", FormatError, "line 1, column 25", "where ')'"),
        ("POLYGON ((0 0, (1 0), 0 1))", FormatError, "line 1, column 16", "line 1, column 10"),
        ("POLYGON ((0 0, 1 0, 0 1),)", FormatError, "line 1, column 26", "where '('"),
        ("POLYGON ((0 0, 1 0, 0 1) (1 1))", FormatError, "line 1, column 26", "where ')'"),
        ("POLYGON ((0 0, 1 0, 0 1)))", FormatError, "line 1, column 26", "after the polygon"),
        ("POLYGON ((0 0, 1 0, 0 1))\nPOLYGON", FormatError, "line 2, column 1", "after the"),
        ("POLYGON (EMPTY)", FormatError, "line 1, column 10", "EMPTY"),
        ("POLYGON (())", FormatError, "vertex 0", "0 numbers"),
        ("POLYGON ((0 0, 1 0, 0 1,))", FormatError, "vertex 3", "0 numbers"),
        ("POLYGON ((0 0, 1 0 5, 0 1))", FormatError, "vertex 1", "'1 0 5' has 3 numbers"),
        ("POLYGON ((0 0, 1, 0 1))", FormatError, "vertex 1", "1 number;"),
        ("POLYGON ((0 0, 1; 0))", NumberError, "vertex 1, x", "'1;'"),
        ("POLYGON ((0 0, 1 0, 0 nan))", NumberError, "vertex 2, y", "'nan'"),
        ("POLYGON ((0 0, 1e99999 0))", NumberLimitError, "vertex 1, x", "exponent"),
        ("POLYGON ((0 0, 1 0, 0 1), (0 0, 1))", FormatError, "hole 0, vertex 1", "1 number"),
        ("POLYGON ((0 0), (0 0), (0 0, x 1))", NumberError, "hole 1, vertex 1, x", "'x'"),
        ("POLYGON ((" * 10_000, FormatError, "line 1, column 19", "inside the ring"),
        ("POLYGON " + "(" * 10**6, FormatError, "line 1, column 11", "inside the ring"),
    ],
)
def test_wkt(text, kind, where, word):
    assert_refuses(parse_outline, text, kind, where, word)


@pytest.mark.parametrize(
    ("text", "kind", "where", "word"),
    [
        ("[[0, 0], [3, 0], [3,", FormatError, "line 1, column 21", "the text ends here"),
        ('{"vertices": [[0, 0],\n [3, 0], [3, 2]]', FormatError, "line 2, column 17", "ends here"),
        ('{"vertices": [[0, 0],\n [3, 0], [3, 2', FormatError, "line 2, column 15", "ends here"),
        ('{"vert', FormatError, "line 1, column 2", "Unterminated string"),
        ("[", FormatError, "line 1, column 2", "ends here"),
        ("{'vertices': []}", FormatError, "line 1, column 2", "double quotes"),
        ("[[0 0], [3 0]]", FormatError, "line 1, column 5", "delimiter"),
        ("[[0, 0]]\n[[1, 1]]", FormatError, "line 2, column 1", "Extra data"),
        ("[[.5, 0]]", FormatError, "line 1, column 3", "broken JSON"),
        ("[[1/2, 0]]", FormatError, "line 1, column 4", "broken JSON"),
        ("\xa0[[0, 0]]", FormatError, "line 1, column 1", "broken JSON"),
        ('"house"', FormatError, None, "the text 'house' is not an outline"),
        ("[]", TooFewVerticesError, "vertices", "at least 3"),
        ("{}", FormatError, None, 'no key "vertices" (keys found: none)'),
        ('{"points": [[0, 0]]}', FormatError, None, "points"),
        ('{"error": {"type": "x"}}', FormatError, None, 'no key "vertices"'),
        ("[[NaN, 0]]", NumberError, "vertex 0, x", "'NaN'"),
        ("[[0, 0], [0, -Infinity]]", NumberError, "vertex 1, y", "'-Infinity'"),
        ("[[0, 0], [1e400000, 0]]", NumberLimitError, "vertex 1, x", "exponent"),
        (f"[[0, 0], [0, {'9' * 20_001}]]", NumberLimitError, "vertex 1, y", "20001"),
        ("[" * 10**6, FormatError, None, "nested too deeply"),
        ('{"a":' * 10**5, FormatError, None, "nested too deeply"),
        ("[" * 10**5 + "]" * 10**5, FormatError, None, "nested too deeply"),
        ('{"vertices": [[0, 0]], "vertices": [[1, 1]]}', FormatError, "key 'vertices'", "twice"),
        ('{"vertices": [[0, 0]], "x": {"a": 1, "a": 1}}', FormatError, "key 'a'", "twice"),
    ],
)
def test_json_text(text, kind, where, word):
    assert_refuses(parse_outline, text, kind, where, word)


@pytest.mark.parametrize(
    ("document", "kind", "where", "word"),
    [
        ([0, 0, 3, 0], FormatError, "vertex 0", "the number 0"),
        ([[0, 0], "3,0"], FormatError, "vertex 1", "the text '3,0'"),
        ([[0, 0], [3, 0, 0]], FormatError, "vertex 1", "a list of 3"),
        ([[0, 0], [3]], FormatError, "vertex 1", "a list of 1"),
        ([[0, 0], {"x": 3, "y": 0}], FormatError, "vertex 1", "an object"),
        ([[0, 0], None], FormatError, "vertex 1", "null"),
        ([[0, 0], [True, 0]], NumberError, "vertex 1, x", "true is not a number"),
        ([[0, 0], [0, False]], NumberError, "vertex 1, y", "false is not a number"),
        ([[0, 0], [0, None]], NumberError, "vertex 1, y", "null is not a number"),
        ([[0, 0], [None, None]], NumberError, "vertex 1, x", "null is not a number"),
        ([[0, 0], [0, [1]]], NumberError, "vertex 1, y", "a list of 1 is not a number"),
        ([PAIRS[:2]], NumberError, "vertex 0, x", "a list of 2 is not a number"),
        ([[0, 0], ["", 0]], NumberError, "vertex 1, x", "''"),
        ([[0, 0], ["nan", 0]], NumberError, "vertex 1, x", "'nan'"),
        ([[0, 0], ["1/0", 0]], NumberError, "vertex 1, x", "zero"),
        ({"vertices": None}, FormatError, "vertices", "null"),
        ({"vertices": "0,0 3,0 3,2"}, FormatError, "vertices", "the text"),
        ({"vertices": {}}, FormatError, "vertices", "an object"),
        ({"vertices": []}, TooFewVerticesError, "vertices", "at least 3"),
        ({"vertices": PAIRS, "name": 7}, FormatError, "name", "the number 7"),
        ({"vertices": PAIRS, "name": ["a"]}, FormatError, "name", "a list of 1"),
        ({"vertices": PAIRS, "name": "a\nb"}, FormatError, "name", "control characters"),
        ({"vertices": PAIRS, "name": "\x1b[31m"}, FormatError, "name", "control characters"),
        ({"vertices": PAIRS, "name": "\ud800"}, FormatError, "name", "\\ud800"),
        ({"vertices": PAIRS, "center_of_mass": [1]}, FormatError, "center_of_mass", "a list of 1"),
        ({"vertices": PAIRS, "center_of_mass": "1,1"}, FormatError, "center_of_mass", "[x, y]"),
        ({"vertices": PAIRS, "center_of_mass": [1, "a"]}, NumberError, "center_of_mass, y", "'a'"),
        ({"vertices": PAIRS, "holes": 3}, FormatError, "holes", "the number 3"),
        ({"vertices": PAIRS, "holes": PAIRS}, FormatError, "hole 0, vertex 0", "the number 0"),
        ({"vertices": PAIRS, "holes": [7]}, FormatError, "hole 0", "the number 7"),
        ({"vertices": PAIRS, "holes": [PAIRS, []]}, TooFewVerticesError, "hole 1", "at least 3"),
        (
            {"vertices": PAIRS, "holes": [PAIRS, [[0, "x"]]]},
            NumberError,
            "hole 1, vertex 0, y",
            "'x'",
        ),
        ({"schema": "stochgeom/plan/2", "part": {}}, FormatError, "schema", "stochgeom/plan/1"),
        ({"schema": 1, "part": {"vertices": PAIRS}}, FormatError, "schema", "the number 1"),
        ({"schema": "stochgeom/plan/1", "part": PAIRS}, FormatError, "part", "a list of 3"),
        ({"schema": "stochgeom/plan/1", "part": {}}, FormatError, None, 'no key "vertices"'),
        ({"part": {"vertices": [[0, "x"]]}}, NumberError, "vertex 0, y", "'x'"),
        ({"type": "Point", "coordinates": [0, 0]}, FormatError, "type", "'Point'"),
        ({"type": "MultiPolygon", "coordinates": []}, FormatError, "type", "'MultiPolygon'"),
        ({"type": "FeatureCollection", "features": []}, FormatError, "type", "GeoJSON Polygon"),
        ({"type": "polygon", "coordinates": [PAIRS]}, FormatError, "type", "'polygon'"),
        ({"type": None, "coordinates": [PAIRS]}, FormatError, "type", "null"),
        ({"type": ["Polygon"]}, FormatError, "type", "a list of 1"),
        ({"type": "Feature", "geometry": None}, FormatError, "geometry", "null"),
        ({"type": "Feature"}, FormatError, "geometry", "null"),
        ({"type": "Feature", "geometry": {"type": "Point"}}, FormatError, "type", "'Point'"),
        ({"type": "Feature", "geometry": {"type": "Feature"}}, FormatError, "type", "'Feature'"),
        ({"type": "Polygon"}, FormatError, "coordinates", "null"),
        ({"type": "Polygon", "coordinates": "x"}, FormatError, "coordinates", "list of rings"),
        ({"type": "Polygon", "coordinates": []}, TooFewVerticesError, "coordinates", "at least 3"),
        ({"type": "Polygon", "coordinates": [[]]}, TooFewVerticesError, "coordinates", "at least"),
        ({"type": "Polygon", "coordinates": PAIRS}, FormatError, "vertex 0", "the number 0"),
        ({"type": "Polygon", "coordinates": [[[0, 0, 5]]]}, FormatError, "vertex 0", "a list of 3"),
        ({"type": "Polygon", "coordinates": [PAIRS, 5]}, FormatError, "hole 0", "the number 5"),
        (
            {"type": "Polygon", "coordinates": [PAIRS], "centre_of_mass": [1, 1]},
            FormatError,
            "key 'centre_of_mass'",
            '"center_of_mass"',
        ),
    ],
)
def test_json_shapes(document, kind, where, word):
    assert_refuses(parse_outline, json.dumps(document), kind, where, word)


@pytest.mark.parametrize(
    ("key", "meant"),
    [
        ("centre_of_mass", "center_of_mass"),
        ("center_of_gravity", "center_of_mass"),
        ("centerOfMass", "center_of_mass"),
        ("center-of-mass", "center_of_mass"),
        ("CENTER_OF_MASS", "center_of_mass"),
        ("hole", "holes"),
        ("Name", "name"),
        ("vertexes", "vertices"),
        ("Vertices", "vertices"),
    ],
)
@pytest.mark.parametrize("complete", [True, False])
def test_a_misspelt_key_is_not_passed_over(key, meant, complete):
    document = {key: PAIRS} | ({"vertices": PAIRS} if complete else {})
    word = f'close to "{meant}"'
    assert_refuses(parse_outline, json.dumps(document), FormatError, f"key '{key}'", word)


@pytest.mark.parametrize(
    ("text", "kind", "where", "word"),
    [
        ("", FormatError, "--vertices", "no vertices"),
        ("  ", FormatError, "--vertices", "no vertices"),
        (";", FormatError, "--vertices, vertex 0", "0 fields"),
        ("0 0 3 0 3 2", FormatError, "--vertices, vertex 0", "'0' has 1 field"),
        ("0,0,3,0", FormatError, "--vertices, vertex 0", "4 fields"),
        ("0,0 3,0 3", FormatError, "--vertices, vertex 2", "1 field"),
        ("0,0 3,0 ,2", FormatError, "--vertices, vertex 1", "3 fields"),
        ("0 0; 3 0;; 3 2", FormatError, "--vertices, vertex 2", "0 fields"),
        ("0 0; 3 0 0; 3 2", FormatError, "--vertices, vertex 1", "3 fields"),
        ("0,0 3,0 3,x", NumberError, "--vertices, vertex 2, y", "'x'"),
        ("0,0 inf,0 3,2", NumberError, "--vertices, vertex 1, x", "'inf'"),
        ("0,0 3,1e999999999", NumberLimitError, "--vertices, vertex 1, y", "exponent"),
        ("POLYGON ((0 0, 3 0))", FormatError, "--vertices, vertex 0", "POLYGON"),
    ],
)
def test_vertices_of_the_command_line(text, kind, where, word):
    assert_refuses(lambda text: parse_vertices(text, where="--vertices"), text, kind, where, word)


@pytest.mark.parametrize(
    ("text", "kind", "where", "word"),
    [
        ("", FormatError, "--center-of-mass", "0 fields"),
        ("3", FormatError, "--center-of-mass", "1 field"),
        ("1,2,3", FormatError, "--center-of-mass", "3 fields"),
        ("1,5 2,5", FormatError, "--center-of-mass", "4 fields"),
        ("x,2", NumberError, "--center-of-mass, x", "'x'"),
        ("1,nan", NumberError, "--center-of-mass, y", "'nan'"),
    ],
)
def test_a_point_of_the_command_line(text, kind, where, word):
    assert_refuses(
        lambda text: parse_point(text, where="--center-of-mass"), text, kind, where, word
    )


def test_without_a_place_the_vertex_is_the_place():
    assert_refuses(parse_vertices, "0,0 x,1", NumberError, "vertex 1, x")
    assert_refuses(parse_point, "x,1", NumberError, "x")


class TestFiles:
    def test_a_missing_file(self, tmp_path):
        path = tmp_path / "no.json"
        assert_refuses(read_outline, path, ReadError, str(path), os.strerror(2))

    def test_a_directory(self, tmp_path):
        assert_refuses(read_outline, tmp_path, ReadError, str(tmp_path), "cannot be read")

    def test_a_forbidden_file(self, tmp_path, monkeypatch):
        def refuse(self, mode):
            raise PermissionError(13, os.strerror(13), str(self))

        # Not by its mode bits: root reads all.
        monkeypatch.setattr(Path, "open", refuse)
        path = tmp_path / "secret.json"
        assert_refuses(read_outline, path, ReadError, str(path), os.strerror(13))

    def test_names_that_no_file_has(self):
        assert_refuses(read_outline, "a\x00b", ReadError, "a?b", "null")
        assert_refuses(read_outline, "a\nb", ReadError, "a?b", "cannot be read")
        assert_refuses(read_outline, "x" * 10_000, ReadError, "x" * 10_000, "cannot be read")

    def test_a_number_is_no_path(self):
        for value in (0, None, 1.5, []):
            assert_refuses(read_outline, value, ReadError, None, f"{value!r} is no path")
        assert_refuses(read_outline, "", ReadError, "''", "cannot be read")

    def test_an_empty_file(self, tmp_path):
        path = tmp_path / "empty.txt"
        path.touch()
        assert_refuses(read_outline, path, FormatError, str(path), "empty")

    @pytest.mark.parametrize(
        ("content", "where", "word"),
        [
            (b"0 0\n3 \xff\n", "byte 6", "0xff"),
            (b"\xef\xbb\xbf0 0\n\xe4", "byte 7", "0xe4"),
            ("0 0\n".encode("utf-16"), "byte 0", "UTF-8 text"),
            (b"\x89PNG\r\n\x1a\n", "byte 0", "0x89"),
            (b"\xed\xa0\x80", "byte 0", "0xed"),
        ],
    )
    def test_bytes_that_are_no_text(self, tmp_path, content, where, word):
        path = tmp_path / "part.txt"
        path.write_bytes(content)
        assert_refuses(read_outline, path, FormatError, f"{path}, {where}", word)
        assert_refuses(decode_text, content, FormatError, where, word)

    def test_the_size_limit(self, tmp_path, monkeypatch):
        for module in (outlines, files):
            monkeypatch.setattr(module, "MAX_BYTES", 8)
        path = tmp_path / "part.txt"
        path.write_bytes(b"0 0\n1 1\n")
        assert len(read_outline(path).vertices) == 2
        path.write_bytes(b"0 0\n1 1\n\n")
        assert_refuses(read_outline, path, ReadError, str(path), "at most 8 bytes")
        assert_refuses(parse_outline, "0 0\n1 1\n\n", FormatError, None, "at most 8")

    def test_the_limit_is_64_mebibytes(self):
        assert outlines.MAX_BYTES == 64 * 1024 * 1024


def test_nesting_is_refused_from_deep_within_a_program():
    """The stack may be nearly full when the reader is called."""

    def call_at(depth):
        return call_at(depth - 1) if depth else parse_outline("[" * 10**5)

    with pytest.raises(FormatError, match="nested too deeply"):
        call_at(sys.getrecursionlimit() // 2)


@pytest.mark.parametrize(
    "text",
    [
        "3" + " " * 200_000 + "x y",
        "3 " + "," * 200_000,
        "3" * 200_000,
        "POLYGON" + " " * 200_000 + "x",
        "POLYGON ((" + "\n" * 200_000,
        "POLYGON ((" + "," * 20_000 + "))",
        "(" * 200_000,
        "A" * 200_000 + " (",
        "SRID" + " " * 200_000,
        '{"' + "a" * 200_000 + '": 1}',
    ],
    ids=lambda text: f"{text[:10]!r} {len(text)}",
)
def test_long_nonsense_is_refused_quickly_and_briefly(text):
    """Each takes milliseconds; a reader that backtracks would take hours."""
    with pytest.raises(InputError) as caught:
        parse_outline(text)
    assert len(str(caught.value)) < 500


FRAGMENTS = [
    *'[]{}()",:;#/.-+eE0123456789 \t\n\r\\xyZM',
    "POLYGON",
    "EMPTY",
    "SRID=1;",
    "null",
    "true",
    "NaN",
    '"vertices"',
    '"part"',
    '"type"',
    '"Polygon"',
    '"coordinates"',
    "[[0, 0], [3, 0], [3, 2]]",
    "((0 0, 3 0, 3 2))",
    "0 0\n",
    "\ufeff",
    "\x00",
    "\ud800",
]


def refusal(function, argument):
    """Return the input error the call ends in, or None; any other error is let through."""
    try:
        function(argument)
    except InputError as error:
        return error
    return None


@pytest.mark.parametrize("function", [parse_outline, parse_vertices, parse_point])
@given(
    text=st.one_of(
        st.lists(st.sampled_from(FRAGMENTS), max_size=25).map("".join),
        st.text(st.characters(), max_size=25),
    )
)
def test_any_text_is_read_or_an_input_error(function, text):
    error = refusal(function, text)
    assert error is None or "accepted: " in error.message
    assert error is None or "\n" not in str(error)


@given(st.binary(max_size=30))
def test_any_bytes_are_text_or_an_input_error(content):
    error = refusal(decode_text, content)
    assert error is None or error.where.startswith("byte ")
