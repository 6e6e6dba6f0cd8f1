"""The problem language as far as statements are rewritten: tokens of expressions, units, numbers that stay exact.

It is written anew from docs/language.md and shares nothing with the program, except that the hunt's own test holds the
table of units against it.
"""
import re
from dataclasses import dataclass
from fractions import Fraction

FOOT = Fraction("0.3048")
POUND_MASS = Fraction("0.45359237")
POUND_FORCE = POUND_MASS * Fraction("9.80665")
INCH = FOOT / 12

# Exponents of length, mass, time and angle. The radian has an exponent of its own, of which nothing here depends.
L, M, T, A = (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)
FORCE, PRESSURE, ENERGY, POWER = (1, 1, -2, 0), (-1, 1, -2, 0), (2, 1, -2, 0), (2, 1, -3, 0)

# Angles are counted in turns, so that factors stay rational; one turn is 2 pi rad. `rad` is marked by None.
UNITS = {
    "m": (1, L), "km": (1000, L), "dm": (Fraction(1, 10), L), "cm": (Fraction(1, 100), L), "mm": (Fraction(1, 1000), L),
    "um": (Fraction(1, 10**6), L), "ft": (FOOT, L), "in": (INCH, L), "yd": (3 * FOOT, L), "mi": (5280 * FOOT, L),
    "kg": (1, M), "g": (Fraction(1, 1000), M), "mg": (Fraction(1, 10**6), M), "Mg": (1000, M), "t": (1000, M),
    "lbm": (POUND_MASS, M), "ozm": (POUND_MASS / 16, M), "slug": (POUND_FORCE / FOOT, M), "slinch": (POUND_FORCE / INCH, M),
    "s": (1, T), "ms": (Fraction(1, 1000), T), "us": (Fraction(1, 10**6), T), "min": (60, T), "h": (3600, T),
    "day": (86400, T),
    "N": (1, FORCE), "mN": (Fraction(1, 1000), FORCE), "kN": (1000, FORCE), "MN": (10**6, FORCE),
    "lb": (POUND_FORCE, FORCE), "oz": (POUND_FORCE / 16, FORCE), "kip": (1000 * POUND_FORCE, FORCE),
    "Pa": (1, PRESSURE), "kPa": (1000, PRESSURE), "MPa": (10**6, PRESSURE), "GPa": (10**9, PRESSURE),
    "psi": (POUND_FORCE / INCH**2, PRESSURE), "ksi": (1000 * POUND_FORCE / INCH**2, PRESSURE),
    "J": (1, ENERGY), "mJ": (Fraction(1, 1000), ENERGY), "kJ": (1000, ENERGY), "MJ": (10**6, ENERGY),
    "W": (1, POWER), "mW": (Fraction(1, 1000), POWER), "kW": (1000, POWER), "MW": (10**6, POWER),
    "hp": (550 * FOOT * POUND_FORCE, POWER),
    "mph": (5280 * FOOT / 3600, (1, 0, -1, 0)), "knot": (Fraction(1852, 3600), (1, 0, -1, 0)),
    "rad": (1, A), "mrad": (Fraction(1, 1000), A), "deg": (Fraction(1, 360), A), "rev": (1, A), "turn": (1, A),
    "rpm": (Fraction(1, 60), (0, 0, -1, 1)), "%": (Fraction(1, 100), (0, 0, 0, 0)),
}
IN_TURNS = {"deg", "rev", "turn", "rpm"}
PREPOSITIONS = {"about", "along", "to", "with", "from", "of", "on", "by", "at", "relative"}

TOKEN = re.compile(r"\s*(?:(?P<number>(?:\d+(?:\.\d+)?|\.\d+)(?:[eE][+-]?\d+)?)|(?P<name>[A-Za-z_][A-Za-z_0-9]*'*)"
                   r"|(?P<sign>->|<=|>=|==|\.\.|[-+*/^()\[\],.@<>]))")
UNIT = re.compile(r"(?:1(?=/)|[A-Za-z%]+)(?:\^(?:-?\d+|\([-\d/]+\)))?(?:[*/][A-Za-z%]+(?:\^(?:-?\d+|\([-\d/]+\)))?)*")


class NotUnderstood(Exception):
    """The hunt does not know how to rewrite this; the program may."""


@dataclass
class Unit:
    text: str
    factor: Fraction  # in SI units, angles in radians or, if `turns` is not zero, in turns to that power
    exponents: tuple  # of length, mass, time, angle
    turns: int = 0


