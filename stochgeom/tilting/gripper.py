"""Two jaws close on a polygon in the engine: with friction, and with one jaw that slides (app. B).

The jaws are parallel to the x axis and close along y, the upper one on the lower one, which stands
still. They begin where both just touch the part, so that what happens is a squeeze and no push. The
upper jaw is driven at a constant speed by a motor that stalls at a certain force.

A part that wedges stays as it is, held at two vertices whose chord is inside both friction cones;
one that does not wedge turns until an edge is flush. A jaw on a bearing gives way sideways: then no
friction holds the part up, and nothing wedges.

In `simulate_push_grasp` the lower jaw first moves up and pushes the part over the table until an
edge is flush; then the upper one closes. Which way the part turns depends on the side of the
contact that its centre of friction lies on, whatever the pressure: the table carries it at points
around the centre of mass, with shares that balance there.

All of this is float. The exact maps are `squeeze_function` and `push_grasp_function`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, fields
from numbers import Real
from typing import TYPE_CHECKING, Any, Final, final

import numpy as np
from numpy.typing import NDArray

from stochgeom.arguments import as_count, expect
from stochgeom.errors import SimulationError, TrayError
from stochgeom.geometry.part import Part, as_part
from stochgeom.tilting.intervals import wilson_interval
from stochgeom.tilting.physics import Floor, load_engine
from stochgeom.tilting.tray import GRAVITY

if TYPE_CHECKING:  # an extra: loaded where a trial runs
    import pymunk

SIZE: Final = 50.0
"""Millimetres: the part is scaled so that its largest distance of two vertices is this."""

_JAW_HALF: Final = 5000.0
_JAW_THICKNESS: Final = 50.0
_PART_MASS: Final = 0.1
_JAW_MASS: Final = 0.1
_SLOP: Final = 0.002
_OVERLAP_LEFT: Final = 1e-15
_CARRIED_AT: Final = 0.6
"""The table carries the part at this share of the way from its centre of mass to each vertex."""

Floats = NDArray[np.float64]


@final
@dataclass(frozen=True, slots=True)
class SimulatedGripper:
    """Jaws, table, solver.

    Attributes
    ----------
    friction : float
        Coefficient between jaws and part.
    sliding_jaw : bool
        Whether the upper jaw is on a bearing.
    table_friction : float
        Coefficient between table and part.
    speed : float
        Of the moving jaw, millimetres per second.
    force : float
        At which its motor stalls, as a multiple of the part's weight.
    time_step, iterations : float, int
        Of the solver.
    flush_degrees : float
        An edge nearer to the jaws than this is flush.
    limit_seconds : float
        A grasp that takes longer is an error.

    Raises
    ------
    TrayError
        If a value is not physical.
    """

    friction: float = 0.25
    sliding_jaw: bool = False
    table_friction: float = 0.3
    speed: float = 20.0
    force: float = 100.0
    time_step: float = 0.001
    iterations: int = 30
    flush_degrees: float = 0.5
    limit_seconds: float = 60.0

    def __post_init__(self) -> None:
        for item in fields(self):
            if item.name != "sliding_jaw":
                expect(getattr(self, item.name), Real, "a number", item.name)
        as_count(self.iterations, "iterations", error=TrayError, where="iterations")
        for name in ("friction", "table_friction"):
            if not 0 <= getattr(self, name) < math.inf:
                raise TrayError(f"{getattr(self, name)}; accepted: 0 or more", where=name)
        for name in ("speed", "force", "time_step", "flush_degrees"):
            if not 0 < getattr(self, name) < math.inf:
                raise TrayError(f"{getattr(self, name)}; accepted: above 0", where=name)
        if self.time_step > 0.01:
            raise TrayError(f"{self.time_step}; accepted: at most 0.01", where="time_step")


@final
@dataclass(frozen=True, slots=True)
class Grasp:
    """How a grasp went.

    Attributes
    ----------
    before, after : float
        The part's orientation in radians, as continuously turned.
    is_stable : bool
        Whether an edge is flush at the end; the part is wedged otherwise.
    seconds : float
        How long it took.
    """

    before: float
    after: float
    is_stable: bool
    seconds: float


@final
@dataclass(frozen=True, slots=True)
class GraspShare:
    """Grasps at random orientations.

    Attributes
    ----------
    grasps : tuple of Grasp
        In the order in which they were made.
    """

    grasps: tuple[Grasp, ...]

    @property
    def stable(self) -> int:
        """How many ended with an edge flush."""
        return sum(grasp.is_stable for grasp in self.grasps)

    @property
    def share(self) -> float:
        """The share of them."""
        return self.stable / len(self.grasps)

    def interval(self, level: float = 0.95) -> tuple[float, float]:
        """Return Wilson's confidence interval of the probability of a stable grasp."""
        return wilson_interval(self.stable, len(self.grasps), level)


