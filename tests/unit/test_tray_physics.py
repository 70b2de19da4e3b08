"""The physics of the tray: what must hold whatever the numbers are.

Where a figure has a closed form (sliding down, coming to a stop, sticking to a wall) it is compared
with that; the rest are laws: energy never grows, a tile at rest is inside, symmetry, seeds.
"""

from __future__ import annotations

import math
import sys
from dataclasses import replace

import numpy as np
import pytest
from scipy import integrate

from stochgeom.errors import MissingExtraError, RecordingError, SimulationError, TrayError
from stochgeom.tilting.counts import OTHER
from stochgeom.tilting.physics import Tilt, slide_tile, support_points
from stochgeom.tilting.robot import SimulatedRobot, run_trial, vary
from stochgeom.tilting.states import (
    CANONICAL,
    TilePose,
    azimuth,
    quarter_turn_action,
    quarter_turn_state,
    random_tile_pose,
    tile_state,
)
from stochgeom.tilting.tray import GRAVITY, Solver, TraySetup, setup_from_texts

SETUP = TraySetup()
FLAT = Tilt(azimuth=0.0, angle=0.0, support_friction=0.1, wall_friction=0.7)


# --- states ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("state", range(1, 13))
def test_a_pose_drawn_in_a_state_is_in_it(state):
    random = np.random.default_rng(state)
    for _ in range(200):
        assert tile_state(SETUP, random_tile_pose(SETUP, state, random)) == state


@pytest.mark.parametrize("state", range(1, 13))
def test_a_half_turned_tile_looks_the_same(state):
    pose = random_tile_pose(SETUP, state, np.random.default_rng(1))
    for turns in (-2, -1, 1, 3):
        assert tile_state(SETUP, pose._replace(angle=pose.angle + turns * math.pi)) == state


def test_four_corners_in_two_orientations_and_four_sides():
    assert sum(state.is_corner for state in CANONICAL) == 8
    corners = {(s.right, s.up, s.horizontal) for s in CANONICAL if s.is_corner}
    assert len(corners) == 8
    sides = [state for state in CANONICAL if not state.is_corner]
    assert all(state.horizontal == (state.up != 0) for state in sides)


@pytest.mark.parametrize(
    "pose",
    [
        TilePose(0.0, 0.0, 0.0),
        TilePose(0.0, 75.0, math.pi / 2),  # the short edge at the upper wall
        TilePose(0.0, 97.0, 0.0),  # 3 mm from the wall
        TilePose(0.0, 100.0, math.radians(3.5)),
        TilePose(-70.0, 95.0, 0.0),  # near two walls, at neither
    ],
)
def test_everything_else_is_other(pose):
    assert tile_state(SETUP, pose) == OTHER


def test_a_corner_is_one_wall_touched_and_another_near():
    room_x, room_y = 120 - 45, 120 - 20
    assert tile_state(SETUP, TilePose(-room_x + 11.9, room_y - 1.9, 0.0)) == 3
    assert tile_state(SETUP, TilePose(-room_x + 12.1, room_y - 1.9, 0.0)) == 1
    assert tile_state(SETUP, TilePose(-room_x + 1.9, room_y - 11.9, 0.0)) == 3
    assert tile_state(SETUP, TilePose(-room_x + 2.1, room_y - 2.1, 0.0)) == OTHER


def test_four_quarter_turns_are_none():
    for state in range(1, 13):
        turned = state
        for _ in range(4):
            turned = quarter_turn_state(turned)
        assert turned == state
        assert quarter_turn_state(state) != state
    assert sorted(map(quarter_turn_state, range(1, 13))) == list(range(1, 13))
    assert sorted(map(quarter_turn_action, range(1, 13))) == list(range(1, 13))


def test_turning_the_tray_turns_poses_and_tilts():
    random = np.random.default_rng(4)
    for state in range(1, 13):
        x, y, angle = random_tile_pose(SETUP, state, random)
        assert tile_state(SETUP, TilePose(-y, x, angle + math.pi / 2)) == quarter_turn_state(state)
        turned = azimuth(quarter_turn_action(state)) - azimuth(state)
        assert turned % 360 == 90


