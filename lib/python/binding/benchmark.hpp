#pragma once
/// Every method of a benchmark over one scene, as columns.

#include <pybind11/pybind11.h>

namespace superstep::python {

/// Adds `bench` to the module: see benchmark.py for what it means.
void add_bench(pybind11::module_& module);

}  // namespace superstep::python
