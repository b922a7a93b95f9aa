#pragma once
/// The linear solvers that CVODE can be given for I - gamma J.

#include <memory>
#include <string>

#include "integrators/detail/implicit/sundials.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

/// One kind of linear solver with everything that CVODE's callbacks need.
class CvodeLinearSolver {
 public:
  virtual ~CvodeLinearSolver() = default;
  /// Attaches itself to an initialised CVODE whose user data begin with a CvodeCallbackData. Throws on
  /// failure.
  virtual void attach(void* cvode) = 0;
};

/// What CVODE hands to callbacks as user data.
struct CvodeCallbackData {
  Rhs* rhs = nullptr;
  void* integrator = nullptr;
  CvodeLinearSolver* linear_solver = nullptr;
};

/// Throws std::runtime_error when a SUNDIALS call returned an error flag.
void check_sundials(int flag, const char* what);

/// `klu` with an ordering (metis, amd, colamd); `cholmod`: Cholesky; `pcg`: conjugate gradients in the
/// capacity inner product; `gmres`: SUNDIALS' SPGMR; the last two preconditioned by incomplete Cholesky.
/// Throws Refused.
[[nodiscard]] std::unique_ptr<CvodeLinearSolver> make_cvode_linear_solver(const std::string& kind,
                                                                          const std::string& ordering,
                                                                          Rhs& rhs, N_Vector y,
                                                                          SUNContext context);

}  // namespace superstep
