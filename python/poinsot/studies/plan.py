"""The plan of a study: all that its rows depend on, as plain data. Two studies of one plan have the same rows."""

from __future__ import annotations

import functools
import json
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from .. import _core
from ..problem import Problem
from .axes import Array, Described, grid_values, is_random, largest, quantile
from .draws import unit_draws

# Files beside the rows: readers of whole folders of Parquet leave out what begins with a line.
PLAN, MANIFEST = "_study.json", "_manifest.json"


@dataclass(frozen=True)
class Plan:
    """Row i is the draw i % rows at the point i // rows of the grid of all lists and spans, the last of which changes
    fastest. Each point of the grid has the same draws, so that what differs between points is not chance."""

    text: str  # of the problem file
    name: str  # of the problem file
    over: dict[str, Described]
    asks: list[str]
    sets: list[list[str]]
    rows: int  # for each point of the grid
    seed: int
    sampling: str
    shard_rows: int
    formulas: bool  # whether formulas may be used
    sensitivities: list[str]  # those of `over` by which the answers are differentiated
    versions: dict[str, str]

    @functools.cached_property
    def _grids(self) -> dict[str, Array]:
        return {name: grid_values(axis) for name, axis in self.over.items() if not is_random(axis)}

    @property
    def grid(self) -> tuple[int, ...]:
        return tuple(map(len, self._grids.values()))

    @property
    def total(self) -> int:
        return self.rows * int(np.prod(self.grid, dtype=object))

    @property
    def shards(self) -> int:
        return -(-self.total // self.shard_rows)

    def bounds(self, shard: int) -> tuple[int, int]:
        """The first row of a shard, and the one after its last."""
        return shard * self.shard_rows, min((shard + 1) * self.shard_rows, self.total)

    def values(self, first: int, count: int) -> list[Array]:
        """What is varied, a column for each, in SI units."""
        rows = np.arange(first, first + count)
        points, draws = rows // self.rows, rows % self.rows
        at_point = iter(np.unravel_index(points, self.grid)) if self.grid else iter(())
        parts = iter(self._parts(draws))
        columns = []
        for name, axis in self.over.items():
            column = quantile(axis, next(parts)) if is_random(axis) else self._grids[name][next(at_point)]
            columns.append(np.ascontiguousarray(column, dtype=float))
        return columns

    def _parts(self, draws: Any) -> Array:
        """The draws of these numbers, which go up one by one and begin again after the last."""
        variables = sum(map(is_random, self.over.values()))
        if variables == 0:
            return np.empty((0, len(draws)))
        if self.rows <= len(draws):
            return unit_draws(self.sampling, self.seed, variables, self.rows, 0, self.rows)[:, draws]
        pieces, at = [], 0
        while at < len(draws):
            first = int(draws[at])
            count = min(self.rows - first, len(draws) - at)
            pieces.append(unit_draws(self.sampling, self.seed, variables, self.rows, first, count))
            at += count
        return np.concatenate(pieces, axis=1)

    @functools.cached_property
    def _json(self) -> str:
        return json.dumps(asdict(self), indent=1) + "\n"

    def to_json(self) -> str:
        return self._json

    @classmethod
    def from_json(cls, text: str) -> Plan:
        return cls(**json.loads(text))

    def compiled(self) -> _core.Cases:
        return compiled(self.to_json())

    def __hash__(self) -> int:
        return hash(self.to_json())


@functools.lru_cache(maxsize=4)
def compiled(plan_text: str) -> _core.Cases:
    """The problem of a plan, compiled once in a process."""
    plan = Plan.from_json(plan_text)
    problem = Problem.from_text(plan.text, plan.name)
    first = [float(column[0]) for column in plan.values(0, 1)]
    sets = [(name, text) for name, text in plan.sets]
    usual = [largest(axis) for axis in plan.over.values()]
    questions = _core.CaseQuestions(list(plan.over), plan.asks, sets, first, plan.formulas, plan.sensitivities, usual)
    cases: _core.Cases = problem._called(lambda *ends: problem._core.cases(questions, *ends), None, False)
    return cases
