"""Formulas as answers have them: infix text, its TeX, and expressions of SymPy."""

from __future__ import annotations

import re
from html import escape
from typing import TYPE_CHECKING, Any, TypeAlias

if TYPE_CHECKING:
    import sympy

# A tree: ("number", text), ("name", text), or (operator or function, branch, ...).
Tree: TypeAlias = tuple[Any, ...]

_TOKEN = re.compile(r"\s*(?:(?P<number>\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+)|(?P<name>[^\W\d]\w*'*)|(?P<sign>[-+*/^(),]))")
_FUNCTIONS = {"sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "abs", "sign", "exp", "ln", "log", "sinh", "cosh"}
# Greek letters by their names in TeX.
_GREEK = dict(
    zip(
        "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi omega "
        "Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega varphi".split(),
        "αβγδϵζηθικλμνξπρστυϕχψωΓΔΘΛΞΠΣΥΦΨΩφ",
        strict=True,
    )
)


class _Reader:
    """sum = ['-'] product {('+'|'-') product}; product = power {('*'|'/') power}; power = atom ['^' signed power]."""

    def __init__(self, text: str) -> None:
        self.text, self.tokens, at = text, [], 0
        text = text.rstrip()
        while at < len(text):
            match = _TOKEN.match(text, at)
            if not match:
                raise ValueError(f"'{self.text}' is no formula: '{text[at:].strip()}' is not understood")
            self.tokens.append((str(match.lastgroup), match[match.lastgroup or 0]))
            at = match.end()
        self.tokens.append(("end", ""))
        self.at = 0

    def read(self) -> Tree:
        tree = self.sum()
        if self.tokens[self.at][0] != "end":
            raise ValueError(f"'{self.text}' is no formula: '{self.tokens[self.at][1]}' is not expected there")
        return tree

    def taken(self, *signs: str) -> str:
        kind, token = self.tokens[self.at]
        if kind != "sign" or token not in signs:
            return ""
        self.at += 1
        return token

    def sum(self) -> Tree:
        negative = self.taken("-")
        tree = self.product()
        if negative:
            tree = ("negative", tree)
        while sign := self.taken("+", "-"):
            tree = (sign, tree, self.product())
        return tree

    def product(self) -> Tree:
        tree = self.power()
        while sign := self.taken("*", "/"):
            tree = (sign, tree, self.power())
        return tree

    def power(self) -> Tree:
        if self.taken("-"):
            return ("negative", self.power())
        tree = self.atom()
        return ("^", tree, self.power()) if self.taken("^") else tree

    def atom(self) -> Tree:
        if self.taken("("):
            tree = self.sum()
            self.expect(")")
            return tree
        kind, token = self.tokens[self.at]
        if kind not in ("number", "name"):
            raise ValueError(f"'{self.text}' is no formula: it ends too early or has '{token}' in place of a value")
        self.at += 1
        if kind == "name" and token in _FUNCTIONS and self.taken("("):
            arguments = [self.sum()]
            while self.taken(","):
                arguments.append(self.sum())
            self.expect(")")
            return (token, *arguments)
        return (kind, token)

    def expect(self, sign: str) -> None:
        if not self.taken(sign):
            raise ValueError(f"'{self.text}' is no formula: '{sign}' is missing")


def parse(text: str) -> Tree:
    """The tree of a formula. Raises ValueError."""
    return _Reader(text).read()


def letters(tree: Tree) -> set[str]:
    """The letters of a formula; pi is none."""
    if tree[0] == "number":
        return set()
    if tree[0] == "name":
        return {tree[1]} - {"pi"}
    return set().union(*map(letters, tree[1:]))


def tex_name(whole: str) -> str:
    """A name as TeX: omega1 is \\omega_{1}, theta' has a dot."""
    name = whole.rstrip("'")
    stem = re.sub(r"(?<=.)\d+$", "", name)
    base, _, low = stem.partition("_") if not stem.startswith("_") else (stem, "", "")
    index = low + name[len(stem) :]
    letter = "\\" + base if base in _GREEK else base if len(base) == 1 else "\\mathit{" + base.replace("_", "\\_") + "}"
    primes = len(whole) - len(name)
    if primes:
        letter = f"\\{'d' * primes}ot{{{letter}}}"
    return letter + ("_{" + index.replace("_", "\\_") + "}" if index else "")


def _in_brackets(tree: Tree, *kinds: str) -> str:
    return f"\\left({_tex(tree)}\\right)" if tree[0] in kinds else _tex(tree)


def _tex(tree: Tree) -> str:
    kind = tree[0]
    if kind == "number":
        return str(tree[1])
    if kind == "name":
        return tex_name(tree[1])
    if kind == "negative":
        return "-" + _in_brackets(tree[1], "+", "-")
    if kind in "+-":
        return f"{_tex(tree[1])} {kind} {_in_brackets(tree[2], 'negative', *('+-' if kind == '-' else ''))}"
    if kind == "*":
        left, right = (_in_brackets(part, "+", "-", "negative") for part in tree[1:])
        # Two numbers beside each other would read as one.
        return f"{left} \\cdot {right}" if right[0].isdigit() else f"{left} \\, {right}"
    if kind == "/":
        return f"\\frac{{{_tex(tree[1])}}}{{{_tex(tree[2])}}}"
    if kind == "^":
        simple = tree[1][0] == "name" and "'" not in tree[1][1] or tree[1][0] == "number"
        base = _tex(tree[1]) if simple else f"\\left({_tex(tree[1])}\\right)"
        return f"{base}^{{{_tex(tree[2])}}}"
    if kind == "sqrt":
        return f"\\sqrt{{{_tex(tree[1])}}}"
    name = {"asin": "\\arcsin", "acos": "\\arccos", "atan": "\\arctan", "log": "\\ln"}.get(kind)
    name = name or (f"\\operatorname{{{kind}}}" if kind in ("atan2", "abs", "sign") else "\\" + kind)
    return f"{name}\\left({', '.join(map(_tex, tree[1:]))}\\right)"


def tex(text: str) -> str:
    """The TeX of a formula."""
    return _tex(parse(text))


def _row(*parts: str) -> str:
    return f"<mrow>{''.join(parts)}</mrow>"


def _unseen(sign: str) -> str:
    # Where MathML is taken for unknown tags, as in a notebook that is not trusted, their texts are left: a line in which nothing is
    # missing.
    return f'<mtext style="display:none">{sign}</mtext>'


def mathml_name(whole: str) -> str:
    """A name as MathML: omega1 has an index, theta' a dot."""
    name = whole.rstrip("'")
    stem = re.sub(r"(?<=.)\d+$", "", name)
    base, _, low = stem.partition("_") if not stem.startswith("_") else (stem, "", "")
    index = low + name[len(stem) :]
    letter = f"<mi>{escape(_GREEK.get(base, base))}</mi>"
    if primes := len(whole) - len(name):
        letter = f'<mover accent="true">{letter}<mo>{"˙" if primes == 1 else "¨" if primes == 2 else "⃛"}</mo></mover>'
    return f"<msub>{letter}{_row(_unseen('_'), f'<mi>{escape(index)}</mi>')}</msub>" if index else letter


def _bracketed(inner: str) -> str:
    return _row("<mo>(</mo>", inner, "<mo>)</mo>")


def _mathml_in_brackets(tree: Tree, *kinds: str) -> str:
    return _bracketed(_mathml(tree)) if tree[0] in kinds else _mathml(tree)


def _mathml(tree: Tree) -> str:
    kind = tree[0]
    if kind == "number":
        return f"<mn>{escape(tree[1])}</mn>"
    if kind == "name":
        return mathml_name(tree[1])
    if kind == "negative":
        return _row("<mo>−</mo>", _mathml_in_brackets(tree[1], "+", "-"))
    if kind in "+-":
        sign = "−" if kind == "-" else kind
        return _row(_mathml(tree[1]), f"<mo>{sign}</mo>", _mathml_in_brackets(tree[2], "negative", *("+-" if kind == "-" else "")))
    if kind == "*":
        left, right = (_mathml_in_brackets(part, "+", "-", "negative") for part in tree[1:])
        # Two numbers beside each other would read as one.
        between = "<mo>·</mo>" if _begins_with_digit(tree[2]) else f'{_unseen("·")}<mspace width="0.17em"></mspace>'
        return _row(left, between, right)
    if kind == "/":
        above, below = (_row(_unseen("("), _mathml(part), _unseen(")")) for part in tree[1:])
        return f"<mfrac>{above}{_row(_unseen('/'), below)}</mfrac>"
    if kind == "^":
        simple = tree[1][0] == "name" and "'" not in tree[1][1] or tree[1][0] == "number"
        base = _mathml(tree[1]) if simple else _bracketed(_mathml(tree[1]))
        return f"<msup>{base}{_row(_unseen('^('), _mathml(tree[2]), _unseen(')'))}</msup>"
    if kind == "sqrt":
        return f"<msqrt>{_unseen('sqrt(')}{_mathml(tree[1])}{_unseen(')')}</msqrt>"
    name = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "log": "ln"}.get(kind, kind)
    return _row(f"<mi>{name}</mi><mo>&#8289;</mo>", _bracketed("<mo>,</mo>".join(map(_mathml, tree[1:]))))


