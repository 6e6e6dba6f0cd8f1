"""Studies on a Dask cluster whose workers and whose scheduler are killed in the middle."""

import errno
import os
import random
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pytest

import poinsot
from poinsot.studies import shards

# Dask's functions have no types.
distributed: Any = pytest.importorskip("distributed")

OVER = {"m": poinsot.normal("8 kg", "0.3 kg"), "b": poinsot.tolerance("20 deg", "0.6 deg")}


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.parametrize("kills", [int(os.environ.get("POINSOT_WORKER_KILLS", "2"))])
def test_workers_are_killed(askew: poinsot.Problem, tmp_path: Path, kills: int) -> None:
    # Small shards, so that there is time to kill.
    rows, shard_rows = (60_000, 200) if kills <= 2 else (100_000, 20)
    arguments = {"rows": rows, "seed": 4, "shard_rows": shard_rows}
    poinsot.study(askew, OVER, ["B"], out=tmp_path / "whole", **arguments)  # type: ignore[arg-type]
    folder = tmp_path / "rows"
    killed: list[int] = []
    over = threading.Event()

    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        chance = random.Random(1)

        def kill() -> None:
            while len(killed) < kills and not over.is_set():
                time.sleep(0.02)
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
    assert study.counts.answered == rows
    assert 1 <= len(killed) <= kills if kills <= 2 else len(killed) == kills
    assert contents(folder) == contents(tmp_path / "whole")


def test_the_scheduler_is_killed_and_started_anew(askew: poinsot.Problem, tmp_path: Path) -> None:
    arguments = {"rows": 15_000, "seed": 4, "shard_rows": 500, "formulas": False}
    poinsot.study(askew, OVER, ["B"], out=tmp_path / "whole", **arguments)  # type: ignore[arg-type]
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    folder, address, running, rows = tmp_path / "rows", f"tcp://127.0.0.1:{port}", list[subprocess.Popen[bytes]](), list[int]()
    worker = ["worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard", "--death-timeout", "60"]

    def start() -> None:
        for command in (["scheduler", "--host", "127.0.0.1", "--port", str(port), "--no-dashboard"], worker, worker):
            running.append(subprocess.Popen([sys.executable, "-m", "dask", *command], stderr=subprocess.DEVNULL))

    def kill() -> None:
        for one in running:
            one.kill()
            one.wait()
        running.clear()

    def kill_and_start() -> None:
        while len(list(folder.glob("rows-*"))) < 4:
            time.sleep(0.005)
        kill()
        rows.append(len(list(folder.glob("rows-*"))))
        start()

    start()
    killer = threading.Thread(target=kill_and_start, daemon=True)
    try:
        with distributed.Client(address, timeout=60) as client:
            killer.start()
            study = poinsot.study(askew, OVER, ["B"], out=folder, client=client, **arguments)  # type: ignore[arg-type]
            killer.join()
    finally:
        kill()
    assert rows[0] < 30 and study.counts.answered == 15_000
    assert contents(folder) == contents(tmp_path / "whole")


def test_a_full_disk_of_a_worker_is_told(askew: poinsot.Problem, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    arguments = {"rows": 1000, "seed": 4, "shard_rows": 100}
    poinsot.study(askew, OVER, ["B"], out=tmp_path / "whole", **arguments)  # type: ignore[arg-type]
    put, calls = shards.put, 0

    def full(path: Path, content: Any) -> None:
        nonlocal calls
        calls += 1
        if calls > 5:
            raise OSError(errno.ENOSPC, "No space left on device")
        put(path, content)

    # Workers that are threads of this process.
    with distributed.LocalCluster(n_workers=1, processes=False, dashboard_address=None) as cluster, distributed.Client(cluster) as client:
        monkeypatch.setattr(shards, "put", full)
        with pytest.raises(OSError, match="No space"):
            poinsot.study(askew, OVER, ["B"], out=tmp_path / "rows", client=client, **arguments)  # type: ignore[arg-type]
        monkeypatch.setattr(shards, "put", put)
        poinsot.study(askew, OVER, ["B"], out=tmp_path / "rows", client=client, **arguments)  # type: ignore[arg-type]
    assert contents(tmp_path / "rows") == contents(tmp_path / "whole")
