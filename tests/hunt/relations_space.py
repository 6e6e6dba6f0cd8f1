"""Relations of space: the figure turned against the axes, and shifted from the origin."""
import math
import re
from fractions import Fraction

from language import Token, number_text, text_of, tokens_of
from relations import NotApplicable, Relation, SKIP, Varied, scales_of
from relations_matter import asked_text
from statements import has_word, is_named, situations_of

# Lists of three whose items are no components: of names, directions or points.
NO_VECTORS = {"axes", "semi_axes", "of", "while", "where", "loads", "supports", "carries", "rod", "wire", "polygon",
              "triangle", "tetrahedron", "corners", "sides", "universal", "slot", "diameter", "diagonal", "rows", "assume",
              "claim", "neglect", "angles", "without", "choose", "over", "ask"}
PLACES = {"center", "at", "end", "apex", "base", "top", "particle", "weld", "ball", "start", "origin"}
LISTS_OF_PLACES = {"rod", "wire", "polygon", "triangle", "tetrahedron", "corners", "diameter", "diagonal"}


def turning(random):
    """A rotation with rational entries, from a quaternion of whole numbers."""
    a, b, c, d = (random.choice([-3, -2, -1, 1, 2, 3]) for _ in range(4))
    n = Fraction(a * a + b * b + c * c + d * d)
    return [[(a * a + b * b - c * c - d * d) / n, 2 * (b * c - a * d) / n, 2 * (b * d + a * c) / n],
            [2 * (b * c + a * d) / n, (a * a - b * b + c * c - d * d) / n, 2 * (c * d - a * b) / n],
            [2 * (b * d - a * c) / n, 2 * (c * d + a * b) / n, (a * a - b * b - c * c + d * d) / n]]


