#pragma once
/// Memory that NumPy arrays and C++ share.

#include <pybind11/numpy.h>

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace superstep::python {

namespace py = pybind11;

/// What a caller hands over: rows one after the other, converted where it is something else.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

template <class Value, int flags>
[[nodiscard]] std::span<const Value> view(const py::array_t<Value, flags>& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// Keeps `owner` alive as long as an array looks at it.
template <class Owner>
[[nodiscard]] py::capsule keeper(std::shared_ptr<Owner> owner) {
  auto* kept = new std::shared_ptr<Owner>(std::move(owner));
  return py::capsule(kept, [](void* pointer) { delete static_cast<std::shared_ptr<Owner>*>(pointer); });
}

/// The vector's own memory as an array of one dimension; nothing is copied.
template <class Value>
[[nodiscard]] py::array_t<Value> hand_over(std::vector<Value> values) {
  auto kept = std::make_shared<std::vector<Value>>(std::move(values));
  Value* const data = kept->data();
  const auto size = static_cast<py::ssize_t>(kept->size());
  return py::array_t<Value>({size}, {static_cast<py::ssize_t>(sizeof(Value))}, data, keeper(std::move(kept)));
}

/// An array over memory that `owner` holds, which nobody may write to.
template <class Owner>
[[nodiscard]] py::array_t<double> read_only(const double* data, std::vector<py::ssize_t> shape,
                                            std::shared_ptr<Owner> owner) {
  py::array_t<double> array(std::move(shape), data, keeper(std::move(owner)));
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

}  // namespace superstep::python
