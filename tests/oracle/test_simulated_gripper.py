"""The simulated gripper beside the exact theory: friction cones, squeeze and push-grasp maps."""

from __future__ import annotations

import math
import sys

import numpy as np
import pytest

from stochgeom.errors import MissingExtraError, SimulationError, TrayError
from stochgeom.exact.angles import Angle
from stochgeom.geometry.part import Part
from stochgeom.grasping.squeeze_stability import SqueezeStability
from stochgeom.thesis.parts import catalogue_part
from stochgeom.tilting.gripper import (
    SimulatedGripper,
    carrying_points,
    random_grasps,
    scaled_corners,
    simulate_push_grasp,
    simulate_squeeze,
)
from stochgeom.transfer.push_grasp import push_grasp_function
from stochgeom.transfer.squeeze import squeeze_function

RECTANGLE = catalogue_part("rectangle")
HOUSE = catalogue_part("house")
HEXAGON = Part([(8, 0), (4, 7), (-4, 7), (-8, 0), (-4, -7), (4, -7)], name="nut")
LOPSIDED = Part([(0, 0), (4, 0), (1, 3)], center_of_mass=("2.1", "0.7"), name="lopsided")
ORIENTATIONS = 40


def lean(corners, theta):
    """Radians from the jaws' normal to the line through the vertices that they touch.

    Its sign is that of the slope of the diameter.
    """
    cos, sin = math.cos(theta), math.sin(theta)
    x, y = cos * corners[:, 0] - sin * corners[:, 1], sin * corners[:, 0] + cos * corners[:, 1]
    low, high = int(np.argmin(y)), int(np.argmax(y))
    return math.atan2(x[high] - x[low], y[high] - y[low])


def wedge_margin(part, theta, friction):
    """Degrees by which a grasp is away from the other outcome; positive if the part wedges.

    A squeeze without friction turns the part down the slope of the diameter. With friction it gets
    no further than to a line inside both friction cones, be it at once or on the way; and it ends
    where an edge is flush and the slope turns up again. Where it does not, but the next line is
    inside the cones, the flush edge is held by friction alone: a margin of 0, too near to call.
    """
    corners, cone = scaled_corners(part), math.atan(friction)
    down = -math.copysign(1.0, lean(corners, theta))
    least, here = math.inf, theta
    while True:
        way = to_next_flush(corners, here, down)
        here += down * way
        # Between flush orientations the same vertices are touched, and their line turns along.
        nearest = min(abs(lean(corners, here - down * f * way)) for f in (1e-9, 1 - 1e-9))
        least = min(least, nearest - cone)
        after = lean(corners, here + down * 1e-7)
        if least < 0 or after * down > 0:
            return -math.degrees(least)
        if abs(after) < cone:
            return 0.0


def to_next_flush(corners, theta, down):
    """Radians to turn from `theta` until an edge is parallel to the jaws."""
    edges = np.roll(corners, -1, axis=0) - corners
    ways = (-down * (np.arctan2(edges[:, 1], edges[:, 0]) + theta)) % math.pi
    return float(ways[ways > 1e-9].min())


def exact_stable_share(part, friction):
    """Measure of the orientations outside all cones: critical angles, and a test between them."""
    corners = scaled_corners(part)
    edges = np.roll(corners, -1, axis=0) - corners
    chords = (corners[:, None] - corners[None, :])[~np.eye(len(corners), dtype=bool)]
    flush = -np.arctan2(edges[:, 1], edges[:, 0])
    upright = math.pi / 2 - np.arctan2(chords[:, 1], chords[:, 0])
    cone = math.atan(friction)
    cuts = np.concatenate([flush, flush + math.pi, upright - cone, upright + cone])
    cuts = np.sort(cuts % (2 * math.pi))
    widths = np.diff(np.append(cuts, cuts[0] + 2 * math.pi))
    middles = cuts + widths / 2
    stable = [wedge_margin(part, theta, friction) <= 0 for theta in middles]
    return float(widths[stable].sum() / (2 * math.pi))


