#pragma once
/// Owning handles for SUNDIALS objects.

#include <arkode/arkode_arkstep.h>
#include <cvodes/cvodes.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_types.h>

#include <memory>
#include <span>
#include <stdexcept>

#include "integrators/detail/implicit/state_n_vector.hpp"

namespace superstep::sundials {

/// Frees a SUNDIALS object by its own function.
template <auto destroy>
struct Deleter {
  template <class Object>
  void operator()(Object* object) const noexcept {
    destroy(object);
  }
};

inline void free_context(SUNContext context) noexcept {
  SUNContext_Free(&context);
}
inline void free_cvode(void* memory) noexcept {
  CVodeFree(&memory);
}
inline void free_arkode(void* memory) noexcept {
  ARKStepFree(&memory);
}

using Context = std::unique_ptr<std::remove_pointer_t<SUNContext>, Deleter<free_context>>;
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, Deleter<N_VDestroy>>;
using Matrix = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, Deleter<SUNMatDestroy>>;
using LinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, Deleter<SUNLinSolFree>>;
using Cvode = std::unique_ptr<void, Deleter<free_cvode>>;
using Arkode = std::unique_ptr<void, Deleter<free_arkode>>;

[[nodiscard]] inline Context make_context() {
  SUNContext context = nullptr;
  if (SUNContext_Create(nullptr, &context) != 0) throw std::runtime_error("SUNDIALS cannot create a context");
  return Context(context);
}

}  // namespace superstep::sundials
