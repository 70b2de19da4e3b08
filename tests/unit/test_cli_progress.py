"""The progress line: late, on a terminal only, and gone afterwards."""

from __future__ import annotations

import io
from types import SimpleNamespace

import pytest

from stochgeom.cli import progress
from stochgeom.cli.progress import DELAY, INTERVAL, Progress
from stochgeom.feeding.problem import FeedingProblem
from tests.commands import call


class Terminal(io.StringIO):
    def isatty(self):
        return True


class Clock:
    def __init__(self):
        self.now = 1000.0

    def monotonic(self):
        return self.now


@pytest.fixture
def clock(monkeypatch):
    clock = Clock()
    monkeypatch.setattr(progress, "time", clock)
    return clock


@pytest.fixture
def terminal(monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr(progress, "sys", SimpleNamespace(stderr=terminal))
    return terminal


def test_nothing_is_shown_for_work_that_is_soon_done(clock, terminal):
    with Progress("work") as line:
        line.show(0.5)
        clock.now += DELAY - 0.01
        line.show(0.9)
    assert terminal.getvalue() == ""


def test_the_line_is_drawn_and_wiped(clock, terminal):
    with Progress("work") as line:
        clock.now += DELAY
        line.show(0.5)
        assert terminal.getvalue() == f"\rwork [{'#' * 15}{' ' * 15}]  50.0%"
    assert terminal.getvalue().endswith("\r\x1b[K")


def test_the_line_is_drawn_now_and_then(clock, terminal):
    with Progress("work") as line:
        clock.now += DELAY
        line.show(0.5)
        line.show(0.6)
        clock.now += INTERVAL
        line.show(0.7)
    assert "60.0%" not in terminal.getvalue()
    assert "70.0%" in terminal.getvalue()


@pytest.mark.parametrize(
    ("share", "text"), [(-1.0, f"[{' ' * 30}]   0.0%"), (1.5, f"[{'#' * 30}] 100.0%")]
)
def test_a_share_out_of_range_is_brought_into_it(clock, terminal, share, text):
    with Progress("work") as line:
        clock.now += DELAY
        line.show(share)
    assert text in terminal.getvalue()


def test_the_line_is_wiped_when_the_work_fails(clock, terminal):
    def work():
        with Progress("work") as line:
            clock.now += DELAY
            line.show(0.5)
            raise RuntimeError

    with pytest.raises(RuntimeError):
        work()
    assert terminal.getvalue().endswith("\r\x1b[K")


@pytest.mark.parametrize("stream", [io.StringIO(), None])
def test_nothing_is_shown_where_nobody_looks(clock, monkeypatch, stream):
    monkeypatch.setattr(progress, "sys", SimpleNamespace(stderr=stream))
    with Progress("work") as line:
        clock.now += DELAY
        line.show(0.5)
    assert stream is None or stream.getvalue() == ""


def test_all_of_phase_one_is_under_the_line(capsys, monkeypatch):
    events = []
    usual = FeedingProblem.optimal_plan
    monkeypatch.setattr(Progress, "show", lambda _, share: events.append(share))
    monkeypatch.setattr(
        FeedingProblem, "optimal_plan", lambda *given: events.append("plan") or usual(*given)
    )
    assert call(capsys, "plan", "4gon").code == 0
    assert events[-2:] == [1.0, "plan"]
    assert len(events) == 5


@pytest.mark.parametrize("form", ["lines", "json"])
def test_a_large_prior_is_read_with_progress(clock, terminal, monkeypatch, tmp_path, capsys, form):
    degrees = [str(k * 7 % 360) for k in range(2000)]
    path = tmp_path / "prior"
    as_json = f'{{"kind": "measurements", "degrees": [{", ".join(degrees)}]}}'
    path.write_text("\n".join(degrees) if form == "lines" else as_json)
    shares = []

    def show(line, share):
        shares.append(share)
        clock.now += DELAY
        draw(line, share)

    draw = Progress.show
    monkeypatch.setattr(Progress, "show", show)
    assert call(capsys, "plan", "house", "--prior", str(path)).code == 0
    read = shares[:7]
    assert read == sorted(read)
    assert len(set(read)) == 7
    assert 0 < read[0] < read[-1] < 1
    assert "reading the prior [###" in terminal.getvalue()
