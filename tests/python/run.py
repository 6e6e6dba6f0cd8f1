"""run.py tests|notebooks|types|sanitized PACKAGE: the tests of the Python package that lies below the folder PACKAGE.

sanitized: the modules of `cmake --build build --target poinsot_python_sanitized`, in build/python/sanitized; without the tests
of several processes, and of leaks, of which the interpreter has many.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

subject, package = sys.argv[1], os.path.abspath(sys.argv[2])
environment = os.environ | {"PYTHONPATH": package, "MYPYPATH": package, "PYTHONDONTWRITEBYTECODE": "1"}
scratch = os.path.join(package, "scratch")


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
others = ["test_notebooks", "test_studies_cluster", "test_studies_killed"]
benchmarks = ["benchmarks/studies.py", "benchmarks/python_engine.py", "benchmarks/scenes.py"]
calls = {
    "tests": ["pytest", "-q", "-p", "no:cacheprovider", "tests/python", "--ignore=tests/python/test_notebooks.py"],
    "notebooks": ["pytest", "-q", "-p", "no:cacheprovider", "tests/python/test_notebooks.py"],
    "sanitized": ["pytest", "-q", "-p", "no:cacheprovider", "tests/python", *(f"--ignore=tests/python/{one}.py" for one in others)],
    "types": ["mypy", "--cache-dir", os.path.join(scratch, "mypy"), "python/poinsot", "tests/python", *benchmarks, *notebook_code()],
}
raise SystemExit(subprocess.run([sys.executable, "-m", *calls[subject]], env=environment, check=False).returncode)
