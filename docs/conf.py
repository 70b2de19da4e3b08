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
    "myst_nb",  # which reads Markdown through myst_parser
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "attribute_lists",
    "command_help",
    "notebook_pages",
    "plain_references",
    "public_names",
    "thesis_chapters",
    "thesis_errata",
]
# README.md is the page of the folder for those who read the sources; the manual begins at index.md.
exclude_patterns = ["README.md", "_build"]

# Headings can be linked to, three deep.
myst_heading_anchors = 3
myst_enable_extensions = ["dollarmath"]

# Notebooks are executed at each build, none is taken from a cache: what they show depends on the
# whole package. One that fails ends the build. Pages in Markdown are not executed here.
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 300
nb_merge_streams = True

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
html_static_path = ["_static"]
html_css_files = ["manual.css"]
html_copy_source = False
html_show_sphinx = False
