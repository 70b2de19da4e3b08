"""`DiscretePrior`: worked windows, merging, large and crowded priors."""

from __future__ import annotations

import pytest
from gmpy2 import mpq

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.mixture_prior import MixturePrior
from stochgeom.errors import InvalidArcError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from tests.strategies import TINY

THREE = DiscretePrior({"0": "1/2", "90": "1/4", "100.5": "1/4"})


def deg(value):
    return Angle.from_degrees(value)


def test_what_it_holds():
    assert THREE.orientations == (ZERO, deg(90), deg("100.5"))
    assert THREE.weights == (mpq(1, 2), mpq(1, 4), mpq(1, 4))
    assert (THREE.kind, THREE.describe()) == ("discrete", "discrete, 3 orientations")
    assert DiscretePrior({"7": 1}).describe() == "discrete, 1 orientation"


@pytest.mark.parametrize(
    ("width", "start", "mass"),
    [
        ("1", "0", "1/2"),
        ("90", "0", "1/2"),  # half open: 90 is not caught
        ("90.001", "0", "3/4"),
        ("100.5", "0", "3/4"),
        ("100.6", "0", "1"),
        ("10.5", "0", "1/2"),
        ("360", "0", "1"),
    ],
)
def test_windows_from_zero(width, start, mass):
    window = THREE.best_window(deg(width))
    assert (window.start, window.mass.rational) == (deg(start), mpq(mass))
    assert (window.exact, window.at_most) == (True, None)


def test_a_window_may_pass_zero():
    prior = DiscretePrior({"350": "2/5", "5": "2/5", "180": "1/5"})
    window = prior.best_window(deg("15.5"))
    assert (window.start, window.mass.rational) == (deg(350), mpq(4, 5))


def test_ties_go_to_the_smallest_start():
    prior = DiscretePrior({"350": "2/5", "5": "2/5", "180": "1/5"})
    assert prior.best_window(deg(15)).start == ZERO  # 350 alone, or 5 alone
    assert prior.best_window(deg(5)).start == deg(5)  # from 0 it would miss 5
    for alike in (prior, MixturePrior([(1, prior)])):
        assert alike.best_window(FULL_TURN).start == ZERO
        assert alike.best_window(deg(351)).start == ZERO
        assert alike.best_window(deg(340)).start == deg(180)


def test_equal_orientations_are_merged():
    prior = DiscretePrior([("10", "1/4"), (deg(370), "1/4"), ("-350", "1/4"), ("20", "1/4")])
    assert prior.weights == (mpq(3, 4), mpq(1, 4))


def test_zero_weights_are_left_out():
    prior = DiscretePrior({"10": 0, "200": 1})
    assert prior.orientations == (deg(200),)
    assert prior.best_window(deg(5)).start == deg(200)


def test_orientations_that_no_float_tells_apart():
    prior = DiscretePrior([(TINY + TINY, "1/4"), (ZERO, "1/2"), (TINY, "1/4")])
    assert prior.orientations == (ZERO, TINY, TINY + TINY)
    assert prior.best_window(TINY).mass.rational == mpq(1, 2)
    assert prior.best_window(TINY + TINY).mass.rational == mpq(3, 4)
    assert prior.mass(Arc(TINY, TINY)).rational == mpq(1, 4)


def test_widths_that_are_no_rational_degrees():
    prior = DiscretePrior({"0": "1/2", "30": "1/2"})
    assert prior.best_window(Angle(0, (5, 3))).mass.rational == 1  # 30.96 degrees
    assert prior.best_window(Angle(0, (2, 1))).mass.rational == mpq(1, 2)  # 26.57 degrees


def test_from_counts_and_measurements():
    assert DiscretePrior.from_counts({"0": 2, "90": 1, "100.5": 1}) == THREE
    measured = DiscretePrior.from_measurements(["0", "90", "360", "100.5"])
    assert measured == THREE
    assert hash(measured) == hash(THREE)
    assert measured != DiscretePrior({"0": 1})


def test_weights_beyond_machine_integers():
    tiny = mpq(1, 10**30)
    prior = DiscretePrior({"0": tiny, "10": 1 - tiny})
    assert prior.points.sums.dtype == object
    assert prior.best_window(deg(5)).mass.rational == 1 - tiny
    assert prior.best_window(deg("10.01")).mass.rational == 1


def test_denominators_beyond_machine_integers():
    places = [mpq(1, 10**10 + k) for k in (19, 33, 61)]
    prior = DiscretePrior([(Angle.from_turns(p), "1/3") for p in places])
    assert prior.points._grid is None
    assert prior.best_window(Angle.from_turns(places[0] - places[1])).mass.rational == mpq(1, 3)


def test_many_tied_points():
    prior = DiscretePrior.from_counts([(mpq(k, 10), 1) for k in range(3600)])
    window = prior.best_window(deg(90))
    assert (window.start, window.mass.rational) == (ZERO, mpq(1, 4))
    assert prior.mass(Arc(deg("0.05"), deg(90))).rational == mpq(1, 4)


def test_repr_is_the_constructor_call():
    assert eval(repr(THREE)) == THREE


@pytest.mark.parametrize("width", [ZERO, deg(-1), FULL_TURN + TINY])
def test_bad_widths(width):
    with pytest.raises(InvalidArcError, match="more than 0, at most 360"):
        THREE.best_window(width)


@pytest.mark.parametrize("exact_grid", [True, False])
@pytest.mark.parametrize("kind", ["even", "clustered", "turning"])
def test_blocks_leave_nothing_out(kind, exact_grid):
    """More points than are tried one by one, against every one of them."""
    counts = {
        "even": [1] * 720,
        "clustered": [1 + 9 * (200 <= k < 230) for k in range(720)],
        "turning": [k * k * 7919 % 101 for k in range(720)],
    }[kind]
    prior = DiscretePrior.from_counts([(mpq(k, 2), count) for k, count in enumerate(counts)])
    if not exact_grid:
        prior.points._grid = None
    for width in (deg("0.5"), deg(15), Angle(0, (3, 2)), deg(359)):
        reach = sum(deg(mpq(k, 2)) < width for k in range(720))
        sums = [sum((counts + counts)[k : k + reach]) if counts[k] else -1 for k in range(720)]
        window = prior.best_window(width)
        assert window.mass.rational == mpq(max(sums), sum(counts))
        assert window.start == deg(mpq(sums.index(max(sums)), 2))
