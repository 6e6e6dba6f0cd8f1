#!/usr/bin/env python3
"""poinsot record as other programs see it: killed, interrupted, without room, on a terminal and in a pipe.

usage: recording_test.py PROGRAM [TEST...]

POINSOT_KILLS is how often a run is killed at a random moment (20).
"""
import csv
import errno
import os
import pathlib
import pty
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = sys.argv[1]
KILLS = int(os.environ.get("POINSOT_KILLS", "20"))

# A pendulum with a bob on a spring, which moves without order.
PROBLEM = """title: A bob on a spring below a pendulum
given: {L: 0.9 m, l: 0.5 m, b: 30 deg}
points: {O: [0, 0, 0], P: [0, -L, 0], Q: [0, -L - l, 0]}
bodies:
  rod: {rod: [O, P], mass: 2 kg}
  bob: {particle: Q, mass: 1 kg}
joints:
  pin: {revolute: z, at: O, to: rod, angle: theta}
  plane:
    planar: z
    at: Q
    to: bob
    freedoms: {slide1: {displacement: x1}, slide2: {displacement: y1}, turn: {angle: 0, rate: 0, accel: 0}}
gravity: -y
springs:
  coil: {from: rod, at: P, to: bob, end: Q, stiffness: 40 N/m, free_length: 0.4 m}
instants:
  start: {theta: b, theta': 0, x1: 10 cm, y1: 0 m, x1': 0, y1': 0}
record:
  every: 1 ms
  for: %s
  columns: {t: time, theta: theta, x: x1, F: norm(force(pin on rod))}
  unit: {theta: deg, x: mm}
"""


def run(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, timeout=300, check=False, **options)


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def problem(self, lasts="10 s", name="swing.yaml"):
        file = self.folder / name
        file.write_text(PROBLEM % lasts, encoding="utf-8")
        return file

    def record(self, file, name, **options):
        result = run("record", file, "-o", self.folder / name, **options)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return (self.folder / name).read_bytes(), (self.folder / (name + ".journal")).read_bytes()


