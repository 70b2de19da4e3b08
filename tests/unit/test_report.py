"""The report page as text: what it holds, and that it is well formed and self-contained."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from html.parser import HTMLParser

import pytest

import stochgeom as sg
from benchmarks.outlines import near_circle, small_convex
from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.errors import InputError, WriteError
from stochgeom.feeding import field_certificate_checker
from stochgeom.io.embedded import CERTIFICATE, PLAN, find_block
from stochgeom.io.plan_json import plan_json
from stochgeom.plotting.report import report_html
from stochgeom.plotting.report_pictures import distributions_scene, tolerance_scene
from stochgeom.plotting.report_sections import MOST_CERTIFIED
from stochgeom.plotting.report_subject import MOST_MORE, MOST_ROWS, Subject, shown_rows
from stochgeom.plotting.scene import Disc, Label, Polygon, box_of
from tests.repo.sources import ROOT

HALF_OPEN = sg.StepFunction(
    [sg.Angle.from_degrees(d) for d in (0, 100)], [sg.ZERO, sg.QUARTER_TURN]
)
PLANS = {
    "house": lambda: sg.orient_up_to_symmetry(sg.load_part("house")),
    "4gon": lambda: sg.plan_feeding(sg.load_part("4gon"), cost_ratio="1/2"),
    "push-grasp": lambda: sg.plan_feeding(sg.load_part("key"), action="push-grasp"),
    "prior": lambda: sg.plan_feeding(
        sg.load_part("house"), prior=sg.WrappedNormal(mean="10", sd="30")
    ),
    "measured": lambda: sg.plan_feeding(
        sg.load_part("4gon"), prior=sg.DiscretePrior.from_counts({"10": 1, "80": 3})
    ),
    "error": lambda: sg.plan_feeding(sg.load_part("4gon"), gripper_error="3"),
    "goal": lambda: sg.FeedingProblem(sg.load_part("4gon"), goal="most stable").geometric_plan(),
    "field": lambda: sg.plan_feeding(sg.Part.regular(7)),
    "holes": lambda: sg.plan_feeding(
        sg.Part([(0, 0), (9, 0), (9, 7), (0, 7)], holes=[[(1, 1), (2, 1), (1, 2)]])
    ),
    "huge": lambda: sg.plan_feeding([(0, 0), (10**400, 0), (10**400, 7), (5, 10**399)]),
    "high": lambda: sg.plan_feeding([(0, 0), (1, 0), (1, 10**400), (0, 10**399)]),
    "tiny": lambda: sg.plan_feeding([("0", "0"), ("1e-400", "0"), ("0", "2e-400")]),
    "no part": lambda: sg.plan_transfer(HALF_OPEN),
}
each_plan = pytest.mark.parametrize("name", PLANS)
EMPTY = frozenset({"meta", "input", "br", "link", "img", "hr"})
DRAWN = frozenset({"path", "use", "circle", "rect", "polygon", "polyline", "line"})


class Reader(HTMLParser):
    """Keeps the elements of a page, and complains about tags that do not match."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.elements: list[tuple[str, dict[str, str | None], tuple[str, ...]]] = []
        self.texts: list[tuple[str, str]] = []
        self.feed(page)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs), tuple(self.open)))
        assert len(dict(attrs)) == len(attrs)
        if tag not in EMPTY:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        assert tag in DRAWN
        self.elements.append((tag, dict(attrs), tuple(self.open)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.texts.append((self.open[-1] if self.open else "", data))

    def all(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for kind, attributes, _ in self.elements if kind == tag]


# --- form ----------------------------------------------------------------------------------------


@each_plan
def test_tags_match_and_ids_are_there_once(name):
    reader = Reader(report_html(PLANS[name]()))
    ids = [attributes["id"] for _, attributes, _ in reader.elements if "id" in attributes]
    assert len(ids) == len(set(ids))
    named = {
        word
        for _, attributes, _ in reader.elements
        for key in ("aria-labelledby", "for")
        for word in (attributes.get(key) or "").split()
    } | {href[1:] for use in reader.all("use") if (href := use["href"])}
    assert named <= set(ids)


@each_plan
def test_nothing_outside_is_named_and_nothing_runs(name):
    page = report_html(PLANS[name]())
    reader = Reader(page)
    for tag, attributes, _ in reader.elements:
        assert not {"src", "srcset", "action", "data", "poster", "style"} & set(attributes), tag
        assert not [key for key in attributes if key.startswith("on")]
        assert (attributes.get("href") or "#").startswith("#")
        assert tag not in {"link", "iframe", "object", "embed", "img", "image", "foreignobject"}
    assert {script["type"] for script in reader.all("script")} == {"application/json"}
    assert "url(" not in page
    assert "@import" not in page
    # The name of SVG's namespace is an address that nobody asks for.
    assert set(re.findall(r"\w+://[^\"' ]*", page)) <= {"http://www.w3.org/2000/svg"}
    (policy,) = [m for m in reader.all("meta") if "http-equiv" in m]
    assert policy["content"].startswith("default-src 'none'")


@each_plan
def test_readers_who_do_not_see_are_told_what_is_drawn(name):
    reader = Reader(report_html(PLANS[name]()))
    pictures = [svg for svg in reader.all("svg") if svg.get("aria-hidden") != "true"]
    titles = [places for tag, _, places in reader.elements if tag == "title" and "svg" in places]
    described = [places for tag, _, places in reader.elements if tag == "desc"]
    assert {svg["role"] for svg in pictures} == {"img"}
    assert len(titles) == len(described) == len(pictures)
    assert {cell.get("scope") for cell in reader.all("th")} == {"col", "row"}
    assert len(reader.all("caption")) == len(reader.all("table")) > 3
    assert reader.all("html") == [{"lang": "en"}]
    assert len(reader.all("h1")) == len(reader.all("main")) == 1


@each_plan
def test_the_same_plan_gives_the_same_bytes(name):
    assert report_html(PLANS[name]()) == report_html(PLANS[name]())


def test_another_process_gives_the_same_bytes():
    code = (
        "import sys, stochgeom as sg; from stochgeom.plotting.report import report_html;"
        "sys.stdout.buffer.write(report_html(sg.plan_feeding(sg.load_part('4gon'))).encode())"
    )
    pages = {
        subprocess.run(
            [sys.executable, "-c", code],
            check=True,
            capture_output=True,
            cwd=ROOT,
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)},
        ).stdout
        for seed in ("1", "2")
    }
    assert pages == {report_html(sg.plan_feeding(sg.load_part("4gon"))).encode()}


