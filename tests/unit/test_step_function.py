"""`stochgeom.transfer.step_function` and `.canonical`: worked cases and refusals."""

from __future__ import annotations

import pytest

from stochgeom.errors import InputError, InvalidStepFunctionError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.vectors import AngleVector
from stochgeom.transfer.canonical import find_rotation, full_turn_share
from stochgeom.transfer.step_function import StepFunction


def deg(*values):
    angles = [Angle.from_degrees(value) for value in values]
    return angles if len(angles) != 1 else angles[0]


def arc(start, width):
    return Arc(deg(start), deg(width))


def whole(angles):
    return [int(angle.degrees(0)) for angle in angles]


STAIRS = StepFunction(deg(10, 30, 100), deg(20, 40, 110), HALF_TURN)
"""Three steps in half a turn, each value in its own step."""

AHEAD = StepFunction(deg(0, 100), deg(130, 250), FULL_TURN)
"""Values outside their own steps, as a push may have them."""


# --- canonical form ------------------------------------------------------------------------------


def test_one_smallest_period_is_kept():
    twice = StepFunction(
        deg(10, 30, 100, 190, 210, 280), deg(20, 40, 110, 200, 220, 290), FULL_TURN
    )
    assert twice == STAIRS
    assert hash(twice) == hash(STAIRS)
    assert twice.period == HALF_TURN
    assert twice.order == 2
    assert len(twice) == 3


def test_the_period_may_be_no_rational_direction():
    third = StepFunction(deg(0, 120, 240), deg(50, 170, 290))
    assert (third.period, third.order, len(third)) == (deg(120), 3, 1)
    nearly = StepFunction(deg(0, 120, 240), deg(50, 170, "290.000001"))
    assert (nearly.period, len(nearly)) == (FULL_TURN, 3)


