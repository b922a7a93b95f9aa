/// VTK XML files of points (VTP, VTU) as packings.

#include "packing/formats/vtk/vtk_xml.hpp"

namespace superstep {
namespace {

bool recognises(const PackingFile& file) {
  return is_vtk_xml(file.content);
}

Packing read(const PackingFile& file) {
  const VtkPoints vtk = read_vtk_xml(file.path, file.content);
  return packing_of_points(file, vtk.points, vtk.data);
}

}  // namespace

PackingFormat vtk_xml_format() {
  return {"VTK XML (VTP, VTU)", recognises, read, true};
}

}  // namespace superstep