def test_hostile_names_stay_text():
    name = "</title></script><script>alert(1)</script> \x00 \x0b & \"'"
    reader = Reader(report_html(sg.plan_feeding(sg.Part([(0, 0), (3, 0), (1, 2)], name=name))))
    assert {script["type"] for script in reader.all("script")} == {"application/json"}
    heading = "".join(text for tag, text in reader.texts if tag == "h1")
    assert heading == "Feeding plan for </title></script><script>alert(1)</script> � � & \"'"


# --- content -------------------------------------------------------------------------------------


def cells(page: str, caption: str) -> list[list[str]]:
    """Return the rows of the table of that caption, its header first, as text."""
    part = page.partition(f"<caption><span>{caption}")[2].partition("</table>")[0]
    rows = re.findall(r"<tr.*?</tr>", part, re.DOTALL)
    pairs = [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row, re.DOTALL) for row in rows]
    return [[re.sub("<[^>]*>", "", cell) for cell in row] for row in pairs]


def test_the_table_of_actions_says_what_the_command_says():
    rows = cells(report_html(sg.plan_feeding(sg.load_part("4gon"))), "Actions in order")
    assert rows[1:] == [
        ["1", "random", "any angle", "", "8", "0.1402"],
        ["2", "153.4349°", "(133.8267°, 175.7103°]", "41.8837°", "6", "0.2504"],
        ["3", "-33.6901°", "(-46.1733°, -25.4501°]", "20.7233°", "4", "0.3783"],
        ["4", "-26.5651°", "(-46.1733°, -8.5868°]", "37.5865°", "2", "0.5000"],
    ]


def test_the_plan_is_marked_among_those_of_other_lengths():
    page = report_html(sg.plan_feeding(sg.load_part("4gon")))
    assert cells(page, "Best plan of each length")[1:] == [
        ["1", "50.4629°", "0.1402", "14.2679"],
        ["2", "90.1397°", "0.2504", "11.9814"],
        ["3", "136.1733°", "0.3783", "10.5748"],
        ["4", "180.0000°", "0.5000", "10.0000"],
    ]
    assert '<tr class="chosen"><th scope="row">4</th>' in page
    assert page.count('class="chosen"') == 1


@each_plan
def test_plans_of_other_lengths_are_those_of_the_problem(name):
    subject = Subject(PLANS[name](), 4)
    assert [p.steps for p in subject.chain] == list(range(1, len(subject.chain) + 1))
    assert subject.chain[: subject.plan.steps] == subject.plan.preimages
    probability, cost = subject.worth(subject.plan.preimages[-1])
    assert probability.decimal(8) == subject.plan.probability.decimal(8)
    assert cost.decimal(8) == subject.plan.expected_cost.decimal(8)


