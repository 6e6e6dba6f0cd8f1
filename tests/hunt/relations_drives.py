"""What is far, slow or equal is what is plain: a center of gravity far away, wheels of one size, a contact that is never
reached, a shaking that takes long."""
from random_statements import body, number, place
from relations import NotApplicable, Relation, Varied
from statements import Statement, situations_of

G = 9.80665


class FarCenter(Relation):
    name = "far_center"
    changes = "gravity points to a center ten million times as far away as anything is large; answers stay"
    settings_too = False
    away = 1e7

    def make(self, draw):
        """One or two bodies on joints, let go; or hanging at rest, whose frequencies are asked."""
        points, bodies, joints = {}, {}, {}
        start = {}
        for index in range(draw.choice([1, 1, 2])):
            name, at = f"b{index}", f"P{index}"
            points[at] = place(draw)
            bodies[name] = body(draw, f"{at} + [0.11 m, -0.17 m, 0.07 m]", name)
            joints[f"j{index}"] = {"universal": ["x", "z"], "at": at, "from": f"b{index - 1}" if index else "ground",
                                   "to": name, "freedoms": {"first": {"angle": f"p{index}"}, "second": {"angle": f"q{index}"}}}
            for coordinate in (f"p{index}", f"q{index}"):
                start[coordinate] = f"{number(draw, -1, 1)} rad"
                start[coordinate + "'"] = f"{number(draw, -2, 2)} rad/s"
        last = f"b{len(bodies) - 1}"
        ask = {"a": f"acceleration({last})", "w": f"angular_acceleration({last})", "f": "force(j0 on b0)",
               "W": f"weight({last})", "later": f"center({last}) @ {number(draw, 0.1, 0.5)} s"}
        return Statement("made/far", {"title": "Bodies on joints", "points": points, "bodies": bodies, "joints": joints,
                                      "gravity": "-y", "instants": {"start": start}, "ask": ask})

    def vary(self, statement, random):
        tree = statement.copy().tree
        if tree.get("gravity") != "-y" or tree.get("title") != "Bodies on joints":
            raise NotApplicable
        tree["points"]["far"] = ["0", f"-{self.away!r} m", "0"]
        tree["gravity"] = {"toward": "far", "parameter": f"{G * self.away**2!r} m^3/s^2"}
        # Near a lock of a joint what the pull differs by counts a hundredfold.
        return Varied(statement.with_tree(tree), relative=1e-5)


class EqualWheels(Relation):
    name = "equal_wheels"
    changes = "two wheels of one size that teeth or a belt couple are one wheel with the inertia and the couples of both"
    settings_too = False

    def make(self, draw):
        reach = number(draw, 0.1, 0.4)
        how = draw.choice(["teeth", "belt", "crossed"])
        apart = f"2*{reach} m" if how == "teeth" else f"{number(draw, 1, 2)} m"
        bodies = {name: {"mass": "2 kg", "center": center, "inertia": {
            "axis": "z", "axial": f"{number(draw, 0.01, 0.9)} kg*m^2", "transverse": "1 kg*m^2"}}
            for name, center in (("one", "A"), ("two", "B"))}
        joints = {"shaft": {"revolute": "z", "at": "A", "to": "one", "angle": "p", "rate": f"{number(draw, -9, 9)} rad/s",
                            "couple": f"{number(draw, -9, 9)} N*m", "damping": f"{number(draw, 0, 2)} N*m*s/rad"},
                  "axle": {"revolute": "z", "at": "B", "to": "two", "couple": f"{number(draw, -9, 9)} N*m",
                           "spring": {"stiffness": f"{number(draw, 1, 90)} N*m/rad"}}}
        wheel = {"radius": f"{reach} m"}
        tree = {"title": "Two wheels of one size", "points": {"A": ["0", "0", "0"], "B": [apart, "0", "0"],
                                                              "P": [f"{reach} m", "0", "0"]},
                "bodies": bodies, "joints": joints, "gravity": "none",
                "ask": {"al": "angular_acceleration(one).z", "later": f"p @ {number(draw, 0.05, 0.5)} s",
                        "T": "kinetic_energy(system)"}}
        if how == "teeth":
            tree["gears"] = {"mesh": {"of": "one", "against": "two", "at": "P"}}
        else:
            tree["belts"] = {"belt": {"over": [{"one": wheel}, {"two": wheel}], "tension": "9 kN"}}
            if how == "crossed":
                tree["belts"]["belt"]["crossed"] = "true"
        return Statement("made/equal", tree)

    def vary(self, statement, random):
        tree = statement.copy().tree
        if tree.get("title") != "Two wheels of one size":
            raise NotApplicable
        same_way = "belts" in tree and "crossed" not in tree["belts"]["belt"]
        axle, two = tree["joints"].pop("axle"), tree["bodies"].pop("two")
        tree.pop("gears", None)
        tree.pop("belts", None)
        shaft, inertia = tree["joints"]["shaft"], tree["bodies"]["one"]["inertia"]
        inertia["axial"] += f" + {two['inertia']['axial']}"
        inertia["transverse"] = "2 kg*m^2"
        shaft["couple"] += f" {'+' if same_way else '-'} ({axle['couple']})"
        shaft["spring"] = axle["spring"]
        return Varied(statement.with_tree(tree), relative=1e-7)