@pytest.mark.parametrize("order", [1, 2, 4, 8])
def test_directions_repeat_after_eighths_of_a_turn(order):
    """Breaks and values that are rational directions: found for every period they can have."""
    starts = [deg(360 * k // order) for k in range(order)]
    breaks = [start + Angle(0, (3, 1)) for start in starts]
    values = [start + Angle(0, (2, 1)) for start in starts]
    s = StepFunction(breaks, values)
    assert (s.order, len(s)) == (order, 1)
    assert s == StepFunction(breaks[:1], values[:1], deg(360) if order == 1 else starts[1])
    values[-1] += Angle(0, (10**9, 1))
    assert StepFunction(breaks, values).order == 1


def test_equal_neighbours_are_merged():
    cut = StepFunction(deg(10, 17, 30, 100, 150), deg(20, 20, 40, 110, 110), HALF_TURN)
    assert cut == STAIRS
    # across the end of the period as well
    assert StepFunction(deg(0, 10, 30, 100), deg(-70, 20, 40, 110), HALF_TURN) == STAIRS


def test_breaks_are_brought_into_one_period():
    for shift in (-360, -180, 180, 3600):
        breaks = deg(*(b + shift for b in (10, 30, 100)))
        values = deg(*(v + shift for v in (20, 40, 110)))
        assert StepFunction(breaks, values, HALF_TURN) == STAIRS
    assert StepFunction(deg(100, 190, 210), deg(110, 200, 220), HALF_TURN) == STAIRS
    assert StepFunction(deg(-80, 10, 30), deg(-70, 20, 40), HALF_TURN) == STAIRS


def test_one_step_may_fill_the_period():
    constant = StepFunction([ZERO], [deg(45)], QUARTER_TURN)
    assert whole(constant.widths) == [90]
    assert whole(map(constant, deg(-1, 0, 89, 90))) == [-45, 45, 45, 135]
    filled = StepFunction(deg(0, 10, 20), deg(90, 90, 90), FULL_TURN)
    assert (len(filled), filled.order) == (1, 1)


def test_vectors_are_taken_as_they_are():
    breaks, values = AngleVector.from_angles(STAIRS.breaks), AngleVector.from_angles(STAIRS.values)
    assert StepFunction(breaks, values, HALF_TURN) == STAIRS


# --- refusing ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("breaks", "values", "period", "where", "accepted"),
    [
        ([], [], FULL_TURN, None, "at least one"),
        (deg(1, 2), [deg(1)], FULL_TURN, None, "as many"),
        (deg(10, 10), deg(1, 2), FULL_TURN, "break 0", "strictly increasing breaks"),
        (deg(10, 30, 20), deg(1, 2, 3), FULL_TURN, "break 1", "strictly increasing breaks"),
        (deg(10, 190), deg(1, 2), HALF_TURN, "break 1", "break 0 one period on at 190"),
        (deg(10, 300), deg(1, 2), HALF_TURN, "break 1", "strictly increasing breaks"),
        (deg(10, 30, 50), deg(1, 3, 2), FULL_TURN, "value 1", "values that do not decrease"),
        (deg(10, 30), deg(0, 361), FULL_TURN, "value 1", "values that do not decrease"),
        ([deg(10)], [deg(1)], ZERO, None, "a full turn divided by a whole number"),
        ([deg(10)], [deg(1)], deg(-90), None, "a full turn divided by a whole number"),
        ([deg(10)], [deg(1)], deg(100), None, "a full turn divided by a whole number"),
        ([deg(10)], [deg(1)], deg(720), None, "a full turn divided by a whole number"),
        ([deg(10), 20], deg(1, 2), FULL_TURN, "break 1", "exact angles, such as"),
        ([deg(10)], ["1"], FULL_TURN, "value 0", "exact angles, such as"),
        ([deg(10)], [0.5], FULL_TURN, "value 0", "exact angles, such as"),
        ([deg(10)], [deg(1)], 360, "period", "exact angles, such as"),
        ([deg(10)], [deg(1)], Angle(0, (2, 1)), None, "a full turn divided by a whole number"),
    ],
)
def test_no_monotone_map_of_degree_one(breaks, values, period, where, accepted):
    with pytest.raises(InvalidStepFunctionError) as caught:
        StepFunction(breaks, values, period)
    assert caught.value.where == where
    assert accepted in caught.value.message


def test_order_is_decided_exactly():
    near = Angle(0, (10**40, 1)), Angle(0, (10**40 - 1, 1))
    assert len(StepFunction(near, deg(50, 60))) == 2
    with pytest.raises(InvalidStepFunctionError):
        StepFunction(near[::-1], deg(50, 60))
    with pytest.raises(InvalidStepFunctionError):
        StepFunction(deg(50, 60), near[::-1])
    with pytest.raises(InvalidStepFunctionError):
        StepFunction([ZERO, near[0]], [ZERO, FULL_TURN + near[0]])


def test_full_turn_share():
    assert [full_turn_share(deg(d)) for d in (360, 180, 120, 72, 1)] == [1, 2, 3, 5, 360]


# --- applying ------------------------------------------------------------------------------------


def test_steps_are_closed_on_the_left():
    assert whole(map(STAIRS, deg(9, 10, 29, 30, 99, 100, 189, 190))) == [
        -70, 20, 20, 40, 40, 110, 110, 200,
    ]  # fmt: skip
    assert [STAIRS.step_at(theta) for theta in deg(9, 10, 30, 190, -80)] == [-1, 0, 1, 3, -1]
    assert [STAIRS.step_before(theta) for theta in deg(9, 10, 11, 30, 190)] == [-1, -1, 0, 0, 2]


@pytest.mark.parametrize(
    ("start", "width", "image"),
    [
        (10, 20, (20, 20)),  # the end is not part of the arc
        (10, 21, (20, 40)),
        (29, 2, (20, 40)),
        (30, 180, (40, 200)),
        (31, 180, (40, 220)),
        (-80, 90, (-70, -70)),
        (5, 360, (-70, 290)),
    ],
)
def test_image(start, width, image):
    found = STAIRS.image(arc(start, width))
    assert whole([found.start, found.end]) == list(image)


@pytest.mark.parametrize(
    ("start", "width", "preimage"),
    [
        (20, 1, (10, 20)),
        (19, 1, None),  # the end is not part of the arc
        (20, 20, (10, 20)),
        (20, 21, (10, 90)),
        (15, 100, (10, 180)),
        (41, 60, None),
        (200, 20, (190, 20)),
        (-70, 360, (-80, 360)),
    ],
)
def test_preimage(start, width, preimage):
    found = STAIRS.preimage(arc(start, width))
    assert (found and tuple(whole([found.start, found.width]))) == preimage


def test_preimages_of_values_outside_their_steps():
    found = AHEAD.preimage(arc(130, 1))
    assert whole([found.start, found.width]) == [0, 100]
    assert AHEAD.preimage(arc(0, 100)) is None  # the lifted arc counts, not its shadow
    found = AHEAD.preimage(arc(-110, 241))
    assert whole([found.start, found.width]) == [-260, 360]


# --- new functions from old ----------------------------------------------------------------------


def test_compose_and_power():
    twice = AHEAD.compose(AHEAD)
    assert whole(map(twice, deg(0, 99, 100, 359))) == [250, 250, 250, 250]
    assert len(twice) == 1
    assert AHEAD.power(1) == AHEAD
    assert AHEAD.power(2) == twice
    assert whole(map(AHEAD.power(3), deg(0, 100))) == [250, 250]
    assert STAIRS.power(5) == STAIRS  # every value stays in its own step


def test_composites_have_the_shared_period():
    three = StepFunction([ZERO], [deg(60)], deg(120))
    composite = STAIRS.compose(three)
    assert whole(map(composite, deg(0, 120, 240))) == [40, 110, 290]
    assert (composite.order, len(composite)) == (1, 3)
    other = three.compose(STAIRS)
    assert whole(map(other, deg(10, 189, 190, 279, 280, 369))) == [60, 60, 180, 180, 300, 300]
    assert (other.order, len(other)) == (1, 3)


@pytest.mark.parametrize("exponent", [0, -1])
def test_no_power_below_one(exponent):
    with pytest.raises(InputError, match="accepted"):
        STAIRS.power(exponent)


def test_turning():
    turned = STAIRS.after_turning(deg(25))
    assert whole(map(turned, deg(34, 35, 55))) == [-70, 20, 40]
    rotated = STAIRS.rotate(deg(25))
    assert whole(map(rotated, deg(34, 35, 55))) == [-45, 45, 65]
    assert rotated.rotate(deg(-25)) == STAIRS


def test_rotations_are_found():
    assert STAIRS.rotation_to(STAIRS) == ZERO
    assert STAIRS.rotation_to(STAIRS.rotate(deg(25))) == deg(25)
    assert STAIRS.rotation_to(STAIRS.rotate(deg(-25))) == deg(155)
    assert AHEAD.rotation_to(AHEAD.rotate(deg(300))) == deg(300)
    moved = StepFunction(deg(10, 30, 100), deg(20, 40, 111), HALF_TURN)
    assert STAIRS.rotation_to(moved) is None
    assert not STAIRS.equals_up_to_rotation(moved)
    assert not STAIRS.equals_up_to_rotation(AHEAD)
    assert STAIRS.equals_up_to_rotation(STAIRS.rotate(Angle(0, (3, 2))))


@pytest.mark.parametrize(
    ("word", "target", "shift"),
    [
        ("a", "a", 0),
        ("a", "b", None),
        ("abcab", "ababc", 3),
        ("aaab", "aaba", 1),
        ("abab", "baba", 1),
        ("aab", "abb", None),
        ("aabaaab", "aaabaab", 3),
    ],
)
def test_find_rotation(word, target, shift):
    assert find_rotation(word, target) == shift


# --- as a value ----------------------------------------------------------------------------------


def test_repr_reads_back():
    for function in (STAIRS, AHEAD, STAIRS.rotate(Angle(0, (3, 2)))):
        assert eval(repr(function)) == function
    many = StepFunction(
        [Angle.from_degrees(f"{k}/2") for k in range(101)], deg(*range(101)), FULL_TURN
    )
    assert repr(many) == "<StepFunction of 101 steps in a period of 360.0000°>"


def test_equality():
    others = [
        StepFunction(deg(10, 30, 101), deg(20, 40, 110), HALF_TURN),
        StepFunction(deg(10, 30, 100), deg(20, 40, 111), HALF_TURN),
        StepFunction(deg(10, 30, 100), deg(20, 40, 110), FULL_TURN),
    ]
    assert len({STAIRS, *others}) == 4
    assert STAIRS != "stairs"
