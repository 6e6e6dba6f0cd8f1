"""What differs from case to case: lists, spans and distributions, and their values in SI units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, TypeAlias

import numpy as np
import numpy.typing as npt

from .. import calls, quantities

if TYPE_CHECKING:
    from ..problem import Problem

Array = npt.NDArray[np.float64]
# What a number is described by in the plan of a study: the kind of an axis and its numbers in SI units.
Described: TypeAlias = dict[str, Any]


@dataclass(frozen=True)
class Span:
    """Evenly spaced values, both ends among them."""

    first: quantities.Value
    last: quantities.Value
    count: int


@dataclass(frozen=True)
class Distribution:
    """A random value. Its two numbers are text with unit, numbers in SI units or quantities of pint."""

    first: quantities.Value
    second: quantities.Value
    kind: ClassVar[str]

    def numbers(self, problem: Problem, name: str) -> tuple[float, float]:
        first, second = number(problem, name, self.first), number(problem, name, self.second)
        self.hold(first, second, name)
        return first, second

    def hold(self, first: float, second: float, name: str) -> None:
        if not second > 0:
            raise ValueError(f"{name}: the spread of a {self.kind} distribution is more than zero, not {second}")


class Normal(Distribution):
    """Normal, with the mean and the standard deviation."""

    kind = "normal"


class Uniform(Distribution):
    """Uniform between two values."""

    kind = "uniform"

    def hold(self, first: float, second: float, name: str) -> None:
        if not second > first:
            raise ValueError(f"{name}: a uniform distribution goes from the smaller to the larger value")


class Tolerance(Distribution):
    """A value that is made within a tolerance: normal, with the limits at three standard deviations, and none beyond."""

    kind = "tolerance"


def span(first: quantities.Value, last: quantities.Value, count: int) -> Span:
    """`count` evenly spaced values from `first` to `last`."""
    return Span(first, last, calls.whole(count, "the count of a span", least=2))


def normal(mean: quantities.Value, deviation: quantities.Value) -> Normal:
    """Normal, with a mean and a standard deviation."""
    return Normal(mean, deviation)


def uniform(low: quantities.Value, high: quantities.Value) -> Uniform:
    """Uniform between two values."""
    return Uniform(low, high)


def tolerance(nominal: quantities.Value, plus_minus: quantities.Value) -> Tolerance:
    """Normal about a nominal value, with the limits at three standard deviations and no part beyond them."""
    return Tolerance(nominal, plus_minus)


def number(problem: Problem, name: str, value: quantities.Value) -> float:
    """A value of a letter or datum in SI units."""
    if isinstance(value, str):
        text = value
    elif hasattr(value, "to_base_units") or quantities.is_found(value):
        text = quantities.text_of(value, None, name)
    else:
        try:
            plain = quantities.real(value)
        except (TypeError, ValueError):
            raise TypeError(
                f"{name}: expected text with unit, numbers in SI units or quantities of pint, not {value!r}"
            ) from None
        if not np.isfinite(plain):
            raise ValueError(f"{name}: {plain} is no value")
        return plain
    return problem._core.value_in_si(name, text)


def described(problem: Problem, name: str, axis: Any) -> Described:
    """The axis as the plan of a study has it."""
    if isinstance(axis, Span):
        first, last = (number(problem, name, one) for one in (axis.first, axis.last))
        return {"span": [first, last], "count": axis.count}
    if isinstance(axis, Distribution):
        return {axis.kind: list(axis.numbers(problem, name))}
    if isinstance(axis, (str, bytes, Mapping, set)) or not np.iterable(axis):
        raise TypeError(f"{name}: expected a list of values, a span or a distribution, not {axis!r}")
    values = [number(problem, name, one) for one in axis]
    if not values:
        raise ValueError(f"{name}: the list of its values is empty")
    return {"values": values}


def is_random(axis: Described) -> bool:
    return not ("values" in axis or "span" in axis)


def grid_values(axis: Described) -> Array:
    """All values of a list or a span."""
    if "values" in axis:
        return np.array(axis["values"], dtype=float)
    first, last = axis["span"]
    spaced: Array = np.linspace(float(first), float(last), int(axis["count"]))
    return spaced


def largest(axis: Described) -> float:
    """How large its values become; of a normal distribution, where the bulk of them ends."""
    if not is_random(axis):
        return float(np.abs(grid_values(axis)).max())
    ((kind, (first, second)),) = axis.items()
    return float(max(abs(first), abs(second)) if kind == "uniform" else abs(first) + second)


def quantile(axis: Described, part: Array) -> Array:
    """The values of a distribution below which these parts of it lie."""
    if "uniform" in axis:
        low, high = axis["uniform"]
        return np.asarray(low + (high - low) * part)
    from scipy.special import ndtr, ndtri

    if "normal" in axis:
        mean, deviation = axis["normal"]
        return np.asarray(mean + deviation * ndtri(part))
    nominal, limit = axis["tolerance"]
    below = ndtr(-3.0)
    inner = nominal + limit / 3 * ndtri(below + (1 - 2 * below) * part)
    return np.asarray(np.clip(inner, nominal - limit, nominal + limit))
