#!/usr/bin/env python3
"""Writes a thermal case of N^3 spheres on a jittered lattice, six to seven contacts each.

usage: lattice_case.py N FOLDER   (N = 100: one million particles)

Radii vary by 2 %, centres by 1 % of the spacing, and a diagonal bond is added at some places by larger spheres,
so that rows differ in length as in a packing. Particles are written in random order: what a simulation leaves.
"""
import random
import sys
from pathlib import Path

CASE = """title = "Jittered lattice, {count} spheres"
t_end = {t_end}
output_times = [{early}, {middle}, {t_end}]

[packing]
file = "lattice_{n}.csv"
length_unit = "mm"

[material]
density = 7800.0
[contact]
neck = "hertz"
conductance = "series"
[thermal]
conductivity = 50.0
specific_heat = 460.0
initial = 300.0
fixed = [ {{ where = {{ layer = {{ side = "top", thickness = 0.9 }} }}, value = 400.0 }},
          {{ where = {{ layer = {{ side = "bottom", thickness = 0.9 }} }}, value = 300.0 }} ]
[bench]
baseline = "forward-euler"
integrators = ["auto", "forward-euler"]
"""


def case_values(n):
    """Ends after some two and a half of the slowest time constants, which grow with the square of the side."""
    t_end = 0.05 * n * n
    return dict(n=n, count=n**3, early=0.02 * t_end, middle=0.2 * t_end, t_end=t_end)


def main():
    n, folder = int(sys.argv[1]), Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    rng = random.Random(1)
    uniform = rng.uniform
    cells = list(range(n * n * n))
    rng.shuffle(cells)
    with open(folder / f"lattice_{n}.csv", "w") as out:
        out.write("id,x,y,z,radius\n")
        for number, cell in enumerate(cells):
            x, y, z = cell % n, cell // n % n, cell // (n * n)
            r = 0.53 * uniform(0.98, 1.02) if uniform(0, 1) > 0.05 else 0.75
            out.write(f"{number},{x + uniform(-0.01, 0.01):.9f},{y + uniform(-0.01, 0.01):.9f},"
                      f"{z + uniform(-0.01, 0.01):.9f},{r:.6f}\n")
    (folder / f"lattice_{n}.toml").write_text(CASE.format(**case_values(n)))


main()
