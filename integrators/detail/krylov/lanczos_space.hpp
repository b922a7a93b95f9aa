#pragma once
/// A Krylov space of a linear right-hand side by Lanczos in the capacity inner product, its basis kept:
///   A V = V T + beta v_{m+1} e_m^T
/// Source: Hochbruck & Lubich (1997), doi:10.1137/S0036142995280572.

#include <array>
#include <atomic>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "core/state_vector.hpp"
#include "integrators/detail/krylov/residual_bound.hpp"
#include "integrators/detail/krylov/vector_store.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

class LanczosSpace {
 public:
  /// Precision in which the basis is kept, [bytes] of a number. The recurrence runs in double precision.
  enum class Storage : std::size_t { single = sizeof(float), full = sizeof(double) };
  /// Single where results may err by `error` of what changes and more: sums of up to a thousand kept vectors
  /// then err by less than a tenth of that.
  [[nodiscard]] static constexpr Storage storage_for(double error) noexcept {
    return error >= 2e-5 ? Storage::single : Storage::full;
  }
  /// The last vectors, from which the next one is made. Spaces that grow one after the other share them.
  using Recent = std::array<StateVector, 3>;

  ///   recent  in use while the space grows
  LanczosSpace(Rhs& rhs, Storage storage, Recent& recent);
  /// Rounding of a kept entry, relative to it.
  [[nodiscard]] double rounding() const noexcept;

  /// Of dimension 0, for times up to `longest` [s], once `fill(first)` has written the first vector [n].
  ///   inflow  what flows in along each vector is kept, too
  template <class Fill>
  void open(double longest, bool inflow, const Fill& fill) {
    clear(longest, inflow);
    fill(recent(0));
    norm_.push_back(norm_of(recent(0)));
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

  /// rms that an error of capacity norm 1 has where the newest vectors are; at most `largest`, what it can be
  /// anywhere. Unit: one over the root of a capacity.
  [[nodiscard]] double rms_over_norm(double largest) const;

  enum class Growth { covers, full, stopped };
  /// Adds vectors until the rms error after `elapsed` is within `allowed`, there are `most`, or somebody
  /// wants to stop.
  ///   rms_over_norm  the most that an rms can be of a capacity norm
  [[nodiscard]] Growth grow(double elapsed, double allowed, double rms_over_norm, const Input& input,
                            std::size_t most, const std::atomic<bool>* stop);

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

  /// v_j times `norm_[j]`, for the newest j.
  [[nodiscard]] std::span<double> recent(std::size_t j) const { return (*recent_)[j % recent_->size()]; }

  Rhs* rhs_;
  double scale_;                                                 ///< root of the mean capacity
  std::variant<VectorStore<float>, VectorStore<double>> basis_;  ///< unit vectors times `scale_`
  Recent* recent_;
  std::vector<double> norm_;  ///< [dimension + 1]; norm_[j] couples j-1 to j
  std::vector<double> alpha_, inflow_;
  ResidualBound bound_;
  bool tracks_inflow_ = false;
};

}  // namespace superstep
