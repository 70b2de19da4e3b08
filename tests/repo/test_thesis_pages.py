"""The pages of the thesis in the manual: every table, figure and erratum, the same every time."""

from __future__ import annotations

import re
from collections import Counter

import pytest
import thesis_chapters
from docutils import nodes
from docutils.utils import new_document
from sphinx.addnodes import pending_xref
from thesis_chapters import ThesisSummary, section_of, verdict_words
from thesis_errata import parts_of
from thesis_nodes import label_of as erratum_label
from thesis_results import draw, errata_at, label_of, names_by_chapter, numbers_of, places_of

from stochgeom.plotting.source_figures import SOURCE_FIGURES
from stochgeom.thesis.errata_register import ERRATA
from stochgeom.thesis.number_tables import Count, NumberTable, Verdict, verdict_of
from stochgeom.thesis.reproductions import REPRODUCTIONS
from stochgeom.thesis.tables import Cell
from tests.repo.sources import ROOT

PAGES = ROOT / "docs" / "thesis"
NAMES = [name for chapter in names_by_chapter().values() for name in chapter]
QUICK = [name for name, item in REPRODUCTIONS.items() if not item.long]


def picture(name: str) -> nodes.image:
    return nodes.image(uri=name)


def section(name: str) -> nodes.section:
    return section_of(name, picture, long=False)


def links_in(node: nodes.Node) -> set[str]:
    return {link["reftarget"] for link in node.findall(pending_xref)}


def test_all_there_is_stands_in_a_chapter_once():
    assert sorted(NAMES) == sorted({*REPRODUCTIONS, *SOURCE_FIGURES})


def test_every_chapter_has_its_page():
    pages = [page.read_text(encoding="utf-8") for page in PAGES.glob("*.md")]
    shown = [chapter for page in pages for chapter in re.findall(r"\{thesis-chapter\} (\w+)", page)]
    assert sorted(shown) == sorted(names_by_chapter())


@pytest.mark.parametrize("name", NAMES)
def test_a_section_shows_what_there_is(name):
    found = section(name)
    assert found["names"] == [label_of(name)]
    pictures = [image["uri"] for image in found.findall(nodes.image)]
    assert pictures == [name] * (name in SOURCE_FIGURES)
    assert len(list(found.findall(nodes.table))) == (name in QUICK)
    assert ("long experiment" in found.astext()) == (name in REPRODUCTIONS and name not in QUICK)


@pytest.mark.parametrize("name", QUICK)
def test_a_table_shows_every_number_beside_the_printed_one(name):
    numbers = numbers_of(name, long=False)
    shown = [entry.astext() for entry in section(name).findall(nodes.entry)][len(numbers.header) :]
    for item, text in zip([item for row in numbers.rows for item in row], shown, strict=True):
        if isinstance(item, str):
            assert text == item
        elif not hasattr(item, "printed"):
            assert text == item.decimal(4)
        else:
            assert text.startswith(f"{item.computed.decimal(4)} [{item.printed}]")
            assert ("erratum" in text) == (verdict_of(item) is Verdict.EXPLAINED)


@pytest.mark.parametrize("name", QUICK)
def test_what_is_explained_leads_to_its_erratum(name):
    expected = {
        erratum_label(entry.number)
        for entry in ERRATA
        if entry.erratum in numbers_of(name, long=False).errata
    }
    assert expected <= links_in(section(name))
    assert all(name in places_of(e.erratum) for e in ERRATA if erratum_label(e.number) in expected)


def test_an_erratum_of_a_figure_stands_there_once():
    [erratum] = errata_at("figG.3")
    assert section("figG.3").astext().count(erratum.reason) == 1


def test_the_text_is_the_same_every_time():
    first = [section(name).pformat() for name in NAMES]
    numbers_of.cache_clear()
    assert [section(name).pformat() for name in NAMES] == first


def test_a_picture_is_the_same_every_time(tmp_path):
    for name in ("fig4.6", "fig7.1", "figE.4"):
        once = draw(name, tmp_path).read_bytes()
        assert draw(name, tmp_path).read_bytes() == once


def test_the_summary_counts_what_the_tables_do():
    total: Counter[Verdict] = Counter()
    for name in QUICK:
        total += numbers_of(name, long=False).verdicts
    paragraph, table = summary_nodes()
    assert verdict_words(total) in paragraph.astext()
    assert links_in(table) == {label_of(name) for name in NAMES}


def summary_nodes() -> list[nodes.Node]:
    class Summary(ThesisSummary):
        config = type("Config", (), {"thesis_long_experiments": False})()

        def __init__(self) -> None:
            pass

    return Summary().run()


def test_the_summary_counts_numbers_and_pictures():
    told = summary_nodes()[0].astext()
    assert f"; {len(SOURCE_FIGURES)} pictures drawn." in told
    assert ", 0 open; " in told


def test_an_open_number_says_so():
    table = NumberTable("t", ("n",), ((Cell(Count(3), "4", None),),))
    [found, *_] = thesis_chapters.number_nodes(table, [])
    *_, entry = found.findall(nodes.entry)
    assert entry.astext() == "3 [4] open"
    assert entry["classes"] == ["open"]


@pytest.mark.parametrize("item", ERRATA, ids=lambda item: str(item.number))
def test_an_erratum_is_told_whole(item):
    document = new_document("errata")
    document += parts_of(item)
    for text in (item.erratum.printed, item.erratum.holds, item.erratum.reason):
        assert text in document.astext()
