"""Settings of the manual; `make docs` builds it, and a warning is an error."""

from __future__ import annotations

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "_extensions"), str(HERE.parent)]

project = "stochgeom"
author = "the stochgeom developers"
project_copyright = author

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "attribute_lists",
    "command_help",
    "plain_references",
    "public_names",
]
# README.md is the page of the folder for those who read the sources; the manual begins at index.md.
exclude_patterns = ["README.md", "_build"]

# Headings can be linked to, three deep.
myst_heading_anchors = 3
myst_enable_extensions = ["dollarmath"]

# Docstrings are numpydoc. Attributes go into the text of their class: a dataclass documents its
# fields there, and autodoc would describe them once more.
napoleon_google_docstring = False
napoleon_use_ivar = True
napoleon_use_rtype = False
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_preserve_defaults = True

html_theme = "furo"
html_title = "stochgeom"
html_static_path: list[str] = []
html_copy_source = False
html_show_sphinx = False
