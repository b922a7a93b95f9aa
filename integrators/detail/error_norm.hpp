#pragma once
/// Errors in units of what the run allows: the same measure for every method.

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "integrators/integrator.hpp"

namespace superstep {

/// rms over all entries of e_i / allowed_f, f being the entry's field. A field in which nothing may move has
/// no part in it.
class ErrorNorm {
 public:
  void prepare(const Rhs& rhs, std::span<const double> allowed) {
    reduction_ = &rhs.reduction();
    const auto fields = rhs.fields();
    inverse_.clear();
    for (const double a : allowed) inverse_.push_back(a > 0 ? 1 / a : 0);
    field_of_entry_.assign(fields.size() > 1 ? rhs.size() : 0, 0);
    for (std::size_t f = 0; f < fields.size() && fields.size() > 1; ++f)
      for (std::size_t k = 0, i = fields[f].offset; k < fields[f].count; ++k, i += fields[f].stride)
        field_of_entry_[i] = static_cast<std::uint8_t>(f);
  }

  template <class Error>
  [[nodiscard]] double of(Error error) const {
    const auto n = static_cast<double>(std::max<std::size_t>(1, reduction_->total()));
    const auto squares = [&](auto inverse) {
      return reduction_->sum([&](std::size_t i) {
        const double e = error(i) * inverse(i);
        return e * e;
      });
    };
    if (inverse_.size() == 1) {
      const double one = inverse_.front();
      return std::sqrt(squares([one](std::size_t) { return one; }) / n);
    }
    return std::sqrt(squares([this](std::size_t i) { return inverse_[field_of_entry_[i]]; }) / n);
  }
  /// 1/allowed of an entry [1/K or 1/V].
  [[nodiscard]] double weight(std::size_t i) const noexcept {
    return inverse_.size() == 1 ? inverse_.front() : inverse_[field_of_entry_[i]];
  }

 private:
  const Reduction* reduction_ = nullptr;
  std::vector<double> inverse_;
  std::vector<std::uint8_t> field_of_entry_;  // [n], only with several fields
};

}  // namespace superstep
