"""Reads the series of `superstep run --vtk` with VTK's own reader and compares it with final.csv.

check_vtk.py FOLDER: exit code 0 when everything agrees, 77 when there is no VTK here.
"""
import csv
import sys
import xml.etree.ElementTree as ElementTree

try:
    import vtk
except ImportError:
    print("python3-vtk9 is not installed")
    sys.exit(77)


def read(path):
    reader = vtk.vtkXMLPolyDataReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(path))
    reader.SetFileName(path)
    reader.Update()
    assert not errors, f"VTK complains about {path}"
    return reader.GetOutput()


def column(data, name):
    array = data.GetArray(name)
    assert array is not None, f"no array {name}"
    return [array.GetValue(k) for k in range(array.GetNumberOfTuples())]


def series(folder, name):
    sets = ElementTree.parse(f"{folder}/vtk/{name}.pvd").getroot().find("Collection").findall("DataSet")
    return [(float(one.get("timestep")), read(f"{folder}/vtk/{one.get('file')}")) for one in sets]


folder = sys.argv[1]
with open(f"{folder}/final.csv", newline="", encoding="utf-8") as file:
    final = list(csv.DictReader(file))
fields = [name for name in ("temperature", "potential") if name in final[0]]

particles, contacts = series(folder, "particles"), series(folder, "contacts")
times = [t for t, _ in particles]
assert times == sorted(times) and times[0] == 0 and len(times) > 1, times
assert times == [t for t, _ in contacts]

time, last = particles[-1]
assert last.GetFieldData().GetArray("TimeValue").GetValue(0) == time
assert last.GetNumberOfPoints() == last.GetNumberOfVerts() == len(final)
assert column(last.GetPointData(), "id") == [int(row["id"]) for row in final]
assert column(last.GetPointData(), "radius") == [float(row["r"]) for row in final]
for k, row in enumerate(final):
    assert last.GetPoint(k) == tuple(float(row[axis]) for axis in "xyz"), k
for field in fields:
    assert column(last.GetPointData(), field) == [float(row[field]) for row in final], field

_, lines = contacts[-1]
assert lines.GetNumberOfLines() > 0
for field in fields:
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
print(f"{len(times)} times, {len(final)} particles, {lines.GetNumberOfLines()} contacts agree")
