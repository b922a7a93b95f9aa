#!/usr/bin/env python3
"""Memory per particle of a run over a cubic lattice, from reading the case to the last of 100 sweeps.

usage: memory.py PROGRAM [SIDE[:PROCESSES]]...    default: 46 100 215 46:2 100:2 215:2 (1e5, 1e6, 1e7 particles)

Peaks of all processes are added up; what a process without a scene takes is subtracted and printed.
"""
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from processes import LATTICE, STEP

SWEEPS = 100


def run(program, folder, processes, *words):
    launcher = ["mpirun", "--oversubscribe", "--allow-run-as-root", "--bind-to", "none", "-np", str(processes)]
    began = time.monotonic()
    done = subprocess.run((launcher if processes > 1 else []) + [program, *words], cwd=folder, capture_output=True)
    return done, time.monotonic() - began


def peak(program, folder, side, processes):
    """(peak of all processes [B], wall time [s], record of the run)"""
    case = folder / "lattice.toml"
    case.write_text(LATTICE.format(t_end=STEP * SWEEPS, x=side, y=side, z=side))
    done, wall = run(program, folder, processes, "run", case, "--integrator", f"forward-euler:step={STEP}", "--quiet",
                     "--out", folder / "out")
    if done.returncode != 0:
        raise SystemExit(f"{side}, {processes} processes: exit {done.returncode}: {done.stderr.decode()[-500:]}")
    record = json.loads((folder / "out/run.json").read_text())
    return 1e6 * record["peak_memory_mb"], wall, record


def main():
    program = str(Path(sys.argv[1]).resolve())
    jobs = [(int(side), int(processes or 1)) for side, _, processes in
            (word.partition(":") for word in sys.argv[2:] or ["46", "100", "215", "46:2", "100:2", "215:2"])]
    print("particles processes   B/particle   without a scene [MB]   from start to final.csv [s]   s a sweep", flush=True)
    nothing = {}
    with tempfile.TemporaryDirectory(prefix="superstep-", dir=".") as place:
        folder = Path(place).resolve()
        for side, processes in jobs:
            if processes not in nothing:
                nothing[processes] = peak(program, folder, 10, processes)[0]
            most, wall, record = peak(program, folder, side, processes)
            sweep = record["wall_stepping_s"] / record["counts"]["rhs"]
            print(f"{side ** 3:9} {processes:9}   {(most - nothing[processes]) / side ** 3:10.1f}   "
                  f"{nothing[processes] / 1e6:20.0f}   {wall:27.1f}   {sweep:9.3g}", flush=True)


if __name__ == "__main__":
    main()
