"""The audit finds planners, certificates and searches that are wrong, and says how to repeat it."""

from __future__ import annotations

import json

import pytest

from stochgeom.errors import InputError
from stochgeom.exact.angles import Angle
from stochgeom.exact.lifted import Gap, LiftedAngles
from stochgeom.feeding import audit as module
from stochgeom.feeding.adversarial import FAMILIES
from stochgeom.feeding.audit import (
    Case,
    Comparison,
    audit,
    audit_case,
    audit_cases,
    audit_part,
    compare_with_search,
    reproduction,
    summarize,
)
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.io.load import load_part
from stochgeom.io.outlines import parse_outline

TIE = Case("structural ties", 4, 0)
SQUARE = Part([(0, 0), (1, 0), (1, 1), (0, 1)], name="square")


@pytest.fixture
def planner_that_lets_ties_fit(monkeypatch):
    """A planner that takes <= for <, as one that rounds does where a tie is exact."""
    strictly_below, strictly_widest = LiftedAngles.last_below, LiftedAngles.widest_below

    def a_bit_more(offset):
        return (offset.angle if isinstance(offset, Gap) else offset) + Angle(0, (10**60, 1))

    monkeypatch.setattr(
        LiftedAngles,
        "last_below",
        lambda self, offset: strictly_below(self, a_bit_more(offset)),
    )
    monkeypatch.setattr(
        LiftedAngles,
        "widest_below",
        lambda self, images, offset: strictly_widest(self, images, a_bit_more(offset)),
    )


class TestRows:
    @pytest.mark.parametrize("family", FAMILIES)
    def test_every_family_passes(self, family):
        for row in audit([family], 4, exhaustive=compare_with_search):
            assert row.disagreement is None
            assert row.certificates == 1 + (row.optimal_steps != row.shortest_steps)
            assert 1 <= row.optimal_steps <= row.shortest_steps

    def test_a_row_says_what_was_found(self):
        row = audit_case(TIE, exhaustive=compare_with_search)
        assert (row.case, row.part) == (TIE, TIE.part())
        assert (row.optimal_steps, row.shortest_steps, row.certificates) == (2, 4, 2)
        assert row.comparison == Comparison(4, complete=True)

    def test_without_search_nothing_is_compared(self):
        assert audit_case(TIE).comparison is None

    def test_the_cost_ratio_decides_which_plan_is_optimal(self):
        steps = [audit_case(TIE, cost_ratio=c).optimal_steps for c in (0, 1, 10**6)]
        assert steps == [1, 2, 4]

    def test_parts_from_elsewhere(self):
        row = audit_part(SQUARE, Case("mine", 0, 0), exhaustive=compare_with_search)
        assert (row.optimal_steps, row.certificates, row.disagreement) == (1, 1, None)


class TestWhatIsFound:
    def test_a_planner_that_lets_ties_fit(self, planner_that_lets_ties_fit):
        for case in audit_cases(["structural ties"], 5):
            row = audit_case(case)
            assert row.disagreement is not None
            assert row.certificates < 1 + (row.optimal_steps != row.shortest_steps)

    def test_the_search_finds_it_as_well(self, planner_that_lets_ties_fit):
        compared = compare_with_search(FeedingProblem(TIE.part()))
        assert compared.disagreement == "exhaustive search: plans of 3 steps do not agree"

    def test_a_plan_that_is_not_the_best(self, monkeypatch):
        monkeypatch.setattr(FeedingProblem, "optimal_plan", lambda self, c: self.plan_of(3, c))
        row = audit_case(TIE)
        assert row.disagreement == "the plan of 3 steps: optimal is False, not True"
        assert row.certificates == 1

    def test_a_plan_that_does_not_orient(self, monkeypatch):
        monkeypatch.setattr(FeedingProblem, "geometric_plan", lambda self, c: self.plan_of(3, c))
        assert "orients_up_to_symmetry is False" in audit_case(TIE).disagreement

    def test_a_certificate_that_lies(self, monkeypatch):
        honest = module.certificate

        def lying(plan):
            document = honest(plan)
            document["preimages"][1]["width"]["direction"] = ["-1", "3"]
            return document

        monkeypatch.setattr(module, "certificate", lying)
        row = audit_case(TIE)
        assert row.disagreement.startswith("the certificate of the plan of 2 steps: preimages.1.")
        assert row.certificates == 0

    def test_a_certificate_that_is_none(self, monkeypatch):
        monkeypatch.setattr(module, "certificate", lambda _: {"schema": "other/9"})
        assert "schema" in audit_case(TIE).disagreement

    def test_any_error_at_all(self, monkeypatch):
        def failing(plan):
            raise ZeroDivisionError("by accident")

        monkeypatch.setattr(module, "certificate", failing)
        row = audit_case(TIE)
        assert row.disagreement == "ZeroDivisionError: by accident"
        assert (row.optimal_steps, row.certificates) == (0, 0)

    def test_a_search_that_disagrees(self):
        row = audit_case(TIE, exhaustive=lambda _: Comparison(1, False, "no"))
        assert row.disagreement == "no"
        assert row.certificates == 2

    def test_interruption_is_no_finding(self):
        def stop(problem):
            raise KeyboardInterrupt

        with pytest.raises(KeyboardInterrupt):
            audit_case(TIE, exhaustive=stop)