@pytest.mark.parametrize(("goal", "lengths"), [(None, 4), ("most stable", 4), ("90.9878", 4)])
def test_a_plan_with_a_goal_is_compared_with_longer_ones(goal, lengths):
    plan = sg.FeedingProblem(sg.load_part("4gon"), goal=goal).plan_of(2)
    assert len(Subject(plan, 4).chain) == lengths


def test_lengths_that_are_sure_to_catch_nothing_have_no_cost():
    problem = sg.FeedingProblem(
        sg.load_part("4gon"), prior=sg.WrappedNormal(mean="10", sd="30"), gripper_error="3"
    )
    subject = Subject(problem.optimal_plan(), 4)
    assert subject.worth(subject.chain[0]) is not None
    subject.plan.gripper_error = sg.Angle.from_degrees(26)  # more than half of the first width
    assert subject.worth(subject.chain[0]) is None
    assert subject.worth(subject.chain[1]) is not None


@pytest.mark.parametrize("digits", [0, 1, 4, 12])
def test_decimals_are_those_asked_for(digits):
    plan = sg.plan_feeding(sg.load_part("4gon"))
    rows = cells(report_html(plan, digits=digits), "Best plan of each length")
    assert rows[1][1] == f"{plan.preimages[0].width.degrees(digits)}°"
    with pytest.raises(InputError, match="digits"):
        report_html(plan, digits=-1)


def test_the_exact_numbers_are_there():
    page = report_html(sg.plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)]))
    assert cells(page, "Widest arcs")[1:] == [
        ["1", "arg(-2, 3)", "arg(-5, 12)", "0°"],
        ["2", "arg(2, 3)", "180°", "90°"],
    ]
    assert cells(page, "Vertices")[-1] == ["centre of mass", "3/2", "1"]
    assert cells(page, "Actions, exactly")[2] == [
        "2",
        "-45°",
        "arg(2, -3) - 1 turn",
        "arg(3, -2) - 1 turn",
    ]


def test_distributions_are_those_of_the_plan():
    plan = sg.plan_feeding(sg.load_part("4gon"), action="push-grasp")
    page = report_html(plan)
    for step in range(1, plan.steps + 1):
        state = plan.distribution(step)
        rows = cells(page, f"After action {step}<")
        assert [row[2] for row in rows[1:]] == list(state.probabilities(4))
        assert [row[0] for row in rows[1:]] == [f"{a.degrees(4)}°" for a in state.orientations]


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: sg.plan_feeding(sg.load_part("house"), gripper_error="2"), "off by 2.0000°"),
        (PLANS["push-grasp"], "lower jaw, drawn dark, pushes"),
        (PLANS["prior"], "normal, mean 10.0000°, standard deviation 30.0000°"),
        (PLANS["prior"], "aims at "),
        (PLANS["house"], "26.5650°</dd>"),
        (lambda: sg.plan_feeding(sg.load_part("house")), "the only turn is random"),
        (PLANS["no part"], "Feeding plan for this part"),
    ],
)
def test_what_was_asked_for_is_said(make, words):
    assert words in report_html(make())


@pytest.mark.parametrize("name", ["house", "4gon", "push-grasp", "prior", "field"])
def test_the_filter_is_described_exactly(name):
    plan = PLANS[name]()
    page = report_html(plan)
    ends = [trace.states[-1].reduced() for trace in Subject(plan, 4).traces]
    goal, period = plan.final_orientation.reduced(), plan.transfer.period
    equal = sum(end == goal for end in ends)
    alike = sum(end != goal and not (end - goal) % period for end in ends)
    # Each part is on the stage and in the table.
    assert page.count('<b class="yes">accepted</b>') == 2 * equal > 0
    assert page.count("<b>equivalent</b>") == 2 * alike
    assert page.count("<b>sent around again</b>") == 2 * (len(ends) - equal - alike)


def test_each_verdict_is_reached():
    pages = [report_html(sg.FeedingProblem(sg.load_part("house")).plan_of(k)) for k in (1, 2)]
    assert ["<b>sent around again</b>" in page for page in pages] == [True, False]
    assert all("<b>equivalent</b>" in page for page in pages)


