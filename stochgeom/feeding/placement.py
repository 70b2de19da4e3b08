"""Where the mouth of a plan is put, and how much of the prior it catches.

Under a uniform prior the place does not matter: the first action is a random turn. Under another
prior the first action turns the gripper so that the mouth covers the window of its width that
holds most probability (thesis App. F). If the gripper may be off by delta, only the orientations
at least delta inside the mouth are caught for sure: the window is 2 delta narrower than the
preimage. A mouth that is a whole period wide loses nothing at its ends but the choice between
equivalent final orientations, and one of a full turn loses nothing at all.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, final

from gmpy2 import mpq

from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.sums import AngleSum
from stochgeom.feeding.preimages import Preimage

if TYPE_CHECKING:
    from stochgeom.decision.priors import Prior
    from stochgeom.exact.sums import Probability


@final
@dataclass(frozen=True)
class Placement:
    """A mouth in place.

    Attributes
    ----------
    mouth : Arc
        The orientations before the first action that the plan collapses for sure.
    first_angle : Angle
        The first action; 0 under a uniform prior, where it is a random turn.
    probability : Probability
        Of the mouth, so of *one* final orientation.
    probability_up_to_symmetry : Probability
        Of the mouth and of its copies by whole periods, so of any equivalent final orientation.
    """

    mouth: Arc
    first_angle: Angle
    probability: Probability
    probability_up_to_symmetry: Probability


def place(preimage: Preimage, prior: Prior | None, gripper_error: Angle = ZERO) -> Placement | None:
    """Return the placement of most probability, None if the error leaves nothing to catch.

    Parameters
    ----------
    preimage : Preimage
        The widest arc of so many steps.
    prior : Prior or None
        None for the uniform prior.
    gripper_error : Angle
        delta, of the first action.
    """
    order = preimage.transfer.order
    if prior is None:
        width = preimage.width
        up_to_symmetry = TurnRatio(mpq(order), width)
        return Placement(preimage.arc, ZERO, TurnRatio(mpq(1), width), up_to_symmetry)
    width = preimage.width
    if width == FULL_TURN:
        gripper_error = ZERO
    width -= 2 * gripper_error
    if width <= ZERO:
        return None
    window = prior.best_window(width)
    mouth = Arc(window.start, width)
    return Placement(
        mouth,
        window.start - gripper_error - preimage.arc.start,
        window.mass,
        AngleSum(1) if preimage.is_period else _all_copies(mouth, preimage, prior),
    )


def _all_copies(mouth: Arc, preimage: Preimage, prior: Prior) -> Probability:
    """Return the mass of the copies of the mouth, which do not overlap."""
    period, order = preimage.transfer.period, preimage.transfer.order
    total: Any = prior.mass(mouth)
    for k in range(1, order):
        total = total + prior.mass(mouth.rotate(period * k))
    found: Probability = total
    return found
