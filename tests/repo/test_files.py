"""Size and form of the source files."""

from __future__ import annotations

import ast
import io
import tokenize

import pytest

from tests.repo.sources import MODULES, relative

MOST_FILE_LINES = 400
LONGER_FILES = {
    # One file by contract, to be read and run by itself; its code lines are about 370.
    "certificate_checker.py": 620,
    # The same for parts over fields; about 300.
    "field_certificate_checker.py": 480,
}
MOST_FUNCTION_LINES = 60
BANNED_CALLS = frozenset({"isclose", "allclose", "assert_allclose"})
"""Nothing is decided by being close."""

NO_CODE = frozenset(
    {
        tokenize.COMMENT,
        tokenize.NL,
        tokenize.NEWLINE,
        tokenize.INDENT,
        tokenize.DEDENT,
        tokenize.ENDMARKER,
    }
)
FUNCTION = ast.FunctionDef | ast.AsyncFunctionDef

each_module = pytest.mark.parametrize("path", MODULES, ids=relative)


def functions_too_long(source: str, most: int = MOST_FUNCTION_LINES) -> list[str]:
    """Return the functions with more than `most` lines, without docstring and comments."""
    code = {
        line
        for token in tokenize.generate_tokens(io.StringIO(source).readline)
        if token.type not in NO_CODE
        for line in range(token.start[0], token.end[0] + 1)
    }
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, FUNCTION):
            own = code & set(range(node.lineno, node.end_lineno + 1))
            count = len(own - _docstring_lines(node))
            if count > most:
                found.append(f"{node.name}, line {node.lineno}: {count} lines of code")
    return found


def _docstring_lines(node: ast.FunctionDef | ast.AsyncFunctionDef) -> set[int]:
    if ast.get_docstring(node) is None:
        return set()
    return set(range(node.body[0].lineno, node.body[0].end_lineno + 1))


def undocumented(source: str) -> list[str]:
    """Return the public classes, functions and methods without a docstring."""
    tree = ast.parse(source)
    found = [] if ast.get_docstring(tree) else ["the module"]
    return found + _undocumented_in(tree, "")


def _undocumented_in(owner: ast.Module | ast.ClassDef, prefix: str) -> list[str]:
    found = []
    for node in owner.body:
        if not isinstance(node, FUNCTION | ast.ClassDef) or node.name.startswith("_"):
            continue
        if ast.get_docstring(node) is None and not _inherits_its_docstring(node):
            found.append(f"{prefix}{node.name}, line {node.lineno}")
        if isinstance(node, ast.ClassDef):
            found += _undocumented_in(node, f"{prefix}{node.name}.")
    return found


def _inherits_its_docstring(node: ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef) -> bool:
    names = {ast.unparse(decorator).rpartition(".")[2] for decorator in node.decorator_list}
    return bool(names & {"overload", "override", "setter"})


def banned_calls(source: str) -> list[str]:
    """Return the comparisons by closeness, imported or called."""
    return [
        f"line {node.lineno}: {name}"
        for node in ast.walk(ast.parse(source))
        for name in _names_in(node)
        if name in BANNED_CALLS
    ]


def _names_in(node: ast.AST) -> list[str]:
    if isinstance(node, ast.Attribute):
        return [node.attr]
    if isinstance(node, ast.ImportFrom):
        return [alias.name for alias in node.names]
    return []


@each_module
def test_a_file_is_short(path):
    lines = path.read_text(encoding="utf-8").count("\n")
    assert lines <= LONGER_FILES.get(path.name, MOST_FILE_LINES)


@each_module
def test_functions_are_short(path):
    assert functions_too_long(path.read_text(encoding="utf-8")) == []


@each_module
def test_what_is_public_is_documented(path):
    assert undocumented(path.read_text(encoding="utf-8")) == []


@each_module
def test_nothing_is_decided_by_closeness(path):
    assert banned_calls(path.read_text(encoding="utf-8")) == []


class TestTheCheckersThemselves:
    def test_length_counts_code_only(self):
        docstring = '    """One.\n\n    Two.\n    """\n'
        source = f"def f():\n{docstring}    # why\n\n    a = 1\n    return (\n        a\n    )\n"
        assert functions_too_long(source, most=5) == []
        assert functions_too_long(source, most=4) == ["f, line 1: 5 lines of code"]

    def test_missing_docstrings_are_found(self):
        source = (
            '"""Doc."""\nclass A:\n    """Doc."""\n    def f(self): ...\n    def _g(self): ...\n'
        )
        assert undocumented(source) == ["A.f, line 4"]
        assert undocumented("def f(): ...") == ["the module", "f, line 1"]

    @pytest.mark.parametrize(
        "source", ["math.isclose(a, b)", "from numpy import allclose", "np.testing.assert_allclose"]
    )
    def test_closeness_is_found(self, source):
        assert len(banned_calls(source)) == 1
