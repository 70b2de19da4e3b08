"""Every single-field corruption of a certificate over a field is found, as for rational parts.

The rule of `tests.adversarial.test_certificate_mutants`, but for one thing: an angle over a field
has many directions, and a certificate may hold any of them. So a mutant is true if it is what the
library writes for the facts that the mutant gives, its angles compared as values. Numbers have one
form only, and directions are made of such numbers.
"""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from typing import Any

import pytest
from gmpy2 import mpq

from stochgeom.errors import StochgeomError
from stochgeom.exact.angles import Angle
from stochgeom.exact.fields import RealField, quadratic_field, regular_polygon_field
from stochgeom.exact.scalars import rational, rational_text
from stochgeom.exact.surds import exact_scalar, field_symbols, scalar_text
from stochgeom.feeding import field_certificate_checker as checker
from stochgeom.feeding.certificate_checker import InvalidClaimError
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.geometry.hull import convex_hull
from stochgeom.geometry.part import Part
from stochgeom.geometry.points import Points
from tests.adversarial.test_certificate_mutants import (
    Change,
    Json,
    at_random,
    changes,
    given_facts,
    mutate,
    nodes,
    word_for_word,
)

SEED = 20261125


def cut(n: int, corner: int = 1) -> Part:
    """Return a regular polygon with one corner moved inwards."""
    vertices = list(Part.regular(n).vertices)
    x, y = vertices[corner]
    vertices[corner] = x * mpq(9, 10), y * mpq(9, 10)
    return Part(vertices, name=f"cut {n}-gon")


TRIANGLE = Part([(0, 0), (1, 0), ("1/2", "1/2*sqrt(3)")], name="equilateral")
SKEW = Part([(0, 0), ("sqrt(6)", 0), (3, "1 + sqrt(6)"), (1, 1), (0, 2)], name="sqrt 6")
GOLDEN = Part([(0, 0), ("1/2 + 1/2*sqrt(5)", 0), (1, 1), (0, 1)], name="golden")
PARTS = [TRIANGLE, SKEW, GOLDEN, Part.regular(7), cut(5), cut(8), cut(9, 0)]


def certificates() -> Iterator[tuple[str, Json]]:
    """Yield true certificates: both actions, and plans of all kinds in turn."""
    for k, part in enumerate(PARTS):
        for action in ("squeeze", "push-grasp"):
            problem = FeedingProblem(part, action)
            c = [1, 0, "5/3"][k % 3]
            longest = problem.geometric_plan().steps
            plan = problem.plan_of(1 + (k + 1) % longest, c)
            yield f"{part.name}, {action}", plan.certificate()


# --- what is true --------------------------------------------------------------------------------


def symbols_of(document: Json) -> tuple[RealField | None, Any]:
    """Return the field that a document names, and what its letters stand for."""
    named = document["part"]["field"]
    if "regular polygon" in named:
        field = regular_polygon_field(named["regular polygon"])
        return field, field_symbols(field)
    return quadratic_field(named["square root of"]), None


def number(text: Any, symbols: Any) -> Any:
    """Read a number in its one form."""
    assert isinstance(text, str)
    value = exact_scalar(text, symbols=symbols)
    assert scalar_text(value) == text
    return value


def read_angle(claimed: Any, symbols: Any) -> Angle:
    """Read an angle in any of its forms."""
    assert claimed.keys() == {"turns", "direction"}
    turns, direction = claimed["turns"], claimed["direction"]
    assert type(turns) is int or (rational_text(rational(turns)) == turns and "/" in turns)
    assert isinstance(direction, list)
    return Angle(turns, tuple(number(text, symbols) for text in direction))


def agree(claimed: Any, true: Any, symbols: Any) -> bool:
    """Tell whether two documents are equal but for the directions that angles are given by."""
    if isinstance(true, dict) and true.keys() == {"turns", "direction"}:
        return read_angle(claimed, symbols) == read_angle(true, symbols)
    if type(claimed) is not type(true):
        return False
    if isinstance(true, dict):
        same = claimed.keys() == true.keys()
        return same and all(agree(claimed[key], true[key], symbols) for key in true)
    if isinstance(true, list):
        pairs = zip(claimed, true, strict=True)
        return len(claimed) == len(true) and all(agree(a, b, symbols) for a, b in pairs)
    return bool(claimed == true)


