"""What notebooks show, and that nothing of it is loaded before it is shown."""

from __future__ import annotations

import re
import subprocess
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import stochgeom as sg
from stochgeom import display
from stochgeom.display import Displayed, register_renderers, render
from stochgeom.plotting.rich_display import RENDERERS
from tests.repo.sources import MODULES, ROOT
from tests.scene_checks import SVG, parsed

RECTANGLE = sg.Part([(0, 0), (3, 0), (3, 2), (0, 2)], name="rectangle")
COIN = sg.PlanningProblem.from_matrices(
    ["1/4", "3/4"], {"turn": [[0, 1], [1, 0]], "wait": [[1, 0], [0, 1]]}
)
LONG = sg.FAMILIES["long plans"].generate(15, 1)

SHOWN = {
    "AndOrTree": lambda: sg.all_sensor_plans(COIN, sg.Sensor.perfect(COIN.states), 2),
    "AngleSum": lambda: sg.AngleSum(1, [(2, sg.Angle(0, (3, 2)))]),
    "CellSet": lambda: sg.GraspDiagram(RECTANGLE, "1/4").guaranteed,
    "DecisionProblem": lambda: sg.DecisionProblem(
        ["h", "t"], ["none"], ["h", "t"], [[1], [1]], [[0, 1], [1, 0]]
    ),
    "DiameterFunction": lambda: sg.DiameterFunction(RECTANGLE),
    "FeedingPlan": lambda: sg.plan_feeding(RECTANGLE),
    "FeedingProblem": lambda: sg.FeedingProblem(RECTANGLE, "push-grasp"),
    "GraspDiagram": lambda: sg.GraspDiagram(RECTANGLE, "1/4"),
    "Hyperstate": lambda: sg.plan_feeding(RECTANGLE).distribution(1),
    "Part": lambda: RECTANGLE,
    "PlanTree": lambda: sg.iterative_sensor_plan(COIN, sg.Sensor.perfect(COIN.states), 2).tree,
    "PlanningProblem": lambda: COIN,
    "Preimages": lambda: sg.FeedingProblem(RECTANGLE).preimages,
    "PushStability": lambda: sg.PushStability(RECTANGLE),
    "RadiusFunction": lambda: sg.RadiusFunction(RECTANGLE),
    "RecognitionProblem": lambda: sg.RecognitionProblem(
        {"rectangle": RECTANGLE, "square": [(0, 0), (2, 0), (2, 2), (0, 2)]}
    ),
    "SensingProblem": lambda: sg.SensingProblem(RECTANGLE, bits=1, noise="0.1"),
    "SensorPlan": lambda: sg.iterative_sensor_plan(COIN, sg.Sensor.perfect(COIN.states), 2),
    "SqueezeStability": lambda: sg.SqueezeStability(RECTANGLE, "1/4"),
    "StepFunction": lambda: sg.squeeze_function(RECTANGLE),
    "TurnRatio": lambda: sg.plan_feeding(RECTANGLE, "1/2").probability,
}


def test_every_renderer_is_of_a_class_that_is_displayed_and_tested():
    shown = {name for name, form in RENDERERS if form in {"svg", "html", "latex"}}
    assert set(SHOWN) <= shown
    source = "\n".join(path.read_text(encoding="utf-8") for path in MODULES)
    declared = set(re.findall(r"^class (\w+)\((?:\w+, )*Displayed(?:, \w+)*\)", source, re.M))
    assert shown <= declared
    assert declared <= shown


@pytest.mark.parametrize("name", SHOWN)
def test_what_is_shown_is_short_and_whole(name):
    value = SHOWN[name]()
    assert type(value).__name__ == name
    assert isinstance(value, Displayed)
    forms = {
        "svg": value._repr_svg_(),
        "html": value._repr_html_(),
        "latex": value._repr_latex_(),
    }
    assert {form for form, text in forms.items() if text is not None} == {
        form for owner, form in RENDERERS if owner == name and form in forms
    }
    if forms["svg"]:
        assert len(parsed(forms["svg"])) > 3
        assert len(forms["svg"]) < (40_000 if name == "GraspDiagram" else 20_000)
    if forms["html"]:
        ET.fromstring(f"<div>{forms['html']}</div>")
        assert len(forms["html"]) < 40_000
    if forms["latex"]:
        assert forms["latex"].startswith("$\\displaystyle ")


@pytest.mark.parametrize("name", SHOWN)
def test_what_is_shown_has_a_short_repr_too(name):
    text = repr(SHOWN[name]())
    assert " object at 0x" not in text
    assert name in text


