"""Answers in calculations: whatever is done with one, its unit is not lost."""

import copy
import math
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pint
import pytest

import poinsot

BAR = """\
title: A bar that a couple holds up
given: {m: 2 kg, L: 1 m, M: 4 N*m}
find: {b: deg}
where: [1 deg < b < 80 deg]
points: {O: [0, 0, 0], P: "[L*sin(b), -L*cos(b), 0]"}
bodies: {bar: {rod: [O, P], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar}}
loads: {motor: {body: bar, couple: [0, 0, M]}}
gravity: -y
instants: {now: {angular_velocity(bar): 0, angular_acceleration(bar): 0}}
ask:
  b: b
  R: reaction(pin).y
  K: {of: reaction(pin).y, unit: kN}
  V: reaction(pin)
  P: {of: reaction(pin).y, unit: lb}
  ratio: reaction(pin).y/(m*9.80665 m/s^2)
  up: reaction(pin).y > 0
"""
WEIGHT = 2 * 9.80665
# m g L/2 sin b = M
ANGLE = math.asin(4 / (WEIGHT / 2))


@pytest.fixture
def bar() -> poinsot.Problem:
    return poinsot.Problem.from_text(BAR, "bar.yaml")


def test_an_answer_by_its_name(bar: poinsot.Problem) -> None:
    result = bar.solve()
    assert result.R is result["R"] and result.solution.K is result["K"]
    assert {"R", "K", "unknowns"} <= set(dir(result))
    assert result._ipython_key_completions_() == list(result)
    # What a result has itself comes first.
    assert result.title == "A bar that a couple holds up"
    for name, hint in (("Q", "expected b, R, K"), ("answer", "did you mean 'answers'"), ("unknown", "unknowns")):
        with pytest.raises(AttributeError, match=hint):
            getattr(result, name)
    assert not hasattr(result, "nothing")
    assert copy.copy(result) is result and copy.deepcopy(result)["R"] is result["R"]


def test_where_there_are_several_solutions_names_lead_nowhere() -> None:
    problem = poinsot.Problem.from_text(BAR.replace("80 deg", "170 deg"), "bar.yaml")
    result = problem.solve()
    assert len(result.solutions) == 2
    with pytest.raises(AttributeError, match="2 solutions"):
        result.R  # noqa: B018
    assert "R" not in dir(result)
    low, high = (one.b.si for one in result.solutions)
    assert low + high == pytest.approx(math.pi)


def test_with_a_unit_it_calculates_as_a_quantity(bar: poinsot.Problem) -> None:
    result = bar.solve()
    units: pint.UnitRegistry[Any] = pint.UnitRegistry()
    R, K, V = result["R"], result["K"], result["V"]
    twice: list[Any] = [R * 2, 2 * R, R + K, K + R, R / 0.5, np.float64(2) * R, 3 * R - K, -(-R - K), abs(-R) * 2, sum([R, R])]
    for found in twice:
        assert found.to("N").magnitude == pytest.approx(2 * WEIGHT, rel=1e-14)
    assert (R * K).to("N^2").magnitude == pytest.approx(WEIGHT**2)
    assert (R**2 / K).to("N").magnitude == pytest.approx(WEIGHT)
    assert (1 / R * R).to("").magnitude == pytest.approx(1)
    several: Any = np.array([1.0, 2.0])
    assert (several * R).to("N").magnitude == pytest.approx([WEIGHT, 2 * WEIGHT])
    assert (V * 2).to("N").magnitude == pytest.approx([0, 2 * WEIGHT, 0])
    # Beside quantities of another registry than the application's.
    lever = 2 * units.meter
    for found in (lever * R, R * lever, R * (200 * units.cm), V[1] * units.newton * lever):
        assert found.to("N*m").magnitude == pytest.approx(2 * WEIGHT)
    assert (5 * units.newton + R).magnitude == pytest.approx(5 + WEIGHT)
    assert (5 * units.newton < R) and (R > 5 * units.newton) and (np.array([1.0, 2.0]) * units.m * R).ndim == 1
    calls: list[Callable[[], object]] = [lambda: R + 1, lambda: R + lever, lambda: R + result["b"], lambda: 1 - R]
    for wrong in calls:
        with pytest.raises(pint.DimensionalityError):
            wrong()
    # Without a unit it is a number.
    assert result["ratio"] * 3 == pytest.approx(3) and 1 - result["ratio"] == pytest.approx(0)
    assert isinstance(result["ratio"] + 1, float)


def test_its_unit_is_the_one_pint_knows_by_that_name_or_that_of_the_si(bar: poinsot.Problem) -> None:
    result = bar.solve()
    assert str(result["K"].pint().units) == "kilonewton" and str(result["b"].pint().units) == "degree"
    # A pound is a force in problem files.
    pound = result["P"].pint()
    assert pound.to("lbf").magnitude == pytest.approx(result["P"].value)
    assert pound.to("N").magnitude == pytest.approx(WEIGHT)
    # And back.
    units: pint.UnitRegistry[Any] = pint.UnitRegistry()
    moment = result["R"].pint(units) * units.Quantity("20 cm")
    assert bar.solve(M=moment)["b"].si == pytest.approx(math.asin(0.2 * WEIGHT / (WEIGHT / 2)))
    with pytest.raises(TypeError, match="no number"):
        result["up"].pint()


