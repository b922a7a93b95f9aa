#!/usr/bin/env python3
"""Random packings under random methods against physics and a solver of their own.

    packings.py PROGRAM [FIRST LAST] [TOLERANCE...]

Seeds FIRST to LAST - 1 (default 1 to 13) at tolerances drawn from those given (default 1e-3, 1e-5): each under `auto` and
two other methods. Ends with 1 where the rms error at the end exceeds three times the tolerance of the span, with 77 without
SciPy.
"""

from __future__ import annotations

import csv
import random
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import numpy as np
    from packing_truth import Truth
    from random_packing import UNITS, Law, Packing, random_packing
except ImportError as missing:
    print(missing)
    sys.exit(77)

METHODS = ["rkc", "rkl", "rock", "exprb", "trapezoidal", "esdirk", "cvode", "cvode:linsol=gmres", "arkode", "exponential"]


def amount(law: Law) -> str:
    """As a case file says it."""
    kind, *rest = law
    if kind == "constant":
        return repr(rest[0])
    if kind == "times":
        return "{ times = %r, values = %r }" % tuple(rest)
    if kind == "table":
        return '{ law = "table", temperatures = %r, values = %r, outside = "clamp" }' % tuple(rest)
    if kind == "linear":
        return '{ law = "linear", value = %r, coefficient = %r, reference = %r, outside = "clamp" }' % tuple(rest)
    return '{ law = "sigmoid", value = %r, amplitude = %r, steepness = %r, reference = %r }' % tuple(rest)


def ids(particles: list[int]) -> str:
    return "{ ids = %r }" % [particle + 1 for particle in particles]


def layer(name: str, value: tuple[float, float]) -> str:
    return "%s = { thickness = %r, reduction = %r }" % (name, *value)


def write_case(one: Packing, folder: Path) -> Path:
    """The packing and a case that reads it."""
    unit = UNITS[one.unit]
    rows = ["id,x,y,z,radius,material,T"]
    for k, (centre, radius) in enumerate(zip(one.centres, one.radii)):
        numbers = [float(v) / unit for v in (*centre, radius)]
        rows.append(",".join([str(k + 1), *map(repr, numbers), f"m{one.material_of[k]}", repr(one.initial[k])]))
    (folder / "packing.csv").write_text("\n".join(rows) + "\n")
    lines = [f"t_end = {one.t_end!r}", "[packing]", 'file = "packing.csv"', f'length_unit = "{one.unit}"']
    if any(one.periodic):
        lines.append('periodic = "%s"' % "".join(axis for axis, joined in zip("xyz", one.periodic) if joined))
        lines.append("box = { min = [0, 0, 0], max = %r }" % ([one.side / unit] * 3))
    lines += ["[contact]", f'neck = "{one.neck}"', f'conductance = "{one.conductance}"']
    if one.neck == "plastic":
        lines.append(f"hardening = {one.hardening!r}")
    if one.gap > 0:
        lines.append(f"gap = {one.gap / unit!r}")
    if one.bond_radius > 0:
        lines.append(f"bond_radius = {one.bond_radius / unit!r}")
    for k, material in enumerate(one.materials):
        lines += ["[[materials]]", f'name = "m{k}"', f"density = {material.density!r}"]
        per_mass = {"thermal": f", specific_heat = {material.specific_heat!r}", "electric": ""}
        if one.kind != "steady":
            per_mass["electric"] = f", specific_capacity = {material.specific_capacity!r}"
        for name in one.fields:
            lines.append(f"{name} = {{ conductivity = {amount(material.conductivity[name])}{per_mass[name]} }}")
    if layers := [layer(name, value) for name, value in one.interface.items() if value]:
        lines += ["[[interfaces]]", 'between = ["m0", "m1"]', *layers]
    for name in one.fields:
        lines.append(f"[{name}]")
        if value := one.grain_boundary.get(name):
            lines.append(layer("grain_boundary", value))
        if held := one.fixed.get(name):
            parts = ["{ where = %s, value = %s }" % (ids([k]), amount(law)) for k, law in held.items()]
            lines.append("fixed = [ %s ]" % ", ".join(parts))
        if name == "electric":
            lines.append('mode = "%s"' % ("steady" if one.kind == "steady" else "transient"))
            continue
        lines.append('initial = { column = "T" }')
        if one.sources:
            parts = ["{ where = %s, value = %s }" % (ids([k]), amount(law)) for k, law in one.sources.items()]
            lines.append("source = [ %s ]" % ", ".join(parts))
        for key, factor, exchange in (
            ("convection", "coefficient", one.convection),
            ("radiation", "emissivity", one.radiation),
        ):
            if exchange:
                some, value, ambient = exchange
                lines.append(
                    "%s = [ { where = %s, %s = %r, ambient = %s } ]" % (key, ids(some), factor, value, amount(ambient))
                )
    (folder / "case.toml").write_text("\n".join(lines) + "\n")
    return folder / "case.toml"


def errors_over_span(truth: Truth, final: Path) -> dict[str, float]:
    """rms over all particles, by field."""
    with final.open(newline="") as stream:
        table = csv.DictReader(line for line in stream if not line.startswith("#"))
        rows = {int(row["id"]): row for row in table}
    out = {}
    for name, column in (("thermal", "temperature"), ("electric", "potential")):
        if name in truth.one.fields and truth.span[name] > 0:
            found = np.array([float(rows[k + 1][column]) for k in range(truth.n)])
            out[name] = float(np.sqrt(np.mean((found - truth.final[name]) ** 2))) / truth.span[name]
    return out


def main(program: str, first: int = 1, last: int = 13, *tolerances: float) -> int:
    judged = refused = faults = 0
    for seed in range(first, last):
        one, draw = random_packing(seed), random.Random(seed)
        truth = Truth(one)
        if not truth.contacts or not truth.conducts:
            continue
        truth.solve()
        tolerance = draw.choice(tolerances or (1e-3, 1e-5))
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            case = write_case(one, folder)
            for method in ["auto", *draw.sample(METHODS, 2)]:
                spec = f"{method}{',' if ':' in method else ':'}rtol={tolerance:g}"
                command = [program, "run", str(case), "--integrator", spec, "--out", str(folder / "out"), "--quiet"]
                run = subprocess.run(command, capture_output=True, text=True, check=False)
                if method == "exponential" and run.returncode == 4:  # scenes that it does not solve
                    refused += 1
                    continue
                judged += 1
                if run.returncode != 0:
                    errors, wrong = {}, f"exit code {run.returncode}: {(run.stderr + run.stdout).strip()}"
                else:
                    errors = errors_over_span(truth, folder / "out" / "final.csv")
                    wrong = ", ".join(f"{f}: {e:.2g} of the span" for f, e in errors.items() if not e <= 3 * tolerance)
                if wrong:
                    faults += 1
                    print(f"seed {seed} {one.kind} {one.neck} {one.conductance} {spec}: {wrong}", flush=True)
    print(f"{judged} runs of packings {first} to {last - 1}, {refused} refused, {faults} faults")
    return 1 if faults or not judged else 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], *map(int, sys.argv[2:4]), *map(float, sys.argv[4:])))