class Turned(Relation):
    name = "turned"
    changes = "the whole figure is turned; answers on axes that are turned with it stay"
    directions = ("hx", "hy", "hz")

    def vary(self, statement, random):
        tree = statement.copy().tree
        self.require(tree)
        names = tree.get("axes", ["x", "y", "z"])
        if not isinstance(names, list):
            raise NotApplicable
        axes = dict(zip(names, self.directions))
        turned = self.rewritten(tree, axes, ())
        matrix = turning(random)
        turned["directions"] = {**turned.get("directions", {}), **{
            name: [number_text(matrix[row][column]) for row in range(3)] for column, name in enumerate(self.directions)}}

        def expected(name, value, answer):
            return SKIP if "principal_axes" in asked_text(answer) or "direction_angles" in asked_text(answer) else value

        return Varied(statement.with_tree(turned), expected)

    @staticmethod
    def require(tree):
        """Says nothing of what is drawn along the axes by its nature, or given on a body's axes."""
        if has_word(tree, "plane", "planar", "box_shell", "direction_angles", "rows", "vector", "mesh", "record", "principal_axes"):
            raise NotApplicable
        for situation in situations_of(tree):
            # A list that is no vector has its places by the axes.
            if any("products_of_inertia(" in str(situation.get(kind, {})) for kind in ("instants", "facts")):
                raise NotApplicable
            for kind in ("loads", "impulses", "excitations"):
                if any("axes" in load for load in situation.get(kind, {}).values() if isinstance(load, dict)):
                    raise NotApplicable
            for kind in ("ask", "claim"):
                if any(isinstance(ask, dict) and isinstance(ask.get("axes"), str) for ask in situation.get(kind, {}).values()):
                    raise NotApplicable
            for body in situation.get("bodies", {}).values():
                if re.search(r"'(box|cube)': \{[^{}]*'(corners|side)'", str(body)) and ("contacts" in tree or "corners" in str(body)):
                    raise NotApplicable

    def rewritten(self, node, axes, path):
        if isinstance(node, dict):
            made = {}
            for key, value in node.items():
                inner = path + (key,)
                if self.is_fact_map(path):
                    made.update(self.fact(key, value, axes, inner))
                elif path in ((), ("situations",)) and key == "axes" or key in ("title", "source", "letters", "find", "unit"):
                    made[key] = value
                else:
                    made[key] = self.rewritten(value, axes, inner)
            if path and path[-1] in ("inertia", "radii_of_gyration") and not {"axes", "axis"} & set(made) or \
                    path and path[-1] == "ellipsoid" and "axes" not in made:
                made["axes"] = list(self.directions)
            if path and path[-1] in ("ask", "claim"):
                made = {name: self.on_axes(ask, path[-1]) for name, ask in made.items()}
            return made
        if isinstance(node, list):
            if len(node) == 3 and all(isinstance(item, str) for item in node) and not set(path[-1:]) & NO_VECTORS \
                    and "supports" not in path:
                return self.vector([self.expression(item, axes) for item in node])
            return [self.rewritten(item, axes, path + ("#",)) for item in node]
        return self.expression(node, axes) if self.is_expression(path) else node

    @staticmethod
    def is_fact_map(path):
        path = path[2:] if path[:1] == ("situations",) else path
        return path == ("facts",) or len(path) == 2 and path[0] == "instants"

    @staticmethod
    def is_expression(path):
        return path[0] not in ("title", "source") and (is_named(path) or
                                                      path[-1] not in ("hole", "no_slip", "stays", "ends", "mass_added", "rest"))

    def fact(self, key, value, axes, path):
        quantity = self.expression(key, axes) if re.search(r"\(|\.", key) else key
        if isinstance(value, list) and "any" in value:
            return {f"component({quantity} along {direction})": self.expression(item, axes)
                    for direction, item in zip(self.directions, value) if item != "any"}
        return {quantity: self.rewritten(value, axes, path)}

    def on_axes(self, ask, kind):
        if isinstance(ask, dict):
            if {"largest", "smallest", "first_time", "times", "table"} & set(ask):
                return ask
            return {"axes": list(self.directions), **ask}
        return {"of" if kind == "ask" else "claim": ask, "axes": list(self.directions)}

    def vector(self, items):
        terms = [f"({item})*{direction}" for item, direction in zip(items, self.directions) if item.strip() != "0"]
        return " + ".join(terms) if terms else ["0", "0", "0"]

    def expression(self, text, axes):
        tokens = self.words(tokens_of(text), axes)
        return self.lists(tokens)

    def words(self, tokens, axes):
        """Directions and components by the names of the axes."""
        made = []
        for index, token in enumerate(tokens):
            before = tokens[index - 1].text if index else ""
            if token.kind == "name" and token.text in axes:
                if before == "." and not token.blank:
                    made.pop()
                    start = self.start_of_primary(made)
                    inner = text_of(made[start:])
                    made[start:] = [Token("text", f"component({inner} along {axes[token.text]})", made[start].blank)]
                    continue
                token = Token("name", axes[token.text], token.blank)
            made.append(token)
        return made

    @staticmethod
    def start_of_primary(tokens):
        if not tokens or tokens[-1].text != ")":
            return len(tokens) - 1
        depth, start = 0, len(tokens) - 1
        while start >= 0:
            depth += {")": 1, "(": -1}.get(tokens[start].text, 0)
            if depth == 0:
                break
            start -= 1
        return start - 1 if start and tokens[start - 1].kind == "name" else start

    def lists(self, tokens):
        """The text, with every [a, b, c] in it as a sum along the turned directions."""
        while True:
            close = next((i for i, token in enumerate(tokens) if token.text == "]" and token.kind == "sign"), None)
            if close is None:
                return text_of(tokens)
            start = max(i for i in range(close) if tokens[i].text == "[" and tokens[i].kind == "sign")
            if start > 1 and tokens[start - 1].text == "(" and tokens[start - 2].text in ("min", "max"):
                raise NotApplicable
            items, depth, piece = [], 0, []
            for token in tokens[start + 1:close]:
                depth += {"(": 1, ")": -1}.get(token.text, 0) if token.kind == "sign" else 0
                if token.text == "," and not depth:
                    items.append(text_of(piece))
                    piece = []
                else:
                    piece.append(token)
            items.append(text_of(piece))
            if len(items) != 3:
                raise NotApplicable
            vector = self.vector(items)
            # A vector of nothing but zeros is one along any direction.
            text = f"({vector})" if isinstance(vector, str) else f"(0 m * {self.directions[0]})"
            if not isinstance(vector, str) and len(tokens) > 3:
                raise NotApplicable
            tokens = tokens[:start] + [Token("text", text, tokens[start].blank)] + tokens[close + 1:]


