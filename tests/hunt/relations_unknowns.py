"""Relations between what is given and what is found: letters in place of numbers, a datum hidden and found again."""
from compare import same, state
from language import NotUnderstood, tokens_of
from relations import Find, NotApplicable, Relation, Varied, letter_values, si_factor
from statements import has_word


def numbers_given(tree):
    """Data that are one number with a unit, not zero: name, value in the unit, unit."""
    found = {}
    for name, text in tree.get("given", {}).items():
        if not isinstance(text, str) or name == "g":
            continue
        try:
            tokens = tokens_of(text)
        except NotUnderstood:
            continue
        sign = 1
        if tokens and tokens[0].text == "-":
            sign, tokens = -1, tokens[1:]
        if len(tokens) == 1 and tokens[0].unit and tokens[0].value and tokens[0].unit.text != "%":
            found[name] = (sign * tokens[0].value, tokens[0].unit)
    return found


class Letters(Relation):
    name = "letters"
    changes = "data lose their values and become letters; formulas, evaluated there, are the numbers"

    def vary(self, statement, random):
        tree = statement.copy().tree
        data = numbers_given(tree)
        if not data or statement.settings or any("given" in s for s in tree.get("situations", {}).values()
                                                 if isinstance(s, dict)):
            raise NotApplicable
        chosen = random.sample(sorted(data), random.randint(1, min(3, len(data))))
        letters, values = dict(tree.get("letters", {})), dict(statement.letters)
        for name in chosen:
            value, unit = data[name]
            values[name] = tree["given"].pop(name)
            letters[name] = {"signed": unit.text} if value < 0 and unit.exponents != (0, 0, 0, 1) else unit.text
        tree["letters"] = letters
        varied = statement.with_tree(tree, letters=values)
        # Not every place takes a letter; what is refused as input with the reason is no find.
        return Varied(varied, letters=letter_values(varied), refusals=False)


class Hidden(Relation):
    name = "hidden"
    changes = "a datum is made unknown and an answer stated as a fact; the datum is among the roots"
    settings_too = False
    # An answer has twelve digits and moves with the datum at least a hundredth as much.
    relative, least_slope = 1e-7, 1e-2

    def hold(self, program, statement, random):
        tree = statement.copy().tree
        if any(key in tree for key in ("find", "letters", "situations", "choose", "stages", "impulses", "impacts",
                                       "strikes", "steady", "claim", "define")):
            return None
        data = numbers_given(tree)
        asks = {name: ask for name, ask in tree.get("ask", {}).items()
                if isinstance(ask, str) and "@" not in ask and not any(sign in ask for sign in "<>=+*/")
                and not has_word(ask, "max", "min", "period", "stable", "stability", "growth_rate", "frequencies", "eigenvalues",
                                 "modes", "touching",
                                 "taut")}
        if not data or not asks:
            return None
        name, ask = random.choice(sorted(data)), random.choice(sorted(asks))
        first = program.solve(statement, keep=True)
        if first.fault or not first.document or len(first.document["solutions"]) != 1:
            return [Find(self.name, "fault", first.fault, statement)] if first.fault else None
        answer = first.document["solutions"][0]["answers"][ask]
        if state(answer) != "found" or not isinstance(answer["si"], float | int) or isinstance(answer["si"], bool):
            return None
        value, unit = data[name]
        other = program.solve(statement, {name: f"{float(value) * 1.01!r} {unit.text}"})
        if not other.document or not answer["si"]:
            return None
        moved = other.document["solutions"][0]["answers"][ask].get("si")
        if not isinstance(moved, float | int) or abs(moved / answer["si"] - 1) < 0.01 * self.least_slope:
            return None
        varied = self.with_fact(statement, name, float(value), unit, asks[ask], answer)
        if varied is None:
            return None
        second = program.solve(varied)
        if second.fault:
            return [Find(self.name, "fault", second.fault, statement, varied)]
        if second.code == 2 or not second.document:
            lost = "no values" in second.message or "cannot all hold" in second.message or "one more fact" in second.message
            return [Find(self.name, "lost", second.message, statement, varied)] if lost else None
        wanted = float(value) * si_factor(unit)
        roots = [solution["unknowns"].get(name, {}).get("si") for solution in second.document["solutions"]]
        if any(root is not None and same(root, wanted, self.relative) for root in roots):
            return []
        reasons = [a.get("reason") for s in second.document["solutions"] for a in s["answers"].values() if a.get("reason")]
        return [Find(self.name, f"{ask}: lost", f"{name} = {wanted} is not among the roots {roots} {reasons[:1]}",
                     statement, varied)]

    @staticmethod
    def with_fact(statement, name, value, unit, quantity, answer):
        tree = statement.copy().tree
        del tree["given"][name]
        low, high = sorted((0.6 * value, 1.7 * value))
        tree["find"] = {name: unit.text}
        tree["where"] = tree.get("where", []) + [f"{low!r} {unit.text} < {name} < {high!r} {unit.text}"]
        fact = {quantity: f"{answer['value']!r} {answer['unit']}".strip()}
        instants = tree.get("instants")
        if instants is None:
            tree["facts"] = {**tree.get("facts", {}), **fact}
        elif len(instants) == 1 and isinstance(next(iter(instants.values())), dict):
            instant = next(iter(instants))
            if quantity in instants[instant] or instant in ("before", "after"):
                return None
            tree["instants"] = {instant: {**instants[instant], **fact}}
        else:
            return None
        tree["ask"] = {"found": name}
        return statement.with_tree(tree)
