"""What a relation is: a statement is changed in a way of which it is known how the answers must change."""
import math
import re

from compare import RELATIVE, columns_of, exponents_of, number_of, same, sizes, state, tolerance, value_of
from language import L, M, NotUnderstood, T, parse_unit, tokens_of
from statements import mapped_expressions

SKIP = object()
# Sums of some hundred terms leave this part of the largest as rounding, and a motion followed to 1e-13 as much.
ROUNDING = 1e-12


class NotApplicable(Exception):
    """The relation says nothing of this statement."""


class Find:
    """A disagreement: what was asked, what kind it is and how it shows; and both statements."""

    def __init__(self, relation, kind, words, statement, varied=None):
        self.relation, self.kind, self.words = relation, kind, words
        self.statement, self.varied = statement, varied


class Varied:
    """A changed statement, and how its answers follow from those of the statement."""

    def __init__(self, statement, expected=None, letters=None, answer_name=lambda name: name, states=True,
                 relative=None, refusals=True, limits=()):
        self.statement = statement
        self.expected = expected or (lambda name, value, answer: value)
        self.letters = letters  # in SI units, by name; as in the statement if None
        self.answer_name = answer_name
        self.states = states  # whether what is answered in one is answered in the other
        self.relative = relative
        self.refusals = refusals  # whether it is a find if the changed statement is refused as input
        self.limits = limits  # words of reasons why what is answered in one is not in the other
        self.scales = (1, 1, 1), (1, 1, 1)


class Relation:
    """One relation. `name` is how finds are called, `changes` says what is changed and what must follow."""

    name = changes = ""
    settings_too = True  # whether statements with letters are also tried with values given to them

    def vary(self, statement, random):
        raise NotImplementedError

    def hold(self, program, statement, random):
        """Runs both statements and compares. Returns the finds, None if the relation says nothing of the statement."""
        statement = with_values(statement, random) if self.settings_too else statement
        try:
            varied = self.vary(statement, random)
        except (NotApplicable, NotUnderstood):
            return None
        first = program.solve(statement, keep=True)
        if first.fault:
            return [Find(self.name, "fault", first.fault, statement)]
        if first.code == 2 or not first.document:
            return None
        second = program.solve(varied.statement)
        if second.fault:
            return [Find(self.name, "fault", second.fault, statement, varied.statement)]
        if second.code == 2 or not second.document:
            if not varied.refusals:
                return None
            return [Find(self.name, "refused", second.message, statement, varied.statement)]
        letters = letter_values(statement)
        varied.scales = scales_of(statement), scales_of(varied.statement)
        try:
            words = difference(first.document, second.document, letters, varied)
        except NotUnderstood:
            return None
        return [Find(self.name, *words, statement, varied.statement)] if words else []


def with_values(statement, random):
    """The statement, or the statement with values for its letters."""
    letters = statement.tree.get("letters")
    if not letters or random.random() < 0.5:
        return statement
    given = statement.copy()
    given.settings = drawn_letters(statement)
    return given


def drawn_letters(statement):
    """Values of all letters as text: those of the example, and where it has none others, the same each time."""
    values = dict(statement.letters)
    for index, (name, unit) in enumerate(statement.tree.get("letters", {}).items()):
        unit = unit.get("signed") if isinstance(unit, dict) else unit
        if name not in values:
            number = f"{1 + 0.37 * (index + 1) % 1.9:.4g}"
            values[name] = number if unit == "1" else f"{number} {unit}" if parse_unit(unit).exponents != (0, 0, 0, 1) else f"{0.2 + 0.13 * index % 0.9:.4g} rad"
    return values


def si_value(text):
    """A quantity's value in SI units and radians: '3 kg', '-2.5 m'."""
    tokens = tokens_of(text)
    sign = 1
    while tokens and tokens[0].text in "+-":
        sign *= -1 if tokens[0].text == "-" else 1
        tokens = tokens[1:]
    if len(tokens) != 1 or tokens[0].value is None:
        raise NotUnderstood(text)
    return sign * float(tokens[0].value) * (si_factor(tokens[0].unit) if tokens[0].unit else 1.0)


