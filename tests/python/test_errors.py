"""What is told of errors."""

import pickle
from pathlib import Path

import pytest

import poinsot

from conftest import ASKEW


def error_of(text: str) -> poinsot.StatementError:
    with pytest.raises(poinsot.StatementError) as caught:
        poinsot.Problem.from_text(text, "wrong.yaml").solve()
    return caught.value


def test_place_message_and_caret() -> None:
    error = error_of(ASKEW.replace("kinetic_energy", "kinetik_energy"))
    line = next(k for k, one in enumerate(ASKEW.split("\n"), 1) if "kinetic_energy" in one)
    assert (error.file, error.line, error.column) == ("wrong.yaml", line, 6)
    assert error.message == "there is no function 'kinetik_energy'"
    assert error.hint == "did you mean 'kinetic_energy'?"
    first, source, caret = str(error).split("\n")
    assert first.startswith(f"wrong.yaml:{line}:6: error: ")
    assert source[caret.index("^")] == "k"
    assert isinstance(error, ValueError)


def test_the_caret_counts_characters() -> None:
    text = ASKEW.replace("{m: 8 kg,", "{'ö': 1, m: 8 kgg,")
    _, source, caret = str(error_of(text)).split("\n")
    assert source[caret.index("^")] in "öÖ'"
    diagnostic = poinsot.Diagnostic("a.yaml", 3, 4, "wrong", "", "\tö = x")
    assert str(diagnostic).split("\n")[1:] == ["   3 | \tö = x", "     | \t  ^"]


def test_errors_while_solving_have_their_line() -> None:
    error = error_of(ASKEW.replace("m: 8 kg", "m: -8 kg"))
    assert error.line == 6 and error.diagnostics[0].source.startswith("  disk:")


def test_errors_are_sent() -> None:
    error = error_of(ASKEW.replace("kinetic_energy", "kinetik_energy"))
    again = pickle.loads(pickle.dumps(error))
    assert str(again) == str(error) and again.line == error.line


def test_values_that_are_set_have_no_place(askew: poinsot.Problem) -> None:
    with pytest.raises(poinsot.StatementError) as caught:
        askew.solve(nn="3 rpm")
    assert caught.value.line == 0
    assert caught.value.hint == "did you mean 'n'?"
    assert "--set" not in str(caught.value)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        poinsot.Problem.from_file(tmp_path / "none.yaml")


def test_words_that_nobody_knows(askew: poinsot.Problem) -> None:
    with pytest.raises(ValueError, match="did you mean 'sympy'"):
        askew.equations("simpy")
    with pytest.raises(poinsot.FigureError, match="free-body"):
        askew.figure("freebody")
    with pytest.raises(poinsot.NoAnswer, match="no solution 3"):
        askew.figure(solution=3)
    with pytest.raises(ValueError, match="timeout"):
        askew.solve(timeout=-1)
