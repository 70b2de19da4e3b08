"""The tile slides: a rigid-body engine in the place of the robot.

Seen from above, a tray tilted by the angle t pulls the tile with the acceleration g sin t in the
direction of the tilt, and presses it to the floor with m g cos t. The pressure is spread over the
tile by Gauss-Legendre points; at each of them friction of its share of mu m g cos t acts against
the motion of that point. So a tile that spins meets less resistance to sliding, and the other way
round. Below the speed that friction takes away in one step, mu g cos t dt, the force falls in
proportion to the speed: a tile that friction holds creeps at less than that.

(Pivot joints of the engine with a force limit would be less work and are wrong: such a joint acts
against the motion seen through the inertia of the body at that point, not against the motion.)

Contact with the walls (friction, restitution) is the engine's. It is pymunk, the extra `sim`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, Final, final

import numpy as np

from stochgeom.errors import MissingExtraError, SimulationError
from stochgeom.tilting.states import TilePose
from stochgeom.tilting.tray import GRAVITY, Solver, TraySetup

if TYPE_CHECKING:  # an extra: loaded where a trial runs
    import pymunk

_WALL: Final = 100.0
"""Thickness of the walls in millimetres: nothing tunnels through."""

_MASS: Final = 1.0
"""Cancels out: every force on the tile is proportional to it."""

_SLOP: Final = 0.05
"""Millimetres by which shapes may overlap at rest, so that contacts do not flicker."""

_OVERLAP_LEFT: Final = 1e-15
"""Share of an overlap that is left after a second: an impact leaves up to a step's way of it."""

INSIDE: Final = 0.5
"""Millimetres by which a corner of the tile may be inside a wall."""

_CHECK_SECONDS: Final = 0.008

Watch = Callable[[float, TilePose, float], None]
"""Called after every step with the time, the pose and the energy per mass in mm^2/s^2."""


@final
@dataclass(frozen=True, slots=True)
class Tilt:
    """One tilt as it really is: direction, amount, friction.

    Attributes
    ----------
    azimuth, angle : float
        Degrees; the direction is counter-clockwise from the x axis.
    support_friction, wall_friction : float
        Coefficients.
    """

    azimuth: float
    angle: float
    support_friction: float
    wall_friction: float


@final
@dataclass(frozen=True, slots=True)
class Rest:
    """How a trial ended: the tile at rest and inside the tray.

    Attributes
    ----------
    pose : TilePose
        Where.
    seconds : float
        When, counted from the tilt.
    speed : float
        The speed of the fastest point, at most, in millimetres per second.
    """

    pose: TilePose
    seconds: float
    speed: float


def slide_tile(
    setup: TraySetup,
    pose: TilePose,
    tilt: Tilt,
    *,
    velocity: tuple[float, float, float] = (0.0, 0.0, 0.0),
    watch: Watch | None = None,
) -> Rest:
    """Tilt the tray and wait until the tile is at rest.

    Laid flat again, the tray leaves it there: nothing pulls at it any more.

    Parameters
    ----------
    setup : TraySetup
        Tray, tile, solver; its frictions and angles are those of `tilt`.
    pose : TilePose
        Where the tile lies.
    tilt : Tilt
        What is done.
    velocity : (float, float, float), optional
        Initial velocity (mm/s, mm/s, rad/s), for experiments.
    watch : callable, optional
        Sees every step.

    Raises
    ------
    MissingExtraError
        If pymunk is not installed.
    SimulationError
        If the tile is not at rest within the limit, or outside of the tray.

    Examples
    --------
    A tile at the upper wall, tilted to the left, slides into the corner:

    >>> tilt = Tilt(azimuth=180.0, angle=25.0, support_friction=0.1, wall_friction=0.7)
    >>> rest = slide_tile(TraySetup(), TilePose(0.0, 100.0, 0.0), tilt)
    >>> round(rest.pose.x), round(rest.pose.y), rest.seconds < 1
    (-75, 100, True)
    """
    space, body = tray_space(setup, tilt)
    floor = tray_floor(setup, tilt)
    body.position, body.angle = (pose.x, pose.y), pose.angle
    body.velocity, body.angular_velocity = velocity[:2], velocity[2]
    pull = GRAVITY * math.sin(math.radians(tilt.angle))
    direction = math.radians(tilt.azimuth)
    gravity = pull * math.cos(direction), pull * math.sin(direction)
    space.gravity = gravity
    inertia = body.moment / _MASS

    def see(seconds: float) -> None:
        assert watch is not None
        x, y = body.position
        kinetic = (body.velocity.dot(body.velocity) + inertia * body.angular_velocity**2) / 2
        watch(seconds, TilePose(x, y, body.angle), kinetic - gravity[0] * x - gravity[1] * y)

    watcher = see if watch is not None else None
    seconds = run_until_rest(space, body, floor, setup.reach, setup.solver, watcher)
    x, y = body.position
    rest = Rest(TilePose(x, y, body.angle), seconds, _speed(body, setup.reach))
    _check_inside(setup, rest.pose)
    return rest


