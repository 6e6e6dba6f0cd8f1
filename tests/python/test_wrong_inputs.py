"""What a caller does wrong is told in words of Python, and nothing wrong passes for something right."""

import pickle
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import poinsot
from poinsot import engine
from poinsot.__main__ import main
from poinsot.wording import in_python

from conftest import ASKEW


def model() -> engine.Model:
    builder = engine.ModelBuilder()
    builder.add_body("bar", "ground", "revolute", mass=2, center=[0.5, 0, 0], inertia=np.diag([0, 1, 1]) / 6)
    return builder.build()


# Types are not what they should be: Any, for mypy would refuse them.
solve: Any = poinsot.Problem.solve
study: Any = poinsot.study
from_text: Any = poinsot.Problem.from_text
read: Any = poinsot.Problem.from_file
builder: Any = engine.ModelBuilder
library: Any = engine
package: Any = poinsot
one = np.zeros(1)

CALLS: list[tuple[Callable[[Any], Any], type[Exception], str]] = [
    (lambda p: solve(p, "n=3000 rpm"), TypeError, "by name, as n='3000 rpm'"),
    (lambda p: solve(p, {3: "3000 rpm"}), TypeError, "3 is none"),
    (lambda p: solve(p, n={}), TypeError, r"not \{\}"),
    (lambda p: solve(p, n=None), TypeError, "not None"),
    (lambda p: solve(p, n=np.bool_(True)), TypeError, "truth value"),
    (lambda p: solve(p, n=[300.0]), ValueError, "list of 1: .*poinsot.study"),
    (lambda p: solve(p, n=np.nan), ValueError, "nan is no value"),
    (lambda p: solve(p, timeout="3"), TypeError, "a number of seconds, not '3'"),
    (lambda p: solve(p, progress="yes"), TypeError, "True, False or a function"),
    (lambda p: p.solve().to_text("six"), TypeError, "digits is a whole number"),
    (lambda p: p.solve().to_text(-1), ValueError, "digits"),
    (lambda p: p.solve()[0], TypeError, "by its name, as 'H', not by 0"),
    (lambda p: solve(p, n=1j), TypeError, "not 1j"),
    (lambda p: solve(p, n=np.complex128(3 + 1j)), TypeError, "a number in SI units"),
    (lambda p: p.solve()["B"].y, AttributeError, r"a component is B\['y'\]"),
    (lambda p: p.solve()["T"].y, AttributeError, "no attribute 'y'$"),
    (lambda p: p.solve()["T"].to("kg"), ValueError, "a value in J cannot be told in 'kg'"),
    (lambda p: p.solve()["T"].to("kiloJ"), ValueError, "not a unit"),
    (lambda p: p.solve()["T"].sympy(), poinsot.NoAnswer, "with_letters"),
    (lambda p: p.equations(of=[3]), TypeError, "of is a list of texts"),
    (lambda p: p.equations(letters=["zz"]), poinsot.StatementError, "^letters: zz: error"),
    (lambda p: p.figure(solution="first"), TypeError, "whole number"),
    (lambda p: p.figure(solution=1), poinsot.NoAnswer, "counted from 0"),
    (lambda p: p.figure().save("disk.png"), ValueError, "what is written is .svg"),
    (lambda p: p.motion()("1 s", "kinetic_energy(disk)"), TypeError, "times as numbers in s"),
    (lambda p: p.motion()(None, "kinetic_energy(disk)"), TypeError, "times as numbers in s"),
    (lambda p: p.motion()(1, ["kinetic_energy(disk)"]), TypeError, "texts, one by one"),
    (lambda p: p.motion()(np.array([1j]), "kinetic_energy(disk)"), TypeError, "times as numbers in s"),
    (lambda p: p.motion()(np.array(["2024-01-01"], dtype="datetime64[s]"), "kinetic_energy(disk)"), TypeError, "times as numbers in s"),
    (lambda p: p.motion()(1, "T"), poinsot.StatementError, r"asked for its quantity, T='kinetic_energy\(disk\)'"),
    (lambda p: p.motion()(1, "TT"), poinsot.StatementError, "'TT' is not defined"),
    (lambda p: p.motion()(1), ValueError, "angle: theta gives one to a joint"),
    (lambda p: p.motion(None, "theta"), TypeError, "name the times first"),
    (lambda p: p.motion("theta"), TypeError, "by name"),
    (lambda p: pickle.dumps(p.solve()), TypeError, "stays in its process"),
    (lambda p: pickle.dumps(p.solve()["T"]), TypeError, "stays in its process"),
    (lambda p: bool(p.solve()["H"]), ValueError, "ambiguous"),
    (lambda p: study(p, {"n": [1]}, "B.y"), ValueError, "ask for 'B', whose components are columns"),
    (lambda p: study(p, ["n"]), TypeError, "differs by name"),
    (lambda p: study(p, [{"n": "1 rpm", "m": "2 kg"}]), TypeError, r"cases that are no grid .*problem.solve\(case\)"),
    (lambda p: study(p, {"n": [1, None]}), TypeError, "not None"),
    (lambda p: study(p, {"n": np.array([1, 2j])}), TypeError, "numbers in SI units"),
    (lambda p: study(p, {"n": [1.0]}).frame(units={"B.w": "kN"}), KeyError, "no column 'B.w' to show in kN"),
    (lambda p: study(p, {"n": [1.0]}).frame(units={"T": "kN"}), ValueError, "a value in J cannot be told in 'kN'"),
    (lambda p: study(p, {"n": [True]}), TypeError, "not True"),
    (lambda p: study(p, {"n": np.ones((2, 2))}), TypeError, "not array"),
    (lambda p: study(p, {"n": {"span": [1, 2]}}), TypeError, "a span or a distribution"),
    (lambda p: study(p, {"n": ["1 kg"]}), poinsot.StatementError, "^n=1 kg: error"),
    (lambda p: study(p, {"n": [1]}, [3]), TypeError, "asks is a list of texts"),
    (lambda p: study(p, {"n": [1]}, sets="m=3"), TypeError, "by name"),
    (lambda p: study(p, {"n": [1]}, seed=1.5), TypeError, "whole number"),
    (lambda p: study(p, {"n": [1]}, threads=0), ValueError, "threads is a whole number, 1 or more"),
    (lambda p: study(p, {"n": [1]}, formulas="no"), TypeError, "True or False"),
    (lambda p: study(p, {"n": [1]}, client=3), TypeError, "dask.distributed"),
    (lambda p: study(p, {"n": poinsot.tolerance(1, 2)}, rows=2.5), TypeError, "rows is a whole number"),
    (lambda p: package.span(1, 2, 2.5), TypeError, "count of a span is a whole number"),
    (lambda p: from_text(b"title: x"), TypeError, "text of a problem file"),
    (lambda p: from_text("askew.yaml"), ValueError, "from_file"),
    (lambda p: read(ASKEW), ValueError, "from_text"),
    (lambda p: read(3), TypeError, "int"),
    (lambda p: poinsot.language_help("kinetik_energy"), ValueError, "did you mean 'kinetic_energy'"),
    (lambda p: package.in_unit("3 m", "mm"), TypeError, "numbers in SI units"),
    (lambda p: package.in_unit(np.array([1j]), "mm"), TypeError, "numbers in SI units"),
    (lambda p: package.in_unit(np.array(["3"]), "mm"), TypeError, "numbers in SI units"),
    (lambda p: package.si_unit(3), TypeError, "a unit is a text"),
    (lambda p: builder().add_body("x", mass="1 kg"), TypeError, "mass as a number"),
    (lambda p: builder().add_body("x", axis="z"), TypeError, "axis as three numbers"),
    (lambda p: builder().add_body("x", mass=1, inertia=np.diag([1, 1, 3])), ValueError, r"'x': no rigid body .* I_x \+ I_y >= I_z is broken"),
    (lambda p: builder().add_body("x", mass=1, inertia=[[2, 0, 3], [0, 5, 0], [3, 0, 2]]), ValueError, "I_1 >= 0 is broken"),
    (lambda p: builder().add_body("x", inertia=np.eye(3)), ValueError, "'x': the mass is zero"),
    (lambda p: builder().add_body(3), TypeError, "told by names"),
    (lambda p: model().body("Bar"), KeyError, "did you mean 'bar'"),
    (lambda p: model().first_position(-1), ValueError, "whole number"),
    (lambda p: library.aba(builder(), one, one, one), TypeError, "an engine.Model, not ModelBuilder"),
    (lambda p: library.aba(model(), None, one, one), TypeError, "None stands"),
    (lambda p: library.aba(model(), one, one, one, threads=1.5), TypeError, "threads"),
    (lambda p: library.aba(model(), one, one, one, threads=0), ValueError, "threads is a whole number, 1 or more"),
    (lambda p: library.mass_center(model(), None), TypeError, "None stands"),
    (lambda p: library.advance(model(), one, one, one, "a"), TypeError, "dt as a number"),
    (lambda p: library.from_problem("askew.yaml"), TypeError, "from_file"),
]


