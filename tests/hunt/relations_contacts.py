"""Contacts in two ways: a block on its feet, and on a table that carries it as a whole; friction at its ends, and none or no
slip."""
from compare import same, state
from random_statements import number
from relations import Find, NotApplicable, Relation, Varied
from statements import Statement


class Feet(Relation):
    name = "feet"
    changes = "a block on three or four feet is held by one joint: the feet together carry what that joint carries"
    relative = 1e-7

    def make(self, draw):
        feet = draw.choice([3, 4])
        half, depth = (round(draw.uniform(0.2, 0.9), 3) for _ in range(2))
        corners = [(-half, -depth), (half, -depth), (half, depth), (-half, depth)][:feet]
        height = round(draw.uniform(0.1, 0.8), 3)
        points = {"G": ["0", f"{height / 2:.4g} m", "0"], "C": [f"{draw.uniform(-1, 1) * half:.3g} m", "0.2 m",
                                                                         f"{draw.uniform(-1, 1) * depth:.3g} m"]}
        contacts = {}
        for index, (x, z) in enumerate(corners):
            points[f"F{index}"] = [f"{x:.4g} m", "0", f"{z:.4g} m"]
            contacts[f"foot{index}"] = {"of": "block", "at": f"F{index}", "normal": "y"}
        sides = [f"{2 * half:.4g} m * x", f"{height} m * y", f"{2 * depth:.4g} m * z"]
        tree = {"title": "A block on feet", "points": points, "bodies": {"block": {
            "box": {"center": "G", "sides": sides}, "mass": f"{number(draw, 0.5, 9)} kg"}}, "contacts": contacts, "loads": {
                "press": {"force": ["0", f"{number(draw, -60, 20)} N", "0"], "at": "C", "body": "block"}},
            "gravity": "-y", "instants": {"now": "rest"},
            "ask": {"push": " + ".join(f"force({c} on block).y" for c in contacts),
                    "tilt_x": " + ".join(f"couple({c} on block about G).x" for c in contacts),
                    "tilt_z": " + ".join(f"couple({c} on block about G).z" for c in contacts)}}
        return Statement("made/feet", tree)

    def hold(self, program, statement, random):
        tree = statement.copy().tree
        contacts = tree.pop("contacts", {})
        if len(contacts) < 3 or len(tree.get("ask", {})) < 3:
            return None
        tree["joints"] = {"table": {"weld": "G", "to": "block"}}
        tree["ask"] = {"push": "force(table on block).y", "tilt_x": "couple(table on block about G).x",
                       "tilt_z": "couple(table on block about G).z"}
        varied = statement.with_tree(tree)
        first, second = program.solve(statement), program.solve(varied)
        for run in (first, second):
            if run.fault:
                return [Find(self.name, "fault", run.fault, statement, varied)]
            if not run.document:
                return [Find(self.name, "refused", run.message, statement, varied)]
        by_feet, held = (run.document["solutions"][0]["answers"] for run in (first, second))
        if any(state(answer) != "found" for answer in held.values()):
            return [Find(self.name, "weld", str(held), statement, varied)]
        push, tilt_x, tilt_z = (held[name]["si"] for name in ("push", "tilt_x", "tilt_z"))
        carried = self.carried(tree, contacts, push, tilt_x, tilt_z)
        for name, answer in by_feet.items():
            if carried and state(answer) != "found":
                return [Find(self.name, f"{name}: state", f"the feet can carry it, but {name} is {state(answer)}: "
                             f"{answer.get('reason')}", statement, varied)]
            if carried is False and state(answer) == "found":
                return [Find(self.name, f"{name}: pull", f"a foot would have to pull, but {name} is {answer['si']}",
                             statement, varied)]
            if state(answer) == "found" and not same(answer["si"], held[name]["si"], self.relative, 1e-3):
                return [Find(self.name, f"{name}: value", f"{name}: {answer['si']} in place of {held[name]['si']}",
                             statement, varied)]
        return []

    @staticmethod
    def carried(tree, contacts, push, tilt_x, tilt_z):
        """Whether the resultant passes within the feet; None close to an edge."""
        if abs(push) < 1e-6:
            return None
        # The couple about G of a push at (x, z) below it is (-z push, x push).
        x, z = tilt_z / push, -tilt_x / push
        feet = [[float(part.split()[0]) for part in tree["points"][contact["at"]][::2]] for contact in contacts.values()]
        margins = []
        for (ax, az), (bx, bz) in zip(feet, feet[1:] + feet[:1]):
            margins.append((bx - ax) * (z - az) - (bz - az) * (x - ax))
        if any(abs(margin) < 1e-6 for margin in margins):
            return None
        return push > 0 and all(margin > 0 for margin in margins)


