#!/usr/bin/env bash
# ./bench   sets up, builds for this machine's processor and measures: the engine, beside Pinocchio where it can be
#           had, and the whole program from its start to the answers of each textbook example.
set -euo pipefail
# shellcheck source=scripts/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/scripts/setup.sh"

ensure_packages "${build_packages[@]}" "${bench_packages[@]}"
build_preset bench bench_dynamics
build_preset release poinsot
cd "$root"
status=0
build/bench/benchmarks/bench_dynamics </dev/null || status=$?
echo
python3 benchmarks/startup.py build/poinsot examples/textbook/*.yaml
exit "$status"
