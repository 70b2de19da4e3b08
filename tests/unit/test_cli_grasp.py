"""``stochgeom grasp`` and the tables of chapter 3 and appendix C on the command line."""

from __future__ import annotations

from dataclasses import replace

import pytest

from stochgeom.cli import table_command
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.sums import AngleSum
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.thesis.grasp_tables import table_c_1
from stochgeom.thesis.parts import catalogue_part
from stochgeom.thesis.tables import Cell
from tests.commands import call

RECTANGLE = """\
rectangle: 4 vertices, 4 on the convex hull, centre of mass (3/2, 1)
friction: mu = 1/4, friction angle 14.0362 degrees
pushed by the lower jaw: stable at 0.0000, 90.0000, 180.0000, 270.0000;
  unstable at 56.3099, 123.6901, 236.3099, 303.6901

Stable orientations
  orientation  lower edge  upper edge  held by  ends here at least
       0.0000         0-1         2-3    shape              0.3022
      90.0000         3-0         1-2    shape              0.1680
     180.0000         2-3         0-1    shape              0.3022
     270.0000         1-2         3-0    shape              0.1680

Wedged
          orientations  between vertices
    (42.2737, 70.3461)              0, 2
  (109.6539, 137.7263)              3, 1
  (222.2737, 250.3461)              2, 0
  (289.6539, 317.7263)              1, 3

Guaranteed to end stable, whichever jaw touches first and however far it pushes:
  [70.3462, 109.6538]
  [137.7264, 222.2736]
  [250.3462, 289.6538]
  [317.7264, 402.2736]
Largest tolerance: an orientation known to at most 42.2736 degrees (rounded down),
  with the gripper turned by 0.0000, 180.0000 degrees from the part's input pose

A random grasp ends stable with a probability of at least
  whatever the push does (Eq. 3.13)                    0.6881
    turning into a wedging interval counted as wedged  0.6881
  every length of the push equally likely (App. C)     0.9404

Orientations are degrees counter-clockwise of the part relative to the gripper, whose jaws
are parallel to the x axis. A square bracket takes the end in, a round one leaves it out.
"""


def grasp(capsys, *arguments, code=0):
    result = call(capsys, "grasp", *arguments)
    assert (result.code, result.err) == (code, "")
    return result.out


def document(capsys, *arguments, code=0):
    result = call(capsys, "grasp", *arguments, "--json")
    assert (result.code, result.err) == (code, "")
    return result.document


def refusal(capsys, *arguments):
    result = call(capsys, "grasp", *arguments)
    assert (result.code, result.out) == (2, "")
    assert result.err.count("\n") == 1
    return result.err


def angle(value):
    return Angle(value["turns"], tuple(int(text) for text in value["direction"]))


class TestText:
    def test_the_rectangle_literally(self, capsys):
        assert grasp(capsys, "rectangle", "--mu", "0.25") == RECTANGLE

    def test_intervals_are_rounded_inwards(self, capsys):
        """From 70.346175... to 109.653824..."""
        found = grasp(capsys, "rectangle", "--mu", "0.25", "--digits", "1")
        assert "  [70.4, 109.6]\n" in found

    def test_nothing_guaranteed(self, capsys):
        found = grasp(capsys, "triangle", "--mu", "1/20")
        assert "No orientation is guaranteed to end stable" in found
        assert "Largest tolerance" not in found

    def test_no_friction(self, capsys):
        found = grasp(capsys, "house", "--mu", "0")
        assert "Wedged: in no orientation." in found
        assert "Every orientation is guaranteed to end stable" in found
        assert found.count("1.0000") >= 3

    def test_a_tolerance(self, capsys):
        found = grasp(capsys, "rectangle", "--mu", "0.25", "--tolerance", "10")
        assert "An error of 10.0000 degrees either way is borne by the gripper turned by" in found
        lacking = grasp(capsys, "rectangle", "--mu", "0.25", "--tolerance", "43", code=1)
        assert "No grasp bears an error of 43.0000 degrees." in lacking
        whole = grasp(capsys, "rectangle", "--mu", "0", "--tolerance", "180")
        assert "any tolerance" in whole

    def test_a_prior_and_a_probability(self, capsys):
        options = ["--mu", "1/4", "--prior", "normal:0,5", "--probability", "9/10"]
        found = grasp(capsys, "rectangle", *options)
        assert "under the prior: normal, mean 0.0000°, standard deviation 5.0000°  1.0000" in found
        assert "Largest mu for a probability of at least 9/10, rounded down" in found
        assert "  whatever the push does       0.0787\n" in found

    def test_the_limit_is_told_where_it_is_not_1(self, capsys):
        found = grasp(capsys, "house", "--mu", "1/4", "--probability", "9/10")
        assert "As mu goes to 0 the bound whatever the push does goes to 0.5000;" in found
        assert "As mu" not in grasp(capsys, "rectangle", "--mu", "1/4", "--probability", "9/10")

    def test_any_friction(self, capsys):
        assert "  any\n" in grasp(capsys, "triangle", "--mu", "1", "--probability", "0")

    def test_a_very_long_mu(self, capsys):
        lines = grasp(capsys, "house", "--mu", "1e500").splitlines()
        assert lines[1] == (
            "friction: mu = 1000000000000000... (501 characters), friction angle 90.0000 degrees"
        )

    def test_a_friction_angle(self, capsys):
        found = grasp(capsys, "house", "--friction-angle", "20")
        assert "friction: mu = 0.3640, friction angle 20.0000 degrees" in found

    def test_long_tables_are_cut(self, capsys):
        text = " ".join(f"{x},{y}" for x, y in _convex(25))
        found = grasp(capsys, "--vertices", text, "--mu", "1000")
        assert "more; --json has all of them" in found


