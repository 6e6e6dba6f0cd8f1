"""Problems and their answers, against formulas written down here."""

import copy
import math
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import poinsot

EXAMPLES = Path(__file__).parents[2] / "examples"


def askew_by_hand(
    n: float, m: float = 8.0, r: float = 0.15, b: float = np.radians(20.0), L: float = 0.5
) -> dict[str, Any]:
    """A disk on a shaft along x, its axis at b to it: I = m r^2/4 (1 + e e^T), H = I w, A = -B with L x B = w x H."""
    e = np.array([np.cos(b), np.sin(b), 0.0])
    inertia = m * r**2 / 4 * (np.eye(3) + np.outer(e, e))
    w = np.array([n, 0.0, 0.0])
    H = inertia @ w
    couple = np.cross(w, H)
    B = np.array([0.0, couple[2] / L, -couple[1] / L])
    return {"H": H, "T": 0.5 * w @ H, "A": -B, "B": B}


@pytest.mark.parametrize("rate, n", [("3000 rpm", 100 * np.pi), (314.0, 314.0), (np.float64(-7.5), -7.5), (0, 0.0)])
def test_answers_are_those_of_the_formulas(askew: poinsot.Problem, rate: object, n: float) -> None:
    result = askew.solve(n=rate)
    for name, value in askew_by_hand(n).items():
        np.testing.assert_allclose(result[name].value, value, rtol=1e-12, atol=1e-9)
        np.testing.assert_allclose(result[name].si, value, rtol=1e-12, atol=1e-9)
        assert result[name].state == "found"
    assert result["T"].unit == "J"
    assert result["A"].axes == ["x", "y", "z"]
    assert result["A"].words == "reaction at A, exerted on disk by ground"
    assert result.fully_answered
    assert max(result.checks.values()) < 1e-12


def test_values_stand_in_a_mapping_too(askew: poinsot.Problem) -> None:
    assert askew.solve({"n": "3000 rpm"}, m=4)["T"].value == askew.solve(n="3000 rpm", m="4 kg")["T"].value


def test_a_result_is_gone_through_by_name(askew: poinsot.Problem) -> None:
    result = askew.solve()
    assert list(result) == list(result.keys()) == list(result.solution) == ["H", "T", "A", "B"]
    assert "A" in result and "Z" not in result and 0 not in result
    assert {name: answer.unit for name, answer in result.items()} == {"H": "kg*m^2/s", "T": "J", "A": "N", "B": "N"}


def test_conditions_and_claims_are_true_or_false(bent: poinsot.Problem) -> None:
    result = bent.solve(m=1, a=1, J=1)
    assert result["more"] and not result["less"] and len(result) == 3 and [one.name for one in result.values()] == list(result)
    assert result.get("w") is result["w"] and result.get("v") is None
    with pytest.raises(poinsot.NoAnswer, match="while letters are open"):
        bool(bent.solve()["w"])


def test_answers_in_other_units_and_as_text(askew: poinsot.Problem) -> None:
    by_hand, result = askew_by_hand(40 * np.pi), askew.solve()
    assert result["T"].to("kJ") == pytest.approx(by_hand["T"] / 1000, rel=1e-12)
    np.testing.assert_allclose(result["A"].to("kN"), by_hand["A"] / 1000, rtol=1e-12, atol=1e-12)
    assert f"{result['T']:.2f}" == f"{by_hand['T']:.2f} J" and str(result["T"]) == "669.049 J"
    assert f"{result['B']:.1f}" == f"(0.0, {by_hand['B'][1]:.1f}, 0.0) N"


def test_vectors_of_planar_problems_have_the_axes_of_the_plane() -> None:
    problem = poinsot.Problem.from_file(EXAMPLES / "mechanisms/planar-slider-crank.yaml")
    vectors = [answer for answer in problem.solve().answers.values() if np.ndim(answer.value) == 1]
    for answer in vectors:
        assert answer.axes == ["x", "y"] and answer["y"] == answer.value[1]
    assert vectors


def test_the_bodies_for_other_programs(askew: poinsot.Problem) -> None:
    content = askew.gltf(n="3000 rpm")
    assert content[:4] == b"glTF" and int.from_bytes(content[8:12], "little") == len(content)


def test_units_of_answers_are_those_of_the_file_and_si_beside() -> None:
    problem = poinsot.Problem.from_file(EXAMPLES / "textbook/18.005.yaml")
    answer = problem.solve()["a"]
    assert answer.unit == "lb*ft*s"
    foot, pound = 0.3048, 0.45359237 * 9.80665
    np.testing.assert_allclose(answer.si, np.asarray(answer.value) * pound * foot, rtol=1e-12)


def test_what_a_problem_states(askew: poinsot.Problem, bent: poinsot.Problem) -> None:
    assert askew.title == "Disk mounted askew on a shaft"
    assert askew.data["n"] == "1200 rpm"
    assert askew.questions == {
        "H": "angular_momentum(disk about G)",
        "T": "kinetic_energy(disk)",
        "A": "reaction(A)",
        "B": "reaction(B)",
    }
    assert bent.letters == {"m": "kg", "a": "m", "J": "N*s"}
    assert list(bent.claims) == ["more", "less"]


def test_several_solutions() -> None:
    problem = poinsot.Problem.from_file(EXAMPLES / "textbook/18.111.yaml")
    result = problem.solve()
    assert len(result.solutions) == 2
    with pytest.raises(poinsot.NoAnswer, match="2 solutions"):
        result["a"]
    (name,) = problem.unknowns
    slow, fast = (one.unknowns[name].si for one in result.solutions)
    assert slow < fast


