"""`stochgeom.feeding.certificate_checker`: its own arithmetic, against the library's.

The checker must not import the library; here the two are set side by side.
"""

from __future__ import annotations

import ast
import json
import math
import subprocess
import sys
from fractions import Fraction
from functools import reduce
from pathlib import Path

import flint
import pytest
from gmpy2 import mpq
from hypothesis import assume, given
from hypothesis import strategies as st

from stochgeom.exact.angles import EIGHTH_TURN, FULL_TURN, ZERO, Angle
from stochgeom.exact.balls import working_precision
from stochgeom.exact.forms import sign_of_form
from stochgeom.feeding import certificate_checker as checker
from stochgeom.feeding.certificate_checker import InvalidClaimError, NoCertificateError
from stochgeom.feeding.planner import plan_feeding
from stochgeom.feeding.preimages import preimages
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.hull import convex_hull
from stochgeom.geometry.points import Points
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import (
    angles,
    circle_parts,
    directions,
    large_directions,
    nearly_regular,
    parts,
    points,
    rational_parts,
    rational_points,
)

SOURCE = Path(checker.__file__)
TREE = ast.parse(SOURCE.read_text(encoding="utf-8"))

any_part = st.one_of(parts(), rational_parts(), circle_parts(), nearly_regular())
lifted = angles(rational_turns=False)
eighths = st.sampled_from([1, 2, 4, 8])


def plain(angle):
    """Return the checker's notation for an angle of the library."""
    x, y = angle.direction
    assert angle.turn_part.denominator == 1
    return int(angle.turn_part), int(x), int(y)


def library(angle):
    """Return the library's angle for one of the checker's."""
    return Angle(angle[0], angle[1:])


def hull_of(outline):
    return checker.convex_hull(checker.whole([(Fraction(x), Fraction(y)) for x, y in outline]))


def plain_hull(part):
    return hull_of(part.vertices)


# --- angles --------------------------------------------------------------------------------------


@given(lifted, lifted)
def test_sums_differences_and_order(a, b):
    assert checker.add(plain(a), plain(b)) == plain(a + b)
    assert checker.sub(plain(a), plain(b)) == plain(a - b)
    assert checker.compare(plain(a), plain(b)) == a.compare(b)
    assert checker.compare(plain(a), plain(a)) == 0


@given(lifted, eighths)
def test_whole_eighths_and_remainders(a, e):
    count, _ = divmod(a, EIGHTH_TURN)
    assert checker.floor_eighths(plain(a)) == count
    assert checker.remainder(plain(a), e) == plain(a % (e * EIGHTH_TURN))


@pytest.mark.parametrize("n", range(-17, 18))
def test_eighths_of_a_turn(n):
    assert checker.eighths(n) == plain(EIGHTH_TURN * n)
    assert checker.floor_eighths(checker.eighths(n)) == n


# --- hull, extrema, squeeze function -------------------------------------------------------------


@given(st.one_of(st.lists(points, max_size=9), st.lists(rational_points, max_size=6)))
def test_hulls_are_those_of_the_library(outline):
    pairs = [(Fraction(x), Fraction(y)) for x, y in outline]
    distinct = list(dict.fromkeys(pairs))
    (x0, y0), *others = distinct or [(0, 0)]
    if all(
        (x - x0) * (v - y0) == (y - y0) * (u - x0) for x, y in others for u, v in others
    ):  # on one line
        with pytest.raises(InvalidClaimError, match="part: the outline has no area"):
            checker.convex_hull(checker.whole(pairs))
        return
    found = [k for k, _, _ in checker.convex_hull(checker.whole(pairs))]
    expected = [
        pairs.index(distinct[int(k)]) for k in convex_hull(Points.from_pairs(distinct)).indices
    ]
    start = expected.index(min(expected))
    assert found == expected[start:] + expected[:start]


@given(any_part)
def test_extrema_are_those_of_the_library(part):
    diameter = DiameterFunction(part)
    maxima, minima = checker.extrema(plain_hull(part))
    assert maxima == [plain(angle) for angle in diameter.maxima]
    assert minima == [plain(angle) for angle in diameter.minima]


