"""Entry point of the `stochgeom` command: arguments, errors, exit codes.

Exit code 0 done, 1 a check failed or no plan, 2 bad input. Errors go to stderr as one line; with
``--json`` they are also a document on stdout.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import sys
from collections.abc import Sequence
from typing import NoReturn

import stochgeom.errors as errors
from stochgeom.cli import parts_command, plan_command, table_command

EXIT_DONE, EXIT_FAILED, EXIT_BAD_INPUT, EXIT_INTERRUPTED = 0, 1, 2, 130

_COMMANDS = (plan_command, table_command, parts_command)

# Options whose value may begin with a minus: argparse would take "-1,2" for an option.
_SIGNED_VALUE = re.compile(r"-[0-9.]")


class _UsageError(Exception):
    """What argparse found wrong with the arguments."""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise _UsageError(f"{message}; see {self.prog} --help")


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command and return its exit code."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    wants_json = "--json" in arguments
    try:
        parsed = build_parser().parse_args(join_signed_values(arguments))
        code: int = parsed.run(parsed)
        sys.stdout.flush()
        return code
    except _UsageError as error:
        return _report("UsageError", str(error), None, str(error), wants_json)
    except errors.StochgeomError as error:
        failed = isinstance(error, errors.VerificationError)
        code = EXIT_FAILED if failed else EXIT_BAD_INPUT
        name = type(error).__name__
        return _report(name, error.message, error.where, str(error), wants_json, code)
    except BrokenPipeError:
        # The reader went away; keep the interpreter from complaining when it flushes.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return EXIT_DONE
    except KeyboardInterrupt:
        print("stochgeom: interrupted", file=sys.stderr)
        return EXIT_INTERRUPTED


def build_parser() -> argparse.ArgumentParser:
    """Return the parser of the whole command."""
    from stochgeom.cli.version import VERSION_TEXT

    parser = _Parser(
        prog="stochgeom",
        description="Exact planning for orienting planar parts: an outline in, a provably "
        "optimal feeding plan out.",
    )
    parser.add_argument("--version", action="version", version=VERSION_TEXT)
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for command in _COMMANDS:
        command.add_parser(commands)
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
        if _SIGNED_VALUE.match(argument) and previous.startswith("--") and "=" not in previous:
            joined[-1] = f"{previous}={argument}"
        else:
            joined.append(argument)
    return joined


def _report(
    kind: str,
    message: str,
    where: str | None,
    line: str,
    wants_json: bool,
    code: int = EXIT_BAD_INPUT,
) -> int:
    print(f"stochgeom: {' '.join(line.split())}", file=sys.stderr)
    if wants_json:
        document = {"error": {"type": kind, "message": message, "where": where}}
        print(json.dumps(document, ensure_ascii=False))
    return code


if __name__ == "__main__":
    sys.exit(main())
