"""Makes a statement in which a relation fails small: entries are left out as long as it still fails in the same way."""
import random
import re
from copy import deepcopy

# Each try runs the program twice; a statement has some dozens of entries, many of which cannot go by themselves.
TRIES = 150
# What takes seconds to solve is not made small for hours: a find is one before it is small.
SECONDS = 10


def paths_of(node, path=()):
    """All paths to entries, larger parts first."""
    if isinstance(node, dict):
        for key, value in node.items():
            yield path + (key,)
        for key, value in node.items():
            yield from paths_of(value, path + (key,))


def without(tree, path):
    tree = deepcopy(tree)
    node = tree
    for key in path[:-1]:
        node = node[key]
    del node[path[-1]]
    if not node and len(path) == 2:
        del tree[path[0]]
    return tree


def shrunk(relation, program, find, seed):
    """A smaller find of the same relation and kind. Every try draws what it draws from the same seed."""
    tries, smaller, end = 0, True, program.seconds + SECONDS
    find = question_alone(relation, program, find, seed)
    statement = find.statement
    while smaller and tries < TRIES and program.seconds < end:
        smaller = False
        for path in list(paths_of(statement.tree)):
            if tries >= TRIES or program.seconds > end:
                break
            try:
                tree = without(statement.tree, path)
            except KeyError:
                continue
            tries += 1
            again = tried(relation, program, find, tree, seed)
            if again:
                statement, smaller, find = again.statement, True, again
    return find


def tried(relation, program, find, tree, seed):
    """The same find in another tree, or None."""
    settings = {name: text for name, text in find.statement.settings.items() if name in tree.get("letters", {})}
    candidate = find.statement.with_tree(tree, settings)
    try:
        finds = relation.hold(program, candidate, random.Random(seed)) or []
    except (KeyError, AttributeError, TypeError):
        return None  # of what was left out the relation needs something
    return next((one for one in finds if same_kind(one, find)), None)


def question_alone(relation, program, find, seed):
    """The find with no other question than the one that it is about, if it is still one."""
    name, questions = find.kind.split(":")[0], find.statement.tree.get("ask", {})
    if name not in questions or len(questions) == 1:
        return find
    tree = deepcopy(find.statement.tree)
    tree["ask"] = {name: tree["ask"][name]}
    tree.pop("claim", None)
    return tried(relation, program, find, tree, seed) or find


def same_kind(one, other):
    if one.relation != other.relation or one.kind.split(":")[-1] != other.kind.split(":")[-1]:
        return False
    return one.kind != "refused" or message(one.words) == message(other.words)


def message(words):
    """A message without its place and names."""
    return re.sub(r"^\S+: error: |'[^']*'|[\d.]+", "", words)
