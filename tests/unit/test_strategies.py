"""The random input itself: is it what it claims to be, and does it meet the corners often enough?

A law on random input says nothing about corners that the input never visits. The shares asked
for are well below those counted, of examples that are the same at every run.
"""

from __future__ import annotations

from itertools import combinations, pairwise

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, given, settings

from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO
from stochgeom.exact.offset_directions import OffsetDirections
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.geometry.sight import look_around
from stochgeom.grasping.push_stability import PushStability
from stochgeom.grasping.squeeze_stability import SqueezeStability
from tests import strategies

COUNT = 150


def sample(strategy, count=COUNT):
    """Return examples of a strategy, the same at every run and under every profile."""
    found = []

    @settings(
        max_examples=count,
        database=None,
        derandomize=True,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
        deadline=None,
    )
    @given(strategy)
    def collect(value):
        found.append(value)

    collect()
    return found


def share(examples, property_of_one):
    return sum(map(bool, map(property_of_one, examples))) / len(examples)


# --- numbers, directions, angles -----------------------------------------------------------------


def test_directions_are_never_zero_and_often_alike():
    found = sample(strategies.directions)
    assert all(x or y for x, y in found)
    assert {abs(v) for pair in found for v in pair} == {0, 1, 2, 3, 4}
    pairs = list(pairwise(found))
    assert share(pairs, lambda p: p[0][0] * p[1][1] == p[0][1] * p[1][0]) > 0.03
    assert share(pairs, lambda p: p[0][0] * p[1][0] == -p[0][1] * p[1][1]) > 0.01
    assert share(found, lambda p: 0 in p or abs(p[0]) == abs(p[1])) > 0.2


def test_large_directions_are_large():
    found = sample(strategies.large_directions)
    assert share(found, lambda p: max(map(abs, p)) > 2**63) > 0.05
    assert all(max(map(abs, p)) > 2**63 for p in sample(strategies.long_directions))


def test_rotations_have_whole_length():
    for x, y in strategies.PYTHAGOREAN:
        assert int((x * x + y * y) ** 0.5) ** 2 == x * x + y * y


def test_angles_are_of_all_kinds():
    found = sample(strategies.angles())
    assert share(found, lambda a: a.turn_part.denominator > 1) > 0.1
    assert share(found, lambda a: a.rational_turns is None) > 0.3
    assert share(found, lambda a: a.rational_turns is not None) > 0.15
    assert share(found, lambda a: a < ZERO) > 0.1
    assert share(found, lambda a: a > FULL_TURN) > 0.1
    assert share(found, lambda a: max(map(abs, a.direction)) > 2**63) > 0.01
    directions_only = sample(strategies.angles(rational_turns=False))
    assert all(a.turn_part.denominator == 1 for a in directions_only)


def test_arcs_are_sometimes_full_turns():
    found = sample(strategies.arcs())
    assert 0.01 < share(found, lambda a: a.width == FULL_TURN) < 0.5
    assert share(found, lambda a: a.width > HALF_TURN) > 0.1
    assert share(found, lambda a: a.start.reduced() + a.width > FULL_TURN) > 0.1


def test_machine_integers_reach_their_limits():
    found = sample(strategies.int64s, 400)
    assert all(-(2**63) <= v < 2**63 for v in found)
    assert {2**53 - 1, 2**53, 2**53 + 1, -(2**63), 2**63 - 1} <= set(found)
    assert share(found, lambda v: abs(v) >= 2**53) > 0.3
    assert share(found, lambda v: abs(v) <= 4) > 0.01


def test_near_ties_are_ties_in_float64():
    found = sample(strategies.near_ties())
    assert all(abs(v) < 2**53 for row in found for v in row)
    assert all(abs(a * d - b * c) <= 2 for a, b, c, d in found)
    assert share(found, lambda r: r[0] * r[3] != r[1] * r[2]) > 0.4
    assert share(found, lambda r: r[0] * r[3] == r[1] * r[2]) > 0.05
    hidden = [r for r in found if r[0] * r[3] != r[1] * r[2]]
    assert share(hidden, lambda r: float(r[0]) * r[3] == float(r[1]) * r[2]) > 0.5


def test_the_tiny_angle_is_invisible_to_floats():
    assert strategies.TINY.to_float() == 2.0**-200
    assert (HALF_TURN + strategies.TINY).to_float() == np.pi


