"""Charts of studies and motions, drawn by Matplotlib with names and units at their axes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import quantities

if TYPE_CHECKING:
    from .motion import MotionValues
    from .studies import Study

Array = npt.NDArray[np.float64]


def axes_or_new(ax: Any) -> Any:
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot as plt
    except ImportError:
        raise ImportError("charts are drawn by Matplotlib, which is not installed: pip install matplotlib") from None
    return plt.figure().add_subplot()


class Shown:
    """Columns in the units in which they are shown."""

    def __init__(self, si_units: Mapping[str, str], units: Mapping[str, str] | None) -> None:
        self._si_units, self._units = si_units, dict(units or {})
        for name in self._units:
            if name not in si_units:
                raise KeyError(f"there is no column '{name}' to show in {self._units[name]}: expected {', '.join(si_units)}")

    def unit(self, name: str) -> str:
        return self._units.get(name, self._si_units[name])

    def numbers(self, name: str, si: Array) -> Array:
        if name not in self._units:
            return si
        return np.asarray(quantities.converted(si, self._si_units[name], self._units[name]))

    def label(self, name: str) -> str:
        return f"{name} / {self.unit(name)}" if self.unit(name) else name

    def label_of_all(self, names: Iterable[str]) -> str:
        """What stands at the axis of several columns, which have one unit."""
        units = {self.unit(name): name for name in names}
        if len(units) > 1:
            told = ", ".join(f"{name} in {unit or 'no unit'}" for unit, name in units.items())
            raise ValueError(f"one axis has one unit, and here are {told}: draw them one by one, or give one by units")
        return ", ".join(names) + (f" / {unit}" if (unit := next(iter(units))) else "")


def of_study(study: Study, answers: Sequence[str], over: str, shown: Shown, ax: Any) -> Any:
    """Answers over one of what was varied: lines for each value of the other lists and spans, points of random values."""
    drawn = axes_or_new(ax)
    others = [name for name in study.over if name != over]
    drawn.set_xlabel(shown.label(over))
    drawn.set_ylabel(shown.label_of_all(answers))
    x = shown.numbers(over, study[over])
    if study.is_random:
        for name in answers:
            drawn.plot(x, shown.numbers(name, study[name]), ".", markersize=2, label=name)
    else:
        lines = {tuple(row): None for row in np.stack([study[one] for one in others], axis=1).tolist()} if others else {(): None}
        if len(lines) * len(answers) > _MOST_LINES:
            raise ValueError(f"{len(lines) * len(answers)} lines are too many: draw a smaller study, or take .frame()")
        for values in lines:
            rows = np.ones(len(x), dtype=bool)
            for one, value in zip(others, values, strict=True):
                rows &= study[one] == value
            of_line = [_value(shown, one, value) for one, value in zip(others, values, strict=True)]
            order = np.argsort(x[rows], kind="stable")
            for name in answers:
                label = ", ".join([name] * (len(answers) > 1 or not others) + of_line)
                drawn.plot(x[rows][order], shown.numbers(name, study[name])[rows][order], label=label)
    if len(answers) > 1 or (others and not study.is_random):
        drawn.legend()
    return drawn


_MOST_LINES = 30


def _value(shown: Shown, name: str, si: float) -> str:
    return f"{name} = {float(shown.numbers(name, np.asarray(si))):.6g} {shown.unit(name)}".strip()


def distribution(study: Study, name: str, shown: Shown, ax: Any) -> Any:
    """How often an answer has which value."""
    drawn = axes_or_new(ax)
    column = shown.numbers(name, study[name])
    drawn.hist(column[np.isfinite(column)], bins="auto")
    drawn.set_xlabel(shown.label(name))
    drawn.set_ylabel("rows")
    return drawn


def tornado(study: Study, name: str, shown: Shown, ax: Any) -> Any:
    """The bars of Study.tornado(), the longest at the top."""
    drawn = axes_or_new(ax)
    frame = study.tornado(name)
    low, high = (shown.numbers(name, frame[one].to_numpy()) for one in ("low", "high"))
    places = np.arange(len(frame))[::-1]
    # Else a bar would end at the edge of the picture.
    drawn.use_sticky_edges = False
    drawn.barh(places, high - low, left=low)
    drawn.set_yticks(places, list(frame.index))
    drawn.axvline(float(np.nanmean(shown.numbers(name, study[name]))), color="black", linewidth=0.8)
    drawn.set_xlabel(shown.label(name))
    return drawn


def of_motion(values: MotionValues, names: Sequence[str], shown: Shown, ax: Any) -> Any:
    """Quantities over the time, components of vectors as lines of their own."""
    drawn = axes_or_new(ax)
    drawn.set_xlabel("time / s")
    drawn.set_ylabel(shown.label_of_all(names))
    lines = 0
    for name in names:
        array = shown.numbers(name, values[name])
        parts = [(name, array)] if array.ndim == 1 else [
            (f"{name}.{axis}", part) for axis, part in zip(values.axes[name], array.T, strict=True)
        ]
        for label, part in parts:
            drawn.plot(values.times, part, label=label)
            lines += 1
    if lines > 1:
        drawn.legend()
    return drawn
