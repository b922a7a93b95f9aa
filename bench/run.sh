#!/usr/bin/env bash
# The main job on a bare machine: sets it up, builds, benchmarks the thermal case of the source paper,
# and writes its report.
# Arguments go to `superstep bench`; relative paths among them are relative to the project folder.
set -euo pipefail
# shellcheck source=bench/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

install_missing_packages >&2
install_optional_packages "the program runs on one machine alone" "${parallel_packages[@]}" >&2
fetch_chart_library >&2
build_preset release superstep >&2
exec build/release/bin/superstep bench cases/nial_thermal.toml --report "$@"
