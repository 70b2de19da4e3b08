"""One step map after another, on arrays.

Which outer step an inner value falls into is decided by float shadows where these are farther
from every break than their error, and by exact angles elsewhere. Exact angles are made for those
few only; the result refers to directions that both maps hold already.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from stochgeom.exact.lifted import LiftedAngles
from stochgeom.exact.vectors import AngleVector

Indices = NDArray[np.intp]


def composed_steps(
    outer: tuple[LiftedAngles, LiftedAngles],
    inner: tuple[LiftedAngles, LiftedAngles],
    copies: int,
    rise: int,
) -> tuple[AngleVector, AngleVector]:
    """Return breaks and values of the outer map after the inner one, over a shared period.

    Parameters
    ----------
    outer, inner : (LiftedAngles, LiftedAngles)
        Breaks and values of each map, the values strictly increasing.
    copies : int
        How many inner periods make a shared period.
    rise : int
        How many outer steps a shared period has.

    Returns
    -------
    breaks, values : AngleVector
        No two adjacent values are equal.  O(m log m') for m inner steps and m' outer ones.
    """
    outer_breaks, outer_values = outer
    inner_breaks, inner_values = inner
    everyone = np.arange(len(inner_values))
    steps = [
        outer_breaks.positions(inner_values, everyone, inner_values.period * copy)
        for copy in range(copies)
    ]
    reached = np.concatenate(steps)
    # Step numbers do not decrease, and different steps have different values.
    before = np.concatenate((reached[-1:] - rise, reached[:-1]))
    (fresh,) = np.nonzero(reached != before)
    every_one = len(fresh) == len(inner_breaks) and copies == 1
    breaks = inner_breaks.base if every_one else entries(inner_breaks, fresh)
    return breaks, entries(outer_values, reached[fresh])


def entries(sequence: LiftedAngles, indices: Indices) -> AngleVector:
    """Return the entries a_k of a sequence for whole k that do not decrease.

    One rotation for each period that the k span.

    Examples
    --------
    >>> from stochgeom.exact.angles import HALF_TURN, Angle
    >>> base = AngleVector.from_angles([Angle.from_degrees(d) for d in (0, 10)])
    >>> found = entries(LiftedAngles(base, HALF_TURN), np.array([-1, 1, 2, 5]))
    >>> [angle.degrees(0) for angle in found]
    ['-170', '10', '180', '370']
    """
    laps, places = np.divmod(indices, len(sequence))
    ends = [*(np.flatnonzero(np.diff(laps)) + 1).tolist(), len(laps)]
    pieces, start = [], 0
    for end in ends:
        piece, lap = sequence.base.take(places[start:end]), int(laps[start])
        pieces.append(piece.rotate(sequence.period * lap) if lap else piece)
        start = end
    return pieces[0] if len(pieces) == 1 else AngleVector.concatenate(pieces)
