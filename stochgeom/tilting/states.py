"""The twelve states of a rectangular tile in a square tray, and the twelve tilts.

The source names twelve states, four corners and four sides, and draws them in a figure that did not
survive. Their numbers can be had from its transition matrix of tilt 1 (Fig. 6.4) and its sample
plans (Table 6.1): see docs/decisions/0024-tray-states.md. Tilt 1 is taken for up, and the numbers
to run counter-clockwise; whether the source counts the other way round, its numbers do not tell.

    2 3 | 1 | 11 12        at the upper wall, for tilt 1
    4   |   | 10           at the left and the right wall
    5 6 | 7 | 8 9          at the lower wall

- 1, 4, 7, 10: the long edge flush against one wall, away from the corners.
- 2, 5, 8, 11: in a corner, the long edge vertical.
- 3, 6, 9, 12: in a corner, the long edge horizontal.

Everything else is `OTHER`: four states with the short edge flush against a wall away from the
corners, and jams.

Tilt *a* lets the tile slide in the direction 90 + 30 (a - 1) degrees, counter-clockwise from the x
axis: 1 up, 4 to the left, 7 down, 10 to the right.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, NamedTuple, final

import numpy as np

from stochgeom.arguments import as_count, expect
from stochgeom.tilting.counts import OTHER, Outcome
from stochgeom.tilting.tray import TraySetup

ACTIONS: Final = 12
STATES: Final = 12


class TilePose(NamedTuple):
    """Where the tile's centre is, from the tray's, and how it is turned.

    Millimetres; radians counter-clockwise, 0 with the long edge horizontal.
    """

    x: float
    y: float
    angle: float


@final
@dataclass(frozen=True, slots=True)
class CanonicalState:
    """One of the twelve.

    Attributes
    ----------
    number : int
        From 1.
    right, up : int
        1 if the tile is at the right or upper wall, -1 if at the left or lower one, else 0.
    horizontal : bool
        Whether the long edge is horizontal.
    """

    number: int
    right: int
    up: int
    horizontal: bool

    @property
    def is_corner(self) -> bool:
        """Whether the tile is in a corner."""
        return self.right != 0 and self.up != 0


CANONICAL: Final = tuple(
    CanonicalState(number, right, up, horizontal)
    for number, (right, up, horizontal) in enumerate(
        [
            (0, 1, True),
            (-1, 1, False),
            (-1, 1, True),
            (-1, 0, False),
            (-1, -1, False),
            (-1, -1, True),
            (0, -1, True),
            (1, -1, False),
            (1, -1, True),
            (1, 0, False),
            (1, 1, False),
            (1, 1, True),
        ],
        start=1,
    )
)

_NUMBERS: Final = {(s.right, s.up, s.horizontal): s.number for s in CANONICAL}


def azimuth(action: int) -> float:
    """Return the direction of a tilt in degrees, counter-clockwise from the x axis.

    Examples
    --------
    >>> azimuth(1), azimuth(4), azimuth(12)
    (90.0, 180.0, 420.0)
    """
    return 90.0 + 30.0 * (action - 1)


def quarter_turn_state(state: int) -> int:
    """Return what a state becomes when the tray is turned by 90 degrees counter-clockwise.

    Examples
    --------
    >>> [quarter_turn_state(state) for state in (1, 2, 3, 10)]
    [4, 6, 5, 1]
    """
    before = CANONICAL[state - 1]
    return _NUMBERS[-before.up, before.right, not before.horizontal]


def quarter_turn_action(action: int) -> int:
    """Return what a tilt becomes when the tray is turned by 90 degrees counter-clockwise.

    Examples
    --------
    >>> quarter_turn_action(1), quarter_turn_action(11)
    (4, 2)
    """
    return (action + 2) % ACTIONS + 1


def half_sizes(setup: TraySetup, *, horizontal: bool) -> tuple[float, float]:
    """Return half of the tile's extent in x and in y, when it stands along the walls."""
    length, width = setup.tile_length / 2, setup.tile_width / 2
    return (length, width) if horizontal else (width, length)


def tile_state(setup: TraySetup, pose: TilePose) -> Outcome:
    """Return the state that a tile at rest is in, or `OTHER`.

    Examples
    --------
    >>> setup = TraySetup()
    >>> tile_state(setup, TilePose(10.0, 100.0, 0.0))
    1
    >>> tile_state(setup, TilePose(10.0, 75.0, np.pi / 2))
    'other'
    """
    expect(setup, TraySetup, "a TraySetup", "setup")
    expect(pose, TilePose, "a TilePose", "pose")
    quarters = round(pose.angle / (math.pi / 2))
    if abs(math.degrees(pose.angle - quarters * math.pi / 2)) > setup.turned:
        return OTHER
    horizontal = quarters % 2 == 0
    half_x, half_y = half_sizes(setup, horizontal=horizontal)
    gap_x = setup.side / 2 - half_x - abs(pose.x)
    gap_y = setup.side / 2 - half_y - abs(pose.y)
    if min(gap_x, gap_y) > setup.touching:
        return OTHER
    right = int(math.copysign(gap_x <= setup.corner, pose.x))
    up = int(math.copysign(gap_y <= setup.corner, pose.y))
    # Away from the corners only the long edge counts.
    return _NUMBERS.get((right, up, horizontal), OTHER)


def random_tile_pose(setup: TraySetup, state: int, random: np.random.Generator) -> TilePose:
    """Draw a pose in a state: uniform along a side, and up to `placing_gap` from the walls."""
    expect(setup, TraySetup, "a TraySetup", "setup")
    expect(random, np.random.Generator, "numpy.random.default_rng(seed)", "random")
    place = CANONICAL[as_count(state, "as a state", most=STATES) - 1]
    half_x, half_y = half_sizes(setup, horizontal=place.horizontal)
    angle = 0.0 if place.horizontal else math.pi / 2
    x = _draw_coordinate(setup, half_x, place.right, random)
    return TilePose(x, _draw_coordinate(setup, half_y, place.up, random), angle)


def _draw_coordinate(
    setup: TraySetup, half: float, at_wall: int, random: np.random.Generator
) -> float:
    room = setup.side / 2 - half
    if at_wall:
        return at_wall * (room - random.uniform(0.0, setup.placing_gap))
    return float(random.uniform(-1.0, 1.0) * (room - setup.corner))