class Rough(Relation):
    name = "friction"
    changes = "a contact with friction of zero is smooth, one with a million does not slip"
    settings_too = False

    def make(self, draw):
        radius = round(draw.uniform(0.1, 0.8), 3)
        kind = draw.choice(["ball", "wheel", "crate"])
        shape = {"ball": {"sphere": {"center": "r*out", "radius": "r"}},
                 "wheel": {"disk": {"center": "r*out", "normal": "z", "radius": "r"}},
                 "crate": {"box": {"center": "r*out", "sides": ["r*level", "2*r*out", "r*z"]}}}[kind]
        mass = float(number(draw, 0.5, 9))
        # Too little to lift the body off the slope.
        force = [f"{draw.uniform(-3, 3) * mass:.4g} N", f"{draw.uniform(-3, 1) * mass:.4g} N", "0"]
        tree = {"title": "A body on a slope", "given": {"r": f"{radius} m", "b": f"{draw.uniform(-35, 35):.3g} deg"},
                "directions": {"level": ["cos(b)", "sin(b)", "0"], "out": ["-sin(b)", "cos(b)", "0"]},
                "points": {"C": ["0", "0", "0"], "K": f"r*out + {draw.uniform(-0.5, 0.5):.3g}*r*level"},
                "bodies": {"body": {**shape, "mass": f"{mass} kg"}},
                "contacts": {"slope": {"of": "body", "at": "C", "normal": "out", "friction": draw.choice(["0", "1e6"])}},
                "loads": {"pull": {"force": force, "at": "K", "body": "body"}}, "gravity": "-y"}
        if kind == "crate" or draw.random() < 0.5:
            tree["instants"] = {"now": "rest"}
        else:
            speed = f"({draw.uniform(-3, 3):.3g} m/s)"
            tree["facts"] = {"velocity(body)": f"{speed}*level", "angular_velocity(body)": ["0", "0", f"-{speed}/r"]}
        tree["ask"] = {"a": "acceleration(body)", "turns": "angular_acceleration(body).z",
                       "push": "component(force(slope on body) along out)",
                       "rubs": "component(force(slope on body) along level)"}
        return Statement("made/rough", tree)

    def vary(self, statement, random):
        tree = statement.copy().tree
        contact = tree.get("contacts", {}).get("slope", {})
        friction = contact.pop("friction", None)
        if friction not in ("0", "1e6"):
            raise NotApplicable
        if friction == "1e6":
            contact["no_slip"] = "true"
        return Varied(statement.with_tree(tree), relative=1e-7)


class Capstan(Relation):
    name = "capstan"
    changes = "a cord with friction of zero slides freely over its wheel, one with a thousand does not slip on it"
    settings_too = False

    def make(self, draw):
        radius = round(draw.uniform(0.05, 0.4), 3)
        masses = [number(draw, 0.5, 9) for _ in range(3)]
        fixed = draw.random() < 0.3
        wheel = {"radius": "r", "friction": draw.choice(["0", "1e3"])}
        tree = {"title": "Two blocks on a cord", "given": {"r": f"{radius} m"},
                "points": {"O": ["0", "0", "0"], "A": ["-r", f"-{draw.uniform(0.5, 3):.3g} m", "0"],
                           "B": ["r", f"-{draw.uniform(0.5, 3):.3g} m", "0"]},
                "bodies": {"a": {"particle": "A", "mass": f"{masses[0]} kg"}, "b": {"particle": "B", "mass": f"{masses[1]} kg"}},
                "cords": {"rope": {"from": "a", "at": "A", "over": [{"O" if fixed else "w": wheel}], "to": "b", "end": "B"}},
                "gravity": "-y", "instants": {"now": "rest"},
                "ask": {"a": "acceleration(a).y", "T": "tension(rope on a)", "S": "tension(rope on b)",
                        "y": f"center(b).y @ {draw.uniform(0.1, 0.4):.3g} s"}}
        if not fixed:
            tree["bodies"]["w"] = {"disk": {"center": "O", "normal": "z", "radius": "r"}, "mass": f"{masses[2]} kg"}
            tree["joints"] = {"axle": {"revolute": draw.choice(["z", "-z"]), "at": "O", "to": "w"}}
            tree["ask"]["turns"] = "angular_acceleration(w).z"
        return Statement("made/capstan", tree)

    def vary(self, statement, random):
        tree = statement.copy().tree
        over = tree.get("cords", {}).get("rope", {}).get("over", [])
        wheel = next(iter(over[0].values())) if over and isinstance(over[0], dict) else {}
        friction = wheel.pop("friction", None)
        if friction not in ("0", "1e3"):
            raise NotApplicable
        if friction == "0":
            wheel["smooth"] = "true"
        elif "O" in over[0]:
            raise NotApplicable  # A post that holds its cord has no other form.
        return Varied(statement.with_tree(tree), relative=1e-7)


