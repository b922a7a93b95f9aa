#pragma once
/// One field on its network: conduction, fixed values, sources, convection and radiation.
///   C_i dy_i/dt = sum_j K_ij (y_j - y_i) + sum_g K_ig (y_g(t) - y_i) + Q_i(t) + r_i (y_env(t)^4 - y_i^4)
/// Source: Rojek & Nisar 2026, eqs 1, 3 and 5. What a scene does not have costs nothing: its list is empty.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "network/network.hpp"
#include "rhs/kernels/cuts/boundary_rows.hpp"
#include "rhs/kernels/skewed_passes.hpp"
#include "rhs/kernels/sliced_rows.hpp"
#include "rhs/kernels/sweep.hpp"
#include "rhs/kernels/varying_sweep.hpp"
#include "rhs/rhs.hpp"
#include "rhs/tabled_inputs.hpp"

namespace superstep {

/// The certified bounds of the spectral radius of C^-1 K [1/s]; both are rigorous.
struct SpectralBounds {
  double edge = 0;  ///< max over free edges of d_i/C_i + d_j/C_j (a node with only fixed neighbours: d_i/C_i)
  double gershgorin = 0;  ///< max over nodes of (2 d_i - g_i)/C_i, g_i = conductance to fixed nodes
  [[nodiscard]] double smallest() const noexcept { return edge < gershgorin ? edge : gershgorin; }
};
[[nodiscard]] SpectralBounds spectral_bounds(const Network& network);

/// Adds a breakpoint for every knot of a table.
///   weight  rms rate of change per unit of the table;  field  its number in the right-hand side
void add_knots(const TimeTable& table, double weight, std::size_t field, std::vector<Breakpoint>& points);

/// Stands for the column of a row that another process has.
inline constexpr auto column_elsewhere = static_cast<std::size_t>(-1);

/// Passes on what stands in columns that are here.
template <class Add>
auto only_here(Add add) {
  return [add](std::size_t row, std::size_t column, double value) mutable {
    if (column != column_elsewhere) add(row, column, value);
  };
}

class Flanks;
struct NetworkPart;

class FieldOperator {
 public:
  ///   keep_network  false: its rows are given back, of which sweeps have rates of their own, and no new
  ///                 conductances can be set
  explicit FieldOperator(Network network, bool keep_network = true);

  [[nodiscard]] std::size_t size() const noexcept { return network_.size(); }
  [[nodiscard]] const Network& network() const noexcept { return network_; }
  /// Entries that a sweep passes over, padding included.
  [[nodiscard]] std::size_t entries() const noexcept {
    return rate_.entries() + (boundary_ ? boundary_->entries() : 0);
  }

  /// out = stage with f = the whole right-hand side of the field at (t, y1). One sweep.
  void stage(double t, const Stage& stage, double* out);
  /// The same with conductances formed from values of the nodes, see `varying_sweep`; those of the ghost
  /// edges are the ones last set.
  void varying_stage(double t, ConductanceMean mean, const SlicedRows& geometry, const NodePair* nodes,
                     const Stage& stage, double* out);
  /// The stages of a chain, see Rhs::chain.
  ///   drive  rates [n] added to f [K/s or V/s], or empty
  void chain(std::span<ChainedStage> stages, bool with_inflow, std::span<const double> drive,
             ChainObserver* observer);
  /// What of a chain's data may stay in the cache [bytes]; decides how many stages pass over the network
  /// together. Results do not depend on it.
  void assume_cache(std::size_t bytes) noexcept { cache_bytes_ = bytes; }
  /// Stages that pass over the network together.
  [[nodiscard]] std::size_t chain_depth() const noexcept;
  /// Stages that share a halo, as of the first chain; 1 where each has its own.
  [[nodiscard]] std::size_t stages_of_a_halo() const noexcept;
  /// out = stage with f = conduction alone, fixed values taken as 0: J y1 without radiation. One sweep.
  void conduction_stage(const Stage& stage, double* out) const;
  /// Values of the ghosts at t [g].
  [[nodiscard]] std::span<const double> ghost_values(double t);

