#pragma once
/// PETSc as a library: it is begun once, what it says goes wrong is kept, and what it hands out is given
/// back.

#include <petscsys.h>

#include <string>

namespace superstep::petsc {

/// What went wrong last, in the package's words.
[[nodiscard]] const std::string& last_message();

/// Throws std::runtime_error, with that message, where `code` says that `what` failed.
void check(PetscErrorCode code, const char* what);

/// Once, for the whole life of the program; where a launcher started it, that has been done. Throws
/// std::runtime_error.
void initialize();

template <class Handle, auto destroy>
class Owned {
 public:
  Owned() = default;
  ~Owned() { destroy(&handle_); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  operator Handle() const noexcept { return handle_; }
  Handle* fill() noexcept { return &handle_; }

 private:
  Handle handle_ = nullptr;
};

}  // namespace superstep::petsc
