"""Planar problems: the same figure drawn in another plane."""
import functools
import pathlib

from language import Token, text_of, tokens_of
from relations import NotApplicable, Relation, Varied
from relations_space import Turned
from relations_writing import given_names
from statements import examples, has_word, jiggled, role, situations_of

# Lists of three names or numbers that are no vectors.
NO_VECTORS = {"axes", "of", "while", "where", "loads", "supports", "carries", "choose", "over", "assume", "claim", "neglect"}


@functools.cache
def planar_examples():
    return [one for one in examples(pathlib.Path(__file__).resolve().parents[2]) if one.tree.get("plane") == ["x", "y"]]


class Planar(Relation):
    """Of planar problems, which are few among all."""

    def make(self, draw):
        example = draw.choice(planar_examples())
        return jiggled(example, draw) if draw.random() < 0.4 else example


class OtherPlane(Planar):
    name = "plane"
    changes = "what is stated in the plane of x and y is stated in that of x and z, of which the normal is -y; answers stay"

    def vary(self, statement, random):
        tree = statement.copy().tree
        if tree.get("plane") != ["x", "y"] or "axes" in tree or {"x", "y", "z"} & given_names(tree) or \
                has_word(tree, "supports", "view", "axes", "mesh", "record"):
            raise NotApplicable
        varied = self.rewritten(tree, ())
        varied["plane"] = ["x", "z"]
        return Varied(statement.with_tree(varied))

    def rewritten(self, node, path):
        if isinstance(node, dict):
            return {self.key(key, path + (key, None)): self.rewritten(value, path + (key,)) for key, value in node.items()}
        if isinstance(node, list):
            if len(node) == 3 and all(isinstance(item, str) for item in node) and not set(path) & NO_VECTORS:
                items = [self.expression(item) for item in node]
                return [items[0], self.across(items[2]), items[1]]
            return [self.rewritten(item, path) for item in node]
        return self.expression(node) if role(path) == "expression" and path[-1] != "plane" else node

    @staticmethod
    def across(item):
        if item.strip() not in ("0", "any"):
            raise NotApplicable
        return item

    def key(self, key, path):
        if key in ("z", "xy", "yz", "zx", "xz"):
            return {"z": "y", "xy": "xz"}.get(key) or self.none()
        if path[0] in ("facts", "instants", "situations") and any(sign in key for sign in "(."):
            if ".z" in key:
                raise NotApplicable
            return self.expression(key)
        return key

    @staticmethod
    def none():
        raise NotApplicable

    def expression(self, text):
        if text in ("z", "-z"):
            return {"z": "-y", "-z": "y"}[text]
        made = []
        tokens = tokens_of(text)
        for index, token in enumerate(tokens):
            component = token.kind == "name" and index and tokens[index - 1].text == "." and not token.blank
            if token.kind == "name" and token.text == "z" and component:
                made.pop()
                start = Turned.start_of_primary(made)
                made[start:] = [Token("text", f"(-{text_of(made[start:])}.y)", made[start].blank)]
            elif token.kind == "name" and token.text in ("y", "z"):
                made.append(Token("text", "z" if token.text == "y" else "(-y)", token.blank))
            else:
                made.append(token)
        return self.lists(made)

    def lists(self, tokens):
        """The text, with every [a, b, 0] in it as [a, 0, b]."""
        while True:
            close = next((i for i, token in enumerate(tokens) if token.text == "]" and token.kind == "sign"), None)
            if close is None:
                return text_of(tokens)
            start = max(i for i in range(close) if tokens[i].text == "[" and tokens[i].kind == "sign")
            items, depth = [[]], 0
            for token in tokens[start + 1:close]:
                depth += {"(": 1, ")": -1}.get(token.text, 0) if token.kind == "sign" else 0
                if token.text == "," and not depth:
                    items.append([])
                else:
                    items[-1].append(token)
            items = [text_of(item) for item in items]
            if len(items) == 3:
                items = [items[0], self.across(items[2]), items[1]]
            text = Token("text", "[" + ", ".join(items) + "]", tokens[start].blank)
            tokens = tokens[:start] + [text] + tokens[close + 1:]