def is_true(mutant: Json, original: Json) -> bool:
    """Tell whether a mutant, which differs from a true certificate, is true as well."""
    try:
        _, symbols = symbols_of(mutant)
        if word_for_word(given_facts(mutant)) == word_for_word(given_facts(original)):
            return agree(mutant, original, symbols)
        return agree(mutant, library_certificate(mutant, symbols), symbols)
    except (StochgeomError, LookupError, TypeError, ValueError, AttributeError, AssertionError):
        return False


def library_certificate(mutant: Json, symbols: Any) -> Json:
    """Return what the library certifies for a mutant's facts; the hull stands for the outline."""
    action, part, cost_ratio, steps, nominal = given_facts(mutant)
    assert isinstance(part["name"], str | None)
    assert type(steps) is int
    assert rational_text(rational(cost_ratio)) == cost_ratio
    outline = [tuple(number(text, symbols) for text in pair) for pair in part["vertices"]]
    distinct = list(dict.fromkeys(outline))
    corners = [distinct[int(k)] for k in convex_hull(Points.from_pairs(distinct)).indices]
    center = None
    if action == "push-grasp":
        center = tuple(number(text, symbols) for text in part["center_of_mass"])
    plan = FeedingProblem(Part(corners, center), action).plan_of(steps, cost_ratio)
    document = plan.certificate()
    numbers = [outline.index(corner) for corner in corners]
    renumber(document, numbers)
    document["part"] |= {key: part[key] for key in ("name", "vertices")}
    if center is not None:
        document["part"]["center_of_mass"] = part["center_of_mass"]
    actions = zip(plan.actions, document["plan"]["actions"], nominal, strict=True)
    for k, (done, listed, claimed) in enumerate(actions):
        angle = read_angle(claimed, symbols)
        assert done.low < angle <= done.high if k else angle == done.angle
        listed["angle"] = claimed
    return document


def renumber(document: Json, numbers: list[int]) -> None:
    """Name the corners of a hull by their numbers in the outline."""
    hull = [numbers[k] for k in document["hull"]]
    first = hull.index(min(hull))
    document["hull"] = hull[first:] + hull[:first]
    for table in (document, document.get("squeeze", {}), document.get("push", {})):
        for entry in table.get("breaks", []) + table.get("values", []):
            for key in {"lower", "upper", "edge"} & entry.keys():
                entry[key] = [numbers[k] for k in entry[key]]
            if "vertex" in entry:
                entry["vertex"] = numbers[entry["vertex"]]


# --- mutants -------------------------------------------------------------------------------------


def field_changes(document: Json) -> Iterator[Change]:
    """Yield what may happen to numbers of a field, and to angles over one."""
    field, symbols = symbols_of(document)
    unit = exact_scalar(field.symbol, symbols=symbols) + 3  # positive
    for place, value in nodes(document):
        if isinstance(value, dict) and value.keys() == {"turns", "direction"}:
            x, y = (exact_scalar(text, symbols=symbols) for text in value["direction"])
            for how, u, v in (
                ("doubled", 2 * x, 2 * y),
                ("halved", x / 2, y / 2),
                ("scaled", unit * x, unit * y),
                ("reversed", -x, -y),
                ("reversed and scaled", -unit * x, -unit * y),
                ("mirrored", x, -y),
                ("turned a quarter", -y, x),
                ("bent", unit * x, y),
                ("slightly on", x - y / 10**40, y + x / 10**40),
                ("zero", 0 * x, 0 * y),
            ):
                texts = [scalar_text(u), scalar_text(v)]
                yield how, place, lambda texts=texts, value=value: {**value, "direction": texts}
            for turns in ("1/20", "1/24", "-1/7", "3/2", "2", "0/1", 1, -1, 0):
                yield f"{turns} turns", place, lambda t=turns, value=value: {**value, "turns": t}
        elif isinstance(value, str) and field.symbol in value:
            for new in (
                value.replace(field.symbol, f"1*{field.symbol}"),
                value.replace(field.symbol, "sqrt(7)"),
                value.replace(field.symbol, f"{field.symbol}^2"),
                value.replace(field.symbol, f"{field.symbol}^1"),
                f"{value} + 0",
                f"0 + {value}",
                f"{value} + {field.symbol}",
                f"{value} - {field.symbol}^99",
                f"({value})",
                value.replace(" ", ""),
                value.replace(" + ", " - "),
                value.replace("*", " * "),
                " ".join(value.split(" ")[::-1]),
            ):
                yield f"{value!r:.40} becomes {new!r:.50}", place, lambda new=new: new