class Kills(Folder):
    def kill_at_random(self, file, data, most_seconds, dice):
        """The exit code of a run, None if it was killed."""
        with subprocess.Popen([PROGRAM, "record", file, "-o", data], stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            try:
                return process.wait(timeout=dice.uniform(0, most_seconds))
            except subprocess.TimeoutExpired:
                process.kill()
                return None if process.wait(timeout=60) == -signal.SIGKILL else process.returncode

    def test_a_run_killed_at_any_moment_resumes_to_the_same_bytes(self):
        file = self.problem()
        begin = time.perf_counter()
        data, journal = {}, b""
        for ending in (".csv", ".h5"):
            data[ending], journal = self.record(file, "whole" + ending)
        seconds = (time.perf_counter() - begin) / 2
        dice = random.Random(18)
        kills = on_the_way = 0
        while kills < KILLS:
            ending = dice.choice(sorted(data))
            killed = self.folder / ("killed" + ending)
            kept = self.folder / (killed.name + ".journal")
            # Each run is killed a few times before it comes to its end.
            for _ in range(dice.randint(1, 4)):
                code = self.kill_at_random(file, killed, 1.1 * seconds, dice)
                self.assertIn(code, (0, None))
                kills += code is None
                # What has been written stays, byte for byte; only its end may be torn.
                left = kept.read_bytes() if kept.exists() else b""
                self.assertTrue(journal.startswith(left))
                on_the_way += code is None and 0 < len(left) < len(journal)
            result = run("record", file, "-o", killed)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(kept.read_bytes(), journal)
            self.assertEqual(killed.read_bytes(), data[ending])
            for path in self.folder.glob("killed*"):
                path.unlink()
        self.assertGreater(on_the_way, KILLS // 4)


class Interrupts(Folder):
    def interrupt(self, number):
        file = self.problem("100000 s")
        data, journal = self.folder / "a.csv", self.folder / "a.csv.journal"
        with subprocess.Popen([PROGRAM, "record", file, "-o", data], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True) as process:
            while not journal.exists() or journal.stat().st_size < 100_000:
                self.assertIsNone(process.poll())
                time.sleep(0.01)
            process.send_signal(number)
            out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertEqual(err, f"poinsot: interrupted; the same call goes on from {journal}\n")
        self.assertRegex(out, r"a\.csv: \d+ rows of 4 columns, to [0-9.]+ s \(incomplete\)\n")
        lines = data.read_text(encoding="utf-8").splitlines()
        rows = int(out.split(": ")[1].split()[0])
        self.assertGreater(rows, 1000)
        self.assertEqual(len(lines), rows + 2)
        self.assertEqual(lines[-1], f"# incomplete: {rows} rows of 100000001")
        self.assertEqual(lines[-2].split(",")[0], repr((rows - 1) / 1000).removesuffix(".0"))

    def test_interrupt_key(self):
        self.interrupt(signal.SIGINT)

    def test_termination(self):
        self.interrupt(signal.SIGTERM)


class Streams(Folder):
    def test_no_progress_in_a_pipe(self):
        file = self.problem("1 s")
        result = run("record", file, "-o", self.folder / "a.csv")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(result.stdout, f"{self.folder}/a.csv: 1001 rows of 4 columns, to 1 s\n")

    def test_progress_with_time_left_on_a_terminal(self):
        file = self.problem("1000 s")
        ours, theirs = pty.openpty()
        with subprocess.Popen([PROGRAM, "record", file, "-o", self.folder / "a.csv"], stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=theirs) as process:
            os.close(theirs)
            shown = b""
            while True:
                try:
                    part = os.read(ours, 4096)
                except OSError as error:
                    self.assertEqual(error.errno, errno.EIO)
                    part = b""
                if not part:
                    break
                shown += part
            os.close(ours)
            self.assertEqual(process.wait(timeout=60), 0)
        text = shown.decode()
        self.assertRegex(text, r"\r +\d+ %  recording  \d+ s left")
        self.assertNotIn("\n", text)
        self.assertTrue(text.endswith(" \r"))

    def test_csv_is_read_by_others(self):
        file = self.problem("1 s")
        self.record(file, "a.csv")
        with open(self.folder / "a.csv", newline="", encoding="utf-8") as stream:
            rows = list(csv.reader(stream))
        self.assertEqual(rows[0], ["t [s]", "theta [deg]", "x [mm]", "F [N]"])
        self.assertEqual(len(rows), 1002)
        for number, expected in zip(rows[1], (0, 30, 100)):
            self.assertAlmostEqual(float(number), expected, delta=1e-12)


class Refusals(Folder):
    def refused(self, code, message, *arguments, **options):
        result = run("record", *arguments, **options)
        self.assertEqual((result.returncode, result.stdout), (code, ""), result.stderr)
        self.assertEqual(result.stderr, message)

    def test_output_that_cannot_be(self):
        file = self.problem()
        (self.folder / "sub.csv").mkdir()
        self.refused(2, "poinsot: cannot record to 'a.txt': its name ends in neither .csv nor .h5, which tells the format\n",
                     file, "-o", "a.txt")
        self.refused(2, f"poinsot: cannot record to {self.folder}/sub.csv: it is a folder; name a file in it\n",
                     file, "-o", self.folder / "sub.csv")
        self.refused(2, f"poinsot: cannot record to {self.folder}/no/a.csv: there is no folder {self.folder}/no\n",
                     file, "-o", self.folder / "no" / "a.csv")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["sub.csv", "swing.yaml"])

    @unittest.skipIf(os.geteuid() == 0, "nothing is forbidden to root")
    def test_folder_that_takes_nothing(self):
        file = self.problem()
        self.folder.chmod(0o500)
        self.addCleanup(self.folder.chmod, 0o700)
        self.refused(2, f"poinsot: cannot record to {self.folder}/a.csv.journal: Permission denied\n", file, "-o",
                     self.folder / "a.csv")

    def test_journal_of_another_problem_is_kept(self):
        first, second = self.problem("1 s"), self.problem("2 s", "other.yaml")
        data, journal = self.record(first, "a.csv")
        self.refused(2, f"poinsot: {self.folder}/a.csv.journal is not overwritten, it holds a recording of another "
                        "problem, or of an older text of it: move it away, or record to another file\n",
                     second, "-o", self.folder / "a.csv")
        self.refused(2, f"poinsot: {self.folder}/a.csv.journal is not overwritten, it holds a recording with other "
                        "settings: move it away, or record to another file\n",
                     first, "-o", self.folder / "a.csv", "--set", "b=101 deg")
        self.assertEqual((self.folder / "a.csv").read_bytes(), data)
        self.assertEqual((self.folder / "a.csv.journal").read_bytes(), journal)

    def test_file_that_is_no_journal_is_kept(self):
        file = self.problem("1 s")
        journal = self.folder / "a.csv.journal"
        journal.write_text("dear diary\n", encoding="utf-8")
        self.refused(2, f"poinsot: {journal} is not overwritten: it is no journal of a recording: move it away, or "
                        "record to another file\n", file, "-o", self.folder / "a.csv")
        self.assertEqual(journal.read_text(encoding="utf-8"), "dear diary\n")

    def test_table_of_another_is_kept_unless_forced(self):
        file, table = self.problem("1 s"), self.folder / "a.csv"
        table.write_text("dear diary\n", encoding="utf-8")
        self.refused(2, f"poinsot: {table} is not overwritten: without a journal beside it, it is no recording of this "
                        "program; move it away, record to another file, or add --force\n", file, "-o", table)
        self.assertEqual(table.read_text(encoding="utf-8"), "dear diary\n")
        self.assertFalse((self.folder / "a.csv.journal").exists())
        self.assertEqual(run("record", file, "-o", table, "--force").returncode, 0)
        self.assertTrue(table.read_text(encoding="utf-8").startswith("t [s]"))

    def test_two_runs_at_once(self):
        file = self.problem("100000 s")
        journal = self.folder / "a.csv.journal"
        with subprocess.Popen([PROGRAM, "record", file, "-o", self.folder / "a.csv"], stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            while not journal.exists() or journal.stat().st_size == 0:
                time.sleep(0.01)
            self.refused(2, f"poinsot: cannot record to {journal}: another run is recording to it\n", file, "-o",
                         self.folder / "a.csv")
            process.kill()

    def test_no_room(self):
        file = self.problem("5 s")
        _, whole = self.record(file, "whole.csv")
        for limit in (10, 3000, 100_000, len(whole), len(whole) + 50_000):
            name = f"a{limit}.csv"
            result = run("record", file, "-o", self.folder / name,
                         preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
            self.assertEqual(result.returncode, 3, result.stderr)
            self.assertIn("cannot write", result.stderr)
            self.assertIn("File too large", result.stderr)
            if limit > 3000:
                self.assertRegex(result.stderr, "the same call (goes on from|writes the data file from)")
            self.assertTrue(whole.startswith((self.folder / (name + ".journal")).read_bytes()))
            self.assertFalse((self.folder / (name + ".part")).exists())
            # With room again it goes on.
            result = run("record", file, "-o", self.folder / name)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual((self.folder / (name + ".journal")).read_bytes(), whole)

    def test_no_room_for_hdf5(self):
        file = self.problem("5 s")
        self.record(file, "a.h5")
        result = run("record", file, "-o", self.folder / "a.h5",
                     preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000)))
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("File too large", result.stderr)
        self.assertIn("the recording is safe in", result.stderr)
        self.assertFalse((self.folder / "a.h5.part").exists())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