def tray_space(setup: TraySetup, tilt: Tilt) -> tuple[pymunk.Space, pymunk.Body]:
    """Return the engine's space with the tray and the tile in it."""
    engine = load_engine()
    space = engine.Space()
    space.iterations = setup.solver.iterations
    space.collision_slop = _SLOP
    space.collision_bias = _OVERLAP_LEFT
    near, far = setup.side / 2, setup.side / 2 + _WALL
    for box in (
        (-far, near, far, far),
        (-far, -far, far, -near),
        (-far, -near, -near, near),
        (near, -near, far, near),
    ):
        wall = engine.Poly(space.static_body, _box_corners(*box))
        wall.friction, wall.elasticity = tilt.wall_friction, setup.restitution
        space.add(wall)
    length, width = setup.tile_length, setup.tile_width
    corners = _box_corners(-length / 2, -width / 2, length / 2, width / 2)
    body = engine.Body(_MASS, _MASS * (length**2 + width**2) / 12)
    tile = engine.Poly(body, corners)
    tile.friction = tile.elasticity = 1.0  # the engine multiplies with the wall's
    space.add(body, tile)
    return space, body


def support_points(setup: TraySetup) -> list[tuple[float, float, float]]:
    """Return where the floor carries the tile, with shares of its weight: x, y, share."""
    along = setup.solver.support_points
    return [
        (x * setup.tile_length / 2, y * setup.tile_width / 2, p * q)
        for x, p in _gauss_points(along)
        for y, q in _gauss_points(max(1, along // 2))
    ]


@cache
def _gauss_points(count: int) -> list[tuple[float, float]]:
    """Return nodes in [-1, 1] and weights of sum 1."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return [(float(x), float(p) / 2) for x, p in zip(nodes, weights, strict=True)]


def tray_floor(setup: TraySetup, tilt: Tilt) -> Floor:
    """Return the floor under the tile."""
    deceleration = tilt.support_friction * GRAVITY * math.cos(math.radians(tilt.angle))
    return Floor(support_points(setup), _MASS * deceleration, deceleration * setup.solver.time_step)


@final
class Floor:
    """Friction under a body, point by point.

    Parameters
    ----------
    points : iterable of (x, y, share)
        In the body's frame; shares of the weight, of sum 1.
    force : float
        Of friction when every point slides in one direction.
    creep : float
        Speed below which the friction of a point falls in proportion to its speed.
    """

    def __init__(
        self, points: Iterable[tuple[float, float, float]], force: float, creep: float
    ) -> None:
        self._points = [(x, y, share * force) for x, y, share in points] if force > 0 else []
        self.creep = creep

    def drag(self, body: pymunk.Body) -> None:
        """Let the floor act on a body during the next step."""
        if not self._points:
            return
        angle, spin = body.angle, body.angular_velocity
        vx, vy = body.velocity
        cos, sin = math.cos(angle), math.sin(angle)
        # In the body's frame the points stand still, and its velocity turns.
        vx, vy = cos * vx + sin * vy, cos * vy - sin * vx
        creep, sqrt = self.creep, math.sqrt
        fx = fy = torque = 0.0
        for x, y, force in self._points:
            ux, uy = vx - spin * y, vy + spin * x
            speed = sqrt(ux * ux + uy * uy)
            scale = force / (speed if speed > creep else creep)
            fx -= scale * ux
            fy -= scale * uy
            torque += scale * (y * ux - x * uy)
        body.force = cos * fx - sin * fy, sin * fx + cos * fy
        body.torque = torque


def run_until_rest(
    space: pymunk.Space,
    body: pymunk.Body,
    floor: Floor,
    reach: float,
    solver: Solver,
    see: Callable[[float], None] | None = None,
) -> float:
    """Step until the body has been slow for `rest_seconds`; return the seconds it took.

    Slow is below `rest_speed`, and what the floor lets creep comes on top.

    Raises
    ------
    SimulationError
        If that takes more than `limit_seconds`.
    """
    step, every = solver.time_step, max(1, round(_CHECK_SECONDS / solver.time_step))
    slow = solver.rest_speed + floor.creep
    steps, quiet = 0, 0.0
    while quiet < solver.rest_seconds:
        if steps * step >= solver.limit_seconds:
            raise SimulationError(
                f"not at rest after {solver.limit_seconds} s: still at {_speed(body, reach):.1f} "
                f"mm/s; accepted: below {slow:.1f} mm/s"
            )
        for _ in range(every):
            floor.drag(body)
            space.step(step)
            steps += 1
            if see is not None:
                see(steps * step)
        quiet = quiet + every * step if _speed(body, reach) < slow else 0.0
    return steps * step


def load_engine() -> Any:
    """Return the module pymunk.

    Raises
    ------
    MissingExtraError
        If it is not installed.
    """
    try:
        import pymunk
    except ImportError as error:
        raise MissingExtraError.of("simulated trials", "pymunk", "sim") from error
    return pymunk


def _box_corners(left: float, low: float, right: float, high: float) -> list[tuple[float, float]]:
    return [(left, low), (right, low), (right, high), (left, high)]


def _speed(body: pymunk.Body, reach: float) -> float:
    """Return a bound on the speed of the body's points."""
    return float(body.velocity.length + abs(body.angular_velocity) * reach)


def _check_inside(setup: TraySetup, pose: TilePose) -> None:
    cos, sin = abs(math.cos(pose.angle)), abs(math.sin(pose.angle))
    half_x = (setup.tile_length * cos + setup.tile_width * sin) / 2
    half_y = (setup.tile_length * sin + setup.tile_width * cos) / 2
    most = setup.side / 2 + INSIDE
    # Written so that NaN fails.
    if not (abs(pose.x) + half_x <= most and abs(pose.y) + half_y <= most):
        raise SimulationError(
            f"the tile ended at ({pose.x:.1f}, {pose.y:.1f}) mm, turned by "
            f"{math.degrees(pose.angle):.1f} degrees; accepted: inside the tray"
        )
