#include "rhs/kernels/cuts/flanks.hpp"

#include <algorithm>

#include "rhs/kernels/cuts/joined_rows.hpp"

namespace superstep {

/// Own rows [first, last) as a network of capacities 1, so that its conductances are rates; columns and rows
/// count from `first`.
NetworkPart FieldOperator::rates_of_rows(std::size_t first, std::size_t last) const {
  const Partition& partition = network_.halo->partition();
  const std::int64_t origin = partition.begin() + static_cast<std::int64_t>(first);
  struct Entry {
    std::int32_t column;
    double rate;
  };
  std::vector<std::vector<Entry>> entries(last - first);
  for_rates(first, last, [&](std::size_t row, std::size_t column, double rate) {
    const std::int64_t global = column < size() ? partition.begin() + static_cast<std::int64_t>(column)
                                                : network_.halo->row(column - size());
    entries[row - first].push_back({static_cast<std::int32_t>(global - origin), rate});
  });
  NetworkPart part;
  Network& out = part.network;
  out.row_begin.push_back(0);
  for (const auto& row : entries) {
    for (const auto& [column, rate] : row) {
      out.column.push_back(column);
      out.conductance.push_back(rate);
    }
    out.row_begin.push_back(static_cast<std::int64_t>(out.column.size()));
  }
  out.source.assign(last - first, 0.0);
  const auto is_here = [&](std::int32_t row) { return at(row) >= first && at(row) < last; };
  const auto here = [&](std::int32_t row) { return row - static_cast<std::int32_t>(first); };
  for (const auto& source : sources_)
    if (is_here(source.row)) out.source[at(here(source.row))] = source.rate;
  for (const auto& ghost : ghosts_) {
    if (!is_here(ghost.row)) continue;
    out.ghost_edges.push_back(
        {here(ghost.row), static_cast<std::int32_t>(out.ghost_value.size()), ghost.rate});
    out.ghost_value.push_back(ghost_value_[at(ghost.ghost)]);
  }
  for (std::size_t k = 0; k < radiation_.size(); ++k)
    if (is_here(radiation_[k].row))
      out.radiation.push_back({.node = here(radiation_[k].row),
                               .coefficient = radiation_[k].rate,
                               .ambient = network_.radiation[k].ambient});
  return part;
}

Flanks::Flanks(const FieldOperator& field, std::size_t reach, std::size_t depth)
    : field_(field), reach_(reach), depth_(depth), slices_((field.size() + lanes - 1) / lanes) {
  const Halo& halo = *field.network_.halo;
  const Partition& partition = halo.partition();
  Communicator& among = halo.among();
  const std::size_t beside = reach_ * lanes, beyond = depth_ * beside, n = field.size();
  const auto with_lower = [&] {
    if (partition.begin() == 0) return;
    add_side(true, field.rates_of_rows(0, beside),
             swap_rows(among, among.rank() - 1, field.rates_of_rows(0, beyond)));
    for (std::size_t k = beyond; k > 0; --k)
      rows_beyond_.push_back(partition.begin() - static_cast<std::int64_t>(k));
  };
  const auto with_upper = [&] {
    if (partition.end() == partition.rows()) return;
    add_side(false, field.rates_of_rows(n - beside, n),
             swap_rows(among, among.rank() + 1, field.rates_of_rows(n - beyond, n)));
    for (std::size_t k = 0; k < beyond; ++k)
      rows_beyond_.push_back(partition.end() + static_cast<std::int64_t>(k));
  };
  // Pairs with an even lower process go first, so that nobody waits for somebody who waits.
  if (among.rank() % 2 == 0) {
    with_upper();
    with_lower();
    if (sides_.size() == 2) std::swap(sides_[0], sides_[1]);
  } else {
    with_lower();
    with_upper();
  }
  std::sort(rows_beyond_.begin(), rows_beyond_.end());
}

void Flanks::add_side(bool left, const NetworkPart& own, const NetworkPart& beyond) {
  const std::size_t own_rows = 2 * reach_ * lanes, beyond_rows = depth_ * reach_ * lanes,
                    stepped = (depth_ - 1) * reach_ * lanes;
  const std::size_t beside = own.network.source.size();
  const std::array<RowsOfPart, 2> parts =
      left ? std::array<RowsOfPart, 2>{{{&beyond.network, 0, beyond_rows - stepped, beyond_rows},
                                        {&own.network, beyond_rows, 0, beside}}}
           : std::array<RowsOfPart, 2>{
                 {{&own.network, own_rows - beside, 0, beside}, {&beyond.network, own_rows, 0, stepped}}};
  Network rows = joined_rows(parts, own_rows + beyond_rows);
  sides_.push_back({.rows = std::make_unique<FieldOperator>(std::move(rows), false),
                    .left = left,
                    .own_first = left ? depth_ * reach_ : 0,
                    .first_own = left ? 0 : slices_ - 2 * reach_});
}

std::pair<std::size_t, std::size_t> Flanks::inner_slices(std::size_t k) const noexcept {
  std::pair<std::size_t, std::size_t> inner{0, slices_};
  for (const Side& side : sides_)
    if (side.left)
      inner.first = (k + 1) * reach_;
    else
      inner.second = slices_ - (k + 1) * reach_;
  return inner;
}

Flanks::Copy& Flanks::copy_of(const double* own) {
  for (std::size_t k = 0; k < used_; ++k)
    if (copies_[k].of == own) return copies_[k];
  if (used_ == copies_.size()) {
    const Halo& halo = *field_.network_.halo;
    Copy& made = copies_.emplace_back();
    made.halo = std::make_unique<Halo>(halo.among(), halo.partition(), rows_beyond_);
    made.arrived.resize(rows_beyond_.size());
    for (std::size_t side = 0; side < sides_.size(); ++side)
      made.at_side[side].resize((depth_ + 2) * reach_ * lanes);
  }
  Copy& copy = copies_[used_++];
  copy.of = own;
  copy.is_current = copy.is_written = false;
  return copy;
}

void Flanks::fetch(const double* own) {
  if (!own) return;
  Copy& copy = copy_of(own);
  if (copy.is_current || copy.is_written) return;
  copy.halo->begin(own, copy.arrived.data());
  copy.is_awaited = copy.is_current = true;
}

void Flanks::begin(std::span<const ChainedStage> stages, std::span<const double> drive) {
  for (const auto& [t, stage, out, unused] : stages) {
    for (const double* read : {stage.y1, stage.y2, stage.y0, stage.f0}) fetch(read);
    copy_of(out).is_written = true;
  }
  if (!drive.empty()) fetch(drive.data());
}

void Flanks::progress() {
  for (std::size_t k = 0; k < used_; ++k)
    if (copies_[k].is_awaited) copies_[k].halo->progress();
}

void Flanks::end() {
  const std::size_t beyond = depth_ * reach_ * lanes;
  for (std::size_t k = 0; k < used_; ++k) {
    Copy& copy = copies_[k];
    if (std::exchange(copy.is_awaited, false)) {
      copy.halo->end();
      for (std::size_t side = 0; side < sides_.size(); ++side)
        std::copy_n(copy.arrived.data() + side * beyond, beyond,
                    copy.at_side[side].data() + (sides_[side].left ? 0 : 2 * reach_ * lanes));
    }
    // After these stages what is written is known for own rows alone.
    if (std::exchange(copy.is_written, false)) copy.is_current = false;
  }
}

/// Others' rows that later stages still need.
void Flanks::step_beyond(const ChainedStage& link, std::size_t side, std::size_t left_over,
                         std::span<const double> drive) {
  Stage stage = link.stage;
  for (const double** vector : {&stage.y1, &stage.y2, &stage.y0, &stage.f0}) *vector = at_side(*vector, side);
  double* const out = copy_of(link.out).at_side[side].data();
  const double* const driven = drive.empty() ? nullptr : at_side(drive.data(), side);
  const std::size_t wide = left_over * reach_;
  const std::size_t from = sides_[side].left ? depth_ * reach_ - wide : 2 * reach_;
  const FieldOperator& rows = *sides_[side].rows;
  for_ranges(wide, wide * lanes, [&](std::size_t begin, std::size_t end) {
    const std::size_t first = (from + begin) * lanes, last = (from + end) * lanes;
    fused_sweep(rows.rate_, stage, from + begin, from + end, out);
    rows.add_inputs(link.t, stage, first, last, out);
    for (std::size_t i = first; driven && i < last; ++i) out[i] += stage.d * driven[i];
  });
}

/// Own rows that have neighbours beyond the cut, or could have.
void Flanks::step_beside(const ChainedStage& link, std::size_t side) {
  const Side& here = sides_[side];
  const auto shift =
      (static_cast<std::ptrdiff_t>(here.first_own) - static_cast<std::ptrdiff_t>(here.own_first)) *
      static_cast<std::ptrdiff_t>(lanes);
  Stage stage = link.stage;
  stage.y1 = at_side(stage.y1, side);
  for (const double** vector : {&stage.y2, &stage.y0, &stage.f0})
    if (*vector) *vector += shift;
  const std::size_t from = here.own_first + (here.left ? 0 : reach_);
  for_ranges(reach_, reach_ * lanes, [&](std::size_t begin, std::size_t end) {
    fused_sweep(here.rows->rate_, stage, from + begin, from + end, link.out + shift);
  });
}

}  // namespace superstep
