"""Series for ParaView, read by VTK's own readers. Whoever imports this where there is no VTK ends with exit code 77."""

import sys
import xml.etree.ElementTree as ElementTree

try:
    import vtk
except ImportError:
    print("python3-vtk9 is not installed")
    sys.exit(77)


def read(path):
    reader = vtk.vtkXMLPPolyDataReader() if path.endswith(".pvtp") else vtk.vtkXMLPolyDataReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(path))
    reader.SetFileName(path)
    reader.Update()
    assert not errors, f"VTK complains about {path}"
    return reader.GetOutput()


def series(folder, name):
    """(instant, file) of each frame."""
    sets = ElementTree.parse(f"{folder}/vtk/{name}.pvd").getroot().find("Collection").findall("DataSet")
    return [(float(one.get("timestep")), one.get("file")) for one in sets]
