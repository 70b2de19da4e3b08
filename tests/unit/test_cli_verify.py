"""``stochgeom plan --certificate`` and ``stochgeom verify``."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from stochgeom.cli.certified import scope
from stochgeom.feeding import certificate_checker
from stochgeom.feeding.planner import plan_feeding
from stochgeom.thesis.parts import catalogue_names
from tests.commands import call

HOUSE = ["--part", "house", "--angles", "0"]


@pytest.fixture
def house(capsys, tmp_path):
    """Return the path of a certificate of the house."""
    path = tmp_path / "house.json"
    assert call(capsys, "plan", "house", "--certificate", str(path)).code == 0
    return path


@pytest.mark.parametrize("name", catalogue_names())
def test_what_plan_writes_verify_takes(capsys, tmp_path, name):
    path = str(tmp_path / "plan.json")
    assert call(capsys, "plan", name, "--cost-ratio", "1/2", "--certificate", path).code == 0
    result = call(capsys, "verify", path)
    assert (result.code, result.err) == (0, "")
    assert result.out.startswith("valid: ")
    assert f" for {name}: of least expected cost at a cost ratio of 1/2" in result.out


def test_the_words_of_a_verdict(capsys, house, tmp_path):
    result = call(capsys, "verify", str(house))
    valid, *scope = result.out.splitlines()
    assert valid == "valid: 1 squeeze for house: of least expected cost at a cost ratio of 1"
    assert scope == [
        "certified for parts that arrive in any orientation, all equally likely; compared with all",
        "plans of an exact gripper, whatever their final orientation. No prior is certified.",
        "The plan ends at 90.0000 degrees relative to the gripper, and bears any gripper error.",
    ]
    path = str(tmp_path / "rectangle.json")
    call(capsys, "plan", "rectangle", "--certificate", path)
    valid, *_, last = call(capsys, "verify", path).out.splitlines()
    assert valid == (
        "valid: 2 squeezes for rectangle: of least expected cost at a cost ratio of 1, and the "
        "fewest that orient it up to symmetry"
    )
    assert last == (
        "The plan ends at 180.0000 degrees relative to the gripper, and bears gripper errors "
        "below 11.3099 degrees."
    )


def test_what_was_asked_for_beyond_a_certificate_is_not_said_to_be_certified(capsys, tmp_path):
    path = str(tmp_path / "plan.json")
    asked = ["rectangle", "--goal", "0", "--gripper-error", "2", "--certificate", path]
    planned = call(capsys, "plan", *asked)
    assert planned.code == 0
    assert "neither the goal nor the gripper error is part of the certificate" in planned.out
    assert "goal" not in Path(path).read_text()
    verdict = call(capsys, "verify", path).out
    assert "whatever their final orientation" in verdict
    assert "gripper errors below 11.3099 degrees" in verdict  # more than the 2 asked for
    # Without a goal or an error there is nothing to say.
    assert "part of the certificate" not in call(
        capsys, "plan", "rectangle", "--certificate", path
    ).out  # fmt: skip


def test_a_plan_that_a_goal_makes_another_has_no_certificate(capsys, tmp_path):
    path = str(tmp_path / "plan.json")
    result = call(capsys, "plan", "house", "--goal", "0", "--certificate", path)
    assert (result.code, result.out) == (2, "")
    assert "a goal or an inexact gripper makes this another plan" in result.err


def test_an_error_that_is_borne_at_a_tie_and_numbers_over_a_field(tmp_path):
    document = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)]).certificate()
    action = document["plan"]["actions"][1]
    action["angle"] = action["high"]  # allowed: ranges are closed above
    assert scope(document)[-1].endswith("bears no gripper error.")
    action["high"] = {"turns": 0, "direction": ["s", "1"]}
    assert scope(document)[-1] == "Its final orientation and its ranges are in the certificate."


def test_a_page_that_was_changed_beside_its_certificate(capsys, tmp_path):
    path = tmp_path / "page.html"
    call(capsys, "report", "rectangle", "-o", str(path))
    path.write_text(path.read_text().replace("0.5000", "0.6000"))
    result = call(capsys, "verify", str(path))
    assert result.code == 0
    assert "Checked is the certificate inside the page, not what the page shows" in result.out


@pytest.mark.parametrize(
    ("arguments", "subject", "claims"),
    [
        (
            ["house", "--center-of-mass", "0,2/5"],
            "3 push-grasps for house, its centre of mass at (0, 2/5)",
            "1, and the fewest that orient it up to symmetry",
        ),
        (
            ["house", "--center-of-mass", "0,2/5", "--cost-ratio", "0"],
            "1 push-grasp for house, its centre of mass at (0, 2/5)",
            "0",
        ),
        (
            ["--vertices", "0,0 2,0 2,2 0,2"],
            "1 push-grasp for this part, its centre of mass at (1, 1)",
            "1, and the fewest that orient it up to symmetry",
        ),
    ],
)
def test_push_grasp_plans(capsys, tmp_path, arguments, subject, claims):
    path = str(tmp_path / "plan.json")
    pushing = ["--action", "push-grasp", "--certificate", path]
    assert call(capsys, "plan", *arguments, *pushing).code == 0
    result = call(capsys, "verify", path)
    verdict = f"valid: {subject}: of least expected cost at a cost ratio of {claims}"
    assert (result.code, result.out.splitlines()[0], result.err) == (0, verdict, "")
    document = json.loads(Path(path).read_text())
    document["push"]["breaks"][0]["vertex"] += 1
    Path(path).write_text(json.dumps(document))
    result = call(capsys, "verify", path)
    assert (result.code, result.err) == (1, "")
    assert result.out.startswith("invalid: push.breaks.0.vertex: claimed ")
    assert call(capsys, "verify", path, "--json").document["claim"] == "push.breaks.0.vertex"


def test_a_centre_of_mass_moved_in_the_file(capsys, tmp_path):
    path = tmp_path / "plan.json"
    pushing = ["--action", "push-grasp", "--certificate", str(path)]
    call(capsys, "plan", "house", "--center-of-mass", "0,2/5", *pushing)
    text = path.read_text()
    for moved, words in (("1/2", "invalid: push."), ("5", "invalid: part.center_of_mass: not ")):
        path.write_text(text.replace('"2/5"', f'"{moved}"', 1))
        result = call(capsys, "verify", str(path))
        assert (result.code, result.err) == (1, "")
        assert result.out.startswith(words)


def test_a_lie_is_named_and_the_exit_code_is_1(capsys, house):
    document = json.loads(house.read_text())
    document["preimages"][1]["last"] += 1  # from 1
    house.write_text(json.dumps(document))
    result = call(capsys, "verify", str(house))
    assert (result.code, result.err) == (1, "")
    assert result.out == "invalid: preimages.1.last: claimed 2, but 1 holds\n"
    verdict = json.loads(call(capsys, "verify", str(house), "--json").out)
    assert verdict["valid"] is False
    assert verdict["claim"] == "preimages.1.last"


def test_a_verdict_for_machines(capsys, house):
    assert json.loads(call(capsys, "verify", str(house), "--json").out) == {
        "schema": "stochgeom/verdict/1",
        "valid": True,
        "claim": None,
        "message": "",
    }


def test_the_checker_runs_alone_where_nothing_is_installed(house, tmp_path):
    alone = tmp_path / "alone.py"
    alone.write_bytes(Path(certificate_checker.__file__).read_bytes())
    command = [sys.executable, "-I", "-S", str(alone), str(house)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "valid\n", "")


@pytest.mark.parametrize("action", ["squeeze", "push-grasp"])
@pytest.mark.parametrize("part", ["regular-7", "cut"])
def test_a_part_over_a_field(capsys, tmp_path, part, action):
    outline, path = tmp_path / "cut.txt", tmp_path / "plan.json"
    outline.write_text("0,0\n1,0\n1/2,sqrt(3)/2\n-1/4,sqrt(3)/3\n")
    source = str(outline) if part == "cut" else part
    assert call(capsys, "plan", source, "--action", action, "--certificate", str(path)).code == 0
    document = json.loads(path.read_text())
    assert document["schema"] == "stochgeom/certificate/2"
    result = call(capsys, "verify", str(path))
    assert (result.code, result.err) == (0, "")
    assert result.out.startswith("valid: ")
    document["period"]["turns"] = 3
    path.write_text(json.dumps(document))
    result = call(capsys, "verify", str(path))
    assert (result.code, result.err) == (1, "")
    assert result.out.startswith("invalid: period: claimed about ")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "not JSON"),
        (b"[1, 2", "not JSON"),
        (b"\xff\xfe", "not JSON"),
        (b'{"schema": "stochgeom/certificate/3"}', "accepted: 'stochgeom/certificate/1' or"),
        (b'{"schema": "stochgeom/certificate/2"}', "part"),
        (b'{"schema": "stochgeom/certificate/2", "part": {}}', "part.field"),
        (b"[]", "accepted: 'stochgeom/certificate/1'"),
        (b'{"schema": "stochgeom/certificate/1"}', "part"),
        (b'{"a": 1, "a": 2}', "twice"),
        (b"[" * 100_000, "not JSON"),
    ],
)
def test_files_that_are_no_certificates(capsys, tmp_path, content, words):
    path = tmp_path / "plan.json"
    path.write_bytes(content)
    result = call(capsys, "verify", str(path))
    assert result.code == 2
    assert result.out == ""
    assert words in result.err
    assert str(path) in result.err
    assert "`stochgeom plan --certificate` writes" in result.err
    assert result.err.count("accepted: ") == 1


@pytest.mark.parametrize("path", ["no/such/file.json", "."])
def test_files_that_cannot_be_read(capsys, path):
    result = call(capsys, "verify", path)
    assert result.code == 2
    assert result.err.startswith(f"stochgeom: {path}: cannot be read: ")


def test_nothing_is_half_written(capsys, tmp_path):
    missing = tmp_path / "missing" / "plan.json"
    result = call(capsys, "plan", "house", "--certificate", str(missing))
    assert result.code == 2
    assert "cannot be written: No such file or directory" in result.err
    folder = tmp_path / "folder"
    folder.mkdir()
    assert call(capsys, "plan", "house", "--certificate", str(folder)).code == 2
    assert [path.name for path in tmp_path.iterdir()] == ["folder"]


class TestOtherPeoplesPlans:
    def test_the_printed_plan_of_the_thesis_orients_the_4gon(self, capsys):
        arguments = ["--part", "4gon", "--angles", "0, 71, 35, 8", "--cumulative"]
        result = call(capsys, "verify", *arguments, "--claims", "up-to-symmetry")
        assert (result.code, result.err) == (0, "")
        assert "4 actions on 4gon: 2 final orientations (up to symmetry)\n" in result.out
        assert result.out.endswith("\nthe claim up-to-symmetry holds\n")

    def test_a_claim_that_fails_exits_with_1(self, capsys):
        arguments = ["--part", "house", "--angles", "0, 45", "--claims", "probability=0.51"]
        result = call(capsys, "verify", *arguments)
        assert (result.code, result.err) == (1, "")
        assert "the claim probability=0.51 fails, the most likely final orientation" in result.out
        assert call(capsys, "verify", *arguments[:-1], "probability=1/2").code == 0

    def test_a_plan_that_could_be_better(self, capsys):
        out = call(capsys, "verify", "--part", "house", "--angles", "0, -5").out
        assert "a plan of 2 actions reaches probability 0.5000; the first action" in out

    def test_a_report_for_machines(self, capsys):
        arguments = ["--part", "house", "--angles", "-10, 45", "--claims", "up-to-symmetry"]
        document = call(capsys, "verify", *arguments, "--json").document
        assert document["schema"] == "stochgeom/report/1"
        assert document["claim"] == {"text": "up-to-symmetry", "holds": True}
        assert document["probability"] == "0.5000"
        low, high = (document["margins"][1][end]["degrees"] for end in ("low", "high"))
        assert (low, high) == ("18.4349", "71.5651")

    def test_push_grasps_about_a_given_centre(self, capsys):
        arguments = ["--part", "house", "--center-of-mass", "0,2/5", "--action", "push-grasp"]
        result = call(capsys, "verify", *arguments, "--angles", "0, 72, 135", "--cumulative")
        assert (result.code, result.err) == (0, "")
        assert result.out.startswith("3 actions on house: 1 final orientation\n")  # Fig. E.8
        assert "to 270.0000\nprobability 1.0000, expected cost 4.0000\n" in result.out

    def test_vertices_that_are_off(self, capsys):
        arguments = ["--part", "rectangle", "--angles", "0, -45", "--vertex-error"]
        result = call(capsys, "verify", *arguments, "1/10")
        assert (result.code, result.err) == (0, "")
        assert result.out.endswith(
            "Proven for every part with vertices within 1/10 of the given ones, which end with the "
            "same edges flush\n"
            "     from        to  ends from        to\n"
            "  56.3100  236.3099   176.1774  183.8226\n"
        )
        result = call(capsys, "verify", *arguments, "1/5")
        assert result.code == 1
        assert "\nNot proven for every part with vertices within 1/5 of the given" in result.out
        found = call(capsys, "verify", *arguments, "0.1", "--json").document["part_errors"]
        assert (found["vertex_error"], found["proven"], found["reason"]) == ("1/10", True, None)
        assert found["arcs"][0]["final"]["width"]["degrees"] == "7.6451"

    @pytest.mark.parametrize(
        ("arguments", "words"),
        [
            (["--part", "house"], "accepted: FILE alone, or --part and --angles together"),
            (["--angles", "0"], "accepted: FILE alone, or --part and --angles together"),
            (["plan.json", "--angles", "0"], "accepted: FILE alone"),
            (["plan.json", "--action", "push-grasp"], "--action is about angles"),
            (["plan.json", "--cumulative"], "--cumulative is about angles"),
            (["plan.json", "--vertex-error", "1"], "accepted: FILE alone"),
            ([*HOUSE, "--vertex-error", "-1"], "vertex error: -1; accepted"),
            ([*HOUSE, "--vertex-error", "x"], "vertex error: 'x' is not a number; accepted"),
            ([*HOUSE, "--action", "push"], "invalid choice: 'push'"),
            ([*HOUSE, "--action", "push-grasp", "--center-of-mass", "9,9"], "(9, 9) lies outside"),
            ([], "accepted: FILE alone"),
            (["--part", "house", "--angles", "0, east"], "action 1: 'east' is no angle; accepted"),
            (["--part", "house", "--angles", ""], "angles: no actions; accepted: at least one"),
            (["--part", "hose", "--angles", "0"], "hose: "),
            (["--part", "house", "--angles", "0", "--claims", "best"], "accepted: up-to-symmetry"),
            (["--part", "house", "--angles", "0", "--cost-ratio", "-1"], "-1 is negative"),
            (["--part", "house", "--angles", "0," * 1_000_001 + "0"], "at most 1000000 actions"),
        ],
    )
    def test_bad_input(self, capsys, arguments, words):
        result = call(capsys, "verify", *arguments)
        assert (result.code, result.out) == (2, "")
        assert words in result.err


def test_another_document_is_no_certificate(capsys, tmp_path):
    path = tmp_path / "other.json"
    path.write_text('{"a": 1}')
    result = call(capsys, "verify", str(path))
    assert result.code == 2
    assert result.err.count("accepted: ") == 1
    assert "no certificate: schema: None; accepted: 'stochgeom/certificate/1'" in result.err
