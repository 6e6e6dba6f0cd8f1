"""What a notebook shows of problems, answers and pages."""

import xml.etree.ElementTree as ET
from html import unescape

import pandas
import pytest

import poinsot

TABLE = """\
given: {m: 2 kg, l: 1 m}
points: {O: [0, 0, 0], P: [l, 0, 0]}
bodies: {bar: {rod: [O, P], mass: m}}
joints: {pin: {revolute: z, at: O, to: bar, angle: theta}}
gravity: none
instants:
  start: {theta: 0, theta': 30 rpm}
ask:
  t: {table: {time: time, theta: theta}, over: {time: 0 s .. 1 s by 0.25 s}, unit: {theta: deg}}
"""


def test_answers_as_html_and_tex(askew: poinsot.Problem, bent: poinsot.Problem) -> None:
    result = askew.solve()
    html = result._repr_html_()
    assert html is not None
    ET.fromstring(f"<page>{html}</page>")
    assert "669.049 J" in html and "kinetic energy of disk" in html
    assert result["T"]._repr_latex_() == r"$\displaystyle T = 669.049\;\mathrm{J}$"
    formula = bent.solve()["w"]._repr_latex_()
    assert formula is not None and r"\frac{12 \, J}{7 \, m \, a}" in formula
    assert "holds, proved" in str(bent.solve()._repr_html_())


def test_texts_stay_text() -> None:
    problem = poinsot.Problem.from_text(
        """\
title: "<script>alert(1)</script>"
bodies: {"b": {sphere: {center: [0, 0, 0], radius: 1 m}, mass: 5 kg}}
ask: {m: mass(b)}
"""
    )
    assert "<script>" not in str(problem.solve()._repr_html_())


def test_figures(askew: poinsot.Problem) -> None:
    svg = askew._repr_svg_()
    assert svg is not None and ET.fromstring(svg).tag.endswith("svg")
    assert set(askew.figures()) >= {"model", "free-body"}
    with_values = askew.figure("free-body", with_values=True, n="2400 rpm")
    # Four times the reactions at twice the rate: 456.772 N at 1200 rpm.
    assert "1827" in with_values.svg or "1830" in with_values.svg
    assert askew.figure(view="top").svg != askew.figure(view="front").svg


def test_a_page_stands_in_a_frame(askew: poinsot.Problem) -> None:
    page = askew.report(n="2400 rpm")
    frame = page._repr_html_()
    document = frame.split('srcdoc="')[1].split('"')[0]
    assert unescape(document) == page.html
    assert page.html.lower().startswith("<!doctype html>")
    # The page may run its own script, and reaches nothing of the notebook.
    assert "allow-same-origin" not in frame


def test_a_motion_shows_its_player() -> None:
    problem = poinsot.Problem.from_text(TABLE)
    shown = problem.motion(m=3)._repr_html_()
    assert shown == problem.report(m=3)._repr_html_() and "iframe" in shown


def test_tables_are_frames(capsys: pytest.CaptureFixture[str]) -> None:
    answer = poinsot.Problem.from_text(TABLE).solve()["t"]
    frame = answer.frame()
    assert isinstance(frame, pandas.DataFrame)
    assert frame.attrs["units"] == {"time": "s", "theta": "deg"}
    assert frame["theta"].to_list() == pytest.approx([0, 45, 90, 135, 180], abs=1e-9)
    assert answer.frame(si=True)["theta"].to_list()[-1] == pytest.approx(3.141592653589793)
    assert answer.frame(si=True).attrs["units"] == {"time": "s", "theta": "rad"}
    assert "theta / deg" in answer._repr_html_()
    with pytest.raises(poinsot.NoAnswer, match="it is a table"):
        answer.value