def test_without_pint_units_are_not_dropped(bar: poinsot.Problem, monkeypatch: pytest.MonkeyPatch) -> None:
    result = bar.solve()
    monkeypatch.setitem(sys.modules, "pint", None)
    with pytest.raises(TypeError, match=r"R has a unit, N.*take .value or .si, or pip install pint"):
        result["R"] * 2
    assert result["ratio"] * 2 == pytest.approx(2)
    assert result["R"] > "19 N"


def test_sines_of_degrees(bar: poinsot.Problem) -> None:
    b = bar.solve()["b"]
    assert b.unit == "deg"
    assert float(np.sin(b)) == pytest.approx(math.sin(ANGLE), rel=1e-12)
    assert float(np.sin(bar.solve().unknowns["b"])) == pytest.approx(math.sin(ANGLE), rel=1e-12)


# The sine of 24 is no sine of 24 degrees.
@pytest.mark.parametrize("taken", [math.sin, float, np.asarray, lambda b: np.array([b, b], dtype=float), lambda b: np.linalg.norm(b)])
def test_what_is_in_another_unit_is_no_plain_number(bar: poinsot.Problem, taken: Callable[[Any], object]) -> None:
    with pytest.raises(TypeError, match=r"b is in deg, and a plain number would be one in rad: take .value, the number in deg, or .si"):
        taken(bar.solve()["b"])


def test_in_the_unit_of_the_si_it_is_a_plain_number(bar: poinsot.Problem) -> None:
    result = bar.solve()
    assert float(result["R"]) == result["R"].value and math.sqrt(result["R"]) == pytest.approx(math.sqrt(WEIGHT))
    assert np.linalg.norm(result["V"]) == pytest.approx(WEIGHT)
    assert np.array([result["R"], result["R"]], dtype=float) == pytest.approx([WEIGHT, WEIGHT])


def test_answers_go_in_with_their_units(bar: poinsot.Problem) -> None:
    result = bar.solve()
    # The unknown is in degrees, which a number would not be.
    again = bar.solve(b=result.unknowns["b"])
    assert again["b"].si == pytest.approx(ANGLE, rel=1e-12)
    assert poinsot.in_unit(result["b"], "deg") == pytest.approx(math.degrees(ANGLE))
    with pytest.raises(poinsot.StatementError, match="M is a moment or an energy"):
        bar.solve(M=result["K"])
    pushed = poinsot.Problem.from_text(
        "letters: {F: N}\nbodies: {b: {particle: [0, 0, 0], mass: 2 kg}}\ngravity: none\n"
        "loads: {push: {body: b, force: [F, 0, 0]}}\nask: {a: acceleration(b).x}"
    )
    assert pushed.solve(F=result["K"])["a"].si == pytest.approx(WEIGHT / 2)
    study = poinsot.study(pushed, {"F": [result["K"], result["P"], 3.0]})
    assert study["a"] == pytest.approx([WEIGHT / 2, WEIGHT / 2, 1.5])
    drawn = poinsot.study(pushed, {"F": poinsot.uniform(result["K"], "30 N")}, rows=100)
    assert WEIGHT / 2 <= drawn["a"].min() < drawn["a"].max() <= 15
    with pytest.raises(TypeError, match="what has a unit as it is"):
        poinsot.in_si(result["K"], "kN")


def test_comparisons(bar: poinsot.Problem) -> None:
    result = bar.solve()
    R, K, V = result["R"], result["K"], result["V"]
    assert R == K and not R != K and R >= K and R == R
    assert R > 5 and not R > 50 and R == pytest.approx(WEIGHT) and K > 0 and R != 0
    assert K > "5 N" and K < "1 kN" and R < "20 N" and not R == "20 N"
    assert list(V > 5) == [False, True, False] and list(V["y"] == V) == [False, True, False]
    assert max(R, K) is R and sorted([R, K]) == [R, K]
    # 5 could be kilonewtons.
    could_be_either: list[Callable[[], object]] = [lambda: K > 5, lambda: K == 5, lambda: K != 5, lambda: result["b"] == 24]
    for unclear in could_be_either:
        with pytest.raises(TypeError, match="take .value"):
            unclear()
    of_others: list[Callable[[], object]] = [lambda: R > result["b"], lambda: R > "3 m", lambda: R == "3 m"]
    for wrong in of_others:
        with pytest.raises(TypeError, match="R is in N"):
            wrong()
    assert not R == None and R != object() and R not in [None, "text"][:1]  # noqa: E711
    assert result["up"] == True and result["up"]  # noqa: E712
    with pytest.raises(TypeError, match="unhashable"):
        {R}
