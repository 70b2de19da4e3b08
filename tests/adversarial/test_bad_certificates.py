"""Files that are no certificates, or broken ones: a clear message, exit code 2, no traceback."""

from __future__ import annotations

import copy
import json
import os
import reprlib
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.feeding import certificate_checker as checker
from stochgeom.feeding.certificate_checker import InvalidClaimError, NoCertificateError
from stochgeom.feeding.planner import FeedingProblem, orient_up_to_symmetry
from stochgeom.geometry.part import Part
from stochgeom.thesis.parts import catalogue_part

CERTIFICATE = orient_up_to_symmetry(catalogue_part("4gon")).certificate()
TEXT = json.dumps(CERTIFICATE)
SMALL = FeedingProblem([(0, 0), (3, 0), (3, 2), (0, 2)]).plan_of(2).certificate()
PUSHED = orient_up_to_symmetry(
    Part([(52, 58), (0, 55), (8, 17), (51, 0)], (28, 32), "4gon"), action="push-grasp"
).certificate()


def call(capsys, path):
    """Call the checker's `main` and return its exit code and output."""
    capsys.readouterr()
    code = checker.main([str(path)])
    return code, *capsys.readouterr()


def refusal(capsys, path):
    """Return the one line that the checker writes about what is no certificate."""
    code, out, err = call(capsys, path)
    assert (code, out) == (2, "")
    assert err.startswith("no certificate: ")
    assert err.count("\n") == 1
    assert len(err) < 300
    return err.removeprefix("no certificate: ").rstrip()


def refusal_of(data):
    """Return why bytes are no certificate, or their document is none."""
    with pytest.raises(NoCertificateError) as caught:
        checker.check(checker.load(data))
    return str(caught.value)


# --- files ---------------------------------------------------------------------------------------


def test_a_missing_file_and_a_folder(capsys, tmp_path):
    assert "No such file" in refusal(capsys, tmp_path / "none.json")
    assert "directory" in refusal(capsys, tmp_path)


def test_a_file_that_may_not_be_read(capsys, tmp_path, monkeypatch):
    """Root may read everything, so the refusal is made here."""

    def refuse(*arguments, **settings):
        raise PermissionError(13, "Permission denied", "plan.json")

    monkeypatch.setattr(Path, "open", refuse)
    assert "Permission denied" in refusal(capsys, tmp_path / "plan.json")


@pytest.mark.parametrize("size", [checker.MAX_BYTES + 1, 70 * 2**20, 2**32])
def test_a_large_file(capsys, tmp_path, size):
    """Only the first bytes are read; the file is sparse and takes no room."""
    path = tmp_path / "large.json"
    with path.open("wb") as file:
        file.write(TEXT.encode())
        file.truncate(size)
    assert refusal(capsys, path) == f"file: more than {checker.MAX_BYTES} bytes"


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="no endless file on this system")
def test_an_endless_file_in_little_memory():
    resource = pytest.importorskip("resource")
    limit = 512 * 2**20

    def restrict():
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

    result = subprocess.run(
        [sys.executable, "-I", "-S", str(checker.__file__), "/dev/zero"],
        capture_output=True,
        preexec_fn=restrict,
        timeout=60,
        check=False,
    )
    assert result.returncode == 2
    assert result.stderr == b"no certificate: file: more than 67108864 bytes\n"


def test_long_text_does_not_hide_what_comes_after_it():
    """The limit is one of bytes: characters of two bytes must not let the rest be cut off."""
    document = {**SMALL, "part": {**SMALL["part"], "name": "é" * 1000}}
    data = json.dumps(document, ensure_ascii=False).encode()
    checker.check(checker.load(data))
    padded = data.ljust(checker.MAX_BYTES + 1) + b"more"
    assert refusal_of(padded) == f"file: more than {checker.MAX_BYTES} bytes"
    assert refusal_of(padded[: checker.MAX_BYTES + 1]).startswith("file: more than")
    checker.check(checker.load(padded[: checker.MAX_BYTES]))