# --- closed forms ---------------------------------------------------------------------------------


def path(pose, tilt, seconds, velocity=(0.0, 0.0, 0.0), setup=SETUP):
    """Poses after every step, up to a time; the walls are far away."""
    seen = []
    slide_tile(
        replace(setup, side=20_000.0, corner=12.0),
        pose,
        tilt,
        velocity=velocity,
        watch=lambda time, here, energy: seen.append((time, here, energy)),
    )
    return [row for row in seen if row[0] <= seconds + 1e-9]


def test_a_tile_slides_down_as_galileo_has_it():
    tilt = Tilt(azimuth=90.0, angle=25.0, support_friction=0.1, wall_friction=0.7)
    pull = GRAVITY * (math.sin(math.radians(25)) - 0.1 * math.cos(math.radians(25)))
    for time, here, _ in path(TilePose(0.0, 0.0, 0.3), tilt, 0.3)[99::100]:
        assert here.y == pytest.approx(pull * time**2 / 2, rel=0.02)
        assert abs(here.x) < 1e-6
        assert here.angle == pytest.approx(0.3, abs=1e-6)


def test_a_tile_stays_where_friction_holds_it():
    tilt = Tilt(azimuth=90.0, angle=25.0, support_friction=0.47, wall_friction=0.7)
    time, here, _ = path(TilePose(0.0, 0.0, 0.3), tilt, 1.0)[-1]  # tan 25 = 0.466
    creep = 0.47 * GRAVITY * math.cos(math.radians(25)) * SETUP.solver.time_step
    assert math.hypot(here.x, here.y) < creep * time < 0.5


def test_a_sliding_tile_stops_after_v_squared_over_two_mu_g():
    here = path(TilePose(0.0, 0.0, 0.0), FLAT, 9.0, velocity=(300.0, 400.0, 0.0))[-1][1]
    way = 500.0**2 / (2 * 0.1 * GRAVITY)
    assert math.hypot(here.x, here.y) == pytest.approx(way, rel=0.02)
    assert here.y / here.x == pytest.approx(4 / 3, rel=1e-3)


def spin_down(points):
    """The angle through which a spinning tile turns before it rests."""
    setup = SETUP.with_solver(support_points=points)
    return path(TilePose(0.0, 0.0, 0.0), FLAT, 9.0, (0.0, 0.0, 8.0), setup)[-1][1].angle


def test_a_spinning_tile_stops_as_its_pressed_area_has_it():
    """The torque is mu p times the integral of r over the area; points approach it."""
    a, b = SETUP.tile_length / 2, SETUP.tile_width / 2
    mean_radius = integrate.dblquad(lambda y, x: math.hypot(x, y), 0, a, 0, b)[0] / (a * b)
    inertia = (4 * a * a + 4 * b * b) / 12
    angle = 8.0**2 * inertia / (2 * 0.1 * GRAVITY * mean_radius)
    assert spin_down(4) == pytest.approx(angle, rel=0.03)
    assert spin_down(16) == pytest.approx(angle, rel=0.01)


def test_spinning_eases_sliding():
    """Friction that has to stop the spin as well opposes the motion less: it goes further."""
    plain = path(TilePose(0.0, 0.0, 0.0), FLAT, 9.0, (500.0, 0.0, 0.0))[-1][1]
    spinning = path(TilePose(0.0, 0.0, 0.0), FLAT, 9.0, (500.0, 0.0, 20.0))[-1][1]
    assert spinning.x > 1.05 * plain.x


@pytest.mark.parametrize(("friction", "stays"), [(0.62, True), (0.52, False)])
def test_wall_friction_holds_up_to_its_angle(friction, stays):
    """A tilt 30 degrees off the wall's normal, tan 30 = .577, a floor without friction."""
    tilt = Tilt(azimuth=60.0, angle=25.0, support_friction=0.0, wall_friction=friction)
    rest = slide_tile(SETUP, TilePose(0.0, 100.0, 0.0), tilt)
    assert (abs(rest.pose.x) < 1.0) == stays
    assert tile_state(SETUP, rest.pose) == (1 if stays else 12)


