#!/usr/bin/env bash
# Every test on a bare machine: sets it up, builds, runs. SUPERSTEP_SANITIZE=1 runs them under the address and
# undefined-behaviour sanitizers.
set -euo pipefail
# shellcheck source=bench/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../bench/setup.sh"

preset=release
if [[ ${SUPERSTEP_SANITIZE:-0} == 1 ]]; then preset=asan; fi
install_missing_packages
build_preset "$preset"
ctest --test-dir "build/$preset" --output-on-failure -j"$(nproc)"
