#!/usr/bin/env python3
"""The command line as other programs see it: exit codes, what goes to which stream, and documents that keep the schema.

usage: command_line_test.py PROGRAM SOURCE_FOLDER
"""
import fcntl
import json
import os
import pathlib
import pty
import re
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unittest

import jsonschema
import yaml

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
GOLDEN = SOURCE / "tests" / "document" / "golden"
EXAMPLES = sorted((SOURCE / "examples" / "textbook").glob("*.yaml"))


# Two rods that swing for hours: following them takes minutes.
LONG_MOTION = """title: A long motion
points: {O: [0, 0, 0], P: [1 m, 0, 0], Q: [2 m, 0, 0]}
bodies: {one: {rod: [O, P], mass: 2 kg}, two: {rod: [P, Q], mass: 1 kg}}
joints: {pin: {revolute: z, at: O, to: one, angle: a}, knee: {revolute: z, at: P, from: one, to: two, angle: b}}
gravity: -y
instants: {start: {a: 10 deg, a': 0, b: 40 deg, b': 0}}
ask: {m: mass(one), x: {table: {t: time, a: a}, over: {time: 0 s .. 200000 s by 1000 s}}}
"""
LONG_EXPECT = "expect: {m: {value: 2, unit: kg}, x: {columns: {t: [0], a: [0]}}}\n"


