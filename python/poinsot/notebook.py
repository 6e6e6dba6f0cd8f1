"""How answers look in a notebook: HTML and TeX of their texts, which stay text whatever they hold."""

from __future__ import annotations

import os
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import NoAnswer

if TYPE_CHECKING:
    from .answers import Answer, Found, Result, Solution, Unknown

_DIGITS = 6


def _number(value: float) -> str:
    text = f"{value:.{_DIGITS}g}"
    return "0" if text == "-0" else text


def _shown(value: Any) -> str:
    if isinstance(value, (bool, str)):
        return "yes" if value is True else "no" if value is False else value
    if isinstance(value, (np.ndarray, list)):
        return "(" + ", ".join(_shown(one) for one in value) + ")"
    return _number(float(value))


def _mathml(inner: str) -> str:
    return f'<math displaystyle="true"><mrow>{inner}</mrow></math>'


def _formula_html(found: Found) -> str:
    """A formula for browsers, which set MathML by themselves: in HTML not all who show notebooks look for TeX."""
    from . import formulas

    name = f"{formulas.mathml_name(found.name)}<mo>=</mo>"
    told = escape(_shown_formula(found.formula))
    if not isinstance(found.formula, list):
        return f'<span title="{told}">{_mathml(name + formulas.mathml(found.formula))}</span>'
    rows = [row if isinstance(row, list) else [row] for row in found.formula]
    # The commas are seen where MathML is not known.
    comma = '<mtext style="display:none">, </mtext></mtd>'
    lines = [comma.join(f"<mtd>{formulas.mathml(one)}" for one in row) for row in rows]
    cells = "<mtr>" + f"{comma}</mtr><mtr>".join(lines) + "</mtd></mtr>"
    table = f'<mtable displaystyle="true">{cells}</mtable>'
    # Brackets as high as what is in them, whatever fonts there are.
    edge = "border:solid;border-width:0 1.5px;border-radius:0.8em;padding:0.1em 0.4em;margin-left:0.2em"
    return (
        f'<span title="{told}" style="display:inline-flex;align-items:center">{_mathml(name)}'
        f'<span style="{edge}">{_mathml(table)}</span></span>'
    )


def _is_table(found: Found) -> bool:
    return bool(getattr(found, "is_table", False))


def text_of(found: Found) -> str:
    """Value and unit, or else the formula, or else why there is none."""
    state = getattr(found, "state", "found")
    if _is_table(found):
        columns = ", ".join(one.name for one in found._core.columns)
        return f"table of {columns} ({len(found._core.columns[0].value)} rows)"
    claim = getattr(found, "claim", None)
    if claim is not None and state == "found":
        return f"holds, {claim.how}" if claim.holds else "does not hold"
    if found.formula is not None:
        return _shown_formula(found.formula)
    try:
        return f"{_shown(found.value)} {found.unit}".strip()
    except NoAnswer as error:
        return str(error)


def _shown_formula(formula: Any) -> str:
    return "(" + ", ".join(map(_shown_formula, formula)) + ")" if isinstance(formula, list) else str(formula)


def _tex_number(value: float) -> str:
    mantissa, _, exponent = _number(value).partition("e")
    return f"{mantissa} \\cdot 10^{{{int(exponent)}}}" if exponent else mantissa


def _tex_of(value: Any) -> str:
    if isinstance(value, (list, np.ndarray)):
        rows = [" & ".join(map(_tex_of, row)) if isinstance(row, (list, np.ndarray)) else _tex_of(row) for row in value]
        return "\\begin{pmatrix} " + " \\\\ ".join(rows) + " \\end{pmatrix}"
    return value if isinstance(value, str) else _tex_number(float(value))


def _tex_unit(unit: str) -> str:
    if not unit:
        return ""
    powers = [part.partition("^") for part in unit.replace("/", " / ").replace("*", " * ").split()]
    text = "".join(
        {"*": " \\cdot ", "/": "/"}.get(name, f"\\mathrm{{{name}}}" + (f"^{{{power}}}" if power else ""))
        for name, _, power in powers
    )
    return "\\;" + text


def equation(found: Found) -> str | None:
    """The name and what it is equal to, as TeX; None where mathematics does not say it."""
    from . import formulas

    if _is_table(found) or getattr(found, "claim", None) is not None:
        return None
    name = formulas.tex_name(found.name)
    if found.tex is not None:
        return f"$\\displaystyle {name} = {_tex_of(found.tex)}$"
    try:
        value = found.value
    except NoAnswer:
        return None
    if isinstance(value, (bool, str)) or (isinstance(value, list)):
        return None
    return f"$\\displaystyle {name} = {_tex_of(value)}{_tex_unit(found.unit)}$"


