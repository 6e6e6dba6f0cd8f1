"""Studies on the workers of a Dask cluster, which may come and go."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from .. import _core
from . import shards
from .plan import PLAN, Plan
from .result import StudyError

# How often a shard is given out anew when its worker, or the scheduler, is gone: it may be what kills them.
_MOST_LOST = 100


def _one(folder: str, shard: int) -> tuple[int, shards.Counts]:
    """Solves a shard on a worker. Where somebody was there before, as a worker that was thought dead, it is kept."""
    # The plan lies beside the rows, so that no worker has to live for others to know it.
    plan = Plan.from_json((Path(folder) / PLAN).read_text(encoding="utf-8"))
    path = shards.path_of(Path(folder), shard)
    if not path.exists():
        shards.write(plan, shard, shards.solved(plan, shard, _core.StopFlag()), Path(folder))
    return shard, shards.counts_of(path)


def on_cluster(client: Any, open_shards: Iterable[int], folder: Path) -> Iterator[tuple[int, shards.Counts]]:
    from distributed import CancelledError, KilledWorker, as_completed

    in_order_of_end: Any = as_completed
    path = str(folder.resolve())
    todo = iter(open_shards)
    shard_of: dict[str, int] = {}
    lost: Counter[int] = Counter()

    def submit(shard: int) -> Any:
        try:
            future = client.submit(_one, path, shard, pure=False)
        except Exception as error:
            if client.status == "running":
                raise
            raise StudyError(
                f"the scheduler of the cluster does not answer any more: what was done stays in {folder}, and the same call goes on"
            ) from error
        shard_of[future.key] = shard
        return future

    most = 4 * max(1, sum(client.nthreads().values()))
    first = [submit(shard) for _, shard in zip(range(most), todo, strict=False)]
    completed = in_order_of_end(first)
    for future in completed:
        shard = shard_of.pop(future.key)
        try:
            found = future.result()
        except (CancelledError, KilledWorker, OSError) as error:
            # Whoever solved it, or knew what was found, is gone. What went wrong in the work itself, as a full disk, is told.
            lost[shard] += 1
            if lost[shard] > _MOST_LOST or (future.status == "error" and not isinstance(error, KilledWorker)):
                raise
            completed.add(submit(shard))
            continue
        yield found
        for another in todo:
            completed.add(submit(another))
            break
