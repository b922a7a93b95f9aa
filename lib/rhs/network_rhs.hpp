#pragma once
/// Conduction of one field with constant conductances: fixed values, sources, convection and radiation.
/// Linear unless it radiates.

#include <memory>

#include "rhs/field_operator.hpp"
#include "rhs/jacobian_assembly.hpp"

namespace superstep {

class NetworkRhs final : public Rhs {
 public:
  ///   field_name, unit   what the entries are
  ///   pair_step [s]      pairwise critical step from particle contributions only
  NetworkRhs(Network network, std::string field_name, std::string unit, double pair_step);
  /// One field of a larger right-hand side, whose counters its sweeps add to.
  NetworkRhs(std::shared_ptr<FieldOperator> field, std::string field_name, std::string unit, double pair_step,
             RhsCounters& counters);

  [[nodiscard]] double spectral_bound(double t, std::span<const double> y) override;
  [[nodiscard]] double pair_step_without_interface() const override { return pair_step_; }
  [[nodiscard]] std::span<const double> capacities() const noexcept override { return network().capacity; }
  [[nodiscard]] double inflow(double t, std::span<const double> y) override;
  [[nodiscard]] double linear_inflow(std::span<const double> v) const override {
    return field_->conduction_inflow(v);
  }
  [[nodiscard]] double source_rate(std::size_t /*field*/) const override {
    return field_->largest_source_rate();
  }
  [[nodiscard]] double mean_source_rate(std::size_t /*field*/) override;
  [[nodiscard]] double radius_beyond_blocks(double t, std::span<const double> y) const override;

  [[nodiscard]] const Network& network() const noexcept { return field_->network(); }
  /// See FieldOperator::assume_cache.
  void assume_cache(std::size_t bytes) noexcept { field_->assume_cache(bytes); }
  /// Rates [n] added to f from now on [K/s or V/s]; they must outlive their use. Empty = none.
  void drive(std::span<const double> rate) noexcept { drive_ = rate; }

 private:
  void do_stage(double t, const Stage& stage, std::span<double> out) override;
  void do_chain(std::span<ChainedStage> stages, bool with_inflow, ChainObserver* observer) override;
  void do_linear_stage(const Stage& stage, std::span<double> out) override;
  void do_block_product(std::size_t field, std::span<const double> v, std::span<double> out) override;
  void do_jacobian(double t, std::span<const double> y, std::span<double> values) override;
  [[nodiscard]] SparsePattern build_pattern() override;

  [[nodiscard]] double drive_inflow() const noexcept;

  std::shared_ptr<FieldOperator> field_;
  std::span<const double> drive_;
  JacobianAssembly assembly_;
  double pair_step_, bound_;
};

}  // namespace superstep
