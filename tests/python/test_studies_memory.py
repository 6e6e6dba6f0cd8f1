"""The memory of a study whose rows go to files does not grow with their number."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from conftest import ASKEW

STUDY = """\
import resource, sys
import poinsot

problem = poinsot.Problem.from_text(sys.stdin.read(), "askew.yaml")
over = {"n": poinsot.uniform("1000 rpm", "3000 rpm"), "b": poinsot.tolerance("20 deg", "0.3 deg")}
study = poinsot.study(problem, over, ["T"], rows=int(sys.argv[2]), out=sys.argv[1], threads=2)
assert study.counts.answered == study.counts.by_formula == int(sys.argv[2])
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
"""


def most(folder: Path, rows: int) -> float:
    """The most memory that the process of such a study had, MB."""
    ran = subprocess.run([sys.executable, "-c", STUDY, folder, str(rows)], input=ASKEW, capture_output=True, text=True, check=True)
    assert len(list(folder.glob("rows-*"))) == -(-rows // (1 << 17))
    # Hundreds of megabytes, which the folders of tests would keep.
    shutil.rmtree(folder)
    return float(ran.stdout)


@pytest.mark.long
def test_ten_times_the_rows_take_no_more_memory(tmp_path: Path) -> None:
    # Sixteen shards, more than are at work at a time.
    few, many = most(tmp_path / "few", 1 << 21), most(tmp_path / "many", 10_000_000)
    print(f"{few:.0f} MB for two million rows, {many:.0f} MB for ten million")
    # The rows alone would be 400 MB. What is added is what the allocator leaves unused between pieces.
    assert many < few + 40