@given(any_part, lifted, st.integers(-9, 9))
def test_the_squeeze_function_is_that_of_the_library(part, theta, k):
    ours, theirs = squeeze_function(part), checker.squeeze(plain_hull(part))[0]
    assert theirs.breaks == [plain(angle) for angle in ours.breaks]
    assert theirs.values == [plain(angle) for angle in ours.values]
    assert theirs.period == plain(ours.period)
    for angle in (theta, ours.lifted_breaks[k], ours.lifted_values[k]):
        before = ours.lifted_values[ours.step_before(angle)]
        assert theirs.apply(plain(angle)) == plain(ours(angle))
        assert theirs.apply(plain(angle), from_left=True) == plain(before)


@given(any_part)
def test_preimages_are_those_of_the_library(part):
    found = checker.preimages(checker.squeeze(plain_hull(part))[0])
    for ours, theirs in zip(preimages(squeeze_function(part)), found, strict=True):
        assert theirs["steps"] == ours.steps
        assert (theirs["first"], theirs["last"]) == (ours.first, ours.last)
        assert library(theirs["start"]) == ours.arc.start
        assert library(theirs["width"]) == ours.width
        assert library(theirs["image_start"]) == ours.image.start
        assert library(theirs["image_width"]) == ours.image_width


# --- costs: signs of n b - m a -------------------------------------------------------------------

WHOLE_EIGHTHS = [EIGHTH_TURN * n for n in range(1, 9)]
TINY = [Angle(0, (2**k, 1)) for k in (20, 60, 70, 130, 300)]
"""By how much a tie fails: at 64 bits it shows, or it does not."""

widths = st.one_of(
    directions.map(lambda p: Angle(0, p)),
    large_directions.map(lambda p: Angle(0, p)),
    st.sampled_from(WHOLE_EIGHTHS + TINY),
).filter(lambda angle: ZERO < angle <= FULL_TURN)
"""Widths of preimages."""

numerators = st.fractions(Fraction(1, 1000), 60, max_denominator=1000)
"""i + c."""


def exact_cost_sign(p, a, q, b):
    """Return the sign of p / a - q / b by the library: that of p b - q a."""
    return sign_of_form(0, [(mpq(p), b), (-mpq(q), a)])


def found_cost_sign(p, a, q, b):
    return checker.cost_sign(Fraction(p), plain(a), Fraction(q), plain(b))


def is_whole_eighths(angle):
    return angle.rational_turns is not None


@given(numerators, widths, numerators, widths)
def test_costs_compare_as_in_the_library(p, a, q, b):
    expected = exact_cost_sign(p, a, q, b)
    assert found_cost_sign(p, a, q, b) == expected
    assert found_cost_sign(q, b, p, a) == -expected
    assert found_cost_sign(p, a, p, a) == 0


@st.composite
def multiples(draw):
    """Angles g and numbers i, j with i g and j g at most 360 degrees."""
    g = draw(widths)
    most = max(k for k in range(1, 10) if k * g <= FULL_TURN)
    return g, draw(st.integers(1, most)), draw(st.integers(1, most))


@given(multiples(), numerators)
def test_structural_ties_of_cost(multiple, unit):
    """i units over i times an angle cost as much as j units over j times that angle."""
    g, i, j = multiple
    assert found_cost_sign(i * unit, g * i, j * unit, g * j) == 0


@given(multiples(), numerators, st.sampled_from(TINY))
def test_near_ties_of_cost(multiple, unit, tiny):
    """The wider angle of the two is the cheaper one, by however little."""
    g, i, j = multiple
    assert found_cost_sign(i * unit, g * i + tiny, j * unit, g * j) == -1
    assert found_cost_sign(i * unit, g * i, j * unit, g * j + tiny) == 1


def test_a_cost_ratio_of_two_hundred_digits():
    """n and m are huge, the widths are small: no multiple is formed."""
    c = 10**200 + 7
    a, b = Angle(0, (3, 1)), Angle(0, (2, 1))
    assert found_cost_sign(1 + c, a, 2 + c, b) == exact_cost_sign(1 + c, a, 2 + c, b) == 1
    # c such that (1 + c) / a and (2 + c) / b differ in the 60th digit only: c = a / (b - a) - 1
    with working_precision(400):
        ratio = (a.ball() / (b - a).ball() - 1).mid()
        mantissa, exponent = ratio.man_exp()
    c = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    for slip in (Fraction(-1, 10**60), 0, Fraction(1, 10**60)):
        expected = exact_cost_sign(1 + c + slip, a, 2 + c + slip, b)
        assert expected != 0
        assert found_cost_sign(1 + c + slip, a, 2 + c + slip, b) == expected


