"""poinsot answers questions about rigid bodies that move in three dimensions.

    problem = poinsot.Problem.from_file("askew.yaml")
    result = problem.solve(n="3000 rpm")
    result["T"].value, result["T"].unit
"""

from typing import TYPE_CHECKING as _TYPE_CHECKING
from typing import Any as _Any

from ._core import answer_schema, language_words, problem_schema
from ._core import version as __version__

from .answers import Answer, Explanation, Result, Solution, Unknown
from .errors import (
    Diagnostic,
    FigureError,
    Interrupted,
    NoAnswer,
    NoEquations,
    NoPages,
    PoinsotError,
    RecordingError,
    StatementError,
    TimedOut,
)
from .motion import Motion, MotionValues
from .notebook import Page, Picture
from .problem import Problem, Recording
from .quantities import in_si, in_unit, si_unit
from .studies import Study, StudyError, normal, span, study, tolerance, uniform
from .wording import language_help

if _TYPE_CHECKING:
    from . import engine as engine


def __getattr__(name: str) -> _Any:
    # Loaded when it is wanted first.
    if name == "engine":
        import importlib

        return importlib.import_module(".engine", __name__)
    raise AttributeError(f"module 'poinsot' has no attribute '{name}'")


__all__ = [
    "Answer",
    "Diagnostic",
    "Explanation",
    "FigureError",
    "Interrupted",
    "Motion",
    "MotionValues",
    "NoAnswer",
    "NoEquations",
    "NoPages",
    "Page",
    "Picture",
    "PoinsotError",
    "Problem",
    "Recording",
    "RecordingError",
    "Result",
    "Solution",
    "StatementError",
    "Study",
    "StudyError",
    "TimedOut",
    "Unknown",
    "__version__",
    "answer_schema",
    "in_si",
    "in_unit",
    "language_help",
    "language_words",
    "normal",
    "problem_schema",
    "si_unit",
    "span",
    "study",
    "tolerance",
    "uniform",
]
