"""Hostile parts: huge, tiny, nearly degenerate, exactly tied. All plans must still be exact."""

from __future__ import annotations

from fractions import Fraction
from math import lcm

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.errors import NumberLimitError
from stochgeom.exact.angles import HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.lifted import LiftedAngles
from stochgeom.feeding.planner import FeedingProblem, orient_up_to_symmetry, plan_feeding
from stochgeom.feeding.preimages import preimages
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

HEPTAGON = [(0, 0), (7, -1), (13, 2), (15, 9), (9, 14), (1, 12), (-3, 5)]
LONG = [(1000, 0), (624, 782), (-223, 975), (-901, 434), (-898, -434), (-222, -975), (623, -782)]
"""Nearly a regular heptagon: its shortest plan up to symmetry has seven steps."""
HAIR = Fraction(1, 10**40)
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
OCTAGON = [(2, 1), (1, 2), (-1, 2), (-2, 1), (-2, -1), (-1, -2), (1, -2), (2, -1)]


def widths(transfer):
    return [p.width for p in preimages(transfer)]


def degrees(transfer, digits=2):
    return [width.degrees(digits) for width in widths(transfer)]


def forced(s):
    """Return the same map with shadows that decide nothing."""
    again = StepFunction(s.breaks, s.values, s.period)
    again.lifted_breaks = LiftedAngles(again.breaks, again.period, error=1e9)
    again.lifted_values = LiftedAngles(again.values, again.period, error=1e9)
    return again


def check(vertices):
    """Check everything that can be checked about the plans of a part, and return its map."""
    problem = FeedingProblem(vertices)
    assert widths(forced(problem.transfer)) == widths(problem.transfer)
    for k in range(1, problem.geometric_plan().steps + 1):
        assert problem.plan_of(k).verify()
    assert len(problem.geometric_plan().distribution()) == problem.transfer.order
    return problem.transfer


# --- size ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("vertices", [HEPTAGON, LONG, OCTAGON])
@pytest.mark.parametrize("size", [10**12, 2**52 + 1, 2**80, 10**400, mpq(1, 10**400)])
def test_size_does_not_matter(vertices, size):
    expected = check(vertices)
    assert squeeze_function([(size * x, size * y) for x, y in vertices]) == expected
    far = [(size * x + 17 * size, size * y - 10**9 * size) for x, y in vertices]
    assert squeeze_function(far) == expected


@pytest.mark.parametrize("size", [10**12, 10**100, 10**400])
def test_the_last_of_400_digits_matters(size):
    exact = [(size * x, size * y) for x, y in HEPTAGON]
    x, y = exact[3]
    other = check([*exact[:3], (x + 1, y), *exact[4:]])
    expected = squeeze_function(HEPTAGON)
    assert other != expected
    assert len(other) == len(expected)
    assert degrees(other, 6) == degrees(expected, 6)
    assert widths(other) != widths(expected)


def test_a_diameter_beyond_the_floats_is_said_to_be():
    huge, long = Part([(0, 0), (10**400, 0), (0, 10**400)]), Part([(0, 0), (10**300, 0), (0, 1)])
    with pytest.raises(NumberLimitError, match="accepted: parts below"):
        DiameterFunction(huge).evaluate(0.5)
    assert DiameterFunction(long).evaluate(np.pi / 2) == 1e300
    assert squeeze_function(huge).breaks.to_float().tolist() == [3 * np.pi / 4]


@pytest.mark.parametrize("bits", [50, 51, 52, 53, 61, 62, 63, 64, 80])
def test_the_limits_of_machine_integers_do_not_matter(bits):
    """Vertices whose coordinates are near a power of two, and differences twice as large."""
    top = 2**bits - 1
    ends = [(-top, -top), (top, -top + 2), (top - 4, top), (-top + 6, top - 8)]
    exact = [(mpq(x, 3), mpq(y, 3)) for x, y in ends]  # three coordinates to one denominator
    expected = squeeze_function(exact)
    assert check(ends) == expected
    if bits < 63:
        assert squeeze_function(np.array(ends)) == expected
    # The same shape far from the origin: small differences of large coordinates.
    shifted = [(x + 2**bits, y - 2**bits) for x, y in HEPTAGON]
    assert squeeze_function(shifted) == squeeze_function(HEPTAGON)
    if bits < 63:
        assert squeeze_function(np.array(shifted)) == squeeze_function(HEPTAGON)