coprime = st.tuples(st.integers(1, 12), st.integers(1, 12)).filter(lambda p: math.gcd(*p) == 1)


class TestTied:
    """Euclid's algorithm on multiples of one angle."""

    @given(coprime, widths, widths)
    def test_it_is_what_adding_up_says(self, multipliers, a, b):
        (n, m), equal = multipliers, None
        assume(not (is_whole_eighths(a) and is_whole_eighths(b)))
        left, right = (reduce(checker.add, [plain(w)] * k) for w, k in ((b, n), (a, m)))
        equal = left == right
        assert checker.tied(n, plain(a), m, plain(b)) is equal

    @given(coprime, widths)
    def test_ties_are_found(self, multipliers, g):
        n, m = multipliers
        assume(not is_whole_eighths(g))
        assert checker.tied(n, plain(g * n), m, plain(g * m))
        assert not checker.tied(n, plain(g * n), m, plain(g * m + TINY[2]))
        assert not checker.tied(n, plain(g * n), m, plain(g * m + EIGHTH_TURN))

    @given(large_directions)
    def test_common_factors_of_directions_mislead_nobody(self, direction):
        """A prime and its conjugate in one direction would cancel: coprime x, y have no both."""
        g = Angle(0, direction)
        assume(not is_whole_eighths(g))
        assert checker.tied(3, plain(g * 3), 2, plain(g * 2))
        assert not checker.tied(2, plain(g * 3), 3, plain(g * 2))

    def test_large_multiples_of_a_small_angle(self):
        g = (0, 10**6, 1)
        n, m = 1000, 999
        a, b = (reduce(checker.add, [g] * k) for k in (n, m))
        assert checker.tied(n, a, m, b)
        assert not checker.tied(n, a, m, checker.add(b, (0, 10**9, 1)))

    def test_huge_multipliers_end_at_once(self):
        """Each subtraction must shorten a direction, so their number is bounded by its digits."""
        assert not checker.tied(10**5000, (0, 3, 1), 10**5000 + 1, (0, 2, 1))
        assert not checker.tied(10**5000 + 1, (0, 1, 0), 1, (0, 2, 1))


class TestEnclosures:
    """`in_eighths` is off by less than 4 units of 2**-bits."""

    @staticmethod
    def error(angle, bits):
        """Return how far off it is, in units, as a ball."""
        with working_precision(2 * bits + 200):
            return (angle.ball() * 8 * flint.arb(2) ** bits) - checker.in_eighths(
                plain(angle), bits
            )

    @given(widths, st.sampled_from([64, 128, 256, 1000]))
    def test_the_bound(self, angle, bits):
        assert abs(self.error(angle, bits)) < 4

    @given(angles(rational_turns=False).filter(lambda angle: angle > ZERO))
    def test_the_bound_for_lifted_angles(self, angle):
        assert abs(self.error(angle, 64)) < 4

    @pytest.mark.parametrize(
        "direction",
        [
            (10**30, 1),
            (10**30, 10**30 - 1),
            (10**30 - 1, 10**30),
            (1, 10**30),
            (-1, 10**30),
            (1 - 10**30, 10**30),
            (-(10**30), 1),
            (10**4000 + 1, 10**4000),
        ],
    )
    def test_near_the_ends_of_an_eighth(self, direction):
        for bits in (64, 4096):
            assert abs(self.error(Angle(0, direction), bits)) < 4

    @given(st.integers(0, 2**128), st.just(2**128))
    def test_arctan(self, t, one):
        """Each term costs less than ten roundings; the spare bits cover 2**60."""
        terms = 40
        with working_precision(400):
            exact = (flint.arb(t) / one).atan() * one
            assert abs(exact - checker.arctan(t, one)) < 10 * terms
        assert 10 * terms * 20 < 2**60


# --- reading -------------------------------------------------------------------------------------


@pytest.mark.parametrize("text", ["0", "1", "-1", "10", "1/2", "-7/3", "10/3", "9" * 5000])
def test_canonical_numbers(text):
    number = checker.rational(text, "here")
    assert checker.text(number) == text
    assert number == Fraction(int(mpq(text).numerator), int(mpq(text).denominator))


