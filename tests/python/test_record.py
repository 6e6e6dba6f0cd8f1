"""Recordings from Python: the rows are those of the motion, and a stopped recording goes on."""

import csv
from pathlib import Path

import numpy as np
import pytest

import poinsot
import poinsot.engine

SWING = """\
given: {m: 2 kg, L: 1 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies: {bar: {rod: [O, A], mass: m}}
joints: {hinge: {revolute: z, at: O, to: bar, angle: phi}}
gravity: -y
instants: {start: rest}
record: {every: 10 ms, for: 2 s, columns: {t: time, phi: phi, T: kinetic_energy(bar)}}
"""


@pytest.fixture
def swing() -> poinsot.Problem:
    return poinsot.Problem.from_text(SWING, "swing.yaml")


def rows(path: Path) -> poinsot.engine.Array:
    with path.open() as file:
        lines = [line for line in csv.reader(file) if line and not line[0].startswith("#")]
    return np.array([[float(x) for x in line] for line in lines[1:]])


def test_rows_are_those_of_the_motion(swing: poinsot.Problem, tmp_path: Path) -> None:
    recording = swing.record(tmp_path / "swing.csv")
    assert recording.complete and (recording.rows, recording.columns, recording.end) == (201, 3, 2.0)
    found = rows(tmp_path / "swing.csv")
    times = np.arange(201) * 0.01
    values = swing.motion()(times, "phi", T="kinetic_energy(bar)")
    np.testing.assert_allclose(found, np.array([times, values["phi"], values["T"]]).T, atol=1e-8)


def test_goes_on_and_refuses(swing: poinsot.Problem, tmp_path: Path) -> None:
    swing.record(tmp_path / "whole.csv", L=1.2)
    path = tmp_path / "swing.csv"
    with pytest.raises(poinsot.TimedOut):
        swing.record(path, L=1.2, timeout=1e-6)
    swing.record(path, L=1.2)
    assert path.read_bytes() == (tmp_path / "whole.csv").read_bytes()
    (tmp_path / "other.csv").write_text("mine")
    with pytest.raises(poinsot.RecordingError, match="say replace=True"):
        swing.record(tmp_path / "other.csv")
    assert swing.record(tmp_path / "other.csv", replace=True).complete
    with pytest.raises(poinsot.RecordingError, match="csv"):
        swing.record(tmp_path / "swing.txt")
    with pytest.raises(poinsot.StatementError, match="what to record"):
        poinsot.Problem.from_text(SWING[: SWING.index("record:")]).record(tmp_path / "none.csv")
