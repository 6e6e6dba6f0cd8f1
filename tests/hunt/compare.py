"""Answers of two documents held against each other."""
import math
import re

from language import NotUnderstood, parse_unit

# Answers have some twelve digits, and statements that differ by rounding differ by what the answer makes of it: what
# is off by less than this part of the answer is taken as that. A lost term or branch is rarely so small.
RELATIVE = 1e-7
# What a motion is off is told with it ("motion_error", in natural sizes); its answers may be off by this much more.
MOTION_FACTOR = 1e3

FUNCTIONS = {
    "sqrt": lambda x: math.sqrt(x), "sin": math.sin, "cos": math.cos, "tan": math.tan, "asin": math.asin,
    "acos": math.acos, "atan": math.atan, "abs": abs, "atan2": math.atan2, "exp": math.exp, "ln": math.log,
    "pi": math.pi, "max": max, "min": min,
}


def number_of(formula, values):
    """The value of a formula of a document, in SI units, with these values of its letters."""
    if isinstance(formula, list):
        return [number_of(item, values) for item in formula]
    if not isinstance(formula, str):
        return formula
    text = re.sub(r"\bto\b", ",", formula).replace("^", "**")
    if not re.fullmatch(r"[A-Za-z_0-9.,+\-*/() \[\]']*", text):
        raise NotUnderstood(formula)
    text = text.replace("'", "_prime")
    names = {name.replace("'", "_prime"): value for name, value in values.items()}
    try:
        value = eval(text, {"__builtins__": {}}, {**FUNCTIONS, **names})  # its signs are checked above
    except (NameError, SyntaxError, TypeError, ValueError, ZeroDivisionError, OverflowError) as error:
        raise NotUnderstood(f"{formula}: {error}") from error
    return value


def sizes(value):
    if isinstance(value, list):
        for item in value:
            yield from sizes(item)
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield abs(value)


def same(a, b, relative, size=None):
    """Whether two values agree to this part of the larger of them (of a vector, of its largest component)."""
    if isinstance(a, list) and isinstance(b, list):
        size = max(list(sizes(a)) + list(sizes(b)) + [size or 0], default=0)
        return len(a) == len(b) and all(same(x, y, relative, size) for x, y in zip(a, b))
    if isinstance(a, bool) or isinstance(b, bool) or isinstance(a, str) or isinstance(b, str) or a is None or b is None:
        return a == b
    if isinstance(a, list) or isinstance(b, list):
        return False
    return abs(a - b) <= relative * max(abs(a), abs(b), size or 0)


def state(answer):
    if "holds" in answer and "value" not in answer:
        return "claim"
    if answer.get("refused"):
        return "refused"
    if answer.get("determined") is False:
        return "undetermined"
    if "table" in answer:
        return "table"
    if answer.get("value") is None:
        return "formula" if "formula" in answer else "needs letters"
    if "holds" in answer:
        return "claim"
    return "found"


def times(value, factor):
    if isinstance(value, list):
        return [times(item, factor) for item in value]
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return value
    return value * factor


def exponents_of(unit):
    return parse_unit(unit).exponents if unit else (0, 0, 0, 0)


def columns_of(answer):
    """The columns of a table by their names: in which order they stand is a matter of writing."""
    return sorted(answer["table"]["columns"], key=lambda column: column["name"])


def formula_at(answer, letters):
    """The formula of an answer at these values of the letters, if it has several the one whose conditions hold."""
    for one in answer.get("formulas", []):
        if all(holds(condition, letters) for condition in one["where"]):
            return one["formula"]
    return answer["formula"]


def holds(condition, letters):
    """Whether an inequality such as "L - 2*a > 0" holds at these values of the letters."""
    for sign in (" >= ", " <= ", " > ", " < "):
        left, found, right = condition.partition(sign)
        if found:
            less = number_of(left, letters) - number_of(right, letters)
            return less > 0 if ">" in sign else less < 0
    raise NotUnderstood(condition)


def value_of(answer, letters):
    """The answer's value in SI units, of a formula at these values of the letters; of a table the columns'."""
    kind = state(answer)
    if kind == "found":
        return answer["si"]
    if kind == "formula":
        return number_of(formula_at(answer, letters), letters)
    if kind == "table":
        columns = [column["si"] for column in columns_of(answer)]
        # What has one row, such as a response at one frequency, has a list of formulas.
        return [column[0] for column in columns] if all(len(column) == 1 for column in columns) else columns
    if kind == "claim":
        return answer.get("holds")
    return None


def tolerance(*solutions):
    errors = [s["checks"].get("motion_error") or 0 for s in solutions]
    return max([RELATIVE] + [MOTION_FACTOR * error for error in errors])
