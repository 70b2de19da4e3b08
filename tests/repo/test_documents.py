"""What the documents name exists, and each has the form its folder asks for."""

from __future__ import annotations

import re

import pytest

from tests.repo.sources import DOCUMENTS, ROOT, make_targets, relative

each_document = pytest.mark.parametrize("path", DOCUMENTS, ids=relative)


def code_in(document: str) -> list[str]:
    """Return the lines of the fenced blocks and the inline code of a Markdown document."""
    fence = r"^```.*?\n(.*?)^```"
    blocks = re.findall(fence, document, flags=re.MULTILINE | re.DOTALL)
    prose = re.sub(fence, "", document, flags=re.MULTILINE | re.DOTALL)
    return [line for block in blocks for line in block.splitlines()] + re.findall(
        r"`([^`\n]+)`", prose
    )


def commands_of_make(document: str) -> set[str]:
    """Return the targets that a document tells its reader to make."""
    pattern = r"^(?:\$ )?(?:[A-Z_]+=\S+ )*make(?: [A-Z_]+=\S+| -\S+)* ([a-z][a-z-]*)"
    return {match[1] for line in code_in(document) if (match := re.match(pattern, line.strip()))}


def links_of(document: str) -> set[str]:
    """Return the targets of the relative links of a document, without their anchors."""
    prose = re.sub(r"^```.*?^```|`[^`\n]+`", "", document, flags=re.MULTILINE | re.DOTALL)
    targets = re.findall(r"\]\(([^)\s#]+)(?:#[^)]*)?\)", prose)
    return {target for target in targets if "://" not in target and ":" not in target}


@each_document
def test_a_block_is_closed_before_the_next_heading(path):
    inside = False
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if re.match(r" *```", line):
            inside = not inside
        assert not (inside and line.startswith("## ")), f"line {number}: {line}"
    assert not inside


@each_document
def test_documents_name_existing_make_targets(path):
    assert commands_of_make(path.read_text(encoding="utf-8")) - make_targets() == set()


@each_document
def test_links_lead_somewhere(path):
    links = links_of(path.read_text(encoding="utf-8"))
    assert [link for link in links if not (path.parent / link).exists()] == []


@pytest.mark.parametrize(
    "path", sorted((ROOT / "docs" / "decisions").glob("*.md")), ids=lambda path: path.stem
)
def test_a_decision_says_context_decision_consequences(path):
    headings = re.findall(r"^## (.+)$", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
    assert headings == ["Context", "Decision", "Consequences"]


def test_decisions_are_numbered_without_gap():
    numbers = [int(path.name[:4]) for path in sorted((ROOT / "docs" / "decisions").glob("*.md"))]
    assert numbers == list(range(1, len(numbers) + 1))


def test_the_map_of_the_tests_names_every_folder():
    described = (ROOT / "tests" / "README.md").read_text(encoding="utf-8")
    folders = {path.parent.name for path in (ROOT / "tests").glob("*/test_*.py")}
    assert {name for name in folders if f"`{name}/`" not in described} == set()


def test_names_of_test_files_are_unique():
    names = [path.name for path in (ROOT / "tests").rglob("test_*.py")]
    assert sorted(names) == sorted(set(names))


class TestTheReadersOfDocuments:
    def test_make_is_found_in_code_only(self):
        block = "```\n$ PYTHON=python3.12 make test-slow\nmake PART=key lint\n```\n"
        text = f"make sure\n`make plan`\n{block}"
        assert commands_of_make(text) == {"plan", "test-slow", "lint"}

    def test_make_targets_are_read(self):
        assert {"plan", "test", "test-slow", "lint", "bench", "clean"} <= make_targets()

    def test_links_are_found(self):
        text = "[a](docs/x.md#part) [b](https://example.org) [c](#here) `[d](nowhere)`"
        assert links_of(text) == {"docs/x.md"}
