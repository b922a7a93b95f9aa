#pragma once
/// What the propagators over SUNDIALS' packages share: vectors, tolerances, linear solver, inflow, probes,
/// counts.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "integrators/detail/error_norm.hpp"
#include "integrators/detail/implicit/sundials_linear_solver.hpp"
#include "integrators/integrator.hpp"

namespace superstep {

class SundialsPropagator : public Propagator {
 public:
  [[nodiscard]] double rtol() const final { return rtol_; }
  [[nodiscard]] double time() const noexcept final { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept final { return state_; }
  [[nodiscard]] bool stops_on_the_way() const noexcept final { return true; }
  void reset_counts() final { counts_ = {}; }
  void add_counts(Statistics& statistics) const final;
  [[nodiscard]] std::string choice() const final { return choice_; }

 protected:
  /// What a package has counted since its last restart.
  struct PackageCounts {
    long int steps = 0, rejected = 0, setups = 0, iterations = 0;
  };

  ///   linsol, ordering  names, or "auto"
  SundialsPropagator(double rtol, std::string linsol, std::string ordering)
      : rtol_(rtol), linsol_(std::move(linsol)), ordering_(std::move(ordering)) {}

  /// New vectors for a run; the package's own memory must be gone by then.
  void prepare_vectors(Rhs& rhs, const Task& task);
  /// Attaches the linear solver that was named, or the fastest one; returns its name.
  std::string attach_linear_solver(SundialsPackage package, void* memory);
  /// y becomes the present state and the start of what the package is to integrate.
  void begin_anew(std::span<const double> y);
  void take_counts(const PackageCounts& counts);
  /// Takes a vector's entries for the present state.
  void show(N_Vector values);
  /// A step failed; `flag` is the package's. Throws what a callback threw, and std::bad_alloc.
  [[nodiscard]] Outcome failure(const char* package, double t, int flag) const;

  /// The k-th derivative of the package's interpolant at t into `derivative_`; false = it has none.
  [[nodiscard]] virtual bool differentiate(double t, int k) = 0;
  /// Adds what entered between two instants of a step, by Gauss points on its interpolant.
  void add_inflow(double begin, double end);
  /// Hands the Taylor polynomials of the probes at a step's end to the history.
  void record_taylor(double t, int order, ProbeHistory& history);

  /// f, as packages want it.
  static int derivative(double t, N_Vector y, N_Vector ydot, void* data) noexcept;
  /// Weights of local errors: the run's tolerance times a factor that makes what is delivered proportional.
  static int weights(N_Vector y, N_Vector inverse, void* data) noexcept;
  /// The last message of a package; `self` is this propagator.
  static void keep_message(int code, const char* module, const char* function, char* message,
                           void* self) noexcept;

  double rtol_;
  double part_of_share_ = 1;  ///< of what local errors may usually have
  std::string linsol_, ordering_, choice_;
  Rhs* rhs_ = nullptr;
  const Plan* plan_ = nullptr;
  std::span<const Instant> instants_;
  std::vector<double> state_;
  // Destroyed from the last to the first: the package's memory, in the derived class, before what it uses.
  sundials::Context context_;
  sundials::Vector y_, derivative_;
  std::unique_ptr<SundialsLinearSolver> linear_solver_;
  SundialsCallbackData callback_data_;
  double t_ = 0;
  bool stepped_ = false;  ///< since probes were recorded last
  bool has_history_ = false;

 private:
  [[nodiscard]] bool is_lost() noexcept;
  [[nodiscard]] bool is_to_stop() const noexcept;

  std::uint64_t evaluations_ = 0;  // of f in the step at hand
  bool lost_ = false;
  ErrorNorm norm_;
  std::vector<double> taylor_;
  std::string message_;
  Statistics counts_, before_restart_;
};

}  // namespace superstep
