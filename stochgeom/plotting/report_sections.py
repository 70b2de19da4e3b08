"""The sections of the page of a plan, each a generator of HTML; `report` puts them together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Final

from stochgeom.errors import InputError
from stochgeom.io.embedded import CERTIFICATE, PLAN, data_block
from stochgeom.io.plan_json import plan_json
from stochgeom.plotting.animation_stage import (
    control,
    panel,
    still,
)
from stochgeom.plotting.function_scenes import analysis_scene, function_behind
from stochgeom.plotting.funnel_scenes import funnel_scene
from stochgeom.plotting.report_pictures import distributions_scene, tolerance_scene
from stochgeom.plotting.report_subject import Subject, shown_rows
from stochgeom.plotting.report_tables import (
    action_table,
    caught,
    cost_table,
    distribution_table,
    exact_actions,
    exact_function,
    exact_preimages,
    table,
    vertex_table,
)
from stochgeom.plotting.report_words import (
    frame_of_reference,
    panel_caption,
    panel_description,
    said_at,
    verdict,
)
from stochgeom.plotting.scene import Scene
from stochgeom.plotting.svg import svg_document, text_of

if TYPE_CHECKING:
    from stochgeom.feeding.plans import FeedingPlan

MOST_PICTURED: Final = 12
"""Rows of a picture, and columns of the table of stills."""

MOST_DRAWN: Final = 1000
"""Orientations of a distribution, and steps of a function, that a picture shows."""

MOST_CERTIFIED: Final = 1000
"""Vertices of a part whose certificate a page carries; it may grow with their square."""


def _picture(scene: Scene, title: str, description: str) -> str:
    """Return a drawing that scrolls sideways where the page is narrower than it can be read."""
    svg = svg_document(scene, title=title, description=description, scale=1.0, background=False)
    return f'<div class="wide" tabindex="0" role="region" aria-label="{text_of(title)}">{svg}</div>'


def player_section(subject: Subject) -> Iterator[str]:
    """Yield the animation with its control, and the same as stills."""
    actions, steps = subject.actions, subject.plan.steps
    if actions < steps:
        yield f"<p>The first {actions} of {steps} actions.</p>"
    buttons, labels = control(actions)
    yield f'<div class="player" role="group" aria-label="animation">\n{buttons}\n{labels}'
    yield '<div class="said"><p class="play">All actions, one after the other, again and again. '
    yield "Choose a number to see one action; the arrow keys step through them.</p>"
    yield from (f'<p class="s{k}">{said_at(subject, k)}</p>' for k in range(actions + 1))
    yield f'</div>\n<div class="stage of{len(subject.traces)}">'
    for place, trace in enumerate(subject.traces):
        caption, words = panel_caption(subject, trace), panel_description(subject, trace)
        yield panel(place, trace, caption, words)
    yield "</div></div>"
    yield _stills(subject)


def _stills(subject: Subject) -> str:
    shown = min(subject.actions, MOST_PICTURED)
    header = ["begins at", "start", *(f"after {k}" for k in range(1, shown + 1)), "in the end"]
    rows = []
    for trace in subject.traces:
        word, accepted = verdict(subject.plan, trace.states[-1])
        kind = ' class="yes"' if accepted else ""
        pictures = [
            f"{still(trace, k)}{trace.states[k].reduced().degrees(2)}°" for k in range(shown + 1)
        ]
        rows.append([f"{trace.start.degrees(2)}°", *pictures, f"<b{kind}>{word}</b>"])
    caption = "The same parts, still: orientations relative to the gripper after each action"
    return table(caption, header, rows, kind="strip")


def actions_section(subject: Subject) -> Iterator[str]:
    """Yield the table of the actions, and a picture of their ranges."""
    yield frame_of_reference(subject)
    yield action_table(subject)
    if subject.plan.margin is None:
        return
    shown = list(range(subject.plan.steps))
    if len(shown) > 2 * MOST_PICTURED:
        few = MOST_PICTURED
        yield f"<p>Of {len(shown)} ranges the first {few} and the last {few} are drawn.</p>"
        shown = shown[:few] + shown[-few:]
    yield _picture(
        tolerance_scene(
            [(k + 1, subject.plan.actions[k]) for k in shown],
            free="any angle" if subject.plan.prior is None else "aims the mouth: no range",
        ),
        "By how much each angle may be off",
        "For each action a bar about the angle of the plan, which the triangle marks: from the "
        "lower end of its range, hollow: not included, to the upper end, filled: included. The "
        "table above has the numbers.",
    )


def distributions_section(subject: Subject) -> Iterator[str]:
    """Yield what is known of the orientation after each action."""
    steps, half = subject.plan.steps, MOST_PICTURED // 2
    if subject.plan.prior is not None and steps <= MOST_PICTURED:
        yield from _funnel(subject)
    few = [k for k in range(1, steps + 1) if len(subject.outcomes[k - 1]) <= MOST_DRAWN]
    shown = few
    if len(few) < steps:
        yield f"<p>Actions that leave more than {MOST_DRAWN} orientations are left out.</p>"
    if len(few) > MOST_PICTURED:
        shown = few[:half] + few[-half:]
        yield f"<p>Of {len(few)} actions the first {half} and the last {half} are shown.</p>"
    if not shown:
        return
    goal = subject.plan.final_orientation
    yield (
        "<p>The probability of each orientation relative to the gripper after each action; the "
        f"accepted one, {goal.reduced().degrees(subject.digits)}°, is dark.</p>"
    )
    yield _picture(
        distributions_scene([(k, subject.state(k)) for k in shown], goal),
        "Distribution after each action",
        "A row for each action; over the axis of orientations from 0 to 360 degrees a stem as "
        "high as the probability. The tables below have the numbers.",
    )
    tables = "\n".join(distribution_table(subject, k) for k in shown)
    yield f"<details><summary>All probabilities</summary>\n{tables}\n</details>"


def _funnel(subject: Subject) -> Iterator[str]:
    """Yield the prior, what the mouth catches of it, and how the actions narrow that."""
    yield (
        "<p>How parts arrive, above, and what the plan catches of it, shaded. Each action takes "
        "the wide arc to the narrow one below it; horizontal is the part's angle on the table.</p>"
    )
    yield _picture(
        funnel_scene(subject.plan),
        "The prior and the plan as a funnel",
        f"What arrives at {caught(subject)} is caught; each action makes the arc narrower, until "
        "one orientation is left.",
    )


def functions_section(subject: Subject) -> Iterator[str]:
    """Yield the functions behind the plan, and its preimages."""
    plan = subject.plan
    action = text_of(subject.action)
    wave = function_behind(plan.part, plan.action_name)
    words = f"The {action} function takes an orientation to the one after {_an(action)} at angle 0."
    if plan.part is not None and subject.action == "squeeze":
        words += (
            " Squeezed, the part turns from wherever it is to the local minimum of its diameter "
            "between two local maxima."
        )
    elif plan.part is not None and subject.action == "push-grasp":
        words += (
            " Pushed, the part turns to a local minimum of its radius, the height of the centre of "
            "mass over the jaw; then the squeeze turns it on."
        )
    yield (
        f"<p>{words} Below are the widest arcs of orientations that 1, 2, … actions bring to one: "
        "each has an image that fits inside the arc above it.</p>"
    )
    states = len(plan.transfer) * plan.transfer.order
    if states > MOST_DRAWN:
        yield f"<p>The function has {states} steps in a full turn, too many to draw.</p>"
        return
    chain = [subject.chain[k] for k in shown_rows(len(subject.chain)) if k is not None]
    yield _picture(
        analysis_scene(plan.transfer, chain, wave, name=f"{subject.action} function", width=760.0),
        f"{subject.action} function and preimages",
        "A graph of the part's diameter or radius, under it the step function with its fixed "
        "diagonal, under that the preimages as bars. The exact numbers are given below.",
    )


def _an(noun: str) -> str:
    return f"an {noun}" if noun[:1] in "aeiou" else f"a {noun}"


def costs_section(subject: Subject) -> Iterator[str]:
    """Yield the costs of plans of other lengths."""
    yield (
        "<p>The expected cost counts all rounds until one part is accepted: the actions and a pass "
        "through the filter, divided by the probability. The row of this plan is marked.</p>"
    )
    yield cost_table(subject)


def exact_section(subject: Subject) -> Iterator[str]:
    """Yield every number of the page that decimals round."""
    yield (
        "<p><code>arg(x, y)</code> is the angle in [0°, 360°) of the direction (x, y), not "
        "rounded. All decimals of this page are rounded correctly from such numbers.</p>"
    )
    blocks = [("Actions", exact_actions(subject))]
    blocks.append((f"{text_of(subject.action)} function", exact_function(subject)))
    blocks.append(("Preimages", exact_preimages(subject)))
    if subject.plan.part is not None:
        blocks.append(("Outline of the part", vertex_table(subject)))
    for title, content in blocks:
        yield f"<details><summary>{title}</summary>\n{content}\n</details>"


def certificate_section(subject: Subject) -> Iterator[str]:
    """Yield the proof of the plan, or the reason why it has none."""
    document, reason = _proof(subject.plan)
    if document is not None:
        yield (
            "<p>This page carries the plan with everything that proves it, in a data block. "
            "<code>stochgeom verify THIS-FILE</code> reads it out and checks every claim anew, "
            "with a program that shares no code with the planner. By hand: it is the JSON in "
            f"the element with the id <code>{CERTIFICATE}</code>. Checked is that block, not what "
            "this page shows.</p><p>What is certified: where the mouth ends, the ranges of the "
            "actions, and that no plan of an exact gripper, whatever its final orientation, costs "
            "less if parts arrive in any orientation, all equally likely. A goal or a gripper "
            "error that was asked for is not part of the document.</p>"
        )
        yield data_block(CERTIFICATE, document)
        return
    yield (
        f"<p>This page carries no certificate: {text_of(_as_prose(reason))}. The plan itself, with "
        f"exact angles and ranges, is the JSON in the element with the id <code>{PLAN}</code>.</p>"
    )
    yield data_block(PLAN, plan_json(subject.plan, subject.digits))


def _as_prose(message: str) -> str:
    """Return the message of an error without "accepted", which orientations are on this page."""
    return message.replace("; accepted: ", ". Certified are ")


def _proof(plan: FeedingPlan) -> tuple[dict[str, Any] | None, str]:
    """Return the certificate, or why there is none."""
    part = plan.part
    if part is not None and len(part) > MOST_CERTIFIED:
        return None, (
            f"of a part of more than {MOST_CERTIFIED} vertices it is large; stochgeom plan "
            "--certificate FILE writes it"
        )
    try:
        return plan.certificate(), ""
    except InputError as error:
        return None, error.message
