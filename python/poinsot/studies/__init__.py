"""Studies: one problem, many cases.

    study = poinsot.study(problem, over={"n": poinsot.span("1000 rpm", "3000 rpm", 21),
                                         "b": poinsot.tolerance("20 deg", "0.3 deg")}, rows=1000)
    study.frame()
"""

from .axes import Distribution, Normal, Span, Tolerance, Uniform, normal, span, tolerance, uniform
from .result import Study, StudyError
from .run import study

__all__ = [
    "Distribution",
    "Normal",
    "Span",
    "Study",
    "StudyError",
    "Tolerance",
    "Uniform",
    "normal",
    "span",
    "study",
    "tolerance",
    "uniform",
]
