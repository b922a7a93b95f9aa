#!/usr/bin/env python3
"""How the lead over forward Euler grows with the number of particles: work against error on lattices.

usage: lead_by_size.py PROGRAM FOLDER CSV SVG N...     (N^3 particles each; 22 46 100 takes some ten minutes)

Runs `superstep bench --work-precision` on the lattice of every size, the reference being the exponential, which
the program compares with itself at a ten times looser tolerance. For every error level the fastest method that
reaches it is set against forward Euler at the certified limit, the longest step that is safe: a lower bound of
the lead where Euler misses the level.
"""
import csv
import math
import subprocess
import sys
from pathlib import Path

LEVELS = [1e-2, 1e-3, 1e-4, 1e-6, 1e-8]  # of the span
EULER = "forward-euler:fraction=1"
SPECS = [EULER, "sts:n=auto,rtol=1e-2", "sts:n=auto,rtol=1e-3"]
SPECS += [f"rkc:rtol=1e-{d}" for d in (2, 3, 4, 5, 7)] + [f"rkl:rtol=1e-{d}" for d in (3, 5)]
SPECS += [f"rock:rtol=1e-{d}" for d in (4, 6, 8)] + [f"cvode:linsol=pcg,rtol=1e-{d}" for d in (3, 5, 7)]
SPECS += [f"exponential:rtol=1e-{d}" for d in (1, 2, 3, 4, 6, 8, 10)]
COLUMNS = ["particles", "unknowns", "error_level", "fastest", "cpu_s", "error", "sweeps", "euler_cpu_s", "euler_error",
           "euler_sweeps", "lead", "euler_reaches_level", "reference_error"]


def study(program, folder, n):
    subprocess.run([sys.executable, Path(__file__).with_name("lattice_case.py"), str(n), folder], check=True)
    out = folder / f"work_precision_{n}"
    command = [program, "bench", folder / f"lattice_{n}.toml", "--work-precision", "--out", out,
               "--repetitions", "3" if n < 60 else "1"]
    for spec in SPECS:
        command += ["--integrator", spec]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    with open(next(out.rglob("work_precision.csv"))) as file:
        return [row for row in csv.DictReader(file) if row["status"] == "ok"]


def leads(n, points):
    euler = next(p for p in points if p["integrator"] == "forward-euler")
    for level in LEVELS:
        reached = [p for p in points if float(p["error_worst_relative"]) <= level]
        if not reached:
            continue
        best = min(reached, key=lambda p: float(p["cpu_s"]))
        yield dict(particles=n**3, unknowns=best["unknowns"], error_level=f"{level:g}",
                   fastest=f"{best['integrator']}:{best['params']}", cpu_s=best["cpu_s"],
                   error=best["error_worst_relative"], sweeps=best["sweeps"], euler_cpu_s=euler["cpu_s"],
                   euler_error=euler["error_worst_relative"], euler_sweeps=euler["sweeps"],
                   lead=f"{float(euler['cpu_s']) / float(best['cpu_s']):.4g}",
                   euler_reaches_level="yes" if float(euler["error_worst_relative"]) <= level else "no",
                   reference_error=best["reference_error"])


def exponent(points):
    """Slope of log(lead) over log(particles), least squares."""
    x, y = [math.log(p) for p, _ in points], [math.log(lead) for _, lead in points]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def figure(rows):
    curves = {}
    for row in rows:
        curves.setdefault(row["error_level"], []).append((row["particles"], float(row["lead"])))
    particles, values = [p for c in curves.values() for p, _ in c], [v for c in curves.values() for _, v in c]
    left, right = math.log10(min(particles)), math.log10(max(particles))
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))

    def place(p, v):
        return (60 + 380 * (math.log10(p) - left) / max(right - left, 1e-9),
                300 - 280 * (math.log10(v) - low) / (high - low))

    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 680 350" font-family="sans-serif" font-size="11">',
             '<rect width="680" height="350" fill="white"/>',
             '<text x="60" y="14">CPU of forward Euler at its certified limit over CPU of the fastest method; error relative to the span</text>',
             '<text x="250" y="340" text-anchor="middle">particles</text>']
    for decade in range(low, high + 1):
        y = place(10**left, 10**decade)[1]
        parts.append(f'<line x1="60" x2="440" y1="{y:.1f}" y2="{y:.1f}" stroke="#ddd"/>'
                     f'<text x="54" y="{y + 4:.1f}" text-anchor="end">{10**decade:g}</text>')
    for decade in range(math.ceil(left), math.floor(right) + 1):
        x = place(10**decade, 10**low)[0]
        parts.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="20" y2="300" stroke="#ddd"/>'
                     f'<text x="{x:.1f}" y="318" text-anchor="middle">1e{decade}</text>')
    labels = []  # bottom up, so that none hides another
    for (level, points), colour in zip(curves.items(), ["#b40", "#c80", "#0b6", "#06b", "#93c"]):
        line = " ".join("{:.1f},{:.1f}".format(*place(*point)) for point in points)
        parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
        parts += ['<circle cx="{:.1f}" cy="{:.1f}" r="3" fill="{}"/>'.format(*place(*point), colour) for point in points]
        law = f", lead ~ n^{exponent(points):.2f}" if len(points) > 1 else ""
        labels.append((place(*points[-1])[1] + 4, colour, f"error {level}{law}"))
    free = float("inf")
    for y, colour, text in sorted(labels, reverse=True):
        free = min(y, free)
        parts.append(f'<text x="448" y="{free:.1f}" fill="{colour}">{text}</text>')
        free -= 13
    return "\n".join(parts + ["</svg>\n"])


def main():
    if len(sys.argv) < 6:
        sys.exit(__doc__)
    program, folder, table, drawing = (Path(argument) for argument in sys.argv[1:5])
    rows = [row for n in map(int, sys.argv[5:]) for row in leads(n, study(program.resolve(), folder, n))]
    with open(table, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    drawing.write_text(figure(rows))


main()
