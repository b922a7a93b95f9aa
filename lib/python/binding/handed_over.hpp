#pragma once
/// Arrays of a Python caller as the data of a case.

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "case/memory/case_data.hpp"
#include "python/binding/arrays.hpp"

namespace superstep::python {

/// Keeps the arrays that its data points into.
class HandedOver {
 public:
  ///   spheres  None, or a dict: centres (n, 3), radii (n,), ids, materials, attributes {name: (n,)}
  ///   network  None, or a dict: data, indices, indptr, or else edges (m, 2), conductance (m,) and nodes;
  ///   with
  ///            capacity, source, initial, fixed (n,)
  /// Throws InputError for shapes that are others.
  HandedOver(const std::string& name, const py::object& spheres, const py::object& network);

  [[nodiscard]] const CaseData& data() const noexcept { return data_; }

 private:
  void take_spheres(const py::dict& spheres);
  void take_network(const py::dict& network);
  /// The array under a key; empty where there is none.
  ///   columns  it has two dimensions and so many columns; 0 = one dimension
  [[nodiscard]] std::span<const double> numbers(const py::dict& from, const char* key,
                                                py::ssize_t columns = 0);
  [[nodiscard]] std::span<const std::int64_t> integers(const py::dict& from, const char* key,
                                                       py::ssize_t columns = 0);

  std::string name_;
  std::vector<py::object> kept_;
  CaseData data_;
};

}  // namespace superstep::python
