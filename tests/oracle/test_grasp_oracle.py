"""Grasps with friction by brute force: whole numbers, all vertices, one orientation after another.

Candidates for critical orientations are the directions of all pairs of vertices, laid level,
upright and turned by the friction angle either way, and those from the vertices to the centre of
mass: more than the diagrams can have. Between two neighbours of them nothing changes, so one
direction from each gap and the candidates themselves are a complete sample. In each the friction
cone is tested on the extreme vertices, and the part is followed from sample to sample until it
rests.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cmp_to_key
from itertools import permutations
from math import lcm

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.exact.angles import Angle
from stochgeom.exact.cells import CellSet
from stochgeom.geometry.part import Part
from stochgeom.grasping.grasp_diagram import GraspDiagram
from tests.strategies import frictions, small_pushable_parts

FEW = settings().max_examples // 5

DOWN, REST, UP, WEDGED, BOTH = "clockwise", "rests", "counter-clockwise", "wedged", "either"


class BruteForce:
    """Every sample's motion under a push of each jaw and under a squeeze."""

    def __init__(self, part, mu):
        cx, cy = part.center_of_mass
        found = [(x - cx, y - cy) for x, y in part.vertices]
        scale = lcm(*(int(v.denominator) for pair in found for v in pair))
        self.points = list({(int(x * scale), int(y * scale)) for x, y in found})
        self.mu = mu
        self.samples = self._samples()
        self.squeezes = [self._squeeze(turn) for turn in self.samples]
        self.pushes = [[self._push(turn, sense) for turn in self.samples] for sense in (1, -1)]

    # --- samples ---------------------------------------------------------------------------------

    def _samples(self):
        p, q = self.mu.numerator, self.mu.denominator
        found = set()
        pairs = [(b[0] - a[0], b[1] - a[1]) for a, b in permutations(self.points, 2)]
        for x, y in pairs:
            found.add((x, -y))  # level
            for u, v in ((1, 0), (q, p), (q, -p)):  # upright, and off by the friction angle
                found.add((y * u - x * v, y * v + x * u))
        for x, y in self.points:
            found |= {(y, x), (-y, -x)}  # straight above or below the centre of mass
        found.discard((0, 0))
        ordered = _without_equals(sorted(found, key=cmp_to_key(_by_argument)))
        # The sum of two neighbours less than half a turn apart points between them.
        return [
            turn
            for a, b in zip(ordered, ordered[1:] + ordered[:1], strict=True)
            for turn in (a, (a[0] + b[0], a[1] + b[1]))
        ]

    def _turned(self, turn):
        c, s = turn
        return [(c * x - s * y, s * x + c * y) for x, y in self.points]

    # --- motions ---------------------------------------------------------------------------------

    def _push(self, turn, sense):
        """Mason's rule, the centre of mass at the origin; sense -1 is the upper jaw."""
        turned = [(x * sense, y * sense) for x, y in self._turned(turn)]
        bottom = min(y for _, y in turned)
        touching = [x for x, y in turned if y == bottom]
        low, high = min(touching), max(touching)
        if low < 0 < high:
            return REST
        if low == high == 0:
            return BOTH
        return DOWN if low < 0 else UP

    def _squeeze(self, turn):
        turned = self._turned(turn)
        bottom, top = min(y for _, y in turned), max(y for _, y in turned)
        below = [x for x, y in turned if y == bottom]
        above = [x for x, y in turned if y == top]
        reach = self.mu * (top - bottom)
        low, high = min(above) - max(below), max(above) - min(below)
        if low == high:  # two vertices
            if abs(low) < reach:
                return WEDGED
            return BOTH if low == 0 else DOWN if low > 0 else UP
        if low < reach and high > -reach:
            return REST
        return DOWN if low >= reach else UP

    # --- following -------------------------------------------------------------------------------

    def squeezed(self, k):
        """Return where a squeeze from a sample may end: samples, or WEDGED; and whether a part
        that turns comes to a wedging interval first."""
        motion = self.squeezes[k]
        if motion == WEDGED:
            return {WEDGED}, True
        if motion == REST:
            return {k}, False
        ends, strict = set(), False
        for step in (1, -1) if motion == BOTH else (1,) if motion == UP else (-1,):
            j = self._next(k, step)
            while self.squeezes[j] not in (REST, WEDGED):
                assert self.squeezes[j] == (UP if step > 0 else DOWN)
                j = self._next(j, step)
            assert self.squeezes[j] == REST  # a wedging interval begins behind a flush edge only
            ends.add(j)
            strict |= self.squeezes[self._next(j, step)] == WEDGED and not self._is_minimum(j)
        return ends, strict

    def _is_minimum(self, k):
        turned = self._turned(self.samples[k])
        bottom, top = min(y for _, y in turned), max(y for _, y in turned)
        below = [x for x, y in turned if y == bottom]
        above = [x for x, y in turned if y == top]
        return min(above) - max(below) < 0 < max(above) - min(below)

    def _next(self, k, step):
        return (k + step) % len(self.samples)

    def way(self, k, jaw):
        """Return the samples that a push by a jaw may leave the part in, from sample k."""
        motions = self.pushes[jaw]
        found = [k]
        senses = {UP: (1,), DOWN: (-1,), BOTH: (1, -1), REST: ()}[motions[k]]
        for step in senses:
            j = k
            while motions[j] != REST:
                j = self._next(j, step)
                found.append(j)
        return found


