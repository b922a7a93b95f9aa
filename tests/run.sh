#!/usr/bin/env bash
# Every test on a bare machine: sets it up, builds, runs. SUPERSTEP_SANITIZE=1 runs them under the address and
# undefined-behaviour sanitizers.
set -euo pipefail
# shellcheck source=bench/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../bench/setup.sh"

preset=release
if [[ ${SUPERSTEP_SANITIZE:-0} == 1 ]]; then preset=asan; fi
install_missing_packages
install_optional_packages "tests of the report in a browser and of VTK files are skipped" chromium fonts-dejavu-core python3-vtk9
fetch_chart_library
fetch_node_modules tests/browser "tests of the report in a browser are skipped"
build_preset "$preset"
ctest --test-dir "build/$preset" --output-on-failure -j"$(nproc)"
