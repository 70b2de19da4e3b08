"""The command as a whole: arguments, exit codes, and what happens when output ends early."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys

import pytest

from stochgeom.cli import plan_command
from stochgeom.cli.layout import count, table
from stochgeom.cli.main import EXIT_INTERRUPTED, join_signed_values, main
from stochgeom.cli.options import read_digits
from stochgeom.cli.version import VERSION_TEXT
from stochgeom.errors import InputError, PrecisionLimitError, VerificationError
from tests.commands import call, start
from tests.repo.sources import ROOT

TRIANGLE = b"0 0\n3 0\n0 2\n"


class TestArguments:
    @pytest.mark.parametrize("option", ["--help", "-h"])
    @pytest.mark.parametrize("command", [[], ["plan"], ["table"], ["parts"]])
    def test_help(self, capsys, command, option):
        result = call(capsys, *command, option)
        assert result.code == 0
        assert result.out.startswith("usage: " + " ".join(["stochgeom", *command]))
        assert result.err == ""

    def test_every_command_is_listed(self, capsys):
        text = call(capsys, "--help").out
        for word in ("plan ", "table ", "parts ", "--version"):
            assert f"\n    {word}" in text or f"\n  {word}" in text

    def test_version(self, capsys):
        result = call(capsys, "--version")
        assert (result.code, result.out, result.err) == (0, f"{VERSION_TEXT}\n", "")
        assert VERSION_TEXT.startswith("stochgeom ")

    def test_without_a_command(self, capsys):
        result = call(capsys)
        assert result.code == 2
        assert "COMMAND" in result.err

    def test_arguments_come_from_the_process_if_not_given(self, capsys, monkeypatch):
        monkeypatch.setattr(sys, "argv", ["stochgeom", "--version"])
        assert main() == 0
        assert capsys.readouterr().out == f"{VERSION_TEXT}\n"

    def test_options_are_not_abbreviated(self, capsys):
        assert call(capsys, "plan", "house", "--cost", "1").code == 2
        assert call(capsys, "parts", "--jso").code == 2

    @pytest.mark.parametrize(
        ("arguments", "joined"),
        [
            (["--center-of-mass", "-1,2"], ["--center-of-mass=-1,2"]),
            (["--center-of-mass", "-.5,2"], ["--center-of-mass=-.5,2"]),
            (["--cost-ratio", "-inf"], ["--cost-ratio=-inf"]),
            (["--vertices", "-1,-1 1,-1"], ["--vertices=-1,-1 1,-1"]),
            (["--vertices=0,0", "-1,2"], ["--vertices=0,0", "-1,2"]),
            (["plan", "-1,2"], ["plan", "-1,2"]),
            (["--", "-1"], ["--", "-1"]),
            (["--json", "-h"], ["--json", "-h"]),
            (["--vertices", "-"], ["--vertices", "-"]),
            (["--digits", "3"], ["--digits", "3"]),
            ([], []),
        ],
    )
    def test_signed_values(self, arguments, joined):
        assert join_signed_values(arguments) == joined

    @pytest.mark.parametrize(("text", "digits"), [("0", 0), ("12", 12), ("100000", 100_000)])
    def test_digits(self, text, digits):
        assert read_digits(text) == digits

    @pytest.mark.parametrize(
        "text", ["", "-1", "+1", "1.0", "4 ", "1_0", "abc", "100001", "9" * 9, "9" * 5000, "\u0663"]
    )
    def test_bad_digits(self, text):
        with pytest.raises(InputError) as caught:
            read_digits(text)
        assert caught.value.where == "--digits"
        assert len(str(caught.value)) < 200


class TestExitCodes:
    @pytest.mark.parametrize(
        ("error", "code"),
        [
            (InputError("no good", where="here"), 2),
            (VerificationError("does not hold"), 1),
            (PrecisionLimitError("too many bits"), 1),
        ],
    )
    def test_errors(self, capsys, monkeypatch, error, code):
        def fail(source, **_):
            raise error

        monkeypatch.setattr(plan_command, "load_part", fail)
        result = call(capsys, "plan", "house", "--json")
        assert result.code == code
        assert result.err == f"stochgeom: {error}\n"
        assert result.document == {
            "error": {
                "type": type(error).__name__,
                "message": error.message,
                "where": error.where,
            }
        }

    def test_without_json_nothing_is_on_stdout(self, capsys):
        result = call(capsys, "plan", "no such part")
        assert (result.code, result.out) == (2, "")

    def test_a_fault_of_the_program_is_not_hidden(self, monkeypatch):
        def fail(source, **_):
            raise ZeroDivisionError

        monkeypatch.setattr(plan_command, "load_part", fail)
        with pytest.raises(ZeroDivisionError):
            main(["plan", "house"])

    def test_interrupted(self, capsys, monkeypatch):
        def interrupt(source, **_):
            raise KeyboardInterrupt

        monkeypatch.setattr(plan_command, "load_part", interrupt)
        result = call(capsys, "plan", "house")
        assert (result.code, result.out) == (EXIT_INTERRUPTED, "")
        assert result.err == "stochgeom: interrupted\n"

    def test_a_long_message_is_cut_to_a_line_that_can_be_read(self, capsys):
        result = call(capsys, "plan", "x" * 200, "y" * 100_000)
        assert result.code == 2
        assert len(result.err) < 1100
        assert "[...]" in result.err
        assert result.err.endswith("see stochgeom --help\n")


def run_shell(script):
    """Run a script of the shell, which knows this Python as ``"$0"``."""
    shell = ["/bin/sh", "-c", script, sys.executable]
    return subprocess.run(shell, cwd=ROOT, capture_output=True, timeout=60, check=False)


class TestProcesses:
    """The command in processes of its own."""

    def test_a_part_of_the_catalogue(self):
        done = start("plan", "house")
        assert (done.returncode, done.stderr) == (0, b"")
        assert done.stdout.startswith(b"house: 5 vertices")

    def test_standard_input(self):
        done = start("plan", "-", "--json", input=TRIANGLE)
        assert (done.returncode, done.stderr) == (0, b"")
        vertices = json.loads(done.stdout)["part"]["vertices"]
        assert vertices == [["0", "0"], ["3", "0"], ["0", "2"]]

    def test_bad_input(self):
        done = start("plan", "-", "--json", input=b"0 0\n3 x\n")
        assert done.returncode == 2
        assert done.stderr.startswith(b"stochgeom: standard input, line 2, y: 'x' is not a number")
        assert done.stderr.count(b"\n") == 1
        assert json.loads(done.stdout)["error"]["where"] == "standard input, line 2, y"

    def test_vertices_with_and_without_equals_sign(self):
        square = "-1,-1 1,-1 1,1 -1,1"
        runs = [
            start("plan", *given, "--center-of-mass", "-1,2", "--json")
            for given in (["--vertices", square], [f"--vertices={square}"])
        ]
        assert [done.returncode for done in runs] == [0, 0]
        assert runs[0].stdout == runs[1].stdout
        assert json.loads(runs[0].stdout)["part"] == {
            "name": None,
            "vertices": [["-1", "-1"], ["1", "-1"], ["1", "1"], ["-1", "1"]],
            "center_of_mass": ["-1", "2"],
        }

    def test_the_reader_of_the_output_goes_away(self):
        """As in ``stochgeom plan house | head -1``, but surely before anything is written."""
        read_end, write_end = os.pipe()
        os.close(read_end)
        with os.fdopen(write_end, "wb") as output:
            done = start("plan", "house", "--digits", "20000", stdout=output)
        assert (done.returncode, done.stderr) == (0, b"")

    @pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no /dev/full")  # noqa: PTH110
    @pytest.mark.parametrize(
        ("arguments", "code"), [(["house"], 1), (["house", "--digits", "20000"], 1), (["x"], 2)]
    )
    def test_the_output_cannot_be_written(self, arguments, code):
        with open("/dev/full", "wb") as output:  # noqa: PTH123
            done = start("plan", *arguments, stdout=output)
        assert done.returncode == code
        assert done.stderr.count(b"\n") == 1
        assert (b"standard output: cannot be written" in done.stderr) is (code == 1)

    @pytest.mark.skipif(sys.platform == "win32", reason="closed by a shell")
    @pytest.mark.parametrize(
        ("redirection", "code", "complaint"),
        [
            ("<&-", 2, b"stochgeom: standard input: closed; accepted: "),
            (">&- </dev/null", 2, b"stochgeom: standard input: the text is empty; accepted: "),
            ("2>&- </dev/null", 2, b""),
        ],
    )
    def test_closed_streams(self, redirection, code, complaint):
        script = f'exec "$0" -m stochgeom plan - {redirection}'
        done = run_shell(script)
        assert done.returncode == code
        assert done.stdout == b""
        assert done.stderr.startswith(complaint)
        assert b"Traceback" not in done.stderr

    @pytest.mark.skipif(sys.platform == "win32", reason="closed by a shell")
    @pytest.mark.parametrize("redirection", [">&-", "2>&-"])
    def test_closed_output(self, redirection):
        script = f'exec "$0" -m stochgeom plan house {redirection}'
        done = run_shell(script)
        assert (done.returncode, done.stderr) == (0, b"")

    def test_an_output_that_knows_no_umlaut(self, tmp_path):
        path = tmp_path / "Gehäuse.txt"
        path.write_bytes(TRIANGLE)
        ascii_only = {"PYTHONIOENCODING": "ascii"}
        done = start("plan", str(path), environment=ascii_only)
        assert (done.returncode, done.stderr) == (0, b"")
        assert done.stdout.startswith(rb"Geh\xe4use: 3 vertices")
        done = start("plan", str(path), "--json", environment=ascii_only)
        assert json.loads(done.stdout)["part"]["name"] == "Gehäuse"


def test_an_output_without_a_file_may_break(monkeypatch):
    class Broken(io.StringIO):
        def write(self, text):
            raise BrokenPipeError

    monkeypatch.setattr(sys, "stdout", Broken())
    assert main(["parts"]) == 0


class TestLayout:
    def test_columns(self):
        text = table(["part", "n"], [["a", "1"], ["long name", "123"]], left=[0])
        assert text.splitlines() == ["  part         n", "  a            1", "  long name  123"]

    def test_no_blanks_at_the_end_of_a_line(self):
        assert table(["x", "y"], [["1", ""]], left=[1]).splitlines()[1] == "  1"

    @pytest.mark.parametrize(
        ("number", "noun", "text"),
        [
            (1, "squeeze", "1 squeeze"),
            (2, "squeeze", "2 squeezes"),
            (0, "step", "0 steps"),
            (1, "filter pass", "1 filter pass"),
            (3, "filter pass", "3 filter passes"),
            (2, "push", "2 pushes"),
            (2, "push-grasp", "2 push-grasps"),
        ],
    )
    def test_counts(self, number, noun, text):
        assert count(number, noun) == text
