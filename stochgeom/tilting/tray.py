"""The tray, the tile, and what varies from trial to trial.

Lengths are millimetres, angles degrees, times seconds. This is physics, not geometry: everything
here is float. The reasons for every number stand in docs/decisions/0023-tray-model.md.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from typing import Any, Final, final

from stochgeom.errors import TrayError

GRAVITY: Final = 9810.0
"""Millimetres per second squared."""


@final
@dataclass(frozen=True, slots=True)
class Solver:
    """How the engine integrates; see the convergence study in notebooks/06-tray-tilting.ipynb.

    Attributes
    ----------
    time_step : float
        Seconds.
    iterations : int
        Rounds of the contact solver in each step.
    support_points : int
        Along the tile, and half as many across: where friction with the floor acts.
    rest_speed : float
        Millimetres per second: no point of a tile at rest moves faster, but for the creeping of
        points that the floor holds (see `stochgeom.tilting.physics`).
    rest_seconds : float
        For so long it has to be that slow.
    limit_seconds : float
        A trial that takes longer is an error.
    """

    time_step: float = 0.001
    iterations: int = 30
    support_points: int = 4
    rest_speed: float = 1.0
    rest_seconds: float = 0.1
    limit_seconds: float = 20.0

    def __post_init__(self) -> None:
        _check_floats(self)
        for name, most in (("time_step", 0.01), ("rest_seconds", math.inf)):
            value = getattr(self, name)
            if not 0 < value <= most:
                raise TrayError(f"{value}; accepted: above 0, at most {most}", where=name)
        for name in ("iterations", "support_points"):
            if getattr(self, name) < 1:
                raise TrayError(f"{getattr(self, name)}; accepted: 1 or more", where=name)
        if self.rest_speed <= 0 or self.limit_seconds <= self.rest_seconds:
            raise TrayError(
                f"rest_speed {self.rest_speed}, limit_seconds {self.limit_seconds}; accepted: a "
                "positive speed, a limit above rest_seconds"
            )


@final
@dataclass(frozen=True, slots=True)
class TraySetup:
    """A square tray, a rectangular tile, tilts, friction, and their variation.

    Attributes
    ----------
    side : float
        Inner side of the tray.
    tile_length, tile_width : float
        Long and short side of the tile.
    tilt : float
        Degrees by which the tray is tilted.
    support_friction : float
        Coefficient of friction between tile and floor.
    wall_friction : float
        Between tile and wall.
    restitution : float
        Share of the normal speed kept at an impact with a wall.
    azimuth_sd, tilt_sd : float
        Standard deviations of the direction and the amount of a tilt, degrees.
    friction_spread : float
        Both coefficients vary uniformly by this share, each by itself.
    placing_gap : float
        Before a trial the tile is put within so much of the walls it should touch.
    touching : float
        A tile nearer to a wall than this touches it.
    corner : float
        A tile that touches one wall and is nearer to the next one than this is in the corner.
    turned : float
        A tile turned further than this from the walls, in degrees, is in none of the states.
    solver : Solver
        How the engine integrates.

    Raises
    ------
    TrayError
        If a value is not physical, or the tile does not fit.

    Examples
    --------
    >>> TraySetup(tile_length=400)
    Traceback (most recent call last):
    ...
    stochgeom.errors.TrayError: tile_length: a tile of 400.0 by 40.0 mm in a tray of 240.0 mm; \
