#!/bin/sh
# Installs PyPI's wheel `pin` (Pinocchio with its headers and those of Boost) into a virtual environment, for
# bench_dynamics to measure against. Usage: fetch_pinocchio.sh [FOLDER], by default build/pinocchio.
set -u
folder=${1:-$(dirname "$0")/../build/pinocchio}
if ls "$folder"/lib/python*/site-packages/cmeel.prefix/include/pinocchio/algorithm/aba.hpp >/dev/null 2>&1; then
  exit 0
fi
fail() {
  echo "fetch_pinocchio.sh: $1; the benchmarks will run without Pinocchio" >&2
  exit 1
}
command -v python3 >/dev/null 2>&1 || fail "there is no python3"
python3 -m venv "$folder" || fail "python3 -m venv $folder failed (on Debian: apt install python3-venv)"
"$folder/bin/pip" install --quiet --disable-pip-version-check pin || fail "pip install pin failed"
ls "$folder"/lib/python*/site-packages/cmeel.prefix/include/pinocchio/algorithm/aba.hpp >/dev/null 2>&1 ||
  fail "the wheel holds no headers"