# --- laws -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(6))
def test_energy_never_grows_without_a_tilt(seed):
    random = np.random.default_rng(seed)
    velocity = (*random.uniform(-900, 900, 2), random.uniform(-10, 10))
    energies = []
    slide_tile(
        SETUP,
        TilePose(*random.uniform(-40, 40, 2), random.uniform(0, math.pi)),
        FLAT,
        velocity=velocity,
        watch=lambda *seen: energies.append(seen[2]),
    )
    assert energies[0] > 1e4
    # A contact is solved by rounds, not exactly: a thousandth of the first energy is allowed for.
    assert np.diff(energies).max() < 1e-3 * energies[0]
    assert energies[-1] < 1.0


@pytest.mark.parametrize("seed", range(4))
def test_with_a_tilt_energy_only_goes_down_the_slope(seed):
    """Kinetic and potential energy together never grow."""
    random = np.random.default_rng(seed)
    energies = []
    slide_tile(
        SETUP,
        TilePose(*random.uniform(-40, 40, 2), random.uniform(0, math.pi)),
        vary(SETUP, int(random.integers(1, 13)), random),
        watch=lambda *seen: energies.append(seen[2]),
    )
    drop = energies[0] - energies[-1]
    assert drop > 0
    assert np.diff(energies).max() < 1e-3 * drop


@pytest.mark.parametrize("action", [1, 4, 7, 10])
def test_without_friction_the_tile_ends_at_the_lowest_wall(action):
    tilt = Tilt(azimuth(action), 25.0, support_friction=0.0, wall_friction=0.0)
    random = np.random.default_rng(action)
    wall = CANONICAL[action - 1]
    for _ in range(5):
        pose = TilePose(*random.uniform(-60, 60, 2), random.uniform(0, math.pi))
        end = slide_tile(SETUP, pose, tilt).pose
        # The lowest place is the long edge flush; the short edge is a lower bound of its own.
        depth = end.x * wall.right + end.y * wall.up
        lowest = 120 - SETUP.tile_width / 2, 120 - SETUP.tile_length / 2
        assert min(abs(depth - low) for low in lowest) < 0.5


@pytest.mark.parametrize("action", [2, 3, 5, 9])
def test_without_friction_a_slanted_tilt_ends_in_the_lowest_corner(action):
    tilt = Tilt(azimuth(action), 25.0, support_friction=0.0, wall_friction=0.0)
    direction = math.radians(azimuth(action))
    random = np.random.default_rng(action)
    for _ in range(5):
        pose = TilePose(*random.uniform(-60, 60, 2), random.uniform(0, math.pi))
        state = CANONICAL[int(tile_state(SETUP, slide_tile(SETUP, pose, tilt).pose)) - 1]
        assert state.right == math.copysign(1, math.cos(direction))
        assert state.up == math.copysign(1, math.sin(direction))


