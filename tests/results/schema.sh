#!/usr/bin/env bash
# The JSON files of a benchmark, a run and the laboratory against their committed JSON Schema.
#   schema.sh PROGRAM SOURCE
set -euo pipefail
program=$1 source=$2
if ! python3 -c 'import jsonschema' 2>/dev/null; then
  echo "python3-jsonschema is not there"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$source"
"$program" bench cases/lattice.toml cases/chain.toml --repetitions 1 --no-cache --quiet --out "$folder/bench" >/dev/null
"$program" run cases/lattice_two_way.toml --quiet --out "$folder/run" >/dev/null
"$program" stability cases/lattice.toml --quick --quiet --out "$folder/stability" >/dev/null
python3 - "$source/reports/schema" "$folder" <<'PYTHON'
import json
import sys

import jsonschema

schemas, folder = sys.argv[1:]
for name, file in (
    ("results", "bench/results.json"),
    ("run", "run/run.json"),
    ("stability", "stability/stability.json"),
):
    with open(f"{schemas}/superstep.{name}.schema.json", encoding="utf-8") as stream:
        schema = json.load(stream)
    with open(f"{folder}/{file}", encoding="utf-8") as stream:
        content = json.load(stream)
    validator = jsonschema.validators.validator_for(schema)(schema)
    validator.check_schema(schema)
    validator.validate(content)
    broken = dict(content)
    broken.pop("version", None) or broken.pop("case")
    assert not validator.is_valid(broken), f"{name}: a missing key is not noticed"
    print(f"{file} is as its schema says")
PYTHON