class NeverReached(Relation):
    name = "never_reached"
    changes = "a contact is stated that would be struck a kilometre farther on; answers stay"
    settings_too = False

    def make(self, draw):
        points = {"O": ["0", "0", "0"], "P": place(draw), "Q": place(draw)}
        bodies = {"swings": body(draw, "O + [0.2 m, -0.3 m, 0]", "swings"), "flies": {"sphere": {
            "center": "Q", "radius": f"{number(draw, 0.05, 0.3)} m"}, "mass": f"{number(draw, 0.2, 9)} kg"}}
        holds = {"revolute": draw.choice(["x", "z"]), "at": "O", "to": "swings", "angle": "p"}
        start = {"p": f"{number(draw, -1, 1)} rad", "p'": f"{number(draw, -2, 2)} rad/s",
                 "velocity(flies)": [f"{number(draw, -3, 3)} m/s" for _ in range(3)],
                 "angular_velocity(flies)": [f"{number(draw, -3, 3)} rad/s" for _ in range(3)]}
        time = number(draw, 0.2, 1)
        return Statement("made/never", {"title": "One swings, one flies", "points": points, "bodies": bodies,
                                        "joints": {"pin": holds}, "gravity": "-y", "instants": {"start": start},
                                        "ask": {"a": "acceleration(swings)", "f": "force(pin on swings)",
                                                "p": f"p @ {time} s", "c": f"center(flies) @ {time} s",
                                                "most": "max(p)"}})

    def vary(self, statement, random):
        tree = statement.copy().tree
        if tree.get("title") != "One swings, one flies":
            raise NotApplicable
        reach = tree["bodies"]["flies"]["sphere"]["radius"]
        bounce = {"restitution": "0.5"} if random.random() < 0.5 else {}
        if random.random() < 0.3:
            bounce["friction"] = "0.4"
        tree["contacts"] = {"far": {"of": "flies", "at": f"Q - ({reach})*y", "normal": "y", "open": "true",
                                    "surface": "[0, -1 km, 0]", **bounce}}
        return Varied(statement.with_tree(tree), relative=1e-7)


