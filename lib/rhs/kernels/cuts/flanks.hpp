#pragma once
/// Several stages in a row where processes share a network: one halo serves them all.
///
///   Beside its cuts a process keeps rows of others, up to `depth` times the bandwidth away, and steps them
///   itself, fewer with every stage:
///     values that came   | others' rows  3 | 2 | 1 | own rows ...
///     after stage 1                    | 2 | 1 | own rows ...
///     after stage 2                        | 1 | own rows ...
///     after stage 3                            | own rows ...
///   Own rows farther from a cut than the bandwidth times the stage's number do not notice: they are stepped
///   in blocks, several stages together, while the halo travels. Those in between follow, stage by stage.
/// A row is the same sum in the same order whoever steps it.
/// Source: Demmel, Hoemmen, Mohiyuddin & Yelick (2008), doi:10.1109/IPDPS.2008.4536305, their PA1.

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "rhs/kernels/field_operator.hpp"

namespace superstep {

class Flanks {
 public:
  /// Collective. Of a field whose inputs are constant, between processes with more rows than `depth` reaches.
  ///   reach  bandwidth of the whole network [slices]
  Flanks(const FieldOperator& field, std::size_t reach, std::size_t depth);

  /// Stages that one halo serves.
  [[nodiscard]] std::size_t depth() const noexcept { return depth_; }
  /// Own slices that do not notice the cuts in stage number k of those that share a halo, from 0.
  [[nodiscard]] std::pair<std::size_t, std::size_t> inner_slices(std::size_t k) const noexcept;

  /// What was fetched belongs to vectors that may be others now.
  void begin_chain() noexcept { used_ = 0; }
  /// The halo of these stages sets out. Collective.
  ///   drive  as of FieldOperator::chain
  void begin(std::span<const ChainedStage> stages, std::span<const double> drive);
  void end();
  /// Between the two, now and then; by the thread that began.
  void progress();
  /// Stage number k beside the cuts, once `inner_slices` of all stages are stepped; `stages` as in `begin`.
  /// finish(first, last) does what else is to be done to own rows.
  template <class Finish>
  void step(std::span<const ChainedStage> stages, std::size_t k, std::span<const double> drive,
            const Finish& finish);

 private:
  static constexpr std::size_t lanes = SlicedRows::lanes;

  /// What lies at one cut: rows of others and those of its own next to them, in the global order.
  struct Side {
    std::unique_ptr<FieldOperator> rows;
    bool left = false;          ///< others' rows come first
    std::size_t own_first = 0;  ///< slices: where own ones begin among these,
    std::size_t first_own = 0;  ///< and which own one that is; there are 2 reach_ of them
  };
  /// A vector beyond the cuts.
  struct Copy {
    const double* of = nullptr;  ///< the own part
    bool is_current = false, is_awaited = false, is_written = false;
    std::unique_ptr<Halo> halo;
    std::vector<double> arrived;
    std::array<std::vector<double>, 2> at_side;
  };

  void add_side(bool left, const NetworkPart& own, const NetworkPart& beyond);
  [[nodiscard]] Copy& copy_of(const double* own);
  void fetch(const double* own);
  [[nodiscard]] const double* at_side(const double* own, std::size_t side) {
    return own ? copy_of(own).at_side[side].data() : nullptr;
  }
  void step_beyond(const ChainedStage& link, std::size_t side, std::size_t left_over,
                   std::span<const double> drive);
  void step_beside(const ChainedStage& link, std::size_t side);

  const FieldOperator& field_;
  std::size_t reach_, depth_, slices_;
  std::vector<Side> sides_;
  std::vector<Copy> copies_;
  std::size_t used_ = 0;  ///< of the copies, by this chain
  std::vector<std::int64_t> rows_beyond_;
};

template <class Finish>
void Flanks::step(std::span<const ChainedStage> stages, std::size_t k, std::span<const double> drive,
                  const Finish& finish) {
  const ChainedStage& link = stages[k];
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    const Side& here = sides_[side];
    auto& y1 = copy_of(link.stage.y1).at_side[side];
    std::copy_n(link.stage.y1 + here.first_own * lanes, 2 * reach_ * lanes,
                y1.data() + here.own_first * lanes);
    step_beyond(link, side, stages.size() - 1 - k, drive);
    step_beside(link, side);
    const auto [first, last] = inner_slices(k);
    const std::size_t from = here.left ? reach_ : last, to = here.left ? first : slices_ - reach_;
    for_ranges(to - from, (to - from) * lanes, [&](std::size_t begin, std::size_t end) {
      fused_sweep(field_.rate_, link.stage, from + begin, from + end, link.out);
    });
    finish(here.left ? 0 : last * lanes, here.left ? first * lanes : slices_ * lanes);
  }
}

}  // namespace superstep
