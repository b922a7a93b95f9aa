#pragma once
/// What a tolerance means, the same for every adaptive method:
///   w_i = rtol * (S_f + |y_i|) + atol,   S_f = span of the entry's field

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/options.hpp"
#include "integrators/integrator.hpp"

namespace superstep {

/// Keys `rtol` and `atol` with the given default of rtol.
[[nodiscard]] std::vector<OptionKey> tolerance_keys(const std::string& default_rtol);

class ErrorWeights {
 public:
  void prepare(Rhs& rhs, const Plan& plan, double rtol, double atol);
  /// Back to the range of initial and fixed values.
  void restart();
  /// Takes computed values into the spans.
  void widen(std::span<const double> y);
  /// Fills weights [n] for values y.
  void fill(std::span<const double> y, std::span<double> weights) const;
  /// Weighted rms norm sqrt(mean((e_i / w_i)^2)) with w_i taken at max(|y_i|, |z_i|).
  template <class Error>
  [[nodiscard]] double norm(Error error, std::span<const double> y, std::span<const double> z) const {
    const auto weight = weight_at();
    const double sum = rhs_->reduction().sum([&](std::size_t i) {
      const double e = error(i) / weight(i, std::max(std::abs(y[i]), std::abs(z[i])));
      return e * e;
    });
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, rhs_->size())));
  }

 private:
  void update_spans();
  /// weight(i, |y_i|); with one field the span is one number, with several it is looked up per entry.
  [[nodiscard]] auto weight_at() const {
    return
        [this, one = field_span_.size() == 1, span = field_span_.front()](std::size_t i, double magnitude) {
          return rtol_ * ((one ? span : field_span_[field_of_entry_[i]]) + magnitude) + atol_;
        };
  }

  const Rhs* rhs_ = nullptr;
  double rtol_ = 0, atol_ = 0;
  std::vector<double> source_rise_;  // [fields] what sources add to the mean by the end
  std::vector<FieldRange> initial_, ranges_;
  std::vector<double> field_span_;
  std::vector<std::uint8_t> field_of_entry_;  // [n], only with several fields
};

}  // namespace superstep
