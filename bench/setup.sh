# shellcheck shell=bash
# Sets a Debian 12 machine up and builds; sourced by bench/run.sh and tests/run.sh.
# Functions only, so that nothing happens before the caller says so.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

packages=(
  g++ cmake ninja-build
  libsundials-dev libsuitesparse-dev libopenblas-dev libeigen3-dev libfmt-dev
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libbenchmark-dev libgtest-dev libxxhash-dev zlib1g-dev
)

# Several processes, and PETSc to compare with; without them the program is the same, and alone. Used by the scripts that source this one.
# shellcheck disable=SC2034
parallel_packages=(libpetsc-real-dev mpi-default-dev mpi-default-bin pkg-config)

# The Python module and its tests; without them CMake leaves it out.
# shellcheck disable=SC2034
python_packages=(pybind11-dev python3-dev python3-numpy python3-scipy)

# missing_packages PACKAGE...: those that are not installed, one a line.
missing_packages() {
  local package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || echo "$package"
  done
}

# apt_install PACKAGE...: as root, or through sudo.
apt_install() {
  local as_root=()
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "setup: missing packages: $*; install them as root (apt-get install), there is no sudo here" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@"
}

# Installs what is missing and nothing else: a machine that has everything needs neither root nor a network.
install_missing_packages() {
  local missing
  mapfile -t missing < <(missing_packages "${packages[@]}")
  if ((${#missing[@]} == 0)); then return; fi
  apt_install "${missing[@]}"
}

# install_optional_packages WITHOUT PACKAGE...: the same for what we can do without; WITHOUT says what then happens.
install_optional_packages() {
  local without=$1 missing
  shift
  mapfile -t missing < <(missing_packages "$@")
  if ((${#missing[@]} == 0)); then return; fi
  apt_install "${missing[@]}" || echo "setup: ${missing[*]} could not be installed: $without" >&2
}

# fetch_node_modules FOLDER WITHOUT: the npm packages that FOLDER/package-lock.json names; WITHOUT says what happens
# when they cannot be had. Nothing is done while they are there and the lock file has not changed.
fetch_node_modules() {
  local folder=$root/$1 without=$2
  if [[ $folder/node_modules/.package-lock.json -nt $folder/package-lock.json ]]; then return; fi
  command -v npm >/dev/null || install_optional_packages "$without" npm
  (cd "$folder" && npm ci --no-audit --no-fund --loglevel=error && touch node_modules/.package-lock.json) ||
    echo "setup: npm packages of $1 could not be fetched: $without" >&2
}

# The chart library that is embedded into reports.
fetch_chart_library() {
  fetch_node_modules reports/web "charts of reports cannot be zoomed"
}

# build_preset PRESET [TARGET...]: goes to the project folder, configures, and builds with all cores in build/PRESET.
build_preset() {
  local preset=$1 targets=()
  shift
  if (($# > 0)); then targets=(--target "$@"); fi
  cd "$root" || return 1
  cmake --preset "$preset"
  cmake --build --preset "$preset" --parallel "$(nproc)" "${targets[@]}"
}
