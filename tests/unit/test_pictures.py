"""Pictures on matplotlib axes: what is on them, the same bytes each time, clear errors."""

from __future__ import annotations

import os
import re
import stat
import sys

import numpy as np
import pytest

import stochgeom as sg
from stochgeom.errors import (
    CenterOfMassError,
    FloatRefusedError,
    FrictionError,
    InputError,
    InvalidPartError,
    MissingExtraError,
    NodeLimitError,
    NumberLimitError,
    PriorError,
    RecordingError,
    SensorError,
    WriteError,
)

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
NUT = sg.Part.regular(6)

TEST = sg.DecisionProblem(
    ["good", "bad"],
    ["pass", "fail"],
    ["keep", "throw"],
    [["9/10", "1/10"], ["1/10", "9/10"]],
    [[0, 1], [5, 0]],
)
COIN = sg.PlanningProblem.from_matrices(
    ["1/4", "3/4"], {"turn": [[0, 1], [1, 0]], "wait": [[1, 0], [0, 1]]}
)
EYE = sg.Sensor.perfect(["0", "1"])
TILTS = sg.figure_6_4_model()


def loss_of(number):
    """Return a problem in which something is lost."""
    return sg.DecisionProblem(["good"], ["pass"], ["keep"], [[1]], [[number]])


DRAWINGS = {
    "draw_all_plans": lambda ax: sg.draw_all_plans(sg.all_sensor_plans(COIN, EYE, 1), ax),
    "draw_analysis": lambda ax: sg.draw_analysis(sg.FeedingProblem(RECTANGLE), ax and [ax] * 3)[0],
    "draw_beta_density": lambda ax: sg.draw_beta_density(4, 1, ax),
    "draw_closing": lambda ax: sg.draw_closing(NUT, 15, ax),
    "draw_closure": lambda ax: sg.draw_closure(sg.plan_feeding(RECTANGLE), ax),
    "draw_diameter": lambda ax: sg.draw_diameter(RECTANGLE, ax),
    "draw_distribution": lambda ax: sg.draw_distribution(
        sg.plan_feeding(RECTANGLE).distribution(), ax
    ),
    "draw_feeder": lambda ax: sg.draw_feeder(sg.plan_feeding(RECTANGLE), ax, parts=2),
    "draw_friction_bounds": lambda ax: sg.draw_friction_bounds(RECTANGLE, ax),
    "draw_funnel": lambda ax: sg.draw_funnel(sg.plan_feeding(RECTANGLE), ax),
    "draw_grasp": lambda ax: sg.draw_grasp(RECTANGLE, "12.5", ax),
    "draw_grasp_diagram": lambda ax: sg.draw_grasp_diagram(RECTANGLE, "1/4", ax),
    "draw_gripper": lambda ax: sg.draw_gripper(ax, sliding=True),
    "draw_monotone_step": lambda ax: sg.draw_monotone_step(sg.plan_feeding(RECTANGLE), ax, step=2),
    "draw_open_loop_plans": lambda ax: sg.draw_open_loop_plans(COIN, 2, ax),
    "draw_part": lambda ax: sg.draw_part(RECTANGLE, ax),
    "draw_phase_one": lambda ax: sg.draw_phase_one(sg.squeeze_function(RECTANGLE), 2, ax),
    "draw_plan_tree": lambda ax: sg.draw_plan_tree(sg.iterative_sensor_plan(COIN, EYE, 2), ax),
    "draw_preimages": lambda ax: sg.draw_preimages(sg.squeeze_function(RECTANGLE), ax),
    "draw_push_density": lambda ax: sg.draw_push_density(RECTANGLE, ax),
    "draw_push_grasp_analysis": lambda ax: sg.draw_push_grasp_analysis(RECTANGLE, ax and [ax] * 6)[
        0
    ],
    "draw_push_stability": lambda ax: sg.draw_push_stability(RECTANGLE, ax, jaw=sg.Jaw.UPPER),
    "draw_radius": lambda ax: sg.draw_radius(RECTANGLE, ax),
    "draw_risks": lambda ax: sg.draw_risks(TEST, None, ax),
    "draw_scooped_blocks": lambda ax: sg.draw_scooped_blocks([1, 1], [1, 1], ax),
    "draw_sensed_blocks": lambda ax: sg.draw_sensed_blocks([1, 1], [1, 2], ax),
    "draw_sensor_density": lambda ax: sg.draw_sensor_density(2, "1/4", [1, 2, 3], ax),
    "draw_sliding_jaw": lambda ax: sg.draw_sliding_jaw(NUT, 20, ax),
    "draw_squeeze_stability": lambda ax: sg.draw_squeeze_stability(RECTANGLE, "1/4", ax),
    "draw_stable_grasps": lambda ax: sg.draw_stable_grasps(RECTANGLE, ax),
    "draw_step_function": lambda ax: sg.draw_step_function(sg.squeeze_function(RECTANGLE), ax),
    "draw_tilting": lambda ax: sg.draw_tilting(None, ax),
    "draw_tilts": lambda ax: sg.draw_tilts(TILTS, 7, [1], ax),
    "draw_trace": lambda ax: sg.draw_trace(sg.plan_feeding(RECTANGLE), ax),
    "draw_tray": lambda ax: sg.draw_tray(None, ax),
    "draw_uncertain_grasp": lambda ax: sg.draw_uncertain_grasp(RECTANGLE, 20, "15", ax),
}

