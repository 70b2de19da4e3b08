"""``stochgeom audit``: hostile parts planned, certified, checked and searched."""

from __future__ import annotations

import argparse
import dataclasses
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from stochgeom.cli.layout import table
from stochgeom.cli.options import add_json, read_count
from stochgeom.cli.output import write, write_json
from stochgeom.cli.progress import Progress
from stochgeom.feeding.problem import TRANSFER_FUNCTIONS
from stochgeom.io.files import write_whole

if TYPE_CHECKING:  # loaded when the command runs: other commands start without them
    from stochgeom.feeding.audit import AuditRow, FamilySummary


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "audit",
        help="put the planner to the test on hostile parts",
        description="Plan hostile parts, have each certificate checked by the stand-alone checker "
        "and, where a part is small enough, compare every plan length with exhaustive search. "
        "Stops at the first disagreement with exit code 1 and writes the part to a file.",
    )
    parser.add_argument("--families", metavar="LIST", help="comma separated; default: all")
    parser.add_argument("--list", action="store_true", help="describe the families and stop")
    parser.add_argument(
        "--count", default="20", metavar="N", help="parts of each family; default 20"
    )
    parser.add_argument("--seed", default="0", metavar="S", help="the first seed; default 0")
    parser.add_argument(
        "--action",
        default="squeeze",
        choices=sorted(TRANSFER_FUNCTIONS),
        help="what the gripper does; default squeeze",
    )
    parser.add_argument("--no-search", action="store_true", help="leave out the exhaustive search")
    parser.add_argument(
        "--finding",
        default="stochgeom-finding.json",
        metavar="FILE",
        help="where a disagreement is written; default stochgeom-finding.json",
    )
    add_json(parser, "print a stochgeom/audit/1 document")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Audit, print the table, return the exit code."""
    from stochgeom.feeding.adversarial import FAMILIES
    from stochgeom.feeding.audit import audit, compare_with_search, summarize

    if arguments.list:
        rows = [[family.name, family.description] for family in FAMILIES.values()]
        write(table(["family", "what it provokes"], rows, left=[0, 1]))
        return 0
    families = None
    if arguments.families is not None:
        families = [name.strip() for name in arguments.families.split(",")]
    count, seed = read_count(arguments.count, "--count", 0), read_count(arguments.seed, "--seed", 0)
    search = None if arguments.no_search else compare_with_search
    audited = audit(families, count, seed, action=arguments.action, exhaustive=search)
    total = count * len(families or FAMILIES)
    found: list[AuditRow] = []
    with Progress("parts audited") as progress:
        summaries = list(summarize(_until_disagreement(audited, found, progress, total)))
    if arguments.json:
        write_json(_document(summaries, found))
    else:
        write(_text(summaries))
    if not found:
        return 0
    write_whole(arguments.finding, found[0].reproduction())
    if not arguments.json:
        case = found[0].case
        action = "" if arguments.action == "squeeze" else f" --action {arguments.action}"
        write(
            f"\n{case.family}, size {case.size}, seed {case.seed}: {found[0].disagreement}\n"
            f"The part is in {arguments.finding}; stochgeom plan {arguments.finding}{action} plans "
            "it."
        )
    return 1


def _until_disagreement(
    rows: Iterable[AuditRow], found: list[AuditRow], progress: Progress, total: int
) -> Iterator[AuditRow]:
    """Pass rows on up to the first disagreement, which is put into `found`."""
    for done, row in enumerate(rows, start=1):
        progress.show(done / total)
        yield row
        if row.disagreement is not None:
            found.append(row)
            return


def _text(summaries: list[FamilySummary]) -> str:
    header = ["family", "parts", "certificates", "searched", "most sides", "longest", "wrong"]
    rows = [
        [
            s.family,
            *map(str, (s.parts, s.certificates, s.searched, s.sides, s.longest)),
            str(s.disagreements),
        ]
        for s in summaries
    ]
    total = [sum(getattr(s, key) for s in summaries) for key in ("parts", "certificates")]
    wrong = sum(s.disagreements for s in summaries)
    return (
        table(header, rows, left=[0])
        + f"\n\n{total[0]} parts, {total[1]} certificates found valid, {wrong} disagreements"
    )


def _document(summaries: list[FamilySummary], found: list[AuditRow]) -> dict[str, Any]:
    return {
        "schema": "stochgeom/audit/1",
        "families": [dataclasses.asdict(summary) for summary in summaries],
        "disagreement": found[0].disagreement if found else None,
    }