def _convex(m):
    """Return 2 m integer points of a parabola and of its image half a turn on."""
    there = [(k, k * k) for k in range(m + 1)]
    return there + [(m - k, m * m - k * k) for k in range(1, m)]


class TestDocument:
    def test_keys_and_exact_values(self, capsys):
        found = document(capsys, "rectangle", "--mu", "0.25")
        diagram = GraspDiagram(catalogue_part("rectangle"), "1/4")
        assert found["schema"] == "stochgeom/grasp/1"
        assert found["mu"] == "1/4"
        assert angle(found["friction_angle"]) == Angle(0, (4, 1))
        assert (found["bound"], found["strict_bound"], found["pushing_bound"]) == (
            "0.6881",
            "0.6881",
            "0.9404",
        )
        assert AngleSum(0, [(1, angle(found["bound_angle"]))]).compare(diagram.bound) == 0
        starts = [angle(item["start"]) for item in found["strong_preimage"]]
        widths = [angle(item["width"]) for item in found["strong_preimage"]]
        expected = diagram.guaranteed.intervals()
        assert starts == [item.start for item in expected]
        assert widths == [item.width for item in expected]
        assert found["strong_preimage_points"] == []
        assert len(found["wedged"]) == 4
        assert found["largest_tolerance"]["degrees"] == "42.2736"  # 42.27368..., rounded down
        assert angle(found["wedged"][0]["width"]) == 2 * Angle(0, (4, 1))

    def test_the_tolerance_is_exact_when_doubled(self, capsys):
        found = document(capsys, "5gon", "--mu", "0.25")
        tolerance, grasp_angle = found["largest_tolerance"], found["grasp_angle"]
        assert tolerance["attained"] is True
        widest = GraspDiagram(catalogue_part("5gon"), "1/4").guaranteed.widest()[0]
        assert angle(tolerance["doubled"]) == widest.width
        assert tolerance["turns"] is None
        middle = widest.start + widest.end
        assert not (angle(grasp_angle["doubled"]) + middle).reduced()
        assert 0 <= float(grasp_angle["degrees"]) < 360

    def test_nothing_guaranteed(self, capsys):
        found = document(capsys, "triangle", "--mu", "0.25")
        assert found["largest_tolerance"] is found["grasp_angle"] is None
        assert found["strong_preimage"] == found["grasp_angles"] == []
        assert found["bound"] == "0.0000"

    def test_no_friction(self, capsys):
        found = document(capsys, "house", "--mu", "0")
        assert found["wedged"] == []
        assert angle(found["bound_angle"]) == FULL_TURN
        assert found["bound"] == found["pushing_bound"] == "1.0000"

    def test_what_else_is_asked(self, capsys):
        options = ["--tolerance", "10", "--prior", "normal:0,5", "--probability", "0.9"]
        found = document(capsys, "rectangle", "--mu", "0.25", *options)
        assert found["tolerance"]["guaranteed"] is True
        assert angle(found["tolerance"]["asked"]) == Angle.from_degrees(10)
        assert len(found["tolerance"]["grasps"]) == 4
        assert found["prior_bound"] == "1.0000"
        assert found["largest_mu"]["bound"]["mu"] == "0.0787"
        assert found["largest_mu"]["bound_limit"] == "1.0000"
        lacking = document(capsys, "rectangle", "--mu", "0.25", "--tolerance", "43", code=1)
        assert lacking["tolerance"] == {
            "asked": lacking["tolerance"]["asked"],
            "guaranteed": False,
            "grasps": [],
            "grasps_points": [],
        }

    def test_a_tolerance_that_leaves_single_orientations(self, capsys):
        """90 degrees less 2 x arctan 1: the square's intervals shrink to the orientations 90 k."""
        square = ["--vertices", "0,0 1,0 1,1 0,1", "--mu", "0"]
        assert document(capsys, *square, "--tolerance", "180")["tolerance"]["guaranteed"]
        found = document(
            capsys, "--vertices", "0,0 1,0 1,1 0,1", "--friction-angle", "15", "--tolerance", "30"
        )
        assert [p["degrees"] for p in found["tolerance"]["grasps_points"]] == [
            "0.0000",
            "90.0000",
            "180.0000",
            "270.0000",
        ]
        assert found["mu"].startswith("0.2679")


