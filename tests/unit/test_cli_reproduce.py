"""``stochgeom reproduce``: what is written, what is counted, and every bad input."""

from __future__ import annotations

import csv
import json
import sys
from dataclasses import replace

import pytest
from gmpy2 import mpq

import stochgeom.thesis.reproductions as reproductions
from stochgeom.cli.main import main
from stochgeom.cli.reproduce_command import chosen_names, file_stem, left_out
from stochgeom.cli.reproduce_files import ResultFolder
from stochgeom.errors import UnknownReproductionError, WriteError
from stochgeom.plotting import source_figures
from stochgeom.plotting.source_figures import SOURCE_FIGURES
from stochgeom.thesis.number_tables import ExactNumber, NumberTable, Verdict, verdict_of
from stochgeom.thesis.random_parts import compared_parts, searched_parts
from stochgeom.thesis.reproductions import REPRODUCTIONS, canonical_name
from stochgeom.thesis.simulated_tables import gripper_table, tilt_table
from stochgeom.thesis.tables import Cell

QUICK = [name for name, item in REPRODUCTIONS.items() if not item.long]


def entries(folder):
    return sorted(path.name for path in folder.iterdir())


class TestNumbers:
    @pytest.mark.parametrize("name", QUICK)
    def test_nothing_is_open(self, name):
        found = REPRODUCTIONS[name].make(float)
        assert found.verdicts[Verdict.OPEN] == 0
        assert all(len(row) == len(found.header) for row in found.rows)

    def test_how_many_numbers_are_printed(self):
        verdicts = {name: REPRODUCTIONS[name].make(float).verdicts for name in QUICK}
        counts = {
            name: (found[Verdict.REPRODUCED], found[Verdict.EXPLAINED])
            for name, found in verdicts.items()
        }
        assert counts == {
            "3.1": (24, 1),
            "4.1": (30, 2),
            "fig4.5": (7, 0),
            "fig4.6": (35, 0),
            "fig6.4": (142, 2),
            "sec7.2": (0, 0),
            "C.1": (23, 2),
            "figE.5": (16, 4),
            "figE.8": (12, 0),
            "figG.1": (2, 0),
            "figG.2": (2, 0),
            "figG.3": (2, 0),
            "figG.4": (2, 0),
        }

    def test_verdicts(self):
        third = ExactNumber(mpq(1, 3))
        erratum = REPRODUCTIONS["4.1"].make(float).errata[0]
        assert verdict_of(Cell(third, "0.33", None)) is Verdict.REPRODUCED
        assert verdict_of(Cell(third, "0.34", erratum)) is Verdict.EXPLAINED
        assert verdict_of(Cell(third, "0.34", None)) is Verdict.OPEN

    def test_experiments_on_few_parts(self):
        told = []
        found = searched_parts("a", 5, told.append)
        assert found.rows[3][1].decimal(0) == "100"
        assert [row[2] for row in found.rows] == ["5.9", "", "", "99", ""]
        assert found.rows[1][1].decimal(3) == "5.962"
        assert compared_parts("b", 3, told.append).verdicts[Verdict.REPRODUCED] == 1
        assert told[4] == told[-1] == 1.0

    def test_simulated_experiments_are_not_judged(self):
        pytest.importorskip("pymunk")
        for found in (gripper_table("a", 2), tilt_table("b", 12, 1)):
            assert not list(found.cells)
            assert "judged" in found.notes[0]
        *plans, mean, spread = found.rows
        assert len(plans) == 14
        assert mean[2:4] == ("mean tilts, best plans of 132 instances", "2.4")
        assert spread[3] == "0.75"
        assert 1 <= mean[4].value <= 3
        assert "144 pairs of states 12 have the start for goal" in found.notes[1]
        assert ".97 (4), .98 (5 to 7), .99 (8 to 21)" in found.notes[2]
        printed = [row[3] for row in gripper_table("a", 2).rows]
        assert printed == ["126/250"] * 2 + ["250/250"] * 2
        assert [row[2] for row in gripper_table("a", 4).rows[2:]] == ["4/4", "4/4"]