# --- text ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "file: not JSON: Expecting value: line 1 column 1"),
        (b"   \n", "file: not JSON: Expecting value: line 2 column 1"),
        (b"certificate", "file: not JSON: Expecting value"),
        (b"\x00\x01\x02", "file: not JSON: Expecting value"),
        (b"\x89PNG\r\n\x1a\n", "file: not JSON: 'utf-8' codec can't decode byte 0x89"),
        (TEXT.encode("utf-16"), "file: not JSON: 'utf-8' codec can't decode byte 0xff"),
        (TEXT.encode("utf-8-sig"), "file: not JSON: Unexpected UTF-8 BOM"),
        (TEXT.encode() + b"{}", "file: not JSON: Extra data"),
        (TEXT.replace('"', "'").encode(), "file: not JSON: Expecting property name"),
        (TEXT.replace("4gon", "4\ngon").encode(), "file: not JSON: Invalid control character"),
        (b"[" * 100_000, "file: not JSON: "),
        (b'{"a":' * 100_000, "file: not JSON: "),
        (b"[" * 100_000 + b"]" * 100_000, "file: not JSON: "),
        (b"NaN", "file: not JSON: NaN is no short whole number"),
        (b"9" * 10**5, "file: not JSON: 99999999999999999999 is no short whole number"),
        (b"null", "schema: None; accepted: 'stochgeom/certificate/1'"),
        (b"true", "schema: None; accepted: 'stochgeom/certificate/1'"),
        (b"17", "schema: None; accepted: 'stochgeom/certificate/1'"),
        (b"-1.5e3", "schema: None; accepted: 'stochgeom/certificate/1'"),
        (b'"stochgeom/certificate/1"', "schema: None; accepted"),
        (b"[]", "schema: None; accepted: 'stochgeom/certificate/1'"),
        (b"{}", "schema: None; accepted: 'stochgeom/certificate/1'"),
        (b'{"schema": null}', "schema: None; accepted: 'stochgeom/certificate/1'"),
        (b'{"schema": 1}', "schema: 1; accepted: 'stochgeom/certificate/1'"),
        (b'{"schema": ["stochgeom/certificate/1"]}', "schema: ['stochgeom/certificate/1']; "),
        (b'{"schema": "stochgeom/certificate/2"}', "schema: 'stochgeom/certificate/2'; accepted"),
        (b'{"schema": "stochgeom/certificate/1 "}', "schema: 'stochgeom/certificate/1 '; "),
        (b'{"schema": "stochgeom/plan/1"}', "schema: 'stochgeom/plan/1'; accepted"),
        (
            b'{"type": "Polygon", "coordinates": [[[0, 0], [3, 0], [3, 2], [0, 0]]]}',
            "schema: None; accepted: 'stochgeom/certificate/1'",
        ),
        (b'{"schema": "stochgeom/certificate/1"}', "part: missing, or not a JSON dict"),
    ],
    ids=reprlib.repr,
)
def test_what_is_no_certificate(capsys, tmp_path, data, message):
    path = tmp_path / "plan.json"
    path.write_bytes(data)
    assert refusal(capsys, path).startswith(message)
    assert refusal_of(data).startswith(message)


@pytest.mark.parametrize("share", range(1, 100))
def test_a_truncated_file(share):
    data = TEXT.encode()
    assert refusal_of(data[: len(data) * share // 100]).startswith("file: not JSON: ")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('"turns": 0', '"turns": -0', "-0 is no short whole number"),
        ('"turns": 0', '"turns": 00', "Expecting ',' delimiter"),
        ('"turns": 0', '"turns": +0', "Expecting value"),
        ('"turns": 0', '"turns": NaN', "NaN is no short whole number"),
        ('"turns": 0', '"turns": Infinity', "Infinity is no short whole number"),
        ('"turns": 0', '"turns": -Infinity', "-Infinity is no short whole number"),
        ('"turns": 0', '"turns": 1' + 10**5 * "0", "10000000000000000000 is no short whole"),
        ('"name": "4gon"', '"name": NaN', "NaN is no short whole number"),
        ('"optimal_steps"', '"schema"', "a key occurs twice in one object"),
        ('"low"', '"high"', "a key occurs twice in one object"),
    ],
)
def test_numbers_and_keys_that_only_python_reads(old, new, message):
    assert old in TEXT
    found = refusal_of(TEXT.replace(old, new, 1).encode())
    assert found.startswith(f"file: not JSON: {message}")


