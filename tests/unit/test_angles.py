"""Worked cases of `Angle`: canonical form, text, conversions, and what is refused."""

from __future__ import annotations

import copy
import pickle
import sys
from fractions import Fraction

import numpy as np
import pytest
import sympy
from gmpy2 import mpq, mpz

from stochgeom.errors import (
    FloatRefusedError,
    InputError,
    InvalidAngleError,
    NumberError,
    NumberLimitError,
)
from stochgeom.exact.angles import (
    EIGHTH_TURN,
    FULL_TURN,
    HALF_TURN,
    QUARTER_TURN,
    ZERO,
    Angle,
    make_angle,
)
from stochgeom.exact.surds import exact_scalar

TINY = Angle(0, (mpz(10) ** 400, 1))
LONG = Angle(0, (mpz(10) ** 5000 + 3, mpz(10) ** 4999 + 1))
SAMPLES = [
    *[ZERO, EIGHTH_TURN, QUARTER_TURN, HALF_TURN, FULL_TURN, -FULL_TURN, TINY, -TINY],
    *[Angle(0, (3, 2)), Angle(-2, (-3, 2)), Angle(7, (3, -2)), Angle.from_degrees(71)],
    *[Angle("71/360", (3, 2)), Angle("-1/3", (-3, -2)), Angle(10**50, (1, 2)), LONG],
]


def parts(angle):
    return angle.turn_part, angle.direction


# --- canonical form ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("given", "turn_part", "direction"),
    [
        (Angle(), 0, (1, 0)),
        (Angle(0, (6, 4)), 0, (3, 2)),
        (Angle(0, ("1/2", "1/3")), 0, (3, 2)),
        (Angle(0, (-6, -4)), 0, (-3, -2)),
        (Angle(0, (0, -7)), 0, (0, -1)),
        (Angle("1/2", (1, 0)), 0, (-1, 0)),
        (Angle("1/8", (1, 0)), 0, (1, 1)),
        (Angle("7/8", (1, 1)), 1, (1, 0)),
        (Angle("-1/8", (1, 1)), 0, (1, 0)),
        (Angle("-1/8", (1, 0)), -1, (1, -1)),
        (Angle("1/4", (3, 2)), 0, (-2, 3)),
        (Angle("1/2", (3, -2)), 1, (-3, 2)),
        (Angle("1/8", (3, 1)), 0, (1, 2)),  # 45 degrees double the norm: (2, 4), reduced
        (Angle("1/3", (1, 0)), mpq(1, 3), (1, 0)),
        (Angle("1/3", (0, 1)), mpq(7, 12), (1, 0)),
        (Angle("1/3", (-2, 3)), mpq(7, 12), (3, 2)),
        (Angle("1/3", (2, 3)), mpq(11, 24), (5, 1)),
        (Angle("1/16", (1, 1)), mpq(3, 16), (1, 0)),
        (Angle.from_degrees(71), mpq(71, 360), (1, 0)),
    ],
)
def test_canonical_form(given, turn_part, direction):
    assert parts(given) == (turn_part, direction)
    assert type(given.turn_part) in (type(mpz()), type(mpq()))
    assert all(type(value) is type(mpz()) for value in given.direction)


def test_constants():
    eighths = [ZERO, EIGHTH_TURN, QUARTER_TURN, None, HALF_TURN, None, None, None, FULL_TURN]
    for k, angle in enumerate(eighths):
        if angle is not None:
            assert angle == Angle.from_turns(Fraction(k, 8)) == k * EIGHTH_TURN
            assert angle.rational_turns == mpq(k, 8)


def test_makers_agree():
    assert Angle.from_degrees("35.5") == Angle.from_turns("71/720") == Angle("71/720")
    assert Angle.from_degrees(-90) == Angle(-1, (0, -1)) == -QUARTER_TURN
    assert Angle.from_turns(mpq(1, 3)) == Angle.from_degrees(120) == Angle(Fraction(1, 3))
    assert Angle(np.int64(2), (np.int8(-1), np.int64(0))) == Angle.from_turns("2.5")
    assert make_angle(0, 6, 4) == make_angle(mpq(0), mpz(3), mpz(2)) == Angle(0, (3, 2))


