"""Studies that a file describes.

    problem = "askew.yaml"
    asks = ["B"]
    rows = 10000
    sampling = "sobol"
    out = "askew-study"

    [set]
    m = "7.5 kg"

    [over]
    n = {span = ["1000 rpm", "3000 rpm"], count = 21}
    r = ["140 mm", "150 mm"]
    b = {tolerance = ["20 deg", "0.3 deg"]}
"""

from __future__ import annotations

import os
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .. import _core
from ..problem import Problem
from .axes import normal, span, tolerance, uniform
from .result import Study
from .run import study

_DISTRIBUTIONS: dict[str, Callable[[Any, Any], Any]] = {"normal": normal, "uniform": uniform, "tolerance": tolerance}
_KEYS = ("problem", "over", "asks", "set", "rows", "seed", "sampling", "formulas", "sensitivities", "out", "shard_rows")


def _known(word: str, words: list[str], what: str) -> None:
    if word not in words:
        hint = _core.did_you_mean(word, words)
        raise ValueError(f"there is no {what} '{word}': expected {', '.join(words)}{f' ({hint})' if hint else ''}")


def _axis(name: str, stated: Any) -> Any:
    if isinstance(stated, list):
        return stated
    if not isinstance(stated, dict):
        raise TypeError(f"over.{name}: expected a list of values, or {{span = [first, last], count = 10}}, "
                        f"{{normal = [mean, deviation]}}, {{uniform = [low, high]}}, {{tolerance = [nominal, limit]}}")
    kinds = [key for key in stated if key != "count"]
    if len(kinds) != 1:
        raise ValueError(f"over.{name}: expected one of span, {', '.join(_DISTRIBUTIONS)}")
    kind = kinds[0]
    _known(kind, ["span", *_DISTRIBUTIONS], "kind of values")
    numbers = stated[kind]
    if not isinstance(numbers, list) or len(numbers) != 2:
        raise ValueError(f"over.{name}: {kind} has two values in a list")
    if kind == "span":
        if type(stated.get("count")) is not int:
            raise ValueError(f"over.{name}: a span has a count")
        return span(numbers[0], numbers[1], stated["count"])
    return _DISTRIBUTIONS[kind](*numbers)


def run_file(path: str | os.PathLike[str], *, out: str | None = None, threads: int | None = None) -> Study:
    """Runs a study's file; the problem and the folder `out` are sought beside it."""
    with open(path, "rb") as file:
        stated = tomllib.load(file)
    for key in stated:
        _known(key, list(_KEYS), "key")
    for key in ("problem", "over"):
        if key not in stated:
            raise ValueError(f"'{key}' is missing")
    for key, kind, what in (("problem", str, "the name of a file"), ("over", dict, "a table"), ("out", str, "the name of a folder")):
        if not isinstance(stated.get(key, kind()), kind):
            raise TypeError(f"'{key}' is {what}, not {stated[key]!r}")
    beside = Path(path).parent
    if out is None and "out" not in stated:
        raise ValueError("'out' is missing: the folder for the rows")
    return study(
        Problem.from_file(beside / stated["problem"]),
        {name: _axis(name, axis) for name, axis in stated["over"].items()},
        stated.get("asks", []),
        sets=stated.get("set"),
        rows=stated.get("rows"),
        seed=stated.get("seed", 0),
        sampling=stated.get("sampling", "random"),
        formulas=stated.get("formulas", True),
        sensitivities=stated.get("sensitivities", ()),
        shard_rows=stated.get("shard_rows"),
        out=beside / stated["out"] if out is None else out,
        threads=threads,
    )
