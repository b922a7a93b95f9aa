#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "integrators/detail/implicit/incomplete_cholesky.hpp"
#include "integrators/detail/implicit/shifted_solver.hpp"
#include "integrators/integrator.hpp"

namespace superstep {
namespace {

/// Conjugate gradients with all inner products in the capacities, in which I - c J is self-adjoint; the
/// operator is a fused sweep where the scene is linear, else a product with the Jacobian of the moment.
class PcgSolver final : public ShiftedSolver {
 public:
  explicit PcgSolver(Rhs& rhs) : rhs_(rhs), preconditioner_(rhs) {
    if (!rhs.traits().symmetric)
      throw Refused(
          "conjugate gradients need a Jacobian that is symmetric, which conductivities that follow the "
          "temperature and coupled fields do not give; use klu, or cvode with linsol=gmres");
    if (!rhs.traits().linear) (void)rhs.pattern();  // products with J need all of it
    for (auto* v : {&residual_, &direction_, &image_, &preconditioned_}) v->resize(rhs.size());
  }

  bool set(double c, double t, std::span<const double> y) override {
    shift_ = c;
    const auto before = preconditioner_.factorizations();
    const bool ok = preconditioner_.set(c, t, y);
    factorizations_ += preconditioner_.factorizations() - before;
    return ok;
  }

  bool solve(std::span<const double> b, std::span<double> x, double tolerance) override {
    constexpr int most_iterations = 10'000;
    ++solves_;
    std::copy(b.begin(), b.end(), residual_.begin());
    std::fill(x.begin(), x.end(), 0.0);
    const double target = tolerance * std::sqrt(dot(residual_, residual_));
    if (!(target > 0)) return std::isfinite(target);
    preconditioner_.apply(residual_, preconditioned_);
    direction_ = preconditioned_;
    double rz = dot(residual_, preconditioned_);
    for (int k = 0; k < most_iterations; ++k) {
      if (rhs_.traits().linear)
        rhs_.linear_stage({.y1 = direction_.data(), .a = 1, .d = -shift_}, image_);
      else
        preconditioner_.jacobian().multiply(1, -shift_, direction_, image_);
      const double alpha = rz / dot(direction_, image_);
      if (!std::isfinite(alpha)) return false;
      for_each_entry(x.size(), [&](std::size_t i) {
        x[i] += alpha * direction_[i];
        residual_[i] -= alpha * image_[i];
      });
      if (std::sqrt(dot(residual_, residual_)) <= target) return true;
      preconditioner_.apply(residual_, preconditioned_);
      const double next = dot(residual_, preconditioned_), beta = next / rz;
      rz = next;
      for_each_entry(x.size(),
                     [&](std::size_t i) { direction_[i] = preconditioned_[i] + beta * direction_[i]; });
    }
    return false;
  }

 private:
  [[nodiscard]] double dot(const std::vector<double>& a, const std::vector<double>& b) const {
    const auto capacity = rhs_.capacities();
    return rhs_.reduction().sum([&](std::size_t i) { return capacity[i] * a[i] * b[i]; });
  }

  Rhs& rhs_;
  IncompleteCholesky preconditioner_;
  std::vector<double> residual_, direction_, image_, preconditioned_;
  double shift_ = 0;
};

}  // namespace

std::unique_ptr<ShiftedSolver> make_pcg_solver(Rhs& rhs) {
  return std::make_unique<PcgSolver>(rhs);
}

}  // namespace superstep