def test_the_text_of_a_key_may_be_escaped_but_not_repeated():
    twice = TEXT.replace('"hull"', '"h\\u0075ll": [], "hull"', 1)
    assert refusal_of(twice.encode()) == "file: not JSON: a key occurs twice in one object"


# --- documents -----------------------------------------------------------------------------------


def changed(place, value, original=CERTIFICATE):
    """Return a certificate with another value at a place such as ``plan.steps``."""
    document = copy.deepcopy(original)
    node = document
    *path, last = [int(key) if key.isdigit() else key for key in place.split(".")]
    for key in path:
        node = node[key]
    node[last] = value
    return document


def nested(depth):
    """Return lists inside each other, made without recursion."""
    value = []
    for _ in range(depth):
        value = [value]
    return value


@pytest.mark.parametrize("value", [7, True, 1.5, [], {}, ["4gon"], nested(5000)], ids=reprlib.repr)
def test_a_name_is_text_or_null(value):
    with pytest.raises(NoCertificateError, match=r"^part\.name: .* is neither text nor null$"):
        checker.check(changed("part.name", value))


@pytest.mark.parametrize(
    ("place", "value", "message"),
    [
        ("part", [], "part: missing, or not a JSON dict"),
        ("part.vertices", {}, "part.vertices: missing, or not a JSON list"),
        ("part.vertices.2", "1", "part.vertices.2: '1' is no pair"),
        ("part.vertices.2", ["1"], "part.vertices.2: ['1'] is no pair"),
        ("part.vertices.2", ["1", "2", "3"], "part.vertices.2: ['1', '2', '3'] is no pair"),
        ("part.vertices.2", {"0": "1", "1": "2"}, "part.vertices.2: ['0', '1'] is no pair"),
        ("part.vertices.2.0", 7, "part.vertices.2: 7 is not p or p/q in lowest terms, as text"),
        ("part.vertices.2.0", "2/4", "part.vertices.2: '2/4' is not p or p/q in lowest terms"),
        ("part.vertices.2.0", "9" * 10**5, "part.vertices.2: '999999999999...9999999999999' is"),
        ("part.vertices.2.0", nested(5000), "part.vertices.2: [[[[[[[...]]]]]]] is not"),
        ("cost_ratio", 1, "cost_ratio: missing, or not a JSON str"),
        ("cost_ratio", "0.5", "cost_ratio: '0.5' is not p or p/q"),
        ("plan", None, "plan: missing, or not a JSON dict"),
        ("plan.steps", True, "plan.steps: missing, or not a JSON int"),
        ("plan.steps", "4", "plan.steps: missing, or not a JSON int"),
        ("plan.actions", {}, "plan.actions: missing, or not a JSON list"),
        ("plan.actions.2", None, "plan.actions.2.angle: missing, or not a JSON dict"),
        ("plan.actions.2", 3, "plan.actions.2.angle: missing, or not a JSON dict"),
        ("plan.actions.2", ["angle"], "plan.actions.2.angle: missing, or not a JSON dict"),
        ("plan.actions.2.angle", "71", "plan.actions.2.angle: missing, or not a JSON dict"),
        ("plan.actions.2.angle", {}, "plan.actions.2.angle.direction: missing"),
        ("plan.actions.2.angle.turns", "0", "plan.actions.2.angle.turns: missing"),
        ("plan.actions.2.angle.turns", "71/360", "plan.actions.2.angle.turns: missing"),
        ("plan.actions.2.angle.turns", 0.5, "plan.actions.2.angle.turns: missing"),
        ("plan.actions.2.angle.direction", "ab", "plan.actions.2.angle.direction: missing"),
        ("plan.actions.2.angle.direction", [], "plan.actions.2.angle: its direction is not two"),
        ("plan.actions.2.angle.direction", ["1"], "plan.actions.2.angle: its direction is not"),
        ("plan.actions.2.angle.direction", ["0", "0"], "plan.actions.2.angle: its direction is"),
        ("plan.actions.2.angle.direction", ["1/2", "1"], "plan.actions.2.angle: its direction is"),
        ("plan.actions.2.angle.direction", ["1", "2", "3"], "plan.actions.2.angle: its direction"),
        ("plan.actions.2.angle.direction", [1, 2], "plan.actions.2.angle: 1 is not p or p/q"),
    ],
    ids=reprlib.repr,
)
def test_fields_of_the_wrong_kind(place, value, message):
    with pytest.raises(NoCertificateError) as caught:
        checker.check(changed(place, value))
    assert str(caught.value).startswith(message)


