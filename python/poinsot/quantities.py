"""Values that go into a problem: text with unit, numbers in SI units, quantities of pint."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _core
from .errors import StatementError

if TYPE_CHECKING:
    from .problem import Problem

# Text ("3000 rpm"), a number in SI units, a quantity of pint, or three of them for a vector.
Value: TypeAlias = Any

_SYMBOLS = {"kilogram": "kg", "meter": "m", "second": "s", "radian": "rad", "kelvin": "K"}


def given(sets: Mapping[str, Value] | None, values: Mapping[str, Value]) -> dict[str, Value]:
    """All values of a call: those of its mapping and its keywords."""
    # The caller may not have the types checked.
    if sets is not None and not isinstance(sets, Mapping):
        raise TypeError(f"values are given by name, as n='3000 rpm' or {{'n': '3000 rpm'}}, not as {sets!r}")
    both = {**(sets or {}), **values}
    for name in both:
        if not isinstance(name, str):
            raise TypeError(f"values are given by name, and {name!r} is none")
    return both


def real(value: Any) -> float:
    """A number; TypeError of what is none, of truth values and of complex numbers, whose imaginary part NumPy would drop."""
    if isinstance(value, (bool, np.bool_)) or np.iscomplexobj(value) or not hasattr(value, "__float__"):
        raise TypeError(f"a real number is expected, not {value!r}")
    return float(value)


def _number(value: Any, name: str) -> str:
    number = real(value)
    if not math.isfinite(number):
        raise ValueError(f"{name}: {number} is no value")
    return repr(number)


def _of_pint(quantity: Any, name: str) -> str:
    base = quantity.to_base_units()
    unit = ""
    for part, exponent in base.unit_items() if hasattr(base, "unit_items") else base.units._units.items():
        if part not in _SYMBOLS:
            raise ValueError(f"{name}: the unit {quantity.units} has '{part}' in it, of which no problem file knows")
        if exponent != int(exponent):
            raise ValueError(f"{name}: the unit {quantity.units} has a broken power of '{part}'")
        unit += ("*" if unit else "") + _SYMBOLS[part] + (f"^{int(exponent)}" if exponent != 1 else "")
    return f"{_number(base.magnitude, name)} {unit}".strip()


def is_found(value: Any) -> bool:
    """Whether it is an answer or an unknown, which have their units with them."""
    return hasattr(value, "si") and isinstance(getattr(value, "unit", None), str)


def _is_several(value: Value) -> bool:
    magnitude = getattr(value, "magnitude", value)
    return not isinstance(magnitude, str) and hasattr(magnitude, "__len__") and getattr(magnitude, "ndim", 1) > 0


def text_of(value: Value, unit: str | None, name: str) -> str:
    """The value as a problem file would have it. unit: the SI unit of plain numbers, None where it is not known."""
    if isinstance(value, str):
        return value
    if is_found(value):
        return text_of(value.si, _core.si_unit_of(value.unit), name)
    if hasattr(value, "to_base_units"):
        magnitude = value.magnitude
        if getattr(magnitude, "ndim", 0) or isinstance(magnitude, (list, tuple)):
            return "[" + ", ".join(text_of(one * value.units, unit, name) for one in magnitude) + "]"
        return _of_pint(value, name)
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name}: a truth value is no value with unit")
    if isinstance(value, (Mapping, set, bytes)):
        raise TypeError(f"{name}: expected text with unit, a number in SI units or a quantity of pint, not {value!r}")
    if hasattr(value, "free_symbols") and value.free_symbols:
        raise TypeError(
            f"{name}: {value} has no value. problem.with_letters('{name}') makes a letter of a datum, as letters: "
            f"{{{name}: {unit or 'its unit'}}} does in a file: what hangs on it then has a formula, answer.formula and answer.sympy()"
        )
    if isinstance(value, Iterable) and getattr(value, "ndim", None) != 0:
        return "[" + ", ".join(text_of(one, unit, name) for one in value) + "]"
    try:
        number = _number(value, name)
    except TypeError:
        raise TypeError(
            f"{name}: expected text with unit, a number in SI units or a quantity of pint, not {value!r}"
        ) from None
    if unit is None:
        raise ValueError(
            f"{name}: its value is stated without a unit of its own, so that a plain number could mean anything: "
            f"write text with unit, as '{number} kg*m^2'"
        )
    return f"{number} {unit}".strip()


def settings(problem: Problem, values: Mapping[str, Value]) -> list[tuple[str, str]]:
    """The values as texts, by the units of the problem."""
    sets = []
    for name, value in values.items():
        # A vector's components may stand alone: w.x has the unit of w.
        # Of a name that the problem does not know it says itself what is wrong.
        unit = problem._units.get(name, problem._units.get(name.split(".")[0], ""))
        if name in problem._numbers and _is_several(value) and not isinstance(value, (Mapping, set, bytes)):
            raise ValueError(
                f"{name}: a call takes one value, and this is a list of {len(value)}: "
                f"ask for all of them at once by poinsot.study(problem, over={{'{name}': values}})"
            )
        sets.append((name, text_of(value, unit, name)))
    return sets


def in_unit(si: npt.ArrayLike, unit: str) -> Any:
    """Numbers in SI units as numbers of another unit of problem files: in_unit(study["n"], "rpm")."""
    if hasattr(si, "to_base_units"):
        raise TypeError(f"in_unit() takes plain numbers in SI units, not {si!r}")
    if is_found(si):
        return converted(si.si, si.unit, unit)  # type: ignore[union-attr]
    return numbers(si, "numbers in SI units") / factor(unit)


def in_si(values: npt.ArrayLike, unit: str) -> Any:
    """Numbers of a unit of problem files as numbers in SI units, which calls take: in_si(np.linspace(1000, 3000, 21), "rpm")."""
    if hasattr(values, "to_base_units") or is_found(values):
        raise TypeError(f"in_si() takes plain numbers and their unit, not {values!r}: calls take what has a unit as it is")
    return numbers(values, f"numbers in {unit}") * factor(unit)


def converted(si: Any, measured: str, unit: str) -> Any:
    """Numbers in the SI unit of `measured` as numbers of another unit of the same kind."""
    try:
        _letter(unit).value_in_si("x", f"1 {measured}".strip())
    except StatementError:
        raise ValueError(f"a value in {measured or 'no unit'} cannot be told in '{unit}'") from None
    return in_unit(si, unit)


def numbers(value: npt.ArrayLike, what: str) -> npt.NDArray[np.float64]:
    """An array of NumPy, in SI units of what has a unit."""
    if is_found(value):
        value = value.si  # type: ignore[union-attr]
    try:
        array = np.asarray(value)
        # Dates and spans of time would become nanoseconds, complex numbers lose a part, and texts become what they say.
        if array.dtype.kind in "iuf" or (array.dtype.kind == "O" and value is not None):
            return np.asarray(array, dtype=float)
    except (TypeError, ValueError):
        pass
    raise TypeError(f"expected {what}, not {value!r}")


@functools.lru_cache(maxsize=256)
def factor(unit: str) -> float:
    """How many of the SI unit one of this unit is."""
    return float(_letter(unit).value_in_si("x", f"1 {unit}".strip()))


def in_si_of(value: Value, unit: str, name: str) -> Any:
    """A text or a quantity of pint of the same kind as `unit` in SI units."""
    try:
        return _letter(unit).value_in_si("x", text_of(value, None, name))
    except StatementError:
        raise TypeError(f"{name} is in {unit or 'no unit'}, and {value!r} is none of its kind") from None


def _letter(unit: str) -> Any:
    si_unit(unit)  # says what is wrong with it
    return _core.Problem.from_text(f"letters: {{x: {unit or 1}}}", unit, None, None)[0]


def si_unit(unit: str) -> str:
    """The coherent SI unit of what a unit measures: "rad/s" of "rpm"."""
    if not isinstance(unit, str):
        raise TypeError(f"a unit is a text, as 'rpm', not {unit!r}")
    return _core.si_unit_of(unit)
