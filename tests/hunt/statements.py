"""Statements: problem files as trees of text, where they come from, and how they are walked through and written."""
import re
from copy import deepcopy

import yaml

from language import text_of, tokens_of

# Maps whose order has a meaning: stages follow each other in time.
ORDERED = {"stages", "over"}
TEXTS = {"title", "source", "file", "ends", "mass_added", "hole", "hypothesis", "no_slip", "stays"}
# Maps from names that the file gives to expressions: there a word of the language is a name like any other.
NAMED_EXPRESSIONS = {"given", "define", "ask", "claim"}


class Statement:
    """A problem file: a tree of maps, lists and text, and the files that it names."""

    def __init__(self, name, tree, files=None, settings=None, letters=None):
        self.name, self.tree, self.files = name, tree, files or {}
        self.settings = settings or {}  # values given from outside, as text
        self.letters = letters or {}  # values at which formulas are compared, as text

    def with_tree(self, tree, settings=None, letters=None):
        return Statement(self.name, tree, self.files, self.settings if settings is None else settings,
                         self.letters if letters is None else letters)

    def copy(self):
        return self.with_tree(deepcopy(self.tree), dict(self.settings))

    def text(self):
        return to_yaml(self.tree)


class Loader(yaml.CBaseLoader if hasattr(yaml, "CBaseLoader") else yaml.BaseLoader):
    """Every scalar stays the text that it is."""


def from_text(name, text, files=None):
    return Statement(name, yaml.load(text, Loader), files)


def scalar_to_yaml(text):
    if re.fullmatch(r"[A-Za-z0-9_.(+][A-Za-z0-9_.()+*/^ <=-]*", text) and text == text.strip() and "- " != text[:2]:
        return text
    return "'" + text.replace("'", "''") + "'"


def flow(node):
    if isinstance(node, dict):
        return "{" + ", ".join(f"{scalar_to_yaml(k)}: {flow(v)}" for k, v in node.items()) + "}"
    if isinstance(node, list):
        return "[" + ", ".join(flow(item) for item in node) + "]"
    return scalar_to_yaml(node)


def to_yaml(node, indent=""):
    lines = []
    for key, value in node.items():
        head = f"{indent}{scalar_to_yaml(key)}:"
        if isinstance(value, dict) and value and len(flow(value)) + len(head) > 100:
            lines.append(head)
            lines.append(to_yaml(value, indent + "  ").rstrip("\n"))
        else:
            lines.append(f"{head} {flow(value)}")
    return "\n".join(lines) + "\n"


def examples(root):
    """Every example and every problem of the manual, without the answers that they expect, in the order of their names."""
    found = []
    for path in sorted((root / "examples").glob("*/*.yaml")):
        found.append(prepared(str(path.relative_to(root)), path.read_text(), path.parent))
    manual = (root / "docs/language.md").read_text()
    meshes = dict(re.findall(r"```obj (\S+)\n(.*?)```", manual, re.DOTALL))
    for number, block in enumerate(re.findall(r"```yaml\n(.*?)```", manual, re.DOTALL)):
        statement = prepared(f"docs/language.md-{number + 1}", block, None)
        statement.files = {name: text for name, text in meshes.items() if name in block}
        found.append(statement)
    return [statement for statement in found if "ask" in statement.tree or "claim" in statement.tree]


def jiggled(statement, draw):
    """The statement with other values of its data: a new one, of which nobody knows the answers."""
    tree = deepcopy(statement.tree)

    def change(tokens, path):
        for token in tokens:
            if token.unit and token.value and token.unit.text != "%":
                token.text = f"{float(token.value) * draw.uniform(0.7, 1.4):.4g} {token.unit.text}"
        return tokens

    if isinstance(tree.get("given"), dict):
        tree["given"] = mapped_expressions({"given": tree["given"]}, change)["given"]
    other = statement.with_tree(tree)
    other.name += "~"
    return other


def prepared(name, text, folder):
    statement = from_text(name, text)
    expected = statement.tree.pop("expect", {})
    statement.tree.pop("record", None)
    values = dict(expected.get("letters", {}))
    for case in expected.get("cases", {}).values():
        values = values or dict(case.get("letters", {}))
    letters = statement.tree.get("letters", {})
    statement.letters = {k: v for k, v in values.items() if k in letters and isinstance(v, str)}
    if folder:
        for mesh in sorted(folder.glob("*.obj")) + sorted(folder.glob("*.stl")):
            if mesh.name in text:
                statement.files[mesh.name] = mesh.read_text()
    return statement


def is_named(path):
    """Whether the key at this path, within a situation, is a name that the file gives."""
    return len(path) == 2 and path[0] in NAMED_EXPRESSIONS


def role(path):
    """What a scalar at this path is: text, unit or expression (names are expressions of one token)."""
    while path and path[0] == "situations":
        path = path[2:]
    if not path:
        return "text"
    if path[0] in TEXTS or path[-1] in TEXTS and not is_named(path):
        return "text"
    if "mesh" in path and path[-1] == "unit":
        return "text"  # it says what the numbers of the file mean
    if path[0] in ("letters", "find") or "unit" in path[1:]:
        return "unit"
    return "expression"


def mapped(node, change, path=()):
    """A tree in which change(path, text) has replaced every scalar, and every key whose path ends with None."""
    if isinstance(node, dict):
        return {change(path + (key, None), key): mapped(value, change, path + (key,)) for key, value in node.items()}
    if isinstance(node, list):
        return [mapped(item, change, path + (str(i),)) for i, item in enumerate(node)]
    return change(path, node)


def is_fact_key(path):
    """Whether the key at this path is a quantity or a time: a fact's, or an instant's."""
    path = path[:-1]
    while path and path[0] == "situations":
        path = path[2:]
    return path[:1] in (("facts",), ("instants",)) or len(path) > 2 and path[-2] == "over"


def mapped_expressions(tree, change, units=lambda text: text, keys=True):
    """A tree in which change(tokens, path) has rewritten every expression, and units(text) every unit."""
    def rewritten(path, text):
        if path[-1] is None:
            if not keys or not is_fact_key(path) or not re.search(r"\d|\(|\.|'", text):
                return text
            return text_of(change(tokens_of(text), path))
        kind = role(path)
        if kind == "text" or not text:
            return text
        if kind == "unit":
            return units(text)
        return text_of(change(tokens_of(text), path))
    return mapped(tree, rewritten)


def has_word(tree, *words):
    """Whether one of these words stands in an expression or key of the tree."""
    pattern = re.compile(r"(?<![A-Za-z_0-9])(" + "|".join(map(re.escape, words)) + r")(?![A-Za-z_0-9])")
    if isinstance(tree, dict):
        return any(pattern.search(k) or has_word(v, *words) for k, v in tree.items() if k not in ("title", "source"))
    if isinstance(tree, list):
        return any(has_word(item, *words) for item in tree)
    return bool(pattern.search(tree))


def situations_of(tree):
    """The maps in which situations are stated: the top, and each under `situations:`."""
    return [tree] + [s for s in tree.get("situations", {}).values() if isinstance(s, dict)]
