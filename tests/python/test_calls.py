"""Long calls: deadlines, Ctrl-C, threads, progress."""

import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import poinsot

LONG = Path(__file__).parents[2] / "examples/benchmarks/A05.yaml"  # seconds of work


@pytest.fixture(scope="module")
def long() -> poinsot.Problem:
    return poinsot.Problem.from_file(LONG)


def test_a_deadline_ends_the_search(long: poinsot.Problem) -> None:
    start = time.monotonic()
    result = long.solve(timeout=0.3)
    assert time.monotonic() - start < 1.5
    assert result.ended == "deadline"
    assert not result.fully_answered


def test_nothing_is_found_in_no_time(long: poinsot.Problem) -> None:
    with pytest.raises(poinsot.TimedOut):
        long.check(timeout=0)


def ball(folder: Path, rings: int) -> Path:
    """A problem with a round mesh of about four triangles for the square of the rings."""
    turns, heights = np.arange(2 * rings) * np.pi / rings, np.arange(1, rings) * np.pi / rings
    points = np.stack([np.outer(np.sin(heights), np.cos(turns)), np.outer(np.sin(heights), np.sin(turns)),
                       np.outer(np.cos(heights), np.ones_like(turns))], axis=-1)
    right = np.roll(points, -1, axis=1)
    top, bottom = (np.broadcast_to([0.0, 0.0, z], points[:1].shape) for z in (1, -1))
    faces = [np.stack(corners, axis=2).reshape(-1, 3, 3) for corners in (
        (points[:-1], points[1:], right[1:]), (points[:-1], right[1:], right[:-1]),
        (top, points[:1], right[:1]), (bottom, right[-1:], points[-1:]))]
    records = np.zeros(sum(map(len, faces)), dtype=[("normal", "<3f4"), ("corners", "<9f4"), ("attribute", "<u2")])
    records["corners"] = np.concatenate(faces).reshape(-1, 9)
    (folder / "ball.stl").write_bytes(bytes(80) + len(records).to_bytes(4, "little") + records.tobytes())
    (folder / "ball.yaml").write_text("bodies: {ball: {mesh: {file: ball.stl, unit: m}, mass: 2 kg}}\ngravity: none\n"
                                      "ask: {I: moment_of_inertia(ball about z at center(ball))}\n")
    return folder / "ball.yaml"


def test_reading_a_large_mesh_can_be_ended(tmp_path: Path) -> None:
    path = ball(tmp_path, 400)  # 638,400 triangles, most of a second
    with pytest.raises(poinsot.TimedOut):
        poinsot.Problem.from_file(path, timeout=0.05)
    with pytest.raises(poinsot.TimedOut):
        poinsot.Problem.from_text(path.read_text(), str(path), timeout=0.05)
    threading.Timer(0.1, signal.raise_signal, [signal.SIGINT]).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        poinsot.Problem.from_file(path)
    assert time.monotonic() - start < 1.5
    # Solid, of radius one: 2/5 m, less what the flat triangles cut off.
    inertia = poinsot.Problem.from_file(ball(tmp_path, 40), timeout=60).solve()["I"].si
    assert 0.79 < inertia < 0.8


def test_control_c_ends_the_search(long: poinsot.Problem) -> None:
    threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt) as caught:
        long.solve()
    assert time.monotonic() - start < 1.5
    assert isinstance(caught.value, poinsot.Interrupted)
    assert caught.value.found.ended == "interrupted"


def test_other_signals_raise_what_their_handlers_raise(long: poinsot.Problem) -> None:
    class Enough(Exception):
        pass

    def handler(*_: object) -> None:
        raise Enough

    before = signal.signal(signal.SIGALRM, handler)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with pytest.raises(Enough):
            long.solve()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_other_threads_run_meanwhile(long: poinsot.Problem) -> None:
    beats: list[float] = []
    done = threading.Event()

    def beat() -> None:
        while not done.is_set():
            beats.append(time.monotonic())
            time.sleep(0.01)

    thread = threading.Thread(target=beat)
    thread.start()
    long.solve(timeout=0.5)
    done.set()
    thread.join()
    assert len(beats) > 15


def test_threads_answer_alike(askew: poinsot.Problem) -> None:
    found: dict[int, float] = {}

    def solve(n: int) -> None:
        found[n] = askew.solve(n=n)["T"].value

    threads = [threading.Thread(target=solve, args=[n]) for n in range(1, 9)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == {n: askew.solve(n=n)["T"].value for n in range(1, 9)}


def test_progress_is_told(long: poinsot.Problem) -> None:
    told: list[tuple[str, float | None, int]] = []
    long.solve(timeout=0.6, progress=lambda *one: told.append(one))
    assert told
    assert all(doing and (part is None or 0 <= part <= 1) and count >= 0 for doing, part, count in told)


def test_what_a_listener_raises_comes_through(long: poinsot.Problem) -> None:
    def listener(*_: object) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        long.solve(timeout=5, progress=listener)


def test_a_bar_is_shown(capsys: pytest.CaptureFixture[str]) -> None:
    # It is shown from the first second on: ten times as long a motion takes longer on any machine.
    longer = poinsot.Problem.from_text(LONG.read_text().replace("@ 10 s", "@ 100 s"))
    longer.solve(timeout=1.6, progress=True)
    assert "motion" in capsys.readouterr().err
