"""`stochgeom.feeding.field_certificate_checker`: its numbers and angles, against the library's."""

from __future__ import annotations

import ast
import json
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import flint
import pytest
from gmpy2 import mpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from stochgeom.errors import NumberLimitError
from stochgeom.exact.algebraic import Algebraic
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.balls import working_precision
from stochgeom.exact.directions import simplest_fraction
from stochgeom.exact.forms import sign_of_form
from stochgeom.exact.surds import rational_bounds, scalar_text
from stochgeom.feeding import certificate_checker, certified_transfer
from stochgeom.feeding import field_certificate_checker as checker
from stochgeom.feeding.certificate_checker import InvalidClaimError, NoCertificateError
from stochgeom.feeding.planner import FeedingProblem, plan_feeding
from stochgeom.geometry.part import Part
from tests.strategies import FIELDS, field_angles, field_numbers, field_parts, fields, hulls

FEW = max(20, settings().max_examples // 5)
SOURCE = Path(checker.__file__)

READERS = {field: checker.Reader(field.description()) for field in FIELDS}


def numbers_of(field, *values):
    """Return numbers of the library as the checker's, scaled up by one whole number."""
    reader = READERS[field]
    vectors = [reader.read(scalar_text(value), "here") for value in values]
    pairs = list(zip(vectors[::2], vectors[1::2], strict=True))
    return [number for corner in reader.whole(pairs) for number in corner[1:]]


def angle_of(field, angle):
    """Return an angle of the library as the checker's."""
    return READERS[field].read_angle(certified_transfer.angle_claim(angle), "here")


# --- numbers -------------------------------------------------------------------------------------


@settings(max_examples=FEW)
@given(fields.flatmap(lambda f: st.tuples(st.just(f), *[field_numbers(f)] * 4)))
def test_signs_are_those_of_the_library(drawn):
    field, *values = drawn
    a, b, c, d = numbers_of(field, *values)
    u, v, w, x = values
    assert (a.sign(), b.sign()) == (u.sign(), v.sign())
    assert (a - b).sign() == (u - v).sign()
    assert (a * d - b * c).sign() == (u * x - v * w).sign()
    assert (a < b, a <= b, a == b, a >= b, a > b) == (u < v, u <= v, u == v, u >= v, u > v)
    assert ((a + b) * (a - b) - (a * a - b * b)).sign() == 0


@pytest.mark.parametrize("field", FIELDS, ids=str)
def test_numbers_that_are_nearly_zero(field):
    """Powers of q g - p for a close fraction p / q: below the first enclosures, but no zeros."""
    g = field_root(field)
    near = simplest_fraction(*rational_bounds(g, 160))
    p, q = int(near.numerator), int(near.denominator)
    a, b = numbers_of(field, g, 1 + 0 * g)
    small = a * q - b * p
    power = small * small * small
    value, error = power.enclose(checker.START_BITS)
    assert abs(value) <= error
    assert power.sign() == (g * q - p).sign() != 0
    # The same number by another way, and one that differs from it by 1.
    again = small * small * (a * q) - small * small * (b * p)
    assert (power - again).sign() == 0
    assert (power - again + 1).sign() == 1


def field_root(field):
    """Return g."""
    return Algebraic(field, [0, 1])


@given(st.integers(1, 2000), st.integers(2, 1000), st.sampled_from([128, 512, 4096]))
@settings(max_examples=FEW)
def test_cosines_are_off_by_less_than_two(k, quarter, bits):
    w = 4 * quarter
    k = max(1, k % (w // 2 + 1))
    with working_precision(bits + 100):
        exact = 2 * flint.arb.cos_pi_fmpq(flint.fmpq(2 * k, w)) * flint.arb(2) ** bits
        assert abs(exact - checker.twice_cosine(k, w, bits)) < 2


@pytest.mark.parametrize("text", ["0", "1", "-1/2", "sqrt(6)", "-sqrt(6)", "2/3 - 5*sqrt(6)"])
def test_numbers_in_their_one_form(text):
    assert checker.Reader({"square root of": 6}).read(text, "here") is not None


OTHER_FORMS = """\
-
0 + sqrt(6)
1*sqrt(6)
0*sqrt(6)
-0
2/4
1/0
1.5
+1
--1
(1)
1 +
1 - 0
1 + 1
1 + + 2
1 + -2
1+sqrt(6)
sqrt(6) + 1
sqrt(6) + sqrt(6)
1 - sqrt(6) +
1 * sqrt(6)
sqrt(6)*2
2sqrt(6)
2*
*sqrt(6)
sqrt(6)^2
sqrt(7)
g""".splitlines()


@pytest.mark.parametrize(
    "text",
    [*OTHER_FORMS, "1 ", " 1", " ", "", 1, None, []],
    ids=repr,
)
def test_other_forms_are_refused(text):
    with pytest.raises(NoCertificateError, match=r"^here: "):
        checker.Reader({"square root of": 6}).read(text, "here")


@settings(max_examples=FEW)
@given(fields.flatmap(lambda f: st.tuples(st.just(f), field_numbers(f))))
def test_every_number_of_the_library_can_be_read(drawn):
    field, value = drawn
    a, b = numbers_of(field, value, 0 * field_root(field) + 1)
    assert (a > b) == (value > 1)


# --- angles --------------------------------------------------------------------------------------

two_angles = fields.flatmap(lambda f: st.tuples(st.just(f), field_angles(f), field_angles(f)))


@settings(max_examples=FEW)
@given(two_angles)
def test_sums_and_order_of_angles(drawn):
    field, a, b = drawn
    assume(is_over(field, a) and is_over(field, b))
    x, y = angle_of(field, a), angle_of(field, b)
    assert certificate_checker.compare(x, y) == a.compare(b)
    for found, expected in (
        (certificate_checker.add(x, y), a + b),
        (certificate_checker.sub(x, y), a - b),
    ):
        assert certificate_checker.compare(found, angle_of(field, expected)) == 0


def is_over(field, angle):
    return (angle.turn_part * 2 * field.unity).denominator == 1


@settings(max_examples=FEW)
@given(two_angles, st.fractions(-1, 1, max_denominator=50))
def test_an_angle_that_is_no_direction_over_the_field_has_its_place(drawn, turns):
    """Nominal angles may be any rational number of turns; they tie with nothing else."""
    field, a, _ = drawn
    assume(is_over(field, a))
    nominal = Angle.from_turns(turns)
    expected = a.compare(nominal)
    assert expected != 0 or is_over(field, nominal)
    assert certificate_checker.compare(angle_of(field, a), angle_of(field, nominal)) == expected


@settings(max_examples=FEW)
@given(two_angles, st.sampled_from([64, 256]))
def test_enclosures_of_angles(drawn, bits):
    field, angle, _ = drawn
    assume(is_over(field, angle))
    found = checker.in_eighths(angle_of(field, angle), bits)
    with working_precision(bits + 200 + field.bits):
        assert abs(angle.ball() * 8 * flint.arb(2) ** bits - found) < 4


@pytest.mark.parametrize(
    ("claimed", "words"),
    [
        (None, "is no angle"),
        ({"turns": 0}, "is no angle"),
        ({"turns": 0, "direction": ["1", "0"], "note": ""}, "is no angle"),
        ({"turns": 0, "direction": ["1"]}, "is no pair"),
        ({"turns": 0, "direction": ["0", "0"]}, "is zero"),
        ({"turns": "2", "direction": ["1", "0"]}, "whole turns are no text"),
        ({"turns": 0.5, "direction": ["1", "0"]}, "not p or p/q"),
        ({"turns": True, "direction": ["1", "0"]}, "not p or p/q"),
        ({"turns": 0, "direction": [1, 0]}, "no text of a number"),
    ],
    ids=str,
)
def test_what_is_no_angle(claimed, words):
    with pytest.raises(NoCertificateError, match=words):
        checker.Reader({"square root of": 6}).read_angle(claimed, "here")


# --- costs ---------------------------------------------------------------------------------------


@settings(max_examples=FEW // 2)
@given(two_angles, st.fractions(1, 12, max_denominator=6), st.fractions(1, 12, max_denominator=6))
def test_costs_compare_as_in_the_library(drawn, p, q):
    field, a, b = drawn
    a, b = a.reduced(), b.reduced()
    assume(is_over(field, a) and is_over(field, b) and a and b)
    try:
        expected = sign_of_form(0, [(mpq(p), b), (-mpq(q), a)])
    except NumberLimitError:
        return
    sign = READERS[field].cost_sign
    x, y = angle_of(field, a), angle_of(field, b)
    assert sign(p, x, q, y) == expected
    assert sign(q, y, p, x) == -expected
    assert sign(p, x, p, x) == 0


@pytest.mark.parametrize("field", FIELDS, ids=str)
def test_structural_ties_of_cost(field):
    """Twice and three times an irrational angle, rational turns, and what is nearly as wide."""
    sign = READERS[field].cost_sign
    g = Angle(0, (20 + field_root(field), 3))
    unit = Angle.from_turns(mpq(1, 2 * field.unity))
    for part, tiny in ((g, Angle(0, (10**40, 1))), (unit, g * 1 - g + Angle(0, (10**40, 1)))):
        two, three = angle_of(field, part * 2), angle_of(field, part * 3)
        more = angle_of(field, part * 3 + tiny)
        assert sign(Fraction(2), two, Fraction(3), three) == 0
        assert sign(Fraction(2), two, Fraction(3), more) == 1
        assert sign(Fraction(3), more, Fraction(2), two) == -1
    # The multipliers are huge, and the widths are not: nothing is multiplied out.
    c = 10**200
    assert sign(Fraction(c), angle_of(field, g), Fraction(c + 1), angle_of(field, g)) == -1
    assert ZERO < g * 3 < FULL_TURN


# --- certificates --------------------------------------------------------------------------------


@settings(max_examples=max(10, FEW // 6))
@given(field_parts(), st.sampled_from(["squeeze", "push-grasp"]), st.data())
def test_certificates_of_all_parts_are_valid(part, action, data):
    problem = FeedingProblem(part, action)
    steps = data.draw(st.integers(1, problem.geometric_plan().steps))
    document = json.loads(json.dumps(problem.plan_of(steps).certificate()))
    assert document["schema"] == checker.SCHEMA
    checker.check(document)


@settings(max_examples=max(10, FEW // 6))
@given(hulls(), st.sampled_from(["sqrt(2)", "1 + sqrt(3)", "sqrt(7)/5", "3 - sqrt(5)"]))
def test_scaled_into_a_field_a_part_has_the_same_plan(part, factor):
    """Degenerate cases are common: parallel edges, ties of widths and of costs."""
    rational = plan_feeding(part).certificate()
    document = plan_feeding(part.scale(factor)).certificate()
    checker.check(document)
    for key in ("hull", "breaks", "values", "preimages", "costs", "plan"):
        assert document[key] == rational[key]


def test_a_claim_that_is_nearly_right():
    document = plan_feeding(Part.regular(7)).certificate()
    document["period"] = {"turns": "1/14", "direction": [str(10**40), "1"]}
    with pytest.raises(InvalidClaimError) as caught:
        checker.check(document)
    assert str(caught.value) == (
        "period: claimed another angle as near, but about 25.7142857 degrees holds"
    )


@pytest.mark.parametrize("n", [3, 5, 6, 7, 8, 10, 12, 16, 25, 30, 97, 100])
def test_certificates_of_regular_polygons_are_valid(n):
    for action in ("squeeze", "push-grasp"):
        document = plan_feeding(Part.regular(n), action=action).certificate()
        checker.check(document)
        document["period"] = {"turns": "1/1000", "direction": ["1", "0"]}
        with pytest.raises(InvalidClaimError, match=r"^period: claimed about 0\.36 degrees, but"):
            checker.check(document)


def test_only_numbers_of_the_field_are_ever_zero(monkeypatch):
    """Beside a nominal angle of 3/82 turns, a zero would take the degrees of both fields."""
    vertices = list(Part.regular(7).vertices)
    vertices[1] = tuple(x * mpq(9, 10) for x in vertices[1])
    document = plan_feeding(Part(vertices)).certificate()
    document["plan"]["actions"][2]["angle"] = {"turns": "3/82", "direction": ["1", "0"]}
    zeros, decide = [], checker.Number.sign

    def sign(number):
        found = decide(number)
        zeros.extend([number.field.degree] * (found == 0))
        return found

    monkeypatch.setattr(checker.Number, "sign", sign)
    checker.check(document)
    assert zeros
    assert max(zeros) <= checker.cosines(28).degree == 6


def test_a_rational_certificate_is_taken_as_well():
    document = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)]).certificate()
    checker.check(checker.load(json.dumps(document).encode()))
    document["schema"] = checker.SCHEMA
    data = json.dumps(document).encode()
    with pytest.raises(NoCertificateError, match="schema: 'stochgeom/certificate/2'; accepted"):
        certificate_checker.load(data)
    with pytest.raises(NoCertificateError, match=r"part\.field: no object of one entry"):
        checker.check(document)


# --- by itself -----------------------------------------------------------------------------------


def test_it_imports_the_standard_library_and_the_other_checker_only():
    tree = ast.parse(SOURCE.read_text(encoding="utf-8"))
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
    others = {name for name in found if name.partition(".")[0] not in sys.stdlib_module_names}
    assert others == {"stochgeom.feeding.certificate_checker", "certificate_checker"}


def test_both_files_alone(tmp_path):
    for path in (SOURCE, Path(certificate_checker.__file__)):
        (tmp_path / path.name).write_bytes(path.read_bytes())

    def run(document):
        (tmp_path / "plan.json").write_text(json.dumps(document))
        # -E, -s, -S: no environment, no installed packages; the folder of the script only.
        command = [sys.executable, "-E", "-s", "-S", SOURCE.name, "plan.json"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout, done.stderr

    document = plan_feeding(Part.regular(5)).certificate()
    assert run(document) == (0, "valid\n", "")
    assert run(plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)]).certificate()) == (0, "valid\n", "")
    document["values"][0]["lower"].reverse()
    code, out, err = run(document)
    assert (code, err) == (1, "")
    assert out.startswith("invalid: values.0.lower.0: claimed ")
    document["part"]["field"] = {"regular polygon": 10}
    code, out, err = run(document)
    assert (code, out) == (2, "")
    assert err == (
        "no certificate: part.field: 'regular polygon 10' is no field by its proper name\n"
    )