class TestBadInput:
    @pytest.mark.parametrize(
        ("options", "words"),
        [
            (["--mu", "-1/4"], "negative; accepted: 0 or more"),
            (["--mu", "-0.1"], "negative; accepted: 0 or more"),
            (["--mu", "nan"], "mu: 'nan' is not a number"),
            (["--mu", "inf"], "mu: 'inf' is not a number"),
            (["--mu", "sqrt(2)"], "mu: 'sqrt(2)' is not a number"),
            (["--mu", ""], "mu: '' is not a number"),
            ([], "neither --mu nor --friction-angle given; accepted: one of them"),
            (["--mu", "1", "--friction-angle", "45"], "both --mu and --friction-angle"),
            (["--friction-angle", "90"], "from 0 to below 90"),
            (["--friction-angle", "-3"], "from 0 to below 90"),
            (["--friction-angle", "x"], "--friction-angle: 'x' is not a number"),
            (["--mu", "1", "--tolerance", "-1"], "tolerance: -1.0000°; accepted: from 0 to 180"),
            (["--mu", "1", "--tolerance", "ten"], "tolerance: 'ten' is not a number"),
            (["--mu", "1", "--probability", "1.5"], "probability 3/2; accepted: from 0 to 1"),
            (["--mu", "1", "--center-of-mass", "9,9"], "outside the convex hull; accepted"),
            (["--mu", "1", "--center-of-mass", "0,-1"], "on the boundary of the convex hull"),
            (["--mu", "1", "--digits", "x"], "--digits"),
            (["--mu", "1", "--prior", "gauss"], "accepted"),
        ],
    )
    def test_refused_with_one_line(self, capsys, options, words):
        assert words in refusal(capsys, "house", *options)

    def test_as_a_document(self, capsys):
        result = call(capsys, "grasp", "house", "--mu", "-1", "--json")
        assert result.code == 2
        assert result.document["error"]["type"] == "FrictionError"
        assert result.document["error"]["where"] == "mu"


class TestTables:
    def test_table_3_1(self, capsys):
        result = call(capsys, "table", "3.1")
        assert (result.code, result.err) == (0, "")
        rows = {line.split()[0]: " ".join(line.split()) for line in result.out.splitlines()[3:12]}
        assert rows["house"] == "house 5 0.3440 [0.34] 0.4365 [0.44] 0.4682 [0.47]"
        assert rows["rectangle"].startswith("rectangle 4 [3](1) 0.6881 [0.69]")
        assert "(1) Tables 3.1 and C.1, rectangle, sides: printed 3; what holds: 4" in result.out

    def test_table_c_1(self, capsys):
        result = call(capsys, "table", "C.1", "--digits", "2")
        assert (result.code, result.err) == (0, "")
        assert "1.00 [0.99](2)" in result.out
        assert "(2) Table C.1, rectangle, mu = .05: printed 0.99" in result.out

    def test_the_document(self, capsys):
        rows = call(capsys, "table", "C.1", "--json").document["rows"]
        cells = {(row["part"], cell["mu"]): cell for row in rows for cell in row["cells"]}
        assert len(cells) == 24
        differing = [place for place, cell in cells.items() if not cell["agrees"]]
        assert differing == [("rectangle", "0.05")]
        assert cells["wrench", "0.25"]["computed"] == "0.6623"

    def test_a_difference_that_nothing_explains_is_a_failed_check(self, capsys, monkeypatch):
        first, *others = table_c_1()
        wrong = replace(first, cells=(Cell(AngleSum("1/2"), "0.59", None), *first.cells[1:]))
        monkeypatch.setitem(table_command._GRASP_TABLES, "C.1", lambda: (wrong, *others))
        result = call(capsys, "table", "C.1")
        assert result.code == 1
        assert "differs, and no erratum explains it" in result.out