def si_factor(unit):
    return float(unit.factor) * (2 * math.pi) ** unit.turns


def letter_values(statement):
    values = {}
    for name, text in drawn_letters(statement).items():
        try:
            values[name] = si_value(text)
        except NotUnderstood:
            continue
    values.setdefault("g", 9.80665)
    return values


def of_answer(text):
    """A condition and the answer that it is told of, or None where it is told of all: "9.5 - k > 0 for 'height'"."""
    found = re.fullmatch(r"(.*) for '([^']*)'", text)
    return (found[1], found[2]) if found else (text, None)


def holds_at(text, letters):
    """Whether a condition holds at these values of the letters, as far as it is a formula."""
    for sign in (" >= ", " <= ", " > ", " < "):
        left, found, right = text.partition(sign)
        if not found:
            continue
        try:
            less = number_of(left.split(":")[-1].strip(), letters) - number_of(right, letters)
        except NotUnderstood:
            return True
        return less >= 0 if ">" in sign else less <= 0
    return True


def conditions_hold(solution, letters):
    """Whether the conditions of all answers hold at these values of the letters."""
    texts = [c["formula"] for c in solution.get("conditions", [])] + solution.get("assumptions", [])
    return all(holds_at(text, letters) for text in texts if of_answer(text)[1] is None)


def answers_elsewhere(solution, letters):
    """The answers told under a condition of their own that does not hold at these values of the letters."""
    told = map(of_answer, solution.get("assumptions", []))
    several = {name for name, answer in solution["answers"].items() if answer.get("formulas")}
    return {name for text, name in told if name and name not in several and not holds_at(text, letters)}


def is_untold(answer):
    """Whether an answer waits for values of letters."""
    return "value" in answer and answer["value"] is None and not answer.keys() & {"formula", "formulas", "refused"}


def digits_told(solution, name):
    """How far the numbers of a law that was found by trials may be off, as its note says."""
    for note in solution.get("notes", []):
        found = re.fullmatch(r"(.*?) by .*with numbers of (\d+) digits.*", note)
        if found and name in re.split(r", | and ", found[1]):
            return 10.0 ** (1 - int(found[2]))
    return 0.0


def difference(first, second, letters, varied):
    """How the second document disagrees with the first: kind and words; None if it agrees."""
    others = varied.letters if varied.letters is not None else letters
    ones = [s for s in first["solutions"] if conditions_hold(s, letters)]
    twos = [s for s in second["solutions"] if conditions_hold(s, others)]
    if len(ones) != len(first["solutions"]) or len(twos) != len(second["solutions"]):
        return None
    if len(ones) != len(twos):
        # Of solutions that tell nothing without values of letters it is not known at which of these they hold.
        if any(all(map(is_untold, solution["answers"].values())) for solution in ones + twos):
            return None
        return "solutions", f"{len(ones)} solutions become {len(twos)}"
    left = list(range(len(twos)))
    for one in ones:
        tried = []
        for index in left:
            wrong = solution_difference(one, twos[index], letters, others, varied)
            if wrong is None:
                left.remove(index)
                break
            tried.append(wrong)
        else:
            return min(tried, key=lambda wrong: wrong[2])[:2]
    return None


def solution_difference(one, two, letters, others, varied):
    relative = varied.relative or tolerance(one, two)
    floors = [rounding_floors(one, varied.scales[0]), rounding_floors(two, varied.scales[1])]
    count, first_wrong = 0, None
    elsewhere = answers_elsewhere(one, letters), answers_elsewhere(two, others)
    for name, answer in one["answers"].items():
        other_name = varied.answer_name(name)
        if other_name is SKIP or name in elsewhere[0] or other_name in elsewhere[1]:
            continue
        other = two["answers"].get(other_name)
        if other is None:
            wrong = (f"{name}: missing", f"{name} has no answer")
        else:
            told_to = max(relative, digits_told(one, name), digits_told(two, other_name))
            wrong = answer_difference(name, answer, other, letters, others, varied, told_to, floors)
        if wrong:
            count += 1
            first_wrong = first_wrong or wrong
    return (*first_wrong, count) if first_wrong else None