@pytest.mark.parametrize("kind", [np.int16, np.int32, np.int64, np.uint16])
def test_arrays_and_lists_are_the_same_part(kind):
    vertices = [(x + 5, y + 5) for x, y in HEPTAGON]
    array = np.array(vertices, dtype=kind)
    assert Part(array) == Part(vertices)
    assert squeeze_function(array) == squeeze_function(vertices)
    mine, other = orient_up_to_symmetry(array), orient_up_to_symmetry(vertices)
    assert mine.actions == other.actions
    assert mine.mouth == other.mouth
    assert plan_feeding(array[::-1], "1/3").expected_cost == (
        plan_feeding(vertices, "1/3").expected_cost
    )
    for view in (np.asfortranarray(array), array[::-1][::-1], np.repeat(array, 2, axis=0)[::2]):
        assert squeeze_function(view) == squeeze_function(vertices)


# --- slivers -------------------------------------------------------------------------------------


@pytest.mark.parametrize("length", [10**6, 10**12, 10**60, 10**400])
def test_needles(length):
    """Flat triangles are obtuse; flat rectangles and kites keep their few stable edges."""
    assert check([(0, 0), (length, 0), (1, 1)]).equals_up_to_rotation(
        squeeze_function([(0, 0), (5, 0), (1, 1)])
    )
    rectangle = check([(0, 0), (length, 0), (length, 1), (0, 1)])
    assert list(rectangle.breaks) == [Angle(0, (1, length)), Angle(0, (-1, length))]
    assert list(rectangle.values) == [QUARTER_TURN, HALF_TURN]
    assert widths(rectangle)[0] == HALF_TURN - Angle(0, (length, 1)) * 2
    leaning = check([(0, 0), (length, 0), (2 * length, 1), (length, 1)])
    assert len(leaning) == 1
    kite = check([(-length, 0), (0, -1), (length, 0), (0, 1)])
    assert len(kite) == len(squeeze_function([(-5, 0), (0, -1), (5, 0), (0, 1)]))


@pytest.mark.parametrize("bits", [20, 60, 200, 1000])
def test_edges_whose_directions_nearly_agree(bits):
    """Edges bent by 2**-bits lie flush 2**-bits apart; what is stable does not change."""
    long = 2**bits
    bent = [(-long, 1), (0, 0), (long, 0), (2 * long, 1), (long, 2 * long)]
    d = DiameterFunction(Part(bent))
    assert len(d.transitions) == 5
    gap = Angle(0, (long, 1))
    assert list(d.transitions)[:2] == [ZERO, gap]
    assert d.transitions[4] == HALF_TURN - gap
    assert len(check(bent)) == 3
    # Bent the other way, neither of the inner vertices is on the hull.
    dented = [(-long, -1), (0, 0), (long, 0), (2 * long, -1), (long, 2 * long)]
    assert len(DiameterFunction(Part(dented)).transitions) == 3
    assert len(check(dented)) == 3


@pytest.mark.parametrize("bits", [20, 60, 200, 1000])
def test_opposite_edges_that_are_nearly_parallel(bits):
    """One corner of a rectangle is off by 2**-bits: two flush orientations instead of one."""
    e = mpq(1, 2**bits)
    rectangle = squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])
    for corner in ((3, 2 + e), (3, 2 - e)):
        tilted = check([(0, 0), (3, 0), corner, (0, 2)])
        assert tilted != rectangle
        assert len(tilted) == len(rectangle) == 2
        assert degrees(tilted, 4) == degrees(rectangle, 4)
        assert len(DiameterFunction(Part([(0, 0), (3, 0), corner, (0, 2)])).transitions) == 3
    # Off along the edge nothing but a length changes.
    longer = check([(0, 0), (3, 0), (3 + e, 2), (0, 2)])
    assert len(longer) == 2


# --- symmetry and nearly -------------------------------------------------------------------------


@pytest.mark.parametrize("sides", [(1, 2), (3, 2), (7, 7 * 10**9), (10**40, 10**40 + 1)])
def test_rectangles_take_two_squeezes_and_squares_one(sides):
    a, b = sides
    rectangle = check([(0, 0), (a, 0), (a, b), (0, b)])
    assert (rectangle.order, len(widths(rectangle))) == (2, 2)
    square = check([(0, 0), (a, b), (a - b, a + b), (-b, a)])
    assert (square.order, len(widths(square))) == (4, 1)