def _begins_with_digit(tree: Tree) -> bool:
    if tree[0] == "number":
        return str(tree[1])[0].isdigit()
    return tree[0] in ("*", "^") and _begins_with_digit(tree[1])


def mathml(text: str) -> str:
    """The MathML of a formula, without the tag around it."""
    return _mathml(parse(text))


def _sympy(tree: Tree, names: dict[str, sympy.Expr]) -> sympy.Expr:
    import sympy

    kind = tree[0]
    if kind == "number":
        exact = "." not in tree[1] and "e" not in tree[1].lower()
        return sympy.Integer(tree[1]) if exact else sympy.Rational(tree[1])
    if kind == "name":
        return sympy.pi if tree[1] == "pi" else names[tree[1]]
    parts = [_sympy(part, names) for part in tree[1:]]
    if kind == "negative":
        return -parts[0]
    if kind == "+":
        return parts[0] + parts[1]
    if kind == "-":
        return parts[0] - parts[1]
    if kind == "*":
        return parts[0] * parts[1]
    if kind == "/":
        return parts[0] / parts[1]
    if kind == "^":
        return parts[0] ** parts[1]
    function: sympy.Expr = getattr(sympy, "Abs" if kind == "abs" else str(kind))(*parts)
    return function


def to_sympy(text: str, positive: set[str] | None = None) -> sympy.Expr:
    """The formula as an expression of SymPy; numbers stay exact. Letters have no assumptions, or, where it is given which
    are positive, are real."""
    import sympy

    tree = parse(text)

    def symbol(name: str) -> sympy.Expr:
        if positive is None:
            return sympy.Symbol(name)
        return sympy.Symbol(name, positive=True) if name in positive else sympy.Symbol(name, real=True)

    names: dict[str, sympy.Expr] = {name: symbol(name) for name in letters(tree)}
    return _sympy(tree, names)
