"""Automata and their text."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.errors import FormatError, InputError
from stochgeom.feeding.action_classes import action_classes
from stochgeom.feeding.automaton import Automaton, read_automaton, write_automaton
from tests.strategies import transfer_functions

CERNY = Automaton(((1, 2, 3, 0), (1, 1, 2, 3)))
TEXT = """\
2 4
1 1
2 1
3 2
0 3
"""


@st.composite
def automata(draw):
    n = draw(st.integers(1, 6))
    row = st.tuples(*[st.integers(0, n - 1)] * n)
    return Automaton(tuple(draw(st.lists(row, min_size=1, max_size=4))))


class TestAutomaton:
    def test_counts(self):
        assert (CERNY.letters, CERNY.states) == (2, 4)

    def test_words_act_from_the_left(self):
        assert CERNY.run((0, 0, 1), 2) == 1
        assert CERNY.run((1, 0, 0), 2) == 0
        assert CERNY.run((), 3) == 3

    def test_images(self):
        assert CERNY.image((1,)) == {1, 2, 3}
        assert CERNY.image((1,), {0, 1}) == {1}
        assert CERNY.image(()) == {0, 1, 2, 3}

    @pytest.mark.parametrize(
        ("maps", "message"),
        [
            ((), "without letters"),
            (((),), "without letters or states"),
            (((0, 1), (0,)), "letter 1: 1 states; accepted: 2"),
            (((0, 1), (0, 2)), "letter 1, state 1: state 2; accepted: 0 to 1"),
            (((0, -1),), "letter 0, state 1: state -1"),
        ],
    )
    def test_bad_maps(self, maps, message):
        with pytest.raises(InputError, match=message):
            Automaton(maps)


class TestText:
    def test_written(self):
        assert write_automaton(CERNY) == TEXT

    def test_written_with_the_states_first(self):
        assert write_automaton(CERNY, states_first=True) == TEXT.replace("2 4", "4 2", 1)

    def test_read(self):
        assert read_automaton(TEXT) == CERNY
        assert read_automaton(TEXT.replace("2 4", "4 2", 1), states_first=True) == CERNY

    @pytest.mark.parametrize("text", [TEXT.rstrip(), TEXT + "\n  \n", TEXT.replace("\n", "\r\n")])
    def test_line_ends_do_not_matter(self, text):
        assert read_automaton(text) == CERNY

    @given(automata(), st.booleans())
    def test_round_trip(self, automaton, states_first):
        text = write_automaton(automaton, states_first=states_first)
        assert read_automaton(text, states_first=states_first) == automaton

    @given(transfer_functions())
    def test_round_trip_of_actions(self, s):
        automaton = action_classes(s).automaton()
        assert automaton.states == len(s)
        assert read_automaton(write_automaton(automaton)) == automaton

    @pytest.mark.parametrize(
        ("text", "message"),
        [
            ("", "empty"),
            ("  \n", "empty"),
            ("2\n", "line 1: 1 numbers; accepted: 2"),
            ("0 2\n\n\n", "line 1: 0 letters"),
            ("1 0", "line 1: 1 letters and 0 states"),
            ("100000 100000\n0\n", "at most 10000000 entries"),
            ("1 2\n0\n", "line 2: 1 lines follow the first; accepted: 2"),
            ("1 2\n0\n1\n1\n", "line 4: 3 lines follow"),
            ("2 2\n0 1\n1\n", "line 3: 1 numbers; accepted: 2"),
            ("1 2\n0\n2\n", "line 3: state 2; accepted: 0 to 1"),
            ("1 2\n0\n-1\n", "line 3: '-1'; accepted: whole numbers"),
            ("1 2\n0\nx\n", "line 3: 'x'"),
            ("1 2\n0\n0.0\n", "line 3: '0.0'"),
            ("1 1\n٠\n", "line 2: '٠'"),
            ("1 1\n" + "0" * 5000 + "\n", "line 2: '00000000000000000000'"),
        ],
    )
    def test_bad_text(self, text, message):
        with pytest.raises(FormatError, match=message):
            read_automaton(text)
