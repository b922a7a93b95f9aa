#pragma once
/// A Krylov space of a linear right-hand side by Lanczos in the capacity inner product, its basis kept:
///   A V = V T + beta v_{m+1} e_m^T
/// Source: Hochbruck & Lubich (1997), doi:10.1137/S0036142995280572.

#include <atomic>
#include <optional>
#include <span>
#include <vector>

#include "integrators/detail/krylov/residual_bound.hpp"
#include "integrators/detail/krylov/vector_store.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

class LanczosSpace {
 public:
  explicit LanczosSpace(Rhs& rhs) : rhs_(&rhs), basis_(rhs.size()) {}

  /// Of dimension 0, for times up to `longest` [s], once `fill(first)` has written the first vector [n].
  ///   inflow  what flows in along each vector is kept, too
  template <class Fill>
  void open(double longest, bool inflow, const Fill& fill) {
    clear(longest, inflow);
    const auto first = basis_.at(0);
    fill(first);
    norm_.push_back(norm_of(first));
  }
  [[nodiscard]] std::size_t dimension() const noexcept { return alpha_.size(); }
  /// No vector more is to be had: the space holds all that the first one excites.
  [[nodiscard]] bool is_whole() const noexcept { return norm_.back() == 0; }
  /// Capacity norm of the first vector.
  [[nodiscard]] double length() const noexcept { return norm_.front(); }
  [[nodiscard]] std::span<const double> alpha() const noexcept { return alpha_; }  ///< [dimension] of T
  /// beta()[j] couples j to j+1 [dimension], the last one leads out of the space.
  [[nodiscard]] std::span<const double> beta() const noexcept { return std::span(norm_).subspan(1); }
  [[nodiscard]] std::span<const double> inflow() const noexcept { return inflow_; }  ///< of unit vectors

  /// An input q of which the small solution u' = e_1 q(t) - T u, u(0) = 0 is wanted.
  struct Input {
    double largest = 1;    ///< of |q| up to then
    double variation = 1;  ///< all that q goes up and down until then, its first step from 0 included
  };
  /// Bound, in the capacity norm, of the error of length() V u after `elapsed`: the integral of the residual.
  /// A network contracts in that norm.
  [[nodiscard]] double bound_at(double elapsed, double largest = 1) const;
  /// What the error will be. The bound takes what the residual leaves for undamped, and where it oscillates
  /// from node to node it is a hundred times too large. Where the recurrence has become regular, as it does
  /// in networks without stiff parts, it is continued by its own mirror image: what that changes of the
  /// response to a step, which is more the longer ago that was, times all that q goes up and down.
  [[nodiscard]] double estimate_at(double elapsed, const Input& input) const;

  enum class Growth { covers, full, stopped };
  /// Adds vectors until the error after `elapsed` is within `allowed` (in the capacity norm), there are
  /// `most`, or somebody wants to stop.
  [[nodiscard]] Growth grow(double elapsed, double allowed, const Input& input, std::size_t most,
                            const std::atomic<bool>* stop);

  /// Adds the sum of factors[k][j] times unit vector j to `states[k]` [n], where that is not empty.
  void add_to(std::span<const std::span<double>> states, std::vector<std::vector<double>> factors) const;
  /// The sum of factors[j] times entry i of unit vector j.
  [[nodiscard]] double entry(std::size_t i, std::span<const double> factors) const;

 private:
  /// One sweep.
  void add_vector();
  /// T continued by its mirror image; nothing where it is not regular.
  struct Continued {
    std::vector<double> alpha, beta;
  };
  [[nodiscard]] std::optional<Continued> continued() const;
  void clear(double longest, bool inflow);
  [[nodiscard]] double norm_of(std::span<const double> v) const;

  Rhs* rhs_;
  VectorStore basis_;         ///< v_j times `norm_[j]`
  std::vector<double> norm_;  ///< [dimension + 1]; norm_[j] couples j-1 to j
  std::vector<double> alpha_, inflow_;
  ResidualBound bound_;
  bool tracks_inflow_ = false;
};

}  // namespace superstep
