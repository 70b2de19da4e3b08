"""Plans for parts that are not quite the part: vertices within epsilon of where they should be.

The claim. A plan *works for all parts near a part* if, whichever part comes whose vertices lie
within epsilon of the given ones, it ends in the plan's final state for every start in the mouth
outside the two *zones* that hold the mouth's ends. A zone is an arc of orientations where nobody
can say which way such a part turns; there is always one about the maxima at the ends of the mouth.
No such part may rest in what is cut off the mouth: so if a plan works for one epsilon, it does for
all smaller ones. If the mouth is a whole period, its two ends are one maximum, and what falls to
either side of it ends in equivalent states: then every start must work, without exception. A part
whose period is a share of half a turn (of a full turn, if it is pushed) loses that symmetry when
its vertices move, so the claim is made for the mouth and for all its equivalents.

The final state is the same if the same edges lie flush: every place where a part may come to rest
at last is due to points that stand on one jaw in the plan's final orientation. An edge with
vertices inside it may bend, and of two parallel edges either may be the one that lies flush; where
only one edge can, each part ends in exactly one orientation.

The proof. `stochgeom.geometry.contact_zones` bounds where all those parts come to rest from an arc
of orientations; the actions are run on arcs. What a zone at the end of a whole mouth adds: from
there a part comes to rest with what stands before the zone or with what stands after it, if no
place of rest lies between the two.

The proof is sufficient, not necessary: it takes the worst of every zone at once, though one vertex
cannot stand in two places. What it proves is true of every such part; what it does not prove may be
true all the same. A centre of mass that was given stays where it is; one that was not moves with
the outline and its holes.
"""

from __future__ import annotations

from typing import Final

from gmpy2 import mpq

from stochgeom.errors import InputError
from stochgeom.exact.surds import Scalar, rational_bounds
from stochgeom.feeding.nearby_courses import NearbyCourses
from stochgeom.feeding.plans import FeedingPlan

BISECTIONS: Final = 10
"""`tolerance_of` is within a 2**-10th of the largest vertex error that its method can prove."""

MOST_HALVINGS: Final = 48
"""Tolerances below a 2**-48th of the first bound are taken as none."""


def tolerance_of(plan: FeedingPlan, *, one_orientation: bool = False) -> mpq:
    """Return a vertex error that a plan is proven to survive, about the largest provable one.

    Parameters
    ----------
    plan : FeedingPlan
        A plan of squeezes or push-grasps that knows its part. If it was made for a gripper error,
        that may come on top.
    one_orientation : bool, default False
        Whether each part must end in exactly one orientation. A part whose final edge has a
        parallel one across has the tolerance 0 then: bend it a little, and it rests on either.

    Returns
    -------
    mpq
        epsilon: the plan works for every part whose vertices lie within epsilon of the given ones
        (what that means is in the docstring of `stochgeom.feeding.part_errors`). A certified lower
        bound of the true tolerance, itself proven to work; 0 if none is. In the part's units.

    Raises
    ------
    InputError
        If the plan is made of other actions, or does not know its part.

    Notes
    -----
    By bisection. The largest epsilon that the method can prove is at most 0.1 percent larger,
    provided that it is not smaller than a 2**-48th of the clearance that the other vertices have
    from the jaws in the final orientation.

    Examples
    --------
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> epsilon = tolerance_of(plan)
    >>> round(float(epsilon), 3)
    0.127
    """
    if not isinstance(plan, FeedingPlan):
        raise InputError(f"{plan!r:.60} is no plan; accepted: a FeedingPlan", where="plan")
    if plan.part is None:
        raise InputError("the plan does not know its part; accepted: plans with one", where="plan")
    courses = NearbyCourses.of_plan(plan, plan.part)

    def works(epsilon: mpq) -> bool:
        report = courses.report(epsilon)
        return report.proven and (report.one_orientation or not one_orientation)

    # Invariant: scale 2**high fails, for there another point can touch a jaw in the final
    # orientation; scale 2**low works, or is below what is looked for.
    scale, low, high = _power_above(courses.final_clearance / 4), -MOST_HALVINGS, 0
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if works(scale * mpq(2) ** middle) else (low, middle)
    if low == -MOST_HALVINGS:
        return mpq(0)
    best = step = scale * mpq(2) ** low
    for _ in range(BISECTIONS):
        step /= 2
        if works(best + step):
            best += step
    return best


def _power_above(squared: Scalar) -> mpq:
    """Return a power of two above the square root of a positive number, at most its eightfold."""
    _, squared = rational_bounds(squared)
    exponent = squared.numerator.bit_length() - squared.denominator.bit_length()
    return mpq(2) ** (exponent // 2 + 1)
