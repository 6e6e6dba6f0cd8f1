#!/usr/bin/env python3
"""Plants faults in the solver one by one, and tells whether the checks of answers refuse what comes out.

usage: faults.py --fit SOURCE             each fault can be planted: its text stands once in its file
       faults.py SOURCE SCRATCH [NAME...] builds poinsot in SCRATCH with each fault (or those named) and runs the examples

With a fault some examples no longer give what they expect. They should say so themselves: an answer that is refused is
as it should be, one that is told and wrong has slipped through. Building takes minutes for each.
"""
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from planted_faults import FAULTS  # noqa: E402

FOLDERS = ["textbook", "published", "benchmarks"]


def misfits(source):
    """The faults that cannot be planted, with the number of places where they could."""
    counts = {fault.name: (source / fault.file).read_text().count(fault.right) for fault in FAULTS}
    return {name: count for name, count in counts.items() if count != 1}


def copied(source, scratch):
    """A copy of the sources that are under version control."""
    tree = scratch / "source"
    names = subprocess.run(["git", "-C", str(source), "ls-files"], text=True, capture_output=True, check=True).stdout.splitlines()
    for name in names:
        target = tree / name
        target.parent.mkdir(parents=True, exist_ok=True)
        text = (source / name).read_bytes()
        if not target.exists() or target.read_bytes() != text:
            target.write_bytes(text)
    return tree


def built(tree, scratch):
    """The program, or None if it could not be built."""
    build = scratch / "build"
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    for command in (["cmake", "-S", str(tree), "-B", str(build), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", *launcher],
                    ["cmake", "--build", str(build), "--target", "poinsot", "--parallel", "2"]):
        if subprocess.run(command, text=True, capture_output=True, check=False).returncode != 0:
            return None
    return build / "poinsot"


def shortfalls(program, tree):
    """What `poinsot check` says of each example that does not give what it expects."""
    found = {}
    for folder in FOLDERS:
        for example in sorted((tree / "examples" / folder).glob("*.yaml")):
            try:
                result = subprocess.run([program, "check", str(example)], text=True, capture_output=True, timeout=120, check=False)
            except subprocess.TimeoutExpired:
                found[example.name] = "takes too long"
                continue
            if result.returncode != 0:
                found[example.name] = (result.stdout + result.stderr).splitlines()[0].split(": ", 1)[-1]
    return found


def tried(fault, tree, scratch, before):
    """One line on a fault, and whether something wrong was told."""
    file = tree / fault.file
    right = file.read_text()
    file.write_text(right.replace(fault.right, fault.wrong))
    try:
        program = built(tree, scratch)
        if program is None:
            return f"{fault.name}: could not be built", False
        after = {name: why for name, why in shortfalls(program, tree).items() if name not in before}
    finally:
        file.write_text(right)
    told = {name: why for name, why in after.items() if re.search(r", expected |solutions?, expected", why)}
    if not after:
        return f"{fault.name}: without effect on the examples", False
    verdict = "SLIPPED THROUGH" if told else "refused"
    first = next(iter((told or after).items()))
    return f"{fault.name}: {verdict}; {len(after)} examples fall short, {len(told)} tell something wrong; {first[0]}: {first[1]}", bool(told)


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--fit":
        wrong = misfits(pathlib.Path(arguments[1]))
        for name, count in wrong.items():
            print(f"{name}: its text stands {count} times in its file")
        print(f"{len(FAULTS)} faults, {len(wrong)} of which do not fit")
        return 1 if wrong or len({fault.name for fault in FAULTS}) != len(FAULTS) else 0
    if len(arguments) < 2:
        print(__doc__.strip())
        return 2
    source, scratch, names = pathlib.Path(arguments[0]).resolve(), pathlib.Path(arguments[1]).resolve(), arguments[2:]
    unknown = set(names) - {fault.name for fault in FAULTS}
    if unknown or misfits(source):
        print(f"no such faults: {sorted(unknown)}" if unknown else f"do not fit: {misfits(source)}")
        return 2
    tree = copied(source, scratch)
    program = built(tree, scratch)
    if program is None:
        print("without faults poinsot could not be built")
        return 2
    before = shortfalls(program, tree)
    slipped = 0
    for fault in FAULTS:
        if names and fault.name not in names:
            continue
        line, told = tried(fault, tree, scratch, before)
        slipped += told
        print(line, flush=True)
    return 1 if slipped else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