class Corner(Relation):
    name = "corner"
    changes = "a contact at the end of a rod or a corner of a box is stated as a corner"
    settings_too = False

    def make(self, draw):
        half, height = number(draw, 0.2, 0.9), number(draw, 0.1, 0.8)
        if draw.random() < 0.5:
            lean = f"{number(draw, 15, 75)} deg"
            bodies = {"one": {"rod": ["A", "B"], "mass": f"{number(draw, 0.5, 9)} kg"}}
            points = {"A": ["0", "0", "0"], "B": [f"{half} m * 2*cos({lean})", f"{half} m * 2*sin({lean})", "0"]}
            contacts = {"foot": {"of": "one", "at": "A", "normal": "y"}, "top": {"of": "one", "at": "B", "normal": "-x"}}
        else:
            points = {"G": ["0", f"{height} m", "0"], "A": [f"-{half} m", "0", "0.3 m"], "B": [f"{half} m", "0", "-0.3 m"]}
            sides = [f"2*{half} m * x", f"2*{height} m * y", "0.6 m * z"]
            bodies = {"one": {"box": {"center": "G", "sides": sides}, "mass": f"{number(draw, 0.5, 9)} kg"}}
            contacts = {"foot": {"of": "one", "at": "A", "normal": "y", "no_slip": "true"}}
        force = [f"{number(draw, -3, 3)} N", f"{number(draw, -9, -1)} N", "0"]
        return Statement("made/corner", {
            "title": "A body on its corners", "points": points, "bodies": bodies, "contacts": contacts,
            "loads": {"push": {"force": force, "body": "one"}}, "gravity": "-y", "instants": {"now": "rest"},
            "ask": {"a": "acceleration(one)", "w": "angular_acceleration(one)", "f": "force(foot on one)",
                    "N": "normal_force(foot)"}})

    def vary(self, statement, random):
        tree = statement.copy().tree
        if tree.get("title") != "A body on its corners":
            raise NotApplicable
        for situation in situations_of(tree):
            for contact in situation.get("contacts", {}).values():
                contact["corner"] = contact.pop("at")
        return Varied(statement.with_tree(tree), relative=1e-7)


class SlowShaking(Relation):
    name = "slow_shaking"
    changes = "what is shaken slowly moves as far as a load of the same size holds it at rest"
    settings_too = False

    def make(self, draw):
        stiff = [number(draw, 100, 900) for _ in range(3)]
        turns = draw.random() < 0.4
        unit, slides = ("N*m/rad", "angle") if turns else ("N/m", "displacement")
        kind = {"revolute": "x"} if turns else {"prismatic": "x"}
        free = "free_angle" if turns else "free_displacement"
        points = {"A": ["0", "0", "0"], "B": ["1 m", "0", "0"]}
        bodies = {name: {"mass": f"{number(draw, 1, 9)} kg", "center": at, "inertia": {
            "axis": "x", "axial": f"{number(draw, 0.1, 3)} kg*m^2", "transverse": "3 kg*m^2"}}
            for name, at in (("one", "A"), ("two", "B"))}
        joints = {"ja": {**kind, "at": "A", "to": "one", slides: "s", "spring": {"stiffness": f"{stiff[0]} {unit}"},
                         "damping": f"{number(draw, 0.1, 9)} {unit.replace('/', '*s/')}"},
                  "jb": {**kind, "at": "B", "from": "one", "to": "two", slides: "u",
                         "spring": {"stiffness": f"{stiff[1]} {unit}", free: "0 rad" if turns else "0 m"}}}
        push = {"couple" if turns else "force": f"{number(draw, 1, 9)} {'N*m' if turns else 'N'}",
                "about" if turns else "along": "x", "body": draw.choice(["one", "two"]),
                "frequency": draw.choice(["0 rad/s", "1e-4 rad/s"])}
        word, about = ("couple", " about A") if turns else ("force", "")
        ask = {"s": "response(s to push).amplitude", "u": "response(u to push).amplitude",
               "f": f"response({word}(ja on one{about}).x to push).amplitude"}
        if push["body"] == "one":  # what hangs on it follows by its inertia alone
            del ask["u"]
        return Statement("made/slow", {"title": "A chain of two", "points": points, "bodies": bodies, "joints": joints,
                                       "excitations": {"push": push}, "gravity": "none",
                                       "instants": {"now": {"s": "0", "u": "0", "s'": "0", "u'": "0"}}, "ask": ask})

    def vary(self, statement, random):
        tree = statement.copy().tree
        push = tree.pop("excitations", {}).get("push")
        if not push or tree.get("title") != "A chain of two":
            raise NotApplicable
        del push["frequency"]
        tree["loads"] = {"push": push}
        turns = "couple" in push
        unit = "rad" if turns else "m"
        tree["find"] = {"S": unit, "U": unit}
        tree["instants"] = {"now": {"rest": "true", "s": "S", "u": "U", "s''": "0", "u''": "0"}}
        word, about = ("couple", " about A") if turns else ("force", "")
        asks = {"s": "abs(s)", "u": "abs(u)", "f": f"abs({word}(ja on one{about}).x)"}
        tree["ask"] = {name: asks[name] for name in tree["ask"]}
        return Varied(statement.with_tree(tree), relative=1e-6)