def _by_argument(a, b):
    half_a, half_b = (a[1] < 0 or (a[1] == 0 and a[0] < 0)), (b[1] < 0 or (b[1] == 0 and b[0] < 0))
    if half_a != half_b:
        return half_a - half_b
    cross = a[0] * b[1] - a[1] * b[0]
    return (cross < 0) - (cross > 0)


def _without_equals(turns):
    return [t for k, t in enumerate(turns) if k == 0 or _by_argument(turns[k - 1], t) != 0]


def check(part, mu):
    slow, diagram = BruteForce(part, mu), GraspDiagram(part, mu)
    thetas = [Angle(0, turn) for turn in slow.samples]
    ends = [slow.squeezed(k) for k in range(len(thetas))]
    resting = {k for k, motion in enumerate(slow.squeezes) if motion == REST}
    assert {thetas[k] for k in resting} == {edge.orientation for edge in diagram.stable}
    friction_only = {edge.orientation for edge in diagram.stable if edge.by_friction}
    assert friction_only == {thetas[k] for k in resting if not slow._is_minimum(k)}
    strict_set = diagram.squeeze.wedged_if_strict
    reached = []
    for k, theta in enumerate(thetas):
        outcomes, is_strict = ends[k]
        expected = {None if end == WEDGED else thetas[end] for end in outcomes}
        assert set(diagram.squeeze.outcomes(theta)) == expected
        assert (theta in diagram.wedged_set) == (outcomes == {WEDGED})
        assert (theta in strict_set) == is_strict
        ways = [j for jaw in (0, 1) for j in slow.way(k, jaw)]
        reached.append({end for j in ways for end in ends[j][0]})
        assert (theta in diagram.guaranteed) == (WEDGED not in reached[-1])
        assert (theta in diagram.guaranteed_if_strict) == (not any(ends[j][1] for j in ways))
    compare_preimages(diagram, thetas, reached, resting)
    return diagram, thetas, reached


def compare_preimages(diagram, thetas, reached, resting):
    for end in sorted(resting)[:3]:
        weak, strong = diagram.weak_preimage(thetas[end]), diagram.strong_preimage(thetas[end])
        for theta, finals in zip(thetas, reached, strict=True):
            assert (theta in weak) == (end in finals)
            assert (theta in strong) == (finals == {end})


@given(small_pushable_parts(), frictions)
@settings(max_examples=FEW)
def test_the_diagrams_against_brute_force(part, mu):
    check(part, mu)


@given(small_pushable_parts(), frictions, st.data())
@settings(max_examples=FEW)
def test_the_image_of_an_orientation_against_brute_force(part, mu, data):
    slow, diagram = BruteForce(part, mu), GraspDiagram(part, mu)
    k = data.draw(st.integers(0, len(slow.samples) - 1))
    image = diagram.image(Angle(0, slow.samples[k]))
    ways = {j for jaw in (0, 1) for j in slow.way(k, jaw)}
    finals = {end for j in ways for end in slow.squeezed(j)[0]}
    stable = CellSet.at(Angle(0, slow.samples[end]) for end in finals if end != WEDGED)
    assert image & diagram.stable_set == stable
    wedged = image - diagram.stable_set
    for j, turn in enumerate(slow.samples):
        assert (Angle(0, turn) in wedged) == (j in ways and slow.squeezes[j] == WEDGED)


@pytest.mark.parametrize("mu", [Fraction(0), Fraction(1, 20), Fraction(1, 4), Fraction(1)])
@pytest.mark.parametrize(
    ("vertices", "center"),
    [
        ([(0, 0), (1, 0), (1, 1), (0, 1)], None),
        ([(-1, -1), (1, -1), (1, 1), (0, 2), (-1, 1)], (0, 0)),
        ([(0, 0), (4, 0), (0, 4)], (1, 1)),
        ([(0, 0), (4, 0), (5, 3), (0, 3)], (4, 1)),  # straight above the end of an edge
        ([(0, 0), (4, 0), (2, 3)], (2, 1)),  # a vertex opposite the middle of an edge
        ([(0, 0), (4, 0), (4, 3)], (3, 1)),  # a vertex opposite the end of an edge
    ],
)
def test_pinned_parts_against_brute_force(vertices, center, mu):
    check(Part(vertices, center), mu)


def test_brute_force_knows_the_square():
    slow = BruteForce(Part([(0, 0), (2, 0), (2, 2), (0, 2)]), Fraction(1, 4))
    diagonal = next(k for k, (x, y) in enumerate(slow.samples) if x == y > 0)
    level = next(k for k, (x, y) in enumerate(slow.samples) if y == 0 < x)
    assert (slow.squeezes[diagonal], slow.squeezes[level]) == (WEDGED, REST)
    assert slow.squeezed(level + 1) == ({level}, False)
    assert slow.pushes[0][diagonal] == slow.pushes[1][diagonal] == BOTH
    assert slow.pushes[0][level] == REST
    assert sum(motion == REST for motion in slow.squeezes) == 4