def test_labels_of_near_states_stand_above_each_other():
    degrees = (0, 1, 2, 3, 100, 350, 355)
    state = Hyperstate(
        tuple(sg.Angle.from_degrees(d) for d in degrees),
        tuple(sg.Angle.from_degrees(w) for w in (30, 30, 40, 200, 20, 20, 20)),
    )
    scene = distributions_scene([(1, state)], sg.ZERO)
    boxes = [
        box_of(shape)
        for shape in scene.shapes
        if isinstance(shape, Label) and re.fullmatch(r"0\.\d\d", shape.text)
    ]
    assert len(boxes) == len(degrees)
    for k, ((left, low), (right, high)) in enumerate(boxes):
        for (other_left, other_low), (other_right, other_high) in boxes[k + 1 :]:
            apart = right < other_left or other_right < left
            # A box is a fifth higher than its letters.
            assert apart or high - 1.2 < other_low or other_high - 1.2 < low


# --- proof ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["house", "4gon", "push-grasp", "holes", "tiny", "error", "field"])
def test_the_certificate_in_the_page_is_valid_and_the_plan_s(name):
    plan = PLANS[name]()
    block = find_block(report_html(plan).encode(), CERTIFICATE)
    assert json.loads(block) == plan.certificate()
    field_certificate_checker.check(field_certificate_checker.load(block))


@pytest.mark.parametrize("name", ["prior", "measured", "goal", "no part"])
def test_a_page_without_certificate_says_why_and_carries_the_plan(name):
    plan = PLANS[name]()
    page = report_html(plan)
    block = find_block(page.encode(), PLAN)
    assert find_block(page.encode(), CERTIFICATE) is None
    assert "This page carries no certificate: " in page
    assert "; accepted: " not in page
    assert json.loads(block) == plan_json(plan)


def test_certificates_of_large_parts_stay_outside():
    part = sg.Part(near_circle(MOST_CERTIFIED + 1, seed=1))
    page = report_html(sg.FeedingProblem(part).plan_of(2))
    assert "stochgeom plan --certificate FILE" in page
    assert find_block(page.encode(), CERTIFICATE) is None
    assert len(page) < 500_000


# --- large ---------------------------------------------------------------------------------------


def test_rows_of_long_tables_are_left_out_in_the_middle():
    assert shown_rows(MOST_ROWS) == list(range(MOST_ROWS))
    rows = shown_rows(1000, 500)
    assert rows.count(None) == 2
    assert len(rows) == MOST_ROWS + 3
    assert {0, 500, 999} < set(rows)


def test_a_plan_of_many_actions_stays_legible():
    part = sg.Part(near_circle(300, seed=1, radius=10**6))
    plan = sg.FeedingProblem(part).geometric_plan()
    assert plan.steps > 100
    page = report_html(plan)
    assert f"The first 40 of {plan.steps} actions." in page
    assert page.count('type="radio"') == 42
    assert len(cells(page, "Actions in order")) == MOST_ROWS + 2
    assert len(Subject(plan, 4).chain) <= plan.steps + MOST_MORE
    Reader(page)


def test_a_part_of_ten_vertices_takes_less_than_half_a_megabyte():
    for seed in range(5):
        part = sg.Part(small_convex(10, seed))
        assert len(report_html(sg.orient_up_to_symmetry(part)).encode()) < 500_000


# --- writing -------------------------------------------------------------------------------------


def test_to_html_writes_the_page(tmp_path):
    plan = PLANS["house"]()
    path = tmp_path / "house.html"
    plan.to_html(path)
    assert path.read_text(encoding="utf-8") == report_html(plan)
    plan.to_html(str(path), digits=7)
    assert path.read_text(encoding="utf-8") == report_html(plan, digits=7)
    assert [p.name for p in tmp_path.iterdir()] == ["house.html"]


