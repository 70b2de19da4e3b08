"""Every single-field corruption of a certificate is found: mutants, systematic and at random.

A mutant differs from a true certificate in one place: a value, an entry or a key changed, dropped,
doubled, added or exchanged with another. The checker must reject every one of them, except those
that are true as well. The rule for these is applied before the checker is asked:

- only the action, the outline, its name, the cost ratio, the number of steps and the nominal angles
  are given, and for push-grasp plans the centre of mass; all else follows from them. Where none of
  these has changed, a mutant is a lie.
- Otherwise the library writes a certificate for what the mutant gives. If it is the mutant, word
  for word, the mutant is true: another name, a nominal angle still in its range and in canonical
  form, or an outline whose extrema are the same (an inner vertex moved, say). If it is not, or if
  the library refuses, the mutant is a lie.

True mutants must be accepted. So the checker is held to the library on both sides.
"""

from __future__ import annotations

import json
import random
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from math import gcd
from typing import Any

import pytest
from gmpy2 import mpq

from stochgeom.errors import StochgeomError
from stochgeom.exact.angles import Angle
from stochgeom.exact.scalars import rational, rational_text
from stochgeom.feeding import certificate_checker as checker
from stochgeom.feeding.certificate_checker import InvalidClaimError
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.geometry.hull import convex_hull
from stochgeom.geometry.part import Part
from stochgeom.geometry.points import Points
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from tests.strategies import SPECIAL

Json = dict[str, Any]
Place = tuple[str | int, ...]
SEED = 20261122
PARTS = 50
PUSHED_PARTS = 40

# --- the parts -----------------------------------------------------------------------------------

INNER = Part([(0, 0), (6, 0), (6, 4), (3, 1), (2, 2), (0, 4)], name="inner vertices")
DOUBLED = Part([(0, 0), (0, 0), (2, 0), (5, 0), (5, 1), (1, 3), (1, 3), (0, 2)], name="doubled")
THIRDS = Part([(0, 0), ("4/3", "-1/7"), ("5/2", "9/4"), ("-1/3", "2")], name="thirds")


def random_part(rng: random.Random) -> Part:
    """Return a polygon on a small grid, its vertices in order about a point of the plane."""
    while True:
        corners = {(rng.randint(-5, 5), rng.randint(-5, 5)) for _ in range(rng.randint(3, 6))}
        eye = mpq(rng.randint(-9, 9), 7), mpq(rng.randint(-9, 9), 11)
        around = sorted(corners, key=lambda p: Angle(0, (p[0] - eye[0], p[1] - eye[1])))
        factor = mpq(rng.choice([1, 1, 2, 3]), rng.choice([1, 1, 1, 7]))
        try:
            return Part([(x * factor, y * factor) for x, y in around])
        except StochgeomError:
            continue


def certificates() -> Iterator[tuple[str, Json]]:
    """Yield a name and a true certificate for each part, with plans of all kinds in turn."""
    rng = random.Random(SEED)
    named = [*map(catalogue_part, catalogue_names()), *SPECIAL, INNER, DOUBLED, THIRDS]
    parts = named + [random_part(rng) for _ in range(PARTS - len(named))]
    for k, part in enumerate(parts):
        problem = FeedingProblem(part)
        c = [1, 0, "5/3", 10][k % 4]
        longest = problem.geometric_plan().steps
        plans = problem.optimal_plan(c), problem.geometric_plan(c), problem.plan_of(1 + k % longest)
        yield part.name or f"part {k}", plans[k % 3].certificate()


def push_certificates() -> Iterator[tuple[str, Json]]:
    """Yield the same for push-grasp plans, of parts with their centroid or another point inside."""
    rng = random.Random(SEED)
    thesis = [Part(catalogue_part("house").vertices, (0, "2/5"), "house")]
    thesis += [Part([(52, 58), (0, 55), (8, 17), (51, 0)], (28, 32), "4gon")]
    named = [*thesis, *SPECIAL, INNER, DOUBLED, THIRDS]
    parts = named + [with_a_center(random_part(rng), rng) for _ in range(PUSHED_PARTS - len(named))]
    for k, part in enumerate(parts):
        problem = FeedingProblem(part, "push-grasp")
        c = [1, 0, "5/3", 10][k % 4]
        longest = problem.geometric_plan().steps
        plans = problem.optimal_plan(c), problem.geometric_plan(c), problem.plan_of(1 + k % longest)
        yield part.name or f"part {k}", plans[k % 3].certificate()


