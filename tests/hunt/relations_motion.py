"""Relations of motion: begun again halfway, seen from a moving frame, small pushes that grow as stability says."""
import math
import re

from compare import same, state
from random_statements import made_statement
from relations import Find, NotApplicable, Relation, SKIP, Varied, scales_of, si_value
from relations_matter import STABILITY, asked_text, calls
from statements import has_word

ABSOLUTE = ("velocity", "momentum", "angular_momentum", "kinetic_energy", "potential_energy", "position", "center",
            "distance", "rate")


class Halfway(Relation):
    name = "halfway"
    changes = "a motion begins with the state that it has reached halfway; what is asked later stays"
    settings_too = False
    # Two motions, each followed to 1e-10 or so, of which the second begins with 16 digits of the first.
    relative = 1e-6

    def hold(self, program, statement, random):
        tree = statement.copy().tree
        start = tree.get("instants", {}).get("start")
        if set(tree.get("instants", {})) != {"start"} or not isinstance(start, dict) or not self.complete(tree, start):
            return None
        times = {}
        for name, ask in tree.get("ask", {}).items():
            match = re.fullmatch(r"([^@]*[^@ ]) @ (\S+ (?:s|ms))", ask) if isinstance(ask, str) else None
            if match:
                times[name] = (match[1], si_value(match[2]))
        if not times or len(times) != len(tree["ask"]):
            return None
        half = random.uniform(0.2, 0.8) * min(time for _, time in times.values())
        coordinates = [name for name in start if not name.endswith("'")]
        reached = statement.with_tree({**tree, "ask": {f"at{i}": f"{name} @ {half!r} s" for i, name in enumerate(
            [c + p for c in coordinates for p in ("", "'")])}})
        first, middle = program.solve(statement, keep=True), program.solve(reached)
        for run, one in ((first, statement), (middle, reached)):
            if run.fault:
                return [Find(self.name, "fault", run.fault, one)]
            if not run.document or len(run.document["solutions"]) != 1:
                return None
        found = list(middle.document["solutions"][0]["answers"].values())
        if any(state(answer) != "found" for answer in found):
            return None
        names = [c + p for c in coordinates for p in ("", "'")]
        again = {name: f"{answer['value']!r} {answer['unit']}".strip() for name, answer in zip(names, found)}
        varied = statement.with_tree({**tree, "instants": {"start": again}, "ask": {
            name: f"{ask} @ {time - half!r} s" for name, (ask, time) in times.items()}})
        second = program.solve(varied)
        if second.fault or not second.document:
            return [Find(self.name, "fault", second.fault or second.message, statement, varied)]
        answers = second.document["solutions"][0]["answers"]
        error = max(s["checks"].get("motion_error") or 0 for s in (first.document["solutions"][0], second.document["solutions"][0]))
        length, mass, time = scales_of(statement)
        for name, answer in first.document["solutions"][0]["answers"].items():
            if state(answer) != "found":
                continue
            if state(answers[name]) != "found":
                return [Find(self.name, f"{name}: state", f"{name}: {answers[name].get('reason')}", statement, varied)]
            if not same(answer["si"], answers[name]["si"], max(self.relative, 1e3 * error), 1e-6):
                return [Find(self.name, f"{name}: value", f"{name}: {answers[name]['si']} in place of {answer['si']}",
                             statement, varied)]
        return []

    @staticmethod
    def complete(tree, start):
        """Whether the start says position and rate of every freedom, and nothing depends on time by itself."""
        if any(key in tree for key in ("stages", "contacts", "cords", "impulses", "impacts", "strikes", "find", "letters",
                                       "situations", "frames", "steady", "claim")) or has_word(tree, "time"):
            return False
        held = set()
        for joint in tree.get("joints", {}).values():
            if not any(kind in joint for kind in ("revolute", "prismatic", "cylindrical", "universal", "weld")):
                return False
            held.add(joint.get("to"))
            freedoms = joint.get("freedoms", {"": joint})
            if "weld" in joint:
                continue
            for freedom in freedoms.values():
                name = freedom.get("angle", freedom.get("displacement"))
                if name not in start or name + "'" not in start or "rate" in freedom:
                    return False
        return held >= set(tree.get("bodies", {})) and all(key.rstrip("'") + "'" in start for key in start)


class MovingFrame(Relation):
    name = "frame"
    changes = "all joints on the ground stand in a frame that moves steadily, or accelerates as gravity says; forces stay"

    def vary(self, statement, random):
        tree = statement.copy().tree
        others = ("frames", "contacts", "cords", "springs", "impacts", "strikes", "steady", "situations", "stages")
        if "plane" in tree or any(key in tree for key in others) or not tree.get("joints"):
            raise NotApplicable
        # What rests does so on the ground, and stability is asked of that.
        if has_word(tree.get("instants", {}), "rest") or has_word(tree.get("ask", {}), *STABILITY):
            raise NotApplicable
        if any(has_word(tree.get(key, {}), *ABSOLUTE) for key in ("instants", "facts", "define", "claim", "where")):
            raise NotApplicable
        held = {joint.get("to") for joint in tree["joints"].values()}
        if not held >= set(tree["bodies"]):
            raise NotApplicable
        # A ring that is fixed would have to move along.
        if any(gear.get("against", "ground") == "ground" for gear in tree.get("gears", {}).values()):
            raise NotApplicable
        velocity = [f"{random.uniform(-9, 9):.3g} m/s" for _ in range(3)]
        acceleration = ["0", "0", "0"]
        sign = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}
        gravity = tree.get("gravity")
        if isinstance(gravity, dict):
            raise NotApplicable  # the center rests
        plain = isinstance(gravity, str) and gravity.lstrip("-") in sign and "axes" not in tree
        if plain and random.random() < 0.6 and not has_word(tree, "g", "weight", "specific_weight", "potential_energy"):
            # Gravity less the acceleration of the frame is what the bodies feel.
            pull = [9.80665 * (-1 if gravity[0] == "-" else 1) * part for part in sign[gravity.lstrip("-")]]
            extra = [round(random.uniform(-20, 20), 2) for _ in range(3)]
            acceleration = [f"{part} m/s^2" for part in extra]
            tree["gravity"] = [f"{p + e!r} m/s^2" for p, e in zip(pull, extra)]
        tree["frames"] = {"carrier": {"velocity": velocity, "acceleration": acceleration}}
        for name, joint in tree["joints"].items():
            if joint.get("from", "ground") == "ground":
                tree["joints"][name] = {**joint, "from": "carrier"}
        moving = acceleration[0] != "0"

        def expected(ask, value, answer):
            text = asked_text(answer)
            # Accelerations of points are those of the ground's frame, in which the carrier's is added.
            return SKIP if calls(text, ABSOLUTE) or moving and calls(text, ("acceleration",)) else value

        return Varied(statement.with_tree(tree), expected)


