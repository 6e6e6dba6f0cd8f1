"""What a problem answers."""

from __future__ import annotations

import json
from collections.abc import ItemsView, Iterable, Iterator, KeysView, Mapping, ValuesView
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import numpy as np

from . import _core, calls, formulas, notebook, quantities
from .arithmetic import Calculates
from .errors import NoAnswer
from .wording import in_python

if TYPE_CHECKING:
    import pandas

    from .problem import Problem

_Item = TypeVar("_Item")
_Same = TypeVar("_Same")


def _plain(value: Any) -> Any:
    """Lists of numbers as arrays of NumPy; everything else as it is."""
    if not isinstance(value, list):
        return value
    try:
        return np.array(value, dtype=float)
    except (TypeError, ValueError):
        return value


def _written(formula: Any) -> str:
    return f"({', '.join(map(_written, formula))})" if isinstance(formula, list) else str(formula)


def _each(function: Any, formula: Any) -> Any:
    return [_each(function, one) for one in formula] if isinstance(formula, list) else function(formula)


class ByName(Mapping[str, _Item], Generic[_Item]):
    """Things by name, in the order of the file."""

    def __init__(self, items: Mapping[str, _Item], what: str) -> None:
        self._items, self._what = dict(items), what

    def __getitem__(self, name: str) -> _Item:
        if not isinstance(name, str):
            raise TypeError(f"one {self._what} is sought by its name, as '{next(iter(self._items), 'T')}', not by {name!r}")
        try:
            return self._items[name]
        except KeyError:
            hint = _core.did_you_mean(name, list(self._items))
            known = f": expected {', '.join(self._items)}" if self._items else ""
            raise KeyError(f"there is no {self._what} '{name}'{known}{f' ({hint})' if hint else ''}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._items)

    def __contains__(self, name: object) -> bool:
        return name in self._items

    def __len__(self) -> int:
        return len(self._items)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{name!r}: {item!r}" for name, item in self._items.items()) + "}"


class _Stays:
    """What other processes do not get."""

    def __reduce__(self) -> Any:
        raise TypeError(
            f"{self!r} stays in its process: send numbers, answer.si, or result.to_dict(), or the problem, and solve it there"
        )

    # Nothing of it changes.
    def __copy__(self: _Same) -> _Same:
        return self

    def __deepcopy__(self: _Same, memo: Any) -> _Same:
        return self


class Found(_Stays, Calculates):
    """A value with its unit, and its formula where letters have no value."""

    def __init__(self, core: Any, positive: frozenset[str]) -> None:
        super().__init__()
        self._core, self._positive = core, positive
        self.name: str = core.name
        self.unit: str = core.unit
        # Text, a list of texts for vectors and matrices, or None.
        self.formula: Any = core.formula

    def _wanted(self, value: Any) -> Any:
        if value is None:
            raise NoAnswer(f"{self.name} has no value{self._why()}")
        return _plain(value)

    def _no_formula(self) -> str:
        why = getattr(self, "no_formula", "")
        return f" ({why})" if why else ""

    def _why(self) -> str:
        if self.formula is None:
            return ""
        return f" while letters are open: it is {_written(self.formula)}; give them values, as solve(m='2 kg'), or take .formula"

    @property
    def value(self) -> Any:
        """In `unit`: a number, an array of NumPy, a truth value or a text. NoAnswer if there is none."""
        return self._wanted(self._core.value)

    @property
    def si(self) -> Any:
        """The same in SI base units and radians."""
        return self._wanted(self._core.si)

    @property
    def tex(self) -> Any:
        """The formula as TeX; a list for vectors and matrices, None without formula."""
        return None if self.formula is None else _each(formulas.tex, self.formula)

    def sympy(self, *, assumptions: bool = False) -> Any:
        """The formula as an expression of SymPy; a matrix for vectors and matrices.

        Letters are symbols without assumptions, as sympy.Symbol("m") makes them. With assumptions=True they are real,
        and positive where the answer assumes it; for SymPy such a symbol is another than one of the same name without.
        """
        if self.formula is None:
            raise NoAnswer(
                f"{self.name} has no formula{self._no_formula()}: formulas are in letters without value, of which "
                "problem.with_letters('m', 'r') makes some of the data, and letters: {m: kg} in a file"
            )
        positive = set(self._positive) if assumptions else None
        found = _each(lambda text: formulas.to_sympy(text, positive), self.formula)
        if not isinstance(found, list):
            return found
        import sympy

        return sympy.Matrix(found)

    def to(self, unit: str) -> Any:
        """The value in another unit: answer.to("kJ")."""
        value = self.si
        if not isinstance(value, (float, np.ndarray)):
            raise TypeError(f"{self.name} is no number with a unit")
        return quantities.converted(value, self.unit, unit)

    def __str__(self) -> str:
        return notebook.text_of(self)

    def __format__(self, digits: str) -> str:
        """With unit: f"{answer:.2f}"."""
        if not digits:
            return str(self)
        value = self.value
        numbers = f"({', '.join(format(one, digits) for one in value)})" if np.ndim(value) == 1 else format(value, digits)
        return f"{numbers} {self.unit}".strip()

    def _repr_latex_(self) -> str | None:
        return notebook.equation(self)


