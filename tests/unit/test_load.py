"""From a source to a part: catalogue, file, standard input."""

from __future__ import annotations

import io
import os
import sys
from types import SimpleNamespace

import pytest
from gmpy2 import mpq

from stochgeom.errors import FormatError, ReadError, SelfIntersectionError
from stochgeom.io import load
from stochgeom.io.load import load_part, part_of
from stochgeom.io.outlines import Outline, parse_outline
from stochgeom.thesis.parts import catalogue_names, catalogue_part

BOW_TIE = "0 0\n# the crossing follows\n1 1\n\n1 0\n0 1\n"


@pytest.fixture
def feed(monkeypatch):
    """Return a function that puts bytes, or another stream, in place of standard input."""

    def place(content):
        stream = content
        if isinstance(content, bytes):
            stream = io.TextIOWrapper(io.BytesIO(content))
        monkeypatch.setattr(load, "sys", SimpleNamespace(stdin=stream))

    return place


class TestCatalogue:
    @pytest.mark.parametrize("name", catalogue_names())
    def test_every_name(self, name):
        assert load_part(name) == catalogue_part(name)

    def test_another_center_of_mass(self):
        part = load_part("house", center_of_mass="-1/2,0.25")
        assert part.center_of_mass == (mpq(-1, 2), mpq(1, 4))
        assert part.vertices == catalogue_part("house").vertices
        assert part.name == "house"

    def test_a_file_of_the_same_name_is_reached_by_its_path(self, tmp_path, monkeypatch):
        monkeypatch.chdir(tmp_path)
        (tmp_path / "house").write_text("0 0\n1 0\n0 1\n")
        assert len(load_part("house")) == 5
        assert len(load_part("./house")) == 3
        assert load_part("./house").name == "house"


class TestFiles:
    def test_the_name_is_that_of_the_file(self, tmp_path):
        path = tmp_path / "wedge.txt"
        path.write_text("0 0\n1 0\n0 1\n")
        part = load_part(str(path))
        assert part.name == "wedge"
        assert part.vertices[2] == (0, 1)
        assert not part.has_given_center

    def test_the_content_may_give_another(self, tmp_path):
        path = tmp_path / "wedge.json"
        path.write_text('{"name": "w", "vertices": [[0,0],[1,0],[0,1]], "center_of_mass": [5, 5]}')
        part = load_part(str(path))
        assert part.name == "w"
        assert part.center_of_mass == (5, 5)
        assert load_part(str(path), center_of_mass="0,0").center_of_mass == (0, 0)

    def test_a_center_of_mass_outside_is_accepted_for_squeezing(self, tmp_path):
        path = tmp_path / "wedge.txt"
        path.write_text("0 0\n1 0\n0 1\n")
        assert load_part(str(path), center_of_mass="100,-100").center_of_mass_side == -1

    @pytest.mark.parametrize("name", ["hous", "no/such/file.txt", "house ", "HOUSE", "*"])
    def test_neither_part_nor_file(self, tmp_path, monkeypatch, name):
        monkeypatch.chdir(tmp_path)
        with pytest.raises(ReadError) as caught:
            load_part(name)
        assert caught.value.where == name
        assert caught.value.message == (
            "neither a part of the catalogue nor a file; accepted: triangle, rectangle, house, "
            "4gon, 5gon, wrench, tuning-fork, key, regular-N, a file, or - for "
            "standard input"
        )

    def test_no_name(self):
        with pytest.raises(ReadError, match="the name is empty; accepted: triangle, "):
            load_part("")

    def test_a_directory(self, tmp_path):
        with pytest.raises(ReadError) as caught:
            load_part(str(tmp_path))
        assert caught.value.where == str(tmp_path)
        assert caught.value.message.startswith("cannot be read: ")

    def test_what_is_wrong_inside_is_named_with_the_file(self, tmp_path, monkeypatch):
        monkeypatch.chdir(tmp_path)
        (tmp_path / "part.txt").write_text("0 0\n1 0\n0 1 2\n")
        with pytest.raises(FormatError, match=r"\Apart.txt, line 3: '0 1 2' has 3 fields; "):
            load_part("part.txt")
        (tmp_path / "bow\ntie").write_text(BOW_TIE)
        with pytest.raises(SelfIntersectionError) as caught:
            load_part("bow\ntie")
        assert caught.value.edges == (0, 2)
        assert caught.value.where == "bow?tie, edges 0 and 2 (which begin at line 1 and line 5)"
        assert str(caught.value) == f"{caught.value.where}: {caught.value.message}"

    def test_a_center_of_mass_that_is_given_does_not_stand_in_the_file(self, tmp_path):
        path = tmp_path / "wedge.txt"
        path.write_text("0 0\n1 0\n0 1\n")
        with pytest.raises(FormatError) as caught:
            load_part(str(path), center_of_mass="1")
        assert caught.value.where == "center of mass"

    @pytest.mark.parametrize("name", ["x" * 5000, "a\0b", "a\udcffb", "\ud800"])
    def test_names_that_cannot_be_opened_or_shown(self, name):
        with pytest.raises(ReadError, match="accepted: ") as caught:
            load_part(name)
        assert caught.value.where.isprintable()


