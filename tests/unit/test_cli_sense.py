"""``stochgeom sense``: what people read, what machines read, what is refused."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from stochgeom.cli.main import build_parser
from stochgeom.sensing.sensing_problem import SensingProblem
from stochgeom.sensing.tree_search import NODE_LIMIT
from tests.commands import call
from tests.repo.sources import ROOT

RECTANGLE = "0,0 3,0 3,2 0,2"

PRINTED = """\
house: 4 stable orientations in a full turn
sensor: 1 bit of the distance between the closed jaws, from 2 to 3; normal noise of standard deviation 3/10

Orientations after the random first squeeze, and what the sensor reads there
  orientation  diameter   prior  below 2.5  from 2.5
       0.0000         3  0.1024     0.0478    0.9522
      90.0000         2  0.3976     0.9522    0.0478
     180.0000         3  0.1024     0.0478    0.9522
     270.0000         2  0.3976     0.9522    0.0478

Squeeze, look once, accept
  reading    probability   accept  right with
  below 2.5       0.7670  90.0000      0.4936
  from 2.5        0.2330   0.0000      0.4185
  expected cost 4.2008: a round costs 2 and succeeds with 0.4761. Eq. 7.5 of
  the source, where a part keeps its reading over all rounds: 4.2213.

Best plan of at most 2 moves after the first squeeze
  read diameter
    below 2.5 (0.7670): accept 90.0000° (0.4936)
    from 2.5 (0.2330)
      read diameter
        below 2.5 (0.1953): accept 90.0000° (0.3976)
        from 2.5 (0.8047): accept 0.0000° (0.4952)
  expected cost 4.0855: a round costs 2.0000 and succeeds with 0.4895.

Look first or squeeze first?
  plan                                      expected cost
  first squeeze, up to 1 squeeze, no look          5.0304
  first squeeze, a look, up to 1 squeeze           4.2008
  first squeeze, up to 1 squeeze, a look           4.2008
  first squeeze, up to 2 moves of any kind         4.0855

