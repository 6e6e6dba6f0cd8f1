"""Statements made at random: trees of bodies, motions, equilibria, blows and contacts, with questions of all kinds."""
from statements import Statement


def number(draw, low, high, digits=3):
    return f"{draw.uniform(low, high):.{digits}g}"


def place(draw, size=1.0):
    return [f"{number(draw, -size, size)} m" for _ in range(3)]


def direction(draw):
    if draw.random() < 0.5:
        return draw.choice(["x", "y", "z", "-x", "-y", "-z"])
    return [str(draw.choice([-3, -2, -1, 1, 2, 3])) for _ in range(3)]


def body(draw, center, name):
    """A body around a point: a shape, or numbers."""
    size = f"{number(draw, 0.05, 0.4)} m"
    other = f"{number(draw, 0.05, 0.4)} m"
    mass = {"mass": f"{number(draw, 0.2, 9)} kg"}
    kind = draw.randrange(8)
    if kind == 0:
        return {"sphere": {"center": center, "radius": size}, **mass}
    if kind == 1:
        return {"disk": {"center": center, "normal": direction(draw), "radius": size}, **mass}
    if kind == 2:
        return {"cylinder": {"center": center, "axis": direction(draw), "radius": size, "length": other}, **mass}
    if kind == 3:
        return {"box": {"center": center, "sides": [f"{size} * x", f"{other} * y", "0.23 m * z"]}, **mass}
    if kind == 4:
        return {"rod": [center, f"{center} + {place_text(draw)}"], **mass}
    if kind == 5:
        moments = [draw.uniform(1, 1.9) for _ in range(3)]
        product = draw.uniform(-0.2, 0.2)
        unit = "kg*m^2"
        return {"center": center, **mass, "inertia": {
            "x": f"{moments[0]:.3g} {unit}", "y": f"{moments[1]:.3g} {unit}", "z": f"{moments[2]:.3g} {unit}",
            "xy": f"{product:.3g} {unit}", "yz": "0", "zx": f"{-product:.3g} {unit}"}}
    if kind == 6:
        return {"ring": {"center": center, "normal": direction(draw), "radius": size}, **mass}
    return {"cone": {"apex": center, "base": f"{center} + {place_text(draw)}", "radius": other}, **mass}


def place_text(draw):
    return "[" + ", ".join(place(draw, 0.6)) + "]"


def joint(draw, holder, held, at, index, spring=False):
    """A joint with coordinates that have names; and the names, with the unit of each."""
    made = {"to": held}
    if holder:
        made["from"] = holder
    kind = draw.choice(["revolute"] * 4 + ["prismatic", "cylindrical", "universal"])

    def freedom(turning):
        name, unit = f"q{index}", "rad" if turning else "m"
        one = {"angle" if turning else "displacement": name}
        if spring or draw.random() < 0.3:
            one["spring"] = {"stiffness": f"{number(draw, 5, 90)} " + ("N*m/rad" if turning else "N/m")}
        if not spring and draw.random() < 0.3:
            one["damping"] = f"{number(draw, 0.1, 2)} " + ("N*m*s/rad" if turning else "N*s/m")
        if not spring and draw.random() < 0.2:
            one["couple" if turning else "force"] = f"{number(draw, 0.5, 4)} " + ("N*m" if turning else "N")
        return one, (name, unit)

    if kind in ("revolute", "prismatic"):
        one, coordinate = freedom(kind == "revolute")
        return {kind: direction(draw), "at": at, **made, **one}, [coordinate]
    names = ("turn", "slide") if kind == "cylindrical" else ("first", "second")
    freedoms, coordinates = {}, []
    for position, name in enumerate(names):
        one, coordinate = freedom(kind == "universal" or position == 0)
        letter = coordinate[0] + "ab"[position]
        one["angle" if coordinate[1] == "rad" else "displacement"] = letter
        freedoms[name] = one
        coordinates.append((letter, coordinate[1]))
    axis = direction(draw) if kind == "cylindrical" else draw.choice([["x", "y"], ["z", "x"], ["y", "z"]])
    return {kind: axis, "at": at, **made, "freedoms": freedoms}, coordinates


def chain(draw, count, spring=False):
    """A tree of bodies hung on the ground; its tree of text and its coordinates."""
    tree = {"title": "A statement made at random", "points": {}, "bodies": {}, "joints": {}}
    coordinates, at = [], None
    for index in range(1, count + 1):
        tree["points"][f"P{index}"] = place(draw, 0.3) if at is None else [f"{number(draw, -1, 1)} m" for _ in range(3)]
        tree["points"][f"C{index}"] = place(draw, 0.8)
        tree["bodies"][f"b{index}"] = body(draw, f"C{index}", f"b{index}")
        holder = f"b{draw.randint(1, index - 1)}" if index > 1 else None
        tree["joints"][f"j{index}"], own = joint(draw, holder, f"b{index}", f"P{index}", index, spring)
        coordinates += own
        at = index
    tree["gravity"] = draw.choice(["-y", "-z", "x", "none"])
    if draw.random() < 0.5:
        tree["loads"] = {"push": {"force": [f"{number(draw, -9, 9)} N" for _ in range(3)], "at": f"P{count}",
                                  "body": f"b{count}"}}
        if draw.random() < 0.5:
            tree["loads"]["twist"] = {"couple": [f"{number(draw, -3, 3)} N*m" for _ in range(3)], "body": "b1"}
    return tree, coordinates


