"""Answers in calculations.

An answer without a unit counts as its number, one with a unit as a quantity of pint. As a plain number one counts where no
one could take it for another: if its unit is that of the SI, in which all plain numbers are.
"""

from __future__ import annotations

import importlib
import operator
import sys
from collections.abc import Callable
from typing import Any

import numpy as np

from . import _core, quantities

_Operation = Callable[[Any, Any], Any]

# Comparisons by their names in NumPy, and what they are with their sides exchanged.
_COMPARED: dict[str, tuple[_Operation, _Operation]] = {
    "less": (operator.lt, operator.gt),
    "less_equal": (operator.le, operator.ge),
    "greater": (operator.gt, operator.lt),
    "greater_equal": (operator.ge, operator.le),
    "equal": (operator.eq, operator.eq),
    "not_equal": (operator.ne, operator.ne),
}


def _tell_pint() -> None:
    """Lets quantities of pint leave it to answers how they are added to and multiplied with such."""
    compatible = sys.modules.get("pint.compat")
    for name in ("Answer", "Unknown") if compatible else ():
        getattr(compatible, "upcast_type_map", {}).setdefault(f"{__package__}.answers.{name}", None)


class Calculates:
    """A value with a unit, in calculations."""

    name: str
    unit: str

    def __init__(self) -> None:
        _tell_pint()

    # Both come from the subclass, and raise NoAnswer where there is no value.
    @property
    def value(self) -> Any:
        raise NotImplementedError

    @property
    def si(self) -> Any:
        raise NotImplementedError

    def _plain(self) -> Any:
        """The value, if it is the same in SI units."""
        value = self.value
        if isinstance(value, (float, np.ndarray)) and quantities.factor(self.unit) != 1:
            raise TypeError(
                f"{self.name} is in {self.unit}, and a plain number would be one in {_core.si_unit_of(self.unit)}: "
                f"take .value, the number in {self.unit}, or .si"
            )
        return value

    def pint(self, registry: Any = None) -> Any:
        """The value as a quantity of pint, of the application's registry or of this one: in its unit where pint has the
        same, else in SI units."""
        try:
            library: Any = importlib.import_module("pint")
        except ImportError:
            raise TypeError(
                f"{self.name} has a unit, {self.unit}, and calculations with units take pint, which is not installed: "
                "take .value or .si, or pip install pint"
            ) from None
        _tell_pint()
        units = library.get_application_registry() if registry is None else registry
        value, si_unit = self.si, _core.si_unit_of(self.unit)
        if not isinstance(value, (float, np.ndarray)):
            raise TypeError(f"{self.name} is no number with a unit")
        quantity = units.Quantity(value, si_unit or "dimensionless")
        try:
            # A pound is a force here and a mass there.
            same = units.Quantity(1, self.unit).to(si_unit).magnitude / quantities.factor(self.unit)
        except Exception:
            return quantity
        return quantity.to(self.unit) if abs(same - 1) < 1e-14 else quantity

    def _operand(self, beside: Any = None) -> Any:
        if not self.unit:
            return self.value
        return self.pint(beside._REGISTRY if hasattr(beside, "to_base_units") else None)

    def _calculated(self, operation: _Operation, other: Any, *, reflected: bool = False) -> Any:
        if other is None or isinstance(other, (str, bytes)):
            return NotImplemented
        mine = self._operand(other)
        theirs = other._operand(mine) if isinstance(other, Calculates) else other
        return operation(theirs, mine) if reflected else operation(mine, theirs)

    def __add__(self, other: Any) -> Any:
        return self._calculated(operator.add, other)

    def __radd__(self, other: Any) -> Any:
        return self._calculated(operator.add, other, reflected=True)

    def __sub__(self, other: Any) -> Any:
        return self._calculated(operator.sub, other)

    def __rsub__(self, other: Any) -> Any:
        return self._calculated(operator.sub, other, reflected=True)

    def __mul__(self, other: Any) -> Any:
        return self._calculated(operator.mul, other)

    def __rmul__(self, other: Any) -> Any:
        return self._calculated(operator.mul, other, reflected=True)

    def __truediv__(self, other: Any) -> Any:
        return self._calculated(operator.truediv, other)

    def __rtruediv__(self, other: Any) -> Any:
        return self._calculated(operator.truediv, other, reflected=True)

    def __pow__(self, other: Any) -> Any:
        return self._calculated(operator.pow, other)

    def __rpow__(self, other: Any) -> Any:
        return self._calculated(operator.pow, other, reflected=True)

    def __neg__(self) -> Any:
        return -self._operand()

    def __pos__(self) -> Any:
        return +self._operand()

    def __abs__(self) -> Any:
        return abs(self._operand())

    def _compared(self, operation: _Operation, other: Any) -> Any:
        if isinstance(other, Calculates):
            if _core.si_unit_of(self.unit) != _core.si_unit_of(other.unit):
                raise TypeError(f"{self.name} is in {self.unit or 'no unit'} and {other.name} in {other.unit or 'no unit'}")
            return operation(self.si, other.si)
        mine = self.value
        if isinstance(other, str) and not isinstance(mine, str) or hasattr(other, "to_base_units"):
            return operation(self.si, quantities.in_si_of(other, self.unit, self.name))
        if isinstance(other, (bool, np.bool_, str)) or isinstance(mine, (bool, str)):
            return operation(mine, other)
        if not isinstance(other, (int, float, np.number, np.ndarray, list, tuple)):
            return NotImplemented
        # Nothing is nothing in all units.
        return operation(self.si, other) if np.ndim(other) == 0 and other == 0 else operation(self._plain(), other)

    def __lt__(self, other: Any) -> Any:
        return self._compared(operator.lt, other)

    def __le__(self, other: Any) -> Any:
        return self._compared(operator.le, other)

    def __gt__(self, other: Any) -> Any:
        return self._compared(operator.gt, other)

    def __ge__(self, other: Any) -> Any:
        return self._compared(operator.ge, other)

    def __eq__(self, other: Any) -> Any:
        return True if other is self else self._compared(operator.eq, other)

    def __ne__(self, other: Any) -> Any:
        return False if other is self else self._compared(operator.ne, other)

    # What is equal to a number and to a text has no one hash.
    __hash__ = None  # type: ignore[assignment]

    def __float__(self) -> float:
        return float(self._plain())

    def __bool__(self) -> bool:
        """Whether it holds, of conditions and claims; of a number whether it is not zero."""
        return bool(self.value)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        return np.asarray(self._plain(), dtype=dtype)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **keywords: Any) -> Any:
        # Those of NumPy: with a quantity of pint the sine of an angle in degrees is right.
        if method == "__call__" and ufunc.__name__ in _COMPARED:
            first, second = inputs
            if isinstance(first, Calculates):
                return first._compared(_COMPARED[ufunc.__name__][0], second)
            return second._compared(_COMPARED[ufunc.__name__][1], first)
        operands = [one._operand() if isinstance(one, Calculates) else one for one in inputs]
        return getattr(ufunc, method)(*operands, **keywords)
