"""Studies that are stopped in the middle, in every way, and go on: the finished files have the same bytes."""

import errno
import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import poinsot
from poinsot.studies import shards

STUDY = """\
problem = "askew.yaml"
asks = ["B", "T"]
rows = 60000
seed = 7
shard_rows = 1000
out = "rows"
[over]
m = {normal = ["8 kg", "0.3 kg"]}
b = {tolerance = ["20 deg", "0.6 deg"]}
n = {span = ["1000 rpm", "3000 rpm"], count = 2}
"""


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


@pytest.fixture
def stated(tmp_path: Path, askew: poinsot.Problem) -> Path:
    (tmp_path / "askew.yaml").write_text(askew.text)
    (tmp_path / "study.toml").write_text(STUDY)
    return tmp_path / "study.toml"


def command(stated: Path, out: str, *arguments: str) -> list[str]:
    return [sys.executable, "-m", "poinsot", "study", str(stated), "-o", str(stated.parent / out), *arguments]


@pytest.mark.parametrize("kills", [6, pytest.param(50, marks=pytest.mark.long)])
def test_killed_again_and_again(stated: Path, kills: int) -> None:
    # So many shards that not all are written before the last kill.
    count_of_shards = 20 * kills
    stated.write_text(STUDY.replace("shard_rows = 1000", f"shard_rows = {120_000 // count_of_shards}"))
    whole = subprocess.run(command(stated, "whole"), capture_output=True, text=True, check=True)
    assert "120000 rows" in whole.stdout and "refuted 0" in whole.stdout
    chance, killed, partly = random.Random(2), 0, 0
    folder = stated.parent / "killed"
    while killed < kills:
        process = subprocess.Popen(command(stated, "killed", "--threads", "2"), stdout=subprocess.DEVNULL)
        before = len(list(folder.glob("rows-*")))
        deadline = time.monotonic() + 60
        # Killed once it has done some more: at any point of the writing of a shard.
        while len(list(folder.glob("rows-*"))) < before + 5 and process.poll() is None and time.monotonic() < deadline:
            time.sleep(0.002)
        time.sleep(chance.uniform(0, 0.02))
        process.send_signal(signal.SIGKILL)
        killed += process.wait() == -signal.SIGKILL
        count = len(list(folder.glob("rows-*")))
        partly += 0 < count < count_of_shards
        if count == count_of_shards:
            break
    assert killed == kills and partly >= kills - 1
    subprocess.run(command(stated, "killed"), capture_output=True, check=True)
    assert contents(folder) == contents(stated.parent / "whole")


def test_interrupted(stated: Path) -> None:
    process = subprocess.Popen(command(stated, "rows"), stderr=subprocess.PIPE, text=True)
    while not list((stated.parent / "rows").glob("rows-*")) and process.poll() is None:
        time.sleep(0.002)
    process.send_signal(signal.SIGINT)
    _, told = process.communicate(timeout=60)
    assert process.returncode == 130 and "goes on" in told and "Traceback" not in told


def test_a_full_disk(askew: poinsot.Problem, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    over = {"m": poinsot.normal(8, 0.1)}
    arguments = {"rows": 1000, "shard_rows": 100, "threads": 1}
    poinsot.study(askew, over, ["T"], out=tmp_path / "whole", **arguments)  # type: ignore[arg-type]
    real, calls = os.fsync, 0

    def full(descriptor: int) -> None:
        nonlocal calls
        calls += 1
        if calls > 8:
            raise OSError(errno.ENOSPC, "No space left on device")
        real(descriptor)

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space"):
        poinsot.study(askew, over, ["T"], out=tmp_path / "rows", **arguments)  # type: ignore[arg-type]
    monkeypatch.setattr(os, "fsync", real)
    left = contents(tmp_path / "rows")
    assert 1 < len(left) < 11 and not any(name.startswith(".") for name in left)
    poinsot.study(askew, over, ["T"], out=tmp_path / "rows", **arguments)  # type: ignore[arg-type]
    assert contents(tmp_path / "rows") == contents(tmp_path / "whole")


def test_a_torn_file_of_a_killed_process_is_cleared_away(askew: poinsot.Problem, tmp_path: Path) -> None:
    poinsot.study(askew, {"m": [1.0, 2.0]}, ["T"], out=tmp_path / "rows", shard_rows=1)
    whole = contents(tmp_path / "rows")
    shards.path_of(tmp_path / "rows", 1).unlink()
    (tmp_path / "rows" / ".rows-000001.parquet.123.abc").write_bytes(b"PAR1 torn")
    poinsot.study(askew, {"m": [1.0, 2.0]}, ["T"], out=tmp_path / "rows", shard_rows=1)
    assert contents(tmp_path / "rows") == whole


# A file system of its own, of one megabyte, that is enlarged when it is full. $1: where it is mounted, $2: where the rows go in the
# end, and then the study's command.
SMALL_DISK = """\
disk=$1 kept=$2
shift 2
mount -t tmpfs -o size=1m tmpfs "$disk" || exit 77
"$@"
echo "ended by $?, $(ls "$disk/rows" | wc -l) files"
mount -o remount,size=64m "$disk" && "$@" && cp -a "$disk/rows" "$kept"
"""


@pytest.mark.long
def test_a_disk_that_is_full(stated: Path) -> None:
    """The file system itself says so, where the test above puts its words into a call."""
    subprocess.run(command(stated, "whole"), capture_output=True, check=True)
    assert sum(map(len, contents(stated.parent / "whole").values())) > 2e6
    if shutil.which("unshare") is None:
        pytest.skip("needs unshare, for a file system of its own")
    (stated.parent / "disk").mkdir()
    places = [str(stated.parent / one) for one in ("disk", "kept")]
    ran = subprocess.run(
        ["unshare", "--map-root-user", "--mount", "sh", "-c", SMALL_DISK, "sh", *places, *command(stated, "disk/rows")],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    if ran.returncode in (1, 77) and "ended by" not in ran.stdout:
        pytest.skip(f"no file system can be mounted here: {ran.stderr.strip()}")
    assert ran.returncode == 0, ran.stderr
    status, files = (int(one) for one in ran.stdout.split("ended by ")[1].split(" files")[0].split(", "))
    assert status == 2 and "No space left on device" in ran.stderr and "Traceback" not in ran.stderr
    assert 1 < files < 122
    assert contents(stated.parent / "kept") == contents(stated.parent / "whole")