class TestNames:
    @pytest.mark.parametrize(
        ("text", "name"),
        [
            ("4.1", "4.1"),
            ("table4.1", "4.1"),
            ("Fig. e.5", "figE.5"),
            ("FIGURE 4.6", "fig4.6"),
            ("section 5.9", "sec5.9"),
            ("c.1", "C.1"),
            ("table-4.1", "4.1"),
            ("fig-E.5", "figE.5"),
            ("?", "?"),
        ],
    )
    def test_spellings(self, text, name):
        assert canonical_name(text) == name

    def test_the_order_is_that_of_the_source(self):
        names = chosen_names(["figE.8", "C.1", "fig5.10", "4.1", "fig5.9"], every=False, long=False)
        assert names == ["4.1", "fig5.9", "fig5.10", "C.1", "figE.8"]

    def test_everything_with_and_without_long_experiments(self):
        every = chosen_names([], every=True, long=False)
        assert set(every) == {*QUICK, *SOURCE_FIGURES}
        longer = {*chosen_names([], every=True, long=True)} - {*every}
        assert longer == {"sec4.8", "sec5.9", "6.1", "secB.2"}
        assert {*chosen_names(["sec4.8"], every=True, long=False)} - {*every} == {"sec4.8"}

    def test_files_have_names_of_their_own(self):
        every = [*REPRODUCTIONS, *(name for name in SOURCE_FIGURES if name not in REPRODUCTIONS)]
        assert len({file_stem(name).lower() for name in every}) == len(every)

    @pytest.mark.parametrize("names", [["9.9"], ["4.1", "nothing"], [""], []])
    def test_unknown_ones_list_the_known(self, names):
        with pytest.raises(UnknownReproductionError) as caught:
            chosen_names(names, every=False, long=False)
        assert all(name in str(caught.value) for name in ("4.1", "fig4.6", "sec4.8", "figC.1"))

    @pytest.mark.parametrize(
        ("text", "meant"),
        [
            ("4.6", "fig4.6"),
            ("7.2", "fig7.2 or sec7.2"),
            ("sec4.1", "4.1 or fig4.1"),
            ("fig3.1x", None),
        ],
    )
    def test_a_number_alone_names_what_has_it(self, text, meant):
        hint = "" if meant is None else f"; is {meant} meant\\?"
        accepted = f"no table or figure '{text}'{hint}; accepted: .*3.1, fig3.1"
        with pytest.raises(UnknownReproductionError, match=accepted):
            chosen_names([text], every=False, long=False)


class TestOutput:
    def test_a_table(self, capsys):
        assert main(["reproduce", "4.1"]) == 0
        shown = capsys.readouterr().out
        assert "10.5748 [16.0](1)" in shown
        assert "32 printed numbers: 30 reproduced, 2 explained, 0 open" in shown

    def test_what_is_left_out_is_told(self, capsys, monkeypatch):
        monkeypatch.setattr(
            "stochgeom.cli.reproduce_command.chosen_names", lambda *_, **__: ["4.1"]
        )
        assert main(["reproduce", "--all"]) == 0
        shown = capsys.readouterr().out
        assert (
            "left out without --long: Section 4.8, Section 5.9, Table 6.1, Section B.2\n" in shown
        )
        assert left_out(["sec4.8", "4.1"]) == ["sec5.9", "6.1", "secB.2"]
        assert main(["reproduce", "4.1"]) == 0
        assert "left out" not in capsys.readouterr().out

    def test_a_document(self, capsys):
        assert main(["reproduce", "4.1", "fig4.3", "--json", "--digits", "2"]) == 0
        document = json.loads(capsys.readouterr().out)
        assert (document["reproduced"], document["explained"], document["open"]) == (30, 2, 0)
        table, figure = document["items"]
        assert (figure["name"], figure["picture"], figure["numbers"]) == (
            "fig4.3",
            "needs -o",
            None,
        )
        wrong = [n for n in table["numbers"]["numbers"] if n["verdict"] == "explained"]
        assert [(n["row"], n["column"], n["computed"]) for n in wrong] == [
            ("4gon", "3-step", "10.57"),
            ("key", "3-step", "8.00"),
        ]
        assert wrong[0]["erratum"] == "Table 4.1, 4gon, 3-step"

    def test_what_nothing_explains_is_a_failed_check(self, capsys, monkeypatch):
        cell = Cell(ExactNumber(mpq(1, 3)), "0.34", None)
        bad = NumberTable("bad", ("a", "b"), (("x", cell),))
        item = replace(REPRODUCTIONS["4.1"], make=lambda _: bad)
        monkeypatch.setattr(reproductions, "REPRODUCTIONS", {"4.1": item})
        assert main(["reproduce", "4.1"]) == 1
        shown = capsys.readouterr().out
        assert "no erratum explains it" in shown
        assert "1 printed number: 0 reproduced, 0 explained, 1 open" in shown

    def test_files(self, tmp_path, capsys):
        target = tmp_path / "a" / "b"
        assert main(["reproduce", "4.1", "figE.8", "-o", str(target), "--no-pictures"]) == 0
        stems = ("fig-E.8", "table-4.1")
        expected = [f"{stem}.{kind}" for stem in stems for kind in ("csv", "json", "txt")]
        assert entries(target) == sorted([*expected, "summary.json", "summary.txt"])
        with (target / "table-4.1.csv").open(newline="") as file:
            rows = list(csv.DictReader(file))
        assert len(rows) == 32
        assert sum(row["verdict"] == "explained" for row in rows) == 2
        summary = json.loads((target / "summary.json").read_text())
        assert summary["items"][0]["files"] == ["table-4.1.txt", "table-4.1.json", "table-4.1.csv"]
        assert (target / "summary.txt").read_text() == capsys.readouterr().out

    def test_the_same_bytes_every_time(self, tmp_path):
        pytest.importorskip("matplotlib")
        contents = []
        for name in ("one", "two"):
            assert main(["reproduce", "fig5.7", "figG.1", "-o", str(tmp_path / name)]) == 0
            contents.append({p.name: p.read_bytes() for p in (tmp_path / name).iterdir()})
        assert contents[0] == contents[1]
        assert {"fig-5.7.svg", "fig-G.1.svg", "fig-G.1.csv"} <= {*contents[0]}

    @pytest.mark.parametrize(
        ("name", "drawing", "friction"),
        [
            ("fig3.5", "draw_push_stability", ()),
            ("fig3.6", "draw_squeeze_stability", ("1/4",)),
            ("fig3.7", "draw_grasp_diagram", ("1/4",)),
        ],
    )
    def test_diagrams_of_chapter_3_are_of_a_square(self, monkeypatch, name, drawing, friction):
        """As their captions say, with mu = .25."""
        monkeypatch.setattr(source_figures, drawing, lambda *given: given)
        assert SOURCE_FIGURES[name].draw() == (((0, 0), (1, 0), (1, 1), (0, 1)), *friction)
        assert "square" in SOURCE_FIGURES[name].title

    @pytest.mark.parametrize("name", SOURCE_FIGURES)
    def test_a_picture(self, name):
        pytest.importorskip("matplotlib")
        import matplotlib as mpl

        mpl.use("Agg")
        import matplotlib.pyplot as plt

        drawn = SOURCE_FIGURES[name].draw()
        if isinstance(drawn, str):
            assert drawn.startswith("<svg")
        else:
            assert drawn.get_figure() is not None
        plt.close("all")


