"""What a notebook shows of problems, answers and pages."""

import cmath
import xml.etree.ElementTree as ET
from html import unescape
from random import Random
from typing import Any

import pandas
import pytest
from IPython.core.formatters import DisplayFormatter

import poinsot
from poinsot import formulas

from outputs import wrong_in

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


def test_all_that_is_shown_is_fit_for_who_shows_notebooks(askew: poinsot.Problem, bent: poinsot.Problem) -> None:
    table = poinsot.Problem.from_text(TABLE)
    given = askew.text.replace("n: 1200 rpm, ", "").replace("ask:", "find: {n: rpm}\ninstants: {now: {reaction(B).y: 100 N}}\nask:")
    found, motion = poinsot.Problem.from_text(given).solve(), table.motion()
    study = poinsot.study(askew, {"n": poinsot.span("1000 rpm", "3000 rpm", 3)}, "B")
    shown = [
        askew, askew.solve(), askew.solve().solution, askew.solve()["T"], askew.solve()["B"], askew.explain(), bent, bent.solve(),
        bent.solve()["w"], bent.solve()["more"], table.solve(), table.solve()["t"], found, found.solutions[0], found.solutions[0].unknowns["n"],
        motion, motion([0, 0.5]), study, askew.report(), askew.figure("free-body", with_values=True),
    ]  # fmt: skip
    formatter: Any = DisplayFormatter()
    for one in shown:
        output, _ = formatter.format(one)
        assert wrong_in(output) == [], one
        # TeX alone needs an extension.
        assert set(output) & {"text/html", "image/svg+xml", "text/markdown"}, one
    assert "sandbox" in formatter.format(motion)[0]["text/html"]


@pytest.mark.parametrize(
    ("form", "text", "wrong"),
    [
        ("text/html", "<table><tr><td>$x$</td></tr></table>", "TeX in HTML: $x$"),
        ("text/html", "<p>a<b>c</p>", "</p> ends nothing"),
        ("text/html", "<div><p>a</p>", "<div> has no end"),
        ("text/html", "<script>x</script>", "<script> in HTML"),
        ("text/html", '<img src="https://a.b/c.png">', "<img> loads https://a.b/c.png"),
        ("text/html", '<p onclick="x()">a</p>', "onclick of <p> is a script"),
        ("text/html", '<iframe srcdoc="a"></iframe>', "a frame that is no page of its own"),
        ("image/svg+xml", '<svg xmlns="http://www.w3.org/2000/svg"><style>a{}</style></svg>', "<style> in SVG"),
        ("text/latex", "x^2", "TeX that nobody takes for it: x^2"),
    ],
)
def test_what_is_unfit_is_seen(form: str, text: str, wrong: str) -> None:
    assert wrong in wrong_in({"text/plain": "x", form: text})


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
    assert shown is not None and "iframe" in shown
    # The page of the report, with a rule that puts the view in space first.
    document = unescape(shown.split('srcdoc="')[1].split('"')[0])
    rule = document[document.rindex("<style>") : document.index("</head>")]
    assert "canvas" in rule and document.replace(rule, "") == problem.report(m=3).html


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


def test_formulas_stand_in_html_as_mathml(bent: poinsot.Problem) -> None:
    """Who shows HTML need not look for TeX in it, as VS Code does not."""
    html = str(bent.solve()._repr_html_())
    assert "$" not in html
    page = ET.fromstring(f"<page>{html}</page>".replace("&#8289;", ""))
    (title,) = (one.attrib["title"] for one in page.iter("span") if "title" in one.attrib)
    assert title == "(0, -12*J/(7*m*a), 60*J/(7*m*a))"
    name, column = page.iter("math")
    assert "".join(name.itertext()) == "w="
    first, second, third = column.iter("mtr")
    assert [seen(one) for one in (first, second, third)] == ["0", "−12J7ma", "60J7ma"]
    above, below = next(third.iter("mfrac"))
    assert (seen(above), seen(below)) == ("60J", "7ma")
    # Who takes the tags away has a formula nevertheless.
    assert "w=0, −(12·J)/(7·m·a), (60·J)/(7·m·a)" in "".join(page.itertext())


def seen(node: ET.Element) -> str:
    """The texts of MathML that are shown."""
    if node.tag == "mtext" and node.attrib.get("style") == "display:none":
        return node.tail or ""
    return (node.text or "") + "".join(map(seen, node)) + (node.tail or "")


@pytest.mark.parametrize(
    ("formula", "shown"),
    [
        ("-(a + b)*c", "<mo>−</mo>(a+b) c"),
        ("2*3^(1/2)", "2<mo>·</mo>3^(1/2)"),
        ("a - (b - c)", "a−(b−c)"),
        ("a - (b + c)", "a−(b+c)"),
        ("a + (b + c)", "a+b+c"),
        ("a*(-b)", "a (−b)"),
        ("(a + b)^2/theta'^2", "(a+b)^2/(θ˙)^2"),
        ("sqrt(105)/16*omega_12", "√(105)/16 ω_12"),
        ("atan2(x, -y)", "atan2(x,−y)"),
        ("exp(-mu*pi)*W", "exp(−μ π) W"),
        ("acos(x'')", "arccos(x¨)"),
    ],
)
def test_mathml_of_formulas(formula: str, shown: str) -> None:
    def line(node: ET.Element) -> str:
        inner = [line(one) for one in node if "style" not in one.attrib]
        if node.tag == "mfrac":
            return "/".join(one if len(one) == 1 or one.isdigit() or one.startswith(("√", "(")) else f"({one})" for one in inner)
        if node.tag in ("msup", "msub"):
            return f"{inner[0]}{'^' if node.tag == 'msup' else '_'}{inner[1] if len(inner[1]) < 3 else f'({inner[1]})'}"
        if node.tag == "msqrt":
            return f"√({''.join(inner)})"
        return " " if node.tag == "mspace" else (node.text or "") + "".join(inner)

    wanted = shown.replace("<mo>", "").replace("</mo>", "")
    assert line(ET.fromstring(f"<mrow>{formulas.mathml(formula).replace('&#8289;', '')}</mrow>")) == wanted


def test_the_texts_of_mathml_are_the_formula() -> None:
    """Formulas drawn at random, whose MathML without its tags has the same value."""
    random = Random(4)

    def drawn(depth: int) -> str:
        if depth == 0:
            return random.choice(["x", "y", "2", "0.5", "7"])
        one, other = drawn(depth - 1), drawn(depth - 1)
        forms = ["(A + B)", "(A - B)", "A*B", "(A)/(B)", "-(A)", "sqrt(A^2 + 1)", "(A)^2", "sin(A)", "atan2(A, B)"]
        return random.choice(forms).replace("A", one).replace("B", other)

    compared = 0
    for _ in range(200):
        text = drawn(3)
        texts = "".join(ET.fromstring(f"<m>{formulas.mathml(text).replace('&#8289;', '')}</m>").itertext())
        written = texts.replace("−", "-").replace("·", "*")
        for at in ({"x": 0.37, "y": 1.3}, {"x": -2.1, "y": 0.8}):
            try:
                wanted = complex(formulas.to_sympy(text).subs(at).evalf())
            except TypeError:
                continue
            if not cmath.isfinite(wanted):
                continue  # a division by zero
            assert complex(formulas.to_sympy(written).subs(at).evalf()) == pytest.approx(wanted, rel=1e-9, abs=1e-12), (text, written)
            compared += 1
    assert compared > 300
