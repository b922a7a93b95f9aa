#include "case/network/parts/shared_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "case/network/parts/byte_pieces.hpp"
#include "case/parts/agreed.hpp"
#include "case/parts/build_in_parts.hpp"
#include "core/index.hpp"

namespace superstep {
namespace {

std::vector<NodeRow> read_part(const RowsInParts& table, Communicator& among) {
  std::vector<NodeRow> part;
  agreed(among, [&] {
    const BytePieces pieces(table, among);
    for (int piece = 0; piece < pieces.count(); ++piece) {
      const auto rows = nodes_of_part(table, pieces.begin(piece), pieces.begin(piece + 1));
      part.insert(part.end(), rows.begin(), rows.end());
    }
  });
  return part;
}

std::uint64_t count_free(const std::vector<NodeRow>& part) {
  return static_cast<std::uint64_t>(
      std::count_if(part.begin(), part.end(), [](const NodeRow& node) { return !node.fixed; }));
}

}  // namespace

SharedNodes::SharedNodes(const RowsInParts& table, Communicator& among) {
  std::vector<NodeRow> part = read_part(table, among);
  count_ = static_cast<std::int64_t>(among.sum(part.size()));
  if (count_ > std::numeric_limits<std::int32_t>::max())
    throw InputError(fmt::format("{}: more than 2147483647 nodes; split the network", table.path()));
  if (among.any(std::any_of(part.begin(), part.end(),
                            [](const NodeRow& node) { return !node.fixed && !(node.capacity > 0); })))
    throw NeedsOneReader("nodes of capacity 0 are eliminated");
  first_read_ = static_cast<std::int64_t>(among.sum_before(part.size()));
  measure(part, among);
  const std::uint64_t free = count_free(part);
  const auto first_row = static_cast<std::int64_t>(among.sum_before(free));
  rows_ = Partition(static_cast<std::int64_t>(among.sum(free)), among.size(), among.rank(), block_rows());
  find_shares(part, first_row, among);
  hand_out(std::move(part), first_row, among);
}

void SharedNodes::measure(const std::vector<NodeRow>& part, Communicator& among) {
  low_ = std::numeric_limits<double>::infinity();
  high_ = -low_;
  for (const auto& node : part) {
    const double value = node.fixed.value_or(node.initial);
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  low_ = among.min(low_);
  high_ = among.max(high_);
}

/// A process begins with the node of its first row; fixed nodes before the first row are the first one's.
void SharedNodes::find_shares(const std::vector<NodeRow>& part, std::int64_t first_row, Communicator& among) {
  std::vector<double> found;  // process, node, ...
  int process = 0;
  std::int64_t row = first_row;
  for (std::size_t k = 0; k < part.size(); ++k) {
    if (part[k].fixed) continue;
    for (; process < among.size() && rows_.first(process) <= row; ++process)
      if (rows_.first(process) == row && row > 0)
        found.insert(found.end(), {static_cast<double>(process),
                                   static_cast<double>(first_read_ + static_cast<std::int64_t>(k))});
    ++row;
  }
  begins_.assign(at(among.size()), 0);
  for (int k = 0; k < among.size(); ++k)
    if (rows_.first(k) > 0 && rows_.first(k) == rows_.rows()) begins_[at(k)] = count_;
  const std::vector<double> all = everywhere(found, among);
  for (std::size_t k = 0; k + 1 < all.size(); k += 2)
    begins_[static_cast<std::size_t>(all[k])] = static_cast<std::int64_t>(all[k + 1]);
  const std::size_t next = at(among.rank()) + 1;
  here_ = {begins_[next - 1], next < begins_.size() ? begins_[next] : count_};
}

void SharedNodes::hand_out(std::vector<NodeRow> part, std::int64_t first_row, Communicator& among) {
  std::vector<std::vector<SharedNode>> to(at(among.size()));
  std::int64_t number = first_read_, row = first_row;
  for (const auto& node : part)
    to[owner(number++)].push_back({.id = node.id,
                                   .row = node.fixed ? -1 : row++,
                                   .capacity = node.capacity,
                                   .source = node.source,
                                   .initial = node.initial,
                                   .fixed_value = node.fixed.value_or(0.0)});
  std::vector<NodeRow>().swap(part);
  own_ = all_to_all(std::move(to), among);
}

std::size_t SharedNodes::owner(std::int64_t node) const noexcept {
  return static_cast<std::size_t>(std::upper_bound(begins_.begin(), begins_.end(), node) - begins_.begin()) -
         1;
}

std::vector<SharedNode> SharedNodes::ask(std::span<const std::int64_t> nodes, Communicator& among) const {
  struct Question {
    std::int64_t node, asker;
  };
  std::vector<std::vector<Question>> questions(begins_.size());
  for (const auto node : nodes) questions[owner(node)].push_back({node, among.rank()});
  std::vector<std::vector<SharedNode>> answers(begins_.size());
  for (const auto& [node, asker] : all_to_all(std::move(questions), among))
    answers[at(asker)].push_back(own_[at(node - here_.begin)]);
  return all_to_all(std::move(answers), among);  // owners ascend with the numbers of nodes
}

std::int64_t SharedNodes::node_of_id(std::int64_t id, Communicator& among) const {
  const auto found =
      std::find_if(own_.begin(), own_.end(), [&](const SharedNode& node) { return node.id == id; });
  return static_cast<std::int64_t>(
      among.max(found == own_.end() ? -1.0 : static_cast<double>(here_.begin + (found - own_.begin()))));
}

}  // namespace superstep