def test_the_angle_between_two_vectors():
    assert Angle.between((1, 0), (0, 2)) == QUARTER_TURN
    assert Angle.between((0, 2), (1, 0)) == 3 * QUARTER_TURN
    assert Angle.between((3, 1), (3, 1)) == ZERO
    assert Angle.between((3, 1), (-6, -2)) == HALF_TURN
    assert Angle.between(("1/2", 1), (1, 3)) == Angle(0, (7, 1))


# --- lifted ---------------------------------------------------------------------------------------


def test_a_full_turn_is_not_zero():
    assert FULL_TURN != ZERO
    assert Angle.from_degrees(370) != Angle.from_degrees(10)
    assert Angle.from_degrees(370).reduced() == Angle.from_degrees(10)
    assert bool(FULL_TURN)
    assert bool(HALF_TURN)  # its sine is zero, it is not
    assert bool(-TINY)
    assert not ZERO
    assert not Angle(-1) + FULL_TURN


def test_order_by_hand():
    increasing = [
        Angle(-2, (1, -1)),
        Angle(-1),
        -2 * TINY,
        -TINY,
        ZERO,
        TINY,
        2 * TINY,
        Angle.from_degrees("1e-30"),
        Angle(0, (10**20, 1)),
        Angle.from_degrees("33.690067525979"),
        Angle(0, (3, 2)),
        Angle.from_degrees("33.690067525980"),
        EIGHTH_TURN,
        Angle(0, (10**40, 10**40 + 1)),
        Angle.from_degrees(46),
        FULL_TURN - TINY,
        FULL_TURN,
        FULL_TURN + TINY,
    ]
    for i, a in enumerate(increasing):
        for j, b in enumerate(increasing):
            assert a.compare(b) == (i > j) - (i < j)
            assert (a < b, a <= b, a == b, a > b, a >= b) == (i < j, i <= j, i == j, i > j, i >= j)


def test_rational_turns_a_half_turn_apart():
    low, high = Angle.from_degrees(71), Angle.from_degrees(251)
    assert low < high
    assert low.compare(high) == -high.compare(low) == -1
    assert low.compare(low + ZERO) == 0
    assert Angle("71/360", (3, 2)) < Angle("251/360", (3, 2)) < Angle("431/360", (3, 2))


# --- arithmetic -----------------------------------------------------------------------------------


def test_sums_by_hand():
    assert Angle(0, (2, 1)) + Angle(0, (3, 1)) == EIGHTH_TURN
    assert Angle(0, (3, -2)) + Angle(0, (3, 2)) == FULL_TURN
    assert Angle(0, (3, 2)) - Angle(0, (3, 2)) == ZERO
    assert Angle(0, (3, 2)) - HALF_TURN == Angle(-1, (-3, -2))
    assert HALF_TURN + HALF_TURN == FULL_TURN
    assert Angle.from_degrees("71") + Angle.from_degrees("19") == QUARTER_TURN
    assert sum([EIGHTH_TURN] * 8, start=ZERO) == FULL_TURN


def test_multiples_by_hand():
    assert 4 * Angle(0, (5, 1)) - Angle(0, (239, 1)) == EIGHTH_TURN
    assert 3 * Angle.from_degrees(120) == FULL_TURN
    assert -2 * Angle(0, (3, 2)) == Angle(-1, (5, -12))
    assert 0 * Angle(5, (3, 2)) == ZERO
    assert 10**30 * Angle.from_degrees("1e-30") == Angle.from_degrees(1)
    for two in (2, mpz(2), np.int64(2), np.int8(2), Fraction(2).numerator):
        assert two * Angle(0, (3, 2)) == Angle(0, (3, 2)) * two == Angle(0, (5, 12))


def test_multiples_have_a_limit():
    angle = Angle(0, (3, 2))
    assert (100_000 * angle).direction[0].bit_length() > 150_000
    for count in (10**8, -(10**30), 10**5000):
        with pytest.raises(NumberLimitError, match="at most 10000000 bits") as caught:
            count * angle
        assert len(str(caught.value)) < 250


@pytest.mark.parametrize("other", [1, 0.5, "1", None, Fraction(1, 2), mpq(1, 2), (1, 0)])
def test_angles_do_not_mix_with_numbers(other):
    angle = Angle(0, (3, 2))
    for attempt in (
        lambda: angle + other,
        lambda: other + angle,
        lambda: angle - other,
        lambda: angle < other,
        lambda: angle >= other,
        lambda: divmod(angle, other),
    ):
        with pytest.raises(TypeError):
            attempt()
    assert angle != other
    assert ZERO != 0


