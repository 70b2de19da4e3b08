"""``stochgeom tilt``: every subcommand, its documents, and its errors."""

from __future__ import annotations

import json
import sys

import pytest

from stochgeom.io.recordings import recording_document, save_recording
from stochgeom.tilting.counts import TransitionCounts
from stochgeom.tilting.robot import SimulatedRobot
from tests.commands import call

ONE = [[0, 9, 0], [0, 9, 0], [0, 0, 9]]
TWO = [[9, 0, 0], [0, 0, 9], [9, 0, 0]]
NEVER = [[0, 0, 0]] * 3

COARSE = [f"--set={name}" for name in ("time_step=0.004", "iterations=5", "support_points=1")]
"""For tests that do not ask where the tile goes."""


@pytest.fixture
def model(tmp_path):
    """Three states and three tilts, the third one never tried."""
    path = str(tmp_path / "model.json")
    save_recording(path, recording_document(TransitionCounts([ONE, TWO, NEVER])))
    return path


class TestSimulate:
    def test_a_recording_is_written_and_planned_with(self, capsys, tmp_path):
        path = str(tmp_path / "seen.json")
        told = call(capsys, "tilt", "simulate", "--trials", "60", "--seed", "3", "--out", path)
        assert (told.code, told.err) == (0, "")
        assert told.out.startswith("60 trials, seed 3: a random state, a random tilt")
        assert f"stochgeom tilt plan {path}" in told.out
        document = json.loads((tmp_path / "seen.json").read_text())
        assert document["simulation"]["setup"]["tilt"] == "25.0"
        assert sum(row[3] for row in document["observations"]) == 60
        planned = call(capsys, "tilt", "plan", path, "--from", "1", "--to", "3")
        assert planned.code == 0

    def test_processes_do_not_change_the_document(self, capsys):
        arguments = ["tilt", "simulate", "--trials", "60", "--seed", "3", "--json", "--jobs"]
        assert call(capsys, *arguments, "1").out == call(capsys, *arguments, "2").out

    def test_the_document_counts_what_the_robot_does(self, capsys):
        found = call(capsys, "tilt", "simulate", "--trials", "25", "--jobs", "1", "--json").document
        counts = SimulatedRobot().observe(25)
        assert [tuple(row) for row in found["observations"]] == list(counts.trials())

    def test_another_tray_may_be_set(self, capsys):
        arguments = ["tilt", "simulate", "--trials", "5", "--jobs", "1", "--json", "--set"]
        found = call(capsys, *arguments, "tilt=30", "--set", "iterations=20").document
        setup = found["simulation"]["setup"]
        assert (setup["tilt"], setup["iterations"]) == ("30.0", "20")

    @pytest.mark.parametrize(
        ("arguments", "message"),
        [
            (["--trials", "0"], "--trials: '0'; accepted: whole numbers from 1 on"),
            (["--trials", "-5"], "--trials: '-5'; accepted"),
            (["--trials", "many"], "--trials: 'many'; accepted"),
            (["--seed", "1.5"], "--seed: '1.5'; accepted: whole numbers from 0 on"),
            (["--jobs", "0"], "--jobs: '0'; accepted"),
            (["--set", "tilt"], "--set: 'tilt'; accepted: NAME=VALUE"),
            (["--set", "colour=1"], "colour: no setting of that name; accepted: azimuth_sd"),
            (["--set", "tilt=x"], "tilt: 'x'; accepted: a number"),
            (["--set", "tile_length=400"], "tile_length: a tile of 400.0 by 40.0 mm in a tray"),
        ],
    )
    def test_bad_input_is_one_line(self, capsys, arguments, message):
        told = call(capsys, "tilt", "simulate", *arguments)
        assert (told.code, told.out) == (2, "")
        assert told.err.startswith(f"stochgeom: {message}")
        assert told.err.count("\n") == 1

    def test_a_missing_extra_is_named(self, capsys, monkeypatch):
        monkeypatch.setitem(sys.modules, "pymunk", None)
        told = call(capsys, "tilt", "simulate", "--trials", "1", "--jobs", "1")
        assert told.code == 2
        assert "accepted: the extra stochgeom[sim]" in told.err
        assert call(capsys, "tilt", "plan", "figure-6.4", "--from", "7", "--to", "1").code == 0


