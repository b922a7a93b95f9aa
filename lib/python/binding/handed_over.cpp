#include "python/binding/handed_over.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"

namespace superstep::python {
namespace {

std::string shape_of(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t k = 0; k < array.ndim(); ++k)
    text += fmt::format("{}{}", k > 0 ? ", " : "", array.shape(k));
  return text + (array.ndim() == 1 ? ",)" : ")");
}

void require_shape(const std::string& name, const char* key, const py::array& array, py::ssize_t columns) {
  const bool fits = columns > 0 ? array.ndim() == 2 && array.shape(1) == columns : array.ndim() == 1;
  if (fits || (array.ndim() == 1 && array.size() == 0)) return;
  throw InputError(fmt::format("{}: {} has the shape {}; it must be {}", name, key, shape_of(array),
                               columns > 0 ? fmt::format("(n, {})", columns) : "(n,)"));
}

/// The array as one of these numbers. Text, objects and, for integers, fractions are not turned into any.
template <class Array>
Array converted(const std::string& name, const char* key, const py::object& given, bool whole) {
  const auto array = py::array::ensure(given);
  const char kind = array ? array.dtype().kind() : 'O';
  const bool fits = kind == 'i' || kind == 'u' || (!whole && (kind == 'f' || kind == 'b')) ||
                    (array && array.size() == 0);  // an empty list has no kind of its own
  if (!fits) {
    PyErr_Clear();
    throw InputError(fmt::format("{}: {} is no array of {}", name, key, whole ? "integers" : "real numbers"));
  }
  auto numbers = Array::ensure(array);
  const auto beyond = [&](const auto value) { return value < 0; };  // what 64 bits with a sign cannot hold
  if (whole && kind == 'u' && std::any_of(numbers.data(), numbers.data() + numbers.size(), beyond))
    throw InputError(fmt::format(
        "{}: {} holds numbers of 2^63 and more; they must fit into 64 bits with a sign", name, key));
  return numbers;
}

}  // namespace

HandedOver::HandedOver(const std::string& name, const py::object& spheres, const py::object& network)
    : name_(name) {
  if (!spheres.is_none()) take_spheres(spheres);
  if (!network.is_none()) take_network(network);
}

std::span<const double> HandedOver::numbers(const py::dict& from, const char* key, py::ssize_t columns) {
  if (!from.contains(key) || from[key].is_none()) return {};
  const auto array = converted<Numbers>(name_, key, from[key], false);
  require_shape(name_, key, array, columns);
  kept_.push_back(array);
  return view(array);
}

std::span<const std::int64_t> HandedOver::integers(const py::dict& from, const char* key,
                                                   py::ssize_t columns) {
  if (!from.contains(key) || from[key].is_none()) return {};
  const auto array = converted<Integers>(name_, key, from[key], true);
  require_shape(name_, key, array, columns);
  kept_.push_back(array);
  return view(array);
}

void HandedOver::take_spheres(const py::dict& spheres) {
  SphereArrays out;
  out.centres = numbers(spheres, "centres", 3);
  out.radii = numbers(spheres, "radii");
  out.ids = integers(spheres, "ids");
  if (spheres.contains("materials")) out.materials = spheres["materials"].cast<std::vector<std::string>>();
  if (spheres.contains("attributes")) {
    const py::dict attributes = spheres["attributes"];
    for (const auto& [key, value] : attributes) {
      const auto name = key.cast<std::string>();
      const auto values = numbers(attributes, name.c_str());
      out.attributes.push_back({name, {values.begin(), values.end()}});
    }
  }
  data_.spheres = std::move(out);
}

void HandedOver::take_network(const py::dict& network) {
  NetworkArrays out;
  out.value = numbers(network, "data");
  out.column = integers(network, "indices");
  out.row_begin = integers(network, "indptr");
  out.ends = integers(network, "edges", 2);
  out.conductance = numbers(network, "conductance");
  if (network.contains("nodes")) out.nodes = network["nodes"].cast<std::size_t>();
  const auto of_nodes = [&](const char* key) {
    const auto values = numbers(network, key);
    if (values.empty() && network.contains(key))
      throw InputError(fmt::format("{}: {} is empty; give one for each node, or leave it out", name_, key));
    return values;
  };
  out.capacity = of_nodes("capacity");
  out.source = of_nodes("source");
  out.initial = of_nodes("initial");
  out.fixed = of_nodes("fixed");
  data_.network = out;
}

}  // namespace superstep::python