def test_problems_name_themselves():
    problem = sg.FeedingProblem(RECTANGLE, gripper_error="2", goal="90")
    assert repr(problem) == (
        "<FeedingProblem for rectangle: squeeze, uniform prior, gripper error 2.0000°, goal 90>"
    )
    chain = sg.FeedingProblem(RECTANGLE).preimages
    assert repr(chain) == "<Preimages under 2 steps in 180.0000°: 0 known>"
    assert len(list(chain)) == 2
    assert repr(chain) == "<Preimages under 2 steps in 180.0000°: 2 known, all>"
    sensing = SHOWN["SensingProblem"]()
    assert repr(sensing) == (
        "<SensingProblem for rectangle: 4 orientations, 4 squeezes, a sensor of 2 readings>"
    )
    assert repr(SHOWN["RecognitionProblem"]()).startswith("<RecognitionProblem: 2 parts, ")


def test_a_sensing_problem_tells_what_is_read_in_each_orientation():
    page = SHOWN["SensingProblem"]()._repr_html_()
    rows = re.findall(r"<td>(.*?)</td><td>(.*?)</td><td>(.*?)</td>", page)
    assert [row[:2] for row in rows] == [
        ("0.0000°", "0.3128"), ("90.0000°", "0.1872"), ("180.0000°", "0.3128"),
        ("270.0000°", "0.1872"),
    ]  # fmt: skip
    assert [row[2] for row in rows[:2]] == ["below 2.5 (1.0000)", "from 2.5 (1.0000)"]
    page = SHOWN["RecognitionProblem"]()._repr_html_()
    assert "<td>square</td><td>90.0000°</td><td>0.1250</td><td>2 (1.0000)</td>" in page


def test_the_same_value_is_shown_alike():
    assert RECTANGLE._repr_svg_() == sg.Part(RECTANGLE.vertices, name="rectangle")._repr_svg_()


def test_a_formula_is_exact():
    assert "operatorname{atan}" in SHOWN["AngleSum"]()._repr_latex_()
    assert sg.plan_feeding(RECTANGLE).probability._repr_latex_() == "$\\displaystyle \\frac{1}{2}$"


def test_the_picture_of_a_part_names_it():
    root = parsed(sg.Part(RECTANGLE.vertices, name='<b> & "q"\x07')._repr_svg_())
    assert root.find(f"{SVG}title").text == '<b> & "q"\ufffd'


def test_a_plan_shows_angles_that_work_as_printed():
    page = sg.orient_up_to_symmetry(sg.catalogue_part("4gon"))._repr_html_()
    rows = re.findall(r"<td>(\d+)</td><td>(.*?)</td><td>(.*?)</td><td>(.*?)</td>", page)
    assert rows[0] == ("1", "any", "", "")
    assert rows[1] == ("2", "153.4349°", "133.8267°", "175.7103°")
    assert len(rows) == 4


def test_a_first_action_under_a_prior_has_an_angle():
    plan = sg.plan_feeding(RECTANGLE, prior=sg.WrappedNormal("40", "30"))
    assert "<td>1</td><td>any</td>" not in plan._repr_html_()


def test_a_plan_tells_how_many_of_the_steps_are_traced():
    page = sg.plan_feeding(sg.catalogue_part("key"))._repr_html_()
    assert "(in 4 of 8 steps)" in page


def test_a_long_plan_shows_its_funnel_and_a_cut_table():
    plan = sg.orient_up_to_symmetry(LONG)
    page = plan._repr_html_()
    assert "<td>3 more</td>" in page
    assert page.count("<tr>") == 1 + 12 + 1
    assert len(page) < 40_000


def test_a_plan_of_a_transfer_function_shows_its_funnel():
    page = sg.plan_transfer(sg.squeeze_function(RECTANGLE))._repr_html_()
    assert "2 actions" in page
    assert "action action" not in page
    assert "sg-funnel" in page
    assert "sg-part" not in page


def test_a_problem_tells_where_nothing_is_caught_for_sure():
    problem = sg.FeedingProblem(
        sg.catalogue_part("4gon"), prior=sg.WrappedNormal("40", "30"), gripper_error="40"
    )
    assert "none for sure" in problem._repr_html_()