@pytest.mark.parametrize(
    ("place", "value", "message"),
    [
        ("part.vertices", [], "part: the outline has no area"),
        ("part.vertices", [["1", "2"]], "part: the outline has no area"),
        ("part.vertices", [["0", "0"], ["1", "2"], ["2", "4"]], "part: the outline has no area"),
        ("cost_ratio", "-1", "cost_ratio: negative"),
        ("cost_ratio", "2", "costs.0.numerator: claimed '2', but '3' holds"),
        ("plan.steps", 0, "plan.steps: not in 1 to 4"),
        ("plan.steps", -1, "plan.steps: not in 1 to 4"),
        ("plan.steps", 5, "plan.steps: not in 1 to 4"),
        ("plan.steps", 3, "plan.actions: 4 of them in 3 steps"),
        ("plan.actions", CERTIFICATE["plan"]["actions"][:3], "plan.actions: 3 of them in 4 steps"),
        ("plan.actions.2.angle.turns", 10**17, "plan.actions.2.angle: outside (low, high]"),
        ("hull", [0, 1, 2], "hull: claimed [0, 1, 2], but [0, 1, 2, 3] holds"),
        ("hull.0", nested(5000), "hull.0: claimed [[[[[[[...]]]]]]], but 0 holds"),
        ("hull.0", float("nan"), "hull.0: claimed nan, but 0 holds"),
        ("action", "push", "action: claimed 'push', no squeeze or push-grasp"),
        ("extra", 1, "document: claimed ['schema', 'action', 'part', "),
    ],
    ids=reprlib.repr,
)
def test_claims_that_fail_are_named(place, value, message):
    with pytest.raises(InvalidClaimError) as caught:
        checker.check(changed(place, value))
    assert not isinstance(caught.value, NoCertificateError)
    assert str(caught.value).startswith(message)


@pytest.mark.parametrize(
    ("place", "value", "message"),
    [
        ("part.center_of_mass", None, "part.center_of_mass: missing, or not a JSON list"),
        ("part.center_of_mass", {"0": "1", "1": "2"}, "part.center_of_mass: missing"),
        ("part.center_of_mass", [], "part.center_of_mass: [] is no pair"),
        ("part.center_of_mass", ["28"], "part.center_of_mass: ['28'] is no pair"),
        ("part.center_of_mass", ["28", "32", "0"], "part.center_of_mass: ['28', '32', '0'] is no"),
        ("part.center_of_mass.0", 28, "part.center_of_mass: 28 is not p or p/q in lowest terms"),
        ("part.center_of_mass.0", "28.0", "part.center_of_mass: '28.0' is not p or p/q"),
        ("part.center_of_mass.0", "56/2", "part.center_of_mass: '56/2' is not p or p/q"),
        ("part.center_of_mass.1", nested(5000), "part.center_of_mass: [[[[[[[...]]]]]]] is not"),
        ("part.center_of_mass.1", "9" * 10**5, "part.center_of_mass: '9999999"),
        ("part.vertices", {}, "part.vertices: missing, or not a JSON list"),
    ],
    ids=reprlib.repr,
)
def test_fields_of_the_wrong_kind_where_a_part_is_pushed(place, value, message):
    with pytest.raises(NoCertificateError) as caught:
        checker.check(changed(place, value, PUSHED))
    assert str(caught.value).startswith(message)