def test_every_trial_ends_inside_and_at_rest():
    random = np.random.default_rng(0)
    for number in range(120):
        pose = random_tile_pose(SETUP, number % 12 + 1, random)
        rest = slide_tile(SETUP, pose, vary(SETUP, number // 12 + 1, random))
        assert rest.speed < SETUP.solver.rest_speed
        assert rest.seconds >= SETUP.solver.rest_seconds
        cos, sin = math.cos(rest.pose.angle), math.sin(rest.pose.angle)
        for dx, dy in ((45, 20), (45, -20), (-45, 20), (-45, -20)):
            assert abs(rest.pose.x + cos * dx - sin * dy) < 120.5
            assert abs(rest.pose.y + sin * dx + cos * dy) < 120.5


def test_rest_is_counted_in_seconds_not_steps():
    """A tile that never moves rests after the same time, whatever the step."""
    held = Tilt(90.0, 5.0, support_friction=0.5, wall_friction=0.5)
    for step in (0.002, 0.001, 0.00025):
        rest = slide_tile(SETUP.with_solver(time_step=step), TilePose(0.0, 0.0, 0.0), held)
        assert rest.seconds == pytest.approx(SETUP.solver.rest_seconds, abs=0.01)


@pytest.mark.parametrize(("state", "action"), [(1, 5), (2, 10), (5, 1), (9, 6), (6, 1)])
def test_turning_the_tray_maps_outcomes_onto_outcomes(state, action):
    """Counts of a trial and of the same trial turned by 90 degrees differ by chance alone."""
    count = 120
    robot = SimulatedRobot(seed=9)
    plain = robot.execute(state, [action], count)
    turned = robot.execute(quarter_turn_state(state), [quarter_turn_action(action)], count)
    mapped = {OTHER: plain[OTHER]}
    mapped |= {quarter_turn_state(s): plain[s] for s in range(1, 13)}
    # For two samples of a kind, the sum over outcomes of (x - y)^2 / (x + y) is about chi-squared.
    kinds = [key for key in turned if turned[key] + mapped[key] > 0]
    distance = sum((turned[k] - mapped[k]) ** 2 / (turned[k] + mapped[k]) for k in kinds)
    assert distance < len(kinds) - 1 + 5 * math.sqrt(2 * len(kinds))


def test_the_law_of_symmetry_can_fail():
    """What the comparison above finds when outcomes are mapped the wrong way round."""
    robot = SimulatedRobot(seed=9)
    plain, turned = robot.execute(1, [5], 60), robot.execute(4, [8], 60)
    assert plain[4] > 20
    assert turned[7] > 20
    assert turned[4] < 10


# --- seeds, processes, errors ---------------------------------------------------------------------


def test_the_same_seed_gives_the_same_trials():
    assert SimulatedRobot(seed=3).trials(60) == SimulatedRobot(seed=3).trials(60)
    assert SimulatedRobot(seed=3).trials(60) != SimulatedRobot(seed=4).trials(60)


def test_no_trial_is_a_repetition():
    trials = SimulatedRobot(seed=3).trials(100)
    assert trials[:50] != trials[50:]
    ends = [run_trial(SETUP, 3, 2, (11, 5), number) for number in range(100)]
    assert ends[:50] != ends[50:]
    assert len(set(ends)) > 1


def test_a_longer_run_continues_a_shorter_one():
    assert SimulatedRobot(seed=3).trials(70)[:30] == SimulatedRobot(seed=3).trials(30)


def test_processes_change_nothing():
    robot, told = SimulatedRobot(seed=3), []
    shared = robot.trials(120, jobs=2, tell=told.append)
    assert shared == robot.trials(120)
    assert (len(told), told[-1]) == (3, 1.0)
    plans = [(1, (4,)), (2, (11, 4))]
    assert robot.execute_all(plans, 60, jobs=2) == robot.execute_all(plans, 60)


def test_executions_start_where_they_should():
    """Without variation the tile slides along its wall into the corner, every time."""
    still = TraySetup(azimuth_sd=0.0, tilt_sd=0.0, friction_spread=0.0)
    assert SimulatedRobot(still).execute(1, [4], 30)[3] == 30
    assert SimulatedRobot(still).execute(1, [], 5)[1] == 5
    assert run_trial(still, 0, 1, (4, 7), 0) == (1, 6)


def test_other_outcomes_are_counted_as_such():
    counts = SimulatedRobot(TraySetup(corner=5.0, touching=2.0), seed=1).observe(300)
    assert counts.has_other
    assert 0 < counts.others < 150
    assert counts.total == 300


def test_a_trial_that_does_not_come_to_rest_is_named():
    hasty = SETUP.with_solver(limit_seconds=0.15)
    with pytest.raises(SimulationError, match=r"^seed 1, trial 0: not at rest after 0.15 s"):
        SimulatedRobot(hasty, seed=1).trials(5)
    with pytest.raises(SimulationError) as caught:  # from another process
        SimulatedRobot(hasty, seed=1).trials(60, jobs=2)
    assert caught.value.where.startswith("seed 1, trial ")
    assert caught.value.message.startswith("not at rest")


def test_a_tile_outside_is_found():
    with pytest.raises(SimulationError, match="accepted: inside the tray"):
        slide_tile(SETUP, TilePose(400.0, 0.0, 0.0), FLAT)


@pytest.mark.parametrize("count", [0, -1, 1.5, True])
def test_zero_trials_are_refused(count):
    with pytest.raises(TrayError, match=r"^trials: .*accepted: whole numbers from 1 on"):
        SimulatedRobot().trials(count)


def test_no_processes_and_bad_seeds_are_refused():
    with pytest.raises(TrayError, match=r"^jobs: 0"):
        SimulatedRobot().trials(1, jobs=0)
    for seed in (-1, 0.5, None):
        with pytest.raises(TrayError, match=r"^seed: "):
            SimulatedRobot(seed=seed)
    with pytest.raises(RecordingError, match="start '13'"):
        SimulatedRobot().execute(13, [1], 1)
    with pytest.raises(RecordingError, match="action '0'"):
        SimulatedRobot().execute(1, [0], 1)


def test_without_the_engine_the_error_names_the_extra(monkeypatch):
    monkeypatch.setitem(sys.modules, "pymunk", None)
    with pytest.raises(MissingExtraError, match=r"stochgeom\[sim\]"):
        SimulatedRobot().trials(1)


@pytest.mark.parametrize(
    ("change", "where"),
    [
        ({"tile_length": 400.0}, "tile_length"),
        ({"tile_length": 215.0, "tile_width": 30.0}, "tile_length"),
        ({"tile_width": 90.0}, "tile_width"),
        ({"tile_width": 0.0}, "tile_width"),
        ({"side": -1.0}, "side"),
        ({"tilt": 0.0}, "tilt"),
        ({"tilt": 91.0}, "tilt"),
        ({"support_friction": -0.1}, "support_friction"),
        ({"wall_friction": math.nan}, "wall_friction"),
        ({"restitution": 1.5}, "restitution"),
        ({"friction_spread": 2.0}, "friction_spread"),
        ({"azimuth_sd": math.inf}, "azimuth_sd"),
        ({"placing_gap": 3.0}, "placing_gap"),
        ({"corner": 30.0}, "corner"),
        ({"turned": 20.0}, "turned"),
        ({"side": "240"}, "side"),
        ({"side": True}, "side"),
    ],
)
def test_a_setup_that_cannot_be_is_refused(change, where):
    with pytest.raises(TrayError, match="accepted: ") as caught:
        TraySetup(**change)
    assert caught.value.where == where


@pytest.mark.parametrize(
    "change",
    [
        {"time_step": 0.0},
        {"time_step": 0.1},
        {"iterations": 0},
        {"iterations": 2.5},
        {"support_points": 0},
        {"rest_seconds": 0.0},
        {"rest_speed": 0.0},
        {"limit_seconds": 0.01},
    ],
)
def test_a_solver_that_cannot_be_is_refused(change):
    with pytest.raises(TrayError, match="accepted: "):
        Solver(**change)


def test_a_setup_is_written_and_read():
    setup = TraySetup(tilt=30, wall_friction=0.1).with_solver(iterations=20, time_step=0.0005)
    assert setup_from_texts(setup.as_texts()) == setup
    assert setup_from_texts({}) == SETUP
    with pytest.raises(TrayError, match="colour: no setting of that name; accepted: azimuth_sd"):
        setup_from_texts({"colour": "1"})
    with pytest.raises(TrayError, match="tilt: 'steep'; accepted: a number"):
        setup_from_texts({"tilt": "steep"})


def test_the_floor_carries_the_whole_weight_under_the_centre():
    points = support_points(SETUP)
    assert sum(share for *_, share in points) == pytest.approx(1)
    assert sum(x * share for x, _, share in points) == pytest.approx(0)
    moment = sum((x * x + y * y) * share for x, y, share in points)
    assert moment == pytest.approx((SETUP.tile_length**2 + SETUP.tile_width**2) / 12)
