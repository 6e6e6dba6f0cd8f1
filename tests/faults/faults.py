#!/usr/bin/env python3
"""Plants faults in the solver, and tells whether the checks of answers refuse what comes out.

usage: faults.py --fit SOURCE             each fault can be planted: its text stands once in its file
       faults.py --plant SOURCE SCRATCH   writes the sources with all faults asleep to SCRATCH/source, and no more
       faults.py SOURCE SCRATCH [NAME...] builds poinsot in SCRATCH/build with all faults asleep, and wakes each (or those named)

The environment wakes one fault, so that one build serves for all, and POINSOT_BUILT names a program that is built
already. The examples, the problems of the manual and the statements beside this file that come to the fault are solved with and without it: an answer that differs should be refused by
the program itself. What the examples expect plays no part, since a user has none of it.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planted_faults import FAULTS  # noqa: E402

FOLDERS = ["textbook", "published", "mechanisms", "benchmarks"]
LONGEST = 3.0  # seconds: examples that take longer without a fault are left out
MOST = 25  # examples to a fault: those that take the shortest time
# Tells which fault is awake, and at the end which a run has come to.
WAKING = """#pragma once
#include <cstddef>
#include <cstdio>
#include <cstdlib>
namespace planted {
constexpr std::size_t most = 1000;
struct Record {
  std::size_t awake = std::getenv("POINSOT_FAULT") ? std::strtoul(std::getenv("POINSOT_FAULT"), nullptr, 10) : 0;
  bool reached[most] = {};
  ~Record() {
    const char* path = std::getenv("POINSOT_REACHED");
    std::FILE* file = path ? std::fopen(path, "w") : nullptr;
    if (!file) return;
    for (std::size_t fault = 0; fault < most; ++fault)
      if (reached[fault]) std::fprintf(file, "%zu\\n", fault);
    std::fclose(file);
  }
};
inline Record& record() {
  static Record one;
  return one;
}
inline bool awake(std::size_t fault) {
  record().reached[fault] = true;
  return fault == record().awake;
}
}  // namespace planted
"""


def misfits(source):
    """The faults that cannot be planted, with the number of places where they could."""
    paths = {fault.name: source / fault.file for fault in FAULTS}
    counts = {fault.name: paths[fault.name].read_text().count(fault.right) if paths[fault.name].is_file() else 0 for fault in FAULTS}
    return {name: count for name, count in counts.items() if count != 1}


def planted(source, scratch):
    """A copy of the sources under version control with every fault asleep in it."""
    tree = scratch / "source"
    names = subprocess.run(["git", "-C", str(source), "ls-files"], text=True, capture_output=True, check=True).stdout.splitlines()
    texts = {name: (source / name).read_bytes() for name in names}
    for number, fault in enumerate(FAULTS, 1):
        text = texts[fault.file].decode()
        texts[fault.file] = text.replace(fault.right, fault.planted.replace("AWAKE", f"planted::awake({number})")).encode()
    texts["src/planted.h"] = WAKING.encode()
    for name in {fault.file for fault in FAULTS}:
        text = texts[name].decode()
        include = '#include "planted.h"\n'
        # A header keeps its guard first, and both keep the comment that heads them.
        texts[name] = (text.replace("#pragma once\n", "#pragma once\n" + include, 1) if name.endswith(".h") else include + text).encode()
    for name, text in texts.items():
        target = tree / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_bytes() != text:
            target.write_bytes(text)
    return tree


def built(tree, scratch):
    """The program, or None if it could not be built."""
    build = scratch / "build"
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    for command in (["cmake", "-S", str(tree), "-B", str(build), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", *launcher],
                    ["cmake", "--build", str(build), "--target", "poinsot", "--parallel", "2"]):
        result = subprocess.run(command, text=True, capture_output=True, check=False)
        if result.returncode != 0:
            print((result.stdout + result.stderr)[-3000:])
            return None
    return build / "poinsot"


def solved(program, example, fault, seconds, reached=""):
    """The document of an example with a fault awake (0: none), or None where an error is told, and how long it took."""
    environment = {**os.environ, "POINSOT_FAULT": str(fault), "POINSOT_REACHED": str(reached)}
    began = time.monotonic()
    try:
        result = subprocess.run([program, "solve", "--json", str(example)], text=True, capture_output=True, timeout=seconds, check=False, env=environment)
        return json.loads(result.stdout), time.monotonic() - began
    except (subprocess.TimeoutExpired, json.JSONDecodeError):
        return None, time.monotonic() - began


def is_refused(answer):
    """Whether an answer is withheld, in letters too: then it has neither a value nor a formula."""
    untold = "value" in answer and answer["value"] is None and not answer.keys() & {"formula", "formulas"}
    return untold or answer.get("refused") is True or answer.get("determined") is False


def same(one, other):
    """Whether two answers say the same to a reader of six digits."""
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(same(one[key], other[key]) for key in one)
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(same, one, other))
    numbers = isinstance(one, (int, float)) and isinstance(other, (int, float)) and not isinstance(one, bool)
    return abs(one - other) <= 1e-5 * max(abs(one), abs(other)) + 1e-9 if numbers else one == other


def steadiness(solution):
    """What the notes say of stability, without numbers."""
    return sorted(re.sub(r"[0-9.e+-]+", "#", note) for note in solution.get("notes", []) if re.search("stable", note))


def told_otherwise(right, wrong):
    """Whether anything is otherwise, and what of it is told all the same."""
    if right is None or wrong is None:
        return (right is None) != (wrong is None), []
    # That nothing exists is withheld where the particles do not confirm the equations that say so.
    unconfirmed = any("do not confirm" in json.dumps(warning) for warning in wrong.get("warnings", []))
    right, wrong = right.get("solutions", []), wrong.get("solutions", [])
    if len(right) != len(wrong):
        # What is one too many is seen where an answer of it is refused; what is lost is missed by those that stand alone.
        whole = [solution["answers"] for solution in wrong if not any(map(is_refused, solution["answers"].values()))]
        seen = len(whole) < len(wrong) and all(any(same(one["answers"], answers) for one in right) for answers in whole)
        told = all(any(not is_refused(answer) for answer in solution["answers"].values()) for solution in wrong)
        return True, [f"{len(wrong)} solutions"] if told and not unconfirmed and not seen else []
    changed, told = False, []
    for one, other in zip(right, wrong):
        for name, answer in one["answers"].items():
            after = other["answers"].get(name, {"refused": True})
            if same(answer, after):
                continue
            changed = True
            if not is_refused(after):
                told.append(f"{name}: {json.dumps(after.get('value', after))[:60]}")
        said, after = steadiness(one), steadiness(other)
        changed = changed or said != after
        # What the checks refuse is not said.
        if not any(map(is_refused, other["answers"].values())) and not set(after) <= set(said):
            told.append("what the notes say of stability")
    return changed, told


def manual(source, folder):
    """The problems of the manual, each in a file."""
    text = (source / "docs/language.md").read_text()
    for name, block in re.findall(r"```obj (\S+)\n(.*?)```", text, re.DOTALL):
        (folder / name).write_text(block)
    paths = []
    for number, block in enumerate(re.findall(r"```yaml\n(.*?)```", text, re.DOTALL), 1):
        paths.append(folder / f"manual-{number}.yaml")
        paths[-1].write_text(block)
    return paths


def solved_without(program, example, folder):
    """The same without a fault, and which faults it comes to."""
    path = folder / f"{example.parent.name}-{example.stem}"
    document, seconds = solved(program, example, 0, 20, path)
    return document, seconds, set(map(int, path.read_text().split())) if path.exists() else set()


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--fit":
        wrong = misfits(pathlib.Path(arguments[1]))
        for name, count in wrong.items():
            print(f"{name}: its text stands {count} times in its file")
        print(f"{len(FAULTS)} faults, {len(wrong)} of which do not fit")
        asleep = all("AWAKE" in fault.planted for fault in FAULTS)
        return 1 if wrong or not asleep or len({fault.name for fault in FAULTS}) != len(FAULTS) else 0
    if len(arguments) == 3 and arguments[0] == "--plant":
        planted(*(pathlib.Path(path).resolve() for path in arguments[1:]))
        return 0
    if len(arguments) < 2:
        print(__doc__.strip())
        return 2
    source, scratch, names = pathlib.Path(arguments[0]).resolve(), pathlib.Path(arguments[1]).resolve(), arguments[2:]
    unknown = set(names) - {fault.name for fault in FAULTS}
    if unknown or misfits(source):
        print(f"no such faults: {sorted(unknown)}" if unknown else f"do not fit: {misfits(source)}")
        return 2
    program = os.environ.get("POINSOT_BUILT") or built(planted(source, scratch), scratch)
    if program is None:
        print("poinsot could not be built")
        return 2
    folders = [source / "examples" / name for name in FOLDERS] + [source / "tests/faults/statements"]
    examples = [example for folder in folders for example in sorted(folder.glob("*.yaml"))]
    slipped = 0
    with concurrent.futures.ThreadPoolExecutor(2) as workers, tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        examples += manual(source, folder)
        right = dict(zip(examples, workers.map(lambda example: solved_without(program, example, folder), examples)))
        quick = sorted((example for example in examples if right[example][1] < LONGEST), key=lambda example: right[example][1])
        for number, fault in enumerate(FAULTS, 1):
            if names and fault.name not in names:
                continue
            examples = [example for example in quick if number in right[example][2]][:MOST]
            # A fault may make the solver search in vain: what takes ten times as long tells nothing.
            wrong = workers.map(lambda example: solved(program, example, number, 5 + 10 * right[example][1])[0], examples)
            compared = {example.name: told_otherwise(right[example][0], after) for example, after in zip(examples, wrong)}
            changed = sum(change for change, _ in compared.values())
            told = {name: what for name, (_, what) in compared.items() if what}
            slipped += bool(told)
            verdict = "SLIPPED THROUGH" if told else "refused" if changed else "without effect on the examples that come to it"
            first = "; ".join(f"{name}: {what[0]}" for name, what in list(told.items())[:3])
            print(f"{fault.name}: {verdict}; {changed} of {len(examples)} examples changed, {len(told)} tell something else. {first}", flush=True)
    return 1 if slipped else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
