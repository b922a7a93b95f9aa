/// Chains of stages on one field's network: those that fit into the cache together pass over it together.

#include <array>

#include "rhs/kernels/field_operator.hpp"

namespace superstep {
namespace {

// Blocks of less would be lost in the passing from one to the next.
constexpr std::size_t smallest_block = 512;  // slices

}  // namespace

SkewedBlocks FieldOperator::chain_blocks() const noexcept {
  const std::size_t reach = (rate_.reach() + SlicedRows::lanes - 1) / SlicedRows::lanes;
  return {rate_.slices(), reach, smallest_block, threads_for(size())};
}

std::size_t FieldOperator::chain_depth() const noexcept {
  constexpr std::size_t entry_bytes = sizeof(double) + sizeof(std::int32_t), vectors = 3;
  if (!constant_inputs_ || boundary_ || rate_.slices() == 0) return 1;
  const std::size_t bytes = rate_.entries() * entry_bytes + size() * vectors * sizeof(double);
  if (bytes <= cache_bytes_) return 1;  // it stays in the cache as it is
  const auto blocks = chain_blocks();
  const std::size_t slices_in_cache = cache_bytes_ / (bytes / rate_.slices() + 1);
  std::size_t depth = 1;
  while (depth < longest_chain && blocks.rows_in_flight(depth + 1) <= slices_in_cache) ++depth;
  return depth;
}

void FieldOperator::chain(std::span<ChainedStage> stages, bool with_inflow, std::span<const double> drive,
                          ChainObserver* observer) {
  const std::size_t depth = chain_depth();
  for (std::size_t first = 0; first < stages.size(); first += depth)
    pass_together(stages.subspan(first, std::min(depth, stages.size() - first)), first, with_inflow, drive,
                  observer);
}

void FieldOperator::pass_together(std::span<ChainedStage> stages, std::size_t first_stage, bool with_inflow,
                                  std::span<const double> drive, ChainObserver* observer) {
  std::vector<RowInflow> inflow(with_inflow ? stages.size() : 0);
  (void)ghost_values(stages.front().t);
  const auto finish = [&](std::size_t pass, std::size_t first, std::size_t last) {
    const auto& [t, stage, out, unused] = stages[pass];
    add_inputs(t, stage, first, last, out);
    if (!drive.empty())
      for (std::size_t i = first; i < last; ++i) out[i] += stage.d * drive[i];
    if (observer) observer->entries_done(first_stage + pass, first, last);
  };
  const auto work = [&](std::size_t pass, std::size_t first, std::size_t last) {
    fused_sweep(rate_, stages[pass].stage, first, last, stages[pass].out);
    finish(pass, first * SlicedRows::lanes, std::min(last * SlicedRows::lanes, size()));
  };
  const auto watch = [&](std::size_t pass, std::size_t first, std::size_t last) {
    if (with_inflow)
      add_inflow(stages[pass].t, stages[pass].stage.y1, first * SlicedRows::lanes, last * SlicedRows::lanes,
                 inflow[pass]);
  };
  if (stages.size() == 1) {
    watch(0, 0, rate_.slices());
    sweep_all(stages.front().stage, stages.front().out,
              [&](std::size_t first, std::size_t last) { finish(0, first, last); });
  } else {
    skewed_passes(chain_blocks(), stages.size(), work, watch);
  }
  for (std::size_t k = 0; with_inflow && k < stages.size(); ++k)
    stages[k].inflow = total_inflow(stages[k].t, inflow[k]);
}

}  // namespace superstep