Orientations and turns are degrees counter-clockwise; costs are in units of one squeeze. Half a turn
apart a part looks the same to gripper and sensor, so no round succeeds with more than 0.5 under a
uniform prior.
"""  # noqa: E501


class TestText:
    def test_a_part_of_the_catalogue(self, capsys):
        result = call(capsys, "sense", "house", "--bits", "1", "--noise", "0.3")
        assert result.code == 0
        assert result.out == PRINTED
        assert result.err == ""

    def test_an_exact_sensor(self, capsys):
        out = call(capsys, "sense", "--vertices", RECTANGLE, "--digits", "2").out
        assert out.startswith(
            "part: 4 stable orientations in a full turn\nsensor: reads the distance"
        )
        assert "  expected cost 4.00: a round costs 2 and succeeds with 0.50." in out

    def test_the_horizon(self, capsys):
        out = call(capsys, "sense", "house", "--horizon", "0").out
        assert "Best plan of at most 0 moves after the first squeeze\n  accept 90.0000°" in out
        assert "Look first" not in out
        one = call(capsys, "sense", "house", "--horizon", "1").out
        assert "With and without a look\n" in one

    def test_costs(self, capsys):
        out = call(
            capsys, "sense", "house", "--cost-ratio", "0", "--sensor-cost", "1/2", "--horizon", "1"
        ).out
        assert "expected cost 3.0000: a round costs 3/2" in out

    def test_a_range_and_a_length_of_noise(self, capsys):
        out = call(capsys, "sense", "house", "--bits", "2", "--range", "1,5", "--sd", "1/8").out
        assert "from 1 to 5; normal noise of standard deviation 1/8" in out
        assert "below 2  2 to 3" in out

    def test_long_trees_and_tables_are_cut(self, capsys):
        out = call(capsys, "sense", "key", "--bits", "7", "--noise", "0.05", "--horizon", "1").out
        assert "  ... and 69 lines more: see --json" in out  # 128 readings and a header, of 60
        assert " readings] (" in out  # of the tree, neighbours that end alike share a line
        assert "128 readings: see --json" in out
        assert len(out.splitlines()) < 110

    def test_out_of_time(self, capsys):
        result = call(capsys, "sense", "4gon", "--bits", "2", "--noise", "0.2", "--time-limit", "0")
        assert result.code == 0
        assert (
            "Not proven optimal: the search was cut short. No plan costs below 2.0000."
            in result.out
        )
        assert "* not proven to be the least" in result.out

    def test_a_prior_from_a_file(self, capsys, tmp_path):
        path = tmp_path / "prior.txt"
        path.write_text("0 1\n90 1\n")
        result = call(capsys, "sense", "--vertices", RECTANGLE, "--prior", str(path))
        assert result.code == 0
        assert "expected cost 2.0000: a round costs 2.0000 and succeeds with 1.0000" in result.out


def test_the_default_limit_is_that_of_the_planner():
    parsed = build_parser().parse_args(["sense", "house"])
    assert int(parsed.node_limit) == NODE_LIMIT


class TestDrawings:
    def test_svg(self, capsys, tmp_path):
        path = tmp_path / "plan.svg"
        call(capsys, "sense", "house", "--tree", str(path))
        texts = [e.text for e in ET.parse(path).iter("{http://www.w3.org/2000/svg}text")]
        assert "read diameter" in texts

    def test_dot(self, capsys, tmp_path):
        path = tmp_path / "plan.dot"
        call(capsys, "sense", "house", "--tree", str(path))
        assert path.read_text().startswith("digraph plan {")


class TestDocument:
    def test_the_contract(self, capsys):
        document = call(
            capsys, "sense", "4gon", "--bits", "2", "--noise", "0.05", "--json"
        ).document
        assert document["schema"] == "stochgeom/sense/1"
        assert set(document) == {
            "schema",
            "part",
            "cost_ratio",
            "sensor",
            "states",
            "actions",
            "one_step",
            "plan",
            "orders",
        }
        sensor = document["sensor"]
        assert sensor["range"] == ["103/2", "1157/20"]
        assert (sensor["bits"], sensor["standard_deviation"]) == (2, "127/400")
        assert len(sensor["likelihood"]) == len(document["states"]) == 8
        assert document["plan"]["proven_optimal"] is True
        assert document["plan"]["expected_cost"] == document["orders"]["mixed"] == "5.0016"
        assert document["one_step"]["equation_7_5"] == "5.5754"

    def test_the_tree_is_the_plan(self, capsys):
        document = call(
            capsys, "sense", "4gon", "--bits", "2", "--noise", "0.05", "--json"
        ).document
        root = document["plan"]["tree"]
        assert root["read"] == "diameter"
        first = root["branches"][0]
        assert first["then"]["act"] in document["actions"]
        assert first["then"]["then"] == {"accept": "78.1113", "probability": "0.5000"}

    def test_likelihoods_are_exact(self, capsys):
        from fractions import Fraction

        document = call(
            capsys, "sense", "house", "--bits", "1", "--noise", "0.3", "--json"
        ).document
        sensor = SensingProblem(
            [(p[0], p[1]) for p in document["part"]["vertices"]], 1, "0.3"
        ).sensor
        for state, row in document["sensor"]["likelihood"].items():
            assert sum(map(Fraction, row)) == 1
            exact = sensor.likelihood[sensor.state_number(state)]
            assert [Fraction(p) for p in row] == [Fraction(p) for p in exact]


BAD = [
    ([], "neither SOURCE nor --vertices given"),
    (["nowhere"], "neither a part of the catalogue nor a file"),
    (["house", "--bits", "11"], "bits: 11; accepted: whole numbers from 0 to 10"),
    (["house", "--bits", "two"], "--bits: 'two'; accepted: whole numbers"),
    (["house", "--noise", "0.1"], "noise without bits"),
    (["house", "--bits", "1", "--noise", "-1"], "standard deviation -1"),
    (["house", "--bits", "1", "--noise", "x"], "noise: 'x' is not a number"),
    (["house", "--bits", "1", "--noise", "0.1", "--sd", "1"], "noise and sd given"),
    (["house", "--bits", "1", "--range", "3,2"], "from 3 to 2; accepted: an increasing pair"),
    (["house", "--bits", "1", "--range", "3"], "--range: '3'; accepted: LOW,HIGH"),
    (["house", "--horizon", "-1"], "--horizon: '-1'; accepted: whole numbers"),
    (["house", "--horizon", "30"], "make a tree of 265288703664880029479731 nodes"),
    (["house", "--node-limit", "5"], "make a tree of 43 nodes; accepted: up to 5"),
    (["house", "--time-limit", "soon"], "--time-limit: 'soon'"),
    (["house", "--sensor-cost", "-1"], "cost of a sensor: '-1'"),
    (["house", "--cost-ratio", "x"], "cost ratio"),
    (["house", "--tree", "plan.png"], "--tree: 'plan.png'; accepted: FILE.svg or FILE.dot"),
    (["house", "--prior", "normal:30,5"], "is not exact"),
    (["house", "--digits", "x"], "--digits: 'x' decimals"),
]


@pytest.mark.parametrize(("arguments", "message"), BAD, ids=[m for _, m in BAD])
def test_bad_input_is_one_line_and_code_2(capsys, arguments, message):
    result = call(capsys, "sense", *arguments)
    assert result.code == 2
    assert result.out == ""
    assert message in result.err
    assert result.err.count("\n") == 1
    document = call(capsys, "sense", *arguments, "--json").document
    assert set(document["error"]) == {"type", "message", "where"}


class TestTheTableOfOrders:
    def test_every_cell_stands_in_the_decision(self, capsys):
        out = call(capsys, "table", "7.2").out
        page = (ROOT / "docs" / "decisions" / "0021-the-jaw-sensor.md").read_text(encoding="utf-8")
        rows = [
            line for line in page.splitlines() if line.startswith(("  rect", "  4gon", "  house"))
        ]
        assert len(rows) == 7
        assert set(rows) <= set(out.splitlines())

    def test_the_document(self, capsys):
        document = call(capsys, "table", "7.2", "--json", "--digits", "2").document
        assert len(document["rows"]) == 12
        assert document["rows"][7] == {
            "part": "4gon",
            "bits": 1,
            "noise": "0.3",
            "blind": "11.98",
            "sense_then_act": "7.42",
            "act_then_sense": "6.30",
            "mixed": "6.30",
        }
