"""The help of every command: as wide as the terminal, examples on lines of their own that run."""

from __future__ import annotations

import re
import shlex

import pytest

from stochgeom.cli.main import build_parser, main

COMMANDS = list(build_parser()._subparsers._group_actions[0].choices)


def shown(capsys, monkeypatch, *arguments):
    monkeypatch.setenv("COLUMNS", "80")
    assert main([*arguments, "--help"]) == 0
    return capsys.readouterr().out


@pytest.mark.parametrize("command", COMMANDS)
def test_lines_fit_a_terminal(capsys, monkeypatch, command):
    # A usage line may be longer: argparse breaks it between options only. So may a path.
    text = shown(capsys, monkeypatch, command).partition("\n\n")[2]
    assert [line for line in text.split("\n") if len(line) > 79 and "/" not in line] == []


@pytest.mark.parametrize("command", COMMANDS)
def test_examples_are_commands(capsys, monkeypatch, command):
    text = shown(capsys, monkeypatch, command)
    for line in re.findall(r"^  stochgeom (.*)$", text, re.MULTILINE):
        build_parser().parse_args(shlex.split(line))


@pytest.mark.parametrize(
    "example",
    [
        line
        for command in ("grasp", "plan", "verify")
        for line in re.findall(
            r"^  stochgeom (.*)$",
            build_parser(command)._subparsers._group_actions[0].choices[command].format_help(),
            re.MULTILINE,
        )
        if not re.search(r"\.(txt|json|html)\b", line)
    ],
)
def test_examples_that_need_no_file_run(capsys, example):
    assert main(shlex.split(example)) == 0
