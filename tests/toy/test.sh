#!/usr/bin/env bash
# Adds an integrator as integrators/README.md says, one file and one line, to a copy of the sources, builds that, and looks
# whether program, completion, conformance, order, work-precision, laboratory and report know it. Some minutes on two cores.
#   test.sh SOURCE
set -euo pipefail
source=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

(cd "$source" && git ls-files -z | xargs -0 cp --parents -t "$folder")
cd "$folder"
cp tests/toy/heun.cpp integrators/heun.cpp                                                # one file
sed -i 's/method(forward_euler)/method(forward_euler) method(heun)/' integrators/registry.cpp  # one line
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DSUPERSTEP_MICRO=OFF >configure.log
cmake --build build --parallel "$(nproc)" --target superstep test_integrators >build.log

superstep=build/bin/superstep
has() { grep -q -- "$1" "$2" || { echo "$2: no $1"; exit 1; }; }
"$superstep" list >list.txt && has '  heun  Heun' list.txt
"$superstep" completion bash >completion.txt && has heun completion.txt
"$superstep" run cases/chain.toml --integrator heun --out run >run.txt && has 'heun: ok' run.txt
"$superstep" bench cases/lattice.toml --integrator heun --out bench --report --no-cache --quiet >bench.txt
has '^heun ' bench.txt && has '#305070' bench/report.html
"$superstep" bench cases/lattice.toml --work-precision --out bench --no-cache --quiet >sweep.txt
has 'heun:fraction=0.25' sweep.txt
"$superstep" stability cases/lattice.toml --quick --out stability >stability.txt
has '^heun,' stability/stability_methods.csv
build/bin/test_integrators --gtest_filter='*heun*' >tests.txt || { cat tests.txt; exit 1; }
has 'PASSED' tests.txt
echo "a toy integrator is known everywhere: $(grep -c 'OK ' tests.txt) tests of the registry took it"