# Numbers about the normal in a planar problem.
ABOUT_NORMAL = {"angular_velocity", "angular_acceleration", "angular_momentum", "couple", "reaction_couple", "impulsive_couple"}


class InSpace(Planar):
    name = "space"
    others = ("inertia", "gyration", "drive", "load", "friction", "rate", "cross", "axis", "times")
    changes = "a planar problem is stated in space, where its bodies keep in their plane; numbers about the normal are components"

    def vary(self, statement, random):
        tree = statement.copy().tree
        if tree.pop("plane", None) != ["x", "y"] or "axes" in tree or not tree.get("points") or \
                has_word(tree, "mesh", "record", "table", "radii_of_gyration", "stable", "frequencies", "modes") or \
                any(f"{function}(" in str(tree) for function in self.others):
            raise NotApplicable
        tree = self.rewritten(tree, ())
        held = {joint.get("to") for joint in tree.get("joints", {}).values()}
        for situation in situations_of(tree):
            for body in situation.get("bodies", {}).values():
                inertia = body.get("inertia") if isinstance(body, dict) else None
                if isinstance(inertia, dict) and set(inertia) == {"z"}:
                    body["inertia"] = {axis: inertia["z"] for axis in "xyz"}
            for kind in ("loads", "impulses", "excitations"):
                for load in situation.get(kind, {}).values():
                    if "couple" in load and not isinstance(load["couple"], list) and not {"about", "along"} & set(load):
                        load["about"] = "z"
        place = next(iter(tree["points"]))
        joints = {f"in_plane_{name}": {"planar": "z", "at": place, "to": name} for name, body in tree.get("bodies", {}).items()
                  if name not in held and "particle" not in body}
        tree["joints"] = {**tree.get("joints", {}), **joints}

        def expected(name, value, answer):
            vector = isinstance(statement.tree["ask"].get(name), str) and isinstance(value, list) and len(value) == 2
            return [*value, 0.0] if vector else value

        # Not every list is seen to be a vector, and in space supports share more.
        return Varied(statement.with_tree(tree), expected, states=False, refusals=False)

    def rewritten(self, node, path):
        if isinstance(node, dict):
            made = {}
            for key, value in node.items():
                fact = path[:1] in (("facts",), ("instants",)) and "(" in key
                made[self.expression(key) if fact else key] = self.rewritten(value, path + (key,))
            return made
        if isinstance(node, list):
            vectors = path[0] in ("points", "directions", "facts", "instants", "loads", "impulses", "strikes", "gravity") or \
                "sides" in path and path[-1] != "sides"
            items = [self.rewritten(item, path + ("#",)) for item in node]
            return [*items, "0"] if vectors and len(items) == 2 and all(isinstance(item, str) for item in items) else items
        return self.expression(node) if role(path) == "expression" else node

    @staticmethod
    def expression(text):
        """The text, with every [a, b] in it as [a, b, 0], and numbers about the normal as components along z."""
        made, opened = [], []
        tokens = tokens_of(text)
        for index, token in enumerate(tokens):
            before = tokens[index - 1] if index else None
            if token.text in ("(", "[") and token.kind == "sign":
                about = token.text == "(" and before is not None and before.kind == "name" and before.text in ABOUT_NORMAL
                opened.append([token.text, about, 0])
            elif token.text == "," and opened:
                opened[-1][2] += 1
            elif token.text in (")", "]") and token.kind == "sign" and opened:
                sign, about, commas = opened.pop()
                if sign == "[" and commas == 1:
                    made.append(Token("text", ", 0"))
                after = tokens[index + 1] if index + 1 < len(tokens) else None
                if about and not (after is not None and after.text == "."):
                    made.append(Token("text", ").z"))
                    continue
            made.append(token)
        return text_of(made)
