"""Runs studies: in threads of this process, or on the workers of a Dask cluster."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np

from .. import _core, calls, quantities
from ..problem import Problem
from . import shards
from .axes import described, is_random
from .draws import SAMPLINGS
from .plan import MANIFEST, PLAN, Plan
from .result import Study, StudyError

# Rows of a shard, which takes some milliseconds by formulas, and some seconds else.
_ROWS_BY_FORMULA, _ROWS_BY_INSTANT, _ROWS_IN_FULL = 1 << 17, 1 << 16, 1 << 10


def study(
    problem: Problem,
    over: Mapping[str, Any],
    asks: str | Sequence[str] = (),
    *,
    sets: Mapping[str, quantities.Value] | None = None,
    rows: int | None = None,
    seed: int = 0,
    sampling: str = "random",
    formulas: bool = True,
    sensitivities: str | Sequence[str] = (),
    out: str | os.PathLike[str] | None = None,
    shard_rows: int | None = None,
    threads: int | None = None,
    client: Any = None,
    progress: calls.Progress = None,
) -> Study:
    """Asks a problem for many cases.

    over: for each letter or datum a list of values, a span(), or a distribution: normal(), uniform(), tolerance().
    Lists and spans make a grid; `rows` draws of the distributions are made at each of its points, "random", by
    "latin hypercube" or "sobol". asks: the questions that are answered, all by default; sets: values for all rows.

    formulas: whether rows may go by formulas; without them each row is solved by itself. sensitivities: those of `over`
    by which the answers are differentiated: "T by n" is how much T changes per n, in SI units.

    out: a folder that gets the rows as Parquet, in shards, with a manifest; a study that was stopped goes on there.
    Without it the rows are kept in memory. threads: all processors by default. client: of dask.distributed, whose
    workers then see the folder `out`. Whatever computes, the rows are the same.
    """
    plan = _plan(problem, over, asks, sets, rows, seed, sampling, formulas, sensitivities, shard_rows)
    threads = None if threads is None else calls.whole(threads, "threads")
    if client is not None and not hasattr(client, "submit"):
        raise TypeError(f"client is one of dask.distributed, not {client!r}")
    if out is None and client is not None:
        raise ValueError("on a cluster the rows go to a folder that its workers see: name it by out")
    folder = None if out is None else Path(out)
    if folder is not None:
        _begin(plan, folder)
    heard = calls.listener(progress)
    try:
        kept: dict[int, shards.Rows] = {}
        written: dict[int, shards.Written] = {}
        counts = shards.Counts()
        for shard, found in _found(plan, folder, threads, client):
            if isinstance(found, shards.Rows):
                kept[shard] = found
            else:
                written[shard] = found
            counts += found.counts
            if heard is not None:
                heard("solving cases", counts.rows / plan.total, counts.rows)
    finally:
        calls.close(heard)
    if folder is not None:
        _end(plan, folder, counts, written)
        return Study(plan, counts, folder, {})
    return Study(plan, counts, None, kept)


def _plan(
    problem: Problem,
    over: Mapping[str, Any],
    asks: str | Sequence[str],
    sets: Mapping[str, quantities.Value] | None,
    rows: int | None,
    seed: int,
    sampling: str,
    formulas: bool,
    sensitivities: str | Sequence[str],
    shard_rows: int | None,
) -> Plan:
    # The caller may not have the types checked.
    if not isinstance(problem, Problem):
        raise TypeError(f"a study asks a Problem, not {problem!r}: Problem.from_file(path) reads one")
    asks, sensitivities = calls.texts(asks, "asks"), calls.texts(sensitivities, "sensitivities")
    if not isinstance(over, Mapping):
        raise TypeError(
            f"over has what differs by name, as {{'n': span('1000 rpm', '3000 rpm', 21)}}, of which a grid is made, and is not {over!r}: "
            "cases that are no grid are solved one by one, as [problem.solve(case) for case in cases]"
        )
    for one in asks:
        whole = one.partition(".")[0]
        if one not in problem.questions and whole in problem.questions:
            raise ValueError(f"asks has the names of questions: ask for '{whole}', whose components are columns, as study['{one}']")
    if not isinstance(formulas, bool):
        raise TypeError(f"formulas is True or False, not {formulas!r}")
    sets = quantities.given(sets, {})
    if not over:
        raise ValueError("nothing differs from row to row: name what does by over")
    if both := set(over) & set(sets):
        raise ValueError(f"{', '.join(sorted(both))} cannot both be set and differ from row to row")
    if sampling not in SAMPLINGS:
        hint = _core.did_you_mean(sampling, list(SAMPLINGS))
        raise ValueError(f"there is no sampling '{sampling}': expected {', '.join(SAMPLINGS)}{f' ({hint})' if hint else ''}")
    seed = calls.whole(seed, "a seed", least=0)
    if seed >= 2**64:
        raise ValueError("a seed is a whole number from 0 to 2^64 - 1")
    axes = {name: described(problem, name, axis) for name, axis in over.items()}
    random = any(map(is_random, axes.values()))
    if random and rows is None:
        raise ValueError("how many draws are made of the distributions? Say it by rows")
    if not random and rows is not None:
        raise ValueError("rows counts the draws of distributions, and there are none: a grid has its own number of rows")
    rows = None if rows is None else calls.whole(rows, "rows")
    shard_rows = None if shard_rows is None else calls.whole(shard_rows, "shard_rows")
    for one in sensitivities:
        if one not in over:
            hint = _core.did_you_mean(one, list(over))
            raise ValueError(f"'{one}' among the sensitivities does not differ from row to row: expected of over "
                             f"{', '.join(over)}{f' ({hint})' if hint else ''}")
    # The plan knows the text of the problem, in which they have values.
    if opened := [one for one in problem._opened if one not in over and one not in sets]:
        raise ValueError(f"{', '.join(opened)} became letters by with_letters(): vary them by over, or give them values by sets")
    with _sources(problem):
        given = quantities.settings(problem, sets)
    plan = Plan(
        problem.text,
        problem.name,
        axes,
        asks,
        [list(one) for one in given],
        rows or 1,
        seed,
        sampling,
        shard_rows or _ROWS_BY_FORMULA,
        formulas,
        list(sensitivities),
        _versions(random),
    )
    if shard_rows is None and not plan.compiled().has_formulas:
        plan = replace(plan, shard_rows=_ROWS_BY_INSTANT if plan.compiled().by_instants else _ROWS_IN_FULL)
    _refuse_asks(problem, plan, sets)
    return plan


def _refuse_asks(problem: Problem, plan: Plan, sets: Mapping[str, quantities.Value]) -> None:
    """What would have no place, or no answer in any row, since letters have no value, is told before all rows."""
    cases = plan.compiled()
    for one in cases.columns:
        if one.name in plan.over:
            raise ValueError(f"{one.name} is the name of what is varied and of what is asked: give the question another name")
    if not problem.letters.keys() - plan.over.keys() - sets.keys():
        return
    first = {one.name: f"{float(column[0])!r} {one.unit}".strip() for one, column in zip(cases.over, plan.values(0, 1), strict=True)}
    asked: dict[str, None] = {}
    needed: dict[str, None] = {}
    for solution in problem.solve({**sets, **first}, progress=False).solutions:
        for name in plan.asks or problem.questions:
            if solution[name].state == "needs_letters":
                asked[name] = None
                needed.update(dict.fromkeys(solution[name].letters))
    if asked:
        values = ", ".join(f"'{letter}': '... {problem.letters[letter]}'" for letter in needed)
        raise ValueError(
            f"{', '.join(asked)} needs values for {', '.join(needed)}: sets={{{values}}} gives them to all rows, over= varies them"
        )


def _sources(problem: Problem) -> Any:
    from ..problem import _Sources

    return _Sources(problem.text)


def _versions(random: bool) -> dict[str, str]:
    """Of what the numbers of rows come from."""
    versions = {"poinsot": _core.version, "numpy": np.__version__}
    if random:
        import scipy

        versions["scipy"] = scipy.__version__
    return versions


def _begin(plan: Plan, folder: Path) -> None:
    """Makes the folder of a study, or sees that it is of this one."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / PLAN
    if path.exists():
        begun = json.loads(path.read_text(encoding="utf-8"))
        now = json.loads(plan.to_json())
        if begun != now:
            others = ", ".join(key for key in now if begun.get(key) != now[key])
            raise StudyError(
                f"{folder} holds another study, which differs in: {others}. Name another folder, or delete this one"
            )
        _clear(folder)
        return
    if any(folder.iterdir()):
        raise StudyError(f"{folder} holds other files: name a folder that is empty or new")
    shards.put(path, plan.to_json().encode())


