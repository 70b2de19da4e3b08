"""Best windows and masses by slower roads: every start on a grid, sums of fractions, mpmath."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.decision.density_priors import VonMises, WrappedNormal
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.mixture_prior import MixturePrior
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.priors import uniform_prior
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from tests.strategies import (
    circle_points,
    grid_degrees,
    grid_widths,
    histograms,
    orientations,
    weighted_points,
)

GRID = [Fraction(5 * k, 2) for k in range(144)]
"""Every place where a mass on the grids may bend or jump, for the widths drawn here."""

weights = st.sampled_from([Fraction(k, 4) for k in range(5)])


def degrees(angle: Angle) -> Fraction:
    turns = angle.rational_turns
    return 360 * Fraction(int(turns.numerator), int(turns.denominator))


def points_in(points, start, width):
    """Sum the weights in [start, start + width)."""
    return sum((w for a, w in points.items() if (a - start) % 360 < width), Fraction(0))


def bins_in_all(bins, width):
    """Sum step densities given as (start, end, mass) over [s, s + width) for each s of the grid."""
    cells = [Fraction(0)] * 144
    for low, high, mass in bins:
        count = int((high - low) / Fraction(5, 2))
        for k in range(count):
            cells[int(low / Fraction(5, 2) + k) % 144] += mass / count
    sums = [Fraction(0)]
    for cell in cells * 2:
        sums.append(sums[-1] + cell)
    wide = int(width / Fraction(5, 2))
    return {GRID[k]: sums[k + wide] - sums[k] for k in range(144)}


def as_bins(histogram):
    edges, counts = histogram
    return [
        (a, b, Fraction(n, sum(counts))) for a, b, n in zip(edges, edges[1:], counts, strict=False)
    ]


def prior_of(points):
    return DiscretePrior([(place, weight) for place, weight in points.items()])


# --- discrete ------------------------------------------------------------------------------------


@given(weighted_points(), grid_widths)
def test_discrete_against_every_start(points, width):
    window = prior_of(points).best_window(Angle.from_degrees(width))
    masses = {start: points_in(points, start, width) for start in GRID}
    best = max(masses.values())
    assert window.exact
    assert window.mass.rational == best
    aligned = [a for a in sorted({0, *points}) if masses[a] == best and (not a or points[a])]
    assert degrees(window.start) == aligned[0]


@given(weighted_points(), st.sampled_from(GRID), grid_widths)
def test_discrete_mass(points, start, width):
    arc = Arc(Angle.from_degrees(start), Angle.from_degrees(width))
    assert prior_of(points).mass(arc).rational == points_in(points, start, width)


@given(circle_points(), orientations.filter(lambda a: ZERO < a <= FULL_TURN))
def test_discrete_at_any_angles(points, width):
    prior = DiscretePrior(points)
    window = prior.best_window(width)
    caught = {}
    for start in (ZERO, *(angle for angle, _ in points)):
        arc = Arc(start.reduced(), width)
        caught[arc.start] = sum(w for a, w in points if arc.contains(a))
        assert prior.mass(arc).rational == caught[arc.start]
    best = max(caught.values())
    assert window.mass.rational == best
    assert window.start == min(start for start, mass in caught.items() if mass == best)


@given(weighted_points(), grid_widths)
def test_both_roads_of_counting_agree(points, width):
    prior, other = prior_of(points), prior_of(points)
    assert other.points._grid is not None
    other.points._grid = None  # so that LiftedAngles counts
    angle = Angle.from_degrees(width)
    assert prior.points.last_below(angle).tolist() == other.points.last_below(angle).tolist()
    assert prior.best_window(angle) == other.best_window(angle)


# --- piecewise -----------------------------------------------------------------------------------


@given(histograms(), grid_widths)
def test_piecewise_against_every_start(histogram, width):
    window = PiecewisePrior.from_histogram(*histogram).best_window(Angle.from_degrees(width))
    masses = bins_in_all(as_bins(histogram), width)
    best = max(masses.values())
    assert window.exact
    assert window.mass.rational == best
    # All bends are on the grid, so the smallest start of all is on it too.
    assert degrees(window.start) == min(start for start in GRID if masses[start] == best)


@given(histograms(), orientations.filter(lambda a: ZERO < a <= FULL_TURN), orientations)
def test_piecewise_no_start_is_better(histogram, width, start):
    prior = PiecewisePrior.from_histogram(*histogram)
    window = prior.best_window(width)
    assert prior.mass(Arc(window.start, width)) == window.mass
    assert prior.mass(Arc(start, width)) <= window.mass
    for edge in histogram[0]:
        place = Angle.from_degrees(edge)
        for other in (place, place - width):
            found = prior.mass(Arc(other, width)).compare(window.mass)
            assert found < 0 or (found == 0 and window.start <= other.reduced())


# --- mixtures ------------------------------------------------------------------------------------


@given(weighted_points(), histograms(), weights, grid_widths)
def test_mixture_against_every_start(points, histogram, share, width):
    prior = MixturePrior(
        [(share, prior_of(points)), (1 - share, PiecewisePrior.from_histogram(*histogram))]
    )
    window = prior.best_window(Angle.from_degrees(width))
    spread = bins_in_all(as_bins(histogram), width)

    def mixed(caught, start):
        return share * caught + (1 - share) * spread[start]

    masses = {s: mixed(points_in(points, s, width), s) for s in GRID}
    # Just above a start, the window has lost a point at the start and gained one at the end.
    limits = [mixed(points_in(points, s + Fraction(1, 1000), width), s) for s in GRID]
    supremum = max(*masses.values(), *limits)
    if width == 360:
        supremum = Fraction(1)
    if max(masses.values()) == supremum:
        assert window.exact
        assert window.mass.rational == supremum
        assert masses.get(degrees(window.start)) == supremum
    else:
        assert not window.exact
        assert window.at_most.rational == supremum
        mass = window.mass.rational
        assert max(masses.values()) <= mass < supremum
        assert supremum - mass < Fraction(1, 10**4)
    arc = Arc(window.start, Angle.from_degrees(width))
    assert prior.mass(arc) == window.mass


@given(weighted_points(), histograms(), st.sampled_from(GRID), grid_widths)
def test_nested_mixtures_are_flat(points, histogram, start, width):
    a, b = prior_of(points), PiecewisePrior.from_histogram(*histogram)
    flat = MixturePrior([("1/4", a), ("1/4", b), ("1/2", uniform_prior())])
    nested = MixturePrior(
        [("1/2", MixturePrior([("1/2", a), ("1/2", b)])), ("1/2", uniform_prior())]
    )
    arc = Arc(Angle.from_degrees(start), Angle.from_degrees(width))
    expected = (
        points_in(points, start, width) / 4
        + bins_in_all(as_bins(histogram), width)[start] / 4
        + width / 720
    )
    assert flat.mass(arc).rational == nested.mass(arc).rational == expected
    assert flat.best_window(arc.width) == nested.best_window(arc.width)


# --- normal and von Mises ------------------------------------------------------------------------

DENSITIES = [
    *(WrappedNormal("10", sd) for sd in ("1/2", "5", "40", "90", "91", "200", "2000")),
    *(VonMises("10", kappa) for kappa in ("1/100", "1", "4", "30", "200")),
]
ARCS = [
    Arc(Angle.from_degrees(start), width)
    for start, width in [
        (0, Angle(0, (3, 2))),
        (10, Angle.from_degrees(10)),
        (300, Angle(0, (-3, -2))),
        (185, Angle.from_degrees("0.5")),
        (-5, Angle(0, (-1, 10))),
    ]
]
each_density = pytest.mark.parametrize("prior", DENSITIES, ids=lambda prior: prior.describe())


@each_density
def test_masses_against_mpmath(prior):
    mp = pytest.importorskip("mpmath")
    with mp.workdps(30):

        def radians(angle):
            return mp.mpf(angle.degrees(32)) * mp.pi / 180

        for arc in ARCS:
            start = radians(arc.start) - radians(prior.mean)
            end = start + radians(arc.width)
            expected = (
                slow_normal(mp, prior, start, end)
                if prior.kind == "normal"
                else (slow_von_mises(mp, prior, start, end))
            )
            assert abs(mp.mpf(prior.mass(arc).decimal(16)) - expected) < mp.mpf(10) ** -16


def slow_normal(mp, prior, start, end):
    scale = mp.mpf(int(prior.sd.numerator)) / int(prior.sd.denominator) * mp.pi / 180 * mp.sqrt(2)
    reach = 3 + int(prior.sd / 30)
    return (
        mp.fsum(
            mp.erf((end + 2 * mp.pi * k) / scale) - mp.erf((start + 2 * mp.pi * k) / scale)
            for k in range(-reach, reach + 1)
        )
        / 2
    )


def slow_von_mises(mp, prior, start, end):
    kappa = mp.mpf(int(prior.kappa.numerator)) / int(prior.kappa.denominator)
    places = mp.linspace(start, end, 12)
    total = mp.quad(lambda t: mp.exp(kappa * mp.cos(t)), places)
    return total / (2 * mp.pi * mp.besseli(0, kappa))


@each_density
def test_masses_against_simpson(prior):
    """The mass is the integral of the density, by a rule of 200 intervals in floats."""
    for arc in ARCS:
        count = 200
        places = [arc.start + Angle.from_turns(Fraction(k, 100 * count)) for k in range(count + 1)]
        values = [float(prior.density_at(place)) for place in places]
        total = values[0] + values[-1] + 4 * sum(values[1:-1:2]) + 2 * sum(values[2:-1:2])
        piece = Arc(arc.start, Angle.from_turns(Fraction(1, 100)))
        assert abs(float(prior.mass(piece)) - total / (300 * count)) < 1e-9


def test_von_mises_against_scipy():
    stats = pytest.importorskip("scipy.stats")
    prior, start = VonMises(0, 3), Angle.from_degrees(-40)
    for width in (10, 60, 100):
        mass = float(prior.mass(Arc(start, Angle.from_degrees(width))))
        ends = [degrees(start) * 3.141592653589793 / 180, (width - 40) * 3.141592653589793 / 180]
        low, high = stats.vonmises.cdf([float(end) for end in ends], 3)
        assert abs(mass - (high - low)) < 1e-9


@each_density
@pytest.mark.parametrize("width", [Angle(0, (3, 2)), Angle.from_degrees(20), Angle(0, (-9, -7))])
def test_no_start_is_better(prior, width):
    window = prior.best_window(width)
    bound = window.mass if window.exact else window.at_most
    for k in range(24):
        other = prior.mass(Arc(window.start + Angle.from_degrees(15 * k + 1), width))
        assert float(other) <= float(bound)
    assert 0 <= float(bound) - float(window.mass) < 1e-9


@given(grid_degrees)
def test_the_oracle_counts_half_open(place):
    assert points_in({place: 1}, place, 15) == 1
    assert points_in({place: 1}, place - 15, 15) == 0
