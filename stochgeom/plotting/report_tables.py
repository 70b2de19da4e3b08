"""The tables of a report: HTML with headers for rows and columns."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.decimals import significant
from stochgeom.exact.scalars import rational_text
from stochgeom.exact.surds import scalar_text
from stochgeom.feeding.actions import Action
from stochgeom.geometry.points import Point
from stochgeom.plotting.report_subject import Subject, shown_rows
from stochgeom.plotting.svg import text_of


def table(
    caption: str,
    header: Sequence[str],
    rows: Iterable[Sequence[str]],
    *,
    kind: str = "",
    chosen: int | None = None,
) -> str:
    """Return a table, the first cell of each row its header; cells are HTML.

    Parameters
    ----------
    caption : str
        What the table shows, HTML.
    header : sequence of str
        Of the columns.
    rows : iterable of sequences of str
        In order.
    kind : str
        A class for the style.
    chosen : int, optional
        The number of the row that stands out.
    """
    lines = [f'<div class="wide" tabindex="0" role="region" aria-label="{caption}">']
    lines.append(f'<table class="{kind}"><caption><span>{caption}</span></caption><thead><tr>')
    lines.extend(f'<th scope="col">{cell}</th>' for cell in header)
    lines.append("</tr></thead><tbody>")
    for place, (first, *others) in enumerate(rows):
        mark = ' class="chosen"' if place == chosen else ""
        cells = "".join(f"<td>{cell}</td>" for cell in others)
        lines.append(f'<tr{mark}><th scope="row">{first}</th>{cells}</tr>')
    lines.append("</tbody></table></div>")
    return "\n".join(lines)


def action_table(subject: Subject) -> str:
    """Return the actions with their ranges, and how much is known after each."""
    rows = []
    for k in shown_rows(subject.plan.steps):
        if k is None:
            rows.append(["…", "", "", "", "", ""])
            continue
        action, outcome = subject.plan.actions[k], subject.outcomes[k]
        angle, range_text = angle_and_range(subject, k)
        width = action.tolerance
        rows.append(
            [
                str(k + 1),
                angle,
                range_text,
                "" if width is None else f"{significant(width.degrees, subject.digits)}°",
                str(subject.left(k + 1)),
                outcome.most_likely().decimal(subject.digits),
            ]
        )
    header = [
        "action",
        "turn the gripper by",
        "works for",
        "width of the range",
        "orientations left",
        "probability of the likeliest",
    ]
    return table("Actions in order of execution", header, rows)


def angle_and_range(subject: Subject, k: int) -> tuple[str, str]:
    """Return the angle of action k and its range, rounded inwards, as text."""
    action = subject.plan.actions[k]
    if action.low is None or action.high is None:
        if subject.plan.prior is None:
            return "random", "any angle"
        return f"{subject.plan.mouth_decimals(subject.digits)[0]}°", f"aims at {caught(subject)}"
    angle, low, high = action.decimals(subject.digits)
    return f"{angle}°", f"({low}°, {high}°]"


def caught(subject: Subject) -> str:
    """Return the orientations that the mouth catches if the first angle is as printed."""
    if subject.plan.mouth.width == FULL_TURN:
        return "every orientation"
    _, low, high = subject.plan.mouth_decimals(subject.digits)
    return f"{low}° to {high}°"


def cost_table(subject: Subject) -> str:
    """Return probability and expected cost of the best plan of each length."""
    rows, chosen = [], None
    for k in shown_rows(len(subject.chain), subject.plan.steps - 1):
        if k is None:
            rows.append(["…", "", "", ""])
            continue
        preimage = subject.chain[k]
        if preimage.steps == subject.plan.steps:
            chosen = len(rows)
        worth = subject.worth(preimage)
        decimals = ["0", "none"] if worth is None else [n.decimal(subject.digits) for n in worth]
        rows.append([str(preimage.steps), f"{preimage.width.degrees(subject.digits)}°", *decimals])
    header = ["actions", "arc collapsed", "probability", "expected cost"]
    caption = f"Best plan of each length; a pass through the filter costs {subject.price}"
    return table(caption, header, rows, chosen=chosen)


def distribution_table(subject: Subject, step: int) -> str:
    """Return every orientation after so many actions, with its probability."""
    state = subject.state(step)
    rows = [
        ["…", "", ""]
        if k is None
        else [
            f"{state.orientations[k].degrees(subject.digits)}°",
            f"{state.widths[k].degrees(subject.digits)}°",
            state.probability(k).decimal(subject.digits),
        ]
        for k in shown_rows(len(state))
    ]
    header = ["orientation", "initial orientations that end there", "probability"]
    return table(f"After action {step}", header, rows)


# --- exact numbers -------------------------------------------------------------------------------


def exact_text(angle: Angle) -> str:
    """Return an angle exactly: degrees if they are rational, else turns and a direction.

    Examples
    --------
    >>> exact_text(Angle.from_degrees("22.5")), exact_text(Angle(-1, (3, -2)))
    ('45/2°', 'arg(3, -2) - 1 turn')
    """
    turns = angle.rational_turns
    if turns is not None:
        return f"{rational_text(turns * 360)}°"
    x, y = (scalar_text(value) for value in angle.direction)
    t = angle.turn_part
    if not t:
        return f"arg({x}, {y})"
    unit = "turn" if abs(t) == 1 else "turns"
    return f"arg({x}, {y}) {'-' if t < 0 else '+'} {rational_text(abs(t))} {unit}"


def exact_actions(subject: Subject) -> str:
    """Return nominal angles and ends of ranges exactly."""

    def row(number: int, action: Action) -> list[str]:
        ends = (action.angle, action.low, action.high)
        return [str(number), *("" if end is None else text_of(exact_text(end)) for end in ends)]

    rows = [
        ["…", "", "", ""] if k is None else row(k + 1, subject.plan.actions[k])
        for k in shown_rows(subject.plan.steps)
    ]
    header = ["action", "angle", "works above", "works up to"]
    return table("Actions, exactly", header, rows, kind="exact")


def exact_function(subject: Subject) -> str:
    """Return breaks and values of the transfer function exactly."""
    transfer = subject.plan.transfer
    rows = [
        ["…", "", "", ""]
        if k is None
        else [
            f"{transfer.breaks[k].degrees(subject.digits)}°",
            text_of(exact_text(transfer.breaks[k])),
            f"{transfer.values[k].degrees(subject.digits)}°",
            text_of(exact_text(transfer.values[k])),
        ]
        for k in shown_rows(len(transfer))
    ]
    header = ["from", "exactly", "goes to", "exactly"]
    period = exact_text(transfer.period)
    return table(f"One period, {period}, of the {subject.action} function", header, rows,
                 kind="exact")  # fmt: skip


def exact_preimages(subject: Subject) -> str:
    """Return the preimages exactly."""
    rows = [
        ["…", "", "", ""]
        if k is None
        else [
            str(preimage.steps),
            *(
                text_of(exact_text(angle))
                for angle in (preimage.arc.start, preimage.width, preimage.image_width)
            ),
        ]
        for k in shown_rows(len(subject.chain))
        for preimage in [subject.chain[k or 0]]
    ]
    header = ["actions", "start", "width", "width of its image"]
    return table("Widest arcs that so many actions collapse", header, rows, kind="exact")


def vertex_table(subject: Subject) -> str:
    """Return the vertices and the centre of mass exactly."""
    part = subject.plan.part
    assert part is not None

    def row(name: str, point: Point) -> list[str]:
        return [name, *(text_of(scalar_text(value)) for value in point)]

    rows = [
        ["…", "", ""] if k is None else row(str(k), part.vertices[k]) for k in shown_rows(len(part))
    ]
    rows.append(row("centre of mass", part.center_of_mass))
    return table("Vertices, counted from 0", ["vertex", "x", "y"], rows, kind="exact")