@pytest.mark.parametrize(
    ("place", "value", "message"),
    [
        ("action", "push", "action: claimed 'push', no squeeze or push-grasp"),
        ("action", None, "action: claimed None, no squeeze or push-grasp"),
        ("action", ["push-grasp"], "action: claimed ['push-grasp'], no squeeze or push-grasp"),
        ("action", "squeeze", "plan.actions.1.angle: outside (low, high]"),
        ("part.center_of_mass", ["52", "58"], "part.center_of_mass: not strictly inside the hull"),
        ("part.center_of_mass", ["26", "113/2"], "part.center_of_mass: not strictly inside"),
        ("part.center_of_mass", ["-28", "-32"], "part.center_of_mass: not strictly inside the"),
        ("part.center_of_mass", ["28", "33"], "push.breaks.0.angle.direction.0: claimed "),
        ("part.vertices", [], "part: the outline has no area"),
        ("part.vertices.0", ["52", "59"], "push.breaks."),
        ("push", None, "push: claimed None, but ['period', 'breaks', 'values'] holds"),
        ("push.breaks", [], "push.breaks: claimed [], but [{"),
        ("push.breaks.1.vertex", "1", "push.breaks.1.vertex: claimed '1', but "),
        ("push.values.1.edge", [0], "push.values.1.edge: claimed [0], but ["),
        ("push.period.turns", 2, "push.period.turns: claimed 2, but 1 holds"),
        ("squeeze.values.0.upper", [], "squeeze.values.0.upper: claimed [], but "),
        ("breaks.0.push_break", True, "breaks.0.push_break: claimed True, but 0 holds"),
        ("values.0.squeeze_value", 5, "values.0.squeeze_value: claimed 5, but 1 holds"),
        ("plan.steps", 5, "plan.steps: not in 1 to 4"),
        ("plan.actions.2.angle.turns", 10**17, "plan.actions.2.angle: outside (low, high]"),
    ],
    ids=reprlib.repr,
)
def test_claims_about_pushes_that_fail_are_named(place, value, message):
    with pytest.raises(InvalidClaimError) as caught:
        checker.check(changed(place, value, PUSHED))
    assert not isinstance(caught.value, NoCertificateError)
    assert str(caught.value).startswith(message)


def test_a_squeeze_certificate_that_says_push_grasp():
    with pytest.raises(NoCertificateError) as caught:
        checker.check(changed("action", "push-grasp"))
    assert str(caught.value) == "part.center_of_mass: missing, or not a JSON list"


def test_another_schema_is_no_certificate_whatever_it_holds(capsys, tmp_path):
    path = tmp_path / "plan.json"
    path.write_text(json.dumps({**CERTIFICATE, "schema": "stochgeom/certificate/2"}))
    assert refusal(capsys, path).startswith("schema: 'stochgeom/certificate/2'; accepted: ")


def test_an_outline_of_many_points_on_a_line():
    outline = [[str(k), str(k)] for k in range(10_000)]
    with pytest.raises(InvalidClaimError, match="no area"):
        checker.check(changed("part.vertices", outline))


# --- anything ------------------------------------------------------------------------------------

scalars = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-3, 9),
    st.integers(-(2**62), 2**62),
    st.floats(),
    st.text(max_size=5),
    st.sampled_from(["0", "1", "-1", "1/2", "2/4", "-0", "squeeze", checker.SCHEMA]),
)
keys = st.one_of(st.text(max_size=3), st.sampled_from(sorted(CERTIFICATE)))
anything = st.recursive(
    scalars,
    lambda inner: st.one_of(st.lists(inner, max_size=4), st.dictionaries(keys, inner, max_size=4)),
    max_leaves=12,
)


