"""Studies on a Dask cluster whose workers are killed, and that is started anew, in the middle."""

import os
import random
import signal
import threading
import time
from pathlib import Path
from typing import Any

import dask
import pytest

import poinsot

# Dask's functions have no types.
distributed: Any = pytest.importorskip("distributed")

OVER = {"m": poinsot.normal("8 kg", "0.3 kg"), "b": poinsot.tolerance("20 deg", "0.6 deg")}


@pytest.mark.parametrize("kills", [int(os.environ.get("POINSOT_WORKER_KILLS", "2"))])
def test_workers_are_killed(askew: poinsot.Problem, tmp_path: Path, kills: int) -> None:
    arguments = {"rows": 60_000, "seed": 4, "shard_rows": 500}
    poinsot.study(askew, OVER, ["B"], out=tmp_path / "whole", **arguments)  # type: ignore[arg-type]
    folder = tmp_path / "rows"
    killed: list[int] = []
    over = threading.Event()

    # A shard is not at fault for the death of its worker, however often that happens.
    with (
        dask.config.set({"distributed.scheduler.allowed-failures": 1000}),
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        chance = random.Random(1)

        def kill() -> None:
            while len(killed) < kills and not over.is_set():
                time.sleep(0.2)
                if not list(folder.glob("rows-*")):
                    continue
                workers = [one.pid for one in cluster.workers.values() if one.pid]
                if workers:
                    victim = chance.choice(workers)
                    os.kill(victim, signal.SIGKILL)
                    killed.append(victim)
                    time.sleep(1)
            if not over.is_set():
                client.restart(wait_for_workers=False)

        killer = threading.Thread(target=kill)
        killer.start()
        study = poinsot.study(askew, OVER, ["B"], out=folder, client=client, **arguments)  # type: ignore[arg-type]
        over.set()
        killer.join()
    assert killed and study.counts.answered == 60_000
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == {
        path.name: path.read_bytes() for path in (tmp_path / "whole").iterdir()
    }
