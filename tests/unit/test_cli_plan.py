"""``stochgeom plan``: what people read, and what machines read."""

from __future__ import annotations

import json
import re
from fractions import Fraction
from math import cos, sin, tau

import pytest

from stochgeom.cli.plan_text import MOST_ROWS, plan_text, sentence
from stochgeom.exact.angles import Angle
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import preimages
from stochgeom.thesis.parts import catalogue_names
from stochgeom.transfer.step_function import StepFunction
from tests.commands import call
from tests.plan_documents import check_document

SQUARE = "0,0 1,0 1,1 0,1"
RECTANGLE = "0,0 3,0 3,2 0,2"
NARROW = "2,7 4,1 7,5 7,8"
"""An action of its plans works for (48.1798, 48.3665] degrees only."""

HOUSE = """\
house: 5 vertices, 5 on the convex hull
squeeze function: 2 steps in a period of 180.0000 degrees, 4 stable orientations in a full turn

Stochastically optimal plan
  step  rotate gripper by  works for  states left  probability
     1             random  any angle            4       0.3976

Shortest plan that orients the part up to symmetry
  step  rotate gripper by           works for  states left  probability
     1             random           any angle            4       0.3976
     2            45.0000  (18.4350, 71.5650]            2       0.5000

Angles are degrees counter-clockwise, each relative to the gripper's last pose; ranges
are rounded inwards, so they work as printed. Up to symmetry means: of the
squeeze function, which cannot tell those orientations apart.

The 1-step plan bears any gripper error: its only turn is random.
The 2-step plan bears every gripper error below 26.5650 degrees.

Best plan of each length (a filter pass costs 1 squeeze time)
  steps  collapsed arc  probability  expected cost
      1       143.1301       0.3976  5.0304 <- least
      2       180.0000       0.5000  6.0000

1 squeeze brings this part into one orientation with probability 0.3976; expected cost 5.03 \
squeeze times: 2.52 squeezes and 2.52 filter passes.
If the filter accepts either of the 2 equivalent orientations: 2.52 squeeze times.

2 squeezes orient this part up to its 180 degree symmetry; expected cost 6.00 squeeze times: \
4 squeezes and 2 filter passes.
If the filter accepts either of the 2 equivalent orientations: 3.00 squeeze times.
"""


def report(capsys, *arguments):
    result = call(capsys, "plan", *arguments)
    assert (result.code, result.err) == (0, "")
    return result.out


def sentences(text):
    return [line for line in text.splitlines() if "expected cost " in line and ";" in line]


class TestForPeople:
    def test_the_house_literally(self, capsys):
        assert report(capsys, "house") == HOUSE

    @pytest.mark.parametrize("name", catalogue_names())
    @pytest.mark.parametrize("cost_ratio", ["0", "1/3", "1", "50"])
    def test_the_shape(self, capsys, name, cost_ratio):
        text = report(capsys, name, "--cost-ratio", cost_ratio)
        blocks = text.rstrip("\n").split("\n\n")
        assert blocks[0].startswith(f"{name}: ")
        tables = [block for block in blocks if "\n  step " in block]
        for block in tables:
            first, *others = block.splitlines()[2:]
            assert first.split()[:4] == ["1", "random", "any", "angle"]
            for step, row in enumerate(others, start=2):
                match = re.fullmatch(
                    r" +(\d+) +(-?\d+\.\d{4}) +\((-?\d+\.\d{4}), (-?\d+\.\d{4})\] +(\d+) +0\.\d{4}",
                    row,
                )
                assert match is not None, row
                assert int(match[1]) == step
                assert float(match[3]) < float(match[2]) <= float(match[4])
        costs = next(block for block in blocks if block.startswith("Best plan of each length"))
        assert costs.count("<- least") == 1
        same = "also the shortest" in text
        assert len(tables) == len(sentences(text)) == (1 if same else 2)
        assert not any(line.endswith(" ") for line in text.splitlines())

    def test_states_left_decrease_to_the_order_of_symmetry(self, capsys):
        text = report(capsys, "key")
        block = next(b for b in text.split("\n\n") if b.startswith("Shortest plan"))
        assert [row.split()[-2] for row in block.splitlines()[2:]] == ["8", "6", "2"]

    def test_digits(self, capsys):
        # Inwards: the range is 18.4349488229220107... to 71.5650511770779893...
        assert "(19, 71]" in report(capsys, "house", "--digits", "0")
        assert "(18.434948822923, 71.565051177077]" in report(capsys, "house", "--digits", "12")

    def test_a_part_without_a_name(self, capsys):
        text = report(capsys, "--vertices", SQUARE)
        assert text.startswith("part: 4 vertices, 4 on the convex hull\n")

    def test_one_step_is_singular(self, capsys):
        assert "squeeze function: 1 step in a period of 90.0000 degrees, 4 stable" in report(
            capsys, "--vertices", SQUARE
        )

    @pytest.mark.parametrize(
        ("holes", "words"),
        [
            ("(1 1, 2 1, 2 2, 1 1)", "1 hole: jaws touch the convex hull only, so "),
            ("(1 1, 2 1, 2 2, 1 1), (3 3, 3.5 3, 3 3.5, 3 3)", "2 holes: jaws touch the "),
        ],
    )
    def test_holes_are_told_of(self, capsys, tmp_path, holes, words):
        path = tmp_path / "frame.wkt"
        path.write_text(f"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), {holes})")
        text = report(capsys, str(path))
        assert text.splitlines()[2].startswith(words)
        assert text.splitlines()[2].endswith("shift the uniform centroid")
        assert "hole" not in report(capsys, "house")

    def test_long_tables_are_cut_but_show_the_least_cost(self):
        transfer, length = ladder(60)
        problem = ladder_problem(transfer)
        text = plan_text(problem, problem.plan_of(30), problem.geometric_plan(), 4)
        assert length == 60
        costs = next(b for b in text.split("\n\n") if b.startswith("Best plan of each length"))
        steps = [row.split()[0] for row in costs.splitlines()[2:]]
        half = MOST_ROWS // 2
        first = [str(k) for k in range(1, half + 1)]
        last = [str(k) for k in range(60 - half + 1, 61)]
        assert steps == [*first, "...", "30", "...", *last]
        assert "<- least" in next(row for row in costs.splitlines() if row.startswith("     30 "))
        plan = next(b for b in text.split("\n\n") if b.startswith("Shortest plan"))
        assert [row.split()[0] for row in plan.splitlines()[2:]] == [*first, "...", *last]

    @pytest.mark.parametrize("digits", [0, 3])
    def test_what_is_printed_works(self, capsys, digits):
        """The seven-sided part has ranges that four decimals cannot show."""
        corners = [
            (round(1000 * cos(k * tau / 7)), round(1000 * sin(k * tau / 7))) for k in range(7)
        ]
        outline = " ".join(f"{x},{y}" for x, y in corners)
        text = report(capsys, "--vertices", outline, "--digits", str(digits))
        plan = FeedingProblem(corners).geometric_plan()
        printed = re.findall(r"(-?[0-9.]+) +\((-?[0-9.]+), (-?[0-9.]+)\]", text)
        assert len(printed) == plan.steps - 1 == 6
        for action, texts in zip(plan.actions[1:], printed, strict=True):
            angle, low, high = (Angle.from_degrees(number) for number in texts)
            assert action.low <= low < angle <= high <= action.high


