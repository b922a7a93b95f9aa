#pragma once
/// One method over one scene, as Python asks for it.

#include <pybind11/pybind11.h>

namespace superstep::python {

/// Adds `run` to the module: see integration.py for what it means.
void add_run(pybind11::module_& module);

}  // namespace superstep::python
