#pragma once
/// Krylov spaces of the Jacobian from one vector b, for h phi_k(hJ) b with several h and k from one basis.
///
/// New vectors are made orthogonal to the last `depth` ones only. Where conduction dominates, J is nearly
/// symmetric and two are enough; elsewhere more of them. J V_m = V_m H_m + v_{m+1} h e_m^T holds whatever the
/// basis, so that the residual of the small solution is known and its integral over the step bounds the
/// error in a contractive network: incomplete orthogonalisation can cost vectors, not accuracy.

#include <limits>

#include "integrators/detail/exponential/scaled_jacobian.hpp"
#include "integrators/detail/krylov/phi_contour.hpp"

namespace superstep {

class KrylovSpace {
 public:
  ///   most   vectors that the space may have;  depth  that a new one is made orthogonal to
  void prepare(const Rhs& rhs, const ErrorNorm& norm, ScaledJacobian& jacobian, std::size_t most,
               std::size_t depth);

  /// Starts a space from b. Nothing is multiplied yet.
  template <class Entry>
  void begin(Entry b);
  /// Takes or adds vectors until the error of h phi_k(hJ) b is below `allowed`, in units of the run's
  /// tolerance. False when there would be too many.
  [[nodiscard]] bool reach(double h, int k, double allowed);
  /// Longest step below h for which the vectors at hand are enough: allowed(step) is the error of it.
  template <class Allowed>
  [[nodiscard]] double longest(double h, int k, const Allowed& allowed);

  /// What a result is made of: the sum of factor * step * phi_k(step J) b.
  struct Term {
    double step = 0;
    int k = 1;
    double factor = 1;
  };
  /// add(i, value) with entry i of the combination of up to two terms, for every i.
  template <class Add>
  void combine(std::span<const Term> terms, Add add);
  /// The same for two combinations in one pass over the basis.
  template <class Add>
  void combine(std::span<const Term> first, std::span<const Term> second, Add add);

  [[nodiscard]] double length() const noexcept {
    return length_;
  }  ///< of b, in units of the tolerance a second
  [[nodiscard]] std::size_t products() const noexcept { return products_; }
  void reset_products() noexcept { products_ = 0; }

 private:
  void extend();
  void weigh_start();
  [[nodiscard]] double error(std::size_t m, double h, int k);
  [[nodiscard]] double part_in_norm(std::size_t vector);
  void find_coefficients(std::span<const Term> terms, std::vector<double>& out);

  const Reduction* reduction_ = nullptr;
  const ErrorNorm* norm_ = nullptr;
  ScaledJacobian* jacobian_ = nullptr;
  std::size_t most_ = 0, depth_ = 2;
  std::vector<StateVector> basis_;    ///< grows when first needed
  std::vector<double> part_in_norm_;  ///< [vectors] rms of D^-1 v in units of the tolerance, < 0 = not known
  HessenbergBand matrix_;
  PhiContour contour_;
  std::size_t size_ = 0;  ///< columns of the matrix
  std::size_t used_ = 0;  ///< vectors that the last `reach` found enough
  bool exhausted_ = false;
  double length_ = 0;
  std::size_t products_ = 0;
  std::vector<double> coefficient_, second_coefficient_;
};

template <class Entry>
void KrylovSpace::begin(Entry b) {
  if (basis_.empty()) basis_.emplace_back(reduction_->size());
  auto& v = basis_.front();
  const auto scale = jacobian_->scale();
  length_ = std::sqrt(reduction_->sum([&](std::size_t i) {
    v[i] = scale[i] * b(i);
    return v[i] * v[i];
  }));
  weigh_start();
}

template <class Allowed>
double KrylovSpace::longest(double h, int k, const Allowed& allowed) {
  constexpr double shrink = 0.9;
  constexpr int most_trials = 60;
  for (int trial = 0; trial < most_trials; ++trial) {
    h *= shrink;
    if (error(used_, h, k) <= allowed(h)) break;
  }
  return h;
}

template <class Add>
void KrylovSpace::combine(std::span<const Term> terms, Add add) {
  combine(terms, {}, [&](std::size_t i, double value, double) { add(i, value); });
}

template <class Add>
void KrylovSpace::combine(std::span<const Term> first, std::span<const Term> second, Add add) {
  find_coefficients(first, coefficient_);
  find_coefficients(second, second_coefficient_);
  const auto inverse = jacobian_->inverse();
  const bool both = !second.empty();
  for_ranges(inverse.size(), inverse.size(), [&](std::size_t begin, std::size_t end) {
    constexpr std::size_t block = 256;
    std::array<double, block> a, b;
    for (std::size_t from = begin; from < end; from += block) {
      const std::size_t count = std::min(block, end - from);
      a.fill(0.0);
      b.fill(0.0);
      for (std::size_t j = 0; j < used_; ++j) {
        const double* v = basis_[j].data() + from;
        const double c = coefficient_[j];
        for (std::size_t i = 0; i < count; ++i) a[i] += c * v[i];
        if (!both) continue;
        const double d = second_coefficient_[j];
        for (std::size_t i = 0; i < count; ++i) b[i] += d * v[i];
      }
      for (std::size_t i = 0; i < count; ++i)
        add(from + i, inverse[from + i] * a[i], inverse[from + i] * b[i]);
    }
  });
}

}  // namespace superstep
