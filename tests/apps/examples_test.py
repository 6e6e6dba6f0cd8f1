#!/usr/bin/env python3
"""The examples against the answers they expect: those that fall short are those of examples/known-shortfalls.txt.

usage: examples_test.py PROGRAM EXAMPLES_FOLDER FOLDER...
"""
import pathlib
import re
import subprocess
import sys
import unittest

PROGRAM, EXAMPLES, FOLDERS = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
KNOWN = EXAMPLES / "known-shortfalls.txt"


def known_shortfalls():
    """File and reason of every line that is no comment."""
    lines = [line for line in KNOWN.read_text().splitlines() if line.strip() and not line.startswith("#")]
    return dict((line.split(None, 1) + [""])[:2] for line in lines)


def shortfalls(folder):
    """The files of a folder of examples that `poinsot check` finds to fall short, and how many it checked."""
    result = subprocess.run([PROGRAM, "check", str(EXAMPLES / folder)], text=True, capture_output=True, timeout=900, check=False)
    output = result.stdout + result.stderr
    counts = re.search(r"^(\d+) passed, (\d+) failed$", output, re.MULTILINE)
    assert counts, f"check ended with {result.returncode} and without a count:\n{output}"
    prefix = f"{EXAMPLES}/{folder}/"
    named = {line[len(prefix):].split(": ")[0]: line[len(prefix):] for line in output.splitlines() if line.startswith(prefix)}
    assert len(named) == int(counts[2]), f"{counts[2]} failed, but these are named: {sorted(named)}"
    return {f"{folder}/{name}": why for name, why in named.items()}, int(counts[1]) + int(counts[2])


class Examples(unittest.TestCase):
    def test_what_falls_short_is_known(self):
        known = known_shortfalls()
        for folder in FOLDERS:
            with self.subTest(folder):
                found, checked = shortfalls(folder)
                self.assertEqual(checked, len(list((EXAMPLES / folder).glob("*.yaml"))))
                self.assertGreater(checked, 0)
                unknown = {file: why for file, why in found.items() if file not in known}
                self.assertEqual(unknown, {}, "these fall short")
                better = [file for file in known if file.startswith(f"{folder}/") and file not in found]
                self.assertEqual(better, [], f"these pass: take them out of {KNOWN}")

    def test_the_readme_counts_them(self):
        counts = re.findall(r"`examples/(\w+)`\s(?:states\s)?(\d+)\s", (EXAMPLES.parent / "README.md").read_text())
        self.assertEqual([folder for folder, _ in counts], ["textbook", "published"])
        for folder, count in counts:
            self.assertEqual(len(list((EXAMPLES / folder).glob("*.yaml"))), int(count), folder)

    def test_known_shortfalls_are_examples_and_say_why(self):
        for file, why in known_shortfalls().items():
            self.assertTrue((EXAMPLES / file).is_file(), file)
            self.assertTrue(why, file)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
