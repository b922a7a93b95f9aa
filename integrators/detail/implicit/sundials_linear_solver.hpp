#pragma once
/// The linear solvers that the integrators of SUNDIALS can be given for I - gamma J.

#include <exception>
#include <memory>
#include <string>

#include "integrators/detail/implicit/sundials.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

/// The package that an integrator is of; each has names of its own for the same calls.
enum class SundialsPackage { cvode, arkode };

/// One kind of linear solver with everything that callbacks need.
class SundialsLinearSolver {
 public:
  virtual ~SundialsLinearSolver() = default;
  /// Attaches itself to an initialised integrator whose user data begin with a SundialsCallbackData. Throws
  /// on failure.
  virtual void attach(SundialsPackage package, void* integrator) = 0;
  /// Makes I - gamma J at (t, y) ready; 0 = it is, > 0 = a smaller step may help.
  virtual int linear_system(double t, N_Vector y, SUNMatrix matrix, booleantype jacobian_ok,
                            booleantype* jacobian_new, double gamma);
  /// Whether that is why the package's own solver failed.
  [[nodiscard]] virtual bool out_of_memory() const noexcept { return false; }
};

/// What SUNDIALS hands to callbacks as user data.
struct SundialsCallbackData {
  Rhs* rhs = nullptr;
  void* integrator = nullptr;
  SundialsLinearSolver* linear_solver = nullptr;
  std::exception_ptr thrown;  ///< in a callback
};

/// Work of a callback. What it throws cannot pass through C: it is kept for whoever called the package, which
/// is told to give up.
template <class Work>
[[nodiscard]] int carried_out(SundialsCallbackData& data, const Work& work) noexcept {
  try {
    return work();
  } catch (...) {
    data.thrown = std::current_exception();
    return -1;
  }
}

/// Throws std::runtime_error when a SUNDIALS call returned an error flag.
void check_sundials(int flag, const char* what);

/// `klu` with an ordering (metis, amd, colamd); `cholmod`: Cholesky; `pcg`: conjugate gradients in the
/// capacity inner product; `gmres`: SUNDIALS' SPGMR; the last two preconditioned by incomplete Cholesky.
/// Throws Refused.
[[nodiscard]] std::unique_ptr<SundialsLinearSolver> make_sundials_linear_solver(const std::string& kind,
                                                                                const std::string& ordering,
                                                                                Rhs& rhs, N_Vector y,
                                                                                SUNContext context);

}  // namespace superstep
