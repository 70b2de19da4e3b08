"""The register of errata: complete, settled by computations that can fail, and its command."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import pytest

import stochgeom.thesis.errata_register as register
from stochgeom.cli.main import main
from stochgeom.errors import UnknownErratumError
from stochgeom.thesis import errata, errata_statements, facts
from stochgeom.thesis import recompute_framework as framework
from stochgeom.thesis import recompute_grasps as grasps
from stochgeom.thesis import recompute_planning as planning
from stochgeom.thesis import recompute_tables as tables
from stochgeom.thesis.appendix_g import FIGURES_G
from stochgeom.thesis.chapter_6 import FIGURE_6_4_ERRATA
from stochgeom.thesis.errata import Erratum
from stochgeom.thesis.errata_register import ERRATA, find_errata
from stochgeom.thesis.figures_4 import FIGURE_4_6
from stochgeom.thesis.parts import catalogue_part


def errata_of(module):
    """Return every erratum that a module defines, in dictionaries as well."""
    for value in vars(module).values():
        if isinstance(value, Erratum):
            yield value
        elif isinstance(value, dict):
            yield from (item for item in value.values() if isinstance(item, Erratum))


@pytest.mark.parametrize("entry", ERRATA, ids=lambda entry: str(entry.number))
def test_everything_that_settles_an_erratum_holds(entry):
    found = entry.recompute()
    assert found
    assert [fact for fact in found if not fact.holds] == []
    assert all(fact.claim for fact in found)


def test_the_register_is_complete():
    known = [entry.erratum for entry in ERRATA]
    defined = [*errata_of(errata), *errata_of(errata_statements), *FIGURE_6_4_ERRATA.values()]
    defined += [figure.erratum for figure in FIGURES_G if figure.erratum]
    assert {erratum.where for erratum in defined} == {erratum.where for erratum in known}
    assert len(known) == len(defined)


def test_numbers_run_from_1_and_functions_are_used_once():
    assert [entry.number for entry in ERRATA] == list(range(1, len(ERRATA) + 1))
    assert len({entry.recompute for entry in ERRATA}) == len(ERRATA)
    for entry in ERRATA:
        assert re.fullmatch(r"stochgeom\.thesis\.recompute_\w+\.\w+", entry.recomputed_by)
        assert entry.argument
        assert not entry.erratum.reason.endswith(".")


class TestRecomputationsCanFail:
    """Each road fails when what it rests on is another number or another part."""

    def failing(self, recompute):
        return [fact.claim for fact in recompute() if not fact.holds]

    @pytest.mark.parametrize(
        ("where", "name", "value"),
        [
            (
                "4gon",
                "FIGURE_4_6",
                replace(FIGURE_4_6, rows=(("0.12", "0.02", "0.11", "0.13"), *FIGURE_4_6.rows[1:])),
            ),
            ("6.4", "FIGURE_6_4_COPY", tables.FIGURE_6_4_COPY[:-1]),
        ],
    )
    def test_with_another_printed_number(self, monkeypatch, where, name, value):
        monkeypatch.setattr(tables, name, value)
        recompute = {
            "4gon": tables.four_gon_at_three_steps,
            "6.4": tables.columns_of_figure_6_4,
        }[where]
        assert self.failing(recompute)

    @pytest.mark.parametrize(
        ("module", "recompute"),
        [
            (tables, tables.text_of_section_4_8),
            (grasps, grasps.text_of_appendix_e),
            (grasps, grasps.sweep_of_appendix_d),
            (grasps, grasps.limit_of_the_bound),
            (planning, planning.cost_in_figure_5_8),
            (planning, planning.angles_of_equation_5_3),
            (planning, planning.closure_of_lemma_5_1),
        ],
    )
    def test_with_another_part(self, monkeypatch, module, recompute):
        other = catalogue_part("rectangle")
        monkeypatch.setattr(module, "catalogue_part", lambda *_, **__: other)
        assert self.failing(recompute)

    def test_with_another_prior(self, monkeypatch):
        monkeypatch.setattr(framework, "PRIOR", (framework.PRIOR[1],) * 4 + framework.PRIOR[:1])
        assert self.failing(framework.cost_with_a_sensor)

    def test_with_fewer_executions(self, monkeypatch):
        monkeypatch.setattr(framework, "EXECUTIONS", 100)
        assert self.failing(framework.success_of_the_second_plan)


class TestFinding:
    def test_by_number_and_by_text(self):
        assert [entry.number for entry in find_errata("3")] == [3]
        assert [entry.erratum.where for entry in find_errata("eq. 7.5")] == ["Eq. 7.5"]
        assert find_errata(None) == ERRATA
        assert [entry.number for entry in find_errata(" +3 ")] == [3]
        assert len(find_errata("table 4.1")) >= 2

    @pytest.mark.parametrize(
        "query", ["0", "999", "-1", "99999999999", "", "  ", "no such text", "²"]
    )
    def test_none(self, query):
        with pytest.raises(
            UnknownErratumError, match=f"accepted: a number from 1 to {len(ERRATA)}"
        ):
            find_errata(query)


def test_printed_decimals():
    assert facts.fraction(".25") * 4 == 1
    assert facts.half_unit("16") * 2 == 1
    assert facts.equal("x", [1, "a"], [1, "a"]) == facts.Fact("x", "1, a", True)
    assert not facts.equal("x", 1, 2).holds


class TestTheCommand:
    def test_the_list(self, capsys):
        assert main(["errata"]) == 0
        shown = capsys.readouterr().out
        assert all(f"{entry.number}. {entry.erratum.where}" in shown for entry in ERRATA)
        assert max(map(len, shown.splitlines())) <= 100
        assert "recomputed by" not in shown

    def test_one(self, capsys):
        assert main(["errata", "Table 4.1, 4gon"]) == 0
        shown = capsys.readouterr().out
        assert "recomputed by stochgeom.thesis.recompute_tables.four_gon_at_three_steps" in shown
        assert "10.959" in shown

    def test_check(self, capsys):
        assert main(["errata", "--check"]) == 0
        shown = capsys.readouterr().out
        assert shown.count("\n  ok ") == len(ERRATA) - 1
        assert "all hold" in shown

    @pytest.mark.parametrize("options", [["--check"], ["--json"], ["1"]])
    def test_what_does_not_hold_is_a_failed_check(self, capsys, monkeypatch, options):
        wrong = replace(
            ERRATA[0], recompute=lambda: (facts.equal("two", 1, 2), facts.equal("a", 1, 1))
        )
        monkeypatch.setattr(register, "ERRATA", (wrong, *ERRATA[3:5]))
        assert main(["errata", *options]) == 1
        shown = capsys.readouterr().out
        assert ("FAILED" in shown) is ("--json" not in options)
        if options == ["--check"]:
            assert "1 of them FAILED" in shown
            assert "two: 1" in shown

    def test_document(self, capsys):
        assert main(["errata", "7.5", "--json"]) == 0
        document = json.loads(capsys.readouterr().out)
        assert document["schema"] == "stochgeom/errata/1"
        (found,) = document["errata"]
        assert found["where"] == "Eq. 7.5"
        assert all(fact["holds"] for fact in found["facts"])

    def test_an_unknown_one(self, capsys):
        assert main(["errata", "77", "--json"]) == 2
        captured = capsys.readouterr()
        assert json.loads(captured.out)["error"]["type"] == "UnknownErratumError"
        assert captured.err.count("\n") == 1
        assert "'77'" in captured.err