class TestEstimate:
    def test_figure_6_4(self, capsys):
        told = call(capsys, "tilt", "estimate", "figure-6.4")
        assert told.code == 0
        rows = [line.split() for line in told.out.splitlines()]
        assert rows[9] == ["7", "0.7401", "0.0012", "0.1244"] + ["0.0012"] * 8 + ["0.1244", "8"]

    def test_exact_numbers_for_machines(self, capsys, model):
        found = call(capsys, "tilt", "estimate", model, "--tilt", "2", "--json").document
        assert found["matrix"][0] == ["901/903", "1/903", "1/903"]
        assert found["counts"] == TWO

    def test_alpha_may_be_given(self, capsys, model):
        found = call(capsys, "tilt", "estimate", model, "--alpha", "1", "--json").document
        assert found["matrix"][0] == ["1/12", "5/6", "1/12"]

    def test_what_was_never_observed_is_told(self, capsys, model):
        assert (
            "Never observed: tilt 3; all that the model says"
            in call(capsys, "tilt", "estimate", model).out
        )

    @pytest.mark.parametrize(
        ("arguments", "message"),
        [
            (["--tilt", "4"], "action '4'; accepted: 1 to 3"),
            (["--alpha", "0"], "alpha: 0; accepted: numbers above 0"),
            (["--alpha", "-1/2"], "alpha: -1/2; accepted: numbers above 0"),
            (["--alpha", "small"], "--alpha: 'small' is not a number"),
            (["--states", "2"], "model.json, line 9: initial state '3'; accepted: 1 to 2"),
        ],
    )
    def test_bad_input_is_one_line(self, capsys, model, arguments, message):
        told = call(capsys, "tilt", "estimate", model, *arguments)
        assert (told.code, told.out) == (2, "")
        assert message in told.err


class TestPlan:
    @pytest.mark.parametrize(
        "method", ["all-plans", "branch-and-bound", "shortest-path", "expected"]
    )
    def test_every_method_finds_the_plan(self, capsys, model, method):
        arguments = ["tilt", "plan", model, "--from", "1", "--to", "3", "--method", method]
        found = call(capsys, *arguments, "--json").document
        assert found["tilts"] == [1, 2]
        assert found["probability"] == "0.9956"
        assert found["method"] == method
        assert (found["bound"] is not None) == (method == "shortest-path")

    def test_the_text_shows_the_states_on_the_way(self, capsys, model):
        told = call(capsys, "tilt", "plan", model, "--from", "1", "--to", "3")
        assert told.out.startswith("From 1 to 3: tilts 1 2; probability 0.9956")
        assert "expected under the posterior: 0.9956" in told.out
        assert "2: 0.998" in told.out

    def test_every_pair_may_be_planned(self, capsys, model):
        found = call(capsys, "tilt", "plan", model, "--all", "--json").document
        pairs = [(plan["from"], plan["to"]) for plan in found["plans"]]
        assert pairs == [(1, 2), (1, 3), (2, 1), (2, 3), (3, 1), (3, 2)]
        told = call(capsys, "tilt", "plan", model, "--all")
        assert "6 plans of 1.50 tilts on average" in told.out

    def test_a_tilt_never_observed_is_used_and_told_or_left_out(self, capsys, tmp_path):
        """With the prior alone a tilt brings one in three; the two observed ones bring less."""
        path = str(tmp_path / "model.json")
        away = [[0, 9, 0], [9, 0, 0], [9, 0, 0]]
        save_recording(path, recording_document(TransitionCounts([away, NEVER])))
        arguments = ["tilt", "plan", path, "--from", "1", "--to", "3"]
        used = call(capsys, *arguments)
        assert "tilts 2" in used.out
        assert "Never tried, but met with probability 1.000 at most: tilt 2 in state 1" in used.out
        assert "Never observed: tilt 2; plans may use such a tilt, by its prior alone" in used.out
        left_out = call(capsys, *arguments, "--observed-only", "--json").document
        assert set(left_out["tilts"]) <= {1}
        assert "plans leave such a tilt out" in call(capsys, *arguments, "--observed-only").out
        assert left_out["unobserved"] == []

    def test_a_recording_in_csv(self, capsys, tmp_path):
        path = tmp_path / "seen.csv"
        path.write_text("initial,action,final\n1,4,3\n1,4,3\n1,4,other\n")
        told = call(capsys, "tilt", "plan", str(path), "--from", "1", "--to", "3")
        assert "tilts 4" in told.out
        assert told.code == 0

    def test_a_long_plan_does_not_wait_for_its_expectation(self, capsys):
        arguments = ["--method", "branch-and-bound", "--max-tilts", "9"]
        told = call(capsys, "tilt", "plan", "figure-6.4", "--from", "7", "--to", "2", *arguments)
        assert told.code == 0
        assert "tilts 1 1 1 1 1 1 1 1 1;" in told.out
        assert "expected" not in told.out

    def test_at_the_goal_already(self, capsys, model):
        told = call(capsys, "tilt", "plan", model, "--from", "2", "--to", "2")
        assert told.out.startswith("From 2 to 2: tilts none; probability 1.0000")

    def test_no_path_is_exit_code_1(self, capsys, model):
        arguments = ["--method", "shortest-path", "--max-tilts", "0"]
        told = call(capsys, "tilt", "plan", model, "--from", "1", "--to", "2", *arguments)
        assert told.code == 1
        assert "no path of at most 0 tilts leads from 1 to 2" in told.err

    @pytest.mark.parametrize(
        ("arguments", "message"),
        [
            (["--from", "1"], "--to: missing; accepted: a state, 1 to 3"),
            (["--to", "1"], "--from: missing; accepted: a state, 1 to 3"),
            (["--from", "4", "--to", "1"], "--from: 4; accepted: a state, 1 to 3"),
            (["--from", "0", "--to", "1"], "--from: '0'; accepted: whole numbers from 1 on"),
            (["--all", "--to", "1"], "--all plans every pair; accepted: --from and --to, or --all"),
            (["--from", "1", "--to", "2", "--max-tilts", "30"], "make more than 5000000 plans"),
            (["--from", "1", "--to", "2", "--method", "luck"], "argument"),
        ],
    )
    def test_bad_input_is_one_line(self, capsys, model, arguments, message):
        told = call(capsys, "tilt", "plan", model, *arguments)
        assert (told.code, told.out) == (2, "")
        assert message in told.err or "luck" in told.err
        assert told.err.count("\n") == 1

    def test_a_missing_file_is_told(self, capsys):
        told = call(capsys, "tilt", "plan", "nowhere.json", "--from", "1", "--to", "2")
        assert told.code == 2
        assert "nowhere.json: cannot be read" in told.err


