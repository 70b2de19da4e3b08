"""A plan as an animation of HTML, SVG and CSS, with a control to step through it; no script.

One number, the CSS variable ``--t``, is the time in actions. Everything that moves is a sum of
ramps in it, such as ``rotate(calc(20deg + 51deg*clamp(0,(var(--t) - .54)*2.63,1)))``, so at a whole
time a part stands exactly at the angle printed. Radio buttons set ``--t``; where the browser knows
``@property`` it glides there, else it jumps, and the button "play" lets it run.

Radio buttons come first, then the stage, as siblings: that is how CSS reaches one from the other.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Decimal
from typing import TYPE_CHECKING, Final

from stochgeom.plotting.animation_motion import OPEN, Hold, KeyFrame, Trace
from stochgeom.plotting.silhouettes import FloatArray
from stochgeom.plotting.svg import number, text_of
from stochgeom.plotting.trace_scenes import typical_orientations

if TYPE_CHECKING:
    from stochgeom.feeding.plans import FeedingPlan

MOST_ACTIONS: Final = 40
"""Of a longer plan the first so many actions are shown."""

MOST_PARTS: Final = 6
"""On the stage."""

RADIUS: Final = 100
"""Of a part, in units of the picture."""

_JAW, _HALF, _EDGE = 12, 84, 152

SECONDS_PER_ACTION: Final = 2.6
_GLIDE: Final = 2.4


def traces(plan: FeedingPlan) -> tuple[Trace, ...]:
    """Return the parts on the stage: one for each step of the first action, or for some of them.

    Under a prior such as arrive.
    """
    assert plan.part is not None
    hold = Hold(plan.part)
    return tuple(Trace(plan, hold, start) for start in typical_orientations(plan, MOST_PARTS))


def shown_actions(plan: FeedingPlan) -> int:
    """Return how many of the actions are shown."""
    return min(plan.steps, MOST_ACTIONS)


# --- style ---------------------------------------------------------------------------------------


def stage_style(shown: Sequence[Trace], actions: int) -> str:
    """Return the rules that move everything, for a stage made by `stage`."""
    rules = ['@property --t{syntax:"<number>";inherits:true;initial-value:0}']
    rules.append(f".stage{{--t:0;transition:--t {_GLIDE}s linear}}")
    for k in range(actions + 1):
        rules.append(f"#t{k}:checked~.stage{{--t:{k}}}")
        rules.append(f"#t{k}:checked~.said .s{k}{{display:block}}")
        rules.append(f"#t{k}:checked~.steps label[for=t{k}]{{{_CHOSEN}}}")
        rules.append(f"#t{k}:focus-visible~.steps label[for=t{k}]{{{_FOCUSED}}}")
    rules.append(f"#play:checked~.steps label[for=play]{{{_CHOSEN}}}")
    rules.append(f"#play:focus-visible~.steps label[for=play]{{{_FOCUSED}}}")
    rules.append("#play:checked~.said .play{display:block}")
    # A pause at the end, then again from the start.
    length = actions + 1.0
    share = number(100 * actions / length)
    rules.append(f"@keyframes run{{0%{{--t:0}}{share}%,100%{{--t:{actions}}}}}")
    seconds = number(SECONDS_PER_ACTION * length)
    rules.append(f"#play:checked~.stage{{animation:run {seconds}s linear infinite}}")
    rules.append(
        "@media (prefers-reduced-motion:reduce){.stage{transition:none}"
        f"#play:checked~.stage{{animation:none;--t:{actions}}}}}"
    )
    for place, trace in enumerate(shown):
        frames = trace.frames(actions)
        if place == 0:
            rules.append(f".grip{{transform:rotate({ramps(frames, _gripper, 'deg')})}}")
        part = ramps(frames, _part, "deg")
        lower, upper = ramps(frames, _lower, "px"), ramps(frames, _upper, "px")
        rules.append(f".p{place}{{transform:rotate({part})}}")
        rules.append(f".l{place}{{transform:translateY({lower})}}")
        rules.append(f".u{place}{{transform:translateY({upper})}}")
    return "\n".join(rules)


_CHOSEN: Final = "background:var(--ink);color:var(--paper);border-color:var(--ink)"
_FOCUSED: Final = "outline:3px solid var(--accent);outline-offset:2px"


def _gripper(frame: KeyFrame) -> str | None:
    return frame.gripper


def _part(frame: KeyFrame) -> str | None:
    return frame.part


def _lower(frame: KeyFrame) -> str:
    return number(-RADIUS * frame.lower)


def _upper(frame: KeyFrame) -> str:
    return number(RADIUS * frame.upper)


def ramps(frames: Sequence[KeyFrame], value: Callable[[KeyFrame], str | None], unit: str) -> str:
    """Return a CSS length or angle as a function of ``--t``: a start and a ramp for each change.

    Parameters
    ----------
    frames : sequence of KeyFrame
        In order.
    value : callable
        Returns a decimal of a frame, or None where it lies on the line between its neighbours.
    unit : str
        ``"deg"`` or ``"px"``.

    Examples
    --------
    >>> frames = [KeyFrame(t, g, None, 0, 0) for t, g in ((0, "5"), (1, "5"), (1.5, "3.25"))]
    >>> ramps(frames, lambda frame: frame.gripper, "deg")
    'calc(5deg - 1.75deg*clamp(0,(var(--t) - 1)*2,1))'
    """
    stops = [(frame.time, Decimal(text)) for frame in frames if (text := value(frame)) is not None]
    (time, here), *others = stops
    terms = [f"{_plain(here)}{unit}"]
    for then, there in others:
        if there != here:
            sign, size = ("+", there - here) if there > here else ("-", here - there)
            speed = _plain(Decimal(f"{1 / (then - time):.4f}"))
            begin = _plain(Decimal(f"{time:.4f}"))
            terms.append(f"{sign} {_plain(size)}{unit}*clamp(0,(var(--t) - {begin})*{speed},1)")
        time, here = then, there
    return f"calc({' '.join(terms)})"


def _plain(value: Decimal) -> str:
    """Return a decimal without superfluous zeros and never with an exponent."""
    text = f"{value:f}"
    return (text.rstrip("0").rstrip(".") if "." in text else text) or "0"


# --- content -------------------------------------------------------------------------------------


def definitions(trace: Trace) -> str:
    """Return the shapes that the pictures of a page share, once."""
    shape = trace.hold.shape
    holes = "".join(_path(hole) for hole in shape.holes)
    (x, y), (u, v) = (
        (number(RADIUS * a), number(RADIUS * b)) for a, b in (shape.mass, shape.outline[0])
    )
    return (
        '<svg class="defs" width="0" height="0" aria-hidden="true"><defs>'
        f'<g id="part"><path class="part" d="{_path(shape.outline)}{holes}"/>'
        f'<path class="pointer" d="M{x},{y}L{u},{v}"/>'
        f'<circle class="mass" cx="{x}" cy="{y}" r="4.5"/>'
        f'<circle class="first" cx="{u}" cy="{v}" r="6"/></g>'
        f'<path id="lower" d="M{-_HALF},0h{2 * _HALF}v{-_JAW}H9l-4,-9h-10l-4,9H{-_HALF}z"/>'
        f'<path id="upper" d="M{-_HALF},0h{2 * _HALF}v{_JAW}h{-2 * _HALF}z"/>'
        "</defs></svg>"
    )


def _path(points: FloatArray) -> str:
    corners = ",".join(f"{number(RADIUS * x)},{number(RADIUS * y)}" for x, y in points)
    return f"M{corners}z"


def control(actions: int) -> tuple[str, str]:
    """Return the radio buttons, and the labels that are seen in their place."""
    names = ["start", *map(str, range(1, actions + 1))]
    spoken = ["before the first action", *(f"after action {k}" for k in range(1, actions + 1))]
    buttons = ['<input type="radio" name="t" id="play" checked aria-label="play all actions">']
    labels = ['<label for="play">play</label>']
    for k, (name, words) in enumerate(zip(names, spoken, strict=True)):
        buttons.append(f'<input type="radio" name="t" id="t{k}" aria-label="{words}">')
        labels.append(f'<label for="t{k}">{name}</label>')
    return "\n".join(buttons), f'<div class="steps" aria-hidden="true">{"".join(labels)}</div>'


def panel(place: int, trace: Trace, caption: str, description: str) -> str:
    """Return one part on the stage, moved by the rules of `stage_style`."""
    start = trace.start.degrees(2)
    return (
        f'<figure class="panel"><svg viewBox="{-_EDGE} {-_EDGE} {2 * _EDGE} {2 * _EDGE}" '
        f'role="img" aria-labelledby="n{place} d{place}">'
        f'<title id="n{place}">a part that begins at {start} degrees</title>'
        f'<desc id="d{place}">{text_of(description)}</desc><g transform="scale(1,-1)">'
        f'<g class="grip"><use href="#lower" class="jaw {_pushing(trace)}l{place}"/>'
        f'<use href="#upper" class="jaw u{place}"/></g>'
        f'<use href="#part" class="p{place}"/></g></svg>'
        f"<figcaption>{caption}</figcaption></figure>"
    )


def still(trace: Trace, step: int) -> str:
    """Return a part and the jaws that hold it after so many actions, 0 for open jaws."""
    lower = upper = OPEN
    if step:
        lower, upper = trace.hold.touching(trace.states[step].to_float())
    gripper, pose = (angles[step].degrees(1) for angles in (trace.grippers, trace.poses))
    return (
        f'<svg class="still" viewBox="{-_EDGE} {-_EDGE} {2 * _EDGE} {2 * _EDGE}" '
        f'aria-hidden="true"><g transform="scale(1,-1)"><g transform="rotate({gripper})">'
        f'<use href="#lower" class="jaw {_pushing(trace)}" y="{number(-RADIUS * lower)}"/>'
        f'<use href="#upper" class="jaw" y="{number(RADIUS * upper)}"/></g>'
        f'<use href="#part" transform="rotate({pose})"/></g></svg>'
    )


def _pushing(trace: Trace) -> str:
    return "pushing " if trace.plan.action_name == "push-grasp" else ""
