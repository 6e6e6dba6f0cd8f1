"""Problem files and what they answer."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeVar, overload

import numpy.typing as npt

from . import _core, calls, quantities
from .answers import Explanation, Result
from .errors import Interrupted, NoAnswer, StatementError
from .motion import Motion, MotionValues
from .notebook import Page, Picture

_Kind = TypeVar("_Kind", bound=Result)


@dataclass(frozen=True)
class Recording:
    """What Problem.record() wrote."""

    path: str
    rows: int
    columns: int
    end: float  # time of the last row, s
    complete: bool
    resumed_at: int  # the number of rows that were there before
    notes: tuple[str, ...]  # events during the motion


class Problem:
    """A problem file that was read and checked. It does not change, and threads may share it."""

    def __init__(self, core: _core.Problem | None = None, text: str = "", opened: tuple[str, ...] = ()) -> None:
        # The caller may not have the types checked.
        if not isinstance(core, _core.Problem):
            raise TypeError("a problem is read by Problem.from_file(path) or Problem.from_text(text)")
        self._core = core
        self.text = text
        # The data of the text that are letters here.
        self._opened = opened
        # The SI units of what can be given; None where the file does not tell.
        self._units: dict[str, str | None] = {}
        # What is known to be a single number.
        self._numbers: set[str] = set()
        for situation in core.situations:
            for datum in situation.data:
                # A datum that is stated as a formula or a vector has no unit of its own.
                known = datum.unit or _is_number(datum.text)
                self._units[datum.name] = quantities.si_unit(datum.unit) if known else None
                if known:
                    self._numbers.add(datum.name)
            for letter in situation.letters:
                self._units[letter.name] = quantities.si_unit(letter.unit)
                self._numbers.add(letter.name)
            for unknown in situation.unknowns:
                self._units[unknown.name] = quantities.si_unit(unknown.unit)
                if not unknown.vector:
                    self._numbers.add(unknown.name)

    @classmethod
    def from_text(cls, text: str, name: str = "problem", *, timeout: float | None = None) -> Problem:
        """Reads the text of a problem file; `name` is used in messages. Files that it names are sought beside it: large
        meshes take their time, which `timeout` (s) or Ctrl-C ends."""
        if not isinstance(text, str) or not isinstance(name, str):
            raise TypeError(f"from_text() takes the text of a problem file, not {text if not isinstance(text, str) else name!r}")
        if "\n" not in text and text.endswith((".yaml", ".yml")):
            raise ValueError(f"'{text}' is the name of a file and no problem: Problem.from_file() reads files")
        return cls._read(text, name, timeout)

    @classmethod
    def from_file(cls, path: str | os.PathLike[str], *, timeout: float | None = None) -> Problem:
        """Reads a problem file. OSError if there is none, StatementError if it is wrong."""
        name = os.fspath(path)
        if "\n" in name:
            raise ValueError("this is the text of a problem and no path: Problem.from_text() reads texts")
        with open(name, encoding="utf-8", newline="") as file:
            text = file.read()
        return cls._read(text, name, timeout)

    @classmethod
    def _read(cls, text: str, name: str, timeout: float | None) -> Problem:
        return cls(_called(text, lambda *ends: _core.Problem.from_text(text, name, *ends), timeout, False), text)

    def with_letters(self, *names: str | Iterable[str]) -> Problem:
        """The problem with these data as letters without value, as if the file had letters: {m: kg} in place of
        given: {m: 8 kg}; without names with all data that are numbers. What hangs on them has a formula then:
        problem.with_letters("m", "r").solve()["T"].sympy(). Letters that are positive in the file are taken as positive."""
        wanted = [name for one in names for name in calls.texts(one, "names")]
        if not names:
            wanted = [name for name in self.data if name in self._numbers and name not in self.unknowns]
        opened = tuple(dict.fromkeys([*self._opened, *(one for one in wanted if one not in self.letters)]))
        with _Sources(self.text):
            return type(self)(self._core.with_letters(wanted), self.text, opened)

    def __reduce__(self) -> tuple[Any, ...]:
        if self._opened:
            return (_with_letters, (self.text, self.name, self._opened))
        return (type(self).from_text, (self.text, self.name))

    @property
    def name(self) -> str:
        return self._core.name

    @property
    def title(self) -> str:
        return self._core.title

    @property
    def data(self) -> dict[str, str]:
        """The data of the file and the texts of their values."""
        return {one.name: one.text for situation in self._core.situations for one in situation.data}

    @property
    def letters(self) -> dict[str, str]:
        """The letters, which have no value, and their units."""
        return {one.name: one.unit for situation in self._core.situations for one in situation.letters}

    @property
    def unknowns(self) -> dict[str, str]:
        """What is to be found, and its units."""
        return {one.name: one.unit for situation in self._core.situations for one in situation.unknowns}

    @property
    def questions(self) -> dict[str, str]:
        return {one.name: one.text for one in self._core.questions}

    @property
    def claims(self) -> dict[str, str]:
        return {one.name: one.text for one in self._core.claims}

    def solve(
        self,
        sets: Mapping[str, quantities.Value] | None = None,
        /,
        *,
        timeout: float | None = None,
        progress: calls.Progress = None,
        **values: quantities.Value,
    ) -> Result:
        """Answers every question and decides every claim.

        Values of letters, data and unknowns are given by name, solve(n="3000 rpm"), or in a mapping, where a name is no
        name of Python: text with unit, numbers in SI units, quantities of pint; three of them for a vector. After
        `timeout` seconds the result holds what was found, and `ended` says so; Ctrl-C raises Interrupted, whose `found`
        is that result.
        """
        return self._found(Result, False, False, sets, timeout, progress, values)

    def explain(
        self,
        sets: Mapping[str, quantities.Value] | None = None,
        /,
        *,
        timeout: float | None = None,
        progress: calls.Progress = None,
        **values: quantities.Value,
    ) -> Explanation:
        """The same with a worked solution: to_markdown()."""
        return self._found(Explanation, False, True, sets, timeout, progress, values)

    def check(self, *, timeout: float | None = None, progress: calls.Progress = None) -> list[str]:
        """Compares the answers with the file's own `expect:` and describes each discrepancy."""
        shortfalls: list[str] = self._called(self._core.check, timeout, progress)
        return shortfalls

    def equations(
        self,
        form: str = "text",
        *,
        of: str | Sequence[str] = (),
        function: str = "equations",
        situation: str = "",
        sets: Mapping[str, quantities.Value] | None = None,
        letters: str | Sequence[str] = (),
        timeout: float | None = None,
        progress: calls.Progress = None,
    ) -> str:
        """The equations of motion as "text", "tex", "c", "c++", "python" or "sympy".

        of: some of "mass-matrix", "right-hand-side", "constraint-matrix", "reduced", "position-rate",
        "forward-dynamics", "inverse-dynamics". letters: data that remain letters.
        """

        def call(*ends: Any) -> Any:
            given = quantities.settings(self, quantities.given(sets, {}))
            return self._core.equations(parts, form, function, situation, given, open_letters, *ends)

        parts, open_letters = calls.texts(of, "of"), calls.texts(letters, "letters")

        text: str = self._called(call, timeout, progress)
        return text

    @overload
    def motion(
        self,
        sets: Mapping[str, quantities.Value] | None = None,
        /,
        *,
        timeout: float | None = None,
        progress: calls.Progress = None,
        **values: quantities.Value,
    ) -> Motion: ...

    @overload
    def motion(
        self,
        times: npt.ArrayLike,
        /,
        *asked: str,
        timeout: float | None = None,
        progress: calls.Progress = None,
        **values: quantities.Value,
    ) -> MotionValues: ...

    def motion(
        self,
        first: Any = None,
        /,
        *asked: str,
        timeout: float | None = None,
        progress: calls.Progress = None,
        **values: quantities.Value,
    ) -> Motion | MotionValues:
        """The motion, to be asked for any quantities at any times. NoAnswer if there is not one motion.

        motion(times, "theta", "kinetic_energy(disk)", n="3000 rpm") asks it at once, as motion(n="3000 rpm")(times, ...) does.
        """
        at_once = first is not None and not isinstance(first, (Mapping, str))
        if asked and not at_once:
            raise TypeError(f"quantities are asked at times, as motion(np.linspace(0, 1, 101), {asked[0]!r}): name the times first")
        sets = quantities.given(None if at_once else first, values)
        given = quantities.settings(self, sets)

        def call(*ends: Any) -> Any:
            return self._core.motion(given, *ends)

        motion = Motion(self._called(call, timeout, progress), self, sets)
        return motion(first, *asked, timeout=timeout, progress=progress) if at_once else motion

    def record(
        self,
        path: str | os.PathLike[str],
        sets: Mapping[str, quantities.Value] | None = None,
        /,
        *,
        replace: bool = False,
        timeout: float | None = None,
        progress: calls.Progress = None,
        **values: quantities.Value,
    ) -> Recording:
        """Records the motion as the file says under `record:`, to a file that ends in .csv, .h5 or .hdf5.

        A recording that was stopped, by Ctrl-C, the timeout or a kill, goes on when it is called again, from the journal beside
        the file. replace: whether a file that is there without a journal is replaced; else that is a RecordingError.
        """
        given = quantities.settings(self, quantities.given(sets, values))

        def call(*ends: Any) -> Any:
            return self._core.record(os.fspath(path), given, replace, *ends)

        core = self._called(call, timeout, progress)
        return Recording(core.data, core.rows, core.columns, core.end, core.complete, core.resumed_at, tuple(core.notes))

    def figures(self, sets: Mapping[str, quantities.Value] | None = None, /, **values: quantities.Value) -> dict[str, str]:
        """The names of the figures that figure() draws, and what they show."""
        return dict(self._illustrated(sets, values)._core.figures(0))

    def figure(
        self,
        of: str = "model",
        sets: Mapping[str, quantities.Value] | None = None,
        /,
        *,
        view: str | Sequence[float] = "",
        with_values: bool = False,
        solution: int = 0,
        **values: quantities.Value,
    ) -> Picture:
        """A line drawing: "model", "free-body", "impulse", "motion", ... (see figures()).

        view: "front", "top", ..., azimuth and elevation in degrees, (30, 20), or the direction towards the viewer,
        (1, 2, 3). with_values: values beside the symbols. solution: its number, counted from 0.
        """
        if not isinstance(view, str):
            view = ",".join(f"{float(one):.17g}" for one in view)
        result = self._illustrated(sets, values)
        _known(solution, result)
        return Picture(result._core.to_svg(solution, of, view, with_values))

    def gltf(
        self, sets: Mapping[str, quantities.Value] | None = None, /, *, solution: int = 0, **values: quantities.Value
    ) -> bytes:
        """The bodies and their motion as a binary file of glTF (.glb), for other programs."""
        result = self._illustrated(sets, values)
        _known(solution, result)
        content: bytes = result._core.to_gltf(solution)
        return content

    def report(
        self,
        sets: Mapping[str, quantities.Value] | None = None,
        /,
        *,
        timeout: float | None = None,
        progress: calls.Progress = None,
        height: int = 720,
        **values: quantities.Value,
    ) -> Page:
        """One page with the statement, a view in space with the player of the motion, answers, worked solution."""
        result = self._found(Result, True, True, sets, timeout, progress, values)
        return Page(result._core.to_html(self._core, self.text), height)

    def _illustrated(self, sets: Mapping[str, Any] | None, values: Mapping[str, Any]) -> Result:
        result = self._found(Result, True, False, sets, None, None, values)
        result.solutions or result.solution  # raises, if there is nothing to draw
        return result

    def _found(
        self,
        kind: type[_Kind],
        scene: bool,
        explanation: bool,
        sets: Mapping[str, Any] | None,
        timeout: float | None,
        progress: calls.Progress,
        values: Mapping[str, Any],
    ) -> _Kind:
        given = quantities.settings(self, quantities.given(sets, values))

        def call(*ends: Any) -> Any:
            document, raised = self._core.solve(given, scene, explanation, *ends)
            return kind(document, self), raised

        found: _Kind = self._called(call, timeout, progress)
        return found

    def _called(
        self, call: Callable[..., tuple[Any, Any]], timeout: float | None, progress: calls.Progress
    ) -> Any:
        return _called(self.text, call, timeout, progress)

    def __repr__(self) -> str:
        return f"<poinsot.Problem '{self.title or self.name}'>"

    def _repr_svg_(self) -> str | None:
        try:
            return self.figure().svg
        except (StatementError, NoAnswer):
            return None