def with_a_center(part: Part, rng: random.Random) -> Part:
    """Return the part with a mean of its corners as centre of mass."""
    corners = part.hull.points.pairs()
    weights = [rng.randint(1, 4) for _ in corners]
    x, y = (
        sum(w * corner[axis] for w, corner in zip(weights, corners, strict=True)) / sum(weights)
        for axis in (0, 1)
    )
    return Part(part.vertices, (x, y))


# --- what is true --------------------------------------------------------------------------------


def given_facts(document: Json) -> Any:
    """Return what a certificate's other claims follow from."""
    plan = document["plan"]
    return (
        document["action"],
        document["part"],
        document["cost_ratio"],
        plan["steps"],
        [action["angle"] for action in plan["actions"]],
    )


def is_true(mutant: Json, original: Json) -> bool:
    """Tell whether a mutant, which differs from a true certificate, is true as well."""
    try:
        facts = given_facts(mutant)
        if word_for_word(facts) == word_for_word(given_facts(original)):
            return False
        return word_for_word(library_certificate(*facts)) == word_for_word(mutant)
    except (StochgeomError, LookupError, TypeError, ValueError, AttributeError, AssertionError):
        return False


def word_for_word(value: Any) -> str:
    """Return a text that tells 1 from 1.0, True and "1"; the order of keys does not count."""
    return json.dumps(value, sort_keys=True)


def library_certificate(
    action_name: str, part: Json, cost_ratio: str, steps: int, nominal: list[Json]
) -> Json:
    """Return what the library certifies for these facts; the hull stands for the outline."""
    assert isinstance(part["name"], str | None)
    assert rational_text(rational(cost_ratio)) == cost_ratio
    assert type(steps) is int
    outline = [(rational(x), rational(y)) for x, y in part["vertices"]]
    assert [[rational_text(x), rational_text(y)] for x, y in outline] == part["vertices"]
    distinct = list(dict.fromkeys(outline))
    corners = [distinct[int(k)] for k in convex_hull(Points.from_pairs(distinct)).indices]
    given_part = {"name": part["name"], "vertices": part["vertices"]}
    center = None
    if action_name == "push-grasp":
        x, y = center = tuple(rational(number) for number in part["center_of_mass"])
        given_part["center_of_mass"] = [rational_text(x), rational_text(y)]
    plan = FeedingProblem(Part(corners, center), action_name).plan_of(steps, cost_ratio)
    document = plan.certificate()
    number = [outline.index(corner) for corner in corners]
    hull = [number[k] for k in document["hull"]]
    first = hull.index(min(hull))
    document["hull"] = hull[first:] + hull[:first]
    for table in (document, document.get("squeeze", {}), document.get("push", {})):
        for entry in table.get("breaks", []) + table.get("values", []):
            for key in {"lower", "upper", "edge"} & entry.keys():
                entry[key] = [number[k] for k in entry[key]]
            if "vertex" in entry:
                entry["vertex"] = number[entry["vertex"]]
    document["part"] = given_part
    actions = zip(plan.actions, document["plan"]["actions"], nominal, strict=True)
    for k, (action, listed, claimed) in enumerate(actions):
        angle = Angle(claimed["turns"], [rational(number) for number in claimed["direction"]])
        x, y = angle.direction
        canonical = {"turns": int(angle.turn_part), "direction": [str(x), str(y)]}
        assert word_for_word(claimed) == word_for_word(canonical)
        assert action.low < angle <= action.high if k else angle == action.angle
        listed["angle"] = claimed
    return document


# --- mutants -------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Mutant:
    """A changed certificate: how, where, and its text."""

    how: str
    place: Place
    text: str
    document: Json | None
    """None if the text is no JSON that stands for a document of ours."""

    def __str__(self) -> str:
        return f"{self.how} at {'.'.join(map(str, self.place))}"


