#!/usr/bin/env bash
# Installs the build, makes a project outside the tree that uses it by find_package, and compares what that project
# computes with what the program writes.
#   test.sh BUILD SOURCE
set -euo pipefail
build=$1 source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cmake --install "$build" --prefix "$folder/installed" >"$folder/install.log"
cp "$source/tests/consumer/CMakeLists.txt" "$source/tests/consumer/main.cpp" "$source/tests/consumer/host.cpp" \
  "$folder/"
# All headers that are installed compile there, in an order that nobody wrote.
(cd "$folder/installed/include/superstep" && find . -name '*.hpp' | sort -R --random-source=<(yes) | sed 's|^\./\(.*\)|#include <\1>|') >"$folder/headers.cpp"
cmake -S "$folder" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$folder/installed" >"$folder/configure.log"
cmake --build "$folder/build" >"$folder/build.log"

"$folder/installed/bin/superstep" run "$source/cases/chain.toml" --integrator cvode:rtol=1e-8 --out "$folder/run" --quiet
"$folder/build/consumer" "$source/cases/chain.toml" cvode:rtol=1e-8 >"$folder/consumer.txt"
tail -n +2 "$folder/run/final.csv" | cut -d, -f2 >"$folder/program.txt"
paste "$folder/consumer.txt" "$folder/program.txt" | awk '
  # Six digits are what the consumer prints.
  { if (($1 - $2)^2 > 1e-10) { print "line " NR ": " $1 " and " $2 " differ"; bad = 1 } }
  END { if (NR != 102) { print NR " nodes instead of 102"; bad = 1 } exit bad }'
for method in exponential:rtol=1e-8 rkc:rtol=1e-8; do
  "$folder/build/host" "$source/cases/chain.toml" "$method"
done
echo "the consumer agrees with the program on $(wc -l <"$folder/consumer.txt") nodes"
