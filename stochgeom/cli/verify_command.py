"""``stochgeom verify``: check a certificate, or somebody's list of angles."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from stochgeom.cli.certified import scope
from stochgeom.cli.options import add_digits, add_json, read_digits
from stochgeom.cli.output import write, write_json
from stochgeom.errors import FormatError, InputError, ReadError, VerificationError
from stochgeom.feeding import certificate_checker as checker
from stochgeom.feeding import field_certificate_checker as any_checker
from stochgeom.feeding.problem import TRANSFER_FUNCTIONS
from stochgeom.io.embedded import CERTIFICATE, find_block, is_page
from stochgeom.io.load import load_part

_EPILOG = """\
examples:

  stochgeom verify plan.json
  stochgeom verify report.html
  stochgeom verify --part 4gon --angles "0, 71, 35, 8" --cumulative
  stochgeom verify --part 4gon --angles "0, 71, -36, -27" --claims probability=1/2
  stochgeom verify --part house --action push-grasp --angles "0, 72, 207"
  stochgeom verify --part rectangle --angles "0, -45" --vertex-error 1/10

The checker is one file that imports nothing of the package; it can be run by itself:

  python certificate_checker.py plan.json

It is {path}.

For parts over a field, such as regular polygons, it takes {field_checker} beside it.
"""

_ABOUT_PAGES = """\
Checked is the certificate inside the page, not what the page shows: text and pictures may have been
changed beside it. `stochgeom report` draws the page anew, with the same bytes."""

# Options that say nothing about a certificate.
_OF_ANGLES = (
    "part",
    "angles",
    "action",
    "center-of-mass",
    "vertex-error",
    "cumulative",
    "cost-ratio",
    "claims",
)


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "verify",
        help="check a plan",
        description="Check a certificate written by `stochgeom plan --certificate`: every claim "
        "is computed anew, and the first that fails is named. Or run a list of angles on a part "
        "and report what it does. Exit code 1 if a claim fails, or is not proven for parts with "
        "the vertex error.",
        epilog=_EPILOG.format(path=checker.__file__, field_checker=Path(any_checker.__file__).name),
    )
    parser.add_argument("file", nargs="?", metavar="FILE", help="a certificate, or a report")
    parser.add_argument("--part", metavar="SOURCE", help="what the angles are for")
    parser.add_argument(
        "--angles",
        metavar="LIST",
        help='degrees or directions, such as "0, 71, 35.5, 3:2", each relative to the last pose',
    )
    parser.add_argument(
        "--action",
        choices=sorted(TRANSFER_FUNCTIONS),
        help="what the gripper does; default squeeze",
    )
    parser.add_argument("--center-of-mass", metavar="X,Y", help="default: uniform centroid")
    parser.add_argument(
        "--vertex-error",
        metavar="E",
        help="also try to prove it for every part with vertices within E of the given ones",
    )
    parser.add_argument(
        "--cumulative", action="store_true", help="the angles are poses of the gripper"
    )
    parser.add_argument("--cost-ratio", metavar="C", help="default 1")
    parser.add_argument(
        "--claims", metavar="CLAIM", help="up-to-symmetry, or probability=P: at least P"
    )
    add_digits(parser)
    add_json(parser, "print a verdict or report as JSON")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Check, print the verdict, return the exit code."""
    digits = read_digits(arguments.digits)
    if arguments.file is None:
        if arguments.part is None or arguments.angles is None:
            raise InputError("accepted: FILE alone, or --part and --angles together")
        return _verify_angles(arguments, digits)
    for option in _OF_ANGLES:
        if getattr(arguments, option.replace("-", "_")):
            raise InputError(
                f"--{option} is about angles, and a certificate says all of its plan; "
                "accepted: FILE alone, or --part and --angles together"
            )
    return _verify_certificate(arguments.file, arguments.json)


def _verify_angles(arguments: argparse.Namespace, digits: int) -> int:
    from stochgeom.cli.report_text import report_document, report_text
    from stochgeom.feeding.verification import check_claim, verify_plan

    part = load_part(arguments.part, center_of_mass=arguments.center_of_mass)
    report = verify_plan(
        part,
        arguments.angles,
        arguments.cost_ratio or 1,
        cumulative=arguments.cumulative,
        action=arguments.action or "squeeze",
        vertex_error=arguments.vertex_error,
    )
    failure = None
    if arguments.claims is not None:
        try:
            check_claim(report, arguments.claims)
        except VerificationError as error:
            failure = error
    if arguments.json:
        document = report_document(report, digits)
        if arguments.claims is not None:
            document["claim"] = {"text": arguments.claims, "holds": failure is None}
        write_json(document)
    else:
        write(report_text(report, part.name or "this part", digits))
        if arguments.claims is not None:
            verdict = "holds" if failure is None else f"fails, {failure.message}"
            write(f"\nthe claim {arguments.claims} {verdict}")
    proven = report.part_errors is None or report.part_errors.proven
    return 0 if failure is None and proven else 1


def _verify_certificate(path: str, wants_json: bool) -> int:
    content = _read(path)
    try:
        document = any_checker.load(_certificate_of(content, path))
        any_checker.check(document)
    except checker.NoCertificateError as error:
        begin = ", as" if "; accepted: " in str(error) else "; accepted: what"
        writer = f"{begin} `stochgeom plan --certificate` writes"
        raise FormatError(f"no certificate: {error}{writer}", where=path) from error
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
        write("\n".join([f"valid: {_summary(document)}", *scope(document)]))
        if is_page(content):
            write(_ABOUT_PAGES)
    return 0


def _summary(document: dict[str, Any]) -> str:
    """Say what the certificate has proved; the checker has found every field to be right."""
    plan, part = document["plan"], document["part"]
    name = part["name"] or "this part"
    if "center_of_mass" in part:  # given, not proved
        name += f", its centre of mass at ({', '.join(part['center_of_mass'])})"
    steps = f"{plan['steps']} {document['action']}" + ("" if plan["steps"] == 1 else "s")
    claims = []
    if plan["optimal"]:
        claims.append(f"of least expected cost at a cost ratio of {document['cost_ratio']}")
    if plan["orients_up_to_symmetry"]:
        claims.append("the fewest that orient it up to symmetry")
    return f"{steps} for {name}" + (f": {', and '.join(claims)}" if claims else "")


def _certificate_of(content: bytes, path: str) -> bytes:
    """Return the content of a certificate, or the certificate that a report carries."""
    if not is_page(content):
        return content
    found = find_block(content, CERTIFICATE)
    if found is None:
        raise FormatError(
            "this page carries no certificate; accepted: what `stochgeom report` writes for a "
            "plan that can be certified",
            where=path,
        )
    return found


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