class Raw(str):
    """JSON text to be put in as it is."""

    __slots__ = ()


Change = tuple[str, Place, Callable[[], Any]]
"""How, where, and what the value there is replaced with."""


def changes(document: Json) -> Iterator[Change]:
    """Yield every systematic change of a document."""
    for place, value in nodes(document):
        if place:
            kinds = {dict: of_objects, list: of_lists, str: of_texts, bool: of_truths}
            of_kind = kinds.get(type(value), of_numbers if type(value) is int else of_nothing)
            for how, new in of_kind(value):
                yield how, place, new
            yield from ((f"becomes {other!r}", place, lambda o=other: o) for other in OTHERS)


OTHERS = (None, True, False, 0, 1, -1, 1.0, "", "0", "1", [], {}, ["0", "1"], [[]])


def nodes(node: Any, place: Place = ()) -> Iterator[tuple[Place, Any]]:
    """Yield the places and values of all nodes."""
    yield place, node
    if isinstance(node, dict | list):
        for key, value in node.items() if isinstance(node, dict) else enumerate(node):
            yield from nodes(value, (*place, key))


def of_numbers(n: int) -> Iterator[tuple[str, Callable[[], Any]]]:
    """Yield changes of a whole number, and other ways to write it."""
    for new in (n + 1, n - 1, -n, 10 * n, n + 10**15, float(n), str(n), [n], n + 0.5):
        yield f"{n} becomes {new!r}", lambda new=new: new
    for raw in (f"0{n}", f"+{n}", f"{n}.", f"{n}.0", f"{n}e0", f"-{n}", "NaN", "Infinity"):
        yield f"{n} becomes {raw}", lambda raw=raw: Raw(raw)


def of_texts(text: str) -> Iterator[tuple[str, Callable[[], Any]]]:
    """Yield changes of a text, most of which is a number."""
    new = [f" {text}", f"{text} ", f"{text}0", f"0{text}", f"+{text}", f"{text}.0", f"{text}/1"]
    new += [text[:-1], text[1:], text.upper(), text.lower(), f"{text}e0", f"{text}\n", text[::-1]]
    new += [text.removeprefix("-") if text.startswith("-") else f"-{text}"]
    for k, digit in enumerate(text):
        if digit.isdigit():
            for other in ((int(digit) + 1) % 10, (int(digit) - 1) % 10):
                new.append(text[:k] + str(other) + text[k + 1 :])
    p, _, q = text.partition("/")
    if p.lstrip("-").isdigit() and (not q or q.isdigit()):
        new += [f"{2 * int(p)}/{2 * int(q or 1)}", f"{-int(p)}/-{q or 1}", f"{p}/{q}1", f"{p}/0"]
        new += [int(p), float(p), [text], Raw(p)] if not q else [int(p) / int(q), f"{q}/{p}"]
    for value in new:
        yield f"{text!r} becomes {value!r}", lambda value=value: value


def of_truths(truth: bool) -> Iterator[tuple[str, Callable[[], Any]]]:
    """Yield changes of true and false."""
    for new in (not truth, int(truth), str(truth).lower(), [truth]):
        yield f"{truth} becomes {new!r}", lambda new=new: new


def of_nothing(nothing: None) -> Iterator[tuple[str, Callable[[], Any]]]:
    """Yield what may stand in the place of null."""
    for new in ("null", {"turns": 0, "direction": ["1", "0"]}, {"first": 0, "width": None}, [None]):
        yield f"null becomes {new!r}", lambda new=new: new


def of_lists(entries: list[Any]) -> Iterator[tuple[str, Callable[[], Any]]]:
    """Yield changes of the entries of a list as a whole."""
    count = len(entries)
    for k in range(count):
        yield f"entry {k} dropped", lambda k=k: entries[:k] + entries[k + 1 :]
        yield f"entry {k} doubled", lambda k=k: entries[: k + 1] + entries[k:]
        yield f"null inserted before {k}", lambda k=k: [*entries[:k], None, *entries[k:]]
        yield f"entry {k} put last", lambda k=k: [*entries[:k], *entries[k + 1 :], entries[k]]
        yield f"entries cut at {k}", lambda k=k: entries[:k]
        for j in range(k):
            yield (
                f"entries {j} and {k} exchanged",
                lambda j=j, k=k: [
                    entries[{j: k, k: j}.get(place, place)] for place in range(count)
                ],
            )
    yield "reversed", lambda: entries[::-1]
    yield "twice over", lambda: entries * 2
    yield "one turned", lambda: entries[1:] + entries[:1]
    yield "as an object", lambda: {str(k): entry for k, entry in enumerate(entries)}
    yield "nested", lambda: [entries]
    yield "something added", lambda: [*entries, "0"]
    yield "null added", lambda: [*entries, None]


