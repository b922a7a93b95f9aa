#pragma once
/// Conduction of one field with constant conductances, fixed values and sources:
///   C_i dy_i/dt = sum_j K_ij (y_j - y_i) + Q_i        Rojek & Nisar 2026, eqs 1 and 5

#include <memory>

#include "network/network.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

class NetworkRhs final : public Rhs {
 public:
  ///   field_name, unit   what the entries are
  ///   pair_step [s]      pairwise critical step from particle contributions only
  NetworkRhs(Network network, std::string field_name, std::string unit, double pair_step);

  [[nodiscard]] double spectral_bound(double t, std::span<const double> y) const override;
  [[nodiscard]] double pair_step_without_interface() const override { return pair_step_; }
  [[nodiscard]] std::span<const double> capacities() const noexcept override { return network_.capacity; }
  [[nodiscard]] double inflow(double t, std::span<const double> y) const override;
  [[nodiscard]] double linear_inflow(std::span<const double> v) const override;
  [[nodiscard]] double source_rate() const override;

  [[nodiscard]] const Network& network() const noexcept { return network_; }

 private:
  struct GhostRate {
    std::int32_t row, ghost;
    double rate;  ///< K/C [1/s]
  };
  struct SourceRate {
    std::int32_t row;
    double rate;  ///< Q/C [K/s or V/s]
  };

  void do_stage(double t, const Stage& stage, std::span<double> out) override;
  void do_linear_stage(const Stage& stage, std::span<double> out) override;
  void do_jacobian(double t, std::span<const double> y, std::span<double> values) override;
  [[nodiscard]] SparsePattern build_pattern() const override;

  Network network_;
  double pair_step_, bound_;
  std::vector<double> rate_;  ///< [nnz] K_ij/C_i [1/s]
  std::vector<GhostRate> ghosts_;
  std::vector<SourceRate> sources_;
};

/// The certified bounds of the spectral radius of C^-1 K [1/s]; both are rigorous.
struct SpectralBounds {
  double edge = 0;  ///< max over free edges of d_i/C_i + d_j/C_j (a node with only fixed neighbours: d_i/C_i)
  double gershgorin = 0;  ///< max over nodes of (2 d_i - g_i)/C_i, g_i = conductance to fixed nodes
  [[nodiscard]] double smallest() const noexcept { return edge < gershgorin ? edge : gershgorin; }
};
[[nodiscard]] SpectralBounds spectral_bounds(const Network& network);

}  // namespace superstep