def places(node, path=()):
    """Yield the paths to all nodes of a document."""
    yield path
    if isinstance(node, dict | list):
        for key, value in node.items() if isinstance(node, dict) else enumerate(node):
            yield from places(value, (*path, key))


PLACES = [place for place in places(CERTIFICATE) if place]
PUSHED_PLACES = [place for place in places(PUSHED) if place]


def replaced(document, place, value):
    document = copy.deepcopy(document)
    node = document
    for key in place[:-1]:
        node = node[key]
    node[place[-1]] = value
    return document


def restored(document, original):
    """Return the text of a valid document, its free fields (name, nominal angles) put back."""
    document = copy.deepcopy(document)
    document["part"]["name"] = original["part"]["name"]
    nominal = zip(document["plan"]["actions"], original["plan"]["actions"], strict=True)
    for mine, given_angle in nominal:
        mine["angle"] = given_angle["angle"]
    return json.dumps(document)


def assert_refused_or_true(document, original=CERTIFICATE):
    """Only the checker's own two errors come out of it, whatever goes in."""
    try:
        checker.check(document)
    except InvalidClaimError as error:
        message = str(error)
    else:
        message = "valid"
        assert isinstance(document["part"]["name"], str | None)
        assert restored(document, original) == json.dumps(original)
    assert message.isascii()
    assert "\n" not in message
    assert 0 < len(message) < 1000


@given(anything)
def test_any_document_is_refused(document):
    assert_refused_or_true(document)


@given(st.dictionaries(st.sampled_from(sorted(CERTIFICATE)), anything))
def test_any_document_with_the_right_keys_is_refused(fields):
    with pytest.raises(InvalidClaimError):
        checker.check(fields)


@given(st.sampled_from(PLACES), anything)
def test_anything_anywhere_is_refused(place, value):
    """At every place, what is not what was there is found (and raises nothing else)."""
    assert_refused_or_true(replaced(CERTIFICATE, place, value))


@given(st.sampled_from(PUSHED_PLACES), anything)
def test_anything_anywhere_is_refused_where_a_part_is_pushed(place, value):
    assert_refused_or_true(replaced(PUSHED, place, value), PUSHED)


@given(st.lists(st.tuples(st.sampled_from(PLACES), anything), min_size=2, max_size=4))
def test_several_things_at_once_are_refused(changes):
    document = CERTIFICATE
    for place, value in changes:
        try:
            document = replaced(document, place, value)
        except (LookupError, TypeError):  # the change before took the place away
            continue
    assert_refused_or_true(document)


@given(st.binary(max_size=60))
def test_any_bytes_are_refused(data):
    with pytest.raises(NoCertificateError):
        checker.load(data)


@given(st.integers(0, len(TEXT) - 1), st.integers(0, 255))
def test_a_changed_byte_is_refused(position, byte):
    """Unless it stands in the name, or is white space for white space."""
    data = bytearray(TEXT.encode())
    data[position] = byte
    try:
        document = checker.load(bytes(data))
    except NoCertificateError:
        return
    assert_refused_or_true(document)


def test_no_answer_depends_on_the_environment(tmp_path):
    """A limit of Python's on long numbers, switched off, changes nothing."""
    path = tmp_path / "plan.json"
    path.write_bytes(TEXT.replace('"turns": 0', '"turns": 1' + 10**5 * "0", 1).encode())
    environment = {**os.environ, "PYTHONINTMAXSTRDIGITS": "0"}
    result = subprocess.run(
        [sys.executable, "-S", str(checker.__file__), str(path)],
        env=environment,
        capture_output=True,
        timeout=60,
        check=False,
    )
    assert result.returncode == 2
    assert b"is no short whole number" in result.stderr