def of_objects(members: Json) -> Iterator[tuple[str, Callable[[], Any]]]:
    """Yield changes of the keys of an object, and of an angle's two parts together."""
    for key in members:
        others = {other: value for other, value in members.items() if other != key}
        yield f"{key} dropped", lambda others=others: others
        yield f"{key} renamed", lambda others=others, key=key: {**others, key.upper(): members[key]}
        yield f"{key} null", lambda key=key: {**members, key: None}
        for other in others:
            yield (
                f"{key} and {other} exchanged",
                lambda key=key, other=other: {
                    **members,
                    key: members[other],
                    other: members[key],
                },
            )
            yield f"{key} as {other}", lambda key=key, other=other: {**members, key: members[other]}
    yield "a key added", lambda: {**members, "note": ""}
    yield "as a list", lambda: list(members.values())
    yield "nested", lambda: [members]
    if members.keys() == {"turns", "direction"} and is_whole(members):
        yield from of_angles(members)


def is_whole(members: Json) -> bool:
    """Tell whether an angle is a direction over Q, lifted by whole turns."""
    digits = (str(number).removeprefix("-").isdecimal() for number in members["direction"])
    return type(members["turns"]) is int and all(digits)


def of_angles(members: Json) -> Iterator[tuple[str, Callable[[], Any]]]:
    """Yield other angles near by, and other ways to write the angle."""
    turns, (x, y) = members["turns"], map(int, members["direction"])
    for name, t, u, v in (
        ("doubled direction", turns, 2 * x, 2 * y),
        ("half a turn on", turns + (y < 0 or (y == 0 and x < 0)), -x, -y),
        ("reversed direction", turns, -x, -y),
        ("a quarter turned", turns, -y, x),
        ("mirrored", turns, x, -y),
        ("exchanged", turns, y, x),
        ("a turn on", turns + 1, x, y),
        ("a turn back", turns - 1, x, y),
        ("negated", -turns, x, -y),
        ("slightly on", turns, 1000 * x - y, 1000 * y + x),
        ("slightly back", turns, 1000 * x + y, 1000 * y - x),
        ("eighths", turns, 1, 1),
        ("zero", 0, 1, 0),
        ("no direction", turns, 0, 0),
    ):
        common = 1 if "doubled" in name else gcd(u, v) or 1
        new = {"turns": t, "direction": [str(u // common), str(v // common)]}
        yield name, lambda new=new: new
    yield "without turns, as text", lambda: f"{x}:{y}"
    yield "turns as text", lambda: {**members, "turns": str(turns)}


def at_random(document: Json, rng: random.Random) -> Change:
    """Return a random change: two leaves or entries of one kind exchanged, or a small number."""
    leaves = [
        (place, value) for place, value in nodes(document) if not isinstance(value, dict | list)
    ]
    place, value = rng.choice(leaves)
    alike = [(other, v) for other, v in leaves if type(v) is type(value) and v != value]
    if alike and rng.random() < 0.6:
        other, new = rng.choice(alike)
        if rng.random() < 0.5:
            return f"exchanged with {'.'.join(map(str, other))}", place, lambda: Exchange(other)
        return f"copied from {'.'.join(map(str, other))}", place, lambda: new
    step = rng.choice([-100, -10, -2, -1, 1, 2, 10, 100])
    if type(value) is int:
        return f"{step:+}", place, lambda: value + step
    if isinstance(value, str) and value.lstrip("-").isdigit():
        return f"{step:+}", place, lambda: str(int(value) + step)
    return "replaced at random", place, lambda: rng.choice(OTHERS)


@dataclass(frozen=True)
class Exchange:
    """In place of a new value: exchange with the value at another place."""

    other: Place


def mutate(document: Json, change: Change) -> Mutant | None:
    """Return the mutant, or None if nothing has changed."""
    how, place, make = change
    original = word_for_word(document)
    mutant = json.loads(original)
    new = make()
    if isinstance(new, Raw):
        put(mutant, place, "@raw@")
        text = word_for_word(mutant).replace('"@raw@"', new)
        return None if text == original else Mutant(how, place, text, None)
    if isinstance(new, Exchange):
        put(mutant, new.other, value_at(document, place))
        new = value_at(document, new.other)
    put(mutant, place, new)
    text = word_for_word(mutant)
    return None if text == original else Mutant(how, place, text, mutant)


def value_at(node: Any, place: Place) -> Any:
    for key in place:
        node = node[key]
    return node


def put(document: Json, place: Place, value: Any) -> None:
    value_at(document, place[:-1])[place[-1]] = value


# --- the count -----------------------------------------------------------------------------------


@dataclass
class Tally:
    """How many mutants of what kind."""

    parts: int = 0
    lies: int = 0
    true: int = 0
    survivors: list[str] = field(default_factory=list)
    false_alarms: list[str] = field(default_factory=list)
    exit_codes: Counter[int] = field(default_factory=Counter)

    def add(self, name: str, mutant: Mutant, original: Json) -> None:
        """Apply the rule, ask the checker, count."""
        true = mutant.document is not None and is_true(mutant.document, original)
        try:
            checker.check(checker.load(mutant.text.encode()))
        except InvalidClaimError as error:
            self.exit_codes[2 if isinstance(error, checker.NoCertificateError) else 1] += 1
            if true:
                self.false_alarms.append(f"{name}: {mutant}: {error}")
        else:
            if not true:
                self.survivors.append(f"{name}: {mutant}")
        self.true += true
        self.lies += not true

    def __str__(self) -> str:
        killed = self.lies - len(self.survivors)
        return (
            f"{self.lies + self.true} mutants of {self.parts} certificates: {self.true} still "
            f"true, {killed} of {self.lies} lies found: kill rate {100 * killed / self.lies:.4f} % "
            f"({self.exit_codes[1]} claims that fail, {self.exit_codes[2]} no certificates)"
        )


def count_mutants(
    systematic: int,
    randomly: int,
    source: Callable[[], Iterator[tuple[str, Json]]] = certificates,
) -> Tally:
    """Try so many mutants of each part, or all systematic ones if there are fewer."""
    rng, tally = random.Random(SEED), Tally()
    for name, document in source():
        tally.parts += 1
        everything = list(changes(document))
        chosen = rng.sample(everything, min(systematic, len(everything)))
        chosen += [at_random(document, rng) for _ in range(randomly)]
        for change in chosen:
            mutant = mutate(document, change)
            if mutant is not None:
                tally.add(name, mutant, document)
    return tally


def report(tally: Tally, capsys: pytest.CaptureFixture[str]) -> None:
    with capsys.disabled():
        sys.stdout.write(f"\n{tally}\n")


def test_every_mutant_is_found(capsys):
    tally = count_mutants(systematic=170, randomly=60)
    report(tally, capsys)
    assert tally.parts == PARTS
    assert tally.lies >= 10_000
    assert tally.survivors == []
    assert tally.false_alarms == []
    assert tally.true > 0


def test_every_mutant_of_a_push_grasp_plan_is_found(capsys):
    tally = count_mutants(50, 20, push_certificates)
    report(tally, capsys)
    assert tally.parts == PUSHED_PARTS
    assert tally.lies >= 2_500
    assert tally.survivors == []
    assert tally.false_alarms == []
    assert tally.true > 0


@pytest.mark.slow
@pytest.mark.parametrize("source", [certificates, push_certificates])
def test_every_mutant_is_found_the_long_way(capsys, source):
    tally = count_mutants(1700, 600, source)
    report(tally, capsys)
    assert tally.lies >= 80_000
    assert tally.survivors == []
    assert tally.false_alarms == []


def test_every_systematic_mutant_of_one_certificate_is_found():
    document = FeedingProblem([(0, 0), (5, 0), (-1, 1)]).optimal_plan().certificate()
    tally = Tally(parts=1)
    for change in changes(document):
        mutant = mutate(document, change)
        if mutant is not None:
            tally.add("obtuse triangle", mutant, document)
    assert tally.lies > 1000
    assert tally.survivors == []
    assert tally.false_alarms == []


def about_the_push(document: Json) -> list[Change]:
    """Return the changes of what a push-grasp plan's certificate says in its own way."""
    own = {"action", "part", "push", "squeeze", "breaks", "values"}
    return [change for change in changes(document) if change[1][0] in own]


def test_every_systematic_mutant_of_one_push_grasp_plan_is_found():
    triangle = Part([(0, 0), (4, 0), (0, 3)], name="3 4 5")
    document = FeedingProblem(triangle, "push-grasp").optimal_plan().certificate()
    tally = Tally(parts=1)
    for change in about_the_push(document):
        mutant = mutate(document, change)
        if mutant is not None:
            tally.add("triangle", mutant, document)
    assert tally.lies > 2000
    assert tally.survivors == []
    assert tally.false_alarms == []


# --- the rule and the mutants themselves ---------------------------------------------------------

RECTANGLE = FeedingProblem(Part([(0, 0), (3, 0), (3, 2), (0, 2)], name="tray"))
NOTCHED = FeedingProblem([(0, 0), (3, 0), (3, 2), (2, 1), (0, 2)])
PUSHED = FeedingProblem(
    Part([(0, 0), (6, 0), (6, 4), (4, 1), (0, 4)], (3, 1), "pushed"), "push-grasp"
)


def changed(problem, place, value):
    document = problem.geometric_plan().certificate()
    put(document, place, value)
    return document


class TestTheRule:
    """Which mutants are true; each is accepted, each lie beside it is not."""

    @pytest.mark.parametrize(
        ("problem", "place", "value", "expected"),
        [
            (RECTANGLE, ("part", "name"), "another", True),
            (RECTANGLE, ("part", "name"), None, True),
            (RECTANGLE, ("part", "name"), 7, False),
            # -45 degrees, in (-56.3, -33.7]
            (RECTANGLE, ("plan", "actions", 1, "angle", "direction", 1), "-2", False),
            (RECTANGLE, ("plan", "actions", 1, "angle", "direction"), ["5", "-4"], True),
            (RECTANGLE, ("plan", "actions", 1, "angle", "direction"), ["10", "-8"], False),
            (RECTANGLE, ("plan", "actions", 1, "angle", "direction"), ["3", "-2"], True),
            (RECTANGLE, ("plan", "actions", 1, "angle", "direction"), ["2", "-3"], False),
            (RECTANGLE, ("plan", "actions", 0, "angle", "direction"), ["5", "-4"], False),
            # an inner vertex moved, onto the hull, and out of it
            (NOTCHED, ("part", "vertices", 3), ["1", "1"], True),
            (NOTCHED, ("part", "vertices", 3), ["1", "2"], True),
            (NOTCHED, ("part", "vertices", 3), ["1", "3"], False),
            (NOTCHED, ("part", "vertices", 3, 0), "2/2", False),
            (NOTCHED, ("part", "vertices", 2, 0), "4", False),
            (NOTCHED, ("cost_ratio",), "2", False),
            (NOTCHED, ("plan", "steps"), 1, False),
            (NOTCHED, ("action",), "push-grasp", False),
            (PUSHED, ("part", "name"), "another", True),
            (PUSHED, ("part", "vertices", 3), ["4", "2"], True),
            (PUSHED, ("part", "vertices", 3), ["4", "5"], False),
            (PUSHED, ("part", "center_of_mass"), ["3", "2"], False),
            (PUSHED, ("part", "center_of_mass", 1), "2/2", False),
            (PUSHED, ("part", "center_of_mass", 1), 1, False),
            (PUSHED, ("part", "center_of_mass", 1), "0", False),
            (PUSHED, ("part", "center_of_mass", 1), "5", False),
            (PUSHED, ("part", "center_of_mass"), None, False),
            (PUSHED, ("action",), "squeeze", False),
        ],
    )
    def test_it_is_the_checkers(self, problem, place, value, expected):
        original = problem.geometric_plan().certificate()
        mutant = changed(problem, place, value)
        assert is_true(mutant, original) is expected
        if expected:
            checker.check(mutant)
        else:
            with pytest.raises(InvalidClaimError):
                checker.check(mutant)

    def test_the_library_writes_the_certificate_again(self):
        for _, document in [*certificates(), *push_certificates()]:
            assert library_certificate(*given_facts(document)) == document


def test_the_mutants_are_of_all_kinds():
    """Each of these lies was once thought of; none may get lost from the list."""
    document = RECTANGLE.geometric_plan().certificate()
    found = {str(mutant) for mutant in (mutate(document, c) for c in changes(document)) if mutant}
    assert len(found) > 3000
    for expected in (
        "low and high exchanged at plan.actions.1",
        "low as high at plan.actions.1",
        "lower and upper exchanged at breaks.0",
        "first and last exchanged at preimages.1",
        "entries 0 and 1 exchanged at preimages",
        "entry 0 dropped at plan.actions",
        "entry 1 doubled at hull",
        "steps dropped at plan",
        "rival null at preimages.0",
        "a key added at plan",
        "width renamed at plan.mouth",
        "0 becomes -0 at period.turns",
        "0 becomes 00 at period.turns",
        "2 becomes '2' at optimal_steps",
        "2 becomes 2.0 at optimal_steps",
        "True becomes False at plan.optimal",
        "True becomes 1 at plan.optimal",
        "'3' becomes '+3' at part.vertices.1.0",
        "'3' becomes '6/2' at part.vertices.1.0",
        "'0' becomes '-0' at part.vertices.1.1",
        "'12' becomes 12 at preimages.0.width.direction.1",
        "doubled direction at preimages.0.width",
        "slightly on at plan.actions.1.high",
        "becomes None at plan.actions.1.low",
        "1 becomes -1 at costs.0.comparison",
    ):
        assert expected in found


def test_the_mutants_of_push_grasp_plans_are_of_all_kinds():
    document = PUSHED.geometric_plan().certificate()
    mutants = (mutate(document, change) for change in about_the_push(document))
    found = {str(mutant) for mutant in mutants if mutant}
    for expected in (
        "entries 0 and 1 exchanged at push.values.0.edge",
        "reversed at push.values.0.edge",
        "entry 0 dropped at push.breaks",
        "breaks and values exchanged at push",
        "a turn on at push.values.3.angle",
        "a key added at squeeze",
        "lower and upper exchanged at squeeze.breaks.0",
        "0 becomes 1 at breaks.0.push_break",
        "angle and squeeze_value exchanged at values.0",
        "center_of_mass dropped at part",
        "entries 0 and 1 exchanged at part.center_of_mass",
    ):
        assert expected in found


@pytest.mark.parametrize("place", ["push.", "squeeze.", "breaks", "values"])
def test_a_checker_blind_to_pushes_would_be_caught(monkeypatch, place):
    """If it believed one of the tables, mutants would survive."""
    blind = checker.agree

    def agree(claimed, true, where, *numbers):
        if not where.startswith(place):
            blind(claimed, true, where, *numbers)

    monkeypatch.setattr(checker, "agree", agree)
    document = PUSHED.geometric_plan().certificate()
    tally, rng = Tally(parts=1), random.Random(SEED)
    for change in rng.sample(about_the_push(document), 300):
        mutant = mutate(document, change)
        if mutant is not None:
            tally.add("pushed", mutant, document)
    assert tally.survivors
    assert all(f"at {place.rstrip('.')}" in survivor for survivor in tally.survivors)


def test_a_blind_checker_would_be_caught(monkeypatch):
    """If the checker believed the costs, mutants would survive."""
    blind = checker.agree

    def agree(claimed, true, place, *numbers):
        if not place.startswith("costs"):
            blind(claimed, true, place, *numbers)

    monkeypatch.setattr(checker, "agree", agree)
    tally = count_mutants(systematic=20, randomly=5)
    assert tally.survivors
    assert all("costs" in survivor or "cost_ratio" in survivor for survivor in tally.survivors)
