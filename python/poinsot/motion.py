"""Motions, their quantities as arrays over time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core, calls, charts, notebook
from . import quantities as quantity_values
from .errors import PoinsotError, StatementError
from .wording import in_python

if TYPE_CHECKING:
    import pandas
    import xarray

    from .problem import Problem

Array = npt.NDArray[np.float64]


class Motion:
    """The motion of a problem: followed as far as it is asked for, once, and asked for quantities at any times.

        motion = problem.motion()
        values = motion(np.linspace(0, 10, 1001), "theta", "angular_velocity(disk)", E="kinetic_energy(disk)")
        values["theta"], values["E"]
    """

    def __init__(self, core: _core.Motion, problem: Problem, sets: Mapping[str, quantity_values.Value]) -> None:
        self._core, self._problem, self._sets = core, problem, sets

    @property
    def coordinates(self) -> list[str]:
        """The coordinates with names; they and their rates (theta') can be asked for."""
        names: list[str] = self._problem._called(self._core.coordinates, None, False)
        return names

    def __call__(
        self,
        times: npt.ArrayLike,
        *quantities: str,
        axes: str = "",
        timeout: float | None = None,
        progress: calls.Progress = None,
        **named: str,
    ) -> MotionValues:
        """Quantities at times (numbers in s or pint's, in any order), each asked for as in a problem file; by default the coordinates.

        Keywords give names: E="kinetic_energy(disk)". axes: those of vectors, as `axes:` of a question. What has no answer
        raises NoAnswer.
        """
        at = np.atleast_1d(quantity_values.numbers(_in_seconds(times), "times as numbers in s"))
        if at.ndim != 1:
            raise ValueError(f"times are one number or a list of them, not an array of {at.ndim} dimensions")
        for one in (*quantities, *named.values()):
            if not isinstance(one, str):
                raise TypeError(f"quantities are texts, one by one, motion(times, 'theta', \"theta'\"), not {one!r}")
        names = [*quantities, *named]
        if len(set(names)) != len(names):
            raise ValueError(f"a name is given to two quantities: {', '.join(names)}")
        texts = [*quantities, *named.values()]
        if not texts:
            names = texts = self.coordinates
            if not names:
                raise ValueError(
                    "no coordinate of the problem has a name, as angle: theta gives one to a joint: say which quantities are asked, "
                    "as 'kinetic_energy(disk)'"
                )

        def call(*ends: Any) -> Any:
            return self._core.values(at.tolist(), texts, axes, *ends)

        try:
            return MotionValues(at, names, self._problem._called(call, timeout, progress))
        except StatementError as error:
            for one in texts:
                if one in self._problem.questions and not self._knows(one, axes):
                    hint = f"it is a question: a motion is asked for its quantity, {one}='{self._problem.questions[one]}'"
                    error.diagnostics = [replace(error.diagnostics[0], hint=hint)]
            raise

    def attitude(self, times: npt.ArrayLike, body: str, *, timeout: float | None = None, progress: calls.Progress = None) -> Array:
        """How a body is turned at times, as matrices: their columns are the body's axes, which lie along those of the figure
        where it is drawn, on the axes of the ground. scipy.spatial.transform.Rotation.from_matrix() makes quaternions of them."""
        if not isinstance(body, str):
            raise TypeError(f"a body is told by its name, not by {body!r}")
        if not self([], f"angular_velocity({body})").axes:
            raise ValueError("in a planar problem a body is turned by an angle: angle: theta at its joint names it, and 'theta' asks for it")
        # Rows of the matrices are the ground's axes on those of the body.
        rows = self(
            times, x="[1 m, 0, 0]", y="[0, 1 m, 0]", z="[0, 0, 1 m]", axes=body, timeout=timeout, progress=progress
        )  # fmt: skip
        return np.stack(list(rows.values()), axis=1)

    def _knows(self, quantity: str, axes: str) -> bool:
        """Whether a text is a quantity of the problem, which the name of a question need not be."""
        try:
            self._core.values([], [quantity], axes, None, None)
        except StatementError:
            return False
        return True

    def __repr__(self) -> str:
        return f"<poinsot.Motion of '{self._problem.title or self._problem.name}'>"

    def _repr_html_(self) -> str | None:
        """Its player: the report of the problem, in a frame, with the player at its top."""
        try:
            return notebook.with_player_first(self._problem.report(self._sets))._repr_html_()
        except PoinsotError:
            return None


def _in_seconds(times: Any) -> Any:
    """Times that have their unit with them, as numbers: quantities of pint, spans of time of NumPy and pandas."""
    if hasattr(times, "to_base_units"):
        return times.to("s").magnitude
    if getattr(getattr(times, "dtype", None), "kind", "") == "m":
        return np.asarray(times) / np.timedelta64(1, "s")
    return times


class MotionValues(Mapping[str, Array]):
    """Arrays over time by name, in SI units: one number for each time, or for a vector a row of three."""

    def __init__(self, times: Array, names: Sequence[str], core: _core.MotionValues) -> None:
        self.times = times
        self._arrays: dict[str, Array] = {name: one.si for name, one in zip(names, core.series, strict=True)}
        self.units: dict[str, str] = {name: one.unit for name, one in zip(names, core.series, strict=True)}
        self.axes: dict[str, list[str]] = {
            name: one.axes for name, one in zip(names, core.series, strict=True) if one.axes
        }
        self.checks: dict[str, float] = core.checks
        self.notes = [in_python(note) for note in core.notes]

    def __getitem__(self, name: str) -> Array:
        try:
            return self._arrays[name]
        except KeyError:
            raise KeyError(f"'{name}' was not asked for: there are {', '.join(self._arrays)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def frame(self, units: Mapping[str, str] | None = None) -> pandas.DataFrame:
        """As a frame of pandas over the time in seconds, in SI units or in those of units={"theta": "deg"}, which are in
        attrs["units"]; components of vectors are columns of their own."""
        import pandas

        shown = charts.Shown(self.units, units)
        columns: dict[str, Array] = {}
        of: dict[str, str] = {}
        for name, si in self._arrays.items():
            array, unit = shown.numbers(name, si), shown.unit(name)
            if array.ndim == 1:
                columns[name], of[name] = array, unit
                continue
            for axis, component in zip(self.axes[name], array.T, strict=True):
                columns[f"{name}.{axis}"], of[f"{name}.{axis}"] = component, unit
        frame = pandas.DataFrame(columns, index=pandas.Index(self.times, name="time"))
        frame.attrs["units"] = {"time": "s", **of}
        return frame

    def dataset(self) -> xarray.Dataset:
        """As a dataset of xarray over the time in seconds; axes of vectors are a dimension, units attributes."""
        import xarray

        arrays: dict[str, Any] = {}
        axes: dict[str, list[str]] = {}
        for name, array in self._arrays.items():
            unit = {"units": self.units[name]}
            if array.ndim == 1:
                arrays[name] = ("time", array, unit)
                continue
            # Vectors on the same axes share the dimension.
            dimension = next((one for one, known in axes.items() if known == self.axes[name]), f"axis{len(axes) or ''}")
            axes[dimension] = self.axes[name]
            arrays[name] = (("time", dimension), array, unit)
        return xarray.Dataset(arrays, {"time": ("time", self.times, {"units": "s"}), **axes})

    def plot(self, *names: str, units: Mapping[str, str] | None = None, ax: Any = None) -> Any:
        """Draws quantities over the time by Matplotlib; all that have the unit of the first, if none is named.
        units={"theta": "deg"} shows them in these; ax: the axes of a figure to draw on, which are returned."""
        if not names:
            names = tuple(name for name, unit in self.units.items() if unit == self.units[next(iter(self.units))])
        for name in names:
            self[name]  # raises, with what there is
        return charts.of_motion(self, names, charts.Shown(self.units, units), ax)

    def __repr__(self) -> str:
        return f"<poinsot.MotionValues of {', '.join(self._arrays)} at {len(self.times)} times>"

    def _repr_html_(self) -> str:
        frame = self.frame()
        units = frame.attrs["units"]
        headed = frame.rename(columns={name: f"{name} / {unit}" if unit else name for name, unit in units.items()})
        return str(headed.to_html(max_rows=10))
