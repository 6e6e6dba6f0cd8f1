"""Rows of a study, a shard at a time: solved, and kept as files of Parquet.

A shard is written beside its place, brought to the disk and then put there, so that a file with a shard's name is
whole, whenever the process was killed. Its bytes follow from the plan alone.
"""

from __future__ import annotations

import hashlib
import json
import os
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .. import _core
from ..wording import in_python
from .axes import Array
from .plan import Plan


ROADS = ("full", "instant", "formula")


@dataclass(frozen=True)
class Counts:
    """What is known of the rows of one or more shards."""

    rows: int = 0
    answered: int = 0  # rows in which every answer was found
    by_formula: int = 0
    by_instant: int = 0  # rows of which the instant alone was solved again
    checked: int = 0  # rows by formula or instant that were solved in full as well
    refuted: int = 0  # those where this gave something else: then all rows of the shard were solved in full

    def __add__(self, other: Counts) -> Counts:
        return Counts(*(a + b for a, b in zip(asdict(self).values(), asdict(other).values(), strict=True)))


@dataclass(frozen=True)
class Written:
    """A shard that lies in its file."""

    counts: Counts
    sha256: str


@dataclass
class Rows:
    """The rows of one shard, in SI units."""

    over: dict[str, Array]
    answers: dict[str, Array]
    roads: npt.NDArray[np.uint8]  # how each was found, by its place in ROADS
    reasons: list[tuple[int, str]]  # of rows in which an answer is missing, counted from the first of the shard
    counts: Counts


def solved(plan: Plan, shard: int, stop: _core.StopFlag) -> Rows:
    """The rows of a shard."""
    cases = plan.compiled()
    first, end = plan.bounds(shard)
    values = plan.values(first, end - first)
    columns, roads, reasons, checked, refuted = cases.solve(values, first, stop)
    _, by_instant, by_formula = (int(one) for one in np.bincount(roads, minlength=len(ROADS)))
    counts = Counts(end - first, end - first - len(reasons), by_formula, by_instant, checked, refuted)
    names = [one.name for one in cases.columns]
    return Rows(
        dict(zip(plan.over, values, strict=True)),
        dict(zip(names, columns, strict=True)),
        roads,
        [(row, in_python(reason)) for row, reason in reasons],
        counts,
    )


def units(plan: Plan) -> dict[str, str]:
    cases = plan.compiled()
    return {one.name: one.unit for one in [*cases.over, *cases.columns]}


def path_of(folder: Path, shard: int) -> Path:
    return folder / f"rows-{shard:06}.parquet"


def write(plan: Plan, shard: int, rows: Rows, folder: Path) -> Written:
    """Puts a shard into its file."""
    import pyarrow
    import pyarrow.parquet

    first, _ = plan.bounds(shard)
    of = units(plan)
    arrays: list[Any] = [pyarrow.array(np.arange(first, first + rows.counts.rows))]
    fields = [pyarrow.field("row", pyarrow.int64(), nullable=False)]
    for name, column in {**rows.over, **rows.answers}.items():
        missing = np.isnan(column)
        arrays.append(pyarrow.array(column, mask=missing if missing.any() else None))
        fields.append(pyarrow.field(name, pyarrow.float64(), metadata={"unit": of[name]}))
    arrays.append(pyarrow.DictionaryArray.from_arrays(rows.roads.astype(np.int8), list(ROADS)))
    fields.append(pyarrow.field("road", arrays[-1].type))
    arrays.append(_reasons(rows))
    fields.append(pyarrow.field("reason", pyarrow.string()))
    schema = pyarrow.schema(fields, metadata={"poinsot": json.dumps(asdict(rows.counts))})
    table = pyarrow.Table.from_arrays(arrays, schema=schema)

    sink = pyarrow.BufferOutputStream()
    # Random values share no bytes: to look for such takes longer than all else.
    pyarrow.parquet.write_table(table, sink, compression="none", use_dictionary=["road", "reason"])
    content = sink.getvalue()
    put(path_of(folder, shard), content)
    return Written(rows.counts, hashlib.sha256(content).hexdigest())


def _reasons(rows: Rows) -> Any:
    import pyarrow

    if not rows.reasons:
        return pyarrow.nulls(rows.counts.rows, pyarrow.string())
    reasons: list[str | None] = [None] * rows.counts.rows
    for row, reason in rows.reasons:
        reasons[row] = reason
    return pyarrow.array(reasons, type=pyarrow.string())


def put(path: Path, content: Any) -> None:
    """Writes a file that is there whole or not at all, after a loss of power too."""
    scratch = path.with_name(f".{path.name}.{os.getpid()}.{os.urandom(4).hex()}")
    try:
        with open(scratch, "xb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        os.replace(scratch, path)
    except BaseException:
        scratch.unlink(missing_ok=True)
        raise
    folder = os.open(path.parent, os.O_RDONLY)
    try:
        os.fsync(folder)
    finally:
        os.close(folder)


def counts_of(path: Path) -> Counts:
    """The counts that a shard's file has with it."""
    import pyarrow.parquet

    metadata = pyarrow.parquet.read_schema(path).metadata
    return Counts(**json.loads(metadata[b"poinsot"]))


def written_before(path: Path) -> Written:
    """What a shard's file holds that another call has written."""
    with open(path, "rb") as file:
        return Written(counts_of(path), hashlib.file_digest(file, "sha256").hexdigest())
