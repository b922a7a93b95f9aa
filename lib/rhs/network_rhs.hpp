#pragma once
/// Conduction of one field with constant conductances: fixed values, sources, convection and radiation.
/// Linear unless it radiates.

#include <memory>
#include <optional>
#include <string>

#include "rhs/kernels/field_operator.hpp"
#include "rhs/kernels/jacobian_assembly.hpp"

namespace superstep {

class NetworkRhs final : public Rhs {
 public:
  ///   field_name, unit   what the entries are
  ///   pair_step [s]      pairwise critical step from particle contributions only
  ///   keep_network       see FieldOperator
  NetworkRhs(Network network, std::string field_name, std::string unit, double pair_step,
             bool keep_network = true);
  /// One field of a larger right-hand side, whose counters its sweeps add to.
  NetworkRhs(std::shared_ptr<FieldOperator> field, std::string field_name, std::string unit, double pair_step,
             RhsCounters& counters);

  [[nodiscard]] double spectral_bound(double t, std::span<const double> y) override;
  [[nodiscard]] std::span<const double> capacities() const noexcept override { return network().capacity; }
  [[nodiscard]] double inflow(double t, std::span<const double> y) override;
  [[nodiscard]] double linear_inflow(std::span<const double> v) const override {
    return field_->conduction_inflow(v);
  }
  [[nodiscard]] double radius_beyond_blocks(double t, std::span<const double> y) const override;
  [[nodiscard]] std::optional<std::string> law_violation(std::span<const double> y,
                                                         double slack = 0) override;

  [[nodiscard]] std::vector<InputShape> input_shapes() const override { return field_->input_shapes(); }
  void enter(double begin, double end) override { field_->enter(begin, end); }
  void leave() override { field_->leave(); }

  [[nodiscard]] const Network& network() const noexcept { return field_->network(); }
  /// See FieldOperator::assume_cache.
  void assume_cache(std::size_t bytes) noexcept { field_->assume_cache(bytes); }
  /// Entries of the rows that are here, padding included.
  [[nodiscard]] std::size_t entries() const noexcept { return field_->entries(); }
  /// Rates [n] added to f from now on [K/s or V/s]; they must outlive their use. Empty = none.
  void drive(std::span<const double> rate);

 private:
  NetworkRhs(double bound, Network network, std::string field_name, std::string unit, double pair_step,
             bool keep_network);
  void do_stage(double t, const Stage& stage, std::span<double> out) override;
  void do_chain(std::span<ChainedStage> stages, bool with_inflow, ChainObserver* observer) override;
  void do_linear_stage(const Stage& stage, std::span<double> out) override;
  void do_block_product(std::size_t field, std::span<const double> v, std::span<double> out) override;
  void do_jacobian(double t, std::span<const double> y, std::span<double> values) override;
  [[nodiscard]] SparsePattern build_pattern() override;

  [[nodiscard]] double drive_inflow() const;
  void find_facts(double pair_step);

  std::shared_ptr<FieldOperator> field_;
  std::span<const double> drive_;
  bool driven_ = false;  ///< here or elsewhere
  JacobianAssembly assembly_;
  double bound_;
};

}  // namespace superstep
