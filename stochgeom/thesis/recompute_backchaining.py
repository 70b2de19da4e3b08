"""What settles the errata on backchaining: Lemma 5.1, Eq. 5.7, and how many plans phase I makes."""

from __future__ import annotations

from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc, ClosedArc
from stochgeom.feeding.adversarial import FAMILIES
from stochgeom.feeding.execution import composite, run_arc
from stochgeom.feeding.exhaustive import search_plans
from stochgeom.feeding.preimages import preimages
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.thesis.facts import Fact, Facts, equal
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction


def closure_in_lemma_5_1() -> Facts:
    """Show that a plan need not collapse the smallest contiguous set around a collapsed one.

    It collapses one of the two arcs between two orientations that end alike: a plan is a monotone
    map F of degree one, so F grows by one turn over both arcs together, and by none over one. That
    arc is narrower than a period T, as F(theta + T) = F(theta) + T. So for T of at most half a turn
    it is the shorter one, and the lemma holds as printed; push-grasps have a T of a whole turn.
    """
    problem = FeedingProblem(catalogue_part("house", appendix="E"), "push-grasp")
    whole = composite(problem.transfer, [action.angle for action in problem.plan_of(2).actions])
    low, high = Angle.from_degrees(34), Angle.from_degrees(180)
    ends = [whole(theta).reduced() for theta in (low, high)]
    shorter, longer = Arc(low, high - low), Arc(high, low + FULL_TURN - high)
    elsewhere = [
        width
        for width, value in zip(whole.widths, whole.values, strict=True)
        if value.reduced() != ends[0]
    ]
    chains = [
        (preimage.width, problem.transfer.period)
        for problem in (FeedingProblem(catalogue_part(name)) for name in catalogue_names())
        for preimage in problem.preimages
    ]
    return (
        equal(
            "where two push-grasps of App. E's house bring the orientations 34 and 180",
            [end.degrees(0) for end in ends],
            ["90", "90"],
        ),
        Fact("the shorter arc between them", shorter.width.degrees(0), shorter.width < HALF_TURN),
        equal(
            "  how far apart its ends and its inside are brought",
            whole.image(shorter).width.degrees(0),
            "180",
        ),
        Fact(
            "  degrees of it that end elsewhere",
            ", ".join(width.degrees(2) for width in elsewhere),
            ZERO < sum(elsewhere, start=ZERO) < shorter.width,
        ),
        equal("the longer arc is collapsed: width of its image", whole.image(longer).width, ZERO),
        equal("the period of these push-grasps", problem.transfer.period, FULL_TURN),
        Fact(
            "arcs that phase I collapses by squeezes of the eight parts, none wider than T <= 180",
            str(len(chains)),
            all(width <= period <= HALF_TURN for width, period in chains),
        ),
    )


def wider_arcs_in_5_7() -> Facts:
    """Show that an image exactly as wide as the preimage before cannot be collapsed by it.

    An image is closed and a preimage is not: of [a, a + h] and [b, b + h) no turn puts the one into
    the other. Seen on a part in which such a tie makes the difference of a step.
    """
    transfer = squeeze_function(FAMILIES["structural ties"](4, 0))
    chain = list(preimages(transfer))
    second, third = chain[1], chain[2]
    arc, image = _with_image_of(transfer, second.width)
    turn = image.start - second.arc.start
    # The plan that would follow: onto the second preimage, and on from there as that one goes on.
    onward = second.image.start - chain[0].arc.start
    images = run_arc(transfer, [ZERO, turn, onward], arc)
    proper = run_arc(transfer, [ZERO, third.image.start - second.arc.start, onward], third.arc)
    return (
        Fact(
            "an arc wider than the third preimage, in degrees",
            f"{arc.width.degrees(2)} > {third.width.degrees(2)}",
            arc.width > third.width,
        ),
        equal("its image is exactly as wide as the second preimage", image.width, second.width),
        Fact(
            "turned onto that one, what three actions make of it, in degrees",
            images[-1].width.degrees(2),
            images[-1].width > ZERO,
        ),
        equal("what they make of the third preimage", proper[-1].width, ZERO),
        equal(
            "the wider arc is a period, so that <= would promise 3 steps",
            arc.width,
            transfer.period,
        ),
        equal("steps of the shortest plan", len(chain), 4),
        equal(
            "of 3 steps, the most that any plan collapses, by search",
            search_plans(transfer).lengths[2].width,
            third.width,
        ),
    )


def _with_image_of(transfer: StepFunction, width: Angle) -> tuple[Arc, ClosedArc]:
    """Return the widest arc of whole steps whose image has a width, and the image."""
    size = len(transfer)
    breaks, values = transfer.lifted_breaks, transfer.lifted_values
    _, arc = max(
        (breaks[last + 1] - breaks[first], Arc(breaks[first], breaks[last + 1] - breaks[first]))
        for first in range(size)
        for last in range(first, first + size)
        if values[last] - values[first] == width
    )
    return arc, transfer.image(arc)


def plans_of_phase_one() -> Facts:
    """Show that N preimages give plans of 1 to N steps: the last one takes N, not N - 1."""
    counts, needed = [], []
    for name in catalogue_names():
        problem = FeedingProblem(catalogue_part(name))
        chain = list(problem.preimages)
        plan = problem.plan_of(len(chain))
        counts.append((len(chain), plan.steps, plan.verify()))
        lengths = search_plans(problem.transfer).lengths
        shorter = max(length.width for length in lengths if length.steps == len(chain) - 1)
        needed.append(shorter < chain[-1].width)
    return (
        equal(
            "preimages of the eight parts",
            [number for number, _, _ in counts],
            [3, 2, 2, 4, 3, 3, 2, 3],
        ),
        equal(
            "steps of the plans for the last preimage of each, which collapse it",
            [steps for _, steps, works in counts if works],
            [number for number, _, _ in counts],
        ),
        equal(
            "parts of which no plan of one step less collapses as much, by search",
            sum(needed),
            len(counts),
        ),
    )