def test_large_values_are_shown_short():
    """100,000 vertices, 270 steps, 180 states: pictures stay pictures."""
    k = np.arange(-50_000, 50_000)
    parabola = sg.Part(np.stack([k, k * k], axis=1))
    assert len(parabola._repr_svg_()) < 20_000
    assert len(sg.DiameterFunction(parabola)._repr_svg_()) < 20_000
    problem = sg.FeedingProblem(sg.FAMILIES["Reuleaux-like parts"].generate(90, 1))
    assert len(problem.transfer._repr_svg_()) < 20_000
    assert len(problem._repr_html_()) < 40_000
    plan = problem.geometric_plan()
    assert len(plan._repr_html_()) < 40_000
    assert len(plan.distribution(1)._repr_svg_()) < 40_000


def test_large_diagrams_and_problems_are_shown_short():
    """80 vertices, 200 states, 30 actions, a tree of hundreds of nodes."""
    many = sg.GraspDiagram(sg.Part.regular(80), "1/100")
    assert len(many._repr_svg_()) < 80_000
    assert len(many.guaranteed._repr_svg_()) < 20_000
    n = 200
    identity = [[int(i == j) for j in range(n)] for i in range(n)]
    large = sg.PlanningProblem.from_matrices([1] + [0] * (n - 1), [identity] * 30)
    page = large._repr_html_()
    assert "<td>188 more</td>" in page
    assert "<svg" not in page
    assert len(page) < 5_000


def test_floats_are_shown_too():
    assert "0.2500" in COIN.to_float()._repr_html_()


def test_a_long_plan_with_sensors_is_told_in_numbers():
    problem = sg.PlanningProblem.from_matrices(["1/5"] * 5, [[[0, 1, 0, 0, 0]] * 5])
    noisy = sg.Sensor.noisy(problem.states, "1/10")
    plan = sg.iterative_sensor_plan(problem, noisy, stages=["sense", "sense", "sense"])
    assert sum(1 for _ in plan.tree.nodes()) > 60
    assert "<svg" not in plan._repr_html_()
    assert "leaves" in plan._repr_html_()


def test_more_states_than_degrees_are_summed_by_the_degree():
    width = sg.Angle.from_turns("1/720")
    state = sg.Hyperstate(tuple(width * k for k in range(720)), (width,) * 720)
    root = parsed(state._repr_svg_())
    assert len(root.findall(f"{SVG}polygon")) == 360


def test_coordinates_beyond_floats_are_shown():
    part = sg.Part([(0, 0), (10**400, 0), (0, 10**399)])
    assert len(parsed(part._repr_svg_())) > 3


@pytest.mark.parametrize("size", [10**400, "1e-400"])
@pytest.mark.parametrize("action", ["squeeze", "push-grasp"])
def test_problems_of_such_parts_are_shown_without_their_waves(size, action):
    problem = sg.FeedingProblem([(0, 0), (size, 0), (0, size)], action)
    shown = problem._repr_html_()
    assert "preimage" in shown
    assert "diameter" not in shown
    assert "radius" not in shown
    assert sg.DiameterFunction(problem.part)._repr_svg_() is None
    assert sg.RadiusFunction(problem.part)._repr_svg_() is None


def test_what_cannot_occur_is_not_counted():
    half = sg.Angle.from_degrees(180)
    state = sg.Hyperstate((sg.ZERO, half), (half, half), (sg.AngleSum(1), sg.AngleSum(0)))
    shown = state._repr_svg_()
    assert "a distribution over 1 orientation<" in shown
    assert "180.00 degrees" not in shown


class TestTheRegistry:
    @pytest.fixture(autouse=True)
    def _own_sources(self, monkeypatch):
        monkeypatch.setattr(display, "_sources", [])

    def test_without_a_renderer_nothing_is_shown(self):
        assert RECTANGLE._repr_svg_() is None
        assert render(RECTANGLE, "no such form") is None

    def test_a_renderer_of_a_base_class_serves(self):
        class Base(Displayed):
            pass

        class Derived(Base):
            pass

        register_renderers(lambda: {("Base", "html"): lambda value: type(value).__name__})
        assert Derived()._repr_html_() == "Derived"
        assert Derived()._repr_svg_() is None

    def test_arguments_are_handed_on(self):
        register_renderers(
            lambda: {("int", "sum"): lambda value, *more, last: value + more[0] + last}
        )
        assert render(1, "sum", 2, last=3) == 6


def test_pictures_are_loaded_when_the_first_value_is_shown():
    code = (
        "import sys; from stochgeom.feeding.planner import plan_feeding\n"
        "plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])\n"
        "print(any('plotting' in name for name in sys.modules))\n"
        "page = plan._repr_html_()\n"
        "print(any('plotting' in name for name in sys.modules), 'matplotlib' in sys.modules)\n"
    )
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT
    )
    assert run.stdout.split() == ["False", "True", "False"]
