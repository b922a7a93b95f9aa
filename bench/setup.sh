# shellcheck shell=bash
# Sets a Debian 12 machine up and builds; sourced by bench/run.sh and tests/run.sh.
# Functions only, so that nothing happens before the caller says so.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

packages=(
  g++ cmake ninja-build
  libsundials-dev libsuitesparse-dev libopenblas-dev libeigen3-dev libfmt-dev
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libbenchmark-dev libgtest-dev
)

# Installs what is missing and nothing else: a machine that has everything needs neither root nor a network.
install_missing_packages() {
  local missing=() package
  for package in "${packages[@]}"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
  done
  if ((${#missing[@]} == 0)); then return; fi
  local as_root=()
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "setup: missing packages: ${missing[*]}; install them as root (apt-get install), there is no sudo here" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
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
