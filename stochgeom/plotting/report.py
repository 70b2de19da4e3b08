"""A plan as one HTML page: what is fed, how, how well, and the proof.

The page refers to nothing outside itself and runs no script; the policy in its head forbids both.
The same plan gives the same bytes. Numbers are decimals of exact ones, correctly rounded; pictures
are drawn in floats.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, Final

from stochgeom.errors import InputError, NumberLimitError
from stochgeom.exact.decimals import check_digits
from stochgeom.exact.surds import scalar_to_float
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.io.embedded import CERTIFICATE, PLAN, data_block
from stochgeom.io.files import write_whole
from stochgeom.io.plan_json import plan_json
from stochgeom.plotting.animation_stage import (
    control,
    definitions,
    panel,
    stage_style,
    still,
)
from stochgeom.plotting.function_scenes import analysis_scene
from stochgeom.plotting.funnel_scenes import funnel_scene
from stochgeom.plotting.part_scenes import part_scene
from stochgeom.plotting.report_pictures import distribution_scene, tolerance_scene
from stochgeom.plotting.report_style import PAGE_STYLE
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
    facts,
    frame_of_reference,
    headline,
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

DRAWABLE: Final = (1e-200, 1e200)
"""Widths of parts between which floats hold their diameters."""

MOST_CERTIFIED: Final = 1000
"""Vertices of a part whose certificate a page carries; it may grow with their square."""

_POLICY: Final = "default-src 'none'; style-src 'unsafe-inline'"


def write_report(plan: FeedingPlan, path: str | os.PathLike[str], *, digits: int = 4) -> None:
    """Write a plan as an HTML page, whole or not at all.

    Parameters
    ----------
    plan : FeedingPlan
        Any plan; one for no part has no pictures of it.
    path : path
        The file to write; what stands there is replaced.
    digits : int, default 4
        Decimals after the point.

    Raises
    ------
    WriteError
        If the folder is missing or not writable; nothing is written then.
    InputError
        If `digits` is not acceptable.
    """
    write_whole(os.fsdecode(path), report_html(plan, digits=digits))


def report_html(plan: FeedingPlan, *, digits: int = 4) -> str:
    """Return a plan as an HTML page.  About 0.1 s for a part of ten vertices.

    Examples
    --------
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> page = report_html(plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> page[:15], "<script src" in page
    ('<!DOCTYPE html>', False)
    """
    subject = Subject(plan, check_digits(digits))
    title = f"Feeding plan for {text_of(subject.name)}"
    style = PAGE_STYLE
    if subject.traces:
        style += stage_style(subject.traces, subject.actions)
    return "\n".join(
        [
            '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">',
            f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            '<meta name="generator" content="stochgeom">',
            f"<title>{title}</title>\n<style>\n{style}\n</style>\n</head>\n<body>\n<main>",
            _hero(subject, title),
            *_sections(subject),
            "</main>\n</body>\n</html>\n",
        ]
    )


def _sections(subject: Subject) -> Iterator[str]:
    if subject.traces:
        yield _section("The plan at work", _player(subject))
    yield _section("Actions and their tolerances", _actions(subject))
    yield _section("Where the part may be", _distributions(subject))
    yield _section("Why this plan: the functions behind it", _functions(subject))
    yield _section("What plans of other lengths cost", _costs(subject))
    yield _section("Exact numbers", _exact(subject))
    yield _section("Certificate", _certificate(subject))


def _section(title: str, content: Iterable[str]) -> str:
    return f"<section>\n<h2>{title}</h2>\n" + "\n".join(content) + "\n</section>"


def _picture(scene: Scene, title: str, description: str) -> str:
    """Return a drawing that scrolls sideways where the page is narrower than it can be read."""
    svg = svg_document(scene, title=title, description=description, scale=1.0, background=False)
    return f'<div class="wide" tabindex="0" role="region" aria-label="{text_of(title)}">{svg}</div>'


def _hero(subject: Subject, title: str) -> str:
    part = subject.plan.part
    picture = ""
    if part is not None:
        words = f"{subject.name}: {len(part)} vertices, {len(part.hull)} on the convex hull"
        picture = svg_document(
            part_scene(part), title=subject.name, description=words, scale=90.0, background=False
        )
    rows = "".join(f"<div><dt>{what}</dt><dd>{value}</dd></div>" for value, what in facts(subject))
    return (
        f'<header><div class="hero">{definitions(subject.traces[0]) if subject.traces else ""}'
        f"{picture}<div><h1>{title}</h1>{headline(subject)}</div></div>"
        f'<dl class="facts">{rows}</dl></header>'
    )


# --- sections ------------------------------------------------------------------------------------


def _player(subject: Subject) -> Iterator[str]:
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


def _actions(subject: Subject) -> Iterator[str]:
    yield frame_of_reference(subject)
    yield action_table(subject)
    if subject.plan.margin is None:
        return
    shown = [k for k in shown_rows(subject.plan.steps) if k is not None][: 2 * MOST_PICTURED]
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


def _distributions(subject: Subject) -> Iterator[str]:
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
        distribution_scene([(k, subject.state(k)) for k in shown], goal),
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


def _functions(subject: Subject) -> Iterator[str]:
    plan = subject.plan
    action = text_of(subject.action)
    wave = _wave(plan)
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


def _wave(plan: FeedingPlan) -> DiameterFunction | RadiusFunction | None:
    """Return the function of the part that the action follows, if floats can draw it."""
    part = plan.part
    if part is None or plan.action_name not in ("squeeze", "push-grasp"):
        return None
    xs = [x for x, _ in part.hull.points.pairs()]
    try:
        drawable = DRAWABLE[0] < scalar_to_float(max(xs) - min(xs)) < DRAWABLE[1]
    except (OverflowError, NumberLimitError):
        drawable = False
    if not drawable:
        return None
    return DiameterFunction(part) if plan.action_name == "squeeze" else RadiusFunction(part)


def _an(noun: str) -> str:
    return f"an {noun}" if noun[:1] in "aeiou" else f"a {noun}"


def _costs(subject: Subject) -> Iterator[str]:
    yield (
        "<p>The expected cost counts all rounds until one part is accepted: the actions and a pass "
        "through the filter, divided by the probability. The row of this plan is marked.</p>"
    )
    yield cost_table(subject)


def _exact(subject: Subject) -> Iterator[str]:
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


def _certificate(subject: Subject) -> Iterator[str]:
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
        f"<p>This page carries no certificate: {text_of(reason)}. The plan itself, with exact "
        f"angles and ranges, is the JSON in the element with the id <code>{PLAN}</code>.</p>"
    )
    yield data_block(PLAN, plan_json(subject.plan, subject.digits))


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
