#!/usr/bin/env python3
"""Times of a sweep: by one process, two threads, two processes; with a halo and without; beside an older program.

usage: processes.py PROGRAM ROUNDS [OLDER]

Every round measures each once, in an order of its own, so that what else the machine does falls on all. Prints the
least and the median over the rounds of the time of a sweep in milliseconds, and ratios of the least: CPU time where
programs are compared, wall time elsewhere.
"""
import json
import os
import random
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
LATTICE = """t_end = {t_end}
[packing]
generator = "lattice"
cells = [{x}, {y}, {z}]
spacing = 1.0
diameter = 1.02
length_unit = "mm"
[material]
density = 7800.0
[contact]
neck = "hertz"
[thermal]
conductivity = 50.0
specific_heat = 460.0
initial = 300.0
fixed = [ {{ where = "top", value = 400.0 }}, {{ where = "bottom", value = 300.0 }} ]
"""
STEP = 1e-3  # s; far below the limit
# spheres along an edge, and sweeps that take about a second
SIZES = {"1e5": (46, 1000), "1e6": (100, 100)}


def write_cases(folder):
    for name, (side, sweeps) in SIZES.items():
        for part, high in (("", side), ("_half", side // 2)):
            case = folder / f"lattice_{name}{part}.toml"
            case.write_text(LATTICE.format(t_end=STEP * sweeps, x=side, y=side, z=high))
    subprocess.run([sys.executable, HERE / "lattice_case.py", "100", folder], check=True)


def launch(program, folder, case, out, spec, *options, processes=1, threads=1):
    words = [program, "run", case, "--integrator", spec, "--quiet", "--threads", str(threads), "--out",
             str(folder / out), *options]
    if processes > 1:
        words = ["mpirun", "--allow-run-as-root", "--bind-to", "none", "-np", str(processes)] + words
    environment = dict(os.environ, OMP_PROC_BIND="true", OMP_PLACES="cores") if threads > 1 else dict(os.environ)
    return subprocess.Popen([str(word) for word in words], cwd=folder, env=environment, stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL)


def a_sweep(folder, out, time="wall_stepping_s"):
    """Time of one [ms]."""
    record = json.loads((folder / out / "run.json").read_text())
    return 1e3 * record[time] / record["counts"]["rhs"]


def finish(*runs):
    for run in runs:
        if run.wait() != 0:
            raise SystemExit(f"{run.args} failed")


def measures(program, older, folder, root):
    """Calls that each give one time, by name."""
    found = {}

    def one(name, case, spec, which=program, time="wall_stepping_s", **how):
        def measure():
            finish(launch(which, folder, case, "one", spec, **how))
            return a_sweep(folder, "one", time)
        found[name] = measure

    def halves(name, case, spec):
        def measure():
            finish(launch(program, folder, case, "left", spec), launch(program, folder, case, "right", spec))
            return max(a_sweep(folder, "left"), a_sweep(folder, "right"))
        found[name] = measure

    nial, million = root / "cases/nial_thermal.toml", folder / "lattice_100.toml"
    for name, case, spec in (("NiAl", nial, "forward-euler:alpha=0.3"), ("jittered 1e6", million, "rkc:rtol=1e-2")):
        one(f"{name}, now", case, spec, time="cpu_stepping_s")
        if older:
            one(f"{name}, older", case, spec, which=older, time="cpu_stepping_s")
    for name in SIZES:
        case, spec = folder / f"lattice_{name}.toml", f"forward-euler:step={STEP}"
        one(f"{name}, one", case, spec)
        one(f"{name}, two threads", case, spec, threads=2)
        one(f"{name}, two processes", case, spec, processes=2)
        halves(f"{name}, two halves alone", folder / f"lattice_{name}_half.toml", spec)
    return found


def triad(program, threads):
    done = subprocess.run([program, "1"], env=dict(os.environ, OMP_NUM_THREADS=str(threads), OMP_PROC_BIND="true",
                                                   OMP_PLACES="cores"), capture_output=True, check=True)
    return float(done.stdout)


def main():
    program, rounds = Path(sys.argv[1]).resolve(), int(sys.argv[2])
    older = Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None
    with tempfile.TemporaryDirectory(prefix="superstep-") as place:
        folder = Path(place)
        write_cases(folder)
        subprocess.run(["cc", "-O3", "-fopenmp", HERE / "triad.c", "-o", folder / "triad"], check=True)
        calls = measures(program, older, folder, HERE.parents[1])
        times, rates = {name: [] for name in calls}, {1: [], 2: []}
        chance = random.Random(1)
        for _ in range(rounds):
            for name in chance.sample(list(calls), len(calls)):
                times[name].append(calls[name]())
            for threads in chance.sample([1, 2], 2):
                rates[threads].append(triad(folder / "triad", threads))
    least = {name: min(found) for name, found in times.items()}
    print(f"{'':28}{'least':>10}{'median':>10}   ms a sweep, {rounds} rounds")
    for name, found in times.items():
        print(f"{name:28}{least[name]:10.4g}{statistics.median(found):10.4g}")
    print(f"triad: {max(rates[1]):.3g} GB/s by one thread, {max(rates[2]):.3g} by two: {max(rates[2]) / max(rates[1]):.3g}")
    for name in SIZES:
        alone = least[f"{name}, one"]
        print(f"{name}: two threads gain {alone / least[f'{name}, two threads']:.3g}, two processes "
              f"{alone / least[f'{name}, two processes']:.3g}; with halo / without "
              f"{least[f'{name}, two processes'] / least[f'{name}, two halves alone']:.3g}")
    for name in ("NiAl", "jittered 1e6") if older else ():
        print(f"{name}: now / older {least[f'{name}, now'] / least[f'{name}, older']:.3g}")


if __name__ == "__main__":
    main()
