#!/usr/bin/env python3
"""The hunt itself: faults are planted in answers and must be found, and without them nothing is.

usage: hunt_test.py PROGRAM
"""
import json
import pathlib
import random
import signal
import stat
import subprocess
import sys
import tempfile
import textwrap
import time
import unittest
import zlib

HERE = pathlib.Path(__file__).resolve().parent
# Folders of compiled modules have no place among the sources.
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))
import compare  # noqa: E402
import relations  # noqa: E402
import report  # noqa: E402
import statements  # noqa: E402
from all_relations import RELATIONS  # noqa: E402
from language import UNITS, number_text, parse_unit, text_of, tokens_of  # noqa: E402
from random_statements import made_statement  # noqa: E402
from relations import si_factor  # noqa: E402
from runner import Program, Run  # noqa: E402
from shrink import shrunk  # noqa: E402

PROGRAM = sys.argv[1]
ROOT = HERE.parents[1]
EXAMPLES = statements.examples(ROOT)
# A planted fault shows in every second document; so many tries miss it once in a million.
TRIES = 20


def changed_first_number(node, change):
    """Changes the first number that is not zero. Returns whether there was one."""
    if isinstance(node, dict):
        return any(changed_first_number(node[key], change) for key in node if key in ("si", "answers", "table", "columns")
                   or isinstance(node[key], dict)) if "si" not in node else changed_si(node, change)
    if isinstance(node, list):
        return any(changed_first_number(item, change) for item in node)
    return False


def changed_si(node, change):
    def walk(value):
        if isinstance(value, list):
            return [walk(item) for item in value]
        if isinstance(value, float | int) and not isinstance(value, bool) and value and not walk.done:
            walk.done = True
            return change(value)
        return value

    walk.done = False
    node["si"] = walk(node["si"])
    return walk.done


class Faulty(Program):
    """The program, but for a fault in the documents of some statements."""

    fault = staticmethod(lambda document: None)
    always = False

    def wrong(self, text):
        """Whether a statement is one of those with the fault: as good as by chance, and the same each time."""
        return self.always or zlib.crc32(text.encode()) % 2

    honest = {}  # runs of the program itself, which the tests share

    def run(self, statement, values):
        key = (statement.text(), tuple(sorted(values.items())))
        if key not in self.honest:
            self.honest[key] = super().run(statement, values)
        run = self.honest[key]
        if run.document and self.wrong(statement.text()):
            document = json.loads(json.dumps(run.document))
            self.fault(document)
            return Run(run.code, document, run.message, self.fault_of(document))
        return run


def found_with(relation, fault, seed=1, always=False):
    """The finds of one relation on a program with a fault, until there is one."""
    program = Faulty(PROGRAM)
    program.fault, program.always = fault, always
    draw = random.Random(seed)
    tried = 0
    while tried < TRIES:
        statement = statement_for(relation, draw)
        finds = relation.hold(program, statement, random.Random(draw.randrange(2**32)))
        tried += finds is not None
        if finds:
            return finds
    return []


def statement_for(relation, draw):
    if hasattr(relation, "make"):
        return relation.make(draw)
    return made_statement(draw) if draw.random() < 0.3 else draw.choice(EXAMPLES)


# How much an answer may be off before these relations must notice; others notice 1e-5 of it.
COARSE = {"massless": 0.01, "growth": 2.0}


def scaled(document, by=1e-5):
    for solution in document["solutions"]:
        for answer in [*solution["answers"].values(), *solution["unknowns"].values()]:
            changed_first_number(answer, lambda value: value * (1 + by))


def negated(document):
    for solution in document["solutions"]:
        for answer in [*solution["answers"].values(), *solution["unknowns"].values()]:
            changed_first_number(answer, lambda value: -value)


class PlantedFaults(unittest.TestCase):
    def test_every_relation_finds_a_wrong_digit(self):
        for relation in RELATIONS.values():
            with self.subTest(relation.name):
                finds = found_with(relation, lambda document: scaled(document, COARSE.get(relation.name, 1e-5)))
                self.assertTrue(finds, f"{relation.name} finds nothing")

    def test_every_relation_finds_a_wrong_sign(self):
        for relation in RELATIONS.values():
            with self.subTest(relation.name):
                self.assertTrue(found_with(relation, negated), f"{relation.name} finds nothing")

    def test_a_root_that_is_lost(self):
        statement = next(s for s in EXAMPLES if s.name.startswith("docs") and "steady precession" in s.tree["title"])
        program = Faulty(PROGRAM)
        program.fault = lambda document: document["solutions"].pop()
        finds = []
        for seed in range(TRIES):
            finds += RELATIONS["order"].hold(program, statement, random.Random(seed)) or []
        self.assertIn("solutions", {find.kind for find in finds})

    def test_a_question_that_is_no_longer_answered(self):
        def refused(document):
            for solution in document["solutions"]:
                for answer in solution["answers"].values():
                    answer.clear()
                    answer.update({"ask": "x", "refused": True, "reason": "it is refused"})

        self.assertTrue(found_with(RELATIONS["units"], refused))

    def test_the_words_of_a_fault_are_one(self):
        def confesses(document):
            for solution in document["solutions"]:
                for answer in solution["answers"].values():
                    answer.clear()
                    answer.update({"ask": "x", "refused": True,
                                   "reason": "the independent check with particles does not confirm it"})

        finds = found_with(RELATIONS["units"], confesses, always=True)
        self.assertEqual([find.kind for find in finds], ["fault"])

    def test_a_document_that_is_none(self):
        def unlike(document):
            document["solutions"].append({"answers": 3})

        finds = found_with(RELATIONS["names"], unlike, always=True)
        self.assertIn("its schema refuses the document", finds[0].words)