def random_grasps(
    part: Part,
    gripper: SimulatedGripper,
    count: int = 250,
    seed: int = 0,
    *,
    tell: Callable[[float], None] | None = None,
) -> GraspShare:
    """Squeeze a part at uniformly random orientations (app. B.2; the source made 250).

    Each number draws an orientation of its own from the seed.

    Examples
    --------
    >>> square = Part([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> random_grasps(square, SimulatedGripper(sliding_jaw=True), 10, seed=1).stable
    10
    """
    count = as_count(count, "trials", error=TrayError, where="trials")
    seed = as_count(seed, "as a seed", least=0, error=TrayError, where="seed")
    grasps = []
    for number in range(count):
        random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(number,)))
        grasps.append(simulate_squeeze(part, random.uniform(0.0, 2 * math.pi), gripper))
        if tell is not None:
            tell((number + 1) / count)
    return GraspShare(tuple(grasps))


def simulate_squeeze(part: Part, theta: float, gripper: SimulatedGripper) -> Grasp:
    """Close the jaws on a part turned by `theta` radians that both of them touch.

    Raises
    ------
    MissingExtraError
        If pymunk is not installed.
    SimulationError
        If the part is not at rest within the limit.

    Examples
    --------
    A square on its corner wedges; turned a little further it does not:

    >>> square = Part([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> gripper = SimulatedGripper(friction=0.25)
    >>> [simulate_squeeze(square, math.radians(d), gripper).is_stable for d in (45, 65)]
    [False, True]
    """
    scene = _Scene(part, theta, gripper)
    scene.put_upper_jaw()
    seconds = scene.close()
    return Grasp(theta, scene.body.angle, scene.is_flush(), seconds)


def simulate_push_grasp(part: Part, theta: float, gripper: SimulatedGripper) -> Grasp:
    """Push a part with the lower jaw until an edge is flush, then close the upper one.

    The exact counterpart, without friction at the jaws, is `push_grasp_function`.

    Raises
    ------
    MissingExtraError
        If pymunk is not installed.
    SimulationError
        If the part is not flush or not at rest within the limit.

    Examples
    --------
    >>> square = Part([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> grasp = simulate_push_grasp(square, math.radians(30), SimulatedGripper(friction=0.0))
    >>> round(math.degrees(grasp.after))
    0
    """
    scene = _Scene(part, theta, gripper)
    seconds = scene.push()
    scene.put_upper_jaw()
    seconds += scene.close()
    return Grasp(theta, scene.body.angle, scene.is_flush(), seconds)