def rounding_floors(solution, scales):
    """For each unit what may be rounding of an answer that is zero: beside the largest answer in it, and beside what
    the statement's own lengths, masses and times make."""
    floors = {}
    for answer in solution["answers"].values():
        parts = answer["table"]["columns"] if "table" in answer else [answer]
        for part in parts:
            unit = part.get("unit")
            if unit not in floors:
                powers = zip(scales, exponents_of(unit) if unit else ())
                floors[unit] = ROUNDING * math.prod(scale**power for scale, power in powers)
            for size in sizes(part.get("si")):
                floors[unit] = max(floors[unit], ROUNDING * size)
    return floors


def scales_of(statement):
    """How long, heavy and slow a statement is: the largest of its lengths and masses, the shortest of its times."""
    found = {L: [], M: [], T: []}

    def look(tokens, path):
        for token in tokens:
            if token.unit and token.value:
                a, b, c, _ = token.unit.exponents
                size = abs(float(token.value)) * si_factor(token.unit)
                if (a, b, c) in ((1, 0, 0), (0, 1, 0)):
                    found[L if a else M].append(size)
                elif (a, b) == (0, 0) and abs(c) == 1:
                    found[T].append(size**c)
                elif (a, b, c) == (1, 1, -2):
                    found[M].append(size / 9.8)
                elif (a, b, c) == (1, 0, -1):
                    found["v"] = max(found.get("v", 0), size)
        return tokens

    mapped_expressions(statement.tree, look)
    for name, text in statement.settings.items():
        look(tokens_of(text), ())
    length, mass = max(found[L], default=1.0), max(found[M], default=1.0)
    times_found = found[T] + ([length / found["v"]] if found.get("v") else [])
    return length, mass, min(times_found, default=(length / 9.8) ** 0.5)


def below(value, floor):
    return all(size <= floor for size in sizes(value))


def rounding_alone(answer, other, value, found, floors):
    """Whether both are zero but for rounding: nothing beside the largest answer in the same unit."""
    if "table" in answer and "table" in other and isinstance(value, list) and isinstance(found, list):
        units = [[column["unit"] for column in columns_of(one)] for one in (answer, other)]
        return len(value) == len(found) and all(
            same(v, f, RELATIVE) or below(v, floors[0].get(a, 0)) and below(f, floors[1].get(b, 0))
            for v, f, a, b in zip(value, found, *units))
    return below(answer.get("si"), floors[0].get(answer.get("unit"), 0)) and \
        below(found, floors[1].get(other.get("unit"), 0))


def answer_difference(name, answer, other, letters, others, varied, relative, floors):
    kinds = state(answer), state(other)
    answered = [kind in ("found", "claim", "table", "formula") for kind in kinds]
    if answered[0] != answered[1]:
        open_letters = "needs letters" in kinds
        if open_letters or not varied.states or varied.expected(name, None, answer) is SKIP:
            return None
        reason = other.get("reason") or answer.get("reason")
        if any(words in str(reason) for words in varied.limits):
            return None
        return f"{name}: {kinds[0]}, {kinds[1]}", f"{name}: {kinds[0]} becomes {kinds[1]} ({reason})"
    if not answered[0]:
        return None
    value = varied.expected(name, value_of(answer, letters), answer)
    found = value_of(other, others)
    if value is SKIP or same(value, found, relative) or rounding_alone(answer, other, value, found, floors):
        return None
    return f"{name}: value", f"{name}: {str(found)[:300]} in place of {str(value)[:300]}"