class PlantedEnds(unittest.TestCase):
    """The program replaced by one that misbehaves."""

    def program(self, lines):
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(lambda: [path.unlink() for path in folder.iterdir()] and folder.rmdir())
        script = folder / "program"
        script.write_text(f"#!{sys.executable}\nimport os, subprocess, sys\nif sys.argv[1] == 'schema':\n"
                          f"    sys.exit(subprocess.run([{PROGRAM!r}] + sys.argv[1:]).returncode)\n" + textwrap.dedent(lines))
        script.chmod(script.stat().st_mode | stat.S_IXUSR)
        return Program(script)

    def fault(self, lines):
        return self.program(lines).solve(EXAMPLES[0]).fault

    def test_exit_codes_and_signals(self):
        self.assertEqual(self.fault("sys.exit(3)"), "it ends with exit code 3")
        self.assertEqual(self.fault("os.kill(os.getpid(), 11)"), "it ends by signal 11")
        self.assertEqual(self.fault("pass"), "it says nothing")

    def test_what_is_no_number(self):
        document = '{"poinsot": "1.0.0", "file": "x", "title": "", "solutions": [%s], "warnings": []}'
        self.assertIn("NaN", self.fault(f"print('{document % 'NaN'}')"))
        self.assertIn("Infinity", self.fault(f"print('{document % '-Infinity'}')"))
        one = '{"unknowns": {}, "checks": {}, "answers": {"a": {"ask": "x", "value": 1e999, "unit": "", "si": 1e999}}}'
        self.assertIn("finite", self.fault(f"print('{document % one}')"))

    def test_time_and_memory(self):
        import runner
        kept = runner.SECONDS, runner.MEMORY
        try:
            runner.SECONDS = 1
            self.assertIn("more than 1 s", self.fault("while True: pass"))
            runner.SECONDS, runner.MEMORY = kept[0], 50 * 2**20
            self.assertIn("1 GiB", self.fault("a = bytearray(60 * 2**20)\nfor i in range(0, len(a), 4096): a[i] = 1"))
        finally:
            runner.SECONDS, runner.MEMORY = kept


class Writing(unittest.TestCase):
    """Statements are read and written without a change in meaning."""

    def test_units_are_those_of_the_program(self):
        asks = {f"u{i}": f"mass(b)*(1 {unit})" for i, unit in enumerate(UNITS)}
        tree = {"points": {"O": ["0", "0", "0"]}, "bodies": {"b": {"particle": "O", "mass": "1 kg"}},
                "gravity": "none", "ask": asks}
        run = Program(PROGRAM).solve(statements.Statement("units", tree))
        self.assertEqual(run.code, 0, run.message)
        answers = run.document["solutions"][0]["answers"]
        for index, unit in enumerate(UNITS):
            with self.subTest(unit):
                self.assertAlmostEqual(answers[f"u{index}"]["si"] / si_factor(parse_unit(unit)), 1, 14)

    def test_expressions_are_written_as_they_are_read(self):
        for text in ("5/8 oz/ft * r^2", "2 m * x", "a' @ 2 s", "velocity(A of b relative to c).x", "-1/2*m*L", "3*r/2 m"):
            self.assertEqual(text_of(tokens_of(text)), text)
        literal = tokens_of("5/8 oz/ft * r")[0]
        self.assertEqual((literal.value.numerator, literal.value.denominator, literal.unit.text), (5, 8, "oz/ft"))

    def test_numbers_are_exact_or_have_17_digits(self):
        from fractions import Fraction
        for text in ("1", "0.1", "1e-6", "123456.789", "1e9", "-2.5"):
            self.assertEqual(Fraction(number_text(Fraction(text))), Fraction(text))
        self.assertEqual(number_text(Fraction(1, 3)), "1/3")

    def test_yaml_is_read_back(self):
        for statement in EXAMPLES:
            with self.subTest(statement.name):
                again = statements.from_text(statement.name, statement.text())
                self.assertEqual(again.tree, statement.tree)
                self.assertEqual(list(again.tree), list(statement.tree))

    def test_words_of_the_language_are_names_where_names_are_given(self):
        tree = {"ask": {"stays": "mass(b)"}, "contacts": {"C": {"stays": "'true'"}}}
        self.assertEqual(statements.role(("ask", "stays")), "expression")
        self.assertEqual(statements.role(("situations", "s", "ask", "hole")), "expression")
        self.assertEqual(statements.role(("contacts", "C", "stays")), "text")
        changed = statements.mapped_expressions(tree, lambda tokens, path: tokens_of("mass(c)"))
        self.assertEqual(changed, {"ask": {"stays": "mass(c)"}, "contacts": {"C": {"stays": "'true'"}}})

    def test_formulas_with_powers_of_e_and_tables_of_one_row_have_values(self):
        self.assertAlmostEqual(compare.number_of("T*exp(2*a)/ln(b)", {"T": 3, "a": 0.5, "b": 2.718281828459045}),
                               3 * 2.718281828459045, 12)
        row = {"columns": [{"name": "phase", "si": [0.5]}, {"name": "amplitude", "si": [2]}]}
        self.assertEqual(compare.value_of({"table": row}, {}), [2, 0.5])
        row["columns"][0]["si"] = [0.5, 0.6]
        self.assertEqual(compare.value_of({"table": row}, {}), [[2], [0.5, 0.6]])

    def test_the_same_seed_makes_the_same(self):
        texts = [made_statement(random.Random(7)).text() for _ in range(2)]
        self.assertEqual(*texts)