class _Scene:
    """The engine's space with a part, a lower jaw below it, and perhaps an upper one."""

    def __init__(self, part: Part, theta: float, gripper: SimulatedGripper) -> None:
        part = as_part(part)
        expect(theta, Real, "an orientation in radians, a float", "theta")
        expect(gripper, SimulatedGripper, "a SimulatedGripper", "gripper")
        engine = load_engine()
        self._engine, self._gripper = engine, gripper
        self._corners = scaled_corners(part)
        corners = [(float(x), float(y)) for x, y in self._corners]
        self.space = engine.Space()
        self.space.iterations = gripper.iterations
        self.space.collision_slop, self.space.collision_bias = _SLOP, _OVERLAP_LEFT
        self.body = engine.Body(_PART_MASS, engine.moment_for_poly(_PART_MASS, corners))
        self.body.angle = theta
        outline = engine.Poly(self.body, corners)
        outline.friction = 1.0  # the engine multiplies with the jaws'
        self.space.add(self.body, outline)
        low, _ = self._extent()
        self.body.position = 0.0, -low
        self.lower = self._jaw(engine.Body(body_type=engine.Body.KINEMATIC), 0.0, -_JAW_THICKNESS)
        weight = _PART_MASS * GRAVITY
        friction = gripper.table_friction * weight
        creep = gripper.table_friction * GRAVITY * gripper.time_step
        points = carrying_points(self._corners)
        self._floor = Floor(points, friction, creep)
        self._weight = weight

    def _extent(self) -> tuple[float, float]:
        """Return how far the part reaches below and above its centre of mass."""
        cos, sin = math.cos(self.body.angle), math.sin(self.body.angle)
        heights = sin * self._corners[:, 0] + cos * self._corners[:, 1]
        return float(heights.min()), float(heights.max())

    def _jaw(self, body: pymunk.Body, bottom: float, top: float) -> pymunk.Body:
        corners = [(-_JAW_HALF, bottom), (_JAW_HALF, bottom), (_JAW_HALF, top), (-_JAW_HALF, top)]
        jaw = self._engine.Poly(body, corners)
        jaw.friction = self._gripper.friction
        self.space.add(body, jaw)
        return body

    def put_upper_jaw(self) -> None:
        """Put the upper jaw where it just touches the part, and its motor beside it."""
        engine, (x, y) = self._engine, self.body.position
        height = y + self._extent()[1]
        jaw = self._jaw(engine.Body(_JAW_MASS, math.inf), 0.0, _JAW_THICKNESS)
        jaw.position = x, height
        # The motor moves down at its speed and takes the jaw along, with so much force at most;
        # a groove along x lets the jaw slide.
        motor = engine.Body(body_type=engine.Body.KINEMATIC)
        motor.position, motor.velocity = (x, height), (0.0, -self._gripper.speed)
        ends = (-_JAW_HALF, 0.0), (_JAW_HALF, 0.0)
        drive = engine.GrooveJoint(motor, jaw, *ends, (0.0, 0.0))
        drive.max_bias, drive.max_force = 0.0, self._gripper.force * self._weight
        self.space.add(motor, drive)
        if not self._gripper.sliding_jaw:
            rail = (x, height - 4 * SIZE), (x, height + 4 * SIZE)
            self.space.add(engine.GrooveJoint(self.space.static_body, jaw, *rail, (0.0, 0.0)))
        self.upper = jaw

    def close(self) -> float:
        """Close until the motor stalls and the part is at rest; return the seconds it took."""
        slow = self._gripper.speed / 20
        return self._run(
            lambda: abs(self.upper.velocity.y) < slow and self._turning() < slow, "at rest"
        )

    def push(self) -> float:
        """Push with the lower jaw until an edge is flush; return the seconds it took."""
        self.lower.velocity = 0.0, self._gripper.speed
        slow = self._gripper.speed / 200
        seconds = self._run(lambda: self._turning() < slow and self.is_flush(), "flush")
        self.lower.velocity = 0.0, 0.0
        return seconds

    def _turning(self) -> float:
        return float(abs(self.body.angular_velocity)) * SIZE

    def _run(self, done: Callable[[], bool], what: str) -> float:
        step, quiet, steps = self._gripper.time_step, 0.0, 0
        while quiet < 0.1:
            if steps * step > self._gripper.limit_seconds:
                raise SimulationError(
                    f"the part is not {what} after {self._gripper.limit_seconds} s; accepted: "
                    "grasps that end"
                )
            self._floor.drag(self.body)
            self.space.step(step)
            steps += 1
            quiet = quiet + step if done() else 0.0
        return steps * step

    def is_flush(self) -> bool:
        """Return whether an edge of the part is parallel to the jaws and touches one of them."""
        sides = np.roll(self._corners, -1, axis=0) - self._corners
        turned = np.arctan2(sides[:, 1], sides[:, 0]) + self.body.angle
        away = np.degrees(np.abs((turned + math.pi / 2) % math.pi - math.pi / 2))
        return bool(away.min() < self._gripper.flush_degrees)


def scaled_corners(part: Part) -> Floats:
    """Return the hull about the centre of mass, scaled to `SIZE`, as floats."""
    xs, ys = part.hull.points.to_float()
    center = [float(coordinate) for coordinate in part.center_of_mass]
    corners = np.stack([xs, ys], axis=1) - center
    distances = np.linalg.norm(corners[:, None] - corners[None, :], axis=2)
    scaled: Floats = corners * (SIZE / distances.max())
    return scaled


def carrying_points(corners: Floats) -> list[tuple[float, float, float]]:
    """Return where the table carries a convex part about the origin: x, y, share of the weight.

    The shares are Wachspress's coordinates of the origin, so that they balance there.

    Raises
    ------
    TrayError
        If the centre of mass is not inside the hull.

    Examples
    --------
    >>> points = carrying_points(np.array([[-1.0, -1.0], [2.0, -1.0], [-1.0, 2.0]]))
    >>> [round(share, 6) for _, _, share in points]
    [0.333333, 0.333333, 0.333333]
    """
    before, after = np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0)
    inner = _cross(corners, after)
    if not (inner > 0).all():
        raise TrayError("the centre of mass is not inside the hull; accepted: inside it")
    weights = _cross(corners - before, after - corners) / (_cross(before, corners) * inner)
    shares = weights / weights.sum()
    return [
        (float(x) * _CARRIED_AT, float(y) * _CARRIED_AT, float(share))
        for (x, y), share in zip(corners, shares, strict=True)
    ]


def _cross(first: Any, second: Any) -> Any:
    return first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
