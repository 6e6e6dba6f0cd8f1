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

from conftest import ASKEW

# Dask's functions have no types.
distributed: Any = pytest.importorskip("distributed")

OVER = {"m": poinsot.normal("8 kg", "0.3 kg"), "b": poinsot.tolerance("20 deg", "0.6 deg")}

# With dry friction each row is solved in full.
SLIDING = """\
title: Crate that slides up a rough ramp
given: {m: 8 kg, mu: 0.3, b: 20 deg, v: 2 m/s}
points: {C: [0, 0, 0]}
directions: {up: [cos(b), sin(b), 0], out: [-sin(b), cos(b), 0]}
bodies: {crate: {particle: C, mass: m}}
contacts: {ramp: {of: crate, at: C, normal: out, friction: mu}}
gravity: -y
instants: {now: {velocity(crate): v*up}}
ask: {a: component(acceleration(crate) along up), N: normal_force(ramp)}
"""


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.parametrize(
    ("text", "arguments", "kills", "pause"),
    [
        # Small shards, so that there is time to kill.
        (ASKEW, {"over": OVER, "rows": 60_000, "shard_rows": 200}, 2, 1.0),
        # Every few seconds until all is done, which takes a minute.
        pytest.param(
            SLIDING,
            {"over": {"v": poinsot.uniform("1 m/s", "3 m/s"), "m": poinsot.normal("8 kg", "0.3 kg")}, "rows": 100_000, "shard_rows": 50},
            1000, 3.0, marks=pytest.mark.long,
        ),
    ],
)  # fmt: skip
def test_workers_are_killed(text: str, arguments: dict[str, Any], kills: int, pause: float, tmp_path: Path) -> None:
    problem = poinsot.Problem.from_text(text, "problem.yaml")
    poinsot.study(problem, out=tmp_path / "whole", seed=4, **arguments)
    folder = tmp_path / "rows"
    killed: list[int] = []
    ended = threading.Event()

    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        chance = random.Random(1)

        def kill() -> None:
            while len(killed) < kills and not ended.is_set():
                time.sleep(0.02)
                if not list(folder.glob("rows-*")):
                    continue
                workers = [one.pid for one in cluster.workers.values() if one.pid]
                if workers:
                    victim = chance.choice(workers)
                    os.kill(victim, signal.SIGKILL)
                    killed.append(victim)
                    ended.wait(pause)
            if not ended.is_set():
                client.restart(wait_for_workers=False)

        killer = threading.Thread(target=kill)
        killer.start()
        study = poinsot.study(problem, out=folder, client=client, seed=4, **arguments)
        ended.set()
        killer.join()
    print(f"{len(killed)} workers killed")
    assert study.counts.answered == arguments["rows"]
    assert min(kills, 5) - 1 <= len(killed) <= kills
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
