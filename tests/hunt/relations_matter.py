"""Relations of matter: a body split in two, a massless one with very little mass, a joint doubled by constraints."""
import re

from relations import NotApplicable, Relation, SKIP, Varied, scales_of
from statements import has_word

# What is asked of a body itself and not of the body that is welded to it.
OF_MATTER = ("mass", "weight", "momentum", "angular_momentum", "kinetic_energy", "potential_energy", "moment_of_inertia",
             "radius_of_gyration", "moments_of_inertia", "products_of_inertia", "inertia_matrix", "principal_moments",
             "principal_axes", "symmetry_axis", "body_cone", "space_cone", "invariable_plane", "poinsot_ellipsoid",
             "polhode", "axis_stability", "precession_axis", "precession_rate", "precession_sense", "spin_rate")
FORCES = ("reaction", "reaction_couple", "force", "couple", "impulse", "impulsive_couple", "tension", "tangential_force", "radial_force",
          "axial_force")
STABILITY = ("stable", "stability", "growth_rate", "frequencies", "eigenvalues", "modes")
AMOUNTS = ("mass", "weight", "density", "specific_weight")


def asked_text(answer):
    return str(answer.get("ask", ""))


def calls(text, functions):
    return re.search(r"(?<![A-Za-z_0-9])(" + "|".join(functions) + r")\(", text) is not None


class Split(Relation):
    name = "split"
    changes = "a body is two halves of half the mass each, welded together; all but what is asked of its matter stays"

    def vary(self, statement, random):
        tree = statement.copy().tree
        # Two halves of a particle can turn, as the particle cannot: where only its velocity is stated, a motion of theirs
        # would not be fixed.
        moves = "@" in statement.text() and has_word(tree.get("instants", {}), "velocity")
        bodies = {name: body for name, body in tree.get("bodies", {}).items()
                  if self.can_split(tree, name, body) and not (moves and "particle" in body)}
        if not bodies or any("bodies" in s for s in tree.get("situations", {}).values() if isinstance(s, dict)):
            raise NotApplicable
        name = random.choice(sorted(bodies))
        if any(has_word(tree.get(key, {}), *OF_MATTER) for key in ("define", "instants", "facts", "claim", "where", "assume")):
            raise NotApplicable
        half = self.halved(bodies[name])
        tree["bodies"] = {**tree["bodies"], name: half, "other_half": half}
        tree["joints"] = {**tree.get("joints", {}), "seam": {"weld": ["0", "0", "0"], "from": name, "to": "other_half"}}

        def expected(ask, value, answer):
            text = asked_text(answer)
            return SKIP if calls(text, OF_MATTER) and "system" not in text else value

        return Varied(statement.with_tree(tree), expected)

    @staticmethod
    def can_split(tree, name, body):
        if not isinstance(body, dict) or "parts" in body or "added" in body or has_word(body, "any"):
            return False
        if name in tree.get("steady", {}).get("spins", {}) or "choose" in tree:
            return False
        return any(amount in body for amount in AMOUNTS)

    @staticmethod
    def halved(body):
        half = dict(body)
        for amount in AMOUNTS:
            if amount in half:
                half[amount] = f"({half[amount]})/2"
        if "inertia" in half:
            half["inertia"] = {key: value if key in ("about", "axes", "axis", "rest") or value == "0" else f"({value})/2"
                               for key, value in half["inertia"].items()}
        if "inertia_matrix" in half:
            rows = half["inertia_matrix"].get("rows")
            if not isinstance(rows, list) or not all(isinstance(row, list) for row in rows):
                raise NotApplicable
            half["inertia_matrix"] = {**half["inertia_matrix"], "rows": [
                [item if item == "0" else f"({item})/2" for item in row] for row in rows]}
        return half


class Massless(Relation):
    name = "massless"
    changes = "a massless body gets a billionth of the mass; answers change as little"
    # A billionth of the mass, as far out as the figure is wide, beside bodies that are smaller than the figure.
    relative = 1e-5

    def vary(self, statement, random):
        tree = statement.copy().tree
        names = [name for name, body in tree.get("bodies", {}).items() if body == "massless"]
        # A motion with such a body takes steps as short as its own oscillations.
        if not names or has_word(tree, "max", "min", "period", "first_time", "times", "record", "stages", "over") or \
                re.search(r"@ [\d.]", statement.text()) or any("bodies" in s for s in tree.get("situations", {}).values() if isinstance(s, dict)):
            raise NotApplicable
        length, mass, _ = scales_of(statement)
        for name in names:
            size = f"{length * 0.1:.6e} m"
            at = next((joint["at"] for joint in tree.get("joints", {}).values()
                       if isinstance(joint, dict) and name in (joint.get("to"), joint.get("from")) and "at" in joint), None)
            if at is None:
                raise NotApplicable
            tree["bodies"][name] = {"mass": f"{mass * 1e-9:.6e} kg", "center": at,
                                    "radii_of_gyration": {axis: size for axis in tree.get("axes", ["x", "y", "z"])}}

        def expected(ask, value, answer):
            text = asked_text(answer)
            return SKIP if calls(text, STABILITY) or any(re.search(rf"\b{name}\b", text) for name in names) else value

        # What nothing felt before, the turning of the body by itself, may have to be stated now.
        return Varied(statement.with_tree(tree), expected, states=False, relative=self.relative)


class Doubled(Relation):
    name = "doubled"
    changes = "a joint has another like it, which becomes constraints; motions stay, forces may be shared"

    def vary(self, statement, random):
        tree = statement.copy().tree
        joints = {name: joint for name, joint in tree.get("joints", {}).items() if isinstance(joint, dict)}
        kinds = ("weld", "revolute", "prismatic", "ball")
        able = [name for name, joint in joints.items() if any(kind in joint for kind in kinds) and "to" in joint
                and not ({"about", "supports"} & set(joint) and "at" not in joint)]
        if not able or any("joints" in s for s in tree.get("situations", {}).values() if isinstance(s, dict)):
            raise NotApplicable
        # What is stated of forces that are shared now fixes less.
        if any(has_word(tree.get(key, {}), *FORCES) for key in ("instants", "facts", "define", "where", "claim", "situations")):
            raise NotApplicable
        # The loop that two joints close need not have the formulas by which derivatives by letters are told.
        if has_word(tree.get("claim", {}), "derivative"):
            raise NotApplicable
        name = random.choice(sorted(able))
        joint = joints[name]
        twin = {key: joint[key] for key in (*kinds, "at", "from", "to") if key in joint}
        if "revolute" in twin and "at" not in twin and "->" not in str(twin["revolute"]):
            raise NotApplicable
        tree["joints"] = {**tree["joints"], "like_it": twin}

        def expected(ask, value, answer):
            text = asked_text(answer)
            return SKIP if calls(text, FORCES + STABILITY) else value

        # What rubs by its load has to know its share: what is told all the same must be what it was.
        knows = not any(isinstance(one.get("friction"), dict) for one in joints.values())
        return Varied(statement.with_tree(tree), expected, states=knows, refusals=knows)