@pytest.mark.parametrize("vertices", [SQUARE, OCTAGON])
@pytest.mark.parametrize("digits", [3, 60, 400])
def test_a_hair_breaks_a_symmetry(vertices, digits):
    """One coordinate is off by 10**-digits: the period is 180 degrees, not 90."""
    hair = Fraction(1, 10**digits)
    exact = check(vertices)
    assert exact.order == 4
    (x, y), *others = vertices
    for corner in ((x - hair, y), (x, y + hair), (x + hair, y + hair)):
        broken = check([corner, *others])
        assert broken.order == 2
        assert len(broken) in (2 * len(exact), 2 * len(exact) + 1)
        assert len(widths(broken)) > len(widths(exact))
        assert widths(broken)[-1] == HALF_TURN


# --- outlines ------------------------------------------------------------------------------------


def test_a_thousand_collinear_points():
    """On straight edges, many vertices mean nothing: to a convex outline and to another one."""
    fine = []
    for k, (x, y) in enumerate(HEPTAGON):
        u, v = HEPTAGON[(k + 1) % 7]
        steps = [Fraction(j, 143) for j in range(143)]
        fine += [(x + (u - x) * t, y + (v - y) * t) for t in steps]
    assert len(fine) == 1001
    expected = check(HEPTAGON)
    assert squeeze_function(fine) == expected
    assert squeeze_function(fine[500:] + fine[:500]) == expected
    assert squeeze_function(fine[::-1]) == expected
    assert len(Part(fine).hull) == 7
    notched = [*fine[: 7 * 143 // 2], (6, 6), *fine[7 * 143 // 2 + 1 :]]
    assert squeeze_function(notched) == expected
    comb = [(0, 0), (1000, 0), *((x, 10 if x % 2 else 20) for x in range(1000, -1, -1))]
    assert len(Part(comb).hull) == 4
    check(comb)


def test_repeated_vertices_and_orientation():
    expected = check(HEPTAGON)
    for outline in (HEPTAGON, HEPTAGON[::-1], HEPTAGON[3:] + HEPTAGON[:3]):
        assert squeeze_function(outline) == expected
        assert squeeze_function([p for p in outline for _ in range(3)]) == expected
        assert squeeze_function([*outline, outline[0]]) == expected
        assert squeeze_function([outline[-1], *outline]) == expected


def circle_point(k):
    t = Fraction(k, 101 + k)
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


def test_ninety_nine_denominators():
    """Points of a circle whose common denominator would have thousands of bits."""
    circle = [circle_point(k) for k in range(-49, 50)]
    part = Part(circle)
    assert part.points.w is not None
    s = check(circle)
    assert len(part.hull) == 99
    # The same part with whole coordinates: one denominator for all, taken away.
    common = lcm(*(x.denominator for x, _ in circle))
    assert common.bit_length() > 800
    whole = Part([(int(x * common), int(y * common)) for x, y in circle])
    assert whole.points.w is None
    assert squeeze_function(whole) == s
    assert whole.hull.indices.tolist() == part.hull.indices.tolist()
    assert part.area * common**2 == whole.area
    assert part.center_of_mass_side == whole.center_of_mass_side == 1


# --- exact ties ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("vertices", "expected"),
    [
        ([(-1, -2), (1, 3), (-4, 3), (-3, -1)], ["59.04", "104.04", "135.00", "180.00"]),
        ([(-3, -4), (4, 0), (-3, 4), (-4, -2)], ["60.26", "120.51", "164.29", "180.00"]),
        ([(-4, 4), (-3, -4), (4, 1), (1, 4)], ["62.32", "118.41", "152.10", "180.00"]),
        ([(0, -3), (2, 3), (-2, 4), (-4, 3)], ["71.57", "127.87", "162.26", "180.00"]),
        ([(2, -4), (2, 2), (-2, 2), (-4, -1)], ["97.13", "150.26", "180.00"]),
        (
            [(-2, 0), (0, -2), (2, 1), (3, 4), (-4, 4)],
            ["60.26", "90.00", "123.69", "155.22", "180.00"],
        ),
        (
            [(-3, 0), (-1, -4), (2, -2), (4, 0), (-2, 3)],
            ["59.47", "98.13", "128.66", "180.00"],
        ),
    ],
)
def test_an_image_exactly_as_wide_as_a_preimage(vertices, expected):
    """On all of these a planner with float64 angles finds wider preimages, and fails.

    An image is exactly as wide as the preimage that is to hold it, as both are the angle between
    the same two edges; rounding lets it fit.
    """
    s = check(vertices)
    assert degrees(s) == expected
    images = {
        s.lifted_values[last] - s.lifted_values[first]
        for first in range(len(s))
        for last in range(first, first + len(s))
    }
    assert images & set(widths(s)[:-1])


@pytest.mark.parametrize("k", range(4))
@pytest.mark.parametrize("move", [(HAIR, 0), (-HAIR, 0), (0, HAIR), (0, -HAIR)])
def test_a_structural_tie_stays_when_a_vertex_moves(k, move):
    """Both widths are the angle between the same two edges, wherever these are."""
    vertices = [(-3, -4), (4, 0), (-3, 4), (-4, -2)]
    vertices[k] = (vertices[k][0] + move[0], vertices[k][1] + move[1])
    assert degrees(check(vertices)) == ["60.26", "120.51", "164.29", "180.00"]


@pytest.mark.parametrize(
    ("move", "expected"),
    [
        ((0, 0), ["97.13", "150.26", "180.00"]),
        ((0, HAIR), ["97.13", "150.26", "180.00"]),  # now wider by a hair: does not fit either
        ((0, -HAIR), ["97.13", "180.00"]),  # narrower by a hair: fits
        ((-HAIR, 0), ["63.43", "97.13", "150.26", "180.00"]),  # the widest step falls in two
    ],
)
def test_another_tie_is_decided_by_a_hair(move, expected):
    """A vertex moves by 10**-40, and the plan has two, three or four steps."""
    vertices = [(2 + move[0], -4 + move[1]), (2, 2), (-2, 2), (-4, -1)]
    assert degrees(check(vertices)) == expected


@pytest.mark.parametrize(
    ("vertices", "start", "image"),
    [
        ([(-2, -2), (-1, -1), (0, 1), (-4, 1)], "146.31", "56.31"),
        ([(-3, -3), (3, 3), (-1, 4), (-4, 4)], "98.13", "45.00"),
        ([(2, -1), (-2, 3), (-3, 0), (-3, -2)], "135.00", "56.31"),
        ([(3, -4), (4, 3), (0, 3), (-3, 0)], "156.80", "33.69"),
    ],
)
def test_of_equally_wide_preimages_the_narrowest_image_wins(vertices, start, image):
    """The arc of the smallest start would leave less tolerance."""
    check(vertices)
    second = FeedingProblem(vertices).preimages.of_steps(2)
    assert second.ties == 2
    assert (second.arc.start.degrees(2), second.image_width.degrees(2)) == (start, image)


@pytest.mark.parametrize(
    ("vertices", "c", "steps", "dearer"),
    [
        # (2 + c) / 135 = (3 + c) / 180 at c = 1
        ([(-1, -3), (3, -1), (-1, 3)], 1, 2, 3),
        ([(-1, 0), (2, -3), (2, 2)], 1, 2, 3),
        ([(-1, 2), (-1, -3), (3, -2)], 1, 2, 3),
        # (1 + c) / h_1 = (2 + c) / h_2 at c = 0: h_2 = 2 h_1, both irrational
        ([(-1, -1), (1, -1), (0, 1)], 0, 1, 2),
        ([(-1, -4), (-2, 2), (-3, -4)], 0, 1, 2),
        ([(-1, 0), (-1, -2), (2, -1)], 0, 1, 2),
    ],
)
def test_of_equal_costs_the_fewest_steps_win(vertices, c, steps, dearer):
    problem = FeedingProblem(vertices)
    assert problem.expected_cost(steps, c) == problem.expected_cost(steps + 1, c)
    assert problem.optimal_plan(c).steps == steps
    # A filter dearer by a hair is worth one more step, a cheaper one is not.
    assert problem.optimal_plan(c + HAIR).steps == dearer
    assert problem.expected_cost(steps, c + HAIR) > problem.expected_cost(dearer, c + HAIR)
    if c:
        assert problem.optimal_plan(c - HAIR).steps == steps


# --- costs ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "c", ["0", "0.1234567", "1/3", "1000000", "1e-4000", "1e4000", "1/" + "7" * 3000]
)
@pytest.mark.parametrize("vertices", [HEPTAGON, LONG])
def test_cost_ratios_of_every_size(vertices, c):
    problem = FeedingProblem(vertices)
    plan = problem.optimal_plan(c)
    assert plan.cost_ratio == Fraction(c)
    for steps in range(1, problem.geometric_plan().steps + 1):
        assert plan.expected_cost <= problem.expected_cost(steps, c)
    n = len(problem.part.hull)
    assert plan.steps <= n * (plan.cost_ratio + 1) - plan.cost_ratio