@pytest.mark.parametrize(
    "text",
    [
        "",
        " 1",
        "1 ",
        "1\n",
        "+1",
        "-0",
        "00",
        "01",
        "-01",
        "0/1",
        "1/1",
        "2/4",
        "0/5",
        "-0/5",
        "1/-2",
        "1/0",
        "1/02",
        "1/",
        "/2",
        "1 / 2",
        "1.0",
        "1e3",
        "0x10",
        "1_000",
        "١",  # an Arabic digit one
        "½",
        "nan",
        "inf",
        "1" * (checker.MAX_DIGITS + 1),
        1,
        True,
        None,
        1.5,
        [],
        ["1"],
        {},
    ],
    ids=repr,
)
def test_numbers_that_are_not_canonical(text):
    with pytest.raises(NoCertificateError, match=r"^here: .* is not p or p/q in lowest terms"):
        checker.rational(text, "here")


@given(st.fractions(), st.integers(0, 6000))
def test_numbers_of_any_length_are_written(number, digits):
    number += Fraction(10**digits, 3)
    assert checker.text(number) == str(mpq(number))


@pytest.mark.parametrize(
    ("claimed", "message"),
    [
        ({"a": [1, "2"], "b": {"turns": 0, "direction": ["3", "4"]}}, None),
        ({"a": [1, "2"]}, "document: claimed ['a'], but ['a', 'b'] holds"),
        ({"a": [1], "b": {}}, "a: claimed [1], but [1, '2'] holds"),
        ({"a": [1, 2], "b": {}}, "a.1: claimed 2, but '2' holds"),
        ({"a": [True, "2"], "b": {}}, "a.0: claimed True, but 1 holds"),
        ({"a": [1.0, "2"], "b": {}}, "a.0: claimed 1.0, but 1 holds"),
        ({"a": None, "b": {}}, "a: claimed None, but [1, '2'] holds"),
        ({"a": {"0": 1, "1": "2"}, "b": {}}, "a: claimed ['0', '1'], but [1, '2'] holds"),
        ({"a": [1, "2"], "b": {"turns": 0, "direction": ["3", "5"]}}, "b.direction.1: claimed '5'"),
        ({"a": [1, "2"], "b": ["3", "4"]}, "b: claimed ['3', '4'], but"),
        ([], "document: claimed [], but"),
    ],
    ids=str,
)
def test_the_first_difference_is_named(claimed, message):
    true = {"a": [1, "2"], "b": (0, 3, 4)}
    if message is None:
        checker.agree(claimed, true, "document")
        return
    with pytest.raises(InvalidClaimError) as caught:
        checker.agree(claimed, true, "document")
    assert str(caught.value).startswith(message)


# --- by itself -----------------------------------------------------------------------------------


def imported_modules():
    """Return the top-level names of all modules that the checker imports."""
    found = set()
    for node in ast.walk(TREE):
        if isinstance(node, ast.Import):
            found |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0
            found.add(str(node.module).partition(".")[0])
    return found


def code_lines():
    """Count the lines that hold more than a docstring or a comment."""
    documented = (ast.Module, ast.ClassDef, ast.FunctionDef)
    docstrings = {
        line
        for node in ast.walk(TREE)
        if isinstance(node, documented) and ast.get_docstring(node) is not None
        for line in range(node.body[0].lineno, node.body[0].end_lineno + 1)
    }
    lines = enumerate(SOURCE.read_text(encoding="utf-8").splitlines(), start=1)
    return sum(
        number not in docstrings and bool(line.strip()) and not line.strip().startswith("#")
        for number, line in lines
    )


def test_it_imports_the_standard_library_only():
    assert imported_modules() <= sys.stdlib_module_names
    calls = {
        node.func.id
        for node in ast.walk(TREE)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    }
    assert not calls & {"__import__", "exec", "eval", "compile"}


def test_it_can_be_read_in_one_sitting():
    assert code_lines() <= 400