class TestStandardInput:
    def test_it_is_read_as_a_file_is(self, feed):
        feed(b"\xef\xbb\xbf0 0\r\n1 0\r\n0 1\r\n")
        part = load_part("-", center_of_mass="1,1")
        assert part.vertices == ((0, 0), (1, 0), (0, 1))
        assert part.center_of_mass == (1, 1)
        assert part.name is None

    def test_nothing(self, feed):
        feed(b"")
        with pytest.raises(FormatError, match=r"\Astandard input: the text is empty; accepted: J"):
            load_part("-")

    def test_edges_in_conflict(self, feed):
        feed(BOW_TIE.encode())
        with pytest.raises(SelfIntersectionError, match=r"\Astandard input, edges 0 and 2 \(which"):
            load_part("-")

    def test_bytes_that_are_no_text(self, feed):
        feed(b"\x89PNG\r\n")
        with pytest.raises(FormatError, match=r"\Astandard input, byte 0: byte 0x89 is not U"):
            load_part("-")

    def test_too_much(self, feed, monkeypatch):
        monkeypatch.setattr(load, "MAX_BYTES", 12)
        feed(b"0 0\n1 0\n0 1\n")
        assert len(load_part("-")) == 3
        feed(b"0 0\n1 0\n0 1\n\n")
        with pytest.raises(ReadError, match="standard input: larger than accepted: at most 12"):
            load_part("-")

    def test_closed(self, feed):
        feed(None)
        with pytest.raises(ReadError, match="standard input: closed; accepted: "):
            load_part("-")

    def test_a_device_that_fails(self, feed):
        def read(size):
            raise OSError(5, os.strerror(5))

        feed(SimpleNamespace(buffer=SimpleNamespace(read=read)))
        with pytest.raises(ReadError, match=f"standard input: cannot be read: {os.strerror(5)}; "):
            load_part("-")

    def test_it_is_not_read_for_a_part_of_the_catalogue(self, feed):
        feed(None)
        assert load_part("key").name == "key"

    def test_the_stand_in_stands_where_the_process_has_its_input(self):
        assert load.sys is sys


class TestPartOf:
    def test_everything_is_handed_on(self):
        outline = Outline(
            ((0, 0), (4, 0), (4, 4), (0, 4)), (((1, 1), (2, 1), (2, 2)),), (1, 3), "frame"
        )
        part = part_of(outline)
        assert part.vertices == outline.vertices
        assert part.holes == outline.holes
        assert part.center_of_mass == (1, 3)
        assert part.name == "frame"
        assert part_of(outline, "7,8").center_of_mass == (7, 8)

    def test_edges_in_conflict_are_named_with_their_lines(self):
        with pytest.raises(SelfIntersectionError) as caught:
            part_of(parse_outline(BOW_TIE))
        assert caught.value.edges == (0, 2)
        assert caught.value.where == "edges 0 and 2 (which begin at line 1 and line 5)"
        assert caught.value.message.startswith("edge 0 from (0, 0) to (1, 1) and edge 2 ")

    def test_edges_in_conflict_are_named_with_their_columns(self):
        with pytest.raises(SelfIntersectionError) as caught:
            part_of(parse_outline("POLYGON ((0 0, 1 1,\n1 0, 0 1, 0 0))"))
        assert caught.value.where == (
            "edges 0 and 2 (which begin at line 1, column 11 and line 2, column 1)"
        )

    def test_a_format_without_places(self):
        with pytest.raises(SelfIntersectionError) as caught:
            part_of(parse_outline("[[0, 0], [1, 1], [1, 0], [0, 1]]"))
        assert caught.value.where == "edges 0 and 2"

    @pytest.mark.parametrize("text", ["", "1", "1,2,3", "x,1", "1,nan"])
    def test_a_center_of_mass_that_is_no_point(self, text):
        with pytest.raises((FormatError, ValueError)) as caught:
            load_part("house", center_of_mass=text)
        assert caught.value.where.startswith("center of mass")
