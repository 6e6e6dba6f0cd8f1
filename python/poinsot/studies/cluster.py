"""Studies on the workers of a Dask cluster, which may come and go."""

from __future__ import annotations

import time
from collections import Counter, deque
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from .. import _core
from . import shards
from .plan import PLAN, Plan
from .result import StudyError

# How often a task is given out anew when its worker, or the scheduler, is gone: it may be what kills them.
_MOST_LOST = 100


# A task has as many shards as take about this long, s: beside it what the scheduler does for each is nothing, and little is
# lost with a worker.
_TASK = 0.5


def _some(folder: str, numbers: tuple[int, ...]) -> tuple[float, list[tuple[int, shards.Written]]]:
    """Solves shards on a worker, and tells how long one takes. Those that somebody has written before, as a worker that was
    thought dead, are kept."""
    begin = time.perf_counter()
    # The plan lies beside the rows, so that no worker has to live for others to know it.
    plan = Plan.from_json((Path(folder) / PLAN).read_text(encoding="utf-8"))
    found = []
    for shard in numbers:
        path = shards.path_of(Path(folder), shard)
        if path.exists():
            found.append((shard, shards.written_before(path)))
        else:
            found.append((shard, shards.write(plan, shard, shards.solved(plan, shard, _core.StopFlag()), Path(folder))))
    return (time.perf_counter() - begin) / len(numbers), found


def on_cluster(client: Any, open_shards: list[int], folder: Path) -> Iterator[tuple[int, shards.Written]]:
    from distributed import CancelledError, KilledWorker, as_completed

    in_order_of_end: Any = as_completed
    path = str(folder.resolve())
    todo = deque(open_shards)
    task_of: dict[str, tuple[int, ...]] = {}
    lost: Counter[tuple[int, ...]] = Counter()

    def submit(numbers: tuple[int, ...]) -> Any:
        try:
            future = client.submit(_some, path, numbers, pure=False)
        except Exception as error:
            if client.status == "running":
                raise
            raise StudyError(
                f"the scheduler of the cluster does not answer any more: what was done stays in {folder}, and the same call goes on"
            ) from error
        task_of[future.key] = numbers
        return future

    workers = max(1, sum(client.nthreads().values()))

    def next_task(size: int) -> tuple[int, ...]:
        # Towards the end tasks become small, so that no worker waits for another.
        size = max(1, min(size, len(todo) // (2 * workers)))
        return tuple(todo.popleft() for _ in range(min(size, len(todo))))

    # The first ones show how long a shard takes.
    first = [submit(next_task(1)) for _ in range(min(3 * workers, len(todo)))]
    completed = in_order_of_end(first)
    for future in completed:
        numbers = task_of.pop(future.key)
        try:
            seconds, found = future.result()
        except (CancelledError, KilledWorker, OSError) as error:
            # Whoever solved it, or knew what was found, is gone. What went wrong in the work itself, as a full disk, is told.
            lost[numbers] += 1
            if lost[numbers] > _MOST_LOST or (future.status == "error" and not isinstance(error, KilledWorker)):
                raise
            completed.add(submit(numbers))
            continue
        if todo:
            completed.add(submit(next_task(int(_TASK / max(seconds, 1e-6)))))
        yield from found