class Shifted(Relation):
    name = "shifted"
    changes = "the whole figure stands elsewhere; places follow, all else but potential energy stays"

    def vary(self, statement, random):
        tree = statement.copy().tree
        if "plane" in tree:
            raise NotApplicable  # which what is shifted out of it leaves
        if "claim" in tree or has_word(tree, "mesh", "potential_energy") and has_word(tree.get("define", {}), "potential_energy"):
            raise NotApplicable
        if any(has_word(tree.get(key, {}), "position", "center", "potential_energy") for key in ("instants", "facts", "define", "where", "loads", "stages")):
            raise NotApplicable
        length = scales_of(statement)[0]
        by = [round(random.uniform(-3, 3) * length, 6) or 1.0 for _ in range(3)]
        points = set()
        for situation in situations_of(tree):
            points |= set(situation.get("points", {}))
        for ask in tree.get("ask", {}).values():
            texts = [ask] if isinstance(ask, str) else [str(part) for part in ask.values()]
            for text in texts:
                self.require_plain(text, points)
        tree = self.moved(tree, points, by, ())

        def expected(name, value, answer):
            text = asked_text(answer).strip()
            if value is None or not re.search(r"(position|center|potential_energy)\(", text):
                return value
            if re.fullmatch(r"(position|center)\([^()]*\)( @ [^()]*)?", text) and isinstance(value, list) and len(value) == 3:
                return [v + b for v, b in zip(value, by)]
            return value if "potential_energy" not in text and re.search(r"(velocity|distance|about)", text) else SKIP

        return Varied(statement.with_tree(tree), expected)

    @staticmethod
    def require_plain(text, points):
        """Only points by their names: a sum of places in a question would have to be shifted as well."""
        if "[" in text or "largest" in text:
            raise NotApplicable
        tokens = tokens_of(text)
        for index, token in enumerate(tokens):
            if token.text in points:
                near = [tokens[i].text for i in (index - 1, index + 1) if 0 <= i < len(tokens)]
                if {"+", "-", "*", "/", "^"} & set(near):
                    raise NotApplicable

    def moved(self, node, points, by, path):
        if isinstance(node, dict):
            made = {key: self.moved(value, points, by, path + (key,)) for key, value in node.items()}
            if path[-2:-1] == ("frames",) and "rides_on" not in made and "origin" not in made:
                made["origin"] = self.place(by)
            if path[-2:-1] == ("joints",) and "at" not in made and {"revolute", "screw", "cylindrical", "universal", "slot"} & set(made):
                if "->" not in str(made) and "supports" not in made:
                    made["at"] = self.place(by)
            return made
        key = path[-1] if path else ""
        is_place = key in PLACES or path[-2:-1] == ("points",) or path[-2:] == ("gravity", "toward") or key == "about" and {"inertia", "inertia_matrix",
                                                                                      "radii_of_gyration"} & set(path)
        if path and path[0] in ("ask", "given", "define", "instants", "facts", "where", "situations") and path[0] != "situations":
            is_place = False
        if isinstance(node, list):
            if is_place and len(node) == 3 and all(isinstance(item, str) for item in node):
                return [moved_component(item, b) for item, b in zip(node, by)]
            if key in LISTS_OF_PLACES or path[-2:-1] and path[-2] in LISTS_OF_PLACES and key == "#":
                return [self.moved_place(item, points, by) for item in node]
            return [self.moved(item, points, by, path + ("#",)) for item in node]
        return self.moved_place(node, points, by) if is_place else node

    def moved_place(self, node, points, by):
        if isinstance(node, list):
            return [moved_component(item, b) for item, b in zip(node, by)]
        share = 1 - self.weight(node, points)
        if abs(share) < 1e-12:
            return node
        return f"{node} + [" + ", ".join(f"{share * b!r} m" for b in by) + "]"

    @staticmethod
    def place(by):
        return [f"{part!r} m" for part in by]

    @staticmethod
    def weight(text, points):
        """How often the origin counts in a place: once in A, not in r*out, half in A/2."""
        values = []
        for scalar in (0.7, 1.3):
            pieces, depth = [], 0
            for token in tokens_of(re.sub(r"(\w+)->(\w+)", r"(\2 - \1)", text)):
                if token.text == "[":
                    depth += 1
                    pieces += ["0.0"] if depth == 1 else []
                elif token.text == "]":
                    depth -= 1
                elif depth:
                    continue
                elif token.kind == "number":
                    pieces.append(repr(float(token.value)))
                elif token.kind == "name":
                    known = hasattr(math, token.text) or token.text in ("abs",)
                    pieces.append("1.0" if token.text in points else token.text if known and token.text not in ("e", "tau") else
                                  "0.0" if token.text in ("x", "y", "z", "X", "Y", "Z") else f"({scalar})")
                else:
                    pieces.append({"^": "**"}.get(token.text, token.text))
            try:
                values.append(eval(" ".join(pieces), {"__builtins__": {}}, {**vars(math), "abs": abs}))
            except Exception as error:  # whatever it is, it is no plain sum of places
                raise NotApplicable from error
        if not all(isinstance(value, float | int) for value in values) or abs(values[0] - values[1]) > 1e-12:
            raise NotApplicable
        return values[0]


def moved_component(text, by):
    """A coordinate of a place, moved; of one that may be anything nothing changes."""
    return text if text == "any" else f"{by!r} m" if text == "0" else f"{text} + {by!r} m"
