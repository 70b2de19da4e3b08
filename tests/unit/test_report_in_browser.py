"""Reports as a browser shows them: nothing is asked for, everything ends up at the planned angles.

A headless Chromium is looked for; where there is none, what needs it is skipped.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import pytest

import stochgeom as sg
from benchmarks.outlines import near_circle
from stochgeom.plotting.animation_stage import MOST_ACTIONS, MOST_PARTS
from stochgeom.plotting.report import report_html
from stochgeom.plotting.trace_scenes import typical_orientations
from tests.browser import Browser, find_browser

EXECUTABLE = find_browser()
pytestmark = pytest.mark.skipif(EXECUTABLE is None, reason="no Chromium found on the path")

CLOSE = 1e-3
"""Degrees and units of the picture: the browser tells transforms with six digits."""

HOSTILE = "</title></script><img src=https://example.org/x onerror=alert(1)>&amp;"


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with Browser(EXECUTABLE) as found:
        yield found


@pytest.fixture
def page(browser, tmp_path):
    """Open the report of a plan, at a width, with media features."""

    def open_report(plan: sg.FeedingPlan, width: int = 1000, **media: str) -> Browser:
        path = tmp_path / "report.html"
        path.write_text(report_html(plan), encoding="utf-8")
        browser.screen(width, **media)
        browser.open(path)
        return browser

    return open_report


def many_steps() -> sg.FeedingPlan:
    part = sg.Part(near_circle(120, seed=1, radius=10**6))
    return sg.FeedingProblem(part).geometric_plan()


def test_long_figures_stay_in_their_boxes(page):
    plan = sg.plan_feeding(sg.FAMILIES["long plans"](25, seed=1))
    for width in (360, 900, 1400):
        shown = page(plan, width)
        fits = (
            "[...document.querySelectorAll('.facts dd')].map(e => e.scrollWidth <= e.clientWidth)"
        )
        heights = (
            "Math.max(...[...document.querySelectorAll('.facts dd')].map(e => e.clientHeight))"
        )
        assert all(shown.evaluate(fits))
        assert shown.evaluate(heights) < 50  # one line


PLANS = {
    "house": lambda: sg.orient_up_to_symmetry(sg.load_part("house")),
    "4gon": lambda: sg.plan_feeding(sg.load_part("4gon")),
    "push-grasp": lambda: sg.plan_feeding(sg.load_part("4gon"), action="push-grasp"),
    "prior": lambda: sg.FeedingProblem(
        sg.load_part("house"),
        prior=sg.WrappedNormal(mean="10", sd="30"),
        gripper_error="2",
        goal="most stable",
    ).geometric_plan(),
    "hostile name": lambda: sg.plan_feeding(sg.Part([(0, 0), (3, 0), (1, 2)], name=HOSTILE)),
    "pentagon": lambda: sg.plan_feeding(sg.Part.regular(5)),
    "outside": lambda: sg.plan_feeding(sg.Part([(0, 0), (9, 0), (2, 5)], ("100", "7"))),
    "no part": lambda: sg.plan_transfer(sg.squeeze_function(sg.load_part("house"))),
    "many steps": many_steps,
}
with_a_stage = pytest.mark.parametrize("name", [name for name in PLANS if name != "no part"])


@pytest.mark.parametrize("name", PLANS)
def test_a_page_loads_without_a_request_or_a_complaint(page, name):
    found = page(PLANS[name]())
    found.evaluate("new Promise(done => setTimeout(done, 50))")
    assert found.requests() == [found.evaluate("location.href")]
    assert found.complaints() == []
    assert found.evaluate("document.querySelectorAll('img,iframe,object,link').length") == 0
    assert found.evaluate("document.querySelector('h1').textContent").startswith("Feeding plan for")


def test_a_browser_that_sees_a_request_says_so(browser, tmp_path):
    path = tmp_path / "bad.html"
    path.write_text("<img src='other.png'><script>throw new Error('x')</script>", encoding="utf-8")
    browser.open(path)
    assert browser.requests()[1:] == [(tmp_path / "other.png").as_uri()]
    assert browser.complaints()


# --- the animation -------------------------------------------------------------------------------


def choose(browser: Browser, button: str) -> None:
    """Choose a button and let everything finish that moves."""
    browser.evaluate(f"document.getElementById('{button}').click()")
    browser.evaluate("document.getAnimations().forEach(a => a.finish())")


def turn_of(browser: Browser, selector: str) -> float:
    """Return the turn of an element in degrees, counter-clockwise as the page shows it."""
    rows = f"getComputedStyle(document.querySelector('{selector}')).transform"
    a, b = (browser.evaluate(f"new DOMMatrix({rows}).{entry}") for entry in "ab")
    return math.degrees(math.atan2(b, a))


def shift_of(browser: Browser, selector: str) -> float:
    rows = f"getComputedStyle(document.querySelector('{selector}')).transform"
    return browser.evaluate(f"new DOMMatrix({rows}).f")


def off(measured: float, angle: sg.Angle) -> float:
    """Return by how many degrees a measured turn differs from an angle, around the circle."""
    rest = (measured - math.degrees(angle.to_float())) % 360
    return min(rest, 360 - rest)


def starts_of(plan: sg.FeedingPlan) -> tuple[sg.Angle, ...]:
    return typical_orientations(plan, MOST_PARTS)


def states_by_hand(plan: sg.FeedingPlan, start: sg.Angle) -> Iterator[tuple[sg.Angle, sg.Angle]]:
    """Yield the gripper's and the part's pose on the table after each action."""
    state, gripper = start, sg.ZERO
    yield gripper, state
    for action in plan.actions:
        state = plan.transfer(state - action.angle)
        gripper += action.angle
        yield gripper, state + gripper


@with_a_stage
def test_every_part_stands_at_the_planned_angle_after_each_action(page, name):
    plan = PLANS[name]()
    found = page(plan)
    expected = {start: list(states_by_hand(plan, start)) for start in starts_of(plan)}
    steps = [*range(min(plan.steps, MOST_ACTIONS) + 1)]
    for step in steps if len(steps) < 10 else (0, 1, 2, 20, steps[-1]):
        choose(found, f"t{step}")
        for place, start in enumerate(starts_of(plan)):
            gripper, pose = expected[start][step]
            assert off(turn_of(found, f".p{place}"), pose) < CLOSE
            assert off(turn_of(found, ".grip"), gripper) < CLOSE


@pytest.mark.parametrize("name", ["house", "4gon", "push-grasp"])
def test_the_jaws_hold_the_part_at_its_diameter(page, name):
    plan = PLANS[name]()
    found = page(plan)
    xs, ys = zip(*plan.part.hull.points.pairs(), strict=True)
    middle = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
    radius = max(math.hypot(x - middle[0], y - middle[1]) for x, y in zip(xs, ys, strict=True))
    diameter = sg.DiameterFunction(plan.part)
    for step in range(1, plan.steps + 1):
        choose(found, f"t{step}")
        for place, start in enumerate(starts_of(plan)):
            state = plan.execute(start)[step]
            gap = shift_of(found, f".u{place}") - shift_of(found, f".l{place}")
            held = 100 * float(diameter.evaluate(state.to_float())) / radius
            assert gap == pytest.approx(held, abs=0.02)


def test_a_part_glides_to_its_next_place(page):
    plan = PLANS["house"]()
    found = page(plan)
    choose(found, "t1")
    found.evaluate("document.getElementById('t2').click()")
    # Half way: the gripper has turned by 45 degrees, the part not yet.
    found.evaluate("document.getAnimations().forEach(a => {a.pause(); a.currentTime = 1200})")
    assert off(turn_of(found, ".grip"), sg.Angle.from_degrees(45)) < CLOSE
    before, after = list(states_by_hand(plan, starts_of(plan)[0]))[1:]
    assert off(turn_of(found, ".p0"), before[1]) < CLOSE
    found.evaluate("document.getAnimations().forEach(a => a.finish())")
    assert off(turn_of(found, ".p0"), after[1]) < CLOSE
    assert off(turn_of(found, ".p0"), before[1]) > 1


@with_a_stage
def test_left_to_itself_the_animation_runs_through_all_actions_and_begins_again(page, name):
    plan = PLANS[name]()
    found = page(plan)
    assert found.evaluate("document.getElementById('play').checked")
    actions = min(plan.steps, MOST_ACTIONS)
    length = found.evaluate("document.getAnimations()[0].effect.getTiming().duration")
    assert found.evaluate("document.getAnimations()[0].playState") == "running"
    for step in (0, 1, actions):
        time = length * step / (actions + 1)
        found.evaluate(
            f"document.getAnimations().forEach(a => {{a.pause(); a.currentTime = {time + 30}}})"
        )
        pose = list(states_by_hand(plan, starts_of(plan)[0]))[step][1]
        assert off(turn_of(found, ".p0"), pose) < CLOSE


def test_the_arrow_keys_step_through_the_actions(page):
    found = page(PLANS["house"]())
    found.evaluate("document.getElementById('play').focus()")
    seen = []
    for _ in range(3):
        for kind in ("rawKeyDown", "keyUp"):
            found.call(
                "Input.dispatchKeyEvent",
                type=kind,
                key="ArrowRight",
                code="ArrowRight",
                windowsVirtualKeyCode=39,
            )
        seen.append(found.evaluate("document.querySelector('input:checked').id"))
    assert seen == ["t0", "t1", "t2"]


def test_what_is_said_goes_with_the_moment(page):
    found = page(PLANS["4gon"]())
    paragraphs = "[...document.querySelectorAll('.said p')]"
    shown = f"{paragraphs}.filter(p => p.offsetParent).map(p => p.className)"
    assert found.evaluate(shown) == ["play"]
    choose(found, "t3")
    assert found.evaluate(shown) == ["s3"]


# --- readers and their machines ------------------------------------------------------------------


@pytest.mark.parametrize("name", PLANS)
@pytest.mark.parametrize("width", [320, 1400])
def test_the_page_does_not_scroll_sideways(page, name, width):
    found = page(PLANS[name](), width)
    assert found.evaluate("document.documentElement.scrollWidth") <= width


def test_captions_are_read_on_a_phone_and_what_scrolls_says_so(page):
    found = page(PLANS["many steps"](), 390)
    ends = found.evaluate(
        "[...document.querySelectorAll('section > .wide caption span')].filter("
        "s => s.checkVisibility()).map(s => s.getBoundingClientRect().right)"
    )
    assert len(ends) > 2
    assert max(ends) <= 390
    # Covers that scroll with the content, over shadows at the edges that do not.
    style = "getComputedStyle(document.querySelector('.wide')).backgroundAttachment"
    assert found.evaluate(style) == "local, local, scroll, scroll"


def test_nothing_moves_for_who_asked_for_that(page):
    plan = PLANS["4gon"]()
    found = page(plan, prefers_reduced_motion="reduce")
    assert found.evaluate("document.getAnimations().length") == 0
    assert off(turn_of(found, ".p0"), list(states_by_hand(plan, starts_of(plan)[0]))[-1][1]) < CLOSE
    found.evaluate("document.getElementById('t1').click()")
    assert found.evaluate("document.getAnimations().length") == 0
    assert off(turn_of(found, ".p0"), list(states_by_hand(plan, starts_of(plan)[0]))[1][1]) < CLOSE


def test_on_paper_the_still_pictures_remain(page):
    found = page(PLANS["4gon"](), media="print")
    assert not found.evaluate("document.querySelector('.stage').checkVisibility()")
    assert found.evaluate(
        "[...document.querySelectorAll('.still')].every(picture => picture.checkVisibility())"
    )


def contrast(browser: Browser, selector: str) -> float:
    """Return the contrast of an element's text with the page, as WCAG 2 defines it."""

    def light(expression: str) -> float:
        numbers = browser.evaluate(f"{expression}.match(/[0-9.]+/g).slice(0, 3)")
        shares = [float(number) / 255 for number in numbers]
        linear = [s / 12.92 if s <= 0.03928 else ((s + 0.055) / 1.055) ** 2.4 for s in shares]
        return sum(weight * s for weight, s in zip((0.2126, 0.7152, 0.0722), linear, strict=True))

    style = f"getComputedStyle(document.querySelector('{selector}'))"
    pair = (light(f"{style}.color"), light("getComputedStyle(document.body).backgroundColor"))
    return (max(pair) + 0.05) / (min(pair) + 0.05)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_text_stands_out_from_the_page(page, scheme):
    found = page(PLANS["4gon"](), prefers_color_scheme=scheme)
    for selector in ("h1", "p", "caption", "figcaption", "dt", "b.yes"):
        assert contrast(found, selector) > 4.5
    dark = found.evaluate("getComputedStyle(document.body).backgroundColor") != "rgb(255, 255, 255)"
    assert dark == (scheme == "dark")


