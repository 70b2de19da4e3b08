"""``stochgeom verify``: check a certificate, or somebody's list of angles."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from stochgeom.cli.output import write, write_json
from stochgeom.errors import FormatError, InputError, ReadError
from stochgeom.feeding import certificate_checker as checker

_EPILOG = """\
The checker is one file that imports nothing of the package; it can be run by itself:

  python certificate_checker.py plan.json

It is {path}
"""


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "verify",
        help="check a plan",
        description="Check a certificate written by `stochgeom plan --certificate`: every claim "
        "is computed anew, and the first that fails is named. Exit code 1 if one does.",
        epilog=_EPILOG.format(path=checker.__file__),
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("file", nargs="?", metavar="FILE", help="a certificate")
    parser.add_argument("--json", action="store_true", help="print a stochgeom/verdict/1 document")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Check, print the verdict, return the exit code."""
    if arguments.file is None:
        raise InputError("no FILE given; accepted: a certificate")
    return _verify_certificate(arguments.file, arguments.json)


def _verify_certificate(path: str, wants_json: bool) -> int:
    try:
        document = checker.load(_read(path))
        checker.check(document)
    except checker.NoCertificateError as error:
        raise FormatError(
            f"no certificate: {error}; accepted: what `stochgeom plan --certificate` writes",
            where=path,
        ) from error
    except checker.InvalidClaimError as error:
        if wants_json:
            claim, message = error.args
            verdict = {"valid": False, "claim": claim, "message": message}
            write_json({"schema": "stochgeom/verdict/1", **verdict})
        else:
            write(f"invalid: {error}")
        return 1
    if wants_json:
        write_json({"schema": "stochgeom/verdict/1", "valid": True, "claim": None, "message": ""})
    else:
        write(f"valid: {_summary(document)}")
    return 0


def _summary(document: dict[str, Any]) -> str:
    """Say what the certificate has proved; the checker has found every field to be right."""
    plan, name = document["plan"], document["part"]["name"] or "this part"
    steps = f"{plan['steps']} squeeze" + ("" if plan["steps"] == 1 else "s")
    claims = []
    if plan["optimal"]:
        claims.append(f"of least expected cost at a cost ratio of {document['cost_ratio']}")
    if plan["orients_up_to_symmetry"]:
        claims.append("the fewest that orient it up to symmetry")
    return f"{steps} for {name}" + (f": {', and '.join(claims)}" if claims else "")


def _read(path: str) -> bytes:
    """Return the content of a file, of at most a byte more than the checker takes."""
    try:
        with Path(path).open("rb") as file:
            return file.read(checker.MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise ReadError(
            f"cannot be read: {reason}; accepted: a readable certificate", where=path
        ) from error
