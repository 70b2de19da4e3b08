"""The benchmarks run, and what they compare gives the same answer. Nothing is timed here."""

from __future__ import annotations

import doctest
import json

import numpy as np
import pytest

from benchmarks import float_program, growth, harness, naive_program, outlines, report
from benchmarks.__main__ import NAMES, load, main, title
from benchmarks.large_outline import AGREEMENT, OUTLINES, disagreement, library_squeeze
from benchmarks.small_part import HOOK, OVAL
from stochgeom import Part, preimages
from tests.repo.sources import ROOT

FOLDER = ROOT / "benchmarks"
each_benchmark = pytest.mark.parametrize("name", NAMES)


@each_benchmark
def test_a_benchmark_runs(name):
    found = load(name).run(quick=True)
    figures = [row for row in found.rows if not isinstance(row, str)]
    assert found.name == name
    assert figures
    assert all(np.isfinite(row.value) for row in figures)
    assert found.text().startswith(name)
    assert len(json.loads(json.dumps(found.as_json()))["rows"]) == len(figures)


@each_benchmark
def test_a_benchmark_states_the_growth_it_expects(name):
    assert title(load(name))
    assert "Expected:" in load(name).__doc__


@each_benchmark
def test_the_figures_of_a_benchmark_stand_beside_its_command(name):
    assert f"make bench ARGS={name}\n" in (FOLDER / "README.md").read_text(encoding="utf-8")


def test_every_benchmark_is_listed():
    modules = (path for path in FOLDER.glob("*.py") if path.stem != "__init__")
    runnable = {path.stem for path in modules if "\ndef run(" in path.read_text(encoding="utf-8")}
    assert runnable == set(NAMES)


class TestTheCommand:
    def test_list_names_all(self, capsys):
        assert main(["--list"]) == 0
        listed = capsys.readouterr().out.splitlines()
        assert [line.split()[0] for line in listed] == list(NAMES)

    def test_json_is_json(self, capsys):
        assert main(["nonconvex", "--quick", "--json"]) == 0
        printed = json.loads(capsys.readouterr().out)
        assert [one["name"] for one in printed["benchmarks"]] == ["nonconvex"]
        assert {"processor", "python", "packages", "load", "pace"} == set(printed["machine"])

    def test_an_unknown_name_is_refused(self, capsys):
        with pytest.raises(SystemExit) as stop:
            main(["large_outlines"])
        assert stop.value.code == 2
        assert "large_outline" in capsys.readouterr().err


class TestWhatIsCompared:
    @pytest.mark.parametrize("n", [10, 99, 1_000, 10_000])
    @pytest.mark.parametrize("name", OUTLINES)
    def test_the_float_program_agrees_with_the_library(self, name, n):
        outline = OUTLINES[name](n)
        assert disagreement(library_squeeze(outline), float_program.squeeze(outline)) < AGREEMENT

    def test_disagreement_is_noticed(self):
        outline = outlines.near_circle(99, seed=1)
        transfer, steps = library_squeeze(outline), float_program.squeeze(outline)
        other = steps._replace(values=steps.values + 1e-6)
        assert disagreement(transfer, other) > AGREEMENT
        assert disagreement(transfer, float_program.Steps(*(a[:-1] for a in steps))) == np.inf

    def test_the_float_program_finds_every_width_to_the_period(self):
        outline = outlines.near_circle(99, seed=1)
        plain = float_program.PhaseOne(float_program.squeeze(outline))
        while not plain.complete:
            plain.advance()
        exact = [preimage.width.to_float() for preimage in preimages(library_squeeze(outline))]
        assert np.abs(np.array(plain.widths) - np.array(exact)).max() < AGREEMENT

    def test_the_float_program_refuses_what_is_not_convex(self):
        with pytest.raises(ValueError, match="not a strictly convex"):
            float_program.squeeze(outlines.star(20, seed=1))

    @pytest.mark.parametrize("seed", range(3))
    def test_the_naive_program_equals_the_library(self, seed):
        outline = outlines.near_circle(31, seed=seed)
        transfer = library_squeeze(outline)
        breaks, values = naive_program.squeeze(outline)
        assert (tuple(breaks), tuple(values)) == (transfer.breaks.angles, transfer.values.angles)
        exact = [preimage.width for preimage in preimages(transfer)]
        assert naive_program.widths(breaks, values, len(exact)) == exact


class TestTheOutlines:
    @pytest.mark.parametrize("n", [1_000, 100_000])
    @pytest.mark.parametrize("name", OUTLINES)
    def test_large_ones_are_strictly_convex(self, name, n):
        outline = OUTLINES[name](n)
        assert len(Part(outline).hull) == len(outline) == n
        assert outline.dtype == np.int64
        assert int(abs(outline).max()) < 2**41

    def test_the_largest_one_is_strictly_convex(self):
        outline = outlines.near_circle(growth.SIZES[-1], seed=4, radius=growth.RADIUS)
        assert len(Part(outline).hull) == growth.SIZES[-1]

    def test_stars_have_half_their_vertices_on_the_hull(self):
        assert len(Part(outlines.star(300, seed=5)).hull) == 150

    def test_small_ones_have_the_vertices_asked_for(self):
        assert len(Part(OVAL).hull) == len(OVAL) == len(HOOK) == 10
        assert len(Part(HOOK).hull) < 10
        for seed in range(20):
            assert len(Part(outlines.small_convex(10, seed)).hull) == 10
            assert len(Part(outlines.small_star(10, seed))) == 10

    def test_the_same_seed_gives_the_same_outline(self):
        for make in (outlines.near_circle, outlines.star, outlines.small_convex):
            assert (make(10, 7) == make(10, 7)).all()
            assert not (make(10, 7) == make(10, 8)).all()


def test_peak_memory_is_that_of_this_process():
    held = np.ones(10_000_000)
    assert held.nbytes < growth.peak_memory() < 100 * held.nbytes


@pytest.mark.parametrize("module", [harness, report])
def test_examples_of_the_harness(module):
    assert doctest.testmod(module).failed == 0