  /// Net flow into the field through fixed values, sources, convection and radiation [W or A].
  [[nodiscard]] double inflow(double t, std::span<const double> y);
  /// Derivative of `inflow` along v, without radiation.
  [[nodiscard]] double conduction_inflow(std::span<const double> v) const;
  [[nodiscard]] const FieldFacts& facts() const noexcept { return facts_; }
  /// Adds a breakpoint for every knot of a table that acts on the field.
  ///   field  its number among those of the right-hand side
  void add_breakpoints(std::size_t field, std::vector<Breakpoint>& points) const;
  /// See Rhs::input_shapes; of a field that does not radiate.
  [[nodiscard]] std::vector<InputShape> input_shapes() const;
  /// See Rhs::enter and Rhs::leave.
  void enter(double begin, double end) noexcept;
  void leave() noexcept;
  [[nodiscard]] const TabledInputs& inputs() const noexcept { return inputs_; }
  /// Largest slope of radiation, 4 r_i |y_i|^3/C_i [1/s].
  [[nodiscard]] double radiation_slope(std::span<const double> y) const;
  /// Says that a row which radiates is so far below 0 K that its fourth power counts; see Rhs::law_violation.
  [[nodiscard]] std::optional<std::string> radiation_violation(std::span<const double> y, double slack) const;

  /// Calls add(row, column, value) for every contribution to df/dy [1/s]: several may meet in one place.
  /// Columns of rows that other processes have are all `column_elsewhere`.
  template <class Add>
  void jacobian(std::span<const double> y, Add add) const;
  /// What of it is due to radiation.
  template <class Add>
  void radiation_jacobian(std::span<const double> y, Add& add) const;

  /// New conductances on the same graph [nnz] and of the ghost edges [ghost edges], W/K or S.
  void set_conductances(std::span<const double> edges, std::span<const double> ghost_edges);
  /// Of some ghost edges: `edges` says which of `conductance` [ghost edges] are new.
  void set_ghost_conductances(std::span<const std::int32_t> edges, std::span<const double> conductance);

 private:
  struct GhostRate {
    std::int32_t row, ghost;
    double rate;  ///< K/C [1/s]
  };
  struct SourceRate {
    std::int32_t row;
    double rate;  ///< Q/C [K/s or V/s]
  };
  struct TabledRate {
    std::int32_t row, table;
  };
  struct RadiationRate {
    std::int32_t row, table;
    double rate;  ///< emissivity sigma_SB A/C [1/(K^3 s)]
    double ambient4;
  };

  [[nodiscard]] double ambient4(const RadiationRate& radiation, double t) const noexcept;
  /// What flows into rows, as far as it depends on them [W or A].
  struct RowInflow {
    RowSum exchanged, radiated;
  };
  void add_inflow(double t, const double* y, std::size_t first, std::size_t last, RowInflow& sum) const;
  /// With what sources supply.
  [[nodiscard]] double total_inflow(double t, RowInflow& sum) const;

  friend class Flanks;
  /// Calls each(row, column, K/C) for the rates of rows [first, last); columns from size() on are of the
  /// halo.
  template <class Each>
  void for_rates(std::size_t first, std::size_t last, const Each& each) const;
  [[nodiscard]] NetworkPart rates_of_rows(std::size_t first, std::size_t last) const;
  /// The conduction of a Jacobian, from the rates alone.
  template <class Add>
  void add_rates(Add& add) const;
  /// One stage on all slices, conduction alone; finish(first, last) then does what else is to be done to
  /// rows.
  template <class Finish>
  void sweep_all(const Stage& stage, double* out, const Finish& finish) const;
  // For a time that `ghost_values` has been called with.
  void add_inputs(double t, const Stage& stage, std::size_t first, std::size_t last, double* out) const;

  void forget_pattern();
  void find_facts();
  [[nodiscard]] SkewedBlocks chain_blocks() const noexcept;
  /// What the whole of a chain's data takes [bytes].
  [[nodiscard]] std::size_t chain_bytes() const noexcept;
  [[nodiscard]] std::size_t depth_in_cache() const noexcept;
  /// What else is to be done to rows of a stage that has been swept.
  void finish_stage(const ChainedStage& link, std::size_t number, std::size_t first, std::size_t last,
                    std::span<const double> drive, ChainObserver* observer) const;
  void pass_together(std::span<ChainedStage> stages, std::size_t first_stage, bool with_inflow,
                     std::span<const double> drive, ChainObserver* observer);
  /// Rates are no longer those that they were made from.
  void forget_flanks() noexcept {
    flanks_.reset();
    flanks_are_known_ = false;
  }
  [[nodiscard]] std::size_t best_depth(std::size_t reach, std::size_t cuts) const noexcept;
  /// Collective: whether stages may share a halo, and how many.
  void find_flanks();
  /// The same where processes share the network and all stages one halo.
  void pass_between_cuts(std::span<ChainedStage> stages, std::size_t first_stage,
                         std::span<const double> drive, ChainObserver* observer);

