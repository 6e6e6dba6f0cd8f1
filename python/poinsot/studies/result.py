"""What a study found."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .. import charts
from ..answers import ByName
from ..errors import PoinsotError
from ..wording import in_python
from . import shards
from .axes import Array, is_random
from .plan import MANIFEST, PLAN, Plan

if TYPE_CHECKING:
    import pandas


class StudyError(PoinsotError):
    """A study cannot be run there, or is not finished."""


class Study(Mapping[str, Array]):
    """The rows of a study: columns of numbers in SI units by name, for what was varied and for the answers. A row without
    an answer has NaN there, and its reason."""

    def __init__(self, plan: Plan, counts: shards.Counts, folder: Path | None, kept: dict[int, shards.Rows]) -> None:
        self.plan, self.counts, self.folder = plan, counts, folder
        self._kept = kept
        self.units = shards.units(plan)
        cases = plan.compiled()
        self.over = list(plan.over)
        columns = [one.name for one in cases.columns]
        answers = len(columns) // (1 + len(plan.sensitivities))
        self.answers = columns[:answers]
        # Derivatives: "T by n", in SI units, for each of the data that answers were differentiated by.
        self.sensitivities = columns[answers:]
        # Why the rows were solved one by one; "" if they went by formulas.
        self.no_formulas = in_python(cases.no_formulas)
        self._columns: dict[str, Array] = {}

    @classmethod
    def open(cls, folder: Any) -> Study:
        """A study that was finished, from its folder."""
        import json

        at = Path(folder)
        if not (at / MANIFEST).exists():
            raise StudyError(f"{at} holds no finished study")
        plan = Plan.from_json((at / PLAN).read_text(encoding="utf-8"))
        manifest = json.loads((at / MANIFEST).read_text(encoding="utf-8"))
        counts = shards.Counts(**{name: manifest[name] for name in shards.Counts.__dataclass_fields__})
        return cls(plan, counts, at, {})

    def __getitem__(self, name: str) -> Array:
        """A column; under the name of an answer that is a vector all of its components, a row of them for each row."""
        answers = [one for one in self.units if one not in self.plan.over and " by " not in one]
        components = [one for one in answers if one.startswith(f"{name}.")]
        if name not in self.units and components:
            return np.stack([self[one] for one in components], axis=1)
        if name not in self.units:
            ByName(self.units, "column of the study")[name]  # raises, with what there is
        if name not in self._columns:
            self._columns[name] = np.concatenate([self._part(shard, name) for shard in range(self.plan.shards)])
        return self._columns[name]

    def _parts_of(self, name: str) -> list[str]:
        """The columns of single numbers that a name stands for."""
        return [name] if self[name].ndim == 1 else [one for one in self.answers if one.startswith(f"{name}.")]

    def _number(self, name: str) -> Array:
        """A column of single numbers."""
        column = self[name]
        if column.ndim != 1:
            raise ValueError(f"{name} has several numbers in each row: expected {', '.join(self._parts_of(name))}")
        return column

    def _part(self, shard: int, name: str) -> Any:
        if self.folder is None:
            rows = self._kept[shard]
            return rows.over[name] if name in rows.over else rows.answers[name]
        import pyarrow.parquet

        path = shards.path_of(self.folder, shard)
        column = pyarrow.parquet.read_table(path, columns=[name]).column(0)
        return column.to_numpy(zero_copy_only=False)

    def __iter__(self) -> Iterator[str]:
        return iter([*self.over, *self.answers, *self.sensitivities])

    def __len__(self) -> int:
        return len(self.units)

    @property
    def reasons(self) -> dict[int, str]:
        """Why answers are missing, by row."""
        found: dict[int, str] = {}
        for shard in range(self.plan.shards):
            first, _ = self.plan.bounds(shard)
            if self.folder is None:
                found.update((first + row, reason) for row, reason in self._kept[shard].reasons)
                continue
            import pyarrow.parquet

            column = pyarrow.parquet.read_table(shards.path_of(self.folder, shard), columns=["reason"]).column(0)
            if column.null_count < len(column):
                found.update((first + i, text) for i, text in enumerate(column.to_pylist()) if text is not None)
        return found

    def case(self, row: int) -> dict[str, str]:
        """What was varied in a row, as Problem.solve() takes it."""
        row = operator.index(row)
        if not 0 <= row < self.plan.total:
            raise IndexError(f"there is no row {row}: the study has {self.plan.total}")
        values = self.plan.values(row, 1)
        return {
            name: f"{float(column[0])!r} {self.units[name]}".strip()
            for name, column in zip(self.plan.over, values, strict=True)
        }

    def _shown(self, units: Mapping[str, str] | None) -> charts.Shown:
        """The columns in units that are wanted, of which one may stand for all components of a vector."""
        wanted: dict[str, str] = {}
        for name, unit in (units or {}).items():
            parts = [one for one in self.answers if one.startswith(f"{name}.")]
            wanted |= dict.fromkeys([name] if name in self.units else parts or [name], unit)
        return charts.Shown(self.units, wanted)

    def frame(self, units: Mapping[str, str] | None = None) -> pandas.DataFrame:
        """As a frame of pandas, in SI units; units={"b": "deg", "B": "kN"} has columns in these. They are in attrs["units"]."""
        import pandas

        shown = self._shown(units)
        columns = {name: shown.numbers(name, self[name]) for name in self}
        frame = pandas.DataFrame(columns, index=pandas.RangeIndex(self.plan.total, name="row"))
        reasons = self.reasons
        if reasons:
            frame["reason"] = pandas.Series(reasons, dtype=object)
        frame.attrs["units"] = {name: shown.unit(name) for name in self.units}
        return frame

    def summary(self, units: Mapping[str, str] | None = None) -> pandas.DataFrame:
        """Mean, standard deviation, extremes and quantiles of every answer, and how many rows have it; units as in frame()."""
        import pandas

        table, shown = {}, self._shown(units)
        for name in self.answers:
            column = shown.numbers(name, self[name][np.isfinite(self[name])])
            if len(column) == 0:
                table[name] = {"count": 0.0}
                continue
            low, lower, middle, upper, high = np.quantile(column, [0, 0.05, 0.5, 0.95, 1])
            table[name] = {
                "count": float(len(column)),
                "mean": column.mean(),
                "std": column.std(ddof=1) if len(column) > 1 else np.nan,
                "min": low,
                "5 %": lower,
                "50 %": middle,
                "95 %": upper,
                "max": high,
            }
        frame = pandas.DataFrame(table).T
        frame.attrs["units"] = {name: shown.unit(name) for name in self.answers}
        return frame

    def yield_of(self, good: npt.NDArray[np.bool_] | Callable[[Study], npt.NDArray[np.bool_]]) -> float:
        """The part of the rows that are good: study.yield_of(study["B.y"] < 500), or a function of the study that gives
        this. Rows without answer are not."""
        passed = np.asarray(good(self) if callable(good) else good)
        if passed.dtype != bool:
            raise TypeError(f"expected a truth value for each row, as study['B.y'] < 500, not {good!r}")
        if passed.shape != (self.plan.total,):
            raise ValueError("one truth value is expected for each row")
        answered = np.ones(self.plan.total, dtype=bool)
        answered[list(self.reasons)] = False
        return float((passed & answered).mean())

    def worst(self, name: str, *, least: bool = False) -> int:
        """The row with the largest value of an answer, or the least: study.case(row) tells its data."""
        column = self._number(name)
        if not np.isfinite(column).any():
            raise StudyError(f"no row has an answer for {name}")
        return int(np.nanargmin(column) if least else np.nanargmax(column))

    def tornado(self, name: str) -> pandas.DataFrame:
        """How much of the spread of an answer comes from each random value: the change of its mean from the lower to
        the upper tenth of that value, the largest first."""
        import pandas

        answer = self._number(name)
        if not self.is_random:
            raise StudyError("a tornado chart compares random values, as tolerance('20 deg', '0.3 deg'), and here are none")
        table = {}
        for varied, axis in self.plan.over.items():
            if not is_random(axis):
                continue
            column = self[varied]
            low, high = np.quantile(column, [0.1, 0.9])
            below, above = np.nanmean(answer[column <= low]), np.nanmean(answer[column >= high])
            table[varied] = {"low": float(below), "high": float(above), "change": float(above - below)}
        frame = pandas.DataFrame(table, index=["low", "high", "change"]).T
        frame.attrs["units"] = {one: self.units[name] for one in ("low", "high", "change")}
        return frame.loc[frame["change"].abs().sort_values(ascending=False).index]

    @property
    def is_random(self) -> bool:
        """Whether something of what was varied has a distribution."""
        return any(map(is_random, self.plan.over.values()))

    def plot(
        self, *answers: str, over: str = "", units: Mapping[str, str] | None = None, ax: Any = None
    ) -> Any:
        """Draws answers over one of what was varied, the first by default, by Matplotlib; all that have the unit of the first
        answer, if none is named.

        Lists and spans give lines, one for each value of the others, random values points. units={"n": "rpm", "B.y": "kN"} shows
        them in these; ax: the axes of a figure to draw on, which are returned.
        """
        first = over or self.over[0]
        if first not in self.over:
            raise ValueError(f"{first} was not varied: expected {', '.join(self.over)}")
        wanted = answers or tuple(one for one in self.answers if self.units[one] == self.units[self.answers[0]])
        return charts.of_study(self, [part for one in wanted for part in self._parts_of(one)], first, self._shown(units), ax)

    def plot_distribution(self, name: str, *, units: Mapping[str, str] | None = None, ax: Any = None) -> Any:
        """Draws how often an answer has which value, by Matplotlib."""
        self._number(name)
        return charts.distribution(self, name, self._shown(units), ax)

    def plot_tornado(self, name: str, *, units: Mapping[str, str] | None = None, ax: Any = None) -> Any:
        """Draws the tornado chart of tornado(), by Matplotlib."""
        return charts.tornado(self, name, self._shown(units), ax)

    def __repr__(self) -> str:
        missing = self.counts.rows - self.counts.answered
        without = f", {missing} without an answer" if missing else ""
        over = ", ".join(f"{name} / {self.units[name]}" if self.units[name] else name for name in self.over)
        return f"<poinsot.Study of {self.counts.rows} rows over {over}{without}: {', '.join(self.answers)}>"

    def _repr_html_(self) -> str:
        frame = self.frame()
        headed = frame.rename(columns={name: f"{name} / {unit}" if unit else name for name, unit in self.units.items()})
        return str(headed.to_html(max_rows=10))