class Unknown(Found):
    """What was found of an unknown."""

    def __repr__(self) -> str:
        return f"<{self.name} = {notebook.text_of(self)}>"

    def _repr_html_(self) -> str:
        return notebook.unknowns_html([self])


class Answer(Found):
    """The answer to a question or the verdict on a claim."""

    def __init__(self, core: _core.Answer, positive: frozenset[str]) -> None:
        super().__init__(core, positive)
        self.ask = core.ask
        self.words = core.words
        # "found", "needs_letters", "undetermined" or "refused".
        self.state = core.state
        # For every state but "found": why, and what would help.
        self.reason = in_python(core.reason)
        self.axes: list[str] = core.axes
        self.letters: list[str] = core.letters
        self.no_formula = in_python(core.no_formula)

    def _why(self) -> str:
        if self.is_table:
            return ": it is a table, see frame()"
        formula = super()._why()
        return f": {self.reason}" if self.reason else formula or (f": {self.no_formula}" if self.no_formula else "")

    @property
    def is_table(self) -> bool:
        return bool(self._core.columns) and self.state == "found"

    def frame(self, si: bool = False) -> pandas.DataFrame:
        """A table as a frame of pandas, its index what it runs over, if no column shows that; units are in attrs["units"]."""
        if not self.is_table:
            raise NoAnswer(f"{self.name} is no table")
        import pandas

        columns, over = self._core.columns, self._core.over
        index = pandas.Index(over.si if si else over.value, name=over.name) if over else None
        frame = pandas.DataFrame({one.name: one.si if si else one.value for one in columns}, index=index)
        if over:
            columns = [over, *columns]
        frame.attrs["units"] = {one.name: _core.si_unit_of(one.unit) if si else one.unit for one in columns}
        return frame

    def __getitem__(self, component: str | int) -> Any:
        """A component of the value, by the name of its axis or by its number."""
        value = self.value
        if not isinstance(value, np.ndarray):
            raise TypeError(f"{self.name} has no components")
        if isinstance(component, str):
            if component not in self.axes:
                known = ", ".join(self.axes) or f"a number from 0 to {len(value) - 1}"
                raise KeyError(f"{self.name} has no component '{component}': expected {known}")
            component = self.axes.index(component)
        return value[component]

    if not TYPE_CHECKING:  # which would take it for an attribute of any name

        def __getattr__(self, name: str) -> Any:
            """Tells who seeks a component as an attribute where it is."""
            told = f": a component is {self.name}['{name}']" if name in self.__dict__.get("axes", []) else ""
            raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'{told}", name=name, obj=self)

    # An index alone does not make a sequence of it.
    __iter__ = None

    @property
    def holds(self) -> bool | None:
        """Whether a claim holds; None for other answers."""
        return self._core.claim.holds if self._core.claim and self.state == "found" else None

    @property
    def claim(self) -> _core.ClaimOutcome | None:
        """How a claim was decided, and a counterexample if it does not hold."""
        claim: _core.ClaimOutcome | None = self._core.claim
        return claim

    def __repr__(self) -> str:
        return f"<{self.name}: {self.words or self.ask}: {notebook.text_of(self)}>"

    def _repr_html_(self) -> str:
        return notebook.answers_html([self])


