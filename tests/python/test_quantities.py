"""Values that go into a problem."""

from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pint
import pytest
import sympy

import poinsot


def kinetic_energy(problem: poinsot.Problem, **values: Any) -> float:
    return float(problem.solve(**values)["T"].value)


def test_all_ways_give_the_same(askew: poinsot.Problem) -> None:
    units: pint.UnitRegistry[Any] = pint.UnitRegistry()
    wanted = kinetic_energy(askew, n="955 rpm", r="200 mm")
    rate = 955 * 2 * np.pi / 60
    for n in (rate, np.float64(rate), np.array(rate), units("955 rpm"), units.Quantity(rate, "rad/s")):
        for r in (0.2, Decimal("0.2"), Fraction(1, 5), units("20 cm"), units("0.2 m")):
            assert kinetic_energy(askew, n=n, r=r) == pytest.approx(wanted, rel=1e-14)


def test_a_quantity_of_another_kind_is_refused(askew: poinsot.Problem) -> None:
    units: pint.UnitRegistry[Any] = pint.UnitRegistry()
    with pytest.raises(poinsot.StatementError, match="angular velocity"):
        askew.solve(n=units("3 kg"))
    with pytest.raises(ValueError, match="ampere"):
        askew.solve(n=units("3 A"))


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_numbers_that_are_none(askew: poinsot.Problem, value: float) -> None:
    with pytest.raises(ValueError, match="n: .* is no value"):
        askew.solve(n=value)


@pytest.mark.parametrize("value", [True, None, object()])
def test_things_that_are_no_values(askew: poinsot.Problem, value: object) -> None:
    with pytest.raises(TypeError, match="n: "):
        askew.solve(n=value)


def test_a_number_for_a_formula_is_refused() -> None:
    problem = poinsot.Problem.from_text(
        """\
given: {m: 2 kg, r: 1 m, I: m*r^2}
bodies: {b: {sphere: {center: [0, 0, 0], radius: r}, mass: m}}
ask: {m: mass(b)}
"""
    )
    with pytest.raises(ValueError, match="I: .*text with unit"):
        problem.solve(I=3)
    assert problem.solve(I="3 kg*m^2")["m"].value == 2


def test_times_of_pint_have_their_unit(askew: poinsot.Problem) -> None:
    units: pint.UnitRegistry[Any] = pint.UnitRegistry()
    values = askew.motion()(units.Quantity([0, 500, 1000], "ms"), "kinetic_energy(disk)")
    np.testing.assert_allclose(values.times, [0, 0.5, 1], rtol=1e-15)
    with pytest.raises(pint.DimensionalityError):
        askew.motion()(3 * units.kg, "kinetic_energy(disk)")


def test_many_values_for_a_number_are_a_study(askew: poinsot.Problem) -> None:
    for many in ([1.0, 2.0], np.linspace(1, 2, 3), ("1 rpm", "2 rpm", "3 rpm")):
        with pytest.raises(ValueError, match=r"n: a call takes one value.*poinsot.study\(problem, over="):
            askew.solve(n=many)
    assert askew.solve(n=np.float64(100.0)).solution is not None


def test_problems_are_read_by_their_own_functions() -> None:
    with pytest.raises(TypeError, match="from_file"):
        poinsot.Problem("askew.yaml")  # type: ignore[arg-type]


def test_numbers_in_other_units() -> None:
    np.testing.assert_allclose(poinsot.in_unit([0.0, 2 * np.pi], "rpm"), [0, 60], rtol=1e-15)
    assert poinsot.in_unit(4.4482216152605, "lb") == pytest.approx(1, rel=1e-12)
    assert poinsot.in_unit(3.0, "") == 3
    with pytest.raises(ValueError, match="furlong"):
        poinsot.in_unit(1.0, "furlong/s")


def test_numbers_of_a_unit_go_to_si_and_back(askew: poinsot.Problem) -> None:
    speeds = poinsot.in_si(np.linspace(1000, 3000, 3), "rpm")
    np.testing.assert_allclose(speeds, np.linspace(1000, 3000, 3) * 2 * np.pi / 60, rtol=1e-15)
    np.testing.assert_allclose(poinsot.in_unit(speeds, "rpm"), [1000, 2000, 3000], rtol=1e-15)
    study = poinsot.study(askew, {"n": speeds}, "B")
    assert study["B.y"][1] == pytest.approx(askew.solve(n="2000 rpm")["B"].si[1], rel=1e-12)
    assert repr(study).startswith("<poinsot.Study of 3 rows over n / rad/s: B.x")
    with pytest.raises(ValueError, match="unit"):
        poinsot.in_si(1, "turns")
    with pytest.raises(TypeError, match="numbers in rpm"):
        poinsot.in_si("fast", "rpm")


def test_a_symbol_is_no_value(askew: poinsot.Problem) -> None:
    with pytest.raises(TypeError, match=r"n: w/2 has no value\. problem.with_letters\('n'\) makes a letter .*letters: \{n: rad/s\}"):
        askew.solve(n=sympy.Symbol("w") / 2)
    assert askew.solve(n=2 * sympy.pi)["T"].si == pytest.approx(askew.solve(n=2 * np.pi)["T"].si, rel=1e-15)