def test_after_an_error_nothing_is_written_and_nothing_lost(tmp_path):
    plan = PLANS["house"]()
    with pytest.raises(WriteError, match="cannot be written"):
        plan.to_html(tmp_path / "missing" / "house.html")
    (tmp_path / "file").write_text("kept", encoding="utf-8")
    with pytest.raises(WriteError, match="cannot be written"):
        plan.to_html(tmp_path / "file" / "house.html")
    (tmp_path / "folder").mkdir()
    with pytest.raises(WriteError, match="cannot be written"):
        plan.to_html(tmp_path / "folder")
    with pytest.raises(InputError, match="digits"):
        plan.to_html(tmp_path / "file", digits=-3)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file", "folder"]
    assert (tmp_path / "file").read_text(encoding="utf-8") == "kept"


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_may_not_be_written_to(tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(WriteError, match="Permission denied"):
        PLANS["house"]().to_html(tmp_path / "house.html")


def test_pictures_are_loaded_when_a_page_is_written(tmp_path):
    code = (
        "import sys, stochgeom as sg; plan = sg.plan_feeding(sg.load_part('house'));"
        "assert not [m for m in sys.modules if m.startswith('stochgeom.plotting')];"
        "plan.to_html(sys.argv[1]); assert 'matplotlib' not in sys.modules"
    )
    path = tmp_path / "page.html"
    subprocess.run([sys.executable, "-c", code, str(path)], check=True, cwd=ROOT)
    assert path.exists()


# --- under a prior -------------------------------------------------------------------------------

L = [(0, 0), ("7/2", 0), ("7/2", "3/4"), ("5/6", "3/4"), ("5/6", "13/3"), (0, "13/3")]


class TestMeasuredOrientations:
    """A part that arrives at 0 or at 90 degrees, and never otherwise."""

    prior = sg.DiscretePrior.from_counts({"0": 50, "90": 30})
    page = report_html(sg.plan_feeding(L, prior=prior))

    def test_the_first_angle_is_not_said_to_be_free(self):
        page = self.page
        assert "any angle" not in page
        first, second = cells(page, "Actions in order")[1:]
        assert first == ["1", "-10.8856°", "aims at 0.0000° to 130.1868°", "", "2", "0.6250"]
        assert second[4:] == ["1", "1.0000"]
        assert "which aims at 0.0000° to 130.1868°, then squeeze" in page
        assert "aims the mouth: no range" in page

    def test_the_mouth_and_the_prior_are_there(self):
        page = self.page
        assert "from 0.0000° to 130.1868° end in one and the same" in page
        assert "caught: 1.0000" in page

    def test_only_what_arrives_is_shown(self):
        page = self.page
        assert [row[0] for row in cells(page, "The same parts")[1:]] == ["0.00°", "90.00°"]
        assert "sent around again<" not in page
        assert [row[2] for row in cells(page, "After action 1<")[1:]] == ["0.6250", "0.3750"]


def test_what_stands_for_a_density_lies_where_it_is():
    plan = sg.plan_feeding(sg.load_part("house"), prior=sg.WrappedNormal("30", "12"))
    starts = [trace.start for trace in Subject(plan, 4).traces]
    assert len(starts) == 5
    assert all(sg.Angle.from_degrees(6) < theta < sg.Angle.from_degrees(54) for theta in starts)


def test_a_report_without_a_prior_has_no_funnel():
    assert "as a funnel" not in report_html(sg.plan_feeding(L))


# --- ranges --------------------------------------------------------------------------------------


def test_ranges_are_drawn_about_their_angles():
    actions = sg.plan_feeding(sg.load_part("4gon")).actions
    scene = tolerance_scene(list(enumerate(actions, 1)))
    hollow, closed = (
        [shape.center for shape in scene.shapes if isinstance(shape, Disc) and shape.style == style]
        for style in ("hollow", "closed")
    )
    marks = [
        shape.points[0]
        for shape in scene.shapes
        if isinstance(shape, Polygon) and shape.style == "image"
    ]
    for action, low, high, (x, _) in zip(actions[1:], hollow, closed, marks[-3:], strict=True):
        below, above = (float(a.degrees(9)) for a in (action.angle - action.low,
                                                      action.high - action.angle))  # fmt: skip
        assert (x - low[0]) * above == pytest.approx((high[0] - x) * below)


def test_a_range_too_narrow_to_draw_is_written_out():
    plan = sg.plan_feeding(sg.FAMILIES["long plans"](25, seed=1))
    narrow = min(plan.actions[1:], key=lambda action: action.tolerance)
    scene = tolerance_scene([(1, plan.actions[1]), (2, narrow)])
    assert "0.0000101° wide" in {s.text for s in scene.shapes if isinstance(s, Label)}


def test_actions_without_a_name_are_not_called_twice():
    plan = sg.plan_transfer(sg.squeeze_function(L))
    assert "<dt>actions</dt>" in report_html(plan)
    assert "<dt>squeeze actions</dt>" in report_html(sg.plan_feeding(L))


def test_a_long_plan_says_which_actions_it_shows():
    page = report_html(sg.plan_feeding(sg.FAMILIES["long plans"](25, seed=1)))
    assert "Of 25 ranges the first 12 and the last 12 are drawn." in page
    numbers = re.findall(r">action (\d+)<", page)
    assert list(map(int, numbers)) == [*range(1, 13), *range(14, 26)]
    found = re.search(r"Of (\d+) actions the first 6 and the last 6 are shown", page)
    assert found
    assert int(found[1]) > 12
