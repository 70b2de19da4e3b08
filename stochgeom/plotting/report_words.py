"""The sentences of a report, as HTML."""

from __future__ import annotations

from stochgeom.exact.angles import Angle
from stochgeom.feeding.actions import printed_margin
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.plotting.animation_motion import Trace
from stochgeom.plotting.report_subject import Subject
from stochgeom.plotting.report_tables import angle_and_range, caught
from stochgeom.plotting.svg import text_of


def headline(subject: Subject) -> str:
    """Say what the plan does to the part."""
    plan = subject.plan
    order = plan.transfer.order
    if plan.orients_up_to_symmetry and order == 1:
        what = "Every initial orientation ends in one and the same: the part is oriented uniquely."
    elif plan.orients_up_to_symmetry:
        period = short_degrees(plan.transfer.period)
        what = (
            f"Every initial orientation ends in one of {order}, {period}° apart, which the "
            f"{text_of(subject.action)} function cannot tell from each other. A filter accepts one "
            "and sends the rest around again."
        )
    else:
        width = plan.mouth.width.degrees(subject.digits)
        where = f"in an arc of {width}°" if plan.prior is None else f"from {caught(subject)}"
        what = (
            f"The initial orientations {where} end in one and the same. A filter "
            "accepts that one and sends the rest around again."
        )
    if plan.prior is None:
        arrival = "Parts arrive in any orientation, all equally likely."
    else:
        arrival = (
            f"Parts arrive so: {text_of(plan.prior.describe())}. The first action turns the "
            f"gripper so that what arrives at {caught(subject)}, the mouth of the plan, ends in "
            "the accepted orientation."
        )
    return f"<p>{what}</p><p>{arrival}</p>"


def facts(subject: Subject) -> list[tuple[str, str]]:
    """Return the figures that matter most, each with what it is."""
    plan = subject.plan
    action = text_of(subject.action)
    found = [
        (str(plan.steps), text_of(plan.counted_actions.partition(" ")[2])),
        (plan.probability.decimal(4), "probability of the accepted orientation"),
        (plan.expected_cost.decimal(2), f"expected cost, in {action} times, with all rounds"),
    ]
    if plan.transfer.order > 1:
        cost = plan.expected_cost_up_to_symmetry.decimal(2)
        found.append((cost, "expected cost if equivalent orientations are accepted too"))
    return [*found, _borne(subject)]


def _borne(subject: Subject) -> tuple[str, str]:
    least = printed_margin(subject.plan.actions, subject.digits)
    if least is not None:
        return f"{least}°", "gripper errors below this are borne"
    if subject.plan.prior is None:
        return "any", "gripper error is borne: the only turn is random"
    return "none", "of the gripper's errors breaks the plan, but each moves the mouth"


def frame_of_reference(subject: Subject) -> str:
    """Say what the angles mean."""
    words = (
        "Angles are counter-clockwise. An action turns the gripper by its angle relative to the "
        "gripper's last pose, closes it and opens it again. An orientation is that of the part "
        "relative to the gripper. Ranges are open below and closed above, hold whatever the other "
        "actions do inside theirs, and are rounded inwards: they work as printed."
    )
    if subject.plan.prior is not None:
        words += (
            " The first action has no range: any other angle moves the mouth and catches other "
            "parts. Its angle is relative to the pose in which initial orientations are counted."
        )
    lines = [words]
    if subject.action == "push-grasp":
        lines.append("The lower jaw, drawn dark, pushes the part first; then both squeeze it.")
    if subject.plan.gripper_error:
        error = subject.plan.gripper_error.degrees(subject.digits)
        lines.append(
            f"Every action may be off by {error}° either way: the angles leave at least so much "
            "room in their ranges."
        )
    return f"<p>{' '.join(lines)}</p>"


# --- the animation -------------------------------------------------------------------------------


def said_at(subject: Subject, step: int) -> str:
    """Say what the action before this moment was, 0 for the start."""
    if step == 0:
        if subject.plan.prior is None:
            which = (
                "each from another set of initial orientations that the first action brings to one"
            )
        elif subject.plan.prior.kind == "discrete":
            which = "in orientations that were measured"
        else:
            which = "in orientations that part the prior into equal shares"
        return (
            f"Before the first action: parts between open jaws, {which}. The black dot is "
            "vertex 0, the white one the centre of mass."
        )
    angle, range_text = angle_and_range(subject, step - 1)
    verb = text_of(subject.action)
    if range_text == "any angle":
        turn = f"{verb}, after a random turn of the gripper, here none"
    elif range_text.startswith("("):
        turn = f"turn the gripper by {angle}, anywhere in {range_text}, then {verb}"
    else:
        turn = f"turn the gripper by {angle}, which {range_text}, then {verb}"
    outcome = subject.outcomes[step - 1]
    count = subject.left(step)
    left = "orientation is" if count == 1 else "orientations are"
    likeliest = outcome.most_likely().decimal(subject.digits)
    return (
        f"<strong>Action {step}</strong>: {turn}. {count} {left} left; "
        f"the likeliest has probability {likeliest}."
    )


def verdict(plan: FeedingPlan, final: Angle) -> tuple[str, bool]:
    """Say what the filter does with a final orientation, and whether it accepts it.

    Decided exactly.
    """
    goal = plan.final_orientation
    if final.reduced() == goal.reduced():
        return "accepted", True
    if final % plan.transfer.period == goal % plan.transfer.period:
        return "equivalent", False
    return "sent around again", False


def panel_caption(subject: Subject, trace: Trace) -> str:
    """Say where a part begins and ends, and what comes of it."""
    word, accepted = verdict(subject.plan, trace.states[-1])
    final = trace.states[-1].reduced().degrees(2)
    kind = ' class="yes"' if accepted else ""
    return f"{trace.start.degrees(2)}° → {final}°<br><b{kind}>{word}</b>"


def panel_description(subject: Subject, trace: Trace) -> str:
    """Describe the way of a part to readers who do not see it."""
    shown = trace.states[1 : subject.actions + 1]
    path = ", ".join(
        f"after action {k} at {state.reduced().degrees(2)}" for k, state in enumerate(shown, 1)
    )
    word, _ = verdict(subject.plan, trace.states[-1])
    return f"Degrees relative to the gripper: {path}. In the end: {word}."


def short_degrees(angle: Angle) -> str:
    """Return degrees without superfluous zeros.

    Examples
    --------
    >>> short_degrees(Angle.from_degrees(180)), short_degrees(Angle.from_turns("1/7"))
    ('180', '51.4286')
    """
    return angle.degrees(4).rstrip("0").rstrip(".")
