"""The import graph of the package is the list below, read downwards.

A package may import from the ones above it. feeding, grasping, tilting and sensing are siblings:
none imports another, but sensing may import feeding. The facade, `stochgeom` itself, imports from
all and is imported by none.
"""

from __future__ import annotations

from graphlib import CycleError, TopologicalSorter

import pytest

from tests.repo.sources import MODULES, PACKAGE, dotted_name, imports_of, relative

LAYERS = (
    "errors",
    "arguments",
    "display",
    "exact",
    "geometry",
    "transfer",
    "decision",
    "feeding",
    "grasping",
    "tilting",
    "sensing",
    "thesis",
    "io",
    "plotting",
    "cli",
    "__main__",
)
SIBLINGS = frozenset({"feeding", "grasping", "tilting", "sensing"})
ALLOWED_AMONG_SIBLINGS = frozenset({("sensing", "feeding")})
FACADE = "stochgeom"
DEEPEST = 2


def violations(source: str, module: str, *, is_package: bool = False) -> list[str]:
    """Return what is wrong with the imports of one module, a line of text for each."""
    if module == FACADE:
        return []
    layer = module.split(".")[1]
    if layer not in LAYERS:
        return [f"{module}: {layer!r} is not in the list of layers"]
    found = []
    for item in imports_of(source, module, is_package=is_package):
        reason = _reason(layer, item.target)
        if reason:
            found.append(f"{module}, line {item.line}: {reason}")
    return found


def _reason(layer: str, target: str) -> str | None:
    head, _, rest = target.partition(".")
    if head == "?":
        return "imports a module whose name is computed"
    if head != FACADE:
        return None
    other = rest.split(".")[0]
    if other not in LAYERS:
        return f"imports {other or 'all'!r} from the facade; import it from where it lives"
    if other == layer:
        return None
    if {layer, other} <= SIBLINGS and (layer, other) not in ALLOWED_AMONG_SIBLINGS:
        return f"{layer} imports its sibling {other}"
    if LAYERS.index(other) > LAYERS.index(layer):
        return f"{layer} imports {other}, which lies below it"
    return None


@pytest.mark.parametrize("path", MODULES, ids=relative)
def test_a_module_imports_only_from_the_layers_above(path):
    source = path.read_text(encoding="utf-8")
    assert violations(source, dotted_name(path), is_package=path.stem == "__init__") == []


def test_no_modules_import_each_other_in_a_circle():
    graph = module_graph(
        {dotted_name(path): path.read_text(encoding="utf-8") for path in MODULES},
        packages={dotted_name(path) for path in MODULES if path.stem == "__init__"},
    )
    list(TopologicalSorter(graph).static_order())


def module_graph(sources: dict[str, str], packages: set[str]) -> dict[str, set[str]]:
    """Return which of the given modules each of them imports."""
    return {
        module: {
            known
            for item in imports_of(source, module, is_package=module in packages)
            for known in (item.target, item.target.rpartition(".")[0])
            if known in sources and known != module
        }
        for module, source in sources.items()
    }


def test_folders_are_at_most_two_deep():
    folders = {path.parent for path in PACKAGE.rglob("*") if "__pycache__" not in path.parts}
    assert [
        relative(folder) for folder in folders if len(folder.relative_to(PACKAGE).parts) > DEEPEST
    ] == []


class TestTheCheckerItself:
    """Fabricated modules, so that a checker that accepts everything would be found out."""

    @pytest.mark.parametrize(
        ("module", "source"),
        [
            ("stochgeom.geometry.hull", "from stochgeom.feeding.plans import FeedingPlan"),
            ("stochgeom.geometry.hull", "import stochgeom.cli.main"),
            ("stochgeom.exact.angles", "def late():\n    from stochgeom.geometry import hull"),
            ("stochgeom.exact.angles", "from ..geometry.hull import convex_hull"),
            ("stochgeom.exact.angles", "from .. import geometry"),
            ("stochgeom.exact.angles", "import importlib\nimportlib.import_module('stochgeom.io')"),
            ("stochgeom.exact.angles", "from importlib import import_module\nimport_module(name)"),
            ("stochgeom.grasping.bounds", "from stochgeom.feeding.plans import FeedingPlan"),
            ("stochgeom.feeding.plans", "from stochgeom.sensing.sensors import Sensor"),
            ("stochgeom.cli.main", "import stochgeom"),
            ("stochgeom.cli.main", "from stochgeom import Part"),
            ("stochgeom.cli.main", "from stochgeom import *"),
            ("stochgeom.errors", "from stochgeom.exact.scalars import rational"),
            ("stochgeom.misc.things", ""),
        ],
    )
    def test_a_bad_import_is_found(self, module, source):
        assert len(violations(source, module)) == 1

    @pytest.mark.parametrize(
        ("module", "source"),
        [
            ("stochgeom.feeding.plans", "from stochgeom.transfer.squeeze import squeeze_function"),
            ("stochgeom.feeding.plans", "from stochgeom.feeding.preimages import preimages"),
            ("stochgeom.feeding.plans", "from .preimages import preimages"),
            ("stochgeom.sensing.plans", "from stochgeom.feeding.plans import FeedingPlan"),
            ("stochgeom.io.json", "import json\nimport numpy.linalg\nfrom stochgeom import errors"),
            ("stochgeom", "from stochgeom.cli.main import main"),
        ],
    )
    def test_a_good_import_passes(self, module, source):
        assert violations(source, module) == []

    def test_a_package_resolves_its_own_relative_imports(self):
        assert violations("from .angles import Angle", "stochgeom.exact", is_package=True) == []
        assert violations("from ..io import read", "stochgeom.exact", is_package=True) != []

    def test_a_circle_is_found(self):
        sources = {"p": "", "p.a": "from p.b import x", "p.b": "def f():\n    from p import a"}
        with pytest.raises(CycleError):
            TopologicalSorter(module_graph(sources, packages={"p"})).prepare()
