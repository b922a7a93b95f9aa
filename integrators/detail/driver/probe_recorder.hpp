#pragma once
/// Values of the plan's probes at step ends, handed to its history.

#include <span>
#include <vector>

#include "integrators/integrator.hpp"

namespace superstep {

class ProbeRecorder {
 public:
  void prepare(const Plan& plan) {
    history_ = plan.history;
    probes_ = plan.probes;
    values_.resize(probes_.size());
  }
  [[nodiscard]] ProbeHistory* history() const noexcept { return history_; }
  ///   y  the whole state of the scene
  void record(double t, std::span<const double> y) {
    if (!history_) return;
    for (std::size_t k = 0; k < probes_.size(); ++k) values_[k] = y[probes_[k]];
    history_->append(t, values_);
  }
  /// Entries of the whole state.
  [[nodiscard]] const std::vector<std::size_t>& entries() const noexcept { return probes_; }

 private:
  std::vector<std::size_t> probes_;
  std::vector<double> values_;
  ProbeHistory* history_ = nullptr;
};

}  // namespace superstep
