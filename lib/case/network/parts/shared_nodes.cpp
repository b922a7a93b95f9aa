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

}  // namespace

SharedNodes::SharedNodes(const RowsInParts& table, Communicator& among) {
  Part part{.nodes = read_part(table, among)};
  const auto& nodes = part.nodes;
  const auto is_free = [](const NodeRow& node) { return !node.fixed; };
  if (among.any(std::any_of(nodes.begin(), nodes.end(),
                            [&](const NodeRow& node) { return is_free(node) && !(node.capacity > 0); })))
    throw NeedsOneReader("nodes of capacity 0 are eliminated");
  count_ = static_cast<std::int64_t>(among.sum(nodes.size()));
  if (count_ > std::numeric_limits<std::int32_t>::max())
    throw InputError(fmt::format("{}: more than 2147483647 nodes; split the network", table.path()));
  const auto free = static_cast<std::uint64_t>(std::count_if(nodes.begin(), nodes.end(), is_free));
  part.first_node = static_cast<std::int64_t>(among.sum_before(nodes.size()));
  part.first_row = static_cast<std::int64_t>(among.sum_before(free));
  rows_ = Partition(static_cast<std::int64_t>(among.sum(free)), among.size(), among.rank(), block_rows());
  measure(part, among);
  find_ranges(part, among);
  hand_out(std::move(part), among);
}

void SharedNodes::measure(const Part& part, Communicator& among) {
  low_ = std::numeric_limits<double>::infinity();
  high_ = -low_;
  for (const auto& node : part.nodes) {
    const double value = node.fixed.value_or(node.initial);
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  low_ = among.min(low_);
  high_ = among.max(high_);
}

/// A process begins with the node of its first row; fixed nodes before the first row of all are the first
/// one's.
void SharedNodes::find_ranges(const Part& part, Communicator& among) {
  std::vector<double> begins;  // of those whose first row was read here: process, node, ...
  int process = 0;
  std::int64_t node = part.first_node, row = part.first_row;
  for (const auto& one : part.nodes) {
    for (; !one.fixed && process < among.size() && rows_.first(process) <= row; ++process)
      if (rows_.first(process) == row && row > 0)
        begins.insert(begins.end(), {static_cast<double>(process), static_cast<double>(node)});
    if (!one.fixed) ++row;
    ++node;
  }
  ranges_.resize(at(among.size()));
  for (int k = 0; k < among.size(); ++k)
    if (rows_.first(k) > 0 && rows_.first(k) == rows_.rows()) ranges_[at(k)].begin = count_;
  const std::vector<double> all = everywhere(begins, among);
  for (std::size_t k = 0; k + 1 < all.size(); k += 2)
    ranges_[static_cast<std::size_t>(all[k])].begin = static_cast<std::int64_t>(all[k + 1]);
  for (std::size_t k = 1; k < ranges_.size(); ++k) ranges_[k - 1].end = ranges_[k].begin;
  ranges_.back().end = count_;
}

void SharedNodes::hand_out(Part part, Communicator& among) {
  std::vector<std::vector<SharedNode>> to(ranges_.size());
  std::int64_t number = part.first_node, row = part.first_row;
  for (const auto& node : part.nodes)
    to[owner(number++)].push_back({.id = node.id,
                                   .row = node.fixed ? -1 : row++,
                                   .capacity = node.capacity,
                                   .source = node.source,
                                   .initial = node.initial,
                                   .fixed_value = node.fixed.value_or(0.0)});
  std::vector<NodeRow>().swap(part.nodes);
  own_ = all_to_all(std::move(to), among);
}

std::vector<SharedNode> SharedNodes::ask(std::span<const std::int64_t> nodes, Communicator& among) const {
  struct Question {
    std::int64_t node, asker;
  };
  std::vector<std::vector<Question>> questions(ranges_.size());
  for (const auto node : nodes) questions[owner(node)].push_back({node, among.rank()});
  std::vector<std::vector<SharedNode>> answers(ranges_.size());
  for (const auto& [node, asker] : all_to_all(std::move(questions), among))
    answers[at(asker)].push_back(own_[at(node - here().begin)]);
  return all_to_all(std::move(answers), among);  // owners ascend with the numbers of nodes
}

std::int64_t SharedNodes::node_of_id(std::int64_t id, Communicator& among) const {
  const auto found =
      std::find_if(own_.begin(), own_.end(), [&](const SharedNode& node) { return node.id == id; });
  return static_cast<std::int64_t>(
      among.max(found == own_.end() ? -1.0 : static_cast<double>(here().begin + (found - own_.begin()))));
}

}  // namespace superstep
