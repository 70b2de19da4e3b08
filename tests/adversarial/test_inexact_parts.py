"""Inexact parts where it hurts: hostile families, degenerate contacts, large and tiny numbers."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from gmpy2 import mpq

from stochgeom.errors import InvalidPartError
from stochgeom.feeding.adversarial import FAMILIES
from stochgeom.feeding.nearby_courses import NearbyCourses
from stochgeom.feeding.part_errors import tolerance_of
from stochgeom.feeding.planner import orient_up_to_symmetry, plan_feeding
from stochgeom.feeding.verification import verify_plan
from stochgeom.geometry.part import Part
from stochgeom.transfer.squeeze import squeeze_function
from tests.laws.test_part_error_laws import DIRECTIONS, ends_in

SIZES = {"Reuleaux-like parts": 7, "spirals": 8, "near ties": 12, "slivers": 10}


def samples(part, epsilon, count):
    """Yield parts with every vertex epsilon off."""
    chance = random.Random(7)
    for _ in range(count):
        corners = []
        for x, y in part.vertices:
            dx, dy = chance.choice(DIRECTIONS)
            corners.append((x + epsilon * mpq(dx), y + epsilon * mpq(dy)))
        try:
            yield Part(corners)
        except InvalidPartError:
            continue


@pytest.mark.parametrize("name", sorted(FAMILIES))
def test_hostile_families(name):
    for seed in (1, 2):
        plan = plan_feeding(FAMILIES[name](SIZES.get(name, 6), seed=seed))
        epsilon = tolerance_of(plan)
        report = NearbyCourses.of_plan(plan, plan.part).report(epsilon)
        assert report.proven
        for other in samples(plan.part, epsilon, 5):
            ends_in(report, plan, squeeze_function(other))


@pytest.mark.parametrize(
    "corners",
    [
        [(0, 0), (1, 0), (0, 1)],  # the apex straight above the end of an edge
        [(-1, -1), (1, -1), (1, 1), (0, 2), (-1, 1)],  # a roof edge below a right angle
    ],
)
@pytest.mark.parametrize("epsilon", ["1e-3", "1e-12", "1e-25"])
def test_contacts_at_a_right_angle_spoil_plans(corners, epsilon):
    plan = orient_up_to_symmetry(corners)
    assert tolerance_of(plan) == 0
    assert not verify_plan(corners, plan, vertex_error=epsilon).part_errors.proven
    # One vertex moved that little makes another edge stable.
    steps = set()
    for k, (x, y) in enumerate(corners):
        for dx, dy in DIRECTIONS:
            move = [*corners]
            move[k] = (x + Fraction(epsilon) * dx, y + Fraction(epsilon) * dy)
            steps.add(len(squeeze_function(move)))
    assert max(steps) > len(squeeze_function(corners))


@pytest.mark.parametrize("factor", [Fraction(1, 10**300), 10**300, Fraction(10**40, 3)])
def test_scale_does_not_matter(factor):
    corners = [(0, 0), (9, 0), (10, 4), (2, 5)]
    plain = plan_feeding(corners)
    large = plan_feeding([(x * factor, y * factor) for x, y in corners])
    assert large.angles == plain.angles
    ratio = tolerance_of(large) / tolerance_of(plain) / mpq(factor)
    assert mpq(1023, 1025) < ratio < mpq(1025, 1023)


def test_a_vertex_a_hair_inside_the_outline():
    # It may come out as soon as epsilon is above half a hair: then the long edge bends there.
    hair = Fraction(1, 10**6)
    corners = [(0, 0), (4, hair), (9, 0), (10, 4), (2, 5)]
    plain = plan_feeding([(0, 0), (9, 0), (10, 4), (2, 5)])
    dented = plan_feeding(corners)
    assert dented.angles == plain.angles
    assert 0 < tolerance_of(dented) < tolerance_of(plain)


def test_thin_parts():
    rod = [(0, 0), (1000, 0), (1000, 1), (0, 1)]
    plan = plan_feeding(rod)
    epsilon = tolerance_of(plan)
    assert 0 < epsilon < mpq(1, 2)
    for other in samples(plan.part, epsilon, 20):
        ends_in(
            NearbyCourses.of_plan(plan, plan.part).report(epsilon), plan, squeeze_function(other)
        )
    assert not verify_plan(rod, plan, vertex_error="0.5").part_errors.proven


def test_an_outline_that_may_cross_itself_is_no_error():
    corners = [(0, 0), (10, 0), (10, 6), (5, "0.01"), (0, 8)]
    report = verify_plan(corners, "0, -45", vertex_error="0.01").part_errors
    assert report.proven == (report.reason is None)