def flush_margin(part, theta):
    """Degrees from the nearest orientation with an edge parallel to the jaws."""
    corners = scaled_corners(part)
    edges = np.roll(corners, -1, axis=0) - corners
    turned = np.degrees(np.arctan2(edges[:, 1], edges[:, 0]) + theta)
    return float(np.abs((turned + 90) % 180 - 90).min())


def angle_of(theta):
    return Angle.from_degrees(repr(round(math.degrees(theta), 9)))


def apart(first, second):
    """Degrees between two orientations in radians."""
    return abs((math.degrees(first - second) + 180) % 360 - 180)


def test_the_share_of_a_rectangle_in_closed_form():
    """Each of two diagonals wedges within arctan mu of upright, both ways round."""
    for friction in (0.05, 0.1, 0.25):
        expected = 1 - 8 * math.atan(friction) / (2 * math.pi)
        assert exact_stable_share(RECTANGLE, friction) == pytest.approx(expected)


@pytest.mark.parametrize("part", [RECTANGLE, HOUSE, HEXAGON, LOPSIDED], ids=lambda part: part.name)
@pytest.mark.parametrize("friction", ["0.1", "0.25", "0.7"])
def test_the_share_is_that_of_the_squeeze_stability_diagram(part, friction):
    exact = 1 - SqueezeStability(part, friction).wedged.measure
    assert exact_stable_share(part, float(friction)) == pytest.approx(float(exact))


@pytest.mark.parametrize("part", [RECTANGLE, HOUSE, HEXAGON], ids=lambda part: part.name)
@pytest.mark.parametrize("friction", [0.1, 0.25])
def test_the_share_of_stable_grasps_is_that_of_the_friction_cones(part, friction):
    found = random_grasps(part, SimulatedGripper(friction=friction), 150, seed=1)
    low, high = found.interval(0.999)
    assert low < exact_stable_share(part, friction) < high


@pytest.mark.parametrize("part", [RECTANGLE, HOUSE, HEXAGON, LOPSIDED], ids=lambda part: part.name)
def test_a_grasp_wedges_where_the_cones_say_so(part):
    """One by one, but for orientations within half a degree of the edge of a cone."""
    gripper, decided = SimulatedGripper(friction=0.2), 0
    for theta in np.random.default_rng(3).uniform(0, 2 * math.pi, ORIENTATIONS):
        margin = wedge_margin(part, theta, gripper.friction)
        if abs(margin) > 0.5 and flush_margin(part, theta) > 1:
            decided += 1
            grasp = simulate_squeeze(part, theta, gripper)
            assert grasp.is_stable == (margin < 0)
            if abs(lean(scaled_corners(part), theta)) < math.atan(0.19):
                assert apart(grasp.after, theta) < 0.5
    assert decided > ORIENTATIONS / 2


@pytest.mark.parametrize("part", [RECTANGLE, HOUSE, HEXAGON], ids=lambda part: part.name)
def test_with_a_sliding_jaw_every_grasp_is_stable(part):
    """Whatever the friction: the source counted 250 of 250."""
    sliding = SimulatedGripper(friction=0.6, sliding_jaw=True)
    assert random_grasps(part, sliding, 60, seed=2).share == 1
    assert random_grasps(part, SimulatedGripper(friction=0.6), 60, seed=2).share < 0.7


def test_half_of_the_grasps_of_a_nut():
    """126 of 250 without the bearing: what a hexagonal nut does with friction .25 to .28."""
    source_low, source_high = 126 / 250 - 0.062, 126 / 250 + 0.062  # 95 %
    assert source_low < exact_stable_share(HEXAGON, 0.26) < source_high


