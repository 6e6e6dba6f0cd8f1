"""The figure seen in a mirror: every place on the other side of the origin.

Places, velocities and forces change their sign (they are polar vectors); angular velocities, angular momenta and couples
keep it (axial vectors); so do moments and products of inertia and all that is a number. Of a coordinate of turning about
an axis nothing changes; one of sliding counts the other way along an axis that is left as it was.
"""
import re

from compare import times
from random_statements import made_statement
from relations import NotApplicable, Relation, Varied
from relations_matter import asked_text

POLAR = ("acceleration", "velocity", "momentum", "reaction", "force", "tangential_force", "radial_force", "axial_force", "impulse", "center", "position")


def negative(text):
    text = text.strip()
    return text if text == "0" else text[1:].lstrip() if text.startswith("-") else f"-{text}"


def negated(node):
    return [negated(item) for item in node] if isinstance(node, list) else negative(node)


def reversed_fact(node):
    if isinstance(node, list):
        return [reversed_fact(item) for item in node]
    return node if node in ("0", "any") else f"-({node})"


class Mirrored(Relation):
    name = "mirrored"
    changes = "every place is mirrored at the origin; polar vectors change their sign, axial ones do not"

    def make(self, draw):
        return made_statement(draw, draw.choice(["instant", "instant", "motion", "blow"]))

    def vary(self, statement, random):
        tree = statement.copy().tree
        if "plane" in tree:
            raise NotApplicable
        tree["points"] = {name: negated(place) for name, place in tree.get("points", {}).items()}
        tree["bodies"] = {name: self.body(body) for name, body in tree.get("bodies", {}).items()}
        reversed_coordinates = set()
        for name, joint in tree.get("joints", {}).items():
            if "prismatic" in joint:
                tree["joints"][name] = {**joint, "prismatic": negated(joint["prismatic"])}
            elif "cylindrical" in joint:
                slide = joint.get("freedoms", {}).get("slide", {})
                if "displacement" in slide:
                    reversed_coordinates.add(slide["displacement"])
                if "force" in slide:
                    slide["force"] = negative(slide["force"])
            elif not {"revolute", "universal"} & set(joint):
                raise NotApplicable
        if isinstance(tree.get("gravity"), dict) and isinstance(tree["gravity"]["toward"], list):
            tree["gravity"]["toward"] = negated(tree["gravity"]["toward"])
        if isinstance(tree.get("gravity"), str) and tree["gravity"] != "none":
            tree["gravity"] = negative(tree["gravity"])
        for load in tree.get("loads", {}).values():
            if "force" in load:
                load["force"] = negated(load["force"])
        if "excitations" in tree:
            raise NotApplicable
        for impulse in tree.get("impulses", {}).values():
            if "value" in impulse:
                impulse["value"] = negated(impulse["value"])
        for facts in tree.get("instants", {}).values():
            if isinstance(facts, dict):
                for key in facts:
                    if key.rstrip("'") in reversed_coordinates:
                        facts[key] = negative(facts[key])
                    elif re.match(r"(" + "|".join(POLAR) + r")\(", key):
                        facts[key] = reversed_fact(facts[key])

        def expected(name, value, answer):
            text = asked_text(answer)
            polar = re.match(r"(" + "|".join(POLAR) + r")\(", text) is not None
            other = re.match(r"(q\d+[ab]?)'*(?= @|$)", text)
            if value is None or not polar and not (other and other[1] in reversed_coordinates):
                return value
            return times(value, -1)

        return Varied(statement.with_tree(tree), expected)

    @staticmethod
    def body(body):
        """Shapes are mirrored in themselves, but for those drawn to a second point."""
        def other_side(text):
            match = re.fullmatch(r"(\w+) \+ (\[[^\]]*\])", text)
            return f"{match[1]} - {match[2]}" if match else text

        made = dict(body)
        if "rod" in made:
            made["rod"] = [other_side(end) for end in made["rod"]]
        if "cone" in made:
            made["cone"] = {**made["cone"], "base": other_side(made["cone"]["base"])}
        return made
