"""``stochgeom audit``."""

from __future__ import annotations

import json

import pytest

from stochgeom.feeding import certificate_checker
from stochgeom.feeding.adversarial import FAMILIES
from tests.commands import call


def test_every_family_has_a_row(capsys):
    result = call(capsys, "audit", "--count", "1", "--no-search")
    assert (result.code, result.err) == (0, "")
    lines = result.out.splitlines()
    assert [line.split("  ")[1] for line in lines[1:-2]] == list(FAMILIES)
    assert lines[-1].startswith(f"{len(FAMILIES)} parts, ")
    assert lines[-1].endswith(" certificates found valid, 0 disagreements")


def test_the_seed_makes_the_parts(capsys):
    one = call(capsys, "audit", "--families", "random hulls", "--count", "5", "--seed", "3").out
    assert (
        one
        == call(capsys, "audit", "--families", "random hulls", "--count", "5", "--seed", "3").out
    )


def test_push_grasps(capsys):
    """A pushed part is told from itself half a turn on, so plans collapse twice as much."""
    arguments = ["--families", "slivers,random hulls", "--count", "4"]
    result = call(capsys, "audit", *arguments, "--action", "push-grasp", "--json")
    assert (result.code, result.err) == (0, "")
    pushed = result.document["families"]
    squeezed = call(capsys, "audit", *arguments, "--json").document["families"]
    assert [row["parts"] for row in pushed] == [4, 4]
    assert all(row["disagreements"] == 0 for row in pushed)
    assert [row["longest"] for row in pushed] != [row["longest"] for row in squeezed]


def test_families_are_described(capsys):
    out = call(capsys, "audit", "--list").out
    assert all(f"  {family.name} " in out for family in FAMILIES.values())


def test_a_document_for_machines(capsys):
    out = call(capsys, "audit", "--families", "near ties", "--count", "4", "--json").out
    document = json.loads(out)
    assert document["schema"] == "stochgeom/audit/1"
    assert document["disagreement"] is None
    assert document["families"][0]["parts"] == document["families"][0]["searched"] == 4


def test_a_disagreement_stops_and_is_written_down(capsys, tmp_path, monkeypatch):
    """With a checker that accepts no third certificate, the third part is the finding."""
    checked = []

    def lie(document):
        checked.append(document)
        if len(checked) == 3:
            raise certificate_checker.InvalidClaimError("hull", "made up")

    monkeypatch.setattr(certificate_checker, "check", lie)
    path = tmp_path / "finding.json"
    arguments = ["--families", "long plans", "--count", "9", "--finding", str(path)]
    result = call(capsys, "audit", *arguments)
    assert result.code == 1
    assert "hull: made up" in result.out
    assert "  long plans      3 " in result.out
    finding = json.loads(path.read_text())
    assert (finding["family"], finding["seed"]) == ("long plans", 2)
    monkeypatch.undo()
    assert call(capsys, "plan", str(path)).code == 0


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--families", "none such"], "family 'none such'; accepted: long plans, "),
        (["--count", "0"], "0 parts of each family; accepted: 1 or more"),
        (["--count", "many"], "--count: 'many'; accepted: whole numbers from 0 on"),
        (["--seed", "9" * 16], "accepted: whole numbers from 0 on, of at most 15 digits"),
        (["--seed", "-1"], "--seed: '-1'; accepted: whole numbers from 0 on"),
    ],
)
def test_bad_input(capsys, arguments, words):
    result = call(capsys, "audit", *arguments)
    assert (result.code, result.out) == (2, "")
    assert words in result.err
