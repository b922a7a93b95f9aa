#include "python/binding/errors.hpp"

#include "core/error.hpp"
#include "integrators/integrator.hpp"

namespace superstep::python {
namespace {

// They live as long as the interpreter; translators may hold no object that is destroyed after it.
PyObject* input_error = nullptr;
PyObject* method_error = nullptr;

PyObject* new_exception(pybind11::module_& module, const char* name, const char* doc, PyObject* base) {
  PyObject* type = PyErr_NewExceptionWithDoc((std::string("superstep.") + name).c_str(), doc, base, nullptr);
  if (!type) throw pybind11::error_already_set();
  module.add_object(name, type);  // which keeps a reference of its own
  return type;
}

PyObject* type_of(const Error& error) {
  switch (error.code()) {
    case ExitCode::usage:
    case ExitCode::input:
      return input_error;
    case ExitCode::output:
      return PyExc_OSError;
    case ExitCode::numerical:
      return method_error;
    default:
      return PyExc_RuntimeError;
  }
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Error& error) {
    PyErr_SetString(type_of(error), error.what());
  } catch (const Refused& refused) {
    PyErr_SetString(method_error, refused.what());
  }
}

}  // namespace

void add_errors(pybind11::module_& module) {
  input_error = new_exception(
      module, "InputError",
      "What was handed over is wrong; the message names place, value, rule and way out.", PyExc_ValueError);
  method_error = new_exception(module, "MethodError",
                               "A method refused the scene or failed on it.\n\n"
                               "Attributes (where a run raised it): status, reason, and result, what was "
                               "reached before.",
                               PyExc_RuntimeError);
  pybind11::register_exception_translator(translate);
}

}  // namespace superstep::python