class CordEnds(Relation):
    name = "cord_ends"
    changes = "the two ends of a cord that is slack at the start are exchanged; answers stay"
    settings_too = False

    def make(self, draw):
        places = [[round(draw.uniform(-1, 1), 3) for _ in range(3)] for _ in range(2)]
        apart = sum((a - b) ** 2 for a, b in zip(*places)) ** 0.5
        mass = [number(draw, 0.5, 9) for _ in range(2)]
        tree = {"title": "Two particles on a slack cord",
                "points": {name: [f"{x} m" for x in place] for name, place in zip("AB", places)},
                "bodies": {"a": {"particle": "A", "mass": f"{mass[0]} kg"}, "b": {"particle": "B", "mass": f"{mass[1]} kg"}},
                "cords": {"rope": {"from": "a", "at": "A", "to": "b", "end": "B",
                                   "length": f"{(apart + 0.05) * draw.uniform(1, 1.4):.4g} m"}},
                "gravity": draw.choice(["none", "-y"]),
                "instants": {"start": {f"velocity({body})": [f"{draw.uniform(-3, 3):.3g} m/s" for _ in range(3)]
                                       for body in "ab"}},
                "ask": {"first": "tension(rope)", "a": "center(a) @ 0.7 s", "v": "velocity(b) @ 1.3 s",
                        "T": "tension(rope) @ 1.9 s"}}
        return Statement("made/cord_ends", tree)

    def vary(self, statement, random):
        tree = statement.copy().tree
        cord = tree.get("cords", {}).get("rope", {})
        if not {"from", "at", "to", "end", "length"} <= cord.keys():
            raise NotApplicable
        cord["from"], cord["to"] = cord["to"], cord["from"]
        cord["at"], cord["end"] = cord["end"], cord["at"]
        return Varied(statement.with_tree(tree), relative=1e-6)


class Bearings(Relation):
    name = "bearings"
    changes = "a journal of no radius is smooth, and one of length L is one in two supports at its ends"
    settings_too = False

    def make(self, draw):
        half = round(draw.uniform(0.1, 0.6), 3)
        center = [f"{draw.uniform(-0.4, 0.4):.3g} m" for _ in range(3)]
        rate = f"{draw.choice([-1, 1]) * draw.uniform(0.5, 9):.3g} rad/s"
        friction = {"coefficient": f"{draw.uniform(0.02, 0.4):.3g}", "radius": draw.choice(["0 m", "15 mm"])}
        if friction["radius"] != "0 m":
            friction["length"] = "2*h"
        tree = {"title": "A body on a shaft", "given": {"h": f"{half} m"},
                "points": {"O": ["0", "0", "0"], "A": ["0", "0", "-h"], "B": ["0", "0", "h"], "G": center},
                "bodies": {"body": {"mass": f"{number(draw, 0.5, 9)} kg", "center": "G",
                                    "inertia": {"axis": "z", "axial": "0.4 kg*m^2", "transverse": "0.3 kg*m^2"}}},
                "joints": {"shaft": {"revolute": "z", "at": "O", "to": "body", "angle": "q", "rate": rate,
                                     "friction": friction}},
                "gravity": "-y",
                "ask": {"a": "angular_acceleration(body)", "M": "friction(shaft on body).z",
                        "q": "q @ 50 ms"}}
        if friction["radius"] == "0 m":
            del tree["ask"]["M"]
        return Statement("made/bearings", tree)

    def vary(self, statement, random):
        tree = statement.copy().tree
        joint = tree.get("joints", {}).get("shaft", {})
        friction = joint.get("friction")
        if not isinstance(friction, dict) or tree.get("title") != "A body on a shaft":
            raise NotApplicable
        if "length" in friction:
            del friction["length"]
            joint["supports"] = {"A": ["x", "y", "z"], "B": ["x", "y"]}
        else:
            del joint["friction"]
        return Varied(statement.with_tree(tree), relative=1e-7)