SEVERAL_GRAPHS = {"draw_analysis", "draw_push_grasp_analysis"}


def test_every_drawing_function_is_tested():
    assert set(DRAWINGS) == {
        name
        for name in sg.__all__
        if name.startswith("draw_") and "plotting" in getattr(sg, name).__module__
    }


@pytest.mark.parametrize("name", DRAWINGS)
def test_without_matplotlib_the_extra_is_named(name, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(MissingExtraError, match=r"stochgeom\[plot\]"):
        DRAWINGS[name](None)


def test_saving_without_matplotlib_names_the_extra_too(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(MissingExtraError, match=r"stochgeom\[plot\]"):
        sg.save_figure(None, tmp_path / "a.svg")


class TestOnAxes:
    @pytest.fixture(autouse=True)
    def _matplotlib(self):
        pytest.importorskip("matplotlib")
        import matplotlib as mpl

        mpl.use("Agg")
        yield
        import matplotlib.pyplot as plt

        plt.close("all")

    @staticmethod
    def axes(width=6.4, height=4.8):
        from matplotlib.figure import Figure

        return Figure(figsize=(width, height)).subplots()

    @pytest.mark.parametrize("name", DRAWINGS)
    def test_axes_given_are_drawn_on_and_returned(self, name):
        ax = self.axes()
        assert DRAWINGS[name](ax) is ax
        assert ax.has_data() or ax.patches
        import matplotlib.pyplot as plt

        assert plt.get_fignums() == []  # nothing of its own

    @pytest.mark.parametrize(
        ("name", "ending"),
        [*((name, "svg") for name in DRAWINGS), ("draw_grasp", "png"), ("draw_diameter", "pdf")],
    )
    def test_the_same_picture_is_the_same_bytes(self, name, ending, tmp_path):
        paths = [tmp_path / f"{k}.{ending}" for k in (1, 2)]
        for path in paths:
            sg.save_figure(DRAWINGS[name](None), path, dpi=40)
        first, second = (path.read_bytes() for path in paths)
        assert first == second
        assert b"Matplotlib v" not in first  # versions would differ from one machine to the next
        assert b"dc:date" not in first
        assert b"CreationDate" not in first

    @pytest.mark.parametrize(
        "name", ["draw_beta_density", "draw_diameter", "draw_sensed_blocks", "draw_risks"]
    )
    def test_what_was_saved_before_does_not_matter(self, name, tmp_path):
        """Found with 90 dots per inch, after which labels and axes stood elsewhere."""
        used, new = DRAWINGS[name](None), DRAWINGS[name](None)
        sg.save_figure(used, tmp_path / "before.png", dpi=90)
        for ending in ("svg", "png"):
            for ax, path in ((used, tmp_path / f"1.{ending}"), (new, tmp_path / f"2.{ending}")):
                sg.save_figure(ax, path, dpi=130)
            assert (tmp_path / f"1.{ending}").read_bytes() == (
                tmp_path / f"2.{ending}"
            ).read_bytes()

    def test_axes_that_were_placed_by_hand_stay_there(self, tmp_path):
        ax = sg.draw_diameter(RECTANGLE)
        ax.set_position((0.3, 0.3, 0.5, 0.5))
        sg.save_figure(ax, tmp_path / "a.png", dpi=40)
        assert ax.get_position().bounds == pytest.approx((0.3, 0.3, 0.5, 0.5))

    def test_graphs_that_are_drawn_together_are_saved_together(self, tmp_path):
        for pick, name in ((slice(None), "all.svg"), (-1, "one.svg")):
            graphs = sg.draw_analysis(sg.FeedingProblem(RECTANGLE))
            sg.save_figure(graphs[pick], tmp_path / name)
        assert (tmp_path / "all.svg").read_bytes() == (tmp_path / "one.svg").read_bytes()

    # --- what is drawn ---------------------------------------------------------------------------

    def test_bars_stand_where_the_preimages_are(self):
        chain = sg.preimages(sg.squeeze_function(RECTANGLE))
        ax = sg.draw_preimages(chain, self.axes())
        ends = [(bar.get_x(), bar.get_x() + bar.get_width()) for bar in ax.patches]
        exact = [(float(p.arc.start.degrees(9)), float(p.arc.end.degrees(9))) for p in chain]
        assert np.array(ends) == pytest.approx(np.array(exact))
        assert [tick.get_text() for tick in ax.get_yticklabels()] == ["1", "2"]
        top, bottom = ax.get_ylim()[1], ax.get_ylim()[0]
        assert top < bottom  # the first preimage is on top

    def test_push_grasps_get_two_turns(self):
        part = sg.catalogue_part("4gon")
        axes = sg.draw_analysis(sg.FeedingProblem(part, "push-grasp"))
        assert [ax.get_xlim() for ax in axes] == [(0, 720)] * 3
        assert [ax.get_ylabel() for ax in axes] == ["radius", "push-grasp", "actions"]

    def test_a_problem_without_a_part_has_two_graphs(self):
        problem = sg.FeedingProblem.of_transfer(sg.squeeze_function(RECTANGLE))
        assert len(sg.draw_analysis(problem)) == 2

    def test_angle_axes_are_in_degrees(self):
        ax = sg.draw_step_function(sg.squeeze_function(RECTANGLE), self.axes())
        assert [t.get_text() for t in ax.get_xticklabels()][::2] == [
            "0°", "90°", "180°", "270°", "360°"
        ]  # fmt: skip
        assert "270°" in [t.get_text() for t in ax.get_yticklabels()]

    def test_negative_values_have_a_true_minus(self):
        s = sg.StepFunction([sg.ZERO], [sg.Angle.from_degrees(-100)])
        ax = sg.draw_step_function(s, self.axes())
        assert "−90°" in [t.get_text() for t in ax.get_yticklabels()]

    def test_steps_are_drawn_with_their_ends(self):
        ax = sg.draw_step_function(sg.squeeze_function(RECTANGLE), self.axes())
        segments = ax.collections[1].get_segments()
        assert [segment[0][1] for segment in segments] == [0, 90, 180, 270, 360]
        hollow, filled = ax.lines[1], ax.lines[2]
        assert len(hollow.get_xdata()) == len(filled.get_xdata()) == 4
        assert hollow.get_markerfacecolor() != filled.get_markerfacecolor()

    def test_many_steps_are_not_marked(self):
        ax = sg.draw_step_function(sg.squeeze_function(sg.Part.regular(41)), self.axes())
        assert len(ax.lines) == 1

    def test_many_equal_bars_have_all_their_numbers(self):
        """Found with 14 bars, which had lost all of them."""
        state = sg.plan_feeding(sg.Part.regular(7)).distribution(1)
        ax = sg.draw_distribution(state)
        assert [text.get_text() for text in ax.texts] == ["0.071"] * 14
        assert overlaps(ax) == []
        for bar, text in zip(ax.patches, ax.texts, strict=True):
            box = text.get_window_extent().transformed(ax.transData.inverted())
            assert box.x0 - 2 <= bar.get_x() + bar.get_width() / 2 <= box.x1 + 2

    def test_what_has_no_probability_has_no_bar(self):
        prior = sg.DiscretePrior.from_counts({"10": 1, "100": 3})
        state = sg.plan_feeding(sg.catalogue_part("4gon"), prior=prior).distribution(1)
        ax = sg.draw_distribution(state, self.axes())
        assert len(ax.patches) == len(ax.texts) == 2 < len(state)

    def test_extrema_of_the_diameter(self):
        ax = sg.draw_diameter(RECTANGLE, self.axes())
        _, minima, maxima = ax.lines
        assert minima.get_xdata().tolist() == [0, 90, 180, 270, 360]
        assert maxima.get_ydata() == pytest.approx([13**0.5] * 4)

    def test_phase_one_draws_the_square_of_the_widest_arc(self):
        transfer = sg.squeeze_function(RECTANGLE)
        ax = sg.draw_phase_one(transfer, 2, self.axes())
        squares = [p for p in ax.patches if p.get_width() == p.get_height()]
        heavy = max(squares, key=lambda square: square.get_linewidth())
        assert len(squares) == 4
        assert heavy.get_xy() == pytest.approx((56.30993247, 90))
        assert heavy.get_width() == pytest.approx(112.61986495)
        first = sg.draw_phase_one(transfer, 1, self.axes())
        assert first.lines[-1].get_ydata().tolist() == [180]

    @pytest.mark.parametrize("steps", [1, 2])
    def test_the_width_of_a_narrow_arc_stands_beside_its_bar(self, steps):
        long = sg.FAMILIES["long plans"].generate(15, 1)
        ax = sg.draw_phase_one(sg.squeeze_function(long), steps, self.axes())
        (text,), bar = ax.texts, ax.patches[0]
        ax.get_figure().draw_without_rendering()
        box = text.get_window_extent().transformed(ax.transData.inverted())
        left, right = bar.get_x(), bar.get_x() + bar.get_width()
        assert box.x0 >= right or box.x1 <= left or left <= box.x0 <= box.x1 <= right

    def test_a_grasp_says_what_holds(self):
        ax = sg.draw_grasp(RECTANGLE, 0, self.axes())
        assert ax.texts[-1].get_text() == "0.00°: stable"
        ax = sg.draw_grasp(RECTANGLE, sg.Angle(0, (2, 1)), self.axes())
        assert ax.texts[-1].get_text() == "26.57°: wedged"

    def test_text_is_never_mathematics(self):
        """A part's name or a prior's words may hold dollar signs."""
        from stochgeom.plotting.axes import draw_scene
        from stochgeom.plotting.scene import Label, Scene

        ax = draw_scene(Scene([Label((0, 0), "$\\frac{$", 1.0)]), self.axes())
        ax.get_figure().draw_without_rendering()
        assert ax.texts[0].get_text() == "$\\frac{$"

    def test_letters_too_small_to_read_are_warned_of(self):
        """Found in a grid of four by four axes, where letters had three pixels."""
        from matplotlib.figure import Figure

        plan = sg.plan_feeding(sg.catalogue_part("4gon"))
        small = Figure(figsize=(6.4, 4.8)).subplots(4, 4)[0, 0]
        with pytest.warns(UserWarning, match=r"letters of 0\.\d points .* inches") as caught:
            sg.draw_trace(plan, small)
        assert caught[0].filename == __file__
        width, height = map(
            float, re.findall(r"about ([\d.]+) by ([\d.]+)", str(caught[0].message))[0]
        )
        large = Figure(figsize=(width, height)).add_axes((0, 0, 1, 1))
        sg.draw_trace(plan, large)
        assert min(text.get_fontsize() for text in large.texts) == pytest.approx(6, abs=0.1)

    def test_letters_fit_smaller_axes(self):
        large = sg.draw_grasp(RECTANGLE, 0, self.axes(8, 8)).texts[0].get_fontsize()
        small = sg.draw_grasp(RECTANGLE, 0, self.axes(2, 2)).texts[0].get_fontsize()
        assert large == pytest.approx(4 * small)

    @pytest.mark.parametrize("name", sorted({*DRAWINGS} - SEVERAL_GRAPHS))
    def test_labels_do_not_overlap_as_drawn(self, name):
        assert overlaps(DRAWINGS[name](self.axes(4.8, 3.2))) == []

    def test_labels_of_several_graphs_do_not_overlap(self):
        part = sg.catalogue_part("4gon")
        for axes in (
            sg.draw_analysis(sg.FeedingProblem(part, "push-grasp")),
            sg.draw_push_grasp_analysis(part),
        ):
            for ax in axes:
                assert overlaps(ax) == []

    # --- the Beta density ------------------------------------------------------------------------

    @pytest.mark.parametrize(
        ("parameters", "printed"),
        [
            ((1, 1), "mean 0.500, variance 0.083"),
            (("0.1", "0.1"), "mean 0.500, variance 0.208"),
            ((16, 16), "mean 0.500, variance 0.008"),
            ((4, 1), "mean 0.200, variance 0.027"),
        ],
    )
    def test_figures_g_1_to_g_4(self, parameters, printed):
        assert printed in sg.draw_beta_density(*parameters, self.axes()).get_title()

    @pytest.mark.parametrize(
        "parameters", [("1/3", "1000"), (2000, 3), ("1/100", "10000"), (9, 99)]
    )
    def test_a_narrow_density_is_seen(self, parameters):
        """Found with (1/3, 1000), whose axis had ended at 9e-21."""
        ax = sg.draw_beta_density(*parameters)
        beta, (low, high), (_, top) = sg.BetaDensity(*parameters), ax.get_xlim(), ax.get_ylim()
        y = ax.lines[0].get_ydata()
        mean, sd = float(beta.mean), float(beta.variance) ** 0.5
        assert low <= mean <= high
        assert high - low > 4 * sd
        inside = (y <= top) & (y >= 0.02 * top)
        assert inside.mean() > 0.1  # the curve crosses the picture
        assert ("part of" in ax.get_xlabel()) == (high - low < 1)
        assert overlaps(ax) == []
        assert "variance 0.000," not in ax.get_title()

    def test_long_parameters_fit_the_title(self):
        ax = sg.draw_beta_density("123456789/987654321", "7000001/1234577")
        ax.get_figure().draw_without_rendering()
        assert ax.get_title().startswith("α₁ ≈ 0.125000, α₂ ≈ 5.669959")
        box = ax.title.get_window_extent()
        assert box.x1 - box.x0 < ax.get_figure().bbox.x1

    @pytest.mark.parametrize("parameters", [(1, 1), (16, 16), (4, 1), ("2.5", 3)])
    def test_the_density_has_the_exact_moments(self, parameters):
        p = (np.arange(20_000) + 0.5) / 20_000
        beta = sg.BetaDensity(*parameters)
        density = np.array([beta(float(x)) for x in p]) / 20_000
        mean, variance = beta.mean, beta.variance
        assert density.sum() == pytest.approx(1)
        assert (density * p).sum() == pytest.approx(float(mean))
        assert (density * (p - float(mean)) ** 2).sum() == pytest.approx(float(variance))

    # --- bad input -------------------------------------------------------------------------------

    @pytest.mark.parametrize(
        ("call", "error", "message"),
        [
            (
                lambda: sg.draw_part(RECTANGLE, "axes"),
                InputError,
                "'axes' is of type str, not Axes",
            ),
            (lambda: sg.draw_trace(RECTANGLE), InputError, "not FeedingPlan; accepted: a plan"),
            (lambda: sg.draw_closure(RECTANGLE), InputError, "is of type list, not FeedingPlan"),
            (
                lambda: sg.draw_monotone_step(sg.plan_feeding(RECTANGLE), step=3),
                InputError,
                "3 as the number of an action; accepted: whole numbers from 1 to 2",
            ),
            (lambda: sg.draw_feeder(RECTANGLE), InputError, "not FeedingPlan; accepted: a plan"),
            (
                lambda: sg.draw_feeder(sg.plan_feeding(RECTANGLE), seed=None),
                InputError,
                "None as the seed",
            ),
            (lambda: sg.draw_funnel(RECTANGLE), InputError, "not FeedingPlan; accepted: a plan"),
            (lambda: sg.draw_funnel(sg.plan_feeding(RECTANGLE), prior="30"), InputError, "Prior"),
            (lambda: sg.draw_step_function(RECTANGLE), InputError, "not StepFunction"),
            (lambda: sg.draw_analysis(RECTANGLE), InputError, "not FeedingProblem"),
            (lambda: sg.draw_phase_one(RECTANGLE, 1), InputError, "no StepFunction"),
            (lambda: sg.draw_phase_one(sg.squeeze_function(RECTANGLE), 0), InputError, "0 steps"),
            (lambda: sg.draw_distribution(RECTANGLE), InputError, "not Hyperstate"),
            (lambda: sg.draw_preimages(RECTANGLE), InputError, "not Preimage"),
            (lambda: sg.draw_preimages(7), InputError, "not Iterable"),
            (lambda: sg.draw_preimages([]), InputError, "0 preimages"),
            (lambda: sg.draw_diameter(RECTANGLE, turns=0), InputError, "0 turns; accepted: whole"),
            (lambda: sg.draw_radius(RECTANGLE, turns="2"), InputError, "'2' turns"),
            (
                lambda: sg.draw_step_function(sg.squeeze_function(RECTANGLE), turns=11),
                InputError,
                "11 turns; accepted: whole numbers from 1 to 10",
            ),
            (lambda: sg.draw_scooped_blocks([1, 1], ["a", 0]), InputError, "'a' as a place"),
            (lambda: sg.draw_scooped_blocks([1, 1], [True, 0]), InputError, "True as a place"),
            (lambda: sg.draw_scooped_blocks([1, 1], None), InputError, "a list of places"),
            (lambda: sg.draw_sensed_blocks([1, 1], None), InputError, "a list of likelihoods"),
            (lambda: sg.save_figure(RECTANGLE, "a.png"), InputError, "no picture"),
            (lambda: sg.draw_part("house"), InvalidPartError, "is text"),
            (lambda: sg.draw_part([(0, 0), (1, 1)]), InvalidPartError, "accepted"),
            (lambda: sg.draw_grasp(RECTANGLE, 12.5), FloatRefusedError, "degrees: .*12.5"),
            (
                lambda: sg.draw_beta_density(0, 1),
                PriorError,
                "alpha_1: 0; accepted: numbers above 0",
            ),
            (lambda: sg.draw_beta_density(1, "-1/2"), PriorError, "alpha_2"),
            (lambda: sg.draw_grasp_diagram(RECTANGLE, "-1"), FrictionError, "mu: .* negative"),
            (lambda: sg.draw_squeeze_stability(RECTANGLE, 0.25), FloatRefusedError, "mu"),
            (lambda: sg.draw_push_stability(RECTANGLE, jaw="upper"), InputError, "Jaw.LOWER"),
            (lambda: sg.draw_push_density(RECTANGLE, jaw=1), InputError, "not Jaw"),
            (
                lambda: sg.draw_friction_bounds(RECTANGLE, largest=0),
                FrictionError,
                "largest: 0; accepted: positive",
            ),
            (lambda: sg.draw_open_loop_plans(TEST, 1), InputError, "not PlanningProblem"),
            (lambda: sg.draw_open_loop_plans(COIN, 0), InputError, "0 stages; accepted: whole"),
            (lambda: sg.draw_open_loop_plans(COIN, 7), NodeLimitError, r"2\^7 plans.* at most 81"),
            (lambda: sg.draw_plan_tree(COIN), InputError, "not PlanTree"),
            (lambda: sg.draw_all_plans(COIN), InputError, "not AndOrTree"),
            (lambda: sg.draw_risks(COIN), InputError, "not DecisionProblem"),
            (lambda: sg.draw_risks(TEST, []), InputError, "0 rules; accepted: 1 to 8"),
            (lambda: sg.draw_risks(TEST, 5), InputError, "not Iterable; accepted: a list of rules"),
            (lambda: sg.draw_risks(TEST, [3]), InputError, "3 is of type int"),
            (lambda: sg.draw_sensor_density(1, 1, 5), InputError, "a list of edges"),
            (lambda: sg.draw_tilts(TILTS, 1, 3), InputError, "a list of tilts"),
            (lambda: sg.draw_risks(TEST, [(0,)]), InputError, "rule 1: .* 2 readings"),
            (lambda: sg.draw_risks(TEST, [(0, 2)]), InputError, "rule 1: .* 0 to 1"),
            (lambda: sg.draw_risks(TEST, [{"pass": "keep"}]), InputError, "no answer"),
            (lambda: sg.draw_sensor_density(-1, 1), SensorError, "true value: -1; accepted: 0"),
            (lambda: sg.draw_sensor_density(1, 0), SensorError, "sd: 0; accepted: positive"),
            (lambda: sg.draw_sensor_density(1, 1, [2, 2]), SensorError, "edge 2: 2 after 2"),
            (lambda: sg.draw_sensor_density(1, 0.5), FloatRefusedError, "sd"),
            (lambda: sg.draw_tray(RECTANGLE), InputError, "not TraySetup"),
            (lambda: sg.draw_tilting(25), InputError, "25 is of type int, not TraySetup"),
            (lambda: sg.draw_tilts(COIN, 1, []), InputError, "not TransitionModel"),
            (lambda: sg.draw_tilts(TILTS, 13, []), RecordingError, "13"),
            (lambda: sg.draw_tilts(TILTS, 1, [0]), RecordingError, "0"),
            (
                lambda: sg.draw_tilts(
                    sg.TransitionModel(sg.TransitionCounts([[[1, 1], [0, 2]]]), alpha=1), 1, [1]
                ),
                InputError,
                "2 states; accepted: the 12",
            ),
            (lambda: sg.draw_radius(sg.Part(RECTANGLE, (9, 9))), CenterOfMassError, "inside"),
            (
                lambda: sg.draw_phase_one(sg.squeeze_function(RECTANGLE), 3),
                InputError,
                "3 steps; accepted: 1 to 2",
            ),
            (
                lambda: sg.draw_analysis(sg.FeedingProblem(RECTANGLE), []),
                InputError,
                "0 axes; accepted: 3",
            ),
            (
                lambda: sg.draw_push_grasp_analysis(RECTANGLE, []),
                InputError,
                "0 axes; accepted: 6",
            ),
        ],
    )
    def test_bad_input(self, call, error, message):
        with pytest.raises(error, match=message):
            call()

    @pytest.mark.parametrize(
        ("call", "message"),
        [
            (lambda n: sg.draw_diameter([(0, 0), (n, 0), (0, n)]), "Part.scale"),
            (lambda n: sg.draw_radius([(0, 0), (n, 0), (0, n)]), "Part.scale"),
            (lambda n: sg.draw_beta_density(n, 1), "alpha_1"),
            (lambda n: sg.draw_beta_density(1, n), "alpha_2"),
            (lambda n: sg.draw_friction_bounds(RECTANGLE, largest=n), "largest"),
            (lambda n: sg.draw_sensor_density(n, 1), "true value"),
            (lambda n: sg.draw_sensor_density(1, n), "sd"),
            (lambda n: sg.draw_sensor_density(1, 1, [n, 10**500]), "edge 1"),
            (lambda n: sg.draw_risks(loss_of(n)), "risk"),
        ],
    )
    @pytest.mark.parametrize("number", [10**400, "1e-400"])
    def test_numbers_that_floats_do_not_hold_are_refused(self, call, message, number):
        with pytest.raises(NumberLimitError, match=message):
            call(number)

    def test_a_deviation_too_small_to_be_seen_beside_its_value_is_refused(self):
        with pytest.raises(SensorError, match=r"sd: 1e-30 beside .* accepted"):
            sg.draw_sensor_density(1, "1e-30")

    @pytest.mark.parametrize("name", ["picture.bmp", "picture", "picture.svg.gz"])
    def test_other_endings_are_refused(self, name, tmp_path):
        with pytest.raises(InputError, match=r"accepted: \.pdf, \.png, \.svg"):
            sg.save_figure(sg.draw_gripper(), tmp_path / name)

    def test_a_missing_folder(self, tmp_path):
        with pytest.raises(WriteError, match="writable folder"):
            sg.save_figure(sg.draw_gripper(), tmp_path / "no" / "a.png")

    def test_after_an_error_the_old_file_stands(self, tmp_path, monkeypatch):
        path = tmp_path / "a.svg"
        path.write_text("old")
        monkeypatch.setattr("pathlib.Path.replace", no_room)
        with pytest.raises(WriteError, match="no room"):
            sg.save_figure(sg.draw_gripper(), path)
        assert path.read_text() == "old"
        assert [p.name for p in tmp_path.iterdir()] == ["a.svg"]

    def test_a_file_is_readable_by_those_the_mask_allows(self, tmp_path):
        path = sg.save_figure(sg.draw_gripper(), tmp_path / "a.SVG")
        mask = os.umask(0)
        os.umask(mask)
        assert stat.S_IMODE(path.stat().st_mode) == 0o666 & ~mask


def no_room(*_):
    raise OSError(28, "no room")


def overlaps(ax) -> list[tuple[str, str]]:
    """Return the pairs of texts on axes, ticks included, whose drawn boxes share space."""
    ax.get_figure().draw_without_rendering()
    texts = [t for t in (*ax.texts, *ax.get_xticklabels(), *ax.get_yticklabels()) if t.get_text()]
    if not ax.axison:
        texts = list(ax.texts)
    boxes = [(text.get_text(), text.get_window_extent()) for text in texts]
    return [
        (a, b)
        for k, (a, one) in enumerate(boxes)
        for b, other in boxes[k + 1 :]
        if min(one.x1, other.x1) - max(one.x0, other.x0) > 0.5
        and min(one.y1, other.y1) - max(one.y0, other.y0) > 0.5
    ]
