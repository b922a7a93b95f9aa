/// The compiled part of the Python package `superstep`; what users see of it is in superstep/*.py.

#include <pybind11/stl.h>

#include <memory>

#include "bench/host/machine.hpp"
#include "case/case.hpp"
#include "case/checks/effective.hpp"
#include "core/error.hpp"
#include "integrators/registry.hpp"
#include "parallel/stay_alone.hpp"
#include "python/binding/arrays.hpp"
#include "python/binding/benchmark.hpp"
#include "python/binding/bound_scene.hpp"
#include "python/binding/errors.hpp"
#include "python/binding/handed_over.hpp"
#include "python/binding/run.hpp"

namespace superstep::python {
namespace {

std::unique_ptr<BoundScene> load_file(const std::string& path) {
  const py::gil_scoped_release released;
  return std::make_unique<BoundScene>(parse_case(path), CaseData{});
}

std::unique_ptr<BoundScene> build(const std::string& text, const std::string& file, const py::object& spheres,
                                  const py::object& network) {
  const HandedOver handed(file, spheres, network);
  const py::gil_scoped_release released;
  return std::make_unique<BoundScene>(TomlTable::parse_unseen(text, file), handed.data());
}

const FieldScene& field_of(const BoundScene& bound, std::size_t field) {
  return bound.scene().fields.at(field);
}

py::list fields(const BoundScene& bound) {
  py::list out;
  for (const auto& field : bound.scene().fields)
    out.append(py::make_tuple(field.name, field.unit, field.steady));
  return out;
}

py::tuple edges(const BoundScene& bound, std::size_t field) {
  Graph graph = field_at_start(bound.scene(), field_of(bound, field)).graph;
  return py::make_tuple(hand_over(std::vector(graph.i)), hand_over(std::vector(graph.j)),
                        hand_over(std::move(graph.conductance)));
}

py::array_t<double> initial(const BoundScene& bound) {
  std::vector<double> y(bound.unknowns().size());
  bound.unknowns().to_user(bound.scene().initial, y.data());
  return hand_over(std::move(y));
}

/// Particles of the packing; None for a network given directly.
py::object centres(const BoundScene& bound) {
  const auto& packed = bound.scene().packed;
  if (!packed) return py::none();
  std::vector<double> out;
  out.reserve(3 * packed->packing.size());
  for (const Vec3& centre : packed->packing.centre) out.insert(out.end(), {centre.x, centre.y, centre.z});
  const auto rows = static_cast<py::ssize_t>(packed->packing.size());
  return hand_over(std::move(out)).reshape({rows, py::ssize_t{3}});
}

py::object radii(const BoundScene& bound) {
  const auto& packed = bound.scene().packed;
  if (!packed) return py::none();
  return hand_over(std::vector(packed->packing.radius));
}

/// One dimension, whatever the caller's is.
std::span<const double> vector_of(const Numbers& y) {
  if (y.ndim() != 1) throw InputError("y must have one dimension: a value for each unknown");
  return view(y);
}

py::array_t<double> rhs(BoundScene& bound, double t, const Numbers& y) {
  const auto values = vector_of(y);
  std::vector<double> rates(bound.unknowns().size());
  bound.rhs(t, values, rates.data());
  return hand_over(std::move(rates));
}

py::tuple jacobian(BoundScene& bound, double t, const Numbers& y) {
  const auto values = vector_of(y);
  const auto& pattern = bound.jacobian_pattern();
  std::vector<double> data(pattern.row.size());
  bound.jacobian(t, values, data.data());
  return py::make_tuple(hand_over(std::move(data)), hand_over(std::vector(pattern.row)),
                        hand_over(std::vector(pattern.column_begin)));
}

py::array_t<double> values_on_nodes(BoundScene& bound, std::size_t field, double t, const Numbers& y) {
  (void)field_of(bound, field);
  return hand_over(bound.values_on_nodes(field, t, vector_of(y)));
}

py::dict effective(const BoundScene& bound, std::size_t field) {
  const auto found = effective_conductivity(bound.scene(), field_of(bound, field));
  py::dict out;
  out["value"] = found.value;
  out["flow"] = found.flow;
  out["length"] = found.length;
  out["area"] = found.area;
  out["note"] = found.note;
  return out;
}

py::list methods() {
  py::list out;
  for (const auto& entry : integrators()) {
    py::list keys;
    for (const auto& key : entry.keys) keys.append(key.name);
    out.append(py::make_tuple(entry.name, entry.summary, keys));
  }
  return out;
}

void add_scene(py::module_& module) {
  py::class_<BoundScene>(module, "Scene")
      .def_property_readonly("file", [](const BoundScene& b) { return b.scene().file; })
      .def_property_readonly("name", [](const BoundScene& b) { return b.scene().name; })
      .def_property_readonly("title", [](const BoundScene& b) { return b.scene().title; })
      .def_property_readonly("t_end", [](const BoundScene& b) { return b.scene().t_end; })
      .def_property_readonly("output_times", [](const BoundScene& b) { return b.scene().output_times; })
      .def_property_readonly("warnings", [](const BoundScene& b) { return b.scene().warnings; })
      .def_property_readonly("nodes", [](const BoundScene& b) { return b.scene().nodes(); })
      .def_property_readonly("fields", &fields)
      .def_property_readonly(
          "ids", [](const BoundScene& b) { return hand_over(std::vector(field_of(b, 0).graph.id)); })
      .def_property_readonly("unknown_field",
                             [](const BoundScene& b) { return hand_over(std::vector(b.unknowns().field())); })
      .def_property_readonly("unknown_node",
                             [](const BoundScene& b) { return hand_over(std::vector(b.unknowns().node())); })
      .def_property_readonly("initial", &initial)
      .def_property_readonly("centres", &centres)
      .def_property_readonly("radii", &radii)
      .def("edges", &edges)
      .def("capacities", [](const BoundScene& b,
                            std::size_t f) { return hand_over(std::vector(field_of(b, f).graph.capacity)); })
      .def("rhs", &rhs)
      .def("jacobian", &jacobian)
      .def("values_on_nodes", &values_on_nodes)
      .def("effective_conductivity", &effective);
}

}  // namespace
}  // namespace superstep::python

PYBIND11_MODULE(_core, module) {
  namespace here = superstep::python;
  superstep::stay_alone();  // under mpirun each interpreter has scenes of its own
  module.doc() = "The compiled part of superstep; see the package.";
  here::add_errors(module);
  here::add_scene(module);
  module.def("load_file", &here::load_file);
  module.def("build", &here::build);
  module.def("methods", &here::methods);
  module.attr("version") = superstep::program_version();
  here::add_run(module);
  here::add_bench(module);
}
