"""run.py tests|notebooks|types PACKAGE: the tests of the Python package that lies below the folder PACKAGE."""

import os
import subprocess
import sys

subject, package = sys.argv[1:]
environment = os.environ | {"PYTHONPATH": package, "MYPYPATH": package, "PYTHONDONTWRITEBYTECODE": "1"}
scratch = os.path.join(package, "scratch")
calls = {
    "tests": ["pytest", "-q", "-p", "no:cacheprovider", "tests/python", "--ignore=tests/python/test_notebooks.py"],
    "notebooks": ["pytest", "-q", "-p", "no:cacheprovider", "tests/python/test_notebooks.py"],
    "types": ["mypy", "--cache-dir", os.path.join(scratch, "mypy"), "python/poinsot", "tests/python"],
}
raise SystemExit(subprocess.run([sys.executable, "-m", *calls[subject]], env=environment, check=False).returncode)
