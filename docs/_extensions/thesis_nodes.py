"""What the pages of the thesis are put together from: paragraphs, tables, links to errata."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache

from docutils import nodes
from sphinx.addnodes import pending_xref

from stochgeom.thesis.errata import Erratum
from stochgeom.thesis.errata_register import ERRATA

Inline = nodes.Node | str


def paragraph(*children: Inline, classes: Sequence[str] = ()) -> nodes.paragraph:
    """Return a paragraph of texts and inline nodes.

    Examples
    --------
    >>> paragraph("see ", nodes.literal(text="4.1")).astext()
    'see 4.1'
    """
    node = nodes.paragraph("", "", *map(_inline, children))
    node["classes"] += classes
    return node


def _inline(child: Inline) -> nodes.Node:
    return nodes.Text(child) if isinstance(child, str) else child


def link_to(label: str, text: str) -> pending_xref:
    """Return a link to a labelled section of any page."""
    return pending_xref(
        "",
        nodes.inline("", text),
        refdomain="std",
        reftype="ref",
        reftarget=label,
        refexplicit=True,
        refwarn=True,
    )


def section(label: str, title: str) -> nodes.section:
    """Return an empty section with a label that `link_to` takes, once it is noted as a target."""
    return nodes.section("", nodes.title("", title), ids=[nodes.make_id(label)], names=[label])


def table(
    header: Sequence[str], rows: Iterable[Sequence[nodes.entry]], *, classes: Sequence[str] = ()
) -> nodes.table:
    """Return a table of entries under a row of words."""
    group = nodes.tgroup(cols=len(header))
    group += [nodes.colspec(colwidth=1) for _ in header]
    words = [nodes.entry("", paragraph(word)) for word in header]
    group += nodes.thead("", nodes.row("", *words))
    group += nodes.tbody("", *(nodes.row("", *row) for row in rows))
    return nodes.table("", group, classes=["thesis", *classes])


def entry(*children: Inline, classes: Sequence[str] = ()) -> nodes.entry:
    """Return an entry of a table."""
    return nodes.entry("", paragraph(*children), classes=list(classes))


@cache
def _numbers() -> dict[Erratum, int]:
    return {item.erratum: item.number for item in ERRATA}


def number_of(erratum: Erratum) -> int | None:
    """Return the number of an erratum in the register, None if it is not there."""
    return _numbers().get(erratum)


def label_of(number: int) -> str:
    """Return the label of an erratum's section.

    Examples
    --------
    >>> label_of(3)
    'thesis-erratum-3'
    """
    return f"thesis-erratum-{number}"


def erratum_link(erratum: Erratum) -> Inline:
    """Return the link to an erratum, or its place if the register does not have it."""
    number = number_of(erratum)
    return erratum.where if number is None else link_to(label_of(number), f"erratum {number}")