FIELD_NAMES = [
    None,
    {},
    {"square root of": 4},
    {"square root of": 12},
    {"square root of": 7},
    {"square root of": -6},
    {"square root of": "6"},
    {"square root of": 6.0},
    {"square root of": True},
    {"square root of": 10**13},
    {"cube root of": 6},
    {"regular polygon": 5},
    {"regular polygon": 10},
    {"regular polygon": 7},
    {"regular polygon": 12},
    {"regular polygon": 1001},
    {"regular polygon": 0},
    {"regular polygon": 5, "square root of": 6},
    "Q",
    5,
]


def verdict(text: str) -> InvalidClaimError | None:
    """Return what the checker says against a document."""
    try:
        checker.check(checker.load(text.encode()))
    except InvalidClaimError as error:
        return error
    return None


def count(systematic: int, randomly: int, own: int) -> tuple[int, int, list[str]]:
    """Return how many mutants were lies, how many true, and on which the checker was wrong."""
    rng, lies, true, wrong = random.Random(SEED), 0, 0, []
    for name, document in certificates():
        everything, ours = list(changes(document)), list(field_changes(document))
        chosen = rng.sample(everything, min(systematic, len(everything)))
        chosen += rng.sample(ours, min(own, len(ours)))
        chosen += [at_random(document, rng) for _ in range(randomly)]
        for change in chosen:
            mutant = mutate(document, change)
            if mutant is None:
                continue
            holds = mutant.document is not None and is_true(mutant.document, document)
            true, lies = true + holds, lies + (not holds)
            error = verdict(mutant.text)
            if (error is None) is not holds:
                wrong.append(f"{name}: {mutant}: {error}")
    return lies, true, wrong


def test_every_mutant_is_found():
    lies, true, wrong = count(systematic=35, randomly=10, own=25)
    assert wrong == []
    assert lies >= 600
    assert true >= 20


@pytest.mark.slow
def test_every_mutant_is_found_the_long_way():
    lies, true, wrong = count(systematic=1000, randomly=300, own=1000)
    assert wrong == []
    assert lies >= 15_000
    assert true >= 1000


@pytest.mark.parametrize("name", FIELD_NAMES, ids=str)
def test_every_other_name_of_the_field_is_refused(name):
    for part in (SKEW, cut(5)):
        document = FeedingProblem(part).optimal_plan().certificate()
        if document["part"]["field"] != name or type(name) is not dict:
            document["part"]["field"] = name
            error = verdict(json.dumps(document))
            assert error is not None
            # A field that holds the part's numbers by accident is none of them: g = 2 cos 72.
            assert error.args[0].startswith(("part.", "plan.", "hull", "breaks"))


def test_the_library_writes_the_certificate_again():
    for _, document in certificates():
        _, symbols = symbols_of(document)
        assert agree(document, library_certificate(document, symbols), symbols)


def test_the_rule_tells_scaled_directions_from_turned_ones():
    document = FeedingProblem(SKEW).optimal_plan().certificate()
    found = {}
    for change in field_changes(document):
        if change[1] == ("breaks", 0, "angle"):
            mutant = mutate(document, change)
            found[change[0]] = mutant is None or is_true(mutant.document, document)
    assert {how for how, holds in found.items() if holds} >= {"doubled", "halved", "scaled"}
    assert not any(found[how] for how in ("reversed", "bent", "slightly on", "zero", "1 turns"))