class TestSearch:
    def test_large_parts_are_not_searched(self):
        problem = FeedingProblem(FAMILIES["Reuleaux-like parts"](18, 0))
        assert compare_with_search(problem) == Comparison(0, complete=False)
        assert compare_with_search(problem, most_states=18, node_limit=500).lengths > 0

    def test_complete_lengths_are_compared_at_the_node_limit(self):
        problem = FeedingProblem(FAMILIES["long plans"](9, 0))
        compared = compare_with_search(problem, node_limit=300)
        assert not compared.complete
        assert 1 <= compared.lengths < 9
        assert compared.disagreement is None


class TestCases:
    def test_families_one_after_the_other(self):
        cases = list(audit_cases(["needles", "spirals"], 3, seed=5))
        assert [case.family for case in cases] == ["needles"] * 3 + ["spirals"] * 3
        assert [case.seed for case in cases] == [5, 6, 7] * 2
        assert len(list(audit_cases(count=2))) == 2 * len(FAMILIES)

    def test_a_case_is_the_same_in_every_audit(self):
        late = list(audit_cases(["long plans"], 10, seed=0))[7]
        assert [late] == list(audit_cases(["long plans"], 1, seed=7))

    def test_random_hulls_have_ten_points(self):
        assert {case.size for case in audit_cases(["random hulls"], 20)} == {10}

    @pytest.mark.parametrize("count", [0, -1])
    def test_some_parts_are_needed(self, count):
        with pytest.raises(InputError, match="accepted: 1 or more"):
            audit_cases(None, count)

    def test_families_must_exist(self):
        with pytest.raises(InputError, match="family 'squares'"):
            audit_cases(["squares"])


class TestReproductions:
    def test_a_finding_over_a_field_is_an_outline(self, tmp_path):
        part = Part([(0, 0), (2, 0), ("1/2*sqrt(3)", 1)], name="obtuse")
        pentagon = Part.regular(5)
        for found in (part, pentagon):
            row = audit_part(found, Case("long plans", 5, 1))
            assert (row.disagreement, row.certificates) == (None, 1 + (found is part))
            file = tmp_path / "finding.json"
            file.write_text(row.reproduction())
            assert load_part(str(file)).vertices == found.vertices

    def test_a_finding_is_an_outline(self, tmp_path):
        row = audit_case(TIE)
        text = row.reproduction()
        document = json.loads(text)
        assert (document["family"], document["size"], document["seed"]) == (TIE.family, 4, 0)
        assert document["message"] == "no disagreement"
        file = tmp_path / "finding.json"
        file.write_text(text, encoding="utf-8")
        assert load_part(str(file)) == row.part

    @pytest.mark.parametrize("family", FAMILIES)
    def test_parts_read_back_exactly(self, family):
        part = FAMILIES[family](FAMILIES[family].usual[1], 3)
        text = reproduction(part, family, 1, 3, 'a "message"\nof two lines')
        found = parse_outline(text)
        assert found.vertices == part.vertices
        assert found.name == part.name


class TestSummaries:
    def test_a_summary_counts(self, monkeypatch):
        rows = list(audit(["long plans", "needles"], 3, 0, exhaustive=compare_with_search))
        long_plans, needles = summarize(rows)
        assert (long_plans.family, long_plans.parts, long_plans.longest) == ("long plans", 3, 5)
        assert (long_plans.sides, long_plans.searched, long_plans.disagreements) == (5, 3, 0)
        assert long_plans.certificates == sum(row.certificates for row in rows[:3])
        assert needles.family == "needles"

    def test_disagreements_are_counted(self):
        def wrong(problem):
            return Comparison(1, False, "no" if len(problem.part) == 3 else None)

        [summary] = summarize(audit(["needles"], 4, exhaustive=wrong))
        assert (summary.parts, summary.disagreements, summary.searched) == (4, 1, 0)

    def test_summaries_come_as_families_end(self):
        rows = audit(["long plans", "needles"], 2)
        assert next(summarize(rows)).family == "long plans"
        assert next(rows).case.seed == 1  # one row of the next family was taken
