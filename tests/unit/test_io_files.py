"""Files that are written whole or not at all."""

from __future__ import annotations

import errno
import os
import stat
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from stochgeom.errors import InputError, WriteError
from stochgeom.io.files import write_whole
from tests.repo.sources import ROOT


def test_a_file_is_written_and_replaced(tmp_path):
    path = tmp_path / "a.txt"
    write_whole(str(path), "one\n")
    write_whole(str(path), "tw\u00f6\n")
    assert path.read_bytes() == "tw\u00f6\n".encode()
    assert [p.name for p in tmp_path.iterdir()] == ["a.txt"]


def test_the_mask_decides_who_may_read_it(tmp_path):
    before = os.umask(0o027)
    try:
        write_whole(str(tmp_path / "a.txt"), "")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "a.txt").stat().st_mode) == 0o640


def test_a_link_is_followed(tmp_path):
    (tmp_path / "folder").mkdir()
    link = tmp_path / "link"
    link.symlink_to(tmp_path / "folder" / "file")
    write_whole(str(link), "text")
    assert link.is_symlink()
    assert (tmp_path / "folder" / "file").read_text(encoding="utf-8") == "text"
    assert [p.name for p in (tmp_path / "folder").iterdir()] == ["file"]


def test_a_pipe_is_written_to_and_not_replaced(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    read = []
    reader = threading.Thread(target=lambda: read.append(pipe.read_text(encoding="utf-8")))
    reader.start()
    write_whole(str(pipe), "through")
    reader.join()
    assert read == ["through"]
    assert stat.S_ISFIFO(pipe.stat().st_mode)
    assert [p.name for p in tmp_path.iterdir()] == ["pipe"]


def test_standard_output_by_its_name_is_written_to():
    code = "from stochgeom.io.files import write_whole; write_whole('/dev/stdout', 'through')"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, cwd=ROOT)
    assert done.stdout == b"through"


@pytest.mark.parametrize("name", ["missing/a", "file/a", "folder", "circle", "nul\0", "x" * 300])
def test_what_cannot_be_written_leaves_everything_as_it_was(tmp_path, name):
    (tmp_path / "file").write_text("kept", encoding="utf-8")
    (tmp_path / "folder").mkdir()
    (tmp_path / "circle").symlink_to(tmp_path / "circle")
    before = sorted(p.name for p in tmp_path.iterdir())
    with pytest.raises(WriteError, match="accepted: a file in a writable folder"):
        write_whole(str(tmp_path / name), "text")
    assert sorted(p.name for p in tmp_path.iterdir()) == before
    assert (tmp_path / "file").read_text(encoding="utf-8") == "kept"


def test_a_text_that_cannot_be_encoded_leaves_nothing(tmp_path):
    with pytest.raises(WriteError):
        write_whole(str(tmp_path / "a"), "half \ud800")
    assert list(tmp_path.iterdir()) == []


def test_a_write_that_is_cut_short_leaves_nothing(tmp_path, monkeypatch):
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    (tmp_path / "a").write_text("kept", encoding="utf-8")
    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(WriteError, match="No space left"):
        write_whole(str(tmp_path / "a"), "new")
    assert [p.name for p in tmp_path.iterdir()] == ["a"]
    assert (tmp_path / "a").read_text(encoding="utf-8") == "kept"


@pytest.mark.parametrize("path", [None, 5, b"plan.json", ["plan.json"]])
def test_what_is_no_path_is_named(path):
    with pytest.raises(InputError, match="accepted: the path of a file"):
        write_whole(path, "text")