@pytest.mark.parametrize("count", [0.5, 1.0, np.float64(2), Fraction(1, 2), mpq(2), "2", ZERO])
def test_only_whole_multiples(count):
    with pytest.raises(TypeError):
        Angle(0, (3, 2)) * count
    with pytest.raises(TypeError):
        count * Angle(0, (3, 2))


def test_division_with_rest_by_hand():
    right = QUARTER_TURN
    assert divmod(Angle.from_degrees(370), right) == (4, Angle.from_degrees(10))
    assert divmod(Angle.from_degrees(-10), right) == (-1, Angle.from_degrees(80))
    assert divmod(3 * right, right) == (3, ZERO)
    assert divmod(4 * Angle(0, (5, 1)), Angle(0, (5, 1))) == (4, ZERO)
    assert divmod(4 * Angle(0, (5, 1)) - TINY, Angle(0, (5, 1)))[0] == 3
    assert divmod(FULL_TURN, Angle(1)) == divmod(FULL_TURN, FULL_TURN) == (1, ZERO)
    assert Angle(10**40, (3, 2)) // FULL_TURN == 10**40
    assert Angle(10**40, (3, 2)) // right == 4 * 10**40
    assert (Angle(10**40, (3, 2)) - TINY) % Angle.from_degrees(120) == Angle(0, (3, 2)) - TINY
    assert QUARTER_TURN // Angle.from_turns(mpq(1, 3 * 10**50)) == 75 * 10**48
    assert ZERO // TINY == 0
    assert -TINY // FULL_TURN == -1
    assert Angle(10**5) // Angle(0, (3, 2)) == 1068564  # 36 000 000 / 33.690067525979787


def test_a_rest_too_long_to_write_down_is_an_error():
    # The quotient is easy; the rest would have a direction of 10**31 bits.
    with pytest.raises(NumberLimitError, match="at most 10000000 bits"):
        divmod(Angle(10**30), Angle(0, (3, 2)))


@pytest.mark.parametrize("period", [ZERO, -FULL_TURN, -TINY])
def test_periods_are_positive(period):
    with pytest.raises(InputError, match="accepted: positive angles"):
        divmod(FULL_TURN, period)


# --- text and conversions -------------------------------------------------------------------------


def test_degrees_and_turns_as_text():
    angle = Angle(0, (3, 2))
    assert angle.degrees() == "33.6901"
    assert angle.degrees(0) == "34"
    assert angle.degrees(12) == "33.690067525980"
    assert angle.turns() == "0.0936"
    assert (-angle).degrees(2) == "-33.69"
    assert (-TINY).degrees() == TINY.degrees() == "0.0000"
    assert (FULL_TURN - TINY).degrees(3) == "360.000"
    assert TINY.turns(401) == "0." + "0" * 400 + "2"  # 1 / (2 pi 10**400) = 0.159e-400
    assert str(angle) == "33.6901°"
    assert Angle(10**30).degrees(1) == "36" + "0" * 31 + ".0"


def test_ties_go_to_the_even_digit():
    assert Angle.from_degrees("22.5").degrees(0) == "22"
    assert Angle.from_degrees("23.5").degrees(0) == "24"
    assert Angle.from_degrees("-22.5").degrees(0) == "-22"
    assert EIGHTH_TURN.turns(2) == "0.12"
    assert Angle.from_turns("3/8").turns(2) == "0.38"
    assert (Angle.from_degrees("22.5") + TINY).degrees(0) == "23"
    assert (Angle.from_degrees("22.5") - TINY).degrees(0) == "22"
    assert (Angle.from_degrees("23.5") - TINY).degrees(0) == "23"


def test_rational_turns():
    assert Angle(1, (-2, 2)).rational_turns == mpq(11, 8)
    assert Angle.from_degrees(71).rational_turns == mpq(71, 360)
    assert Angle(0, (3, 2)).rational_turns is None
    assert Angle("71/360", (3, 2)).rational_turns is None
    assert TINY.rational_turns is None