def state_facts(draw, coordinates, moving=True):
    facts = {}
    for name, unit in coordinates:
        facts[name] = f"{number(draw, -0.9, 0.9)} {unit}" if unit == "rad" else f"{number(draw, -0.3, 0.3)} m"
        facts[name + "'"] = (f"{number(draw, -4, 4)} {unit}/s") if moving else "0"
    return facts


def instant(draw):
    """Bodies on a tree of joints, at an instant."""
    count = draw.randint(1, 4)
    tree, coordinates = chain(draw, count)
    tree["instants"] = {"now": state_facts(draw, coordinates)}
    last = f"b{count}"
    asks = {
        "accel": f"acceleration({last})", "alpha": f"angular_acceleration({last})", "w": f"angular_velocity({last})",
        "v": f"velocity(P1 of {last})", "H": f"angular_momentum(system about P{count})", "p": f"momentum({last})",
        "T": "kinetic_energy(system)", "V": "potential_energy(system)", "R": "reaction(j1)", "M": "reaction_couple(j1)",
        "F": f"force(j{count} on {last})", "G": f"couple(j{count} on {last} about C{count})",
        "far": f"distance(center({last}) to P1)", "I": f"moments_of_inertia({last} about P1)",
        "drift": "rate(kinetic_energy(system))", "principal": f"principal_moments({last} about center({last}))",
        "own": f"kinetic_energy({last} about center({last}))", "q2": coordinates[-1][0] + "''",
    }
    names = draw.sample(sorted(asks), 7)
    tree["ask"] = {name: asks[name] for name in names}
    return tree


def motion(draw):
    """The same, followed through time."""
    count = draw.randint(1, 2)
    tree, coordinates = chain(draw, count)
    for made in tree["joints"].values():
        for one in [made, *made.get("freedoms", {}).values()]:
            one.pop("couple", None)
    tree["instants"] = {"start": state_facts(draw, coordinates)}
    # Short, so that motions that are sensitive to how they begin still agree.
    later = f"{number(draw, 0.2, 1.2)} s"
    tree["ask"] = {"q": f"{coordinates[-1][0]} @ {later}", "w": f"angular_velocity(b{count}) @ {later}",
                   "c": f"center(b{count}) @ {later}", "R": f"reaction(j1) @ {later}",
                   "E": f"kinetic_energy(system) @ {later}"}
    return tree


def equilibrium(draw):
    """Bodies on springs, or hanging, at rest as drawn, and what becomes of a small push."""
    count = draw.randint(1, 3)
    tree = {"title": "An equilibrium made at random", "points": {"P0": ["0", "0", "0"]}, "bodies": {}, "joints": {}}
    height, axis = 0.0, draw.choice(["x", "z"])
    sign = draw.choice([-1, 1])
    for index in range(1, count + 1):
        length = draw.uniform(0.3, 1.1)
        height += sign * length
        tree["points"][f"P{index}"] = ["0", f"{height:.4g} m", "0"]
        shape = draw.choice(["rod", "bob"])
        mass = f"{number(draw, 0.3, 4)} kg"
        ends = [f"P{index - 1}", f"P{index}"]
        tree["bodies"][f"b{index}"] = {"rod": ends, "mass": mass} if shape == "rod" else {
            "sphere": {"center": ends[1], "radius": "0.07 m"}, "mass": mass}
        tree["joints"][f"j{index}"] = {"revolute": axis, "at": ends[0], "to": f"b{index}", "angle": f"q{index}",
                                       **({"from": f"b{index - 1}"} if index > 1 else {})}
        if draw.random() < 0.6:
            tree["joints"][f"j{index}"]["spring"] = {"stiffness": f"{number(draw, 1, 90)} N*m/rad"}
    tree["gravity"] = "-y"
    tree["instants"] = {"now": "rest"}
    tree["ask"] = {"stable": "stable(system)", "grows": "growth_rate(system)", "swings": "frequencies(system)",
                   "words": "stability(system)"}
    return tree


def blow(draw):
    """Bodies on a tree of joints, struck."""
    count = draw.randint(1, 3)
    tree, coordinates = chain(draw, count)
    tree.pop("loads", None)
    tree["instants"] = {"before": "rest"}
    tree["impulses"] = {"blow": {"body": f"b{count}", "at": f"C{count}",
                                 "value": [f"{number(draw, -5, 5)} N*s" for _ in range(3)]}}
    tree["ask"] = {"v": f"velocity(b{count})", "w": f"angular_velocity(b{count})", "T": "kinetic_energy(system)",
                   "J": "impulse(j1)", "K": f"impulsive_couple(j{count} on b{count} about C{count})"}
    return tree


KINDS = {"instant": instant, "motion": motion, "equilibrium": equilibrium, "blow": blow}


def made_statement(draw, kind=None):
    kind = kind or draw.choice(["instant", "instant", "motion", "equilibrium", "blow"])
    return Statement(f"made/{kind}", KINDS[kind](draw))
