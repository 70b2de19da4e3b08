"""``stochgeom errata``: where the source is wrong, and the computations that settle it."""

from __future__ import annotations

import argparse
from textwrap import wrap
from typing import TYPE_CHECKING, Any, Final

from stochgeom.cli.layout import count
from stochgeom.cli.options import add_json
from stochgeom.cli.output import write, write_json

if TYPE_CHECKING:
    from stochgeom.thesis.errata_register import ErratumEntry
    from stochgeom.thesis.facts import Fact, Facts

WIDTH: Final = 96


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "errata",
        help="list where the source is wrong, and recompute it",
        description="List where Goldberg (1990) does not agree with itself or with its own "
        "definitions. With a number or a word, print the computation as well that settles it.",
    )
    parser.add_argument(
        "query", nargs="?", metavar="NUMBER|WORD", help="which: a number, or a text in it"
    )
    parser.add_argument(
        "--check", action="store_true", help="recompute; exit code 1 if something does not hold"
    )
    add_json(parser, "print a JSON document")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Print errata; exit code 1 if a recomputation fails."""
    from stochgeom.thesis.errata_register import find_errata

    entries = find_errata(arguments.query)
    settled = arguments.check or arguments.json or arguments.query is not None
    facts = [entry.recompute() if settled else () for entry in entries]
    pairs = list(zip(entries, facts, strict=True))
    if arguments.json:
        write_json(errata_document(pairs))
    elif arguments.check:
        write(check_text(pairs))
    else:
        write(errata_text(pairs))
    return 0 if all(fact.holds for found in facts for fact in found) else 1


def errata_text(pairs: list[tuple[ErratumEntry, Facts]]) -> str:
    """Return errata for people, with what was recomputed where there are facts."""
    blocks = ["\n".join(_lines(entry, facts)) for entry, facts in pairs]
    if not any(facts for _, facts in pairs):
        blocks.append(
            f"{count(len(pairs), 'erratum')}; stochgeom errata NUMBER prints the computation that "
            "settles one,\nstochgeom errata --check runs all of them."
        )
    return "\n\n".join(blocks)


def _lines(entry: ErratumEntry, facts: Facts) -> list[str]:
    erratum = entry.erratum
    lines = [f"{entry.number}. {erratum.where}"]
    for label, text in (
        ("printed", erratum.printed),
        ("holds", erratum.holds),
        ("why", f"{erratum.reason}."),
    ):
        lines += wrap(text, WIDTH, initial_indent=f"   {label:<9}", subsequent_indent=" " * 12)
    if facts:
        lines.append(f"   recomputed by {entry.recomputed_by}")
        lines += [line for fact in facts for line in _fact(fact)]
    return lines


def _fact(fact: Fact) -> list[str]:
    mark = "ok    " if fact.holds else "FAILED"
    text = f"{fact.claim.strip()}: {fact.found or 'none'}"
    return wrap(text, WIDTH, initial_indent=f"     {mark} ", subsequent_indent=" " * 12)


def check_text(pairs: list[tuple[ErratumEntry, Facts]]) -> str:
    """Return a line for each erratum, the facts that do not hold, and the sum of it."""
    lines, wrong, total = [], 0, 0
    for entry, facts in pairs:
        bad = [fact for fact in facts if not fact.holds]
        wrong, total = wrong + bool(bad), total + len(facts)
        mark = "FAILED" if bad else "ok    "
        lines.append(f"  {mark} {entry.number:>3}  {entry.erratum.where}: {entry.argument}")
        lines += [line for fact in bad for line in _fact(fact)]
    verdict = f"{wrong} of them FAILED" if wrong else "all hold"
    return "\n".join(
        [*lines, "", f"{count(len(pairs), 'erratum')} by {count(total, 'fact')}: {verdict}"]
    )


def errata_document(pairs: list[tuple[ErratumEntry, Facts]]) -> dict[str, Any]:
    """Return errata and the facts that settle them for machines."""
    return {
        "schema": "stochgeom/errata/1",
        "errata": [
            {
                "number": entry.number,
                "where": entry.erratum.where,
                "printed": entry.erratum.printed,
                "holds": entry.erratum.holds,
                "reason": entry.erratum.reason,
                "recomputed_by": entry.recomputed_by,
                "facts": [
                    {"claim": fact.claim.strip(), "found": fact.found, "holds": fact.holds}
                    for fact in facts
                ],
            }
            for entry, facts in pairs
        ],
    }