@pytest.fixture(scope="module")
def alone(tmp_path_factory):
    """Return a function that runs a copy of the checker in a folder of its own."""
    folder = tmp_path_factory.mktemp("alone")
    script = folder / "certificate_checker.py"
    script.write_bytes(SOURCE.read_bytes())

    def run(*arguments, data=None):
        if data is not None:
            (folder / "plan.json").write_bytes(data)
            arguments = ("plan.json", *arguments)
        # -I: no environment, no user's packages, not the folder; -S: no installed packages.
        result = subprocess.run(
            [sys.executable, "-I", "-S", script.name, *arguments],
            cwd=folder,
            capture_output=True,
            timeout=60,
            check=False,
        )
        return result.returncode, result.stdout.decode(), result.stderr.decode()

    return run


CERTIFICATE = json.dumps(plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)]).certificate())


class TestAlone:
    """The file by itself: in an empty folder, without the package."""

    def test_a_valid_certificate(self, alone):
        assert alone(data=CERTIFICATE.encode()) == (0, "valid\n", "")

    def test_a_certificate_with_spaces_and_escapes(self, alone):
        spread = json.dumps(json.loads(CERTIFICATE), indent=4).replace('"hull"', '"\\u0068ull"')
        assert alone(data=spread.encode()) == (0, "valid\n", "")

    def test_a_claim_that_fails(self, alone):
        lie = CERTIFICATE.replace('"optimal_steps": 2', '"optimal_steps": 1')
        message = "invalid: optimal_steps: claimed 1, but 2 holds\n"
        assert alone(data=lie.encode()) == (1, message, "")

    @pytest.mark.parametrize("claimed", ["\ud800", "two\nlines", "é", "\x1b[31m", "x" * 10**6])
    def test_what_is_claimed_is_shown_on_one_short_line(self, alone, claimed):
        lie = {**json.loads(CERTIFICATE), "action": claimed}
        code, out, err = alone(data=json.dumps(lie).encode())
        assert (code, err) == (1, "")
        assert out.startswith("invalid: action: claimed ")
        assert out.isascii()
        assert out.count("\n") == 1
        assert len(out) < 200

    @pytest.mark.parametrize(
        ("data", "message"),
        [
            (b"", "no certificate: file: not JSON"),
            (b"\xff", "no certificate: file: not JSON"),
            (b"[]", "no certificate: schema: None; accepted: 'stochgeom/certificate/1'"),
        ],
    )
    def test_no_certificate(self, alone, data, message):
        code, out, err = alone(data=data)
        assert (code, out) == (2, "")
        assert err.startswith(message)
        assert err.count("\n") == 1

    def test_other_arguments(self, alone):
        assert alone()[0] == 2
        assert alone("a", "b")[0] == 2
        assert alone("no such file.json")[0] == 2
        assert alone(".")[0] == 2
        for arguments in ((), ("a", "b"), ("no such file.json",), (".",)):
            _, out, err = alone(*arguments)
            assert out == ""
            assert err.startswith("no certificate: ")
            assert err.count("\n") == 1


def test_the_commands_are_those_of_the_module(tmp_path, capsys):
    """`main` is what the script runs."""
    file = tmp_path / "plan.json"
    file.write_text(CERTIFICATE)
    assert checker.main([str(file)]) == 0
    assert capsys.readouterr() == ("valid\n", "")
    file.write_text(CERTIFICATE.replace('"comparison": 1', '"comparison": -1'))
    assert checker.main([str(file)]) == 1
    assert capsys.readouterr().out == "invalid: costs.0.comparison: claimed -1, but 1 holds\n"


# --- forward execution ---------------------------------------------------------------------------


def test_forward_execution_is_no_formality():
    """Wrong ranges, which `actions` would never list, are found by running the plan."""
    outline = [(0, 0), (3, 0), (3, 2), (0, 2)]
    s, _ = checker.squeeze(hull_of(outline))
    chain = checker.preimages(s)
    nominal = [(0, 1, 0), (-1, 1, -1)]
    good = checker.actions(chain, nominal)
    checker.run_forward(s, chain, good)
    step = (0, 10**6, 1)
    for end, message in (("high", "^plan: does not collapse"), ("angle", "^plan: does not")):
        wrong = [good[0], {**good[1], end: checker.add(good[1]["high"], step)}]
        with pytest.raises(InvalidClaimError, match=message):
            checker.run_forward(s, chain, wrong)
    for low in (checker.add(good[1]["low"], step), checker.sub(good[1]["low"], step)):
        with pytest.raises(InvalidClaimError, match=r"^plan(\.actions\.1\.low)?: "):
            checker.run_forward(s, chain, [good[0], {**good[1], "low": low}])
