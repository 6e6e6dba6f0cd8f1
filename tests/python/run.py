"""run.py tests|notebooks|types|faults|sanitized [PACKAGE]: the tests of the Python package that lies below the folder PACKAGE, or
of the one that is installed. Called in the clone, by a Python that has what `pip install '.[test]'` brings.

faults: studies that are killed again and again, a full disk, ten million rows; ten minutes.
sanitized: the modules of `cmake --build build --target poinsot_python_sanitized`, in build/python/sanitized; without the tests
of several processes, and of leaks, of which the interpreter has many.
"""

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

subject = sys.argv[1]
environment = os.environ | {"PYTHONDONTWRITEBYTECODE": "1"}
if len(sys.argv) > 2:
    folder = os.path.abspath(sys.argv[2])
    environment |= {"PYTHONPATH": folder, "MYPYPATH": folder}
    scratch, package = os.path.join(folder, "scratch"), ["python/poinsot"]
else:
    installed = importlib.util.find_spec("poinsot")
    if installed is None or installed.origin is None:
        raise SystemExit("run.py: poinsot is not installed in this environment: pip install '.[test]', or name the folder of its package")
    # By its name: a path within an environment would make modules of all that is installed in it.
    scratch, package = os.path.abspath("build/python/scratch"), ["-p", "poinsot"]


def notebook_code() -> list[str]:
    """The code of the notebooks, each as a file."""
    folder = Path(scratch, "notebooks")
    folder.mkdir(parents=True, exist_ok=True)
    for notebook in Path("examples/notebooks").glob("*.ipynb"):
        cells = json.loads(notebook.read_text())["cells"]
        code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
        (folder / f"{notebook.stem}.py").write_text("\n\n".join(code) + "\n")
    return [str(path) for path in sorted(folder.glob("*.py"))]


if subject == "sanitized":
    libraries = [subprocess.run(["g++", f"-print-file-name={name}"], capture_output=True, text=True, check=True).stdout.strip()
                 for name in ("libasan.so", "libstdc++.so")]
    environment |= {"LD_PRELOAD": " ".join(libraries), "ASAN_OPTIONS": "detect_leaks=0"}
in_processes = ["test_studies_cluster", "test_studies_killed", "test_studies_memory"]
others = ["test_notebooks", *in_processes]
benchmarks = ["benchmarks/studies.py", "benchmarks/python_engine.py", "benchmarks/scenes.py"]
pytest = ["pytest", "-q", "-p", "no:cacheprovider"]
mypy = ["mypy", "--cache-dir", os.path.join(scratch, "mypy")]
calls = {
    "tests": [*pytest, "tests/python", "--ignore=tests/python/test_notebooks.py"],
    "notebooks": [*pytest, "tests/python/test_notebooks.py"],
    # Those that take minutes among them, and each with its time and with what it printed.
    "faults": [*pytest, "-m", "", "-rA", "--durations=0", *(f"tests/python/{one}.py" for one in in_processes)],
    "sanitized": [*pytest, "tests/python", *(f"--ignore=tests/python/{one}.py" for one in others)],
    "types": [*mypy, "tests/python", *benchmarks, *notebook_code()],
}
if subject not in calls:
    raise SystemExit(f"run.py: there is no '{subject}': expected {', '.join(calls)}")
if subject == "types" and (status := subprocess.run([sys.executable, "-m", *mypy, *package], env=environment, check=False).returncode):
    raise SystemExit(status)
raise SystemExit(subprocess.run([sys.executable, "-m", *calls[subject]], env=environment, check=False).returncode)