@pytest.mark.parametrize("name", ["house", "4gon", "push-grasp", "prior"])
def test_no_text_of_a_picture_covers_another(page, name):
    found = page(PLANS[name](), 1400)
    overlaps = found.evaluate(
        """[...document.querySelectorAll('.wide > svg')].flatMap(svg => {
          const boxes = [...svg.querySelectorAll('text')].filter(t => t.textContent)
            .map(t => [t.textContent, t.getBBox()]);
          return boxes.flatMap(([a, p], k) => boxes.slice(k + 1)
            .filter(([b, q]) => p.x + p.width > q.x + 0.5 && q.x + q.width > p.x + 0.5
              && p.y + 0.75 * p.height > q.y + 0.25 * q.height
              && q.y + 0.75 * q.height > p.y + 0.25 * p.height)
            .map(([b, q]) => [a, b]));
        })"""
    )
    assert overlaps == []


def test_the_certificate_can_be_read_from_the_page(page):
    plan = PLANS["4gon"]()
    found = page(plan)
    text = "document.getElementById('stochgeom-certificate').textContent"
    assert found.evaluate(f"JSON.parse({text})") == plan.certificate()


def test_the_browser_is_looked_for_by_name(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    assert find_browser() is None
    (tmp_path / "chromium").write_text("", encoding="utf-8")
    Path(tmp_path / "chromium").chmod(0o755)
    assert find_browser() == str(tmp_path / "chromium")
