#pragma once
/// One method for all stabilised families: error-controlled or fixed steps on the three-term engine.

#include <memory>
#include <vector>

#include "integrators/detail/error_norm.hpp"
#include "integrators/detail/explicit/spectral_radius.hpp"
#include "integrators/registry.hpp"
#include "integrators/schemes/stabilised_schemes.hpp"
#include "integrators/schemes/three_term.hpp"

namespace superstep {

/// The families that one method offers, by their orders; the last one is the default.
using OfferedFamilies = std::vector<const StabilisedFamily*>;

/// Keys rtol, step and stages, and `order` where several families are offered.
[[nodiscard]] std::vector<OptionKey> stabilised_keys(const OfferedFamilies& families);
/// The method of the family that the options ask for.
[[nodiscard]] std::unique_ptr<Method> make_stabilised(const OfferedFamilies& families,
                                                      const Options& options);

class Stabilised final : public OneStepMethod {
 public:
  /// Throws UsageError for `stages` without `step` or not of this family, or both tolerance and `step`.
  Stabilised(const StabilisedFamily& family, const Options& options);

  void prepare(Rhs& rhs, const Task& task) override;
  [[nodiscard]] double rtol() const override { return fixed_step_ > 0 ? 0 : rtol_; }
  [[nodiscard]] Pace pace() const override { return fixed_step_ > 0 ? Pace::multiples : Pace::error; }
  [[nodiscard]] double own_step(double t, std::span<const double> y) override;
  [[nodiscard]] bool stability_varies() const override { return fixed_step_ == 0 && radius_.varies(); }
  [[nodiscard]] double longest_step(double t, std::span<const double> y) override;
  [[nodiscard]] double stable_step(double t, std::span<const double> y) override;
  [[nodiscard]] double convenient(double h, double longest) const override;
  [[nodiscard]] int order() const override { return family_.controlled_order; }
  [[nodiscard]] double share() const override;
  [[nodiscard]] std::span<const double> slope() const override { return derivative_; }
  void restart(double t, std::span<const double> y, bool smooth) override;
  [[nodiscard]] Trial attempt(const Step& step, StateVector& state, StateVector& next) override;
  void accept(const Step& step, std::span<const double> state) override;
  void reset_counts() override { most_stages_ = 0; }
  void add_counts(Statistics& statistics) const override;

 private:
  [[nodiscard]] double estimate_error(const Step& step, const StateVector& y, const StateVector& next);
  [[nodiscard]] double estimate_error_of_finish(double h, const StateVector& y,
                                                const StateVector& next) const;

  const StabilisedFamily& family_;
  double rtol_, fixed_step_;
  int fixed_stages_, stage_limit_ = 0, most_stages_ = 0;
  Rhs* rhs_ = nullptr;
  ErrorNorm norm_;
  SpectralRadius radius_;
  double radius_now_ = 0;  ///< at the start of the step
  ThreeTermScheme scheme_;
  ThreeTermEngine engine_;
  StateVector derivative_, next_derivative_;
};

}  // namespace superstep
