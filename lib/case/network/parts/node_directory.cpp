#include "case/network/parts/node_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "case/parts/agreed.hpp"
#include "parallel/all_to_all.hpp"

namespace superstep {

NodeDirectory::NodeDirectory(const SharedNodes& nodes, const std::string& path, Communicator& among)
    : processes_(static_cast<std::uint64_t>(among.size())) {
  std::vector<std::vector<Entry>> to(processes_);
  std::int64_t number = nodes.here().begin;
  for (const auto& node : nodes.own()) to[process(node.id)].push_back({node.id, number++});
  entries_ = all_to_all(std::move(to), among);
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
  const auto twice = std::adjacent_find(entries_.begin(), entries_.end(),
                                        [](const Entry& a, const Entry& b) { return a.id == b.id; });
  agreed(among, [&] {
    if (twice != entries_.end())
      throw InputError(
          fmt::format("{}: id {} stands twice; every node needs an id of its own", path, twice->id));
  });
}

std::int64_t NodeDirectory::node_of(std::int64_t id) const noexcept {
  if (entries_.empty() || id < entries_.front().id) return -1;
  // Ids without gaps stand where they are expected.
  const std::uint64_t place =
      (static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(entries_.front().id)) / processes_;
  if (place < entries_.size() && entries_[place].id == id) return entries_[place].node;
  const auto found = std::lower_bound(entries_.begin(), entries_.end(), id,
                                      [](const Entry& entry, std::int64_t one) { return entry.id < one; });
  return found != entries_.end() && found->id == id ? found->node : -1;
}

}  // namespace superstep
