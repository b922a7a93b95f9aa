#include <limits>

#include "integrators/detail/implicit/kept_jacobian.hpp"
#include "integrators/detail/implicit/shifted_solver.hpp"
#include "integrators/integrator.hpp"
#include "network/cholmod_factor.hpp"

namespace superstep {
namespace {

/// Factorizes C (I - c J), which is symmetric and positive definite.
class CholmodSolver final : public ShiftedSolver {
 public:
  explicit CholmodSolver(Rhs& rhs) : rhs_(rhs), jacobian_(rhs) {
    if (!rhs.traits().symmetric)
      throw Refused("cholmod needs a symmetric Jacobian, which this scene does not have; use klu");
    const auto& pattern = rhs.pattern();
    std::vector<std::int64_t> column_begin{0}, row;
    for (std::size_t j = 0; j < rhs.size(); ++j) {
      for (auto k = pattern.column_begin[j]; k < pattern.column_begin[j + 1]; ++k) {
        const auto i = static_cast<std::size_t>(pattern.row[static_cast<std::size_t>(k)]);
        if (i > j) continue;
        upper_.push_back({static_cast<std::size_t>(k), i, i == j});
        row.push_back(static_cast<std::int64_t>(i));
      }
      column_begin.push_back(static_cast<std::int64_t>(row.size()));
    }
    factor_ = std::make_unique<CholmodFactor>(column_begin, row);
  }

  bool set(double c, double t, std::span<const double> y) override {
    const bool still_valid = jacobian_.bring_to(t, y);
    if (still_valid && c == shift_) return true;
    const auto capacity = rhs_.capacities();
    const auto value = factor_->values();
    for (std::size_t k = 0; k < upper_.size(); ++k) {
      const auto& entry = upper_[k];
      value[k] =
          capacity[entry.row] * ((entry.diagonal ? 1.0 : 0.0) - c * jacobian_.values()[entry.position]);
    }
    ++factorizations_;
    const bool ok = factor_->factorize();
    shift_ = ok ? c : std::numeric_limits<double>::quiet_NaN();
    return ok;
  }

  bool solve(std::span<const double> b, std::span<double> x, double /*tolerance*/) override {
    const auto capacity = rhs_.capacities();
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = capacity[i] * b[i];
    ++solves_;
    return factor_->solve(x, x);
  }

 private:
  struct Entry {
    std::size_t position, row;  ///< in the Jacobian's pattern
    bool diagonal;
  };
  Rhs& rhs_;
  std::vector<Entry> upper_;
  KeptJacobian jacobian_;
  std::unique_ptr<CholmodFactor> factor_;
  double shift_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace

std::unique_ptr<ShiftedSolver> make_cholmod_solver(Rhs& rhs) {
  return std::make_unique<CholmodSolver>(rhs);
}

}  // namespace superstep
