"""Reads the series of `superstep run --vtk` that several processes wrote in pieces, with VTK's own readers, and compares
it with the series of one process.

check_pieces.py ALONE TOGETHER PROCESSES: exit code 0 when both say the same, 77 when there is no VTK here.
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from vtk_files import read, series, vtk


def arrays(data):
    """Values of all arrays by name."""
    return {data.GetArrayName(k): [data.GetArray(k).GetTuple(n) for n in range(data.GetArray(k).GetNumberOfTuples())]
            for k in range(data.GetNumberOfArrays())}


def joined(pieces):
    """Arrays of all pieces one behind the other; pieces without points keep their arrays."""
    names = list(pieces[0])
    assert all(list(piece) == names for piece in pieces), [list(piece) for piece in pieces]
    return {name: [value for piece in pieces for value in piece[name]] for name in names}


def points(data):
    return [data.GetPoint(k) for k in range(data.GetNumberOfPoints())]


def lines(data):
    """(point, point) of each."""
    found, ends = [], vtk.vtkIdList()
    data.GetLines().InitTraversal()
    while data.GetLines().GetNextCell(ends):
        found.append((data.GetPoint(ends.GetId(0)), data.GetPoint(ends.GetId(1))))
    return found


def pieces_of(folder, file, processes):
    names = [one.get("Source") for one in ElementTree.parse(f"{folder}/vtk/{file}").getroot().iter("Piece")]
    assert len(set(names)) == processes, names
    return [read(f"{folder}/vtk/{name}") for name in names]


def same_particles(alone, pieces, whole):
    expected = arrays(alone.GetPointData())
    assert set(expected) == {"id", "radius", "temperature"}, set(expected)
    found = joined([arrays(piece.GetPointData()) for piece in pieces])
    assert found == expected, "values of the pieces, in the order of the particles"
    assert sum((points(piece) for piece in pieces), []) == points(alone)
    for piece in pieces:
        assert piece.GetNumberOfVerts() == piece.GetNumberOfCells() == piece.GetNumberOfPoints()
    assert sorted(arrays(whole.GetPointData())["id"]) == sorted(expected["id"]), "none is there twice"
    assert whole.GetNumberOfVerts() == alone.GetNumberOfVerts()


def same_contacts(alone, pieces, whole):
    data, ends = arrays(alone.GetCellData()), lines(alone)
    assert set(data) == {"overlap", "neck_radius", "flux_temperature", "conductance_temperature"}, set(data)
    assert ends, "there are contacts"
    found = joined([arrays(piece.GetCellData()) for piece in pieces])
    assert sum((lines(piece) for piece in pieces), []) == ends, "in the order of the contacts"
    assert found == data
    own = []
    for piece in pieces:
        assert piece.GetNumberOfVerts() == 0 and piece.GetNumberOfLines() == piece.GetNumberOfCells()
        ghost = [kind for kind, in arrays(piece.GetPointData())["vtkGhostType"]]
        assert set(ghost) <= {0, 1}, set(ghost)
        own += [point for point, kind in zip(points(piece), ghost) if kind == 0]
    assert own == points(alone), "each point belongs to one piece"
    assert whole.GetNumberOfLines() == alone.GetNumberOfLines()


alone, together, processes = sys.argv[1], sys.argv[2], int(sys.argv[3])
for name, same in (("particles", same_particles), ("contacts", same_contacts)):
    expected, found = series(alone, name), series(together, name)
    assert len(found) > 1 and [t for t, _ in found] == [t for t, _ in expected], (found, expected)
    for (t, file), (_, shared) in zip(expected, found):
        pieces = pieces_of(together, shared, processes)
        for piece in pieces:
            assert piece.GetFieldData().GetArray("TimeValue").GetValue(0) == t
        same(read(f"{alone}/vtk/{file}"), pieces, read(f"{together}/vtk/{shared}"))
print(f"{len(found)} times agree")