  Network network_;
  std::unique_ptr<BoundaryRows> boundary_;  ///< null: all rows are here
  std::shared_ptr<Flanks> flanks_;          ///< null: every stage has a halo of its own
  bool flanks_are_known_ = false;
  SlicedRows rate_;  ///< K_ij/C_i [1/s], without the boundary's
  std::vector<GhostRate> ghosts_;
  std::vector<double> ghost_value_;  ///< [g] at `ghost_time_`
  TabledInputs inputs_;
  FieldFacts facts_;
  std::vector<SourceRate> sources_;
  std::vector<TabledRate> tabled_;
  std::vector<RadiationRate> radiation_;
  bool constant_ghosts_ = true, constant_inputs_ = true;
  // Half of the last cache of common processors. More than there is costs little: what does not fit comes
  // from memory as it would have without.
  std::size_t cache_bytes_ = std::size_t{12} << 20;
  double ghost_time_ = 0;
  bool ghosts_are_current_ = true;
};

/// The halo travels while the slices that do not need it are swept.
template <class Finish>
void FieldOperator::sweep_all(const Stage& stage, double* out, const Finish& finish) const {
  constexpr auto lanes = SlicedRows::lanes;
  const auto sweep = [&](std::size_t first, std::size_t last) {
    fused_sweep(rate_, stage, first, last, out);
    finish(first * lanes, std::min(last * lanes, size()));
  };
  if (!boundary_) return for_slices(rate_, sweep);
  boundary_->begin(stage.y1);
  for_slices(rate_,
             [&](std::size_t first, std::size_t last) { boundary_->for_interior(first, last, sweep); });
  boundary_->end();
  for_ranges(boundary_->slices(), boundary_->slices() * lanes, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      boundary_->sweep(stage, k, out);
      finish(boundary_->slice(k) * lanes, std::min((boundary_->slice(k) + 1) * lanes, size()));
    }
  });
}

template <class Each>
void FieldOperator::for_rates(std::size_t first, std::size_t last, const Each& each) const {
  for (std::size_t i = first; i < last; ++i)
    rate_.for_row(i, [&](std::int32_t column, double rate) { each(i, at(column), rate); });
  if (!boundary_) return;
  boundary_->for_entries(size(), [&](std::size_t row, std::size_t column, double rate) {
    if (row >= first && row < last) each(row, column, rate);
  });
}

template <class Add>
void FieldOperator::add_rates(Add& add) const {
  std::vector<double> diagonal(size(), 0.0);
  for_rates(0, size(), [&](std::size_t row, std::size_t column, double rate) {
    diagonal[row] -= rate;
    add(row, column < size() ? column : column_elsewhere, rate);
  });
  for (std::size_t i = 0; i < size(); ++i) add(i, i, diagonal[i]);
}

template <class Add>
void FieldOperator::jacobian(std::span<const double> y, Add add) const {
  if (network_.row_begin.empty()) add_rates(add);
  for (std::size_t i = 0; i + 1 < network_.row_begin.size(); ++i) {
    double diagonal = 0;
    for (auto k = network_.row_begin[i]; k < network_.row_begin[i + 1]; ++k) {
      const double rate = network_.conductance[static_cast<std::size_t>(k)] / network_.capacity[i];
      diagonal -= rate;
      const auto column = static_cast<std::size_t>(network_.column[static_cast<std::size_t>(k)]);
      add(i, column < size() ? column : column_elsewhere, rate);
    }
    add(i, i, diagonal);
  }
  for (const auto& ghost : ghosts_) {
    const auto row = static_cast<std::size_t>(ghost.row);
    add(row, row, -ghost.rate);
  }
  radiation_jacobian(y, add);
}

template <class Add>
void FieldOperator::radiation_jacobian(std::span<const double> y, Add& add) const {
  for (const auto& radiation : radiation_) {
    const auto row = static_cast<std::size_t>(radiation.row);
    add(row, row, -4 * radiation.rate * y[row] * y[row] * y[row]);
  }
}

}  // namespace superstep