def ladder(count):
    """Return a step function with many preimages, and how many.

    The steps are equally wide but for the last, which is twice as wide; the values lie a little
    farther apart than the breaks, so that a preimage gains one step on the one before.
    """
    width = Fraction(180, count + 1)
    breaks = [Angle.from_degrees(k * width) for k in range(count)]
    values = [Angle.from_degrees((k + Fraction(k + 1, 2 * count)) * width) for k in range(count)]
    transfer = StepFunction(breaks, values, Angle.from_degrees(180))
    return transfer, len(list(preimages(transfer)))


def ladder_problem(transfer):
    problem = FeedingProblem([(0, 0), (1, 0), (0, 1)])
    problem.__dict__["transfer"] = transfer
    return problem


UP_TO_180 = "{} squeezes orient this part up to its 180 degree symmetry"
ONE_OF_TWO = "{} squeezes bring this part into one orientation with probability {}"


def joined(what, cost):
    """Return the sentence that says what a plan does and what it costs."""
    return f"{what}; expected cost {cost.replace(':', ' squeeze times:')}."


class TestSentence:
    """The one line of plain words."""

    @pytest.mark.parametrize(
        ("arguments", "parts"),
        [
            (["rectangle"], [(UP_TO_180.format(2), "6.00: 4 squeezes and 2 filter passes")]),
            (["4gon"], [(UP_TO_180.format(4), "10.00: 8 squeezes and 2 filter passes")]),
            (
                ["--vertices", "0,0 1,0 0,1"],
                [
                    (
                        "1 squeeze orients this part up to its 180 degree symmetry",
                        "4.00: 2 squeezes and 2 filter passes",
                    )
                ],
            ),
            (
                ["--vertices", SQUARE],
                [
                    (
                        "1 squeeze orients this part up to its 90 degree symmetry",
                        "8.00: 4 squeezes and 4 filter passes",
                    )
                ],
            ),
            (
                ["key"],
                [
                    (ONE_OF_TWO.format(2, 0.4873), "6.16: 4.10 squeezes and 2.05 filter passes"),
                    (UP_TO_180.format(3), "8.00: 6 squeezes and 2 filter passes"),
                ],
            ),
            (
                ["rectangle", "--cost-ratio", "5/2"],
                [(UP_TO_180.format(2), "9.00: 4 squeezes and 2 filter passes at 5/2 each")],
            ),
            (
                ["triangle", "--cost-ratio", "0"],
                [
                    (
                        "1 squeeze brings this part into one orientation with probability 0.2098",
                        "4.77: 4.77 squeezes and 4.77 filter passes at 0 each",
                    ),
                    (UP_TO_180.format(3), "6.00: 6 squeezes and 2 filter passes at 0 each"),
                ],
            ),
            (
                ["rectangle", "--cost-ratio", "1/3"],
                [
                    (
                        "1 squeeze brings this part into one orientation with probability 0.3128",
                        "4.26: 3.20 squeezes and 3.20 filter passes at 1/3 each",
                    ),
                    (UP_TO_180.format(2), "4.67: 4 squeezes and 2 filter passes at 1/3 each"),
                ],
            ),
        ],
    )
    def test_literally(self, capsys, arguments, parts):
        assert sentences(report(capsys, *arguments)) == [joined(*both) for both in parts]

    @pytest.mark.parametrize(
        ("arguments", "words"),
        [
            (["rectangle"], "either of the 2 equivalent orientations: 3.00 squeeze times."),
            (["--vertices", SQUARE], "any of the 4 equivalent orientations: 2.00 squeeze times."),
        ],
    )
    def test_a_filter_that_accepts_any_equivalent_orientation(self, capsys, arguments, words):
        assert report(capsys, *arguments).endswith(f"\nIf the filter accepts {words}\n")

    def test_the_price_of_a_filter_pass(self, capsys):
        for ratio, words in [("1", "1 squeeze time"), ("0", "0 squeeze times"), ("0.25", "1/4 s")]:
            text = report(capsys, "house", "--cost-ratio", ratio)
            assert f"Best plan of each length (a filter pass costs {words}" in text

    @pytest.mark.parametrize(
        ("order", "how", "cost"),
        [
            (1, "uniquely", "2.00: 1 squeeze and 1 filter pass"),
            (3, "up to its 120 degree symmetry", "6.00: 3 squeezes and 3 filter passes"),
            (32, "up to its 11.25 degree symmetry", "64.00: 32 squeezes and 32 filter passes"),
        ],
    )
    def test_other_periods(self, order, how, cost):
        period = Angle.from_turns(Fraction(1, order))
        transfer = StepFunction([Angle()], [Angle.from_degrees(1)], period)
        plan = FeedingPlan(transfer, list(preimages(transfer)), 1)
        assert sentence(plan) == joined(f"1 squeeze orients this part {how}", cost)


