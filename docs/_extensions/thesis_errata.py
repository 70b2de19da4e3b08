"""The directive ``thesis-errata``: every erratum, and the facts that settle it, computed anew.

A fact that does not hold is a warning, which ends the build of the manual.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from docutils import nodes
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective
from thesis_nodes import Inline, label_of, link_to, paragraph, section
from thesis_results import label_of as place_label
from thesis_results import places_of

from stochgeom.cli.layout import count
from stochgeom.cli.reproduce_text import heading
from stochgeom.thesis.errata_register import ERRATA, ErratumEntry
from stochgeom.thesis.facts import Fact

if TYPE_CHECKING:
    from sphinx.application import Sphinx

LOGGER = logging.getLogger(__name__)


def parts_of(item: ErratumEntry) -> nodes.field_list:
    """Return what is printed, what holds, and why."""
    erratum = item.erratum
    words = {"printed": erratum.printed, "holds": erratum.holds, "why": f"{erratum.reason}."}
    return nodes.field_list(
        "",
        *(
            nodes.field("", nodes.field_name("", name), nodes.field_body("", paragraph(text)))
            for name, text in words.items()
        ),
        classes=["erratum"],
    )


def fact_item(fact: Fact) -> nodes.list_item:
    """Return a fact: the claim, what was found, and whether it holds.

    Examples
    --------
    >>> fact_item(Fact("sides of the rectangle", "4", True)).astext()
    '✓ sides of the rectangle: 4'
    """
    found = nodes.literal(text=fact.found or "none")
    mark = "✓" if fact.holds else "✗ does not hold:"
    return nodes.list_item("", paragraph(f"{mark} {fact.claim.strip()}: ", found))


def links_of(item: ErratumEntry) -> Iterator[Inline]:
    """Yield the command that prints an erratum, and links to what it explains."""
    yield nodes.literal(text=f"stochgeom errata {item.number}")
    for place, name in enumerate(places_of(item.erratum)):
        yield ", " if place else "; explains "
        yield link_to(place_label(name), heading(name))


class ThesisErrata(SphinxDirective):
    """Show all errata."""

    def run(self) -> list[nodes.Node]:
        """Return how many there are, and a section for each."""
        sections, total = [], 0
        for item in ERRATA:
            facts = item.recompute()
            total += len(facts)
            sections.append(self._section(item, facts))
        settled = f"{count(len(ERRATA), 'erratum')}, settled by {count(total, 'fact')}."
        return [paragraph(nodes.strong("", settled)), *sections]

    def _section(self, item: ErratumEntry, facts: tuple[Fact, ...]) -> nodes.section:
        found = section(label_of(item.number), f"{item.number}. {item.erratum.where}")
        self.state.document.note_explicit_target(found)
        found += parts_of(item)
        found += paragraph(f"The facts show: {item.argument}")
        found += nodes.bullet_list("", *map(fact_item, facts), classes=["facts"])
        found += paragraph(*links_of(item))
        for fact in facts:
            if not fact.holds:
                LOGGER.warning("erratum %d: %s: %s", item.number, fact.claim, fact.found)
        return found


def setup(app: Sphinx) -> dict[str, Any]:
    """Make the directive known to Sphinx."""
    app.add_directive("thesis-errata", ThesisErrata)
    return {"version": "1", "parallel_read_safe": True}
