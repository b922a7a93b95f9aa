"""Reads the series of `superstep run --vtk` with VTK's own reader and compares it with final.csv.

check_vtk.py FOLDER: exit code 0 when everything agrees, 77 when there is no VTK here.
"""
import csv
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from vtk_files import read, series, vtk


def column(data, name):
    array = data.GetArray(name)
    assert array is not None, f"no array {name}"
    return [array.GetValue(k) for k in range(array.GetNumberOfTuples())]


def frames(name):
    return [(t, read(f"{folder}/vtk/{file}")) for t, file in series(folder, name)]


folder = sys.argv[1]
with open(f"{folder}/final.csv", newline="", encoding="utf-8") as file:
    rows = {int(row["id"]): row for row in csv.DictReader(file)}
columns = next(iter(rows.values())).keys()
fields = [name for name in ("temperature", "potential", "current") if name in columns]
moving = "vx" in columns

particles, contacts = frames("particles"), frames("contacts")
times = [t for t, _ in particles]
assert times == sorted(times) and times[0] == 0 and len(times) > 1, times
assert times == [t for t, _ in contacts]

time, last = particles[-1]
assert last.GetFieldData().GetArray("TimeValue").GetValue(0) == time
assert last.GetNumberOfPoints() == last.GetNumberOfVerts() == len(rows)
ids = column(last.GetPointData(), "id")
assert sorted(ids) == sorted(rows)
final = [rows[one] for one in ids]
if not moving:
    assert ids == list(rows), "particles keep the order of the user's file"
assert column(last.GetPointData(), "radius") == [float(row["r"]) for row in final]
for k, row in enumerate(final):
    assert last.GetPoint(k) == tuple(float(row[axis]) for axis in "xyz"), k
for field in fields:
    assert column(last.GetPointData(), field) == [float(row[field]) for row in final], field
if moving:
    velocity = last.GetPointData().GetArray("velocity")
    assert velocity.GetNumberOfComponents() == 3
    for k, row in enumerate(final):
        assert velocity.GetTuple(k) == tuple(float(row["v" + axis]) for axis in "xyz"), k

_, lines = contacts[-1]
assert lines.GetNumberOfLines() > 0
if moving:  # its number of contacts is that of the last step, and a pair overlaps as far as its spheres do
    with open(f"{folder}/history.csv", newline="", encoding="utf-8") as file:
        step = list(csv.DictReader(file))[-1]
    assert lines.GetNumberOfLines() == int(step["contacts"])
    assert sum(column(lines.GetCellData(), "bonded")) == int(step["bonds"])
overlap = column(lines.GetCellData(), "overlap")
for field in ("temperature", "potential"):  # a particle current is no difference over a contact
    if field not in fields:
        continue
    values = [float(row[field]) for row in final]
    conductance = column(lines.GetCellData(), f"conductance_{field}")
    flux = column(lines.GetCellData(), f"flux_{field}")
    ends = vtk.vtkIdList()
    lines.GetLines().InitTraversal()
    for c in range(lines.GetNumberOfLines()):
        lines.GetLines().GetNextCell(ends)
        i, j = ends.GetId(0), ends.GetId(1)
        assert i != j
        expected = conductance[c] * (values[i] - values[j])
        assert abs(flux[c] - expected) <= 1e-12 * abs(conductance[c]) * (abs(values[i]) + abs(values[j])), c
        if moving:
            reach = float(final[i]["r"]) + float(final[j]["r"])
            assert abs(overlap[c] - reach + math.dist(lines.GetPoint(i), lines.GetPoint(j))) <= 1e-12 * reach, c
print(f"{len(times)} times, {len(final)} particles, {lines.GetNumberOfLines()} contacts agree")
