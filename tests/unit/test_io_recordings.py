"""Recordings from CSV and JSON: what is read, and what is told of what is not."""

from __future__ import annotations

import json

import pytest
from gmpy2 import mpq

from stochgeom.errors import FormatError, NumberError, PriorError, ReadError, RecordingError
from stochgeom.io.recordings import (
    load_recording,
    parse_recording,
    recording_document,
    save_recording,
)
from stochgeom.tilting.counts import OTHER, TransitionCounts

COUNTS = TransitionCounts.from_trials([(7, 1, 3), (7, 1, 3), (1, 12, 12)], other=False)
LOST = TransitionCounts.from_trials([(7, 1, 3), (7, 1, OTHER)])


@pytest.mark.parametrize(
    "text",
    [
        "7,1,3\n7,1,3\n1,12,12\n",
        "7;1;3\n7;1;3\n1;12;12",
        "7 1 3\n7\t1\t3\n 1  12 12 \n",
        "initial,action,final\n7,1,3\n7,1,3\n1,12,12\n",
        "final, initial, action\n3,7,1\n3,7,1\n12,1,12\n",
        "initial,action,final,count\n7,1,3,2\n1,12,12,1\n",
        "Count, Final, Action, Initial\n2,3,1,7\n1,12,12,1\n",
        "# the robot's\n\n7,1,3,2  # twice\n1,12,12\n",
        "\ufeff7,1,3\r\n7,1,3\r\n1,12,12\r\n",
        "[[7, 1, 3], [7, 1, 3], [1, 12, 12]]",
        '[["7", "1", "3", "2"], [1, 12, 12]]',
        '{"observations": [[7, 1, 3, 2], [1, 12, 12]]}',
        '{"states": 12, "actions": 12, "other": false, "observations": [[7,1,3,2],[1,12,12,1]]}',
    ],
)
def test_forms_of_the_same_recording(text):
    recording = parse_recording(text)
    assert recording.counts == COUNTS
    assert recording.alpha is None
    assert recording.model().alpha[0][0] == mpq(1, 100)


@pytest.mark.parametrize(
    "text",
    [
        "7,1,3\n7,1,other\n",
        "7,1,3\n7,1,Other\n",
        '[[7, 1, 3], [7, 1, "other"]]',
    ],
)
def test_another_outcome_has_a_column_of_its_own(text):
    assert parse_recording(text).counts == LOST


def test_sizes_may_be_given():
    counts = parse_recording("20,2,1\n", states=20, actions=3).counts
    assert (counts.states, counts.actions) == (20, 3)


@pytest.mark.parametrize(
    ("text", "error", "message"),
    [
        ("7,1,3\n7,13,3\n", RecordingError, "line 2: action '13'; accepted: 1 to 12"),
        ("# a\n\n13,1,3\n", RecordingError, "line 3: initial state '13'; accepted: 1 to 12"),
        ("7,1,0\n", RecordingError, "line 1: final state '0'; accepted: 1 to 12"),
        ("other,1,3\n", FormatError, "line 1: the columns 'other, 1, 3'; accepted: initial"),
        ("7,1,3\nother,1,3\n", RecordingError, "line 2: initial state 'other'"),
        ("7,1,3,-2\n", RecordingError, "line 1: the count '-2'; accepted: whole numbers from 0"),
        ("7,1,3,1.5\n", RecordingError, "line 1: the count '1.5'"),
        ("7,1\n", FormatError, "line 1: '7,1'; accepted: initial state, action, final state"),
        ("7,1,3,4,5\n", FormatError, "line 1: '7,1,3,4,5'"),
        ("initial,final\n7,1\n", FormatError, "line 1: the columns 'initial, final'"),
        ("initial,action,final\n7,1,3,2\n", FormatError, "line 2: '7,1,3,2'"),
        ("", FormatError, "no trials; accepted: CSV with"),
        ("# nothing\n", FormatError, "no trials"),
        ("[\n [7, 1, 3],\n [7, 13, 3]\n]", RecordingError, "line 3: action '13'"),
        (
            '{"states": 3,\n "observations": [[1, 1, 2],\n\n [1, 1, 4]]}',
            RecordingError,
            "line 4: final state '4'; accepted: 1 to 3",
        ),
        ("[[7, 1, 3, -1]]", RecordingError, "line 1: the count '-1'"),
        ("[[7, 1, 2.5]]", RecordingError, "line 1: final state '2.5'"),
        ("[[7, 1, null]]", FormatError, "line 1: a list of 3; accepted: [initial, action, final]"),
        ("[7]", FormatError, "line 1: the number 7; accepted: [initial"),
        ("[[7, 1]]", RecordingError, "line 1: 2 entries"),
        ("[]", FormatError, "observations: a list of 0; accepted: a list of trials"),
        ('{"trials": []}', FormatError, "key trials: accepted keys: actions, alpha"),
        ('{"schema": "x", "observations": [[1,1,1]]}', FormatError, "key schema: the text 'x'"),
        ('{"states": 0, "observations": [[1,1,1]]}', RecordingError, "key states: number of st"),
        ('{"states": [], "observations": [[1,1,1]]}', RecordingError, "key states: number of st"),
        ('{"other": 1, "observations": [[1,1,1]]}', FormatError, "key other: the number 1"),
        ('{"alpha": true, "observations": [[1,1,1]]}', FormatError, "key alpha: true"),
        ('{"alpha": "x", "observations": [[1,1,1]]}', NumberError, "key alpha: 'x' is not"),
        ("[[7, 1, 3]", FormatError, "line 1, column 11: broken JSON"),
    ],
)
def test_a_bad_recording_is_told_with_its_line(text, error, message):
    with pytest.raises(error) as caught:
        parse_recording(text)
    assert str(caught.value).startswith(message)


def test_a_bad_alpha_in_the_file_is_refused_by_the_model():
    recording = parse_recording('{"alpha": 0, "observations": [[1, 1, 1]]}')
    with pytest.raises(PriorError, match="alpha: 0; accepted: numbers above 0"):
        recording.model()
    assert recording.model("1/2").alpha[0][0] == mpq(1, 2)


def test_what_is_written_is_read_back(tmp_path):
    path = str(tmp_path / "seen.json")
    for counts, alpha in ((COUNTS, None), (LOST, "1/3")):
        save_recording(path, recording_document(counts, alpha, simulation={"seed": 1}))
        recording = load_recording(path)
        assert recording.counts == counts
        assert recording.alpha == (None if alpha is None else mpq(alpha))
        assert recording.simulation == {"seed": "1"}
        json.loads((tmp_path / "seen.json").read_text())


def test_a_file_is_named_in_its_errors(tmp_path):
    path = tmp_path / "seen.csv"
    path.write_text("7,1,3\n7,1,99\n")
    with pytest.raises(RecordingError) as caught:
        load_recording(str(path))
    assert caught.value.where == f"{path}, line 2"
    with pytest.raises(ReadError, match=r"nowhere\.csv: cannot be read"):
        load_recording(str(tmp_path / "nowhere.csv"))


def test_long_numbers_do_no_harm():
    with pytest.raises(RecordingError, match="line 1: initial state"):
        parse_recording("9" * 6000 + ",1,3\n")
