"""What is imported is declared, and what is optional is imported only where it is used."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib

import pytest

from tests.repo.sources import MODULES, PACKAGE, ROOT, dotted_name, imports_of, relative

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
IMPORT_NAMES = {"python-flint": "flint"}
"""Distributions that are imported under another name."""

COPIED_BESIDE = {"stochgeom.feeding.field_certificate_checker": "certificate_checker"}
"""Modules that are copied and run without the package, with another one beside them."""

REFUSED = ("geojson", "sympy.geometry")
"""Not exact, whatever their documentation says: they may decide nothing."""


def import_names(requirements: list[str]) -> set[str]:
    """Return the names under which the required distributions are imported."""
    names = [re.match(r"[A-Za-z0-9-]+", requirement)[0] for requirement in requirements]
    return {IMPORT_NAMES.get(name, name) for name in names}


CORE = import_names(PROJECT["dependencies"])
EXTRAS = import_names(
    [item for group in PROJECT["optional-dependencies"].values() for item in group]
) - {"stochgeom"}


def violations(source: str, module: str) -> list[str]:
    """Return the undeclared, refused and too eager imports of one module."""
    found = []
    for item in imports_of(source, module):
        top = item.target.split(".")[0]
        if item.target.startswith(REFUSED):
            found.append(f"line {item.line}: {item.target} is refused")
        elif top in EXTRAS and not item.deferred:
            found.append(f"line {item.line}: {top} is optional; import it inside a function")
        elif top == COPIED_BESIDE.get(module):
            continue
        elif top not in CORE | EXTRAS | sys.stdlib_module_names | {"stochgeom", "?", ""}:
            found.append(f"line {item.line}: {top} is not declared in pyproject.toml")
    return found


@pytest.mark.parametrize("path", MODULES, ids=relative)
def test_imports_are_declared(path):
    assert violations(path.read_text(encoding="utf-8"), dotted_name(path)) == []


def test_an_extra_brings_only_what_is_imported():
    imported = {
        item.target.split(".")[0]
        for path in MODULES
        for item in imports_of(path.read_text(encoding="utf-8"), dotted_name(path))
    }
    assert imported >= EXTRAS


@pytest.mark.parametrize(
    "source",
    [
        "import requests",
        "import matplotlib.pyplot as plt",
        "def draw():\n    import sympy.geometry",
        "from sympy.geometry import Polygon",
    ],
)
def test_the_checker_finds_a_bad_import(source):
    assert len(violations(source, "stochgeom.plotting.pictures")) == 1


def test_the_checker_accepts_an_extra_where_it_is_used():
    source = "import numpy\nfrom flint import arb\ndef draw():\n    import matplotlib.pyplot\n"
    source += "if TYPE_CHECKING:\n    from matplotlib.figure import Figure"
    assert violations(source, "stochgeom.plotting.pictures") == []


def loaded_by(statement: str) -> set[str]:
    """Return the top-level modules that a fresh interpreter holds after one statement."""
    code = f"import sys; sys.path.insert(0, {str(ROOT)!r}); {statement}; print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return {name.split(".")[0] for name in run.stdout.split()}


def test_the_bare_import_is_light():
    heavy = {"sympy", "flint"} | EXTRAS
    loaded = loaded_by("import stochgeom")
    assert "stochgeom" in loaded
    assert loaded & heavy == set()


def test_types_are_shipped():
    assert (PACKAGE / "py.typed").is_file()