class _HasAnswers(_Stays):
    """Answers by name."""

    @property
    def answers(self) -> ByName[Answer]:
        raise NotImplementedError

    def __getitem__(self, name: str) -> Answer:
        if isinstance(name, str) and name not in self.answers:
            whole, _, part = name.partition(".")
            if whole in self.answers and part in self.answers[whole].axes:
                raise KeyError(f"there is no answer '{name}': a component of {whole} is ['{whole}']['{part}']")
        return self.answers[name]

    def __getattr__(self, name: str) -> Answer:
        """result.B is result["B"], where it has nothing else of that name."""
        # The answers themselves come from attributes.
        if name.startswith("_") or name in ("answers", "solution", "solutions"):
            raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")
        try:
            answers = self.answers
        except NoAnswer as error:
            raise AttributeError(f"there is no '{name}': {error}") from None
        if name in answers:
            return answers[name]
        hint = _core.did_you_mean(name, [*answers, *(one for one in super().__dir__() if not one.startswith("_"))])
        raise AttributeError(f"there is no answer '{name}': expected {', '.join(answers)}{f' ({hint})' if hint else ''}")

    def __dir__(self) -> Iterable[str]:
        return [*super().__dir__(), *(name for name in self._names() if name.isidentifier())]

    def _ipython_key_completions_(self) -> list[str]:
        return self._names()

    def _names(self) -> list[str]:
        try:
            return list(self.answers)
        except NoAnswer:
            return []

    def __iter__(self) -> Iterator[str]:
        return iter(self.answers)

    def __contains__(self, name: object) -> bool:
        return name in self.answers

    def __len__(self) -> int:
        return len(self.answers)

    def __bool__(self) -> bool:
        return True

    def get(self, name: str, default: Any = None) -> Any:
        return self.answers.get(name, default)

    def keys(self) -> KeysView[str]:
        return self.answers.keys()

    def values(self) -> ValuesView[Answer]:
        return self.answers.values()

    def items(self) -> ItemsView[str, Answer]:
        return self.answers.items()


class Solution(_HasAnswers):
    """The answers for one root of the unknowns."""

    def __init__(self, core: _core.Solution) -> None:
        positive = frozenset(one.removesuffix(" > 0") for one in core.assumptions if one.endswith(" > 0"))
        self.unknowns = ByName({one.name: Unknown(one, positive) for one in core.unknowns}, "unknown")
        self._answers = ByName({one.name: Answer(one, positive) for one in core.answers}, "answer")
        self.checks: dict[str, float] = core.checks
        self.notes = [in_python(note) for note in core.notes]
        self.assumptions: list[str] = core.assumptions
        self.conditions = [(one.words, one.formula) for one in core.conditions]

    @property
    def answers(self) -> ByName[Answer]:
        return self._answers

    def __repr__(self) -> str:
        return f"<solution: {', '.join(self.answers)}>"

    def _repr_html_(self) -> str:
        return notebook.solution_html(self)


class Result(_HasAnswers):
    """All that a run found. With one solution, its answers are at hand: result["T"].value."""

    def __init__(self, core: _core.Document, problem: Problem) -> None:
        self._core, self._problem = core, problem
        self.title = core.title
        self.solutions = [Solution(one) for one in core.solutions]
        self.warnings = [in_python(warning) for warning in core.warnings]
        self.open_letters = {one.name: one.unit for one in core.open_letters}
        # What ended the run before it was done: "deadline" or "interrupted"; else None.
        self.ended: str | None = core.ended
        self.fully_answered: bool = core.fully_answered

    @property
    def solution(self) -> Solution:
        """The only solution. NoAnswer if there is none or several."""
        if len(self.solutions) == 1:
            return self.solutions[0]
        if self.solutions:
            raise NoAnswer(f"there are {len(self.solutions)} solutions: choose one of result.solutions")
        raise NoAnswer("there is no solution" + (": " + "; ".join(self.warnings) if self.warnings else ""))

    @property
    def answers(self) -> ByName[Answer]:
        return self.solution.answers

    @property
    def unknowns(self) -> ByName[Unknown]:
        return self.solution.unknowns

    @property
    def checks(self) -> dict[str, float]:
        return self.solution.checks

    @property
    def notes(self) -> list[str]:
        return self.solution.notes

    def to_dict(self) -> dict[str, Any]:
        """The answer document, as `poinsot solve --json` prints it."""
        document: dict[str, Any] = json.loads(self._core.to_json())
        return document

    def to_text(self, digits: int = 6) -> str:
        """The answers as the program prints them on a terminal."""
        if calls.whole(digits, "digits") > 17:
            raise ValueError(f"a number has 17 digits and no {digits}")
        return in_python(self._core.to_text(digits))

    def to_markdown(self) -> str:
        """As Markdown with TeX; with the steps of the solution if the result is of explain()."""
        return in_python(self._core.to_markdown())

    def __str__(self) -> str:
        return self.to_text()

    def __repr__(self) -> str:
        return f"<poinsot.Result of '{self.title}': {len(self.solutions)} solution(s)>"

    def _repr_html_(self) -> str | None:
        return notebook.result_html(self)


class Explanation(Result):
    """A result with its worked solution."""

    def _repr_html_(self) -> None:
        return None

    def _repr_markdown_(self) -> str:
        return self.to_markdown()
