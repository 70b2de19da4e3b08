"""Sense, then act, or act, then sense? Expected costs for three parts of the source (7.2.5).

The source asks the question and leaves it open. A round is a squeeze at a random angle, one look at
the jaw-diameter sensor, and at most one more squeeze; the filter costs as much as a squeeze, looks
are free.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, final

from stochgeom.sensing.sensing_problem import OrderComparison, SensingProblem
from stochgeom.sensing.sensor_plan import SensorPlan
from stochgeom.thesis.parts import catalogue_part

PARTS: Final = ("rectangle", "4gon", "house")

SENSORS: Final[tuple[tuple[int | None, str], ...]] = (
    (None, "0"),
    (2, "0.05"),
    (2, "0.2"),
    (1, "0.3"),
)
"""Bits and noise, the latter as a share of the sensor's range; None bits: the exact diameter."""


@final
@dataclass(frozen=True, slots=True)
class OrderRow:
    """One part and one sensor.

    Attributes
    ----------
    name : str
        The part.
    bits : int or None
        Bits of the sensor.
    noise : str
        Standard deviation of its noise, as a share of its range.
    costs : OrderComparison
        The best plans of each order.
    """

    name: str
    bits: int | None
    noise: str
    costs: OrderComparison

    @property
    def plans(self) -> tuple[SensorPlan, ...]:
        """The plans: no look; look first; look last; two moves of any kind."""
        found = self.costs
        return (found.blind, found.sense_then_act, found.act_then_sense, found.mixed)

    def decimals(self, digits: int = 4) -> tuple[str, ...]:
        """Return the costs of the plans."""
        return tuple(plan.decimal(digits) for plan in self.plans)


def sensor_orders(squeezes: int = 1) -> tuple[OrderRow, ...]:
    """Return the table, with at most so many squeezes after the first.

    Examples
    --------
    >>> for row in sensor_orders()[4:8]:
    ...     print(row.name, row.bits, row.noise, *row.decimals())
    4gon None 0 11.9814 4.0000 4.0000 4.0000
    4gon 2 0.05 11.9814 5.0018 5.1314 5.0016
    4gon 2 0.2 11.9814 5.8759 6.0378 5.5829
    4gon 1 0.3 11.9814 7.4164 6.3023 6.3023
    """
    return tuple(
        OrderRow(
            name,
            bits,
            noise,
            SensingProblem(catalogue_part(name), bits, noise).compare_orders(squeezes),
        )
        for name in PARTS
        for bits, noise in SENSORS
    )
