/// Chains of stages on one field's network: those that fit into the cache together pass over it together.

#include <array>
#include <cmath>
#include <limits>

#include "rhs/kernels/cuts/flanks.hpp"
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

std::size_t FieldOperator::chain_bytes() const noexcept {
  constexpr std::size_t entry_bytes = sizeof(double) + sizeof(std::int32_t), vectors = 3;
  return rate_.entries() * entry_bytes + size() * vectors * sizeof(double);
}

std::size_t FieldOperator::depth_in_cache() const noexcept {
  const auto blocks = chain_blocks();
  const std::size_t slices_in_cache = cache_bytes_ / (chain_bytes() / rate_.slices() + 1);
  std::size_t depth = 1;
  while (depth < longest_chain && blocks.rows_in_flight(depth + 1) <= slices_in_cache) ++depth;
  return depth;
}

std::size_t FieldOperator::chain_depth() const noexcept {
  if (!constant_inputs_ || boundary_ || rate_.slices() == 0) return 1;
  return chain_bytes() <= cache_bytes_ ? 1 : depth_in_cache();  // it stays in the cache as it is
}

/// Stages that share a halo, by what they cost in rows swept: others' rows, half of depth - 1 reaches a cut
/// in the mean; a wait for others, once; and memory, where the rows leave the cache between stages.
std::size_t FieldOperator::best_depth(std::size_t reach, std::size_t cuts) const noexcept {
  constexpr double wait = 6e3, traffic = 0.5;  // rows; of the time of a sweep out of memory: processes.md
  const std::size_t slices = size() / SlicedRows::lanes;
  const bool leaves_cache = chain_bytes() > cache_bytes_;
  const std::size_t most = std::min({longest_chain, slices / std::max<std::size_t>(1, cuts * reach),
                                     leaves_cache && slices > 0 ? depth_in_cache() : longest_chain});
  std::size_t best = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t depth = 1; depth <= most; depth *= 2) {  // as chains are made of
    const auto d = static_cast<double>(depth);
    const double own = static_cast<double>(size()) * (leaves_cache ? 1 - traffic + traffic / d : 1.0),
                 others = (d - 1) / 2 * static_cast<double>(cuts * reach * SlicedRows::lanes);
    if (const double cost = own + others + wait / d; cost < least) {
      least = cost;
      best = depth;
    }
  }
  return best;
}

std::size_t FieldOperator::stages_of_a_halo() const noexcept {
  return flanks_ ? flanks_->depth() : 1;
}

void FieldOperator::find_flanks() {
  flanks_are_known_ = true;
  const Halo& halo = *network_.halo;
  const auto& partition = halo.partition();
  double furthest = 0;
  for_rates(0, size(), [&](std::size_t row, std::size_t column, double /*rate*/) {
    const auto there =
        column < size() ? static_cast<std::int64_t>(column) : halo.row(column - size()) - partition.begin();
    furthest = std::max(furthest, std::abs(static_cast<double>(there - static_cast<std::int64_t>(row))));
  });
  const auto reach = static_cast<std::size_t>(
      std::ceil(std::max(halo.among().max(furthest), 1.0) / static_cast<double>(SlicedRows::lanes)));
  const int cuts = (partition.begin() > 0 ? 1 : 0) + (partition.end() < partition.rows() ? 1 : 0);
  const auto depth = static_cast<std::size_t>(
      halo.among().min(static_cast<double>(best_depth(reach, static_cast<std::size_t>(cuts)))));
  if (depth > 1) flanks_ = std::make_shared<Flanks>(*this, reach, depth);
}

void FieldOperator::chain(std::span<ChainedStage> stages, bool with_inflow, std::span<const double> drive,
                          ChainObserver* observer) {
  // Sums of the inflow go through all rows in order, which rows beside cuts do not.
  const bool may_share = boundary_ && constant_inputs_ && !with_inflow;
  if (may_share && stages.size() > 1 && !flanks_are_known_) find_flanks();
  const bool shares = may_share && flanks_;
  const std::size_t depth = shares ? flanks_->depth() : chain_depth();
  if (shares) flanks_->begin_chain();
  // In groups alike: a few stages that are left over would pass alone.
  const std::size_t groups = (stages.size() + depth - 1) / depth;
  const std::size_t share = groups > 0 ? (stages.size() + groups - 1) / groups : depth;
  for (std::size_t first = 0; first < stages.size(); first += share) {
    const auto together = stages.subspan(first, std::min(share, stages.size() - first));
    if (shares && together.size() > 1)
      pass_between_cuts(together, first, drive, observer);
    else
      pass_together(together, first, with_inflow, drive, observer);
  }
}

void FieldOperator::finish_stage(const ChainedStage& link, std::size_t number, std::size_t first,
                                 std::size_t last, std::span<const double> drive,
                                 ChainObserver* observer) const {
  add_inputs(link.t, link.stage, first, last, link.out);
  if (!drive.empty())
    for (std::size_t i = first; i < last; ++i) link.out[i] += link.stage.d * drive[i];
  if (observer) observer->entries_done(number, first, last);
}

void FieldOperator::pass_between_cuts(std::span<ChainedStage> stages, std::size_t first_stage,
                                      std::span<const double> drive, ChainObserver* observer) {
  const auto finish = [&](std::size_t pass, std::size_t first, std::size_t last) {
    finish_stage(stages[pass], first_stage + pass, first, last, drive, observer);
  };
  flanks_->begin(stages, drive);
  const auto work = [&](std::size_t pass, std::size_t first, std::size_t last) {
    const auto inner = flanks_->inner_slices(pass);
    first = std::max(first, inner.first);
    last = std::min(last, inner.second);
    if (first >= last) return;
    fused_sweep(rate_, stages[pass].stage, first, last, stages[pass].out);
    finish(pass, first * SlicedRows::lanes, std::min(last * SlicedRows::lanes, size()));
  };
  skewed_passes(chain_blocks(), stages.size(), work, [this](std::size_t pass, std::size_t, std::size_t) {
    if (pass == 0) flanks_->progress();
  });
  flanks_->end();
  for (std::size_t pass = 0; pass < stages.size(); ++pass)
    flanks_->step(stages, pass, drive,
                  [&](std::size_t first, std::size_t last) { finish(pass, first, last); });
}

void FieldOperator::pass_together(std::span<ChainedStage> stages, std::size_t first_stage, bool with_inflow,
                                  std::span<const double> drive, ChainObserver* observer) {
  std::vector<RowInflow> inflow(with_inflow ? stages.size() : 0);
  (void)ghost_values(stages.front().t);
  const auto finish = [&](std::size_t pass, std::size_t first, std::size_t last) {
    finish_stage(stages[pass], first_stage + pass, first, last, drive, observer);
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
