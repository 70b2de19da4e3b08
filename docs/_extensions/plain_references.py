"""References that lead nowhere for a reader of the manual become plain text; code ends at its end.

References of two kinds. Types in docstrings are words: "rational" means a rational number, and not
one of the attributes of that name, which Sphinx would find. And pages link to files of the sources
that are no pages of the manual, such as the map of the tests.

An example ends with an empty line in the Markdown, or pytest would take the fence for its output;
the reader need not see it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from docutils import nodes
from sphinx.addnodes import pending_xref

if TYPE_CHECKING:
    from sphinx.application import Sphinx


def is_word(reference: pending_xref) -> bool:
    """Return whether this is a word of a docstring's type: no class, no dotted name."""
    target = reference["reftarget"]
    by_type = reference.get("refdomain") == "py" and reference.get("reftype") in {"class", "obj"}
    return by_type and target.islower() and "." not in target


def is_outside(reference: pending_xref, pages: set[str]) -> bool:
    """Return whether this is a link to a document that is no page of the manual."""
    return reference.get("refdomain") == "doc" and reference["reftarget"] not in pages


def make_plain(app: Sphinx, doctree: nodes.document) -> None:
    """Replace references of both kinds by their text, and take empty lines off the ends of code."""
    pages = app.env.found_docs
    for reference in list(doctree.findall(pending_xref)):
        if is_word(reference) or is_outside(reference, pages):
            reference.replace_self(nodes.inline("", "", *reference.children))
    for block in doctree.findall(nodes.literal_block):
        text = block.astext().rstrip("\n")
        # Sphinx paints a block only if its text and its source are the same.
        block.rawsource, block.children = text, []
        block += nodes.Text(text)


def setup(app: Sphinx) -> dict[str, Any]:
    """Look at every page once it is read."""
    app.connect("doctree-read", make_plain)
    return {"version": "1", "parallel_read_safe": True}