accepted: tiles whose diagonal fits between the corner zones, here below 216.0 mm
    """

    side: float = 240.0
    tile_length: float = 90.0
    tile_width: float = 40.0
    tilt: float = 25.0
    support_friction: float = 0.1
    wall_friction: float = 0.7
    restitution: float = 0.2
    azimuth_sd: float = 2.0
    tilt_sd: float = 1.0
    friction_spread: float = 0.2
    placing_gap: float = 2.0
    touching: float = 2.0
    corner: float = 12.0
    turned: float = 3.0
    solver: Solver = field(default_factory=Solver)

    def __post_init__(self) -> None:
        _check_floats(self)
        _check_between(self, ("side", "tile_length", "tile_width"), 0, math.inf, open_low=True)
        _check_between(self, ("tilt",), 0, 90, open_low=True)
        _check_between(
            self,
            ("support_friction", "wall_friction", "azimuth_sd", "tilt_sd", "placing_gap"),
            0,
            math.inf,
        )
        _check_between(self, ("restitution", "friction_spread"), 0, 1)
        _check_between(self, ("touching", "corner"), 0, self.side / 10, open_low=True)
        _check_between(self, ("turned",), 0, 10, open_low=True)
        if self.tile_width >= self.tile_length:
            raise TrayError(
                f"{self.tile_width} mm; accepted: less than the length, {self.tile_length} mm",
                where="tile_width",
            )
        room = self.side - 2 * self.corner
        if math.hypot(self.tile_length, self.tile_width) >= room:
            raise TrayError(
                f"a tile of {self.tile_length} by {self.tile_width} mm in a tray of {self.side} "
                f"mm; accepted: tiles whose diagonal fits between the corner zones, here below "
                f"{room} mm",
                where="tile_length",
            )
        if self.placing_gap > self.touching:
            raise TrayError(
                f"{self.placing_gap} mm; accepted: at most what still touches, {self.touching} mm",
                where="placing_gap",
            )

    @property
    def reach(self) -> float:
        """Half the diagonal of the tile, in millimetres."""
        return math.hypot(self.tile_length, self.tile_width) / 2

    def with_solver(self, **settings: Any) -> TraySetup:
        """Return the setup with other settings of the solver."""
        return replace(self, solver=replace(self.solver, **settings))

    def as_texts(self) -> dict[str, str]:
        """Return the fields as text, for a document; `setup_from_texts` reads it."""
        document = asdict(self)
        solver = document.pop("solver")
        return {name: repr(value) for name, value in {**document, **solver}.items()}


def setup_from_texts(document: Mapping[str, str]) -> TraySetup:
    """Return the setup that `TraySetup.as_texts` wrote; absent fields have their defaults.

    Examples
    --------
    >>> setup_from_texts({"tilt": "30", "iterations": "20"}).with_solver(iterations=10).tilt
    30.0
    """
    kinds = {
        item.name: (owner, item.type) for owner in (Solver, TraySetup) for item in fields(owner)
    }
    found: dict[Any, dict[str, Any]] = {Solver: {}, TraySetup: {}}
    for name, text in document.items():
        if name not in kinds or name == "solver":
            accepted = ", ".join(sorted(set(kinds) - {"solver"}))
            raise TrayError(f"no setting of that name; accepted: {accepted}", where=str(name)[:40])
        owner, kind = kinds[name]
        try:
            found[owner][name] = int(text) if kind == "int" else float(text)
        except ValueError:
            raise TrayError(f"{text[:40]!r}; accepted: a number", where=name) from None
    return TraySetup(**found[TraySetup], solver=Solver(**found[Solver]))


def _check_floats(owner: Solver | TraySetup) -> None:
    """Make every number a finite float, or an int where one is meant."""
    for item in fields(owner):
        value = getattr(owner, item.name)
        if item.name == "solver":
            continue
        whole = item.type == "int"
        good = isinstance(value, int if whole else int | float) and not isinstance(value, bool)
        if not good or not math.isfinite(value):
            raise TrayError(
                f"{value!r}; accepted: {'a whole' if whole else 'a finite'} number",
                where=item.name,
            )
        object.__setattr__(owner, item.name, int(value) if whole else float(value))


def _check_between(
    setup: TraySetup, names: tuple[str, ...], low: float, high: float, *, open_low: bool = False
) -> None:
    for name in names:
        value = getattr(setup, name)
        if not low <= value <= high or (open_low and value == low):
            ends = f"above {low:g}" if open_low else f"{low:g} or more"
            more = "" if high == math.inf else f", at most {high:g}"
            raise TrayError(f"{value}; accepted: {ends}{more}", where=name)
