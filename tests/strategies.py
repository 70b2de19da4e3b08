"""All random input of the tests, on small grids so that degenerate cases are common.

A coordinate range of -4..4 makes parallel edges, right angles, symmetric parts and exact ties
frequent; `tests/unit/test_strategies.py` checks that they are.
"""

from __future__ import annotations

import math
from fractions import Fraction
from math import gcd

from gmpy2 import mpq
from hypothesis import strategies as st

from stochgeom.decision.decision_rules import DecisionProblem
from stochgeom.errors import InvalidPartError
from stochgeom.exact.algebraic import Algebraic
from stochgeom.exact.algebraic_directions import unity_direction
from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.cells import CellSet
from stochgeom.exact.fields import RealField, quadratic_field, regular_polygon_field
from stochgeom.exact.scalars import common_denominator
from stochgeom.geometry.part import Part
from stochgeom.tilting.counts import TransitionCounts
from stochgeom.tilting.estimation import TransitionModel
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

small = st.integers(-4, 4)
"""Coordinates on which degenerate cases are common."""

fractions = st.fractions(-20, 20, max_denominator=12)
"""Rationals with small denominators."""

points = st.tuples(small, small)

rational_points = st.tuples(fractions, fractions)

directions = points.filter(lambda p: p != (0, 0))
"""Non-zero integer vectors."""

large_directions = st.tuples(st.integers(-(10**40), 10**40), st.integers(-(10**40), 10**40)).filter(
    lambda p: p != (0, 0)
)

PYTHAGOREAN = [(1, 0), (0, 1), (-1, 0), (0, -1), (3, 4), (-5, 12), (8, -15), (-20, -21)]
"""Directions of whole length: exact rotations."""

rotations = st.sampled_from(PYTHAGOREAN)


@st.composite
def angles(draw: st.DrawFn, *, rational_turns: bool = True) -> Angle:
    """Lifted angles; with `rational_turns` some like 71 degrees, no rational direction."""
    x, y = draw(st.one_of(directions, directions, large_directions))
    turns = st.integers(-3, 3).map(Fraction)
    if rational_turns:
        turns = st.one_of(turns, turns, st.fractions(-3, 3, max_denominator=24))
    return Angle(draw(turns), (x, y))


@st.composite
def arcs(draw: st.DrawFn) -> Arc:
    """Arcs of rational directions, full turns among them."""
    start = draw(angles(rational_turns=False))
    width = Angle(0, draw(directions))
    return Arc(start, width if width else Angle(1))


@st.composite
def star_polygons(draw: st.DrawFn, *, least: int = 3, most: int = 9) -> Part:
    """Simple polygons, often not convex: distinct grid points in order about one of the plane."""
    corners = draw(st.lists(points, min_size=least, max_size=most, unique=True))
    eye = (
        Fraction(sum(x for x, _ in corners), len(corners)) + Fraction(1, 97),
        Fraction(sum(y for _, y in corners), len(corners)) + Fraction(1, 89),
    )
    corners.sort(key=lambda p: Angle(0, (p[0] - eye[0], p[1] - eye[1])))
    return _part_or_reject(corners)


@st.composite
def hulls(draw: st.DrawFn, *, least: int = 3, most: int = 10) -> Part:
    """Convex polygons: hulls of distinct grid points."""
    corners = draw(st.lists(points, min_size=least, max_size=most, unique=True))
    return _part_or_reject(_in_hull_order(corners))


def parts() -> st.SearchStrategy[Part]:
    """Simple polygons of all kinds, small symmetric ones among them."""
    return st.one_of(hulls(), star_polygons(), st.sampled_from(SPECIAL))


