"""Relations of writing: another order of keys, and other names."""
from language import PREPOSITIONS, UNITS
from relations import NotApplicable, Relation, Varied, letter_values
from statements import ORDERED, mapped_expressions, situations_of

# Maps whose keys are names that the file gives.
NAMED = ("given", "letters", "find", "points", "directions", "frames", "bodies", "joints", "contacts", "cords",
         "belts", "chains", "springs", "loads", "impulses", "impacts", "strikes", "excitations", "define", "choose", "situations", "ask", "claim")


class Order(Relation):
    name = "order"
    changes = "the keys of every map stand in another order; answers stay"

    def vary(self, statement, random):
        def shuffled(node, key=None):
            if isinstance(node, list):
                return [shuffled(item) for item in node]
            if not isinstance(node, dict):
                return node
            items = list(node.items())
            if key not in ORDERED:
                random.shuffle(items)
            return {k: shuffled(v, k) for k, v in items}

        return Varied(statement.with_tree(shuffled(statement.tree)))


class Names(Relation):
    name = "names"
    changes = "bodies, points, letters and all else that the file names have other names; answers stay"

    def vary(self, statement, random):
        names = given_names(statement.tree) - reserved(statement.tree)
        if not names:
            raise NotApplicable
        # New names differ in their alphabetical order, in length and in case.
        numbers = random.sample(range(100, 1000), len(names))
        other = {name: random.choice(["a", "Z", "q_", "beam", "N"]) + str(number)
                 for name, number in zip(sorted(names), numbers)}

        def renamed(tokens, path):
            for index, token in enumerate(tokens):
                if token.kind != "name":
                    continue
                word = token.text.rstrip("'")
                component = index and tokens[index - 1].text == "." and not tokens[index - 1].blank
                stage = index > 1 and component and index > 2 and tokens[index - 3].text == "@"
                call = index + 1 < len(tokens) and tokens[index + 1].text == "("
                if word in other and not call and (not component or stage):
                    token.text = other[word] + token.text[len(word):]
            return tokens

        tree = with_keys(mapped_expressions(statement.tree, renamed), other)
        settings = {other.get(name, name): text for name, text in statement.settings.items()}
        letters = {other.get(name, name): value for name, value in letter_values(statement).items()}
        varied = statement.with_tree(tree, settings)
        return Varied(varied, lambda name, value, answer: renamed_words(value, other), letters, answer_name=lambda name: other.get(name, name))


def renamed_words(value, other):
    """An answer that consists of names, with the other names."""
    if isinstance(value, list):
        return [renamed_words(item, other) for item in value]
    return other.get(value, value) if isinstance(value, str) else value


def with_keys(tree, other):
    """The tree with other keys in the maps that hold names."""
    made = {}
    for key, value in tree.items():
        if key in NAMED + ("stages", "instants") and isinstance(value, dict):
            value = {other.get(k, k): v for k, v in value.items()}
            if key == "situations":
                value = {k: with_keys(v, other) for k, v in value.items()}
        made[key] = value
        if key in ("bodies", "joints") and isinstance(value, dict):
            for name, item in value.items():
                for inner in ("added", "parts", "supports"):
                    if isinstance(item, dict) and isinstance(item.get(inner), dict):
                        item[inner] = {other.get(k, k): v for k, v in item[inner].items()}
        if key == "steady" and isinstance(value, dict) and isinstance(value.get("spins"), dict):
            value["spins"] = {other.get(k, k): v for k, v in value["spins"].items()}
    return made


def given_names(tree):
    names = set()
    for situation in situations_of(tree):
        for key in NAMED:
            if isinstance(situation.get(key), dict):
                names.update(situation[key])
        for bodies in (situation.get("bodies", {}), situation.get("joints", {})):
            for body in bodies.values():
                for inner in ("added", "parts", "supports"):
                    if isinstance(body, dict) and isinstance(body.get(inner), dict):
                        names.update(body[inner])
    return names


def reserved(tree):
    """Words that mean something else as well, here or in the language: these keep their names."""
    words = set(UNITS) | PREPOSITIONS | {"g", "pi", "time", "ground", "system", "rest", "none", "any", "push", "total",
                                         "now", "start", "before", "after", "x", "y", "z", "xy", "yz", "zx",
                                         "turn", "slide", "slide1", "slide2", "first", "second", "right", "left", "both"}
    for situation in situations_of(tree):
        words.update(situation.get("axes", []) if isinstance(situation.get("axes"), list) else [])
    words.update(keys_of_language(tree))
    return words


def keys_of_language(tree):
    """Keys that stand where the language has its own words, so that a name like one of them is not changed."""
    found = set()

    def walk(node, named):
        if isinstance(node, dict):
            for key, value in node.items():
                if not named:
                    found.add(key)
                walk(value, key in NAMED + ("stages", "instants", "added", "parts", "supports", "spins", "facts"))
        elif isinstance(node, list):
            for item in node:
                walk(item, False)

    walk(tree, False)
    return found