class Shrinking(unittest.TestCase):
    def test_what_does_not_matter_goes(self):
        program = Faulty(PROGRAM)
        program.fault = scaled
        program.wrong = lambda text: " kg" not in text
        relation, seed = RELATIONS["units"], 0
        statement = next(s for s in EXAMPLES if s.tree["title"] == "Quantities of a turning bar and a bob on a wire")
        while not (finds := relation.hold(program, statement, random.Random(seed))):
            seed += 1
        small = shrunk(relation, program, finds[0], seed)
        self.assertLess(len(small.statement.text()), len(statement.text()) / 2)
        with tempfile.TemporaryDirectory() as folder:
            path = report.keep(small, pathlib.Path(folder), 1, "the command")
            text = path.read_text()
            self.assertIn("# To repeat it: the command", text)
            self.assertTrue(pathlib.Path(str(path).replace(".yaml", "-varied.yaml")).is_file())
            result = subprocess.run([PROGRAM, "solve", "--json", str(path)], capture_output=True, check=False, timeout=60)
            self.assertIn(result.returncode, (0, 1))


class CommandLine(unittest.TestCase):
    def hunt(self, *arguments):
        return [sys.executable, str(HERE / "hunt.py"), PROGRAM, "--kept", self.folder.name, *arguments]

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def test_it_is_the_same_each_time(self):
        runs = [subprocess.run(self.hunt("--statements", "6", "--seed", "3", "--relation", "order"), text=True,
                               capture_output=True, check=False, timeout=100) for _ in range(2)]
        self.assertEqual(runs[0].stdout, runs[1].stdout)
        self.assertEqual(runs[0].returncode, 0, runs[0].stdout + runs[0].stderr)
        self.assertIn("order        6", runs[0].stdout)
        self.assertIn("seed 3", runs[0].stdout)

    def test_an_interrupt_ends_it_with_what_was_found(self):
        process = subprocess.Popen(self.hunt("--seconds", "100", "--seed", "3"), text=True, stdout=subprocess.PIPE)
        self.assertIn("seed 3", process.stdout.readline())
        time.sleep(1.5)
        process.send_signal(signal.SIGINT)
        rest, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("Statements for each relation", rest)


class ConditionsOfOneAnswer(unittest.TestCase):
    """What is told of one answer alone says nothing of the others, and where it does not hold the answer says nothing."""

    solution = {"answers": {"height": {"si": 0.0}, "b": {"si": 1.0}}, "assumptions": ["9.5 - k > 0 for 'height'", "m > 0"],
                "notes": ["height and c by trials of k, with numbers of 7 digits"]}

    def test_holds_of_it(self):
        self.assertEqual(relations.answers_elsewhere(self.solution, {"k": 10.2, "m": 1}), {"height"})
        self.assertEqual(relations.answers_elsewhere(self.solution, {"k": 9.2, "m": 1}), set())

    def test_leaves_the_others(self):
        self.assertTrue(relations.conditions_hold(self.solution, {"k": 10.2, "m": 1}))
        self.assertFalse(relations.conditions_hold(self.solution, {"k": 9.2, "m": -1}))

    def test_hides_no_wrong_answer(self):
        wrong = {**self.solution, "checks": {}, "answers": {"height": {"si": 5.0, "value": 5.0, "unit": "m"}, "b": {"si": 2.0, "value": 2.0, "unit": "m"}}}
        right = {**wrong, "answers": {"height": {"si": 4.0, "value": 4.0, "unit": "m"}, "b": {"si": 2.0, "value": 2.0, "unit": "m"}}}
        varied = relations.Varied(None)
        self.assertIsNone(relations.difference({"solutions": [right]}, {"solutions": [wrong]}, {"k": 10.2, "m": 1}, varied))
        self.assertIsNotNone(relations.difference({"solutions": [right]}, {"solutions": [wrong]}, {"k": 9.2, "m": 1}, varied))

    def test_numbers_by_trials_have_the_digits_told(self):
        self.assertEqual(relations.digits_told(self.solution, "height"), 1e-6)
        self.assertEqual(relations.digits_told(self.solution, "b"), 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
