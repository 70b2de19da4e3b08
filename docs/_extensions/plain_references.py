"""References that lead nowhere for a reader of the manual become plain text.

Two kinds. Types in docstrings are words: "rational" means a rational number, and not one of the
attributes of that name, which Sphinx would find. And pages link to files of the sources that are
no pages of the manual, such as the map of the tests.
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
    """Replace the references of both kinds by their text."""
    pages = app.env.found_docs
    for reference in list(doctree.findall(pending_xref)):
        if is_word(reference) or is_outside(reference, pages):
            reference.replace_self(nodes.inline("", "", *reference.children))


def setup(app: Sphinx) -> dict[str, Any]:
    """Look at every page once it is read."""
    app.connect("doctree-read", make_plain)
    return {"version": "1", "parallel_read_safe": True}
