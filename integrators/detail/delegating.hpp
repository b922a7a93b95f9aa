#pragma once
/// An integrator that leaves the work to another one, chosen in `prepare`.

#include <memory>

#include "integrators/integrator.hpp"

namespace superstep {

/// Derived classes set `method_` in `prepare`; before that, or after a refusal, there is nothing to tell.
class DelegatingIntegrator : public Integrator {
 public:
  void start(double t, std::span<const double> y) final { method_->start(t, y); }
  Outcome advance(double t_out) final { return method_->advance(t_out); }
  [[nodiscard]] double time() const noexcept final { return method_ ? method_->time() : 0; }
  [[nodiscard]] std::span<const double> state() const noexcept final {
    return method_ ? method_->state() : std::span<const double>();
  }
  [[nodiscard]] const Statistics& statistics() const noexcept final {
    static const Statistics nothing;
    return method_ ? method_->statistics() : nothing;
  }

 protected:
  std::unique_ptr<Integrator> method_;
};

}  // namespace superstep
