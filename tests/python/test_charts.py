"""Charts of studies and motions: their lines have the numbers of the columns, in the units at the axes."""

from collections.abc import Iterator

import matplotlib
import numpy as np
import pytest

import poinsot

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


@pytest.fixture(autouse=True)
def closed() -> Iterator[None]:
    yield
    plt.close("all")


def test_a_line_for_each_value_of_the_others(askew: poinsot.Problem) -> None:
    over = {"n": poinsot.span("1000 rpm", "3000 rpm", 5), "b": ["10 deg", "20 deg"]}
    study = poinsot.study(askew, over, ["T", "B"])
    ax = study.plot("B.y", units={"n": "rpm", "B.y": "kN", "b": "deg"})
    assert ax.get_xlabel() == "n / rpm" and ax.get_ylabel() == "B.y / kN"
    assert [line.get_label() for line in ax.lines] == ["b = 10 deg", "b = 20 deg"]
    for line, b in zip(ax.lines, ("10 deg", "20 deg"), strict=True):
        assert line.get_xdata() == pytest.approx([1000, 1500, 2000, 2500, 3000])
        alone = [askew.solve(n=f"{n} rpm", b=b)["B"].to("kN")[1] for n in (1000, 1500, 2000, 2500, 3000)]
        assert line.get_ydata() == pytest.approx(alone, rel=1e-9)
    assert study.plot("T", over="b").get_xlabel() == "b / rad"
    assert [line.get_label() for line in study.plot("B").lines][:2] == ["B.x, b = 0.174533 rad", "B.y, b = 0.174533 rad"]
    # One unit for all components.
    assert study.plot("B", units={"B": "kN"}).get_ylabel() == "B.x, B.y, B.z / kN"
    # Those with the unit of the first answer.
    assert study.plot().get_ylabel() == "T / J"
    fig, ax = plt.subplots()
    assert study.plot("T", ax=ax) is ax


def test_charts_of_random_values(askew: poinsot.Problem) -> None:
    over = {"n": poinsot.normal("2000 rpm", "30 rpm"), "b": poinsot.tolerance("20 deg", "0.3 deg")}
    study = poinsot.study(askew, over, "B", rows=2000)
    (points,) = study.plot("B.y", units={"B.y": "kN"}).lines
    assert np.asarray(points.get_ydata()) == pytest.approx(study["B.y"] / 1000)
    bars = study.plot_distribution("B.y", units={"B.y": "kN"})
    assert sum(one.get_height() for one in bars.patches) == 2000 and bars.get_xlabel() == "B.y / kN"
    tornado = study.plot_tornado("B.y", units={"B.y": "kN"})
    frame = study.tornado("B.y")
    assert [one.get_text() for one in tornado.get_yticklabels()] == list(frame.index)
    assert [one.get_width() for one in tornado.patches] == pytest.approx(list(frame["change"] / 1000))
    # The largest is at the top.
    assert tornado.patches[0].get_y() > tornado.patches[1].get_y()


def test_what_cannot_be_drawn(askew: poinsot.Problem) -> None:
    study = poinsot.study(askew, {"n": poinsot.span("1000 rpm", "3000 rpm", 40), "b": ["10 deg", "20 deg"]}, ["T", "B"])
    with pytest.raises(ValueError, match="one axis has one unit"):
        study.plot("T", "B.y")
    with pytest.raises(KeyError, match="no column of the study 'Q'"):
        study.plot("Q")
    with pytest.raises(ValueError, match="m was not varied: expected n, b"):
        study.plot("T", over="m")
    with pytest.raises(ValueError, match="cannot be told in 'kg'"):
        study.plot("T", units={"T": "kg"})
    with pytest.raises(KeyError, match="no column 'X'"):
        study.plot("T", units={"X": "kg"})
    with pytest.raises(ValueError, match="40 lines are too many"):
        study.plot("T", over="b")
    with pytest.raises(ValueError, match="expected B.x, B.y, B.z"):
        study.plot_distribution("B")


def test_rows_without_answers_leave_gaps() -> None:
    problem = poinsot.Problem.from_text(
        "title: Ball on a cord at the top of its circle\ngiven: {m: 2 kg, L: 1 m, v: 5 m/s}\n"
        "points: {O: [0, 0, 0], P: [0, L, 0]}\nbodies: {ball: {particle: P, mass: m}}\n"
        "cords: {c: {from: ground, at: O, to: ball, end: P}}\ngravity: -y\n"
        "instants: {top: {velocity(ball): [v, 0, 0]}}\nask: {S: tension(c)}\n"
    )
    study = poinsot.study(problem, {"v": [1, 2, 4, 5]})
    (line,) = study.plot().lines
    assert list(np.isnan(np.asarray(line.get_ydata(), dtype=float))) == [True, True, False, False]


def swinging() -> poinsot.MotionValues:
    problem = poinsot.Problem.from_text(
        "given: {m: 3 kg, l: 2 m}\npoints: {O: [0, 0, 0], P: [0, -l, 0]}\nbodies: {bar: {rod: [O, P], mass: m}}\n"
        "joints: {pin: {revolute: z, at: O, to: bar, angle: theta}}\ngravity: -y\n"
        "instants: {start: {theta: 60 deg, theta': 0}}\nask: {T: mass(bar)}\n"
    )
    return problem.motion(np.linspace(0, 1, 11), "theta", "velocity(P of bar)", "position(P of bar)")


def test_motions() -> None:
    values = swinging()
    ax = values.plot("theta", units={"theta": "deg"})
    assert ax.get_xlabel() == "time / s" and ax.get_ylabel() == "theta / deg"
    assert ax.lines[0].get_ydata()[0] == pytest.approx(60)
    vector = values.plot("velocity(P of bar)")
    assert [line.get_label() for line in vector.lines] == [f"velocity(P of bar).{axis}" for axis in "xyz"]


def test_datasets() -> None:
    xarray = pytest.importorskip("xarray")
    values = swinging()
    data = values.dataset()
    assert isinstance(data, xarray.Dataset) and data["theta"].attrs["units"] == "rad" and data["time"].attrs["units"] == "s"
    assert float(data["velocity(P of bar)"].sel(axis="x")[3]) == values["velocity(P of bar)"][3, 0]
    # Two vectors on the same axes have one dimension of them.
    assert data["position(P of bar)"].dims == ("time", "axis")