class Growth(Relation):
    name = "growth"
    changes = "an equilibrium gets a small push, which must grow, or stay small, as its stability says"
    settings_too = False
    push = 1e-9

    def make(self, draw):
        return made_statement(draw, "equilibrium")

    def hold(self, program, statement, random):
        first = program.solve(statement, keep=True)
        if first.fault:
            return [Find(self.name, "fault", first.fault, statement)]
        if not first.document or len(first.document["solutions"]) != 1:
            return None
        answers = first.document["solutions"][0]["answers"]
        if any(name not in answers or state(answers[name]) not in ("found", "claim") for name in ("stable", "grows", "swings")):
            return None
        stable, rate, swings = answers["stable"]["si"], answers["grows"]["si"], answers["swings"]["si"]
        names = [joint["angle"] for joint in statement.tree.get("joints", {}).values() if "angle" in joint]
        if not names or not rate and not swings:
            return None
        tree = statement.copy().tree
        # After fourteen times the time in which it grows e-fold a push of 1e-9 is a thousandth, and still linear.
        later = [14 / rate, 15 / rate] if rate else [40 / max(swings), 200 / max(swings)]
        tree["instants"] = {"start": {}}
        for name in names:
            tree["instants"]["start"][name] = f"{random.uniform(0.3, 1) * random.choice([-1, 1]) * self.push!r} rad"
            tree["instants"]["start"][name + "'"] = "0"
        tree["ask"] = {f"{name}_{k}": f"{name} @ {time!r} s" for name in names for k, time in enumerate(later)}
        varied = statement.with_tree(tree)
        second = program.solve(varied)
        if second.fault:
            return [Find(self.name, "fault", second.fault, statement, varied)]
        if not second.document:
            return [Find(self.name, "refused", second.message, statement, varied)]
        values = second.document["solutions"][0]["answers"]
        if any(state(answer) != "found" for answer in values.values()):
            return None
        sizes = [math.sqrt(sum(values[f"{name}_{k}"]["si"]**2 for name in names)) for k in (0, 1)]
        if stable:
            # Modes of springs that are nearly soft may swing wide, but not a thousand times as wide.
            wrong = max(sizes) > 1e3 * self.push * (max(swings) / min(swings) if swings and min(swings) > 0 else 1)
            words = f"stable, but a push of {self.push} becomes {max(sizes)}"
        else:
            # Slower growth beside it leaves less than this of the ratio e.
            grown = math.log(sizes[1] / sizes[0]) if sizes[0] > 0 < sizes[1] else 0
            wrong = sizes[0] < 1e2 * self.push or not 0.6 < grown < 1.1
            words = f"grows with {rate}, but a push of {self.push} becomes {sizes[0]} and by {1 / rate} s later {sizes[1]}"
        return [Find(self.name, "growth", words, statement, varied)] if wrong else []


class Shaken(Relation):
    name = "shaken"
    changes = "what shakes a steady motion is doubled: amplitudes of responses are doubled, and phases stay"
    settings_too = False
    sizes = ("force", "couple", "unbalance", "by")

    def make(self, draw):
        statement = made_statement(draw, "equilibrium")
        tree = statement.copy().tree
        names = [joint["angle"] for joint in tree.get("joints", {}).values() if "angle" in joint]
        if not names:
            return statement
        tree["excitations"] = {"push": {
            "couple": [f"{draw.uniform(-3, 3):.3f} N*m" for _ in range(3)], "body": draw.choice(list(tree["bodies"])),
            "frequency": f"{draw.uniform(0, 30):.3f} rad/s"}}
        tree["ask"] = {f"{part}_{name}": f"response({name} to push).{part}" for name in names for part in ("amplitude", "phase")}
        return statement.with_tree(tree)

    def vary(self, statement, random):
        tree = statement.copy().tree
        if "excitations" not in tree or "excitations" in str(tree.get("situations", "")):
            raise NotApplicable

        def doubled(size):
            return [doubled(part) for part in size] if isinstance(size, list) else f"2*({size})"

        for shakes in tree["excitations"].values():
            for key in self.sizes:
                if key in shakes:
                    shakes[key] = doubled(shakes[key])

        def expected(name, value, answer):
            text = asked_text(answer)
            if "response(" not in text:
                return SKIP if isinstance(value, list) else value
            part = re.fullmatch(r"response\((?:[^()]|\([^()]*\))*\)\.(amplitude|phase)", text)
            return SKIP if part is None else 2 * value if part[1] == "amplitude" and value is not None else value

        return Varied(statement.with_tree(tree), expected)