def test_check_compares_with_the_file() -> None:
    text = (EXAMPLES / "textbook/18.005.yaml").read_text()
    assert poinsot.Problem.from_text(text).check() == []
    assert poinsot.Problem.from_text(text.replace("given:", "given:", 1).split("expect:")[0]).check() != []


def test_a_question_without_answer_has_state_and_reason() -> None:
    text = """\
points: {O: [0, 0, 0], P: [1 m, 0, 0]}
bodies: {bar: {rod: [O, P], mass: 2 kg}}
joints: {shaft: {revolute: z, at: O, to: bar}}
gravity: none
ask: {T: kinetic_energy(bar), m: mass(bar)}
"""
    result = poinsot.Problem.from_text(text).solve()
    answer = result["T"]
    assert answer.state == "undetermined"
    assert answer.reason
    with pytest.raises(poinsot.NoAnswer, match="T has no value"):
        answer.value
    assert result["m"].value == 2
    assert not result.fully_answered


def test_the_document_is_that_of_the_program(askew: poinsot.Problem) -> None:
    document = askew.solve().to_dict()
    assert document["poinsot"] == poinsot.__version__
    assert document["solutions"][0]["answers"]["T"]["value"] == askew.solve()["T"].value


def test_a_misspelt_answer_is_named(askew: poinsot.Problem) -> None:
    with pytest.raises(KeyError, match=r"no answer 'B.y': a component of B is \['B'\]\['y'\]"):
        askew.solve()["B.y"]
    with pytest.raises(KeyError, match="there is no answer 'D'"):
        askew.solve()["D"]


def test_problems_are_copied_and_sent(askew: poinsot.Problem) -> None:
    for other in (pickle.loads(pickle.dumps(askew)), copy.deepcopy(askew)):
        assert other.solve(n=10)["T"].value == askew.solve(n=10)["T"].value
        assert other.name == "askew.yaml"


def test_a_worked_solution(bent: poinsot.Problem) -> None:
    text = bent.explain().to_markdown()
    assert "$$" in text and "## Answers" in text


def test_equations_run(tmp_path: Path) -> None:
    problem = poinsot.Problem.from_text(
        """\
given: {m: 3 kg, l: 2 m}
points: {O: [0, 0, 0], P: [l, 0, 0]}
bodies: {bar: {rod: [O, P], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar, angle: theta}}
gravity: [0, -9.81 m/s^2, 0]
ask: {T: mass(bar)}
"""
    )
    names: dict[str, object] = {}
    exec(problem.equations("python", of=["forward-dynamics"], function="accelerations"), names)
    text = problem.equations("tex")
    assert "\\" in text
    accelerations = names["accelerations"]
    assert callable(accelerations)
    angle = 0.3
    # A uniform bar turned about its end: alpha = -3 g cos(theta)/(2 l).
    found = accelerations([angle], [0.7], [0.0], [])
    assert np.ravel(found)[0] == pytest.approx(-1.5 * 9.81 * np.cos(angle) / 2, rel=1e-12)


def test_schema_and_help() -> None:
    assert "kinetic_energy" in poinsot.language_words()
    assert "kinetic_energy" in poinsot.language_help("kinetic_energy")
    assert poinsot.si_unit("rpm") == "rad/s"
    assert poinsot.si_unit("lb*ft") == poinsot.si_unit("N*m")
    with pytest.raises(ValueError, match="rpn"):
        poinsot.si_unit("rpn")


def test_components_by_axis_and_number(askew: poinsot.Problem) -> None:
    answers = askew.solve()
    B, T = answers["B"], answers["T"]
    assert B["y"] == B[1] == B.value[1] > 0
    assert list(np.array(B)) == list(B.value)
    with pytest.raises(KeyError, match="no component 'q': expected x, y, z"):
        B["q"]
    with pytest.raises(TypeError, match="T has no components"):
        T["x"]
    with pytest.raises(TypeError, match="not iterable"):
        list(B)  # type: ignore[call-overload]


def test_the_manual_leads_to_a_plot(monkeypatch: pytest.MonkeyPatch) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    manual = (Path(__file__).parents[2] / "docs/python.md").read_text()
    code = manual.split("## From a problem to a plot")[1].split("```python\n")[1].split("```")[0]
    names: dict[str, Any] = {}
    exec(compile(code, "docs/python.md", "exec"), names)
    line = plt.gca().lines[0]
    plt.close()
    # m r^2 n^2 sin b cos b / (4 L), at 3000 rpm, in kN
    speed, tilt = 3000 * math.pi / 30, math.radians(20)
    expected = 8 * 0.15**2 * speed**2 * math.sin(tilt) * math.cos(tilt) / (4 * 0.5) / 1000
    assert np.asarray(line.get_xdata())[-1] == 3000
    assert np.asarray(line.get_ydata())[-1] == pytest.approx(expected, rel=1e-12)


def test_all_code_of_the_manual_runs(askew: poinsot.Problem, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One block after another, in a folder with the file that they speak of."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    manual = (Path(__file__).parents[2] / "docs/python.md").read_text()
    blocks = [one.split("```")[0] for one in manual.split("```python\n")[1:]]
    assert len(blocks) > 5
    monkeypatch.chdir(tmp_path)
    named = askew.text.replace("rate: n, accel: 0", "angle: theta, rate: n, accel: 0") + "instants: {start: {theta: 0}}\n"
    Path("askew.yaml").write_text(named)
    names: dict[str, Any] = {}
    for number, block in enumerate(blocks, 1):
        exec(compile(block, f"docs/python.md, block {number}", "exec"), names)
    plt.close("all")
    assert names["motion"].coordinates == ["theta"] and names["study"].counts.answered == 210_000
    assert names["start"].model.nv == 1
