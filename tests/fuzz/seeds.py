#!/usr/bin/env python3
"""Writes what each fuzzer begins with, made from the cases: seeds.py FOLDER"""

import pathlib
import struct
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]

SPECS = ["auto", "auto:rtol=1e-6", "forward-euler:fraction=1,bound=lanczos", "sts:n=20,nu=1e-3", "sts:n=auto,rtol=1e-2",
         "rkc:rtol=1e-6", "rkl:step=0.1,stages=5", "rock", "trapezoidal", "cvode:rtol=1e-6,linsol=pcg", "exponential",
         "esdirk"]

PACKINGS = {
    "csv": "# length_unit = \"mm\"\nid,x,y,z,radius,material\n0,0,0,0,1,a\n1,1.9,0,0,1,b\n",
    "dump": "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n0 1\n0 1\n0 1\n"
            "ITEM: ATOMS id type x y z radius\n1 1 0 0 0 0.5\n2 1 0.9 0 0 0.5\n",
    "data": "LAMMPS data\n\n2 atoms\n1 atom types\n\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms # sphere\n\n"
            "1 1 1.0 2500 0 0 0\n2 1 1.0 2500 0.9 0 0\n",
    "yade": "#format x_y_z_r\n0 0 0 1\n1.9 0 0 1\n",
    "mercury": "2 0 0 0 0 1 1 1\n0 0 0 0 0 0 1 0 0 0 0 0 0 0\n1.9 0 0 0 0 0 1 0 0 0 0 0 0 0\n",
}

RESULTS = """{"schema": "superstep.results", "schema_version": 1, "version": "0", "machine": {}, "repetitions": 1,
 "threads": 1, "cases": [{"case": "rod", "baseline": "forward-euler", "rows": [{"case": "rod",
 "integrator": "forward-euler", "params": "", "status": "ok", "steps": 1, "rejected": 0, "rhs": 1, "jacobians": 0,
 "factorizations": 0, "solves": 0, "error_rms": 1e-3, "cpu_stepping_samples_s": [1.0], "yardstick_samples_s": [1.0]}]}]}
"""


def write(folder, name, content):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())


def main():
    out = pathlib.Path(sys.argv[1])
    for case in SOURCE.glob("cases/*.toml"):
        write(out / "case", case.name, case.read_bytes())
    nodes, edges = (SOURCE / f"cases/networks/chain_{what}.csv" for what in ("nodes", "edges"))
    head = lambda path: b"".join(path.read_bytes().splitlines(keepends=True)[:8])
    write(out / "network", "chain", head(nodes) + b"---\n" + head(edges))
    write(out / "network", "small", "id,capacity,source,initial,fixed\n0,1,0,0,\n1,1,0,0,5\n---\ni,j,conductance\n0,1,2\n")
    for name, text in PACKINGS.items():
        write(out / "packing", name, text)
    for k, spec in enumerate(SPECS):
        write(out / "spec", str(k), spec)
    write(out / "results", "small", RESULTS)
    write(out / "checkpoint", "numbers", struct.pack("<QQdQ", 1, 0, 0.5, 2))
    write(out / "checkpoint", "empty", bytes(200))


if __name__ == "__main__":
    main()
