"""The source files of the package and the documents beside it, read for the checks here."""

from __future__ import annotations

import ast
import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "stochgeom"

MODULES = sorted(PACKAGE.rglob("*.py"))
FOLDERS = ("docs", "tests", "notebooks", "benchmarks", "stochgeom")
DOCUMENTS = [
    *sorted(ROOT.glob("*.md")),
    *(path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*.md"))),
]


def relative(path: Path) -> str:
    """Return the path from the root, as messages and test names show it."""
    return path.relative_to(ROOT).as_posix()


def dotted_name(path: Path) -> str:
    """Return the name a module is imported by: ``stochgeom.exact`` for its ``__init__.py``."""
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@dataclass(frozen=True)
class Import:
    """One imported module: its dotted name and line.

    A deferred import does not happen when its module is imported: it stands inside a function or
    is there for the type checker alone.
    """

    target: str
    line: int
    deferred: bool


def imports_of(source: str, module: str, *, is_package: bool = False) -> list[Import]:
    """Return every import of a module: at its top, inside functions, by text and relative.

    ``from a.b import c`` counts as ``a.b.c``, whether c is a module or a name in one.
    """
    tree = ast.parse(source)
    deferred = {node for owner in ast.walk(tree) if _defers(owner) for node in ast.walk(owner)}
    package = module if is_package else module.rpartition(".")[0]
    return [
        Import(target, node.lineno, node in deferred)
        for node in ast.walk(tree)
        for target in _targets(node, package)
    ]


def _defers(node: ast.AST) -> bool:
    if isinstance(node, ast.If):
        return ast.unparse(node.test) in {"TYPE_CHECKING", "typing.TYPE_CHECKING"}
    return isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)


def _targets(node: ast.AST, package: str) -> list[str]:
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if isinstance(node, ast.ImportFrom):
        base = node.module or ""
        if node.level:
            stem = package.split(".")[: len(package.split(".")) - node.level + 1]
            base = ".".join([*stem, *([node.module] if node.module else [])])
        return [f"{base}.{alias.name}" for alias in node.names]
    if isinstance(node, ast.Call) and _called_name(node) in {"import_module", "__import__"}:
        argument = node.args[0] if node.args else None
        if isinstance(argument, ast.Constant) and isinstance(argument.value, str):
            return [argument.value]
        return ["?"]
    return []


def _called_name(node: ast.Call) -> str:
    return getattr(node.func, "attr", getattr(node.func, "id", ""))


def make_targets() -> set[str]:
    """Return the names that ``make`` accepts."""
    text = (ROOT / "Makefile").read_text(encoding="utf-8")
    return set(re.findall(r"^([a-z][a-z-]*):(?!=)", text, flags=re.MULTILINE))
