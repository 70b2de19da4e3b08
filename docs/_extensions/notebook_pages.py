"""The notebooks as pages: copied among the sources of the manual before these are read.

Sphinx reads what lies below ``docs/`` only. Git does not know the copies, which are made anew at
each build. Links change as the place does; everything else stays. `myst_nb` executes them, in
kernels that know nothing of the profile of whoever builds the manual.
"""

from __future__ import annotations

import json
import logging
import os
import re
import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sphinx.addnodes import pending_xref

if TYPE_CHECKING:
    from docutils import nodes
    from sphinx.application import Sphinx

FOLDER = "notebooks"
"""Below the root of the project, and below the sources of the manual."""

LIST = "../howto/notebooks.md"
"""The page that lists the notebooks, as README.md does beside them."""

_LINK = re.compile(r"(?<=\]\()[^)#:\s]+(?=[)#])")


def moved_links(text: str) -> str:
    """Return Markdown of a notebook with links from its copy, one folder further down.

    Examples
    --------
    >>> moved_links("[a](../docs/notation.md#b) [c](../README.md) [d](07-sensors.ipynb)")
    '[a](../notation.md#b) [c](../../README.md) [d](07-sensors.ipynb)'
    >>> moved_links("[all](README.md) [trials](data/tilt-sizes.json) [far](https://example.org/)")
    '[all](../howto/notebooks.md) [trials](data/tilt-sizes.json) [far](https://example.org/)'
    """
    return _LINK.sub(lambda link: _moved(link[0]), text)


def _moved(link: str) -> str:
    if link == "README.md":
        return LIST
    if link.startswith("../docs/"):
        return "../" + link.removeprefix("../docs/")
    return f"../{link}" if link.startswith("../") else link


def copied_notebook(source: str) -> str:
    """Return the text of a notebook as it is copied: links moved in its Markdown cells.

    Examples
    --------
    >>> cell = {"cell_type": "markdown", "source": ["[a](../docs/a.md)"]}
    >>> copied_notebook(json.dumps({"cells": [cell]}))
    '{"cells": [{"cell_type": "markdown", "source": ["[a](../a.md)"]}]}'
    """
    notebook = json.loads(source)
    for cell in notebook["cells"]:
        if cell["cell_type"] == "markdown":
            # A cell's source is a text, or a list of its lines.
            lines = cell["source"]
            moved = moved_links if isinstance(lines, str) else lambda ls: [*map(moved_links, ls)]
            cell["source"] = moved(lines)
    return json.dumps(notebook)


def copy_notebooks(app: Sphinx) -> None:
    """Copy every notebook, and the folder of data beside them, among the sources."""
    origin, target = Path(app.srcdir).parent / FOLDER, Path(app.srcdir) / FOLDER
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir()
    for path in sorted(origin.glob("*.ipynb")):
        text = copied_notebook(path.read_text(encoding="utf-8"))
        (target / path.name).write_text(text, encoding="utf-8")
    shutil.copytree(origin / "data", target / "data")


def lead_to_pages(app: Sphinx, doctree: nodes.document) -> None:
    """Let links of other pages to a notebook, which lead out of ``docs/``, lead to its page."""
    outside = f"{(Path(app.srcdir).parent / FOLDER).as_posix()}/"
    for reference in doctree.findall(pending_xref):
        target = reference["reftarget"]
        page = f"{FOLDER}/{target.removeprefix(outside)}"
        if target.startswith(outside) and page in app.env.found_docs:
            reference["reftarget"] = page


def set_up_kernels(app: Sphinx) -> None:
    """Give the kernels a profile of their own: no start-up files, no word unless it is an error.

    They import the package beside the manual, as the reference does, wherever another is installed.
    Each kernel would tell that it listens to this machine without encryption, and its client that
    a notebook is executed.
    """
    profile = Path(app.doctreedir) / "ipython" / "profile_default"
    profile.mkdir(parents=True, exist_ok=True)
    quiet = json.dumps({"IPKernelApp": {"log_level": logging.ERROR}})
    (profile / "ipython_kernel_config.json").write_text(quiet, encoding="utf-8")
    os.environ["IPYTHONDIR"] = str(profile.parent)
    known = os.environ.get("PYTHONPATH")
    os.environ["PYTHONPATH"] = os.pathsep.join(
        [str(Path(app.srcdir).parent), *filter(None, [known])]
    )
    logging.getLogger("traitlets").setLevel(logging.WARNING)


def setup(app: Sphinx) -> dict[str, Any]:
    """Copy before Sphinx looks for its sources."""
    app.connect("builder-inited", copy_notebooks)
    app.connect("builder-inited", set_up_kernels)
    # Before references that lead nowhere become plain text, at 500.
    app.connect("doctree-read", lead_to_pages, priority=400)
    return {"version": "1", "parallel_read_safe": True}
