"""Relations of measure: other units, and other sizes of length, mass and time."""
from fractions import Fraction

from compare import columns_of, exponents_of, times
from language import L, M, T, literal_text, number_text, parse_unit, tokens_of
from relations import NotApplicable, Relation, Varied, letter_values
from statements import mapped_expressions, situations_of

LENGTHS = ["m", "km", "cm", "mm", "um", "ft", "in", "yd", "mi"]
MASSES = ["kg", "g", "mg", "Mg", "lbm", "ozm", "slug", "slinch"]
TIMES = ["s", "ms", "us", "min", "h"]
ANGLES = {0: ["rad", "mrad"], 1: ["deg", "rev", "turn"]}


def product(pieces):
    """The text of a unit from names and exponents."""
    above = [n if e == 1 else f"{n}^{e}" for n, e in pieces if e > 0]
    below = [n if e == -1 else f"{n}^{-e}" for n, e in pieces if e < 0]
    text = "*".join(above) or "1"
    return text + "".join("/" + piece for piece in below)


class Units(Relation):
    name = "units"
    changes = "every quantity is written in other units; answers in SI units stay"

    def vary(self, statement, random):
        chosen = {L: random.choice(LENGTHS), M: random.choice(MASSES), T: random.choice(TIMES)}

        def other(unit):
            """Another unit of the same kind, and its size in SI units."""
            a, b, c, d = unit.exponents
            if not (a or b or c):
                if not d or abs(d) > 1:
                    return unit.text, unit.factor
                name = random.choice(ANGLES[1 if unit.turns else 0])
                text = product([(name, d)])
            else:
                # Units that count turns do so in their product as well; 1/min alone is refused.
                angle = "rev" if unit.turns else "rad"
                time = "s" if (a, b, c, d) == (0, 0, -1, 0) else chosen[T]
                text = product([(chosen[M], b), (chosen[L], a), (time, c), (angle, d)])
                if unit.turns and unit.turns != d:
                    return unit.text, unit.factor
            made = parse_unit(text)
            if made.exponents != unit.exponents or made.turns != unit.turns:
                return unit.text, unit.factor
            return text, made.factor

        def change(tokens, path):
            for index, token in enumerate(tokens):
                if token.unit:
                    text, factor = other(token.unit)
                    value = token.value * token.unit.factor / factor
                    token.text = literal_text(value, text, tokens, index)
            return tokens

        def units(text):
            return text if text in ("1", "%") else other(parse_unit(text))[0]

        tree = mapped_expressions(statement.tree, change, units)
        settings = {name: mapped_text(text, change) for name, text in statement.settings.items()}
        return Varied(statement.with_tree(tree, settings), letters=letter_values(statement))


def mapped_text(text, change):
    return mapped_expressions({"given": text}, lambda tokens, path: change(tokens, path))["given"]


class Sizes(Relation):
    name = "sizes"
    changes = "lengths, masses and times are all made larger or smaller, up to a million times; answers follow by their units"

    def vary(self, statement, random):
        if statement.files:
            raise NotApplicable
        powers = [random.randint(-6, 6) if random.random() < 0.6 else 0 for _ in range(3)]
        if not any(powers):
            powers[random.randrange(3)] = random.choice([-6, -3, 3, 6])

        def factor(exponents):
            return Fraction(10) ** sum(p * e for p, e in zip(powers, exponents))

        def change(tokens, path):
            for index, token in enumerate(tokens):
                if token.unit and token.value:
                    value = token.value * factor(token.unit.exponents)
                    if not 1e-90 < abs(value) < 1e90:
                        raise NotApplicable
                    token.text = literal_text(value, token.unit.text, tokens, index)
            return tokens

        tree = mapped_expressions(statement.tree, change)
        if not has_size(statement.tree.get("gravity", "")) and not any("g" in s.get(kind, {}) for s in situations_of(tree) for kind in ("given", "letters", "find")):
            tree.setdefault("given", {})["g"] = f"{number_text(Fraction('9.80665') * factor((1, 0, -2, 0)))} m/s^2"
        settings = {name: mapped_text(text, change) for name, text in statement.settings.items()}
        letters = letter_values(statement)
        scaled = {}
        for name, value in letters.items():
            unit = statement.tree.get("letters", {}).get(name, "m/s^2" if name == "g" else "1")
            unit = unit.get("signed") if isinstance(unit, dict) else unit
            scaled[name] = value * float(factor(exponents_of(unit if unit != "1" else "")))

        def expected(name, value, answer):
            if value is None:
                return value
            if "table" in answer:
                columns = columns_of(answer)
                return [times(v, float(factor(exponents_of(c["unit"])))) for v, c in zip(value, columns)]
            return times(value, float(factor(exponents_of(answer.get("unit") or ""))))

        return Varied(statement.with_tree(tree, settings), expected, scaled)


def has_size(gravity):
    """Whether gravity is stated as a vector with units, whose size is then g."""
    if isinstance(gravity, dict):
        return False  # of a center
    text = " ".join(gravity) if isinstance(gravity, list) else gravity
    return any(token.unit or token.text == "[" for token in tokens_of(text)) or isinstance(gravity, list)
