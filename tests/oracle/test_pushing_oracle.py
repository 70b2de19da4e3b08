"""Random grasps in floats: pushes of random length bracket the bounds.

Nothing of the library but the answers: vertices are turned in numpy, lowest and highest ones found,
signs of slopes followed to the next orientation where a push comes to rest.
"""

from __future__ import annotations

import numpy as np
import pytest

from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.pushing_model import pushing_bound, pushing_bounds
from stochgeom.thesis.parts import catalogue_names, catalogue_part

COUNT = 40_000
"""Initial orientations, evenly spread."""


class Floats:
    """All orientations of a part, for one coefficient of friction."""

    def __init__(self, part, mu):
        corners = np.array([(float(x), float(y)) for x, y in part.vertices])
        corners -= np.array([float(v) for v in part.center_of_mass])
        theta = (np.arange(COUNT) + 0.5) * (2 * np.pi / COUNT)
        c, s = np.cos(theta)[:, None], np.sin(theta)[:, None]
        x, y = c * corners[:, 0] - s * corners[:, 1], s * corners[:, 0] + c * corners[:, 1]
        rows = np.arange(COUNT)
        low, high = y.argmin(axis=1), y.argmax(axis=1)
        across, apart = x[rows, high] - x[rows, low], y[rows, high] - y[rows, low]
        self.wedged = np.abs(across) < mu * apart
        # The height of the centre of mass over the jaw grows with theta by minus the contact's x.
        self.slopes = {"lower": -x[rows, low], "upper": x[rows, high]}

    def ends(self, jaw):
        """Return for each orientation the place, counted on, where the push comes to rest."""
        rising = self.slopes[jaw] > 0
        falls_then_rises = np.flatnonzero(~rising & np.roll(rising, -1))
        rests = np.concatenate([falls_then_rises + k * COUNT for k in (-1, 0, 1)])
        here = np.arange(COUNT)
        ahead = np.searchsorted(rests, here - 0.5)
        return np.where(rising, rests[ahead - 1] + 1, rests[ahead])


@pytest.mark.parametrize("mu", ["0.25", "0.05"])
@pytest.mark.parametrize("name", catalogue_names())
def test_random_grasps_bracket_the_bounds(name, mu):
    part = catalogue_part(name)
    diagram, floats = GraspDiagram(part, mu), Floats(part, float(mu))
    rng = np.random.default_rng(7)
    here = np.arange(COUNT)
    wedged = np.concatenate([floats.wedged] * 3)
    before = np.concatenate(([0], np.cumsum(wedged)))
    stable, never = [], np.ones(COUNT, dtype=bool)
    for jaw in ("lower", "upper"):
        ends = floats.ends(jaw)
        reached = here + np.rint((ends - here) * rng.random(COUNT)).astype(int)
        stable.append(~wedged[reached + COUNT])
        first, last = np.minimum(here, ends) + COUNT, np.maximum(here, ends) + COUNT
        never &= before[last + 1] == before[first]
    share = np.mean(stable)
    deviation = np.sqrt(share * (1 - share) / (2 * COUNT))
    bound = float(pushing_bound(diagram))
    assert abs(share - bound) < 4 * deviation + 1e-4
    # The grid misjudges at most the few orientations about each end of an interval.
    assert abs(never.mean() - float(diagram.bound)) < 60 / COUNT
    assert never.mean() <= share + 4 * deviation


@pytest.mark.parametrize("name", ["house", "wrench"])
def test_where_random_grasps_end(name):
    """Per stable orientation: random grasps, squeezed on by the slope of the diameter."""
    part = catalogue_part(name)
    diagram = GraspDiagram(part, "0.25")
    rng = np.random.default_rng(11)
    for edge, bound in pushing_bounds(diagram):
        share = _share_ending_at(part, edge.orientation.to_float(), rng)
        deviation = np.sqrt(share * (1 - share) / (2 * COUNT))
        assert abs(share - float(bound)) < 4 * deviation + 2e-4


def _share_ending_at(part, place, rng):
    """Return the share of random grasps that a squeeze turns to one orientation."""
    floats = Floats(part, 0.25)
    here = np.arange(COUNT)
    corners = np.array([(float(x), float(y)) for x, y in part.vertices])
    finals = _squeezed(corners, floats.wedged)
    hits = []
    for jaw in ("lower", "upper"):
        ends = floats.ends(jaw)
        reached = here + np.rint((ends - here) * rng.random(COUNT)).astype(int)
        final = finals[reached % COUNT]
        off = np.abs((final - place + np.pi) % (2 * np.pi) - np.pi)
        hits.append(off < 3 * (2 * np.pi / COUNT))
    return np.mean(hits)


def _squeezed(corners, wedged):
    """Return for each orientation where a squeeze ends, NaN if wedged: downhill until something
    holds, that is until the next orientation is wedged or the slope changes its sign."""
    theta = (np.arange(COUNT) + 0.5) * (2 * np.pi / COUNT)
    y = np.sin(theta)[:, None] * corners[:, 0] + np.cos(theta)[:, None] * corners[:, 1]
    diameter = y.max(axis=1) - y.min(axis=1)
    rising = np.roll(diameter, -1) > diameter
    found = np.full(COUNT, np.nan)
    for k in np.flatnonzero(~wedged):
        if not np.isnan(found[k]):
            continue
        step, way = (-1 if rising[k] else 1), [k]
        while True:
            j = (way[-1] + step) % COUNT
            if wedged[j] or rising[j] != rising[k]:
                break
            way.append(j)
            if not np.isnan(found[j]):
                break
        found[way] = found[way[-1]] if not np.isnan(found[way[-1]]) else theta[way[-1]]
    return found
