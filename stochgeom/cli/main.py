"""Entry point of the `stochgeom` command: arguments, errors, exit codes.

Exit code 0 done, 1 a check failed or no plan, 2 bad input. Errors go to stderr as one line; with
``--json`` they are also a document on stdout.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import re
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import Any, NoReturn

import stochgeom.errors as errors
from stochgeom.cli.help_text import HelpFormatter
from stochgeom.cli.output import write_json
from stochgeom.io.rings import showable

EXIT_DONE, EXIT_FAILED, EXIT_BAD_INPUT, EXIT_INTERRUPTED = 0, 1, 2, 130

_COMMANDS = {
    "plan": lambda: import_module("stochgeom.cli.plan_command"),
    "grasp": lambda: import_module("stochgeom.cli.grasp_command"),
    "decide": lambda: import_module("stochgeom.cli.decide_command"),
    "sense": lambda: import_module("stochgeom.cli.sense_command"),
    "report": lambda: import_module("stochgeom.cli.report_command"),
    "verify": lambda: import_module("stochgeom.cli.verify_command"),
    "audit": lambda: import_module("stochgeom.cli.audit_command"),
    "table": lambda: import_module("stochgeom.cli.table_command"),
    "reproduce": lambda: import_module("stochgeom.cli.reproduce_command"),
    "errata": lambda: import_module("stochgeom.cli.errata_command"),
    "parts": lambda: import_module("stochgeom.cli.parts_command"),
    "tilt": lambda: import_module("stochgeom.cli.tilt_command"),
}
"""Each in a module of its own, loaded only if it is the one called: a start is half imports."""

# Options whose value may begin with a minus: argparse would take "-1,2" for an option.
_SIGNED_VALUE = re.compile(r"-(?:[0-9.]|inf|nan)", re.IGNORECASE)

_LONGEST_LINE = 1000  # a path or a list of vertices may be longer

_ABOUT_ARGUMENT = re.compile(r"argument ([^:]+): (.*)", re.DOTALL)


class UsageError(errors.InputError):
    """What argparse found wrong with the arguments."""


class _Parser(argparse.ArgumentParser):
    def __init__(self, **settings: Any) -> None:
        # An abbreviated option would change its meaning once another begins alike.
        super().__init__(**{"formatter_class": HelpFormatter} | settings, allow_abbrev=False)

    def error(self, message: str) -> NoReturn:
        about = _ABOUT_ARGUMENT.fullmatch(message)
        where, what = about.groups() if about else (None, message)
        raise UsageError(f"{what}; see {self.prog} --help", where=where)


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command and return its exit code."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    try:
        code = _run(arguments)
        if sys.stdout is not None:  # None: closed by whoever started the program
            sys.stdout.flush()
        return code
    except BrokenPipeError:  # the reader has seen enough
        _abandon_output()
        return EXIT_DONE
    except OSError as error:  # what is read has its own errors, so this is the output
        _abandon_output()
        _complain(f"standard output: cannot be written: {error.strerror or error}")
        return EXIT_FAILED
    except KeyboardInterrupt:
        _complain("interrupted")
        return EXIT_INTERRUPTED


def _run(arguments: Sequence[str]) -> int:
    try:
        parser = build_parser(arguments[0] if arguments else None)
        parsed = parser.parse_args(join_signed_values(arguments))
        code: int = parsed.run(parsed)
        return code
    except SystemExit as stop:  # argparse has printed the help or the version
        return int(stop.code or EXIT_DONE)
    except errors.StochgeomError as error:
        return _report(error, wants_json="--json" in arguments)


def build_parser(called: str | None = None) -> argparse.ArgumentParser:
    """Return the parser of the command called; of all of them if it is none of them."""
    from stochgeom.cli.version import VERSION_TEXT

    parser = _Parser(
        prog="stochgeom",
        description="Exact planning for orienting planar parts: an outline in, a provably "
        "optimal feeding plan out.",
    )
    parser.add_argument("--version", action="version", version=VERSION_TEXT)
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    loaded = [called] if called in _COMMANDS else [] if called == "--version" else _COMMANDS
    for name in loaded:
        _COMMANDS[name]().add_parser(commands)
    return parser


def join_signed_values(arguments: Sequence[str]) -> list[str]:
    """Write ``--option -1,2`` as ``--option=-1,2``, which argparse reads as meant.

    Examples
    --------
    >>> join_signed_values(["plan", "--center-of-mass", "-1,2", "--json"])
    ['plan', '--center-of-mass=-1,2', '--json']
    """
    joined: list[str] = []
    for argument in arguments:
        previous = joined[-1] if joined else ""
        is_option = previous.startswith("--") and previous != "--" and "=" not in previous
        if is_option and _SIGNED_VALUE.match(argument):
            joined[-1] = f"{previous}={argument}"
        else:
            joined.append(argument)
    return joined


def _report(error: errors.StochgeomError, *, wants_json: bool) -> int:
    _complain(str(error))
    if wants_json:
        kind = type(error).__name__
        detail = {"type": kind, "message": error.message, "where": error.where}
        write_json({"error": detail}, indent=None)
    asked_too_much = isinstance(error, errors.InputError | errors.MissingExtraError)
    return EXIT_BAD_INPUT if asked_too_much else EXIT_FAILED


def _complain(text: str) -> None:
    """Print one line on stderr, without characters that a terminal would obey."""
    line = showable(" ".join(text.split()))
    if len(line) > _LONGEST_LINE:
        half = _LONGEST_LINE // 2
        line = f"{line[:half]} [...] {line[-half:]}"
    if sys.stderr is not None:  # print would take None for stdout
        print(f"stochgeom: {line}", file=sys.stderr)


def _abandon_output() -> None:
    """Keep the interpreter from flushing, when it ends, what could not be written."""
    with contextlib.suppress(OSError):  # a stand-in for stdout may have no file
        descriptor = sys.stdout.fileno()
        os.dup2(os.open(os.devnull, os.O_WRONLY), descriptor)


if __name__ == "__main__":
    sys.exit(main())