def test_lifted_sequences_increase_and_have_ties():
    found = sample(strategies.lifted_sequences())
    for entries, period in found:
        assert all(a < b for a, b in pairwise(entries))
        assert entries[-1] - entries[0] < period
    gaps = [[(b - a) % t for a in e for b in e if a != b] for e, t in found]
    assert share(gaps, lambda g: len(set(g)) < len(g)) > 0.3
    assert share(gaps, lambda g: any(a - b == strategies.TINY for a in g for b in g)) > 0.1
    assert {period.degrees(0) for _, period in found} == {"90", "180", "360"}
    assert share(found, lambda s: len(s[0]) == 1) > 0.02


# --- parts ---------------------------------------------------------------------------------------


def edges(part):
    points = part.vertices
    return [
        (q[0] - p[0], q[1] - p[1]) for p, q in zip(points, (*points[1:], points[0]), strict=True)
    ]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def has_parallel_edges(part):
    return any(cross(a, b) == 0 for a, b in combinations(edges(part), 2))


def has_right_angles(part):
    return any(dot(a, b) == 0 for a, b in combinations(edges(part), 2))


def turns(part):
    around = edges(part)
    return [cross(a, b) for a, b in zip(around, (*around[1:], around[0]), strict=True)]


def is_convex(part):
    return all(t > 0 for t in turns(part)) or all(t < 0 for t in turns(part))


def has_point_symmetry(part):
    sums = {(2 * x, 2 * y) for x, y in part.vertices}
    x = sum(p[0] for p in part.vertices) * 2 / len(part)
    y = sum(p[1] for p in part.vertices) * 2 / len(part)
    return {(2 * x - a, 2 * y - b) for a, b in sums} == sums


def test_hulls_are_strictly_convex_and_degenerate_often():
    found = sample(strategies.hulls())
    assert all(is_convex(part) for part in found)
    assert {3, 4, 5, 6, 7} <= {len(part) for part in found}
    assert share(found, has_parallel_edges) > 0.15
    assert share(found, has_right_angles) > 0.2


def test_star_polygons_are_often_not_convex():
    found = sample(strategies.star_polygons())
    assert share(found, lambda part: not is_convex(part)) > 0.3
    assert share(found, lambda part: 0 in turns(part)) > 0.05
    assert {3, 4, 5, 6, 7, 8, 9} <= {len(part) for part in found}


def test_parts_have_symmetries():
    found = sample(strategies.parts())
    assert share(found, has_point_symmetry) > 0.01
    assert all(map(has_point_symmetry, sample(strategies.symmetric_hulls(), 50)))
    assert share(found, has_parallel_edges) > 0.2
    assert {part.name for part in strategies.SPECIAL} <= {part.name for part in found}


def test_rational_parts_have_denominators_of_all_kinds():
    found = sample(strategies.rational_parts())
    denominators = [{v.denominator for p in part.vertices for v in p} for part in found]
    assert share(denominators, lambda some: max(some) > 12) > 0.05
    assert share(denominators, lambda some: some == {1}) < 0.7


def test_circle_parts_lie_on_the_circle_without_a_common_denominator():
    found = sample(strategies.circle_parts())
    for part in found:
        assert all(x * x + y * y == 1 for x, y in part.vertices)
        assert is_convex(part)
    several = [{p[0].denominator for p in part.vertices} for part in found]
    assert share(several, lambda some: len(some) > 1) > 0.9
    assert share(several, lambda some: max(some) > 2**35) > 0.9


# --- step maps -----------------------------------------------------------------------------------


def has_equal_widths(transfer):
    return len(set(transfer.widths)) < len(transfer)


def test_step_functions_have_ties():
    found = sample(strategies.step_functions())
    assert share(found, has_equal_widths) > 0.03
    assert {transfer.order for transfer in found} >= {1, 2, 3, 4, 8}
    assert share(found, lambda transfer: len(transfer) == 1) > 0.02
    assert share(found, lambda transfer: len(transfer) >= 4) > 0.1


@pytest.mark.parametrize("name", ["squeezes", "transfer_functions"])
def test_squeeze_functions_are_among_them(name):
    found = sample(getattr(strategies, name)())
    assert share(found, lambda transfer: transfer.order % 2 == 0) > 0.3
    assert share(found, has_equal_widths) > 0.01
    if name == "squeezes":
        assert all(transfer.period <= HALF_TURN for transfer in found)
        assert share(found, lambda transfer: transfer.period < HALF_TURN) > 0.01