@pytest.mark.parametrize("part", [RECTANGLE, HOUSE, LOPSIDED], ids=lambda part: part.name)
def test_a_sliding_jaw_squeezes_as_the_squeeze_function_says(part):
    function, gripper = squeeze_function(part), SimulatedGripper(friction=0.3, sliding_jaw=True)
    breaks = [b.to_float() for b in function.breaks]
    for theta in np.random.default_rng(4).uniform(0, 2 * math.pi, ORIENTATIONS // 2):
        period = function.period.to_float()
        away = min(abs((theta - b + period / 2) % period - period / 2) for b in breaks)
        if math.degrees(away) > 1:
            grasp = simulate_squeeze(part, theta, gripper)
            assert apart(grasp.after, function(angle_of(theta)).to_float()) < 0.6


@pytest.mark.parametrize("part", [HOUSE, LOPSIDED, HEXAGON], ids=lambda part: part.name)
def test_a_push_first_does_as_the_push_grasp_function_says(part):
    """Off-centre parts among them: the centre of mass decides which way the push turns."""
    function, gripper, decided = push_grasp_function(part), SimulatedGripper(friction=0.0), 0
    period = function.period.to_float()
    breaks = [b.to_float() for b in function.breaks]
    for theta in np.random.default_rng(5).uniform(0, 2 * math.pi, ORIENTATIONS // 2):
        away = min(abs((theta - b + period / 2) % period - period / 2) for b in breaks)
        if math.degrees(away) > 2:
            decided += 1
            grasp = simulate_push_grasp(part, theta, gripper)
            assert apart(grasp.after, function(angle_of(theta)).to_float()) < 0.6
    assert decided > ORIENTATIONS / 4


def test_a_smaller_step_changes_no_grasp():
    """The engine checked against itself, four times as fine."""
    coarse, fine = SimulatedGripper(), SimulatedGripper(time_step=0.00025)
    for theta in np.random.default_rng(6).uniform(0, 2 * math.pi, 12):
        one, other = simulate_squeeze(HOUSE, theta, coarse), simulate_squeeze(HOUSE, theta, fine)
        if abs(wedge_margin(HOUSE, theta, coarse.friction)) > 0.5:
            assert one.is_stable == other.is_stable
            assert apart(one.after, other.after) < 0.5


def test_the_table_carries_the_part_under_its_centre_of_mass():
    for part in (HOUSE, LOPSIDED, HEXAGON):
        points = carrying_points(scaled_corners(part))
        assert all(share > 0 for *_, share in points)
        assert sum(share for *_, share in points) == pytest.approx(1)
        assert sum(x * share for x, _, share in points) == pytest.approx(0, abs=1e-9)
        assert sum(y * share for _, y, share in points) == pytest.approx(0, abs=1e-9)


def test_the_same_seed_makes_the_same_grasps():
    first = random_grasps(RECTANGLE, SimulatedGripper(), 8, seed=1)
    assert first == random_grasps(RECTANGLE, SimulatedGripper(), 8, seed=1)
    assert first.grasps[:4] == random_grasps(RECTANGLE, SimulatedGripper(), 4, seed=1).grasps
    assert first != random_grasps(RECTANGLE, SimulatedGripper(), 8, seed=2)


@pytest.mark.parametrize(
    "change",
    [
        {"friction": -0.1},
        {"force": 0.0},
        {"time_step": 0.1},
        {"speed": math.inf},
        {"iterations": 0},
    ],
)
def test_a_gripper_that_cannot_be_is_refused(change):
    with pytest.raises(TrayError, match="accepted: ") as caught:
        SimulatedGripper(**change)
    assert caught.value.where == next(iter(change))


def test_what_cannot_be_grasped_is_told():
    with pytest.raises(TrayError, match="trials: 0"):
        random_grasps(RECTANGLE, SimulatedGripper(), 0)
    with pytest.raises(SimulationError, match=r"not at rest after 0\.01 s"):
        simulate_squeeze(RECTANGLE, 0.3, SimulatedGripper(limit_seconds=0.01))
    with pytest.raises(TrayError, match="not inside the hull"):
        carrying_points(scaled_corners(Part([(0, 0), (1, 0), (0, 1)], center_of_mass=(2, 2))))


def test_without_the_engine_the_error_names_the_extra(monkeypatch):
    monkeypatch.setitem(sys.modules, "pymunk", None)
    with pytest.raises(MissingExtraError, match=r"stochgeom\[sim\]"):
        simulate_squeeze(RECTANGLE, 0.0, SimulatedGripper())
