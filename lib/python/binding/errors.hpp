#pragma once
/// C++ errors as Python exceptions.

#include <pybind11/pybind11.h>

namespace superstep::python {

/// Adds InputError (a ValueError) and MethodError (a RuntimeError) to the module; from now on what the
/// library throws arrives as one of them, as OSError, or as MemoryError.
void add_errors(pybind11::module_& module);

}  // namespace superstep::python