def _cell(found: Found) -> str:
    if _is_table(found):
        frame = found.frame()  # type: ignore[attr-defined]
        units = frame.attrs["units"]
        headed = frame.rename(columns={name: f"{name} / {unit}" if unit else name for name, unit in units.items()})
        return str(headed.to_html(max_rows=12, float_format=_number, index=False, border=0))
    return _formula_html(found) if found.formula is not None else escape(text_of(found))


def _row(name: str, words: str, cell: str) -> str:
    left = "text-align:left;vertical-align:top"
    return (
        f'<tr><td style="{left}"><b>{escape(name)}</b></td><td style="{left}">{escape(words)}</td>'
        f'<td style="{left}">{cell}</td></tr>'
    )


def _table(rows: list[str]) -> str:
    return f"<table>{''.join(rows)}</table>" if rows else ""


def unknowns_html(unknowns: list[Unknown]) -> str:
    return _table([_row(one.name, "unknown", _cell(one)) for one in unknowns])


def answers_html(answers: list[Answer]) -> str:
    return _table([_row(one.name, one.words or one.ask, _answer_cell(one)) for one in answers])


def _answer_cell(answer: Answer) -> str:
    cell = _cell(answer)
    if answer.state == "found" and answer.axes:
        cell += f" on {escape(', '.join(answer.axes))}"
    return cell


def solution_html(solution: Solution) -> str:
    html = unknowns_html(list(solution.unknowns.values()))
    html += answers_html(list(solution.answers.values()))
    if solution.assumptions:
        html += f"<p>where {escape(', '.join(solution.assumptions))}</p>"
    html += "".join(f"<p>{escape(note)}</p>" for note in solution.notes)
    if solution.checks:
        checks = ", ".join(f"{name.replace('_', ' ')} {misfit:.0e}" for name, misfit in solution.checks.items())
        html += f"<p><small>checked on particles: {escape(checks)}</small></p>"
    return html


def result_html(result: Result) -> str:
    html = f"<p><b>{escape(result.title)}</b></p>" if result.title else ""
    several = len(result.solutions) > 1
    for number, solution in enumerate(result.solutions, 1):
        html += (f"<p>Solution {number} of {len(result.solutions)}</p>" if several else "") + solution_html(solution)
    if not result.solutions:
        html += "<p>There is no solution.</p>"
    return html + "".join(f"<p>Warning: {escape(warning)}</p>" for warning in result.warnings)


class Picture:
    """A line drawing: str() is its SVG."""

    def __init__(self, svg: str) -> None:
        self.svg = svg

    def __str__(self) -> str:
        return self.svg

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<poinsot.Picture: {len(self.svg)} characters of SVG; save(path) writes them>"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes it to a file, whose name ends in .svg."""
        _save(self.svg, path, ".svg")


class Page:
    """A page for a browser: str() is its HTML. In a notebook it stands in a frame of its own, player included."""

    def __init__(self, html: str, height: int = 720) -> None:
        self.html, self.height = html, height

    def __str__(self) -> str:
        return self.html

    def _repr_html_(self) -> str:
        return (
            f'<iframe srcdoc="{escape(self.html)}" sandbox="allow-scripts allow-downloads" '
            f'style="width:100%;height:{self.height}px;border:0" title="poinsot"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<poinsot.Page: {len(self.html)} characters of HTML; save(path) writes them>"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes it to a file, whose name ends in .html."""
        _save(self.html, path, ".html", ".htm")


def with_player_first(page: Page) -> Page:
    """The page with its view in space, and the player there, above the statement."""
    above = "<style>main,main>div:has(canvas){display:flex;flex-direction:column}main>div:has(canvas),section:has(canvas){order:-1}</style>"
    return Page(page.html.replace("</head>", f"{above}</head>", 1), page.height)


def _save(text: str, path: str | os.PathLike[str], *endings: str) -> None:
    name = os.fspath(path)
    if os.path.splitext(name)[1] and not name.lower().endswith(endings):
        raise ValueError(f"'{name}' would be no file of its kind: what is written is {endings[0]}")
    with open(name, "w", encoding="utf-8") as file:
        file.write(text)