def processor_seconds(process):
    """What the process has used of the processor until now."""
    fields = pathlib.Path(f"/proc/{process}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def run(*arguments, **options):
    options = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
    if "input" in options:
        del options["stdin"]
    return subprocess.run([PROGRAM, *arguments], text=True, timeout=120, check=False, **options)


def commands():
    """The commands as the help lists them."""
    listed = run("--help").stdout.partition("Subcommands:\n")[2]
    return re.findall(r"^  ([a-z]+) ", listed, flags=re.MULTILINE)


class Usage(unittest.TestCase):
    def test_version_is_that_of_the_file(self):
        result = run("--version")
        self.assertEqual((result.returncode, result.stdout, result.stderr),
                         (0, "poinsot " + (SOURCE / "VERSION").read_text(), ""))

    def test_help_goes_to_standard_output(self):
        for arguments in (["--help"], ["solve", "--help"], ["check", "-h"]):
            result = run(*arguments)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn("Usage: poinsot", result.stdout)

    def assert_wrong_usage(self, arguments, message, command="poinsot"):
        result = run(*arguments)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(result.stderr, f"poinsot: {message}\nTry '{command} --help'.\n")

    def test_without_arguments_the_help_goes_to_standard_error(self):
        result = run()
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("Usage: poinsot", result.stderr)

    def test_unknown_command_gets_the_nearest(self):
        self.assert_wrong_usage(
            ["slove", "a.yaml"],
            f"unknown command 'slove': expected one of {', '.join(commands())} (did you mean 'solve'?)")

    def test_unknown_command_far_from_all(self):
        self.assert_wrong_usage(
            ["frobnicate"],
            f"unknown command 'frobnicate': expected one of {', '.join(commands())}")

    def test_words_of_other_programs_get_the_call(self):
        for word, call in {"explain": "solve --explain FILE", "draw": "figure FILE -o OUT.svg",
                           "validate": "check FILE", "a.yml": "solve a.yml"}.items():
            self.assert_wrong_usage(
                [word], f"unknown command '{word}': expected one of {', '.join(commands())} (write poinsot {call})")

    def test_options_before_the_command(self):
        self.assert_wrong_usage(
            ["-o", "a.svg", "figure", "a.yaml"],
            "option '-o' stands before the command (write it behind: poinsot figure FILE -o ...)", "poinsot figure")

    def test_flags_take_no_value(self):
        self.assert_wrong_usage(["solve", "a.yaml", "--json=all"], "--json takes no value", "poinsot solve")

    def test_files_of_nearly_the_name(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ["pendulum.yaml", "top.yaml"]:
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write("title: nothing\n")
            for word, hint in {"pendulm.yaml": "did you mean '{}'?", "pendulum": "did you mean '{}'?",
                               "bicycle.yaml": "check the path"}.items():
                path = os.path.join(folder, word)
                result = run("solve", path)
                self.assertEqual(result.returncode, 2)
                meant = hint.format(os.path.join(folder, "pendulum.yaml"))
                self.assertEqual(result.stderr, f"{path}:1:1: error: there is no such file ({meant})\n")

    def test_unknown_option_gets_the_nearest(self):
        self.assert_wrong_usage(["solve", "a.yaml", "--jsno"],
                                "unknown option '--jsno' of solve (did you mean '--json'?)", "poinsot solve")
        self.assert_wrong_usage(["--verson"], "unknown option '--verson' (did you mean '--version'?)")

    def test_missing_file(self):
        self.assert_wrong_usage(["solve"], "FILE is required", "poinsot solve")
        self.assert_wrong_usage(["check"], "PATH is required", "poinsot check")

    def test_argument_that_nothing_takes(self):
        self.assert_wrong_usage(["schema", "a.yaml"], "schema takes no 'a.yaml'", "poinsot schema")

    def test_setting_of_another_form(self):
        for setting in ("m", "=3", "m="):
            self.assert_wrong_usage(
                ["solve", "a.yaml", "--set", setting],
                f"--set: '{setting}' should be NAME=VALUE, for example --set 'm=3 kg'", "poinsot solve")


class WrongInput(unittest.TestCase):
    def test_file_that_does_not_exist(self):
        for command in ("solve", "check"):
            result = run(command, "no-such-file.yaml")
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertRegex(result.stderr, r"^no-such-file\.yaml(:1:1)?: error: ")
            self.assertEqual(result.stdout, "")

    def test_place_of_the_fault_in_standard_input(self):
        for command in (["solve"], ["solve", "--json"]):
            result = run(*command, "-", input="title: Top\ntitle: Top\n")
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertRegex(result.stderr, r"^-:2:1: error: ")

    def test_control_sequences_of_a_file_do_not_reach_the_terminal(self):
        result = run("solve", "-", input='title: Top\n"bod\\eies": {}\n')
        self.assertEqual(result.returncode, 2)
        self.assertNotIn("\x1b", result.stderr)

    def test_a_wrong_file_does_not_keep_the_next_from_being_solved(self):
        example = str(EXAMPLES[0])
        result = run("solve", "--json", "no-such-file.yaml", example)
        self.assertEqual(result.returncode, 2)
        self.assertEqual([json.loads(line)["file"] for line in result.stdout.splitlines()], [example])


class Streams(unittest.TestCase):
    def test_full_device(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            result = run("schema", "--answer", stdout=full)
        self.assertEqual(result.returncode, 3)
        self.assertEqual(result.stderr, "poinsot: cannot write to standard output: No space left on device\n")

    def test_closed_standard_output(self):
        result = subprocess.run(["sh", "-c", '"$0" schema --answer >&-', PROGRAM], stderr=subprocess.PIPE, text=True,
                                timeout=120, check=False)
        self.assertEqual(result.returncode, 3)
        self.assertEqual(result.stderr, "poinsot: cannot write to standard output: Bad file descriptor\n")

    def test_reader_that_goes_away(self):
        reading, writing = os.pipe()
        os.close(reading)
        try:
            result = run("schema", "--answer", stdout=writing)
        finally:
            os.close(writing)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_interrupt(self):
        # More than a pipe holds is taken only by a program that is reading; it then waits for the rest.
        with subprocess.Popen([PROGRAM, "solve", "-"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE) as process:
            process.stdin.write(b"# no end\n" * 20000)
            process.stdin.flush()
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.stderr.read(), b"\npoinsot: interrupted\n")
            self.assertEqual(process.wait(timeout=60), 130)

    def interrupted(self, *arguments, text):
        """Exit code and streams of a program that is interrupted while it works at a file with the text."""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "long.yaml"
            file.write_text(text, encoding="utf-8")
            with subprocess.Popen([PROGRAM, *arguments, str(file)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True) as process:
                # The key is to come when the file has been read, which takes milliseconds, and before the answer is
                # found, which takes minutes.
                while processor_seconds(process.pid) < 0.3:
                    self.assertIsNone(process.poll(), "the program ended before it was interrupted")
                    time.sleep(0.01)
                process.send_signal(signal.SIGINT)
                answer, messages = process.communicate(timeout=60)
                return process.returncode, answer, messages

    def test_interrupted_work_shows_what_was_found(self):
        code, answer, messages = self.interrupted("solve", text=LONG_MOTION)
        self.assertEqual(code, 130)
        self.assertTrue(answer.startswith("A long motion"), answer)
        self.assertTrue(messages.endswith("poinsot: interrupted\n"), messages)
        code, answer, messages = self.interrupted("solve", "--json", text=LONG_MOTION)
        self.assertEqual((code, json.loads(answer)["ended"]), (130, "interrupted"))
        code, answer, messages = self.interrupted("check", text=LONG_MOTION + LONG_EXPECT)
        self.assertEqual((code, answer, messages), (130, "0 passed, 0 failed\n", "poinsot: interrupted\n"))


class Documents(unittest.TestCase):
    def setUp(self):
        result = run("schema", "--answer")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        schema = json.loads(result.stdout)
        jsonschema.Draft202012Validator.check_schema(schema)
        self.validator = jsonschema.Draft202012Validator(schema)

    def test_golden_documents_keep_the_schema(self):
        documents = sorted(GOLDEN.glob("*.json"))
        self.assertTrue(documents)
        for document in documents:
            self.validator.validate(json.loads(document.read_text(encoding="utf-8")))

    def test_schema_refuses_what_is_no_answer_document(self):
        good = (GOLDEN / "every_state.json").read_text(encoding="utf-8")
        for old, new in (('"solutions"', '"solution"'), ('"determined":false', '"determined":true'),
                         ('"value":null', '"value":1.0'), ('"si":null,"letters":["m","n"],', '"si":null,'),
                         ('"refused":true,', ''), ('"value":5.548195,', ''), ('"ask":', '"asked":'),
                         ('"poinsot":"0', '"poinsot":"v0'), ('"newton_euler":0.03', '"newton_euler":"0.03"')):
            self.assertIn(old, good)
            self.assertFalse(self.validator.is_valid(json.loads(good.replace(old, new, 1))), f"{old} -> {new}")

    def test_documents_of_the_examples_keep_the_schema_with_their_scenes(self):
        self.assertTrue(EXAMPLES)
        result = run("solve", "--json", "--scene", *map(str, EXAMPLES))
        self.assertIn(result.returncode, (0, 1), result.stderr)
        lines = result.stdout.splitlines()
        self.assertEqual(len(lines), len(EXAMPLES))
        for line, example in zip(lines, EXAMPLES):
            self.assertNotRegex(line, r"\b(NaN|Infinity)\b")
            document = json.loads(line)
            self.validator.validate(document)
            self.assertEqual(document["file"], str(example))
            for solution in document["solutions"]:
                self.assertTrue(solution["scene"]["bodies"], example)

    def test_scenes_keep_the_schema(self):
        # A motion, a blow, cones, situations, bodies of which the inertia alone is known, springs, a view.
        names = ("textbook/18.C6", "textbook/sp18.1", "textbook/sp18.6", "textbook/18.013", "textbook/18.131",
                 "published/gyrocompass", "published/hooke-joint", "published/nutation-damper", "published/heavy-top")
        files = [str(SOURCE / "examples" / f"{name}.yaml") for name in names]
        result = run("solve", "--json", "--scene", *files)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        scenes = []
        for line in result.stdout.splitlines():
            document = json.loads(line)
            self.validator.validate(document)
            for solution in document["solutions"]:
                scenes += [solution["scene"], *solution.get("other_scenes", [])]
        self.assertTrue(any("motion" in scene and scene["motion"]["arrows"] for scene in scenes))
        self.assertTrue(any(scene["cones"] for scene in scenes))
        self.assertTrue(any(shape["stand_in"] for scene in scenes for body in scene["bodies"]
                            for shape in body["shapes"]))
        self.assertEqual({scene["situation"] for scene in scenes if scene["situation"]} >=
                         {"free", "turning", "turning_about_center"}, True)
        broken = json.loads(result.stdout.splitlines()[0])
        del broken["solutions"][0]["scene"]["bodies"][0]["pose"]
        self.assertFalse(self.validator.is_valid(broken))

    def test_worked_solutions_are_markdown_and_a_field_of_the_document(self):
        for example in (EXAMPLES[0], SOURCE / "examples" / "textbook" / "18.105.yaml"):
            text = run("solve", "--explain", str(example))
            self.assertEqual((text.returncode, text.stderr), (0, ""))
            for heading in ("# ", "## Model", "## Principle", "## Answers"):
                self.assertRegex(text.stdout, rf"(?m)^{heading}")
            document = json.loads(run("solve", "--explain", "--json", str(example)).stdout)
            self.validator.validate(document)
            self.assertEqual(document["solutions"][0]["explanation"], text.stdout)
            plain = json.loads(run("solve", "--json", str(example)).stdout)
            self.assertNotIn("explanation", plain["solutions"][0])

    def test_text_has_no_color_where_there_is_no_terminal(self):
        result = run("solve", str(EXAMPLES[0]), env={**os.environ, "TERM": "xterm"})
        self.assertNotIn("\x1b", result.stdout)
        self.assertTrue(result.stdout)


class ProblemFiles(unittest.TestCase):
    """poinsot schema: what editors are told of problem files."""

    class Loader(yaml.SafeLoader):
        """YAML 1.2, which knows true and false alone as truths: `angle: no` is a name."""

    Loader.yaml_implicit_resolvers = {
        letter: [one for one in resolvers if one[0] != "tag:yaml.org,2002:bool" or letter in "tf"]
        for letter, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()}

    def setUp(self):
        schema = json.loads(run("schema").stdout)
        jsonschema.Draft202012Validator.check_schema(schema)
        self.validator = jsonschema.Draft202012Validator(schema)

    def test_every_example_keeps_the_schema(self):
        files = sorted((SOURCE / "examples").glob("*/*.yaml"))
        self.assertGreater(len(files), 200)
        for file in files:
            problem = yaml.load(file.read_text(encoding="utf-8"), self.Loader)
            self.assertEqual([error.message for error in self.validator.iter_errors(problem)], [], file)

    def test_what_no_file_may_have_breaks_the_schema(self):
        for problem in ({"bodys": {}}, {"ask": {"a": {"off": "x"}}}, {"instants": {"now": 3.5, "then": True}}):
            self.assertFalse(self.validator.is_valid(problem), problem)


class Words(unittest.TestCase):
    def test_keys_functions_units_and_commands_are_explained(self):
        for word, expected in (("disk", "a thin disk"), ("angular_momentum", "angular_momentum(disk about G)"),
                               ("rpm", "0.1047197551 rad/s"), ("record", "Usage: poinsot record")):
            result = run("help", word)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertIn(expected, result.stdout)

    def test_every_word_has_its_help(self):
        words = run("help", "--words").stdout.split()
        self.assertGreater(len(words), 250)
        result = run("help", *words)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for word in words:
            self.assertRegex(result.stdout, rf"(?m)^{re.escape(word)}: ")
        # Links of the manual are words here.
        self.assertNotIn("](", result.stdout)

    def test_an_unknown_word_gets_the_nearest(self):
        result = run("help", "momentun")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(result.stderr, "poinsot: the language has no word 'momentun' (did you mean 'momentum'?)\n")

    def test_a_word_of_other_books_leads_to_the_word_here(self):
        result = run("help", "torque")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue(result.stdout.startswith("torque: no word of the language; here it is couple or couple("))

    def test_what_is_no_word_leads_to_those_that_speak_of_it(self):
        result = run("help", "blow")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue(result.stdout.startswith("blow: no word of the language, which speaks of it at\n    "))
        self.assertRegex(result.stdout, r"\n    impulse +a quantity")

    def test_an_example_is_a_problem_that_is_solved(self):
        text = run("help", "torus").stdout.partition("an example:\n")[2]
        result = run("solve", "-", input=re.sub(r"(?m)^    ", "", text))
        self.assertEqual((result.returncode, result.stderr), (0, ""))


class ShellTexts(unittest.TestCase):
    def options(self, command):
        return set(re.findall(r"--[a-z-]+", run(command, "--help").stdout))

    def test_completions_and_manual_name_every_command_and_option(self):
        texts = [run("completion", shell).stdout for shell in ("bash", "zsh", "fish")]
        texts.append(run("manual").stdout.replace("\\-", "-"))
        for text in texts:
            for command in commands():
                self.assertIn(command, text)
                for option in self.options(command) - {"--help"}:
                    self.assertIn(option.removeprefix("--"), text)

    def test_bash_completes(self):
        script = run("completion", "bash").stdout
        asked = ('COMP_WORDS=(poinsot solve --j); COMP_CWORD=2; _poinsot; echo "${COMPREPLY[@]}";'
                 'COMP_WORDS=(poinsot eq); COMP_CWORD=1; _poinsot; echo "${COMPREPLY[@]}"')
        result = subprocess.run(["bash", "-c", script + asked], text=True, stdout=subprocess.PIPE, check=True)
        self.assertEqual(result.stdout, "--json\nequations\n")

    def test_an_unknown_shell_is_refused(self):
        result = run("completion", "cmd")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("bash", result.stderr)


class Figures(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.output = pathlib.Path(self.folder.name) / "a.svg"

    def refused(self, *arguments):
        result = run("figure", str(EXAMPLES[0]), *arguments)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        return result.stderr

    def test_a_figure_is_written_once(self):
        result = run("figure", str(EXAMPLES[0]), "-o", str(self.output))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        drawn = self.output.read_text(encoding="utf-8")
        self.assertTrue(drawn.startswith("<svg "))
        self.assertIn("--force", self.refused("-o", str(self.output)))
        self.assertEqual(run("figure", str(EXAMPLES[0])).stdout, drawn)

    def test_what_is_not_there_is_told_with_what_is(self):
        self.assertIn("there are model", self.refused("--of", "modle"))
        self.assertIn("expected front", self.refused("--view", "sideways"))
        self.assertIn("has 1", self.refused("--solution", "2"))
        self.assertIn("should end in .svg", self.refused("-o", str(self.output.with_suffix(".png"))))
        self.assertIn("should end in .html", run("report", str(EXAMPLES[0]), "-o", str(self.output)).stderr)


class Galleries(unittest.TestCase):
    def test_a_gallery_tells_on_a_terminal_how_long_it_takes(self):
        text = EXAMPLES[0].read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as folder:
            problems, index = pathlib.Path(folder) / "problems", pathlib.Path(folder) / "pages" / "index.html"
            problems.mkdir()
            # The time left is told once a second has passed, which few pages take on a quick machine.
            for count in (25, 100, 400, 1600):
                for number in range(count):
                    (problems / f"{number}.yaml").write_text(text, encoding="utf-8")
                told = self.told_on_a_terminal("report", "--force", str(problems), "-o", str(index.parent))
                self.assertIn(f"1 of {count}  ", told)
                if re.search(rf"\d+ of {count}  \d+ s left  ", told):
                    return
            self.fail(f"no time left was told of {count} pages: {told[-2000:]}")

    def told_on_a_terminal(self, *arguments):
        terminal, side = pty.openpty()
        with subprocess.Popen([PROGRAM, *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=side) as process:
            os.close(side)
            told = b""
            try:
                while part := os.read(terminal, 65536):
                    told += part
            except OSError:  # so a terminal ends
                pass
            self.assertEqual(process.wait(timeout=60), 0)
        os.close(terminal)
        return told.decode()


class NarrowTerminals(unittest.TestCase):
    """What is printed where a terminal has few columns."""

    # Beside the sources: the path of a file is not broken.
    DISKS = "examples/mechanisms/planar-disks-that-collide.yaml"

    def printed(self, columns, *arguments):
        terminal, side = pty.openpty()
        fcntl.ioctl(side, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        with subprocess.Popen([os.path.abspath(PROGRAM), *arguments], stdin=subprocess.DEVNULL, stdout=side, stderr=side,
                              cwd=SOURCE, env={**os.environ, "NO_COLOR": "1"}) as process:
            os.close(side)
            text = b""
            try:
                while part := os.read(terminal, 65536):
                    text += part
            except OSError:  # so a terminal ends
                pass
            process.wait(timeout=60)
        os.close(terminal)
        return text.decode().replace("\r\n", "\n").splitlines()

    def test_no_line_is_longer_than_the_terminal_or_ends_in_blanks(self):
        for columns in (60, 80, 120):
            for arguments in (("solve", "--help"), ("--help",), ("help", "turns"), ("solve", self.DISKS)):
                lines = self.printed(columns, *arguments)
                self.assertGreater(len(lines), 5)
                for line in lines:
                    self.assertLessEqual(len(line), columns, (columns, arguments))
                    self.assertEqual(line, line.rstrip(), (columns, arguments))

    def test_values_are_not_torn(self):
        lines = self.printed(60, "solve", self.DISKS)
        self.assertIn("            (2.025, 1.16913) m/s  on x, y", lines)
        # What is asked with a vector shows the components that the file gives it.
        self.assertIn("[cos(b), sin(b)]", " ".join(line.strip() for line in lines))


class WorkedSolutions(unittest.TestCase):
    """poinsot solve --explain -o: the text with its figures beside it."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.output = pathlib.Path(self.folder.name) / "worked out (1).md"

    def test_figures_stand_where_they_belong(self):
        for example, places in (("18.105", {"model": "Model", "free-body": "Component equations", "answers": "Answers"}),
                                ("18.030", {"model": "Model", "impulse": "Impulse and momentum"})):
            file = str(SOURCE / "examples" / "textbook" / f"{example}.yaml")
            result = run("solve", "--explain", file, "-o", str(self.output), "--force")
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            text = self.output.read_text(encoding="utf-8")
            heading, found = "", {}
            for line in text.splitlines():
                heading = line[3:] if line.startswith("## ") else heading
                picture = re.fullmatch(r"!\[.+\]\(<(.+)>\)", line)
                if picture:
                    found[picture[1].removeprefix("worked out (1)-").removesuffix(".svg")] = heading
                    drawn = (self.output.parent / picture[1]).read_text(encoding="utf-8")
                    self.assertTrue(drawn.startswith("<svg "), picture[1])
            self.assertEqual(found, found | places)
            # Without the pictures it is what is printed.
            plain = re.sub(r"\n!\[.+\]\(<.+>\)\n", "", text)
            self.assertEqual(plain, run("solve", "--explain", file).stdout)

    def test_nothing_is_overwritten_and_other_forms_are_refused(self):
        def refused(*arguments):
            result = run("solve", "--explain", *arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            return result.stderr

        example = str(EXAMPLES[0])
        figure = self.output.with_name("worked out (1)-model.svg")
        figure.write_text("mine", encoding="utf-8")
        self.assertIn("--force", refused(example, "-o", str(self.output)))
        self.assertEqual(figure.read_text(encoding="utf-8"), "mine")
        self.assertFalse(self.output.exists())
        self.assertIn("should end in .md", refused(example, "-o", str(self.output.with_suffix(".txt"))))
        self.assertIn("one file", refused(example, example, "-o", str(self.output)))


class Folders(unittest.TestCase):
    def test_a_folder_is_solved_file_by_file(self):
        with tempfile.TemporaryDirectory() as folder:
            for i, name in enumerate(("b.yaml", "a.yaml")):
                (pathlib.Path(folder) / name).write_text(EXAMPLES[i].read_text(encoding="utf-8"), encoding="utf-8")
            result = run("solve", "--json", folder)
            self.assertEqual([json.loads(line)["file"] for line in result.stdout.splitlines()],
                             [f"{folder}/a.yaml", f"{folder}/b.yaml"])

    def test_a_folder_without_problems_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            result = run("solve", folder)
            self.assertEqual((result.returncode, result.stdout, result.stderr),
                             (2, "", f"{folder}: no *.yaml file in this folder\n"))


class Check(unittest.TestCase):
    def test_a_failing_file_has_one_line_and_the_count_is_last(self):
        text = EXAMPLES[0].read_text(encoding="utf-8")
        head, expect = re.split(r"^expect:", text, maxsplit=1, flags=re.MULTILINE)
        self.assertTrue(expect)
        with tempfile.TemporaryDirectory() as folder:
            silent = pathlib.Path(folder) / "silent.yaml"
            silent.write_text(head, encoding="utf-8")
            (pathlib.Path(folder) / "whole.yaml").write_text(text, encoding="utf-8")
            result = run("check", folder)
            lines = result.stdout.splitlines()
            self.assertEqual(result.returncode, 1)
            self.assertEqual(len(lines), 2, result.stdout)
            self.assertTrue(lines[0].startswith(f"{silent}: "), lines[0])
            self.assertEqual(lines[1], "1 passed, 1 failed")

    def test_check_goes_through_folders_in_the_order_of_names(self):
        text = EXAMPLES[0].read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as folder:
            below = pathlib.Path(folder) / "a"
            below.mkdir()
            (below / "wrong.yaml").write_text("title: [\n", encoding="utf-8")
            (pathlib.Path(folder) / "silent.yaml").write_text("title: Nothing\n", encoding="utf-8")
            (pathlib.Path(folder) / "whole.yaml").write_text(text, encoding="utf-8")
            (pathlib.Path(folder) / "notes.txt").write_text("no problem", encoding="utf-8")
            result = run("check", folder)
            lines = result.stdout.splitlines()
            self.assertEqual(result.returncode, 1)
            self.assertEqual(len(lines), 3, result.stdout)
            self.assertTrue(lines[0].startswith(f"{below}/wrong.yaml: {below}/wrong.yaml:"), lines[0])
            self.assertTrue(lines[1].startswith(f"{folder}/silent.yaml: "), lines[1])
            self.assertEqual(lines[2], "1 passed, 2 failed")
            result = run("check", str(pathlib.Path(folder) / "nowhere"))
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertIn("there is no such file", result.stderr)

    def test_what_passed_is_named_on_request(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "a.yaml").write_text(EXAMPLES[0].read_text(encoding="utf-8"), encoding="utf-8")
            (pathlib.Path(folder) / "b.yaml").write_text("title: Nothing\n", encoding="utf-8")
            lines = run("check", "--list", folder).stdout.splitlines()
            self.assertEqual((lines[0], lines[2]), (f"{folder}/a.yaml: passed", "1 passed, 1 failed"))
            result = run("check", "--json", folder)
            self.assertEqual(result.returncode, 1)
            document = json.loads(result.stdout)
            self.assertEqual((document["passed"], document["failed"]), (1, 1))
            self.assertEqual([(file["file"], file["passed"]) for file in document["files"]],
                             [(f"{folder}/a.yaml", True), (f"{folder}/b.yaml", False)])
            self.assertEqual(document["files"][0]["shortfalls"], [])
            self.assertTrue(document["files"][1]["shortfalls"])

    def test_nothing_to_check_is_no_success(self):
        with tempfile.TemporaryDirectory() as folder:
            result = run("check", folder)
            self.assertEqual((result.returncode, result.stdout), (1, "0 passed, 0 failed\n"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
