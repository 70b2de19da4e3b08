"""The directive ``public-names``: the public names of one package, each with its docstring.

It reads the list of the facade, so that a new name is in the manual without being written there.
"""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any, ClassVar

from docutils.statemachine import StringList
from sphinx.util.docutils import SphinxDirective

import stochgeom

if TYPE_CHECKING:
    from docutils.nodes import Node
    from sphinx.application import Sphinx


def names_of(package: str) -> list[str]:
    """Return the public names that live in a package, sorted."""
    inside = (package, f"{package}.")
    return sorted(
        name
        for name, home in stochgeom._HOMES.items()
        if home == inside[0] or home.startswith(inside[1])
    )


def directive_of(name: str) -> list[str]:
    """Return the lines of reStructuredText that document a public name."""
    value = getattr(stochgeom, name)
    if inspect.isclass(value):
        # Bases without a name of their own in the manual are no concern of the reader.
        known = all(b.__name__ in stochgeom.__all__ for b in value.__bases__)
        bases = ["   :show-inheritance:"] if known else []
        return [f".. autoclass:: stochgeom.{name}", "   :members:", *bases, ""]
    if callable(value):
        return [f".. autofunction:: stochgeom.{name}", ""]
    # The docstring of a constant stands under it, in the module where it is made.
    home = stochgeom._HOMES[name]
    return [f".. autodata:: stochgeom.{home}.{name}", "   :no-value:", ""]


class PublicNames(SphinxDirective):
    """Document the public names of the package that is the argument."""

    required_arguments = 1
    has_content = False
    option_spec: ClassVar[dict[str, Any]] = {}

    def run(self) -> list[Node]:
        """Return the nodes of all names."""
        names = names_of(self.arguments[0])
        if not names:
            raise self.error(f"no public name lives in {self.arguments[0]!r}")
        lines = [line for name in names for line in directive_of(name)]
        return self.parse_content_to_nodes_of(lines)

    def parse_content_to_nodes_of(self, lines: list[str]) -> list[Node]:
        """Return the nodes of lines of reStructuredText."""
        self.content = StringList(lines, source="public-names")
        return self.parse_content_to_nodes(allow_section_headings=True)


def setup(app: Sphinx) -> dict[str, Any]:
    """Make the directive known to Sphinx."""
    app.add_directive("public-names", PublicNames)
    return {"version": "1", "parallel_read_safe": True}
