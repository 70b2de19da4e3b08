"""``stochgeom report``, and ``stochgeom verify`` of what it writes."""

from __future__ import annotations

import json

import pytest

import stochgeom as sg
from stochgeom.io.embedded import CERTIFICATE, data_block, find_block
from stochgeom.plotting.report import report_html
from stochgeom.thesis.parts import catalogue_names
from tests.commands import call, start


@pytest.fixture
def path(tmp_path):
    """Return where the report is written."""
    return tmp_path / "report.html"


@pytest.mark.parametrize("name", catalogue_names())
@pytest.mark.parametrize("action", ["squeeze", "push-grasp"])
def test_what_report_writes_verify_takes(capsys, path, name, action):
    result = call(capsys, "report", name, "--action", action, "-o", str(path))
    assert (result.code, result.err) == (0, "")
    assert result.out.startswith(f"{path}: a plan of ")
    assert result.out.endswith(f"with its certificate, {path.stat().st_size} bytes\n")
    plan = sg.plan_feeding(sg.load_part(name), action=action)
    assert path.read_text(encoding="utf-8") == report_html(plan)
    verdict = call(capsys, "verify", str(path))
    assert (verdict.code, verdict.err) == (0, "")
    assert verdict.out.startswith("valid: ")


def test_options_are_those_of_plan(capsys, path):
    options = ("--cost-ratio", "1/2", "--prior", "normal:10,30", "--gripper-error", "2")
    more = ("--goal", "most stable", "--center-of-mass", "0,1/3", "--digits", "6")
    result = call(capsys, "report", "house", *options, *more, "--output", str(path))
    assert (result.code, result.err) == (0, "")
    problem = sg.FeedingProblem(
        sg.load_part("house", center_of_mass="0,1/3"),
        prior=sg.WrappedNormal(mean="10", sd="30"),
        gripper_error="2",
        goal="most stable",
    )
    expected = report_html(problem.optimal_plan("1/2"), digits=6)
    assert path.read_text(encoding="utf-8") == expected
    assert "without a certificate" in result.out


def test_a_number_of_steps_may_be_chosen(capsys, path):
    result = call(capsys, "report", "house", "--steps", "2", "-o", str(path), "--json")
    assert result.document == {
        "schema": "stochgeom/report/1",
        "file": str(path),
        "bytes": path.stat().st_size,
        "certificate": True,
        "steps": 2,
    }
    plan = sg.orient_up_to_symmetry(sg.load_part("house"))
    assert path.read_text(encoding="utf-8") == report_html(plan)


def test_vertices_and_standard_input(path):
    result = start("report", "--vertices", "-1,-1 1,-1 0,2", "-o", str(path))
    assert (result.returncode, result.stderr) == (0, b"")
    first = path.read_bytes()
    result = start("report", "-", "-o", str(path), input=b"-1 -1\n1 -1\n0 2\n")
    assert (result.returncode, result.stderr) == (0, b"")
    assert path.read_bytes() == first


def test_the_default_name(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert call(capsys, "report", "house").code == 0
    assert [p.name for p in tmp_path.iterdir()] == ["report.html"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["nowhere"], "nowhere: neither a part of the catalogue nor a file"),
        ([], "neither SOURCE nor --vertices given"),
        (["house", "--steps", "9"], "--steps: 9 steps; accepted: 1 to 2 for this part"),
        (["house", "--steps", "0"], "--steps: 0 steps; accepted: 1 to 2 for this part"),
        (["house", "--steps", "two"], "--steps: 'two' steps; accepted: whole numbers from 1"),
        (["house", "--steps", "-1"], "--steps: '-1' steps; accepted: whole numbers from 1"),
        (["house", "--digits", "many"], "--digits: 'many' decimals"),
        (["house", "--cost-ratio", "-1"], "cost ratio"),
        (["house", "--action", "kick"], "--action: invalid choice"),
        (["house", "--goal", "33"], "33"),
        (["house", "--prior", "missing.txt"], "missing.txt"),
        (["house", "--gripper-error", "-2"], "-2"),
    ],
)
def test_bad_input_leaves_no_file(capsys, path, arguments, message):
    result = call(capsys, "report", *arguments, "-o", str(path))
    assert result.code == 2
    assert result.out == ""
    assert message in result.err
    assert result.err.count("\n") == 1
    assert list(path.parent.iterdir()) == []


@pytest.mark.parametrize("name", ["missing/report.html", "file/report.html", "", "folder", "a\0b"])
def test_a_file_that_cannot_be_written(capsys, tmp_path, name, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("kept", encoding="utf-8")
    (tmp_path / "folder").mkdir()
    result = call(capsys, "report", "house", "-o", name)
    assert result.code == 2
    assert "cannot be written" in result.err
    assert "accepted: a file in a writable folder" in result.err
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file", "folder"]
    assert (tmp_path / "file").read_text(encoding="utf-8") == "kept"


def test_errors_are_json_where_that_is_asked_for(capsys):
    result = call(capsys, "report", "house", "-o", "/nowhere/report.html", "--json")
    assert result.document["error"]["type"] == "WriteError"
    assert result.document["error"]["where"] == "/nowhere/report.html"


# --- reading the certificate out -----------------------------------------------------------------


def test_a_claim_changed_in_the_page_is_found(capsys, path):
    call(capsys, "report", "house", "-o", str(path))
    page = path.read_bytes()
    document = json.loads(find_block(page, CERTIFICATE))
    document["optimal_steps"] = 2
    before, after = page.split(find_block(page, CERTIFICATE))
    path.write_bytes(before + json.dumps(document).encode() + after)
    result = call(capsys, "verify", str(path))
    assert (result.code, result.err) == (1, "")
    assert result.out.startswith("invalid: optimal_steps")


def test_a_page_without_a_certificate(capsys, path):
    call(capsys, "report", "house", "--prior", "normal:10,30", "-o", str(path))
    result = call(capsys, "verify", str(path))
    assert result.code == 2
    assert "this page carries no certificate; accepted: " in result.err
    path.write_text("<html><body>some other page</body></html>", encoding="utf-8")
    assert call(capsys, "verify", str(path)).code == 2


def test_a_page_whose_block_is_no_json(capsys, path):
    block = data_block(CERTIFICATE, {}).replace("{}", "{nothing")
    path.write_text(f"<!DOCTYPE html>{block}", encoding="utf-8")
    result = call(capsys, "verify", str(path))
    assert result.code == 2
    assert "no certificate" in result.err


class TestDataBlocks:
    @pytest.mark.parametrize(
        "document",
        [
            {},
            {"a": "</script>", "b": ["<!--", "<script>", "]]>"]},
            {"name": "Gehäuse 7 \u2028 \U0001f600", "n": [1, None, True]},
        ],
    )
    def test_a_document_comes_back(self, document):
        block = data_block("x", document)
        assert block.isascii()
        assert block.count("<") == 2
        assert json.loads(find_block(f"<p>{block}</p>".encode(), "x")) == document

    def test_blocks_are_told_apart_by_name(self):
        page = (data_block("a", {"n": 1}) + data_block("b", {"n": 2})).encode()
        assert find_block(page, "b") == b'{"n":2}'
        assert find_block(page, "c") is None
        assert find_block(b"", "a") is None