class TestForMachines:
    @pytest.mark.parametrize("name", catalogue_names())
    def test_the_document_keeps_the_contract(self, capsys, name):
        result = call(capsys, "plan", name, "--json")
        assert (result.code, result.err) == (0, "")
        check_document(result.document)

    @pytest.mark.parametrize("digits", [0, 12])
    @pytest.mark.parametrize("cost_ratio", ["0", "1/3", "2.5"])
    def test_options(self, capsys, digits, cost_ratio):
        result = call(
            capsys, "plan", "4gon", "--json", "--digits", str(digits), "--cost-ratio", cost_ratio
        )
        check_document(result.document, digits, Fraction(cost_ratio))

    @pytest.mark.parametrize("whole", [True, False], ids=["document", "its part"])
    def test_the_document_is_a_source(self, capsys, tmp_path, whole):
        first = call(capsys, "plan", "key", "--json")
        path = tmp_path / "plan.json"
        path.write_text(first.out if whole else json.dumps(first.document["part"]))
        assert call(capsys, "plan", str(path), "--json").out == first.out

    @pytest.mark.parametrize("given", [["--vertices", RECTANGLE], [f"--vertices={RECTANGLE}"]])
    def test_vertices(self, capsys, given):
        expected = call(capsys, "plan", "rectangle", "--json").document
        expected["part"]["name"] = None
        assert call(capsys, "plan", *given, "--json").document == expected

    @pytest.mark.parametrize("option", [["--center-of-mass", "-1,2"], ["--center-of-mass=-1,2"]])
    @pytest.mark.parametrize("source", [["house"], ["--vertices", RECTANGLE]])
    def test_center_of_mass(self, capsys, source, option):
        document = call(capsys, "plan", *source, *option, "--json").document
        assert document["part"]["center_of_mass"] == ["-1", "2"]
        plain = call(capsys, "plan", *source, "--json").document
        assert document["plan"] == plain["plan"]

    def test_holes_move_the_centroid_only(self, capsys, tmp_path):
        path = tmp_path / "frame.wkt"
        path.write_text("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))")
        document = call(capsys, "plan", str(path), "--json").document
        # (16 (2, 2) - (3/2, 3/2)) / 15
        assert document["part"]["center_of_mass"] == ["61/30", "61/30"]
        assert len(document["part"]["holes"]) == 1
        square = call(capsys, "plan", "--vertices", "0,0 4,0 4,4 0,4", "--json").document
        assert document["plan"] == square["plan"]
        check_document(document)

    def test_the_document_is_ascii(self, capsys, tmp_path):
        path = tmp_path / "part.json"
        path.write_text(
            '{"name": "Gehäuse", "vertices": [[0, 0], [1, 0], [0, 1]]}', encoding="utf-8"
        )
        result = call(capsys, "plan", str(path), "--json")
        assert result.out.isascii()
        assert result.document["part"]["name"] == "Gehäuse"