def _clear(folder: Path) -> None:
    """Takes away what processes were writing when they were killed."""
    for left in folder.glob(".rows-*"):
        left.unlink(missing_ok=True)


def _end(plan: Plan, folder: Path, counts: shards.Counts, written: Mapping[int, shards.Written]) -> None:
    """Writes the manifest: what every file holds."""
    _clear(folder)
    files = {shards.path_of(folder, shard).name: written[shard] for shard in range(plan.shards)}
    manifest = {
        **asdict(counts),
        "units": shards.units(plan),
        "files": {name: {"sha256": one.sha256, **asdict(one.counts)} for name, one in files.items()},
    }
    shards.put(folder / MANIFEST, (json.dumps(manifest, indent=1) + "\n").encode())


def _found(
    plan: Plan, folder: Path | None, threads: int | None, client: Any
) -> Iterator[tuple[int, shards.Rows | shards.Written]]:
    """Every shard, in any order."""
    open_shards = []
    for shard in range(plan.shards):
        if folder is not None and (path := shards.path_of(folder, shard)).exists():
            yield shard, shards.written_before(path)
        else:
            open_shards.append(shard)
    if client is not None:
        from .cluster import on_cluster

        assert folder is not None
        yield from on_cluster(client, open_shards, folder)
    else:
        yield from _in_threads(plan, open_shards, folder, threads or os.cpu_count() or 1)


def _in_threads(
    plan: Plan, open_shards: Iterable[int], folder: Path | None, threads: int
) -> Iterator[tuple[int, shards.Rows | shards.Written]]:
    stop = _core.StopFlag()

    def one(shard: int) -> tuple[int, shards.Rows | shards.Written]:
        rows = shards.solved(plan, shard, stop)
        return shard, rows if folder is None else shards.write(plan, shard, rows, folder)

    pool = ThreadPoolExecutor(threads)
    try:
        yield from bounded(open_shards, lambda shard: pool.submit(one, shard), 2 * threads)
    finally:
        # After Ctrl-C or an error the other threads end soon.
        stop.set()
        pool.shutdown(cancel_futures=True)


def bounded(
    open_shards: Iterable[int], submit: Callable[[int], Future[Any]], most: int
) -> Iterator[tuple[int, Any]]:
    """The results of calls of which only some wait at a time, so that their results do not fill the memory."""
    pending: set[Future[Any]] = set()
    for shard in open_shards:
        pending.add(submit(shard))
        if len(pending) >= most:
            done, pending = wait(pending, return_when=FIRST_COMPLETED)
            for future in done:
                yield future.result()
    while pending:
        done, pending = wait(pending, return_when=FIRST_COMPLETED)
        for future in done:
            yield future.result()
