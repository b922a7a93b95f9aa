#!/usr/bin/env python3
"""Draws error against CPU time from a work_precision.csv.

usage: work_precision_figure.py CSV SVG TITLE
"""
import csv
import math
import sys

COLOURS = ["#0b6", "#06b", "#b40", "#93c", "#c80", "#088", "#a06", "#666", "#5a0", "#348", "#d47", "#270"]
LEFT, RIGHT, TOP, BOTTOM = 70, 650, 30, 470


def family(row):
    """A method with the setting that makes another method of it."""
    kept = [p for p in row["params"].split(",") if p.split("=")[0] in ("linsol", "solver", "basis")]
    return ":".join([row["integrator"]] + kept)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    with open(sys.argv[1]) as file:
        rows = [row for row in csv.DictReader(file) if row["status"] == "ok" and row["integrator"] != "auto"]
    curves = {}
    for row in rows:
        curves.setdefault(family(row), []).append((float(row["cpu_s"]), float(row["error_worst_relative"])))
    points = [point for curve in curves.values() for point in curve]
    x_low, x_high = (math.log10(f(x for x, _ in points)) for f in (min, max))
    y_low, y_high = math.floor(math.log10(min(y for _, y in points))), math.ceil(math.log10(max(y for _, y in points)))

    def place(x, y):
        return (LEFT + (RIGHT - LEFT) * (math.log10(x) - x_low) / (x_high - x_low),
                BOTTOM - (BOTTOM - TOP) * (math.log10(y) - y_low) / (y_high - y_low))

    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 900 520" font-family="sans-serif" font-size="13">',
           f'<rect width="900" height="520" fill="white"/><text x="{LEFT}" y="18">{sys.argv[3]}</text>']
    for decade in range(y_low, y_high + 1):
        y = place(points[0][0], 10.0**decade)[1]
        out.append(f'<line x1="{LEFT}" x2="{RIGHT}" y1="{y:.1f}" y2="{y:.1f}" stroke="#ddd"/>'
                   f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">1e{decade}</text>')
    for decade in range(math.ceil(x_low), math.floor(x_high) + 1):
        x = place(10.0**decade, points[0][1])[0]
        out.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{TOP}" y2="{BOTTOM}" stroke="#ddd"/>'
                   f'<text x="{x:.1f}" y="{BOTTOM + 18}" text-anchor="middle">{10.0**decade:g}</text>')
    out.append(f'<text x="{(LEFT + RIGHT) / 2}" y="{BOTTOM + 40}" text-anchor="middle">CPU time [s]</text>'
               f'<text x="{LEFT}" y="{BOTTOM + 40}">error over the span</text>')
    for k, (name, curve) in enumerate(sorted(curves.items(), key=lambda item: min(item[1]))):
        colour = COLOURS[k % len(COLOURS)]
        dash = ' stroke-dasharray="5 3"' if k >= len(COLOURS) else ""
        places = [place(*point) for point in sorted(curve)]
        out.append('<polyline points="{}" fill="none" stroke="{}" stroke-width="1.5"{}/>'.format(
            " ".join(f"{x:.1f},{y:.1f}" for x, y in places), colour, dash))
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in places]
        y = TOP + 12 + 18 * k
        out.append(f'<line x1="{RIGHT + 15}" x2="{RIGHT + 40}" y1="{y - 4}" y2="{y - 4}" stroke="{colour}"{dash}/>'
                   f'<text x="{RIGHT + 46}" y="{y}" fill="{colour}">{name}</text>')
    with open(sys.argv[2], "w") as file:
        file.write("\n".join(out + ["</svg>\n"]))


main()
