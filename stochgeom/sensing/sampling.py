"""Sensors whose likelihoods are measured: frequencies of readings (thesis 7.2.3).

The matrices of a sensor can be found by grasping the part again and again and counting what the
sensor says. `sensor_from_counts` makes a sensor of the counts; `sampled_sensor` does so with a
model of the sensor in the place of the real one, to see how many grasps are enough.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Hashable, Iterable, Mapping
from itertools import accumulate
from typing import Any

from gmpy2 import mpq

from stochgeom.arguments import as_count, expect
from stochgeom.decision.labels import Labels, named
from stochgeom.errors import SensorError
from stochgeom.exact.scalars import RationalLike, common_denominator, from_float_exact, rational
from stochgeom.sensing.sensors import Sensor


def sensor_from_counts(
    readings: Iterable[Hashable],
    counts: Mapping[Any, Mapping[Any, Any]],
    *,
    pseudo_count: RationalLike = 0,
    **settings: Any,
) -> Sensor:
    """Return the sensor whose likelihoods are the frequencies of observed readings.

    Parameters
    ----------
    readings : sequence of labels
        All that can occur.
    counts : mapping
        From each state to a mapping from readings to how often they were seen in it; readings left
        out were seen never.
    pseudo_count : rational, default 0
        Added to each count: the likelihood is then the mean of the posterior under a Dirichlet
        prior with that parameter, and a reading that was never seen stays possible.
    **settings
        Cost and name of the sensor.

    Raises
    ------
    SensorError
        If a count is negative, or nothing was read in a state.
    UnknownLabelError
        If a reading was seen that is none of them.

    Examples
    --------
    >>> sensor_from_counts(["x", "y"], {"a": {"x": 3, "y": 1}, "b": {"y": 2}}).likelihood
    ((mpq(3,4), mpq(1,4)), (mpq(0,1), mpq(1,1)))
    """
    labels = Labels(readings, "reading")
    extra = rational(pseudo_count, where="pseudo count")
    expect(counts, Mapping, "a mapping from states to mappings from readings", "counts")
    table = {}
    for state, seen in counts.items():
        place = f"counts of state {named(state)}"
        expect(seen, Mapping, "a mapping from readings to counts", place)
        for reading in seen:
            labels.number(reading, where=place)
        row = [rational(seen.get(x, 0), where=place) + extra for x in labels]
        total = sum(row, start=mpq(0))
        if total <= 0 or min(row) < 0:
            shown = ", ".join(map(str, row))
            raise SensorError(
                f"counts {shown:.60}; accepted: 0 or more each, and at least one positive",
                where=place,
            )
        table[state] = [count / total for count in row]
    return Sensor(labels, table, **settings)


def sampled_sensor(
    sensor: Sensor, times: int, *, seed: int = 0, pseudo_count: RationalLike = 0
) -> Sensor:
    """Return what reading a sensor so many times in each state makes one believe it is.

    Parameters
    ----------
    sensor : Sensor
        The model that readings are drawn from; its likelihoods are hit exactly, by whole numbers.
    times : int
        Readings in each state, at least 1.
    seed : int, default 0
        The same seed gives the same readings.
    pseudo_count : rational, default 0
        As for `sensor_from_counts`.

    Examples
    --------
    >>> model = Sensor.noisy(["left", "right"], "1/10")
    >>> [str(p) for p in sampled_sensor(model, 1000).likelihood[0]]
    ['227/250', '23/250']
    """
    expect(sensor, Sensor, "a Sensor, such as Sensor.noisy(states, '1/10')")
    times = as_count(times, "readings", error=SensorError, where="times")
    chance = random.Random(as_count(seed, "as a seed", least=0))
    counts = {
        state: Counter(sensor.readings[_draw(row, chance)] for _ in range(times))
        for state, row in zip(sensor.states, sensor.likelihood, strict=True)
    }
    return sensor_from_counts(
        sensor.readings,
        counts,
        pseudo_count=pseudo_count,
        name=sensor.name,
        cost=sensor.cost if sensor.exact else from_float_exact(float(sensor.cost)),
    )


def _draw(row: tuple[Any, ...], chance: random.Random) -> int:
    """Return the place of a reading drawn from a distribution, without a float."""
    exact = [p if isinstance(p, type(mpq())) else from_float_exact(p) for p in row]
    scale = common_denominator(exact)
    ends = list(accumulate(int(p * scale) for p in exact))
    drawn = chance.randrange(ends[-1])
    return next(k for k, end in enumerate(ends) if drawn < end)
