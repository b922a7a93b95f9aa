#include "integrators/detail/petsc/package.hpp"

#include <cstdlib>
#include <stdexcept>

namespace superstep::petsc {
namespace {

std::string message;

PetscErrorCode keep_message(MPI_Comm, int, const char* function, const char*, PetscErrorCode code,
                            PetscErrorType kind, const char* text, void*) {
  if (kind == PETSC_ERROR_INITIAL)
    message = std::string(function ? function : "") + ": " + (text ? text : "");
  return code;
}

struct Finish {
  ~Finish() {
    PetscBool over = PETSC_FALSE;
    PetscFinalized(&over);
    if (!over) PetscFinalize();
  }
};

}  // namespace

const std::string& last_message() {
  return message;
}

void check(PetscErrorCode code, const char* what) {
  if (code == 0) return;
  throw std::runtime_error(std::string("PETSc: ") + what + " failed: " + message);
}

void initialize() {
  PetscBool there = PETSC_FALSE;
  PetscInitialized(&there);
  if (!there) {
    // MPI is alone here: it starts no helper and leaves signals to the program.
    ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    ::setenv("OMPI_MCA_opal_signal", "", 0);
    // Two programs that begin at once would make and remove the same folder under each other's feet.
    ::setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
    for (const char* option : {"-skip_petscrc", "-no_signal_handler", "-options_left"})
      check(PetscOptionsSetValue(nullptr, option, option == std::string("-options_left") ? "no" : nullptr),
            "an option");
    check(PetscInitializeNoArguments(), "PetscInitialize");
    static const Finish finish;
  }
  static const bool errors_are_kept = [] {
    check(PetscPushErrorHandler(keep_message, nullptr), "PetscPushErrorHandler");
    return true;
  }();
  (void)errors_are_kept;
}

}  // namespace superstep::petsc