def _with_letters(text: str, name: str, opened: tuple[str, ...]) -> Problem:
    return Problem.from_text(text, name).with_letters(opened)


def _called(text: str, call: Callable[..., tuple[Any, Any]], timeout: float | None, progress: calls.Progress) -> Any:
    """The result of a call about the text of a problem, which the timeout, a signal or the listener may end."""
    heard = calls.listener(progress)
    try:
        with _Sources(text):
            found, raised = call(calls.seconds(timeout), heard)
    finally:
        calls.close(heard)
    if isinstance(raised, KeyboardInterrupt):
        interrupted = Interrupted("interrupted; `found` holds what was found until then")
        interrupted.found = found
        raise interrupted from None
    if raised is not None:
        raise raised
    return found


class _Sources:
    """Puts the line of the file into errors that come through."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: Any, error: BaseException | None, trace: Any) -> None:
        if isinstance(error, StatementError):
            error.diagnostics = [self._with_source(one) for one in error.diagnostics]

    def _with_source(self, one: Any) -> Any:
        if not one.line:
            return one
        lines = self.text.split("\n")
        return replace(one, source=lines[one.line - 1].rstrip("\r")) if one.line <= len(lines) else one


def _known(solution: int, result: Result) -> None:
    if calls.whole(solution, "solution", least=0) >= len(result.solutions):
        raise NoAnswer(f"there is no solution {solution}: there are {len(result.solutions)}, counted from 0")


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
