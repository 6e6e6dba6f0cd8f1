"""Runs the program on a statement, within limits, and reads its document."""
import json
import math
import os
import pathlib
import resource
import signal
import subprocess
import tempfile
import threading

from jsonschema import Draft202012Validator

# What issues no answer may take: processor seconds and bytes of memory. The address space may be twice as large, so
# that what is found is memory in use; the clock, far more, only ends what sleeps.
SECONDS, MEMORY, ADDRESSES, WAIT = 20, 2**30, 2**31, 240
OWN_FAULT = "refused: the independent check"
OWN_FAULTS = ("the independent check with particles does not confirm", "holds together comes apart", OWN_FAULT)


class Run:
    """What came of one run: its exit code, its document if it wrote one, and its fault if it has one by itself."""

    def __init__(self, code, document, message, fault):
        self.code, self.document, self.message, self.fault = code, document, message, fault


class Program:
    def __init__(self, path):
        self.path = str(path)
        schema = subprocess.run([self.path, "schema", "--answer"], capture_output=True, text=True, check=True, timeout=60)
        self.schema = Draft202012Validator(json.loads(schema.stdout))
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="hunt-"))
        self.known = {}
        self.seconds = 0.0  # that all runs took of the processor

    def solve(self, statement, settings=None, keep=False):
        """Runs `poinsot solve --json`; runs with `keep` are remembered, as many relations begin with the same one."""
        values = {**statement.settings, **(settings or {})}
        key = (statement.text(), tuple(sorted(values.items())))
        if key in self.known:
            return self.known[key]
        run = self.run(statement, values)
        if keep:
            self.known[key] = run
        return run

    def run(self, statement, values):
        path = self.folder / "statement.yaml"
        path.write_text(statement.text())
        for name, text in statement.files.items():
            (self.folder / name).write_text(text)
        options = [f"--set={name}={value}" for name, value in values.items()]
        process = subprocess.Popen([self.path, "solve", "--json", *options, str(path)], stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, preexec_fn=limits)
        alarm = threading.Timer(WAIT, process.kill)
        alarm.start()
        try:
            output = process.stdout.read().decode("utf-8", "replace")
        finally:
            process.stdout.close()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            alarm.cancel()
        return self.judged(process.returncode, output, usage)

    def judged(self, code, output, usage):
        seconds, memory = usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024
        self.seconds += seconds
        message = output.strip().splitlines()[-1].replace(str(self.folder) + "/", "") if output.strip() else ""
        if seconds >= SECONDS or code in (-signal.SIGXCPU, -signal.SIGKILL) and seconds > SECONDS - 1:
            return Run(code, None, message, f"it takes more than {SECONDS} s")
        if memory > MEMORY:
            return Run(code, None, message, "it takes more than 1 GiB")
        if code < 0:
            return Run(code, None, message, f"it ends by signal {-code}")
        if code not in (0, 1, 2):
            return Run(code, None, message, f"it ends with exit code {code}")
        lines = [line for line in output.splitlines() if line.startswith('{"poinsot"')]
        if not lines:
            return Run(code, None, message, None if code == 2 or code == 1 and message else "it says nothing")
        try:
            document = json.loads(lines[-1], parse_constant=not_finite)
        except ValueError as error:
            return Run(code, None, message, f"its document is no JSON ({error})")
        return Run(code, document, message, self.fault_of(document))

    def fault_of(self, document):
        wrong = next(iter(self.schema.iter_errors(document)), None)
        if wrong:
            return f"its schema refuses the document: {wrong.message[:200]}"
        if not all(finite(solution) for solution in document["solutions"]):
            return "a number of its document is not finite"
        for solution in document["solutions"]:
            for name, answer in solution["answers"].items():
                reason = str(answer.get("reason", "")) + str(answer.get("no_formula", ""))
                if any(words in reason for words in OWN_FAULTS):
                    return f"{name}: {reason[:200]}"
        return None


def limits():
    resource.setrlimit(resource.RLIMIT_AS, (ADDRESSES, ADDRESSES))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def not_finite(word):
    raise ValueError(f"{word} is no number of JSON")


def finite(value):
    if isinstance(value, dict):
        return all(finite(item) for item in value.values())
    if isinstance(value, list):
        return all(finite(item) for item in value)
    if isinstance(value, str):
        return value.strip("-+").lower() not in ("nan", "inf", "infinity")
    return not isinstance(value, float) or math.isfinite(value)