@dataclass
class Token:
    kind: str  # number, name, sign
    text: str
    blank: str = ""  # in front of it
    value: Fraction | None = None
    unit: Unit | None = None


def parse_unit(text):
    factor, exponents, turns = Fraction(1), [Fraction(0)] * 4, 0
    for sign, piece in re.findall(r"(^|[*/])([^*/]+(?:\([-\d/]+\))?)", text):
        if piece == "1":
            continue
        name, _, power = piece.partition("^")
        if name not in UNITS:
            raise NotUnderstood(f"unit {text}")
        power = Fraction(power.strip("()")) if power else Fraction(1)
        if power.denominator != 1:
            raise NotUnderstood(f"unit {text}")
        power = -power if sign == "/" else power
        size, own = UNITS[name]
        factor *= Fraction(size) ** int(power)
        if name in IN_TURNS:
            turns += int(power)
        exponents = [e + power * o for e, o in zip(exponents, own)]
    return Unit(text, factor, tuple(int(e) for e in exponents), turns)


def unit_at(text, begin):
    """The unit that begins at this place behind a number and blanks; None if it is none."""
    match = UNIT.match(text, begin)
    if not match:
        return None
    first = re.match(r"1/([A-Za-z%]+)|([A-Za-z%]+)", match[0])
    word = (first[1] or first[2]) if first else ""
    if word not in UNITS or word in PREPOSITIONS and not match[0].startswith(word + "/"):
        # `in` is an inch; `at`, `to` and their like are never units.
        if word != "in":
            return None
    end = match.end()
    after = text[end:end + 1]
    if after in ("'", "(") or after and (after.isalnum() or after == "_"):
        return None
    return match[0]


def tokens_of(text):
    tokens, at = [], 0
    while text[at:].strip():
        match = TOKEN.match(text, at)
        if not match:
            raise NotUnderstood(f"'{text[at:]}' in '{text}'")
        blank = match[0][:len(match[0]) - len(match[0].lstrip())]
        begin, at = at + len(blank), match.end()
        kind = match.lastgroup
        token = Token(kind, match[kind], blank)
        if kind == "number":
            token.value = Fraction(token.text)
            fraction = re.compile(r"/((?:\d+(?:\.\d+)?|\.\d+)(?:[eE][+-]?\d+)?)(\s+)").match(text, at)
            if fraction and (unit := unit_at(text, fraction.end())):
                token.value /= Fraction(fraction[1])
                token.unit = parse_unit(unit)
                at = fraction.end() + len(unit)
            else:
                blanks = re.compile(r"\s+").match(text, at)
                if blanks and (unit := unit_at(text, blanks.end())):
                    token.unit = parse_unit(unit)
                    at = blanks.end() + len(unit)
            token.text = text[begin:at]
        tokens.append(token)
    return tokens


def text_of(tokens):
    return "".join(token.blank + token.text for token in tokens).strip()


def number_text(value):
    """A number of the language, exact where 15 digits are: '0.25', '1/3'; otherwise with 17 digits."""
    value = Fraction(value)
    top, bottom = value.numerator, value.denominator
    rest = bottom
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    if rest == 1:
        exponent = 0
        while (value * 10**exponent).denominator != 1:
            exponent += 1
        digits = abs(int(value * 10**exponent))
        zeros = 0
        while digits and digits % 10 == 0:
            digits //= 10
            zeros += 1
        if len(str(digits)) <= 17:
            power = zeros - exponent
            text = f"{digits}e{power}" if power > 6 or power < -9 else plain(digits, power)
            return ("-" if value < 0 else "") + text
    if abs(top) < 10**15 and bottom < 10**15:
        return f"{top}/{bottom}"
    return repr(float(value))


def plain(digits, power):
    text = str(digits)
    if power >= 0:
        return text + "0" * power
    if len(text) <= -power:
        text = "0" * (-power - len(text) + 1) + text
    return f"{text[:power]}.{text[power:]}"


def literal_text(value, unit, tokens, index):
    """A literal in place of tokens[index]; in parentheses where a fraction could be read in two ways."""
    number = number_text(value)
    text = f"{number} {unit}"
    before = tokens[index - 1].text if index else ""
    if before == "@" and "/" in number:
        return f"{float(value)!r} {unit}"
    return f"({text})" if "/" in number and before in ("/", "^") else text
