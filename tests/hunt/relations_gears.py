"""Gears: the same teeth, said in another way."""
from random_statements import number
from relations import NotApplicable, Relation, Varied
from statements import Statement, situations_of


class Teeth(Relation):
    name = "teeth"
    changes = "gears are stated from the other wheel, and pressure angles across the teeth; answers stay"

    def make(self, draw):
        """Three wheels one after another, the last outside or inside the second, of straight or slanted teeth."""
        a, b, c = (number(draw, 0.05, 0.9) for _ in range(3))
        inside = draw.random() < 0.3
        reach = f"{a} m + 2*{b} m"
        last = f"{reach} - {c} m" if inside else f"{reach} + {c} m"
        points = {"O": ["0", "0", "0"], "P": [f"{a} m", "0", "0"], "Q": [f"{a} m + {b} m", "0", "0"],
                  "R": [reach, "0", "0"], "S": [last, "0", "0"]}
        bodies = {name: {"mass": "2 kg", "center": center, "inertia": {
            "axis": "z", "axial": f"{number(draw, 0.01, 0.9)} kg*m^2", "transverse": "1 kg*m^2"}}
            for name, center in (("one", "O"), ("two", "Q"), ("three", "S"))}
        joints = {f"j{name}": {"revolute": draw.choice(["z", "-z"]), "at": body["center"], "to": name}
                  for name, body in bodies.items()}
        joints["jone"]["couple"] = f"{number(draw, -9, 9)} N*m"
        helix = {"helix_angle": f"{draw.randint(5, 40)} deg", "hand": draw.choice(["right", "left", "both"])}
        gears = {"m": {"of": "one", "against": "two", "at": "P", "pressure_angle": f"{draw.randint(1, 35)} deg",
                       **(helix if draw.random() < 0.5 else {})},
                 "n": {"of": "two", "against": "three", "at": "R", "pressure_angle": f"{draw.randint(1, 35)} deg"}}
        return Statement("made/gears", {
            "title": "Wheels", "points": points, "bodies": bodies, "joints": joints, "gears": gears,
            "gravity": draw.choice(["-y", "none"]), "instants": {"now": "rest"},
            "ask": {"w": "angular_acceleration(three).z", "f": "force(m on one)", "r": "radial_force(n on two)",
                    "shaft": "force(jtwo on two)", "couple": "couple(jtwo on two about Q)"}})

    def vary(self, statement, random):
        tree = statement.copy().tree
        changed = False
        for situation in situations_of(tree):
            for gear in situation.get("gears", {}).values():
                if not isinstance(gear, dict):
                    continue
                helix = gear.get("helix_angle")
                if "pressure_angle" in gear:
                    phi = gear.pop("pressure_angle")
                    gear["normal_pressure_angle"] = f"atan(tan({phi})*cos({helix or 0}))"
                    changed = True
                if "lead" not in gear and helix is None and {"of", "against"} <= set(gear) and gear["against"] != "ground":
                    gear["of"], gear["against"] = gear["against"], gear["of"]
                    changed = True
        if not changed:
            raise NotApplicable
        return Varied(statement.with_tree(tree))