class TestExperiment:
    def test_estimated_and_measured_side_by_side(self, capsys, tmp_path):
        path = tmp_path / "found.json"
        arguments = ["--trials", "150", "--executions", "2", "--jobs", "1", "--out", str(path)]
        told = call(capsys, "tilt", "experiment", *arguments, *COARSE)
        assert told.code == 0
        assert told.out.startswith("150 trials, 2 executions of each of 132 plans")
        assert "mean number of tilts" in told.out
        document = json.loads(path.read_text())
        (only,) = document["runs"]
        assert len(only["plans"]) == 132
        assert all(plan["executions"] == 2 for plan in only["plans"])

    def test_numbers_of_trials_are_compared(self, capsys):
        arguments = ["--sizes", "40, 80", "--executions", "1", "--jobs", "1"]
        told = call(capsys, "tilt", "experiment", *arguments, *COARSE)
        assert "By the number of trials:" in told.out
        assert [line.split()[0] for line in told.out.splitlines()[-2:]] == ["40", "80"]

    def test_bad_input_is_one_line(self, capsys):
        told = call(capsys, "tilt", "experiment", "--sizes", "100,none")
        assert told.code == 2
        assert told.err.startswith("stochgeom: --sizes: 'none'; accepted")


class TestGrasp:
    def test_both_grippers_are_counted(self, capsys):
        told = call(capsys, "tilt", "grasp", "house", "--trials", "20", "--seed", "1")
        assert told.code == 0
        assert "one jaw slides   20 of 20" in told.out
        found = call(capsys, "tilt", "grasp", "house", "--trials", "20", "--seed", "1", "--json")
        fixed, sliding = found.document["stable"]
        assert fixed < sliding == 20

    @pytest.mark.parametrize(
        ("arguments", "message"),
        [
            (["nothing"], "nothing: neither a part of the catalogue nor a file"),
            (["house", "--friction", "-1"], "friction -1 is negative; accepted: 0 or more"),
            (["house", "--friction", "much"], "--friction: 'much' is not a number"),
            (["house", "--trials", "0"], "--trials: '0'; accepted"),
        ],
    )
    def test_bad_input_is_one_line(self, capsys, arguments, message):
        told = call(capsys, "tilt", "grasp", *arguments)
        assert (told.code, told.out) == (2, "")
        assert message in told.err