def test_radians_as_float():
    assert QUARTER_TURN.to_float() == np.pi / 2
    assert ZERO.to_float() == 0.0
    assert Angle(0, (10**20, 1)).to_float() == 1e-20
    assert Angle(-1, (10**20, -1)).to_float() == pytest.approx(-1e-20, rel=1e-15)
    assert 0.0 <= TINY.to_float() <= 5e-324
    assert Angle(10**300).to_float() == pytest.approx(2e300 * np.pi, rel=1e-15)
    for huge in (10**400, -(10**400)):
        with pytest.raises(NumberLimitError, match="too large for a float"):
            Angle(huge, (3, 2)).to_float()


def test_sympy_expressions():
    assert Angle(0, (3, 2)).to_sympy() == sympy.atan(sympy.Rational(2, 3))
    assert Angle(2, (-1, 1)).to_sympy() == sympy.pi * sympy.Rational(19, 4)
    assert Angle(1, (3, -2)).to_sympy() == 4 * sympy.pi - sympy.atan(sympy.Rational(2, 3))
    assert Angle.from_degrees(71).to_sympy() == 71 * sympy.pi / 180
    assert Angle(0, (3, 2))._repr_latex_().startswith(r"$\displaystyle \operatorname{atan}")


# --- values: immutable, hashable, copied, printed -------------------------------------------------


@pytest.mark.parametrize("angle", SAMPLES, ids=lambda a: a.degrees(1)[:12])
class TestValues:
    def test_repr_evaluates_back(self, angle):
        assert parts(eval(repr(angle))) == parts(angle)

    @pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
    def test_pickle(self, angle, protocol):
        assert parts(pickle.loads(pickle.dumps(angle, protocol))) == parts(angle)

    def test_copies_are_equal(self, angle):
        assert parts(copy.copy(angle)) == parts(copy.deepcopy(angle)) == parts(angle)
        assert hash(copy.copy(angle)) == hash(angle)

    def test_nothing_can_be_set(self, angle):
        before = parts(angle)
        for name in ("_t", "_x", "turn_part", "direction", "colour"):
            with pytest.raises(AttributeError, match="immutable"):
                setattr(angle, name, 1)
        with pytest.raises(AttributeError, match="immutable"):
            del angle._t
        assert parts(angle) == before


def test_repr_of_more_digits_than_python_prints():
    digits = sys.get_int_max_str_digits()
    assert 0 < digits < 10**5
    for angle in (LONG, Angle(10**5000), Angle(mpq(1, mpz(10) ** 5000)), Angle(0, (10**30000, 1))):
        assert parts(eval(repr(angle))) == parts(angle)


@pytest.mark.parametrize("direction", [(0, 0), ("0", "0.0"), (mpq(0), mpz(0))])
def test_the_zero_vector_has_no_angle(direction):
    with pytest.raises(InvalidAngleError, match="accepted: any other vector"):
        Angle(0, direction)


@pytest.mark.parametrize("direction", [5, None, (1,), (1, 2, 3), (), "0.5"])
def test_a_direction_is_a_pair(direction):
    with pytest.raises(InvalidAngleError, match="accepted: a pair of numbers"):
        Angle(0, direction)


def test_floats_are_refused_everywhere():
    for attempt in (
        lambda: Angle(0.5),
        lambda: Angle(0, (1.0, 2)),
        lambda: Angle.from_turns(0.25),
        lambda: Angle.from_degrees(45.0),
        lambda: Angle.between((1, 0), (0, 1.0)),
    ):
        with pytest.raises(FloatRefusedError):
            attempt()
    with pytest.raises(NumberError, match="degrees: 'right' is not a number"):
        Angle.from_degrees("right")


def test_a_rational_turn_hidden_by_cancellation_is_found():
    """A direction over Q(sqrt 2) times a number of 150 digits' cancellation, which is positive."""
    root = exact_scalar("sqrt(2)")
    p, q = 1, 1
    for _ in range(400):
        p, q = p + 2 * q, p + q
    tiny = abs(p - q * root)
    angle = Angle(0, (tiny * (1 + root), tiny))
    assert angle == Angle.from_degrees("22.5")
    assert angle.rational_turns == mpq(1, 16)
    assert hash(angle) == hash(Angle.from_degrees("22.5"))