class TestBadInput:
    @pytest.mark.parametrize("names", [["9.9"], [], ["--long"], ["4.1", "--digits", "x"]])
    def test_one_line_and_exit_code_2(self, capsys, names):
        assert main(["reproduce", *names]) == 2
        captured = capsys.readouterr()
        assert captured.out == ""
        assert captured.err.count("\n") == 1
        assert "accepted" in captured.err

    def test_a_file_where_the_folder_should_be(self, tmp_path, capsys):
        (tmp_path / "file").write_text("mine")
        for path in (tmp_path / "file", tmp_path / "file" / "below"):
            assert main(["reproduce", "4.1", "-o", str(path)]) == 2
            assert "accepted: a writable folder" in capsys.readouterr().err
        assert (tmp_path / "file").read_text() == "mine"

    def test_a_folder_that_is_not_writable(self, tmp_path, capsys, monkeypatch):
        def refuse(**_):
            raise PermissionError(13, "Permission denied")

        monkeypatch.setattr("stochgeom.cli.reproduce_files.tempfile.mkdtemp", refuse)
        assert main(["reproduce", "4.1", "-o", str(tmp_path / "new" / "er")]) == 2
        captured = capsys.readouterr()
        assert "Permission denied; accepted: a writable folder" in captured.err
        assert captured.err.count("\n") == 1
        assert entries(tmp_path) == []

    def test_a_folder_in_the_way_leaves_everything_as_it_was(self, tmp_path, capsys):
        (tmp_path / "table-4.1.txt").mkdir()
        assert main(["reproduce", "4.1", "-o", str(tmp_path)]) == 2
        assert "table-4.1.txt" in capsys.readouterr().err
        assert entries(tmp_path) == ["table-4.1.txt"]

    def test_after_an_error_nothing_is_there(self, tmp_path):
        def fail():
            with ResultFolder(str(tmp_path / "a" / "b")) as folder:
                folder.write("x.txt", "half")
                raise RuntimeError

        with pytest.raises(RuntimeError):
            fail()
        assert entries(tmp_path) == []

    def test_what_stood_there_stays(self, tmp_path):
        (tmp_path / "mine.txt").write_text("mine")
        with ResultFolder(str(tmp_path)) as folder:
            folder.write("x.txt", "whole")
        assert entries(tmp_path) == ["mine.txt", "x.txt"]

    def test_a_null_character(self):
        with pytest.raises(WriteError, match="accepted: a writable folder"):
            ResultFolder("a\0b").__enter__()

    @pytest.mark.parametrize(
        ("arguments", "module", "extra"),
        [(["fig4.5", "-o", "x"], "matplotlib", "plot"), (["secB.2"], "pymunk", "sim")],
    )
    def test_a_missing_extra_is_named_before_work_begins(
        self, capsys, monkeypatch, tmp_path, arguments, module, extra
    ):
        monkeypatch.chdir(tmp_path)
        monkeypatch.setitem(sys.modules, module, None)
        assert main(["reproduce", *arguments]) == 2
        assert f"stochgeom[{extra}]" in capsys.readouterr().err
        assert entries(tmp_path) == []
