"""Studies on the workers of a Dask cluster, which may come and go."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from .. import _core
from . import shards
from .plan import Plan

# How often a shard is given to another worker when its own is gone.
_RETRIES = 1000


def _one(plan_text: str, shard: int, folder: str) -> tuple[int, shards.Counts]:
    """Solves a shard on a worker. Where somebody was there before, as a worker that was thought dead, it is kept."""
    plan = Plan.from_json(plan_text)
    path = shards.path_of(Path(folder), shard)
    if not path.exists():
        shards.write(plan, shard, shards.solved(plan, shard, _core.StopFlag()), Path(folder))
    return shard, shards.counts_of(path)


def on_cluster(
    client: Any, plan: Plan, open_shards: Iterable[int], folder: Path
) -> Iterator[tuple[int, shards.Counts]]:
    from distributed import as_completed

    in_order_of_end: Any = as_completed
    plan_text, path = plan.to_json(), str(folder.resolve())
    # The plan has the text of the problem: it goes to each worker once.
    shared = client.scatter(plan_text, broadcast=True, hash=True)
    todo = iter(open_shards)

    def submit(shard: int) -> Any:
        return client.submit(_one, shared, shard, path, pure=False, retries=_RETRIES)

    most = 4 * max(1, sum(client.nthreads().values()))
    first = [submit(shard) for _, shard in zip(range(most), todo, strict=False)]
    completed = in_order_of_end(first)
    for future in completed:
        yield future.result()
        for shard in todo:
            completed.add(submit(shard))
            break
