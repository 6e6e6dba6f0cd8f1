"""What can go wrong. Every error of poinsot is a PoinsotError."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .wording import in_python


class PoinsotError(Exception):
    """The base of all errors of this package."""

    def __init__(self, *told: Any) -> None:
        super().__init__(*(in_python(one) if isinstance(one, str) else one for one in told))


@dataclass(frozen=True)
class Diagnostic:
    """One error and its place. Lines and columns count from 1; with line 0 there is no place in the file."""

    file: str
    line: int
    column: int
    message: str
    hint: str
    source: str = ""  # the line of the file

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}:{self.column}" if self.line else self.file
        text = f"{place}: error: {self.message}" + (f" ({self.hint})" if self.hint else "")
        if not self.source:
            return text
        number = f"{self.line:4} | "
        # A tabulator stays one, so that the caret stands below its character.
        before = "".join("\t" if c == "\t" else " " for c in self.source[: self.column - 1])
        return f"{text}\n{number}{self.source}\n{' ' * (len(number) - 2)}| {before}^"


def _diagnostic(file: str, line: int, column: int, message: str, hint: str) -> Diagnostic:
    return Diagnostic(in_python(file), line, column, in_python(message), in_python(hint))


class StatementError(PoinsotError, ValueError):
    """A problem, or a value given to it, that cannot be understood or is impossible."""

    def __init__(self, text: str, diagnostics: list[Any] | None = None) -> None:
        super().__init__(text)
        self.diagnostics = [_diagnostic(*one) if isinstance(one, tuple) else one for one in diagnostics or []]

    # The module raises it with the text alone, where pickles and copies need both.
    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (self.args[0], self.diagnostics))

    def __str__(self) -> str:
        return "\n".join(map(str, self.diagnostics)) or str(self.args[0])

    @property
    def file(self) -> str:
        return self.diagnostics[0].file if self.diagnostics else ""

    @property
    def line(self) -> int:
        return self.diagnostics[0].line if self.diagnostics else 0

    @property
    def column(self) -> int:
        return self.diagnostics[0].column if self.diagnostics else 0

    @property
    def message(self) -> str:
        return self.diagnostics[0].message if self.diagnostics else str(self.args[0])

    @property
    def hint(self) -> str:
        return self.diagnostics[0].hint if self.diagnostics else ""


class NoAnswer(PoinsotError, LookupError):
    """A value was wanted of an answer, an unknown or a motion that has none; the message says why."""


class NoEquations(PoinsotError):
    """The problem has no such equations of motion."""


class FigureError(PoinsotError, ValueError):
    """There is no such figure, or no such view."""


class NoPages(PoinsotError):
    """This build of poinsot carries no script of pages."""


class RecordingError(PoinsotError):
    """A motion could not be recorded."""


class TimedOut(PoinsotError, TimeoutError):
    """The timeout was over before there was any result."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C was pressed. `found` holds what was found until then, or None."""

    found: Any = None
