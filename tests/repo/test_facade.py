"""The public names: listed once for readers, once for the type checker, and all of them load."""

from __future__ import annotations

import re

import pytest

import stochgeom
from tests.repo.sources import PACKAGE, ROOT, imports_of

STUB = (PACKAGE / "__init__.pyi").read_text(encoding="utf-8")
NOTATION = (ROOT / "docs" / "notation.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", stochgeom.__all__)
def test_a_public_name_loads(name):
    assert getattr(stochgeom, name) is not None


def test_the_type_checker_sees_what_is_loaded():
    prefix = f"{stochgeom.__name__}."
    seen = {
        item.target.removeprefix(prefix)
        for item in imports_of(STUB, stochgeom.__name__, is_package=True)
        if item.target.startswith(prefix)
    }
    assert seen == {f"{home}.{name}" for name, home in stochgeom._HOMES.items()}
    assert set(stochgeom._HOMES) == set(stochgeom.__all__)


def test_a_name_is_listed_once():
    assert len(stochgeom.__all__) == len(set(stochgeom.__all__))


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no_such_name"):
        stochgeom.no_such_name  # noqa: B018


def code_names(table: str) -> set[str]:
    """Return the code names of the third column: ``Class``, ``Class.attribute``, ``function``."""
    cells = [re.split(r"(?<!\\)\|", line)[3] for line in table.splitlines() if line[:2] == "| "]
    spans = [span for cell in cells for span in re.findall(r"`([^`]+)`", cell)]
    names = {re.sub(r"\(.*", "", span) for span in spans if span[0].isupper() or "(" in span}
    return names - {"len"}


@pytest.mark.parametrize("dotted", sorted(code_names(NOTATION)))
def test_a_name_in_the_notation_exists(dotted):
    name, _, attribute = dotted.partition(".")
    owner = getattr(stochgeom, name)
    # What only `__init__` sets is no attribute of the class; its docstring lists it.
    assert not attribute or hasattr(owner, attribute) or attribute in listed_attributes(owner)


def listed_attributes(owner: type) -> set[str]:
    """Return the names that the section Attributes of a class's docstring lists."""
    section = (owner.__doc__ or "").partition("Attributes\n")[2]
    return set(re.findall(r"\w+", " ".join(re.findall(r"^ *([\w, ]+) :", section, re.MULTILINE))))


def test_the_reader_of_the_notation_finds_names():
    assert {"StepFunction.period", "plan_feeding", "Angle"} <= code_names(NOTATION)
    assert "ties" in listed_attributes(stochgeom.Preimage)
    assert "nothing" not in listed_attributes(stochgeom.Preimage)
