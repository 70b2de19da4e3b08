"""The register of errata: complete, settled by computations that can fail, and its command."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from itertools import product
from math import atan

import pytest
from gmpy2 import mpq

import stochgeom.thesis.errata_register as register
from stochgeom.cli.main import main
from stochgeom.decision.goal_costs import GoalCost
from stochgeom.errors import InputError, UnknownErratumError
from stochgeom.exact.balls import working_precision
from stochgeom.geometry.part import Part
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.pushing_model import pushing_bound
from stochgeom.thesis import errata, errata_statements, facts
from stochgeom.thesis import recompute_backchaining as backchaining
from stochgeom.thesis import recompute_densities as densities
from stochgeom.thesis import recompute_framework as framework
from stochgeom.thesis import recompute_grasps as grasps
from stochgeom.thesis import recompute_orientations as orientations
from stochgeom.thesis import recompute_planning as planning
from stochgeom.thesis import recompute_tables as tables
from stochgeom.thesis.appendix_g import FIGURES_G
from stochgeom.thesis.chapter_6 import FIGURE_6_4_ERRATA
from stochgeom.thesis.errata import Erratum
from stochgeom.thesis.errata_register import ERRATA, find_errata
from stochgeom.thesis.evolutions import Probability
from stochgeom.thesis.figures_4 import FIGURE_4_6
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.push_grasp import push_grasp_function


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
            (backchaining, backchaining.closure_in_lemma_5_1),
            (backchaining, backchaining.plans_of_phase_one),
            (orientations, orientations.stable_orientations),
            (orientations, orientations.caption_of_figure_e_1),
            (densities, densities.density_of_other_parts),
        ],
    )
    def test_with_another_part(self, monkeypatch, module, recompute):
        other = catalogue_part("rectangle")
        monkeypatch.setattr(module, "catalogue_part", lambda *_, **__: other)
        assert self.failing(recompute)

    def test_with_another_prior(self, monkeypatch):
        monkeypatch.setattr(framework, "PRIOR", (framework.PRIOR[1],) * 4 + framework.PRIOR[:1])
        assert self.failing(framework.cost_with_a_sensor)

    def test_with_an_action_that_costs_something(self, monkeypatch):
        monkeypatch.setattr(framework, "GoalCost", lambda goal, _: GoalCost(goal, "1/10"))
        assert len(self.failing(framework.length_of_cheap_plans)) == 4

    def test_with_other_states(self, monkeypatch):
        monkeypatch.setattr(framework, "CANONICAL", framework.CANONICAL[:-1])
        assert len(self.failing(framework.states_of_the_tray)) == 2

    def test_with_a_centre_that_is_the_centroid(self, monkeypatch):
        longer = Part([(0, 0), ("3.8", 0), ("3.8", 2), (0, 2)])
        monkeypatch.setattr(planning, "catalogue_part", lambda _: longer)
        (claim,) = self.failing(planning.period_and_symmetry)
        assert "(1.9, 1)" in claim

    def test_with_a_part_without_ties(self, monkeypatch):
        monkeypatch.setattr(
            backchaining, "FAMILIES", {"structural ties": lambda *_: catalogue_part("4gon")}
        )
        with pytest.raises(ValueError, match="empty"):
            backchaining.wider_arcs_in_5_7()

    def test_with_rectangles_in_too_few_ranges(self, monkeypatch):
        monkeypatch.setattr(tables, "RANGES", 100)
        (claim,) = self.failing(tables.rectangle_in_table_c_1)
        assert "mu = .05 is at least" in claim

    def test_with_a_box_around_the_centre_of_the_tables(self, monkeypatch):
        """There the cell is .90, so that the bound cannot exclude it."""
        box = ((mpq(-1, 100), mpq(1, 100)), (mpq(1, 50), mpq(1, 25)))
        monkeypatch.setattr(densities, "E_8_BOX", box)
        assert any("Table C.1" in claim for claim in self.failing(densities.density_of_the_house))

    @pytest.mark.parametrize(
        ("name", "value", "words"),
        [
            ("CORNER_SLOPES", (mpq(68, 100), mpq(78, 100)), "slopes"),
            ("CORNER_SLOPES", (mpq(66, 100), mpq(77, 100)), "slopes"),
            ("CORNER_HEIGHT", mpq(342, 1000), "height"),
            ("CORNER_HEIGHT", mpq(2, 3), "mu = .25"),
        ],
    )
    def test_with_another_triangle(self, monkeypatch, name, value, words):
        monkeypatch.setattr(densities, name, value)
        (claim,) = self.failing(densities.density_of_the_house)
        assert words in claim

    def test_with_a_key_that_is_not_uniform_there(self, monkeypatch):
        outlines = {"key": catalogue_part("key").vertices}
        monkeypatch.setattr(densities, "UNIFORM_OUTLINES", outlines)
        assert self.failing(densities.density_of_other_parts) == ["cells of another key, uniform"]

    def test_with_fewer_executions(self, monkeypatch):
        monkeypatch.setattr(framework, "EXECUTIONS", 100)
        assert self.failing(framework.success_of_the_second_plan)


class TestBounds:
    """The two enclosures that carry an erratum, held against the numbers that they enclose."""

    @pytest.mark.parametrize("mu", ["0.25", "0.1", "0.05"])
    def test_of_rectangles(self, mu):
        """By ratio: the diagonal's angle is arctan 1 / r."""
        for ratio in (1, 2, 5, 13, 60):
            exact = pushing_bound(GraspDiagram([(0, 0), (ratio, 0), (ratio, 1), (0, 1)], mu))
            angle = mpq(str(atan(1 / ratio)))
            with working_precision(64):
                near = mpq(1, 10**6)
                low, high = tables.rectangle_bounds(angle - near, angle + near, mu)
                assert low < exact.ball() < high
                assert high - low < 1e-4

    @pytest.mark.parametrize("centre", [("0.01", "0.3"), ("-0.03", "0.4"), (0, "0.35")])
    def test_of_the_house_after_a_push(self, centre):
        corners = catalogue_part("house").vertices
        exact = pushing_bound(GraspDiagram(Part(corners, centre), "0.1"))
        most = [
            densities.most_after_push(corners, densities.E_8_BOX, "0.1", cuts) for cuts in (1, 2, 4)
        ]
        assert exact.compare(most[2]) < 0
        assert most[0].compare(most[1]) >= 0 <= most[1].compare(most[2])
        x, y = (mpq(value) for value in centre)
        point = ((x, x), (y, y))
        assert densities.most_after_push(corners, point, "0.1").decimal(9) == exact.decimal(9)

    def test_of_the_house_in_the_corner(self):
        """At centres all over the triangle, and of those the few that have .40, .20 and .40."""
        corners, (low, high) = catalogue_part("house").vertices, densities.CORNER_SLOPES
        most, fitting = densities.most_in_the_corner("0.25"), 0
        for k, m in product((1, 2, 4, 10, 20), range(1, 6)):
            y = densities.CORNER_HEIGHT * mpq(k, 20)
            part = Part(corners, (y / (low + (high - low) * mpq(m, 6)) - 1, y - 1))
            assert pushing_bound(GraspDiagram(part, "0.25")).compare(most) < 0
            fitting += densities._gives_figure_e_8(part)
        assert fitting

    def test_a_box_in_which_other_edges_are_stable(self):
        corners = catalogue_part("house").vertices
        with pytest.raises(InputError, match="accepted: a smaller box"):
            densities.most_after_push(corners, ((0, mpq(1, 2)), (0, mpq(1, 4))), "0.1")

    def test_the_box_holds_all_centres_that_give_figure_e_8(self):
        """A grid over the whole house, by the steps of its push-grasps: none lies outside."""
        corners = catalogue_part("house").vertices
        (west, east), (low, high) = densities.E_8_BOX
        found = 0
        for x, y in product(range(-28, 29, 4), range(-31, 64, 2)):
            if abs(x) + y >= 64:
                continue
            centre = (mpq(x, 32), mpq(y, 32))
            s = push_grasp_function(Part(corners, centre))
            assert [value.reduced().degrees(0) for value in s.values] == ["90", "270", "0"]
            if [Probability(width).decimal(2) for width in s.widths] == ["0.40", "0.40", "0.20"]:
                found += 1
                assert west < centre[0] < east
                assert low < centre[1] < high
        assert found == 2


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
