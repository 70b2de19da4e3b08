"""Files, and telling the formats apart."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path

import pytest
from gmpy2 import mpq

from stochgeom.io.files import decode_text
from stochgeom.io.outlines import Outline, parse_outline, read_outline

TRIANGLE = ((mpq(0), mpq(0)), (mpq(3), mpq(0)), (mpq(3), mpq(2)))
TEXTS = {
    "json": "[[0, 0], [3, 0], [3, 2]]",
    "wkt": "POLYGON ((0 0, 3 0, 3 2, 0 0))",
    "plain": "0 0\n3 0\n3 2\n",
}


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
@pytest.mark.parametrize("suffix", ["", ".json", ".txt", ".wkt"])
@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"], ids=["bare", "marked"])
def test_the_content_and_not_the_suffix_tells_the_format(tmp_path, text, suffix, mark):
    path = tmp_path / f"wedge{suffix}"
    path.write_bytes(mark + text.encode())
    for source in (path, str(path)):
        outline = read_outline(source)
        assert outline.vertices == TRIANGLE
        assert outline.name == "wedge"


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
@pytest.mark.parametrize("before", ["", " ", "\n\n", "\t\r\n"])
def test_blanks_around_the_text_do_not_matter(text, before):
    assert parse_outline(before + text + "\n \n").vertices == TRIANGLE


def test_a_name_in_the_file_comes_before_the_files_own(tmp_path):
    path = tmp_path / "file.json"
    path.write_text('{"name": "Gehäuse", "vertices": [[0, 0]]}', encoding="utf-8")
    assert read_outline(path).name == "Gehäuse"


@pytest.mark.parametrize(
    ("file_name", "name"),
    [("house.v2.txt", "house.v2"), ("Gehäuse.txt", "Gehäuse"), ("two\nlines.txt", "two?lines")],
)
@pytest.mark.skipif(os.name == "nt", reason="such file names do not exist there")
def test_the_default_name_is_the_stem_on_one_line(tmp_path, file_name, name):
    path = tmp_path / file_name
    path.write_text(TEXTS["plain"], encoding="utf-8")
    assert read_outline(path).name == name


@pytest.mark.skipif(os.name == "nt", reason="file names are text there")
def test_a_file_name_that_is_not_utf8(tmp_path):
    path = Path(os.fsdecode(os.fsencode(tmp_path) + b"/part\xff.txt"))
    try:
        path.write_text(TEXTS["plain"], encoding="utf-8")
    except OSError:
        pytest.skip("the file system refuses such names")
    assert read_outline(path).name == "part?"


def test_decoding_keeps_the_byte_order_mark_for_the_parser():
    assert parse_outline(decode_text(b"\xef\xbb\xbf0 0")).vertices == ((0, 0),)


def test_an_outline_is_a_value():
    outline = Outline(TRIANGLE, name="wedge")
    assert outline == Outline(TRIANGLE, (), None, "wedge", ())
    assert hash(outline) == hash(Outline(TRIANGLE, name="wedge"))
    assert eval(repr(outline), {"Outline": Outline, "mpq": mpq}) == outline
    with pytest.raises(dataclasses.FrozenInstanceError):
        outline.name = "other"