@pytest.mark.parametrize("number", range(len(CALLS)))
def test_wrong_calls_are_told(number: int, askew: poinsot.Problem) -> None:
    call, kind, words = CALLS[number]
    with pytest.raises(kind, match=words) as caught:
        call(askew)
    assert "--set" not in str(caught.value) and "incompatible function arguments" not in str(caught.value)


def test_words_of_the_command_line_are_said_in_python() -> None:
    assert in_python("give values: --set 'm=... kg' --set x=... now") == "give values: m='... kg', x='...' now"
    assert in_python("--set theta'=3") == "theta'=3"
    assert in_python("needs theta': --set 'theta'=3 rad'") == "needs theta': {\"theta'\": '3 rad'}"
    assert in_python("a -- b") == "a -- b"
    assert in_python("(choose one: --situation laid)") == "(choose one: situation='laid')"
    two = poinsot.Problem.from_file(Path(__file__).parents[2] / "examples/mechanisms/block-on-an-incline.yaml")
    with pytest.raises(poinsot.StatementError, match="choose one: situation='laid'"):
        two.equations()


def test_no_message_of_the_sources_speaks_of_options() -> None:
    literals = [
        (path, text)
        for path in Path("src/problem").rglob("*.cpp")
        for text in re.findall(r'"((?:[^"\\]|\\.)*--set(?:[^"\\]|\\.)*)"', path.read_text(encoding="utf-8"))
    ]
    assert len(literals) > 10
    for path, text in literals:
        # What ends there is put together, and keys.cpp is the manual.
        whole = text + "x=1" if text.endswith("--set ") else text + "x=...'" if text.endswith("--set '") else text
        if path.name != "keys.cpp" and not path.name.endswith("settings.h"):
            assert "--set" not in in_python(whole), (path, text)


def test_messages_of_open_letters(bent: poinsot.Problem) -> None:
    with pytest.raises(poinsot.NoAnswer, match="needs values for m, a, J: m='...'"):
        bent.motion()
    assert bent.solve().to_text().endswith("To give values: m='... kg', a='... m', J='... N*s'\n")


@pytest.mark.parametrize(
    "text, words",
    [
        ('problem = 3\nout = "o"\n[over]\nn = [1]', "'problem' is the name of a file, not 3"),
        ('problem = "a.yaml"\nout = "o"\nover = 3', "'over' is a table, not 3"),
        ('problem = "none.yaml"\nout = "o"\n[over]\nn = [1]', "none.yaml: error: No such file"),
        ('problem = "a.yaml"\nout = "o"\n[over\nn = 3', "s.toml: error: .*line 3"),
        ('problem = "a.yaml"\nout = "o"\nset = "m=3"\n[over]\nn = [1]', "s.toml: error: values are given by name"),
    ],
)
def test_wrong_files_of_studies_are_told(text: str, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "a.yaml").write_text(ASKEW)
    (tmp_path / "s.toml").write_text(text)
    assert main(["study", str(tmp_path / "s.toml")]) == 2
    assert re.search(words, capsys.readouterr().err)