@st.composite
def step_functions(draw: st.DrawFn) -> StepFunction:
    """Step maps of period 360, 180, 120, 90 or 45 degrees with rational-degree parts.

    Breaks and values come from one grid of 5 degrees, so that ties are the rule.
    """
    order = draw(st.sampled_from([1, 2, 3, 4, 8]))
    cells = 72 // order
    count = draw(st.integers(1, min(6, cells)))
    breaks = sorted(draw(st.sets(st.integers(0, cells - 1), min_size=count, max_size=count)))
    first = draw(st.integers(-cells, cells))
    rises = draw(st.lists(st.integers(0, cells), min_size=count - 1, max_size=count - 1))
    values = [first]
    for rise in rises:
        values.append(min(values[-1] + rise, first + cells))
    grid = [Angle.from_degrees(5 * k) for k in (*breaks, *values)]
    return StepFunction(grid[:count], grid[count:], Angle.from_turns(Fraction(1, order)))


def _part_or_reject(corners: list[tuple[int, int]]) -> Part:
    from hypothesis import reject

    try:
        return Part(corners)
    except InvalidPartError:
        reject()


def _in_hull_order(corners: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Gift wrapping on integers, written apart from the library's own hull."""
    start = min(corners)
    chain = [start]
    while True:
        here = chain[-1]
        best = None
        for p in corners:
            if p == here:
                continue
            if best is None:
                best = p
                continue
            cross = (best[0] - here[0]) * (p[1] - here[1]) - (best[1] - here[1]) * (p[0] - here[0])
            farther = (p[0] - here[0]) ** 2 + (p[1] - here[1]) ** 2 > (best[0] - here[0]) ** 2 + (
                best[1] - here[1]
            ) ** 2
            if cross < 0 or (cross == 0 and farther):
                best = p
        if best is None or best == start or len(chain) > len(corners):
            return chain
        chain.append(best)


SPECIAL = [
    Part([(0, 0), (1, 0), (1, 1), (0, 1)], name="square"),
    Part([(0, 0), (3, 0), (3, 2), (0, 2)], name="rectangle"),
    Part([(0, 0), (1, 0), (0, 1)], name="right triangle"),
    Part([(0, 0), (5, 0), (-1, 1)], name="obtuse triangle"),
    Part([(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)], name="period 90, r = 1"),
    Part([(2, 1), (1, 2), (-1, 2), (-2, 1), (-2, -1), (-1, -2), (1, -2), (2, -1)], name="octagon"),
    Part([(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)], name="square of 8"),
    Part([(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)], name="L"),
]
"""Corners of the input space: squares, shared squeeze functions, hidden symmetry, collinearity."""


# --- made of the above --------------------------------------------------------------------------

NEAR = [(dx, dy) for dx in range(-4, 5) for dy in range(-4, 5)]

orientations = st.sampled_from(
    [Angle(turn, d) for turn in (0, -2, 1) for d in NEAR if d != (0, 0)]
    + [Angle(Fraction(k, 24)) for k in range(-30, 60)]
    + [Angle(0, (10**40 + k, 10**39 * k)) for k in range(-9, 10)]
)
"""Lifted angles of all kinds, as `angles`, of fewer values, drawn much faster."""

rational_orientations = orientations.filter(lambda angle: angle.turn_part.denominator == 1)
"""Those that are rational directions."""


def squeezes() -> st.SearchStrategy[StepFunction]:
    """Squeeze functions of `parts`: values between their breaks, period at most 180 degrees."""
    return parts().map(squeeze_function)


def transfer_functions() -> st.SearchStrategy[StepFunction]:
    """Step maps of both kinds."""
    return st.one_of(step_functions(), squeezes())


ratios = st.sampled_from([Fraction(p, q) for q in (1, 2, 3, 7, 12) for p in range(-20, 21)])
"""Rationals as `fractions`, of fewer values, drawn much faster."""

shifts = st.tuples(ratios, ratios)

factors = shifts.filter(lambda p: p != (0, 0))
"""Complex numbers to multiply a part by."""


@st.composite
def rational_parts(draw: st.DrawFn) -> Part:
    """Grid parts turned, scaled and moved to coordinates with denominators of all kinds."""
    return draw(parts()).multiply(draw(factors)).translate(*draw(shifts))


@st.composite
def circle_parts(draw: st.DrawFn) -> Part:
    """Convex parts with vertices on the unit circle and 40-bit denominators, all different.

    No small common denominator exists, so that their points are homogeneous.
    """
    slopes = draw(st.lists(st.integers(-30, 30), min_size=3, max_size=8, unique=True))
    corners = []
    for k, slope in enumerate(sorted(slopes)):
        t = Fraction(slope * 10**5 + k, 10**6 + 7 * k)  # of half the polar angle
        corners.append(((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)))
    # Different denominators may have exchanged neighbours on the circle.
    corners.sort(key=lambda p: Angle(0, p))
    return _part_or_reject(corners)


@st.composite
def nearly_regular(draw: st.DrawFn, *, most: int = 11) -> Part:
    """Convex parts close to regular polygons, whose plans are long: n steps where n is odd."""
    n = draw(st.integers(4, most))
    moves = draw(st.lists(st.sampled_from(NEAR), min_size=n, max_size=n))
    turns = [2 * math.pi * k / n for k in range(n)]
    return _part_or_reject(
        [
            (round(1000 * math.cos(turn)) + dx, round(1000 * math.sin(turn)) + dy)
            for turn, (dx, dy) in zip(turns, moves, strict=True)
        ]
    )


@st.composite
def necklaces(draw: st.DrawFn) -> StepFunction:
    """Step maps with breaks on a grid of 30 degrees and a value 15 degrees after each break.

    Given as maps of period 360 degrees, most have a smaller one; many are rotations of others.
    """
    cells = 12 // draw(st.sampled_from([1, 2, 3, 4]))
    word = draw(st.sets(st.integers(0, cells - 1), min_size=1, max_size=6))
    beads = [k for k in range(12) if k % cells in word]
    return StepFunction(
        [Angle.from_degrees(30 * k) for k in beads],
        [Angle.from_degrees(30 * k + 15) for k in beads],
    )


mixtures = st.sampled_from([(a, b) for a in (0, 1, 2, 3, 10**6, 10**30) for b in (1, 2, 5)])
"""Weights of the two ends of a range: an angle strictly above the lower one, at most the upper."""


# --- numbers and sequences at the limits --------------------------------------------------------


def signed(least: int, most: int) -> st.SearchStrategy[int]:
    """Integers of a size from `least` to `most`; hypothesis by itself prefers small ones."""
    return st.builds(
        lambda size, sign: size * sign, st.integers(least, most), st.sampled_from([1, -1])
    )


int64s = st.one_of(
    small,
    signed(2**31, 2**53 - 1),
    signed(2**53, 2**63 - 1),
    st.sampled_from([s * 2**e + d for e in (52, 53, 62) for d in (-1, 0, 1) for s in (-1, 1)]),
    st.sampled_from([-(2**63), 1 - 2**63, 2**63 - 1, 2**63 - 2]),
)
"""Machine integers, those about the limits of float64 and int64 among them."""

long_directions = st.tuples(signed(10**39, 10**40), signed(10**30, 10**40))
"""Directions of some 40 digits."""

long_fractions = st.one_of(
    st.builds(Fraction, st.integers(-99, 99), st.integers(1, 12)),
    st.builds(Fraction, signed(0, 10**31), st.integers(10**29, 10**30)),
)
"""Rationals, some with denominators of 30 digits."""

TINY = Angle(0, (2**200, 1))
"""An angle of about 2**-200: no float64 near another angle shows it."""


@st.composite
def near_ties(draw: st.DrawFn) -> tuple[int, int, int, int]:
    """Integers (a, b, c, d) below 2**53 with a d - b c from -2 to 2.

    Mostly the two products are above 2**100, so that float64 rounds them to one number.
    """
    large = st.integers(2**52, 2**53 - 1)
    a, b = draw(large), draw(large)
    common = gcd(a, b)
    a, b = a // common, b // common
    difference = draw(st.integers(-2, 2))
    d = difference * pow(a, -1, b) % b
    c = (a * d - difference) // b
    s, t = draw(st.sampled_from([(1, 1), (1, -1), (-1, 1), (-1, -1)]))
    return s * a, s * b, t * c, t * d


@st.composite
def lifted_sequences(draw: st.DrawFn) -> tuple[list[Angle], Angle]:
    """One period of an increasing sequence of angles, and the period: 90, 180 or 360 degrees.

    Entries lie on a grid of 5 degrees or on directions of small integers; some are moved by
    `TINY`. So differences of entries are often equal, or differ by `TINY` only.
    """
    degrees = draw(st.sampled_from([90, 180, 360]))
    period = Angle.from_degrees(degrees)
    grid = [Angle.from_degrees(5 * k) for k in range(degrees // 5)]
    slopes = draw(st.lists(directions, max_size=8)).copy()
    pool = grid + [Angle(0, p) for p in slopes if Angle(0, p) < period]
    entries = set(draw(st.lists(st.sampled_from(pool), min_size=1, max_size=8)))
    moved = draw(st.sets(st.sampled_from(sorted(entries))))
    entries |= {entry + TINY for entry in moved if draw(st.booleans())}
    shift = draw(st.sampled_from([Angle(0), Angle(2), Angle(-1, (3, 4)), Angle.from_degrees(71)]))
    return sorted(entry + shift for entry in entries), period


@st.composite
def symmetric_hulls(draw: st.DrawFn) -> Part:
    """Convex parts with a symmetry of 180 or 90 degrees."""
    half = draw(st.lists(points, min_size=2, max_size=5, unique=True))
    corners = {q for x, y in half for q in [(x, y), (-x, -y)]}
    if draw(st.booleans()):
        corners |= {(-y, x) for x, y in corners}
    return _part_or_reject(_in_hull_order(sorted(corners)))


@st.composite
def pushable_parts(draw: st.DrawFn) -> Part:
    """Parts of all kinds with a centre of mass strictly inside the hull.

    Mostly a point of the half-integer grid, so that it often lies straight over an edge's end;
    else a mean of the hull's corners by random weights.
    """
    part = draw(st.one_of(parts(), parts(), symmetric_hulls(), nearly_regular()))
    corners = part.hull.points.pairs()
    weights = draw(st.lists(st.integers(1, 9), min_size=len(corners), max_size=len(corners)))
    x, y = (
        sum(w * c[axis] for w, c in zip(weights, corners, strict=True)) / sum(weights)
        for axis in (0, 1)
    )
    if draw(st.integers(0, 3)):
        near = Part(part.vertices, (round(2 * x) / Fraction(2), round(2 * y) / Fraction(2)))
        if near.center_of_mass_side == 1:
            return near
    return Part(part.vertices, (x, y))


# --- centres of mass ----------------------------------------------------------------------------


@st.composite
def centered_parts(draw: st.DrawFn) -> Part:
    """Parts with a centre of mass strictly inside the hull, often a point of a half-unit grid.

    So the centre often lies straight above a vertex, or over the end of an edge. Some parts are
    turned, scaled and moved.
    """
    part = draw(st.one_of(parts(), parts(), nearly_regular(most=7)))
    place = draw(st.sampled_from(["grid", "grid", "weighted", "centroid"]))
    corners = part.hull.points.pairs()
    center = None
    if place == "grid":
        inside = [
            (Fraction(x, 2), Fraction(y, 2))
            for x in range(-9, 10)
            for y in range(-9, 10)
            if _is_inside(corners, x, y)
        ]
        center = draw(st.sampled_from(inside)) if inside else None
    elif place == "weighted":
        weights = draw(st.lists(st.integers(1, 9), min_size=len(corners), max_size=len(corners)))
        center = tuple(
            sum(w * corner[axis] for w, corner in zip(weights, corners, strict=True)) / sum(weights)
            for axis in (0, 1)
        )
    part = Part(part.vertices, center)
    if draw(st.booleans()):
        return part
    return part.multiply(draw(factors)).translate(*draw(shifts))


@st.composite
def long_centered_parts(draw: st.DrawFn) -> Part:
    """Large parts whose centre of mass has a denominator of 20 digits, or misses a grid by 1e-20.

    Their vertices fit machine integers; in units that are whole for the centre they do not.
    """
    part = draw(centered_parts())
    size = 10**9 * (common_denominator([v for p in part.vertices for v in p]))
    if max(abs(v) for p in part.vertices for v in p) * size >= 2**51:
        size = 10**6
    near = st.sampled_from([Fraction(k, 10**20 + 39) for k in (0, 0, 1, -1, 10**20 // 3)])
    cx, cy = part.scale(size).center_of_mass
    return Part(part.scale(size).vertices, (cx + draw(near), cy + draw(near)))


def _is_inside(corners: tuple[tuple[mpq, mpq], ...], x: int, y: int) -> bool:
    """Tell whether (x / 2, y / 2) is strictly to the left of every edge."""
    return all(
        (bx - ax) * (y - 2 * ay) > (by - ay) * (x - 2 * ax)
        for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True)
    )


# --- priors -------------------------------------------------------------------------------------

grid_degrees = st.integers(0, 23).map(lambda k: Fraction(15 * k))
"""Orientations on a grid of 15 degrees, so that windows often begin or end on one."""

grid_widths = st.integers(1, 144).map(lambda k: Fraction(5 * k, 2))
"""Widths on a grid of 2.5 degrees, a full turn among them."""


@st.composite
def weighted_points(draw: st.DrawFn) -> dict[Fraction, Fraction]:
    """Weights of sum 1 on grid orientations, some of them 0, many of them equal."""
    counts = draw(st.dictionaries(grid_degrees, st.integers(0, 3), min_size=1, max_size=8))
    total = sum(counts.values())
    if total == 0:
        counts[next(iter(counts))] = total = 1
    return {place: Fraction(count, total) for place, count in counts.items()}


@st.composite
def histograms(draw: st.DrawFn) -> tuple[list[Fraction], list[int]]:
    """Edges on the grid, the first one perhaps negative, and counts; the bins may leave a gap."""
    first = draw(st.integers(-24, 24))
    steps = sorted(draw(st.sets(st.integers(1, 24), min_size=1, max_size=7)))
    counts = draw(st.lists(st.integers(0, 3), min_size=len(steps), max_size=len(steps)))
    if not any(counts):
        counts[-1] = 1
    return [Fraction(15 * (first + step)) for step in (0, *steps)], counts


@st.composite
def circle_points(draw: st.DrawFn) -> list[tuple[Angle, Fraction]]:
    """Weights of sum 1 at angles of all kinds, some only `TINY` apart."""
    places = draw(st.lists(orientations, min_size=1, max_size=7))
    places += [place + TINY for place in places if draw(st.booleans())]
    counts = [draw(st.integers(1, 3)) for _ in places]
    return [(p, Fraction(count, sum(counts))) for p, count in zip(places, counts, strict=True)]


# --- over real algebraic fields -------------------------------------------------------------------

FIELDS = [quadratic_field(2), quadratic_field(3), quadratic_field(6)] + [
    regular_polygon_field(n) for n in (5, 7, 9, 16, 20)
]
"""Fields with 8, 12, 4, 20, 28, 36, 16 and 20 roots of unity beside i, with and without s."""

fields = st.sampled_from(FIELDS)


@st.composite
def field_numbers(draw: st.DrawFn, field: RealField) -> Algebraic:
    """Numbers a + b s with few small coefficients, often pure, rational or zero."""
    row = st.lists(st.integers(-2, 2), min_size=1, max_size=min(3, field.degree))
    a = draw(st.one_of(row, st.just([0])))
    b = draw(st.one_of(st.none(), row)) if field.square is not None else None
    return Algebraic(field, a, b)


@st.composite
def field_angles(draw: st.DrawFn, field: RealField) -> Angle:
    """Angles over a field: directions, rational ones, roots of unity, rational turns, sums."""
    direction = draw(
        st.one_of(
            st.tuples(field_numbers(field), field_numbers(field)),
            directions,
            st.integers(0, 2 * field.unity - 1).map(lambda k: unity_direction(field, k)),
        ).filter(lambda z: z[0] != 0 or z[1] != 0)
    )
    order = 2 * field.unity
    turns = st.one_of(
        st.integers(-2, 2).map(Fraction),
        st.integers(-order, order).map(lambda k: Fraction(k, order)),
        st.just(Fraction(71, 360)),
    )
    return Angle(draw(turns), direction)


@st.composite
def field_parts(draw: st.DrawFn) -> Part:
    """Regular polygons with some vertices moved in or out, not always convex any more."""
    n = draw(st.sampled_from([5, 6, 7, 8, 9, 12]))
    vertices = list(Part.regular(n).vertices)
    for k in draw(st.sets(st.integers(0, n - 1), max_size=3)):
        share = draw(st.sampled_from([Fraction(9, 10), Fraction(1, 2), Fraction(11, 10)]))
        x, y = vertices[k]
        vertices[k] = x * mpq(share), y * mpq(share)
    return _part_or_reject(vertices)


# --- friction ------------------------------------------------------------------------------------

frictions = st.sampled_from(
    [Fraction(n, d) for n, d in [(0, 1), (1, 100), (1, 20), (1, 4), (1, 3), (1, 2), (1, 1), (3, 1)]]
)
"""Coefficients of friction; on grid parts their cones often end at a vertex or an edge."""


@st.composite
def small_pushable_parts(draw: st.DrawFn) -> Part:
    """Small grid parts, most of them convex, with a centre of mass of a half-unit grid if any."""
    part = draw(st.one_of(hulls(most=5), st.sampled_from(SPECIAL)))
    corners = part.hull.points.pairs()
    inside = [
        (Fraction(x, 2), Fraction(y, 2))
        for x in range(-9, 10)
        for y in range(-9, 10)
        if _is_inside(corners, x, y)
    ]
    return Part(part.vertices, draw(st.sampled_from(inside)) if inside else None)


@st.composite
def cell_sets(draw: st.DrawFn) -> CellSet:
    """Sets with critical orientations on a grid of 30 degrees, so that ends often coincide."""
    places = sorted(draw(st.sets(st.integers(0, 11), max_size=6)))
    flags = st.lists(st.booleans(), min_size=len(places), max_size=len(places))
    arcs = draw(flags) or [draw(st.booleans())]
    return CellSet([Angle.from_degrees(30 * k) for k in places], draw(flags), arcs)


# --- planning problems ---------------------------------------------------------------------------


@st.composite
def distributions(draw: st.DrawFn, size: int) -> list[Fraction]:
    """Probabilities of sum 1 with small denominators, many of them 0 or equal."""
    counts = draw(st.lists(st.sampled_from([0, 0, 1, 1, 2, 3]), min_size=size, max_size=size))
    if not any(counts):
        counts[draw(st.integers(0, size - 1))] = 1
    return [Fraction(count, sum(counts)) for count in counts]


@st.composite
def problem_tables(
    draw: st.DrawFn, *, states: int = 4, actions: int = 3
) -> tuple[list[Fraction], list[list[list[Fraction]]]]:
    """A prior and stochastic matrices; some actions are deterministic, some are alike."""
    n = draw(st.integers(1, states))
    m = draw(st.integers(1, actions))
    tables = []
    for _ in range(m):
        if draw(st.booleans()):
            targets = draw(st.lists(st.integers(0, n - 1), min_size=n, max_size=n))
            tables.append([[Fraction(j == target) for j in range(n)] for target in targets])
        else:
            tables.append([draw(distributions(n)) for _ in range(n)])
    return draw(distributions(n)), tables


action_prices = st.sampled_from([0, 0, Fraction(1, 8), Fraction(1, 2), 1, 2])
"""Prices of actions: free ones and equal ones among them."""

state_costs = st.sampled_from([0, 0, 1, 1, 2, Fraction(-1, 2), Fraction(7, 3), math.inf])
"""Costs of states: equal, negative and infinite ones among them."""


@st.composite
def plan_cases(draw: st.DrawFn, kind: str) -> tuple[tuple, str, list, object]:
    """Tables, a kind of cost, the prices of the actions, and what else the cost needs.

    That is a cost for each state, or of an iterative cost a goal (None: any) and the price of the
    test.
    """
    tables = draw(problem_tables())
    n, m = len(tables[0]), len(tables[1])
    prices = draw(st.lists(action_prices, min_size=m, max_size=m))
    if kind == "iterative":
        goal = draw(st.none() | st.sets(st.integers(0, n - 1), min_size=1))
        return tables, kind, prices, (goal, draw(st.sampled_from([0, 1, Fraction(3, 2)])))
    return tables, kind, prices, draw(st.lists(state_costs, min_size=n, max_size=n))


@st.composite
def decision_problems(draw: st.DrawFn) -> tuple[DecisionProblem, list[Fraction]]:
    """Decision problems of up to 3 states, readings and actions, with a prior; losses often tie."""
    n, r, m = (draw(st.integers(1, 3)) for _ in range(3))
    likelihood = [draw(distributions(r)) for _ in range(n)]
    losses = st.lists(st.integers(-2, 3), min_size=m, max_size=m)
    loss = [draw(losses) for _ in range(n)]
    problem = DecisionProblem(range(n), range(r), range(m), likelihood, loss)
    return problem, draw(distributions(n))


# --- sensors -------------------------------------------------------------------------------------


@st.composite
def likelihoods(draw: st.DrawFn, states: int, *, readings: int = 3) -> list[list[Fraction]]:
    """A row of reading probabilities for each state; half of the tables are without noise."""
    count = draw(st.integers(1, readings))
    if draw(st.booleans()):
        seen = draw(st.lists(st.integers(0, count - 1), min_size=states, max_size=states))
        return [[Fraction(k == x) for k in range(count)] for x in seen]
    return [draw(distributions(count)) for _ in range(states)]


look_prices = st.sampled_from([0, 0, 0, Fraction(1, 4), 1])
"""Costs of a look; most are free."""
# --- tray tilting --------------------------------------------------------------------------------


@st.composite
def transition_models(
    draw: st.DrawFn, most_states: int = 4, most_actions: int = 3
) -> TransitionModel:
    """Few states, few tilts, counts from 0 to 3: rows alike, never observed, and sure."""
    states, actions = draw(st.integers(1, most_states)), draw(st.integers(1, most_actions))
    width = states + draw(st.booleans())
    table = st.lists(st.integers(0, 3), min_size=width, max_size=width)
    counts = [[draw(table) for _ in range(states)] for _ in range(actions)]
    alpha = draw(st.sampled_from([Fraction(1, 100), Fraction(1), Fraction(7, 3)]))
    return TransitionModel(TransitionCounts(counts), alpha)


@st.composite
def tilt_instances(draw: st.DrawFn) -> tuple[TransitionModel, int, int]:
    """A model, a start and a goal, now and then the same state."""
    model = draw(transition_models())
    state = st.integers(1, model.counts.states)
    return model, draw(state), draw(state)


@st.composite
def long_ways(draw: st.DrawFn) -> tuple[TransitionModel, int, int]:
    """Four states and tilts that lead from each to nearly one other: the best paths are long."""
    counts = []
    for _ in range(draw(st.integers(1, 2))):
        targets = draw(st.permutations(range(4)))
        trials = draw(st.lists(st.integers(1, 9), min_size=4, max_size=4))
        counts.append(
            [[n * (j == to) for j in range(4)] for to, n in zip(targets, trials, strict=True)]
        )
    model = TransitionModel(TransitionCounts(counts), draw(st.sampled_from(["1/100", "1/4"])))
    return model, draw(st.integers(1, 4)), draw(st.integers(1, 4))
