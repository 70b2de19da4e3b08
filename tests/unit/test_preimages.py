"""`stochgeom.feeding.preimages`: phase I on parts small enough to follow by hand."""

from __future__ import annotations

import pytest

from stochgeom.errors import InputError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.feeding.preimages import preimages
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

RECTANGLE = squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])


def deg(*values):
    return [Angle.from_degrees(value) for value in values]


def test_rectangle():
    """The wide step first; then both steps, whose image of 90 degrees fits inside it."""
    one, two = preimages(RECTANGLE)
    assert (one.steps, two.steps) == (1, 2)
    assert (one.arc.start, one.arc.end) == (Angle(0, (-2, 3)), Angle(0, (-2, -3)))
    assert (one.image.start, one.image_width) == (HALF_TURN, ZERO)
    assert one.width == one.arc.width == Angle(0, (-5, 12))
    assert two.width == RECTANGLE.period
    assert two.image_width == QUARTER_TURN
    assert (one.ties, two.ties) == (1, 2)
    # Both arcs of a whole period are as wide, with images as wide: the smaller start wins.
    assert two.arc.start == Angle(0, (2, 3))
    assert (two.image.start, two.image.end) == (QUARTER_TURN, HALF_TURN)


@pytest.mark.parametrize(
    "vertices",
    [
        [(0, 0), (1, 0), (1, 1), (0, 1)],
        [(0, 0), (1, 0), (0, 1)],
        [(0, 0), (5, 0), (-1, 1)],
        [(0, 0), (3, 4), (-1, 7), (-4, 3)],
    ],
)
def test_one_squeeze_may_do(vertices):
    """A period is tested for from the first preimage on (errata, Fig. 5.1)."""
    transfer = squeeze_function(vertices)
    (only,) = preimages(transfer)
    assert only.width == transfer.period
    assert only.image_width == ZERO
    assert (only.steps, only.ties) == (1, 1)


def test_an_image_exactly_as_wide_does_not_fit():
    """Comparisons are strict: with h_1 = 20, images of 20 degrees are too wide."""
    transfer = StepFunction(deg(0, 10, 30), deg(0, 20, 40), Angle.from_degrees(45))
    chain = [(p.arc.start, p.width, p.image_width) for p in preimages(transfer)]
    assert chain == [
        tuple(deg(10, 20, 0)),
        tuple(deg(30, 25, 5)),  # not [0, 30) nor [10, 45): their images are 20 wide
        tuple(deg(10, 35, 20)),
        tuple(deg(10, 45, 25)),
    ]


@pytest.mark.parametrize(
    ("last_value", "start", "image"),
    [(270, 100, 120), (280, 100, 130), (290, 200, 120)],
)
def test_of_equally_wide_arcs_the_narrowest_image_wins(last_value, start, image):
    """After [200, 360), both [100, 360) and [200, 460) fit; of equal images the first one wins."""
    transfer = StepFunction(deg(0, 100, 200), deg(50, 150, last_value), FULL_TURN)
    second = preimages(transfer).of_steps(2)
    assert (second.arc.start, second.width, second.image_width) == tuple(deg(start, 260, image))
    assert second.ties == 2


def test_preimages_are_found_once_and_on_demand():
    chain = preimages(RECTANGLE)
    assert chain.found() == ()
    assert not chain.complete
    first = next(iter(chain))
    assert chain.found() == (first,)
    assert not chain.complete
    assert chain.of_steps(1) is first
    both = list(chain)
    assert chain.complete
    assert both[0] is first
    assert list(chain) == both == list(chain.found())
    # more steps do no better
    assert chain.of_steps(100) is both[1]
    assert len(chain.found()) == 2


@pytest.mark.parametrize("steps", [0, -1])
def test_no_preimage_of_less_than_one_step(steps):
    for chain in (preimages(RECTANGLE), preimages(RECTANGLE)):
        with pytest.raises(InputError, match="accepted"):
            chain.of_steps(steps)
        assert list(chain)  # also when all are found
        with pytest.raises(InputError, match="accepted"):
            chain.of_steps(steps)
    with pytest.raises(InputError, match="accepted"):
        FeedingProblem([(0, 0), (3, 0), (3, 2), (0, 2)]).expected_cost(steps)


def test_two_iterations_may_run_at_once():
    chain = preimages(RECTANGLE)
    left, right = iter(chain), iter(chain)
    assert [next(left), next(right), next(left), next(right)] == [
        chain.of_steps(k) for k in (1, 1, 2, 2)
    ]
    assert next(left, None) is next(right, None) is None