def test_necklaces_have_hidden_periods():
    found = sample(strategies.necklaces())
    assert {transfer.order for transfer in found} >= {1, 2, 3, 4}
    assert share(found, lambda transfer: transfer.order > 1) > 0.5


def test_mixtures_leave_the_lower_end():
    assert all(low >= 0 and high > 0 for low, high in sample(strategies.mixtures))


# --- centres of mass -----------------------------------------------------------------------------


def test_centers_are_inside_and_often_over_ends_of_edges():
    found = sample(strategies.centered_parts())
    assert all(part.center_of_mass_side == 1 for part in found)
    assert share(found, lambda part: part.has_given_center) > 0.5

    def has_a_flat_slope(part):
        sight = look_around(part)
        return (sight.before == 0).any() or (sight.after == 0).any()

    assert share(found, has_a_flat_slope) > 0.1
    assert share(found, lambda part: len(RadiusFunction(part).minima) < len(part.hull)) > 0.2


def test_long_centers_do_not_fit_machine_integers_with_their_parts():
    found = sample(strategies.long_centered_parts())
    assert all(part.center_of_mass_side == 1 for part in found)
    kinds = [type(look_around(part).upright) for part in found]
    assert share(kinds, lambda kind: kind is OffsetDirections) > 0.3


# --- priors --------------------------------------------------------------------------------------


def test_weighted_points_sum_to_one_with_ties_and_zeros():
    found = sample(strategies.weighted_points())
    assert all(sum(points.values()) == 1 for points in found)
    assert share(found, lambda points: 0 in points.values()) > 0.15
    assert share(found, lambda points: len(set(points.values())) < len(points)) > 0.3


def test_histograms_are_sorted_with_gaps_and_empty_bins():
    found = sample(strategies.histograms())
    assert all(len(edges) == len(counts) + 1 and any(counts) for edges, counts in found)
    assert all(a < b for edges, _ in found for a, b in pairwise(edges))
    assert all(edges[-1] - edges[0] <= 360 for edges, _ in found)
    assert share(found, lambda bins: bins[0][-1] - bins[0][0] < 360) > 0.3
    assert share(found, lambda bins: 0 in bins[1]) > 0.2
    assert share(found, lambda bins: bins[0][0] < 0 < bins[0][-1]) > 0.2


def test_circle_points_are_close_to_others_often():
    found = sample(strategies.circle_points())
    assert all(sum(weight for _, weight in points) == 1 for points in found)
    near = [
        any((a + strategies.TINY).reduced() == b.reduced() for a, _ in points for b, _ in points)
        for points in found
    ]
    assert share(near, bool) > 0.3


# --- friction ------------------------------------------------------------------------------------


def test_small_pushable_parts_meet_the_special_cases_of_grasps():
    found = sample(strategies.small_pushable_parts())
    assert all(part.center_of_mass_side == 1 for part in found)
    diagrams = [SqueezeStability(part, "1/4") for part in found]
    assert share(diagrams, lambda d: any(edge.by_friction for edge in d.stable)) > 0.1
    assert share(diagrams, lambda d: any(e.lower_edge and e.upper_edge for e in d.stable)) > 0.1
    assert share(found, lambda part: len(set(PushStability(part).stable)) < len(part.hull)) > 0.2
    clipped = [any(w.width < 2 * d.friction.angle for w in d.wedging) for d in diagrams]
    assert share(clipped, bool) > 0.2


def test_cell_sets_have_points_gaps_and_whole_circles():
    found = sample(strategies.cell_sets())
    assert share(found, lambda cells: cells.is_whole or not cells) > 0.03
    assert share(found, lambda cells: any(not item.width for item in cells)) > 0.1
    assert share(found, lambda cells: any(item.is_closed and item.width for item in cells)) > 0.1
    assert share(found, lambda cells: any(not item.includes_start for item in cells)) > 0.2


# --- tray tilting --------------------------------------------------------------------------------


def test_models_have_rows_never_observed_and_rows_alike():
    found = [model for model, _, _ in sample(strategies.tilt_instances())]
    assert share(found, lambda model: model.undefined_rows) > 0.1
    assert share(found, lambda model: model.counts.has_other) > 0.2
    assert share(found, lambda model: model.counts.states > 1) > 0.4
    rows = [[tuple(row) for matrix in model.counts.table for row in matrix] for model in found]
    assert share(rows, lambda listed: len(set(listed)) < len(listed)) > 0.1
