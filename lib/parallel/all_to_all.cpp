#include "parallel/all_to_all.hpp"

#include <utility>

namespace superstep {

std::vector<std::vector<std::byte>> all_to_all(std::vector<std::vector<std::byte>> own, Communicator& among) {
  std::vector<std::vector<std::byte>> others(own.size());
  const int here = among.rank();
  // Pairs of processes meet in one order everywhere, that of their numbers: nobody waits for ever.
  for (int other = 0; other < among.size(); ++other) {
    const auto k = static_cast<std::size_t>(other);
    if (other == here) {
      others[k] = std::move(own[k]);
    } else if (other < here) {
      others[k] = among.receive(other);
      among.send(other, own[k]);
    } else {
      among.send(other, own[k]);
      others[k] = among.receive(other);
    }
    std::vector<std::byte>().swap(own[k]);
  }
  return others;
}

std::vector<double> everywhere(std::span<const double> own, Communicator& among) {
  const std::vector<double> all = among.gather(own);
  const auto view = std::as_bytes(std::span(all));
  std::vector<std::byte> bytes(view.begin(), view.end());
  among.broadcast(bytes);
  std::vector<double> out(bytes.size() / sizeof(double));
  if (!bytes.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}

std::size_t range_that_holds(std::span<const IndexRange> ranges, std::int64_t k) noexcept {
  const auto behind =
      std::upper_bound(ranges.begin(), ranges.end(), k,
                       [](std::int64_t one, const IndexRange& range) { return one < range.begin; });
  return static_cast<std::size_t>(behind - ranges.begin()) - 1;
}

std::vector<IndexRange> everywhere(IndexRange own, Communicator& among) {
  const double ends[] = {static_cast<double>(own.begin), static_cast<double>(own.end)};
  const std::vector<double> all = everywhere(ends, among);
  std::vector<IndexRange> ranges;
  for (std::size_t k = 0; k + 1 < all.size(); k += 2)
    ranges.push_back({static_cast<std::int64_t>(all[k]), static_cast<std::int64_t>(all[k + 1])});
  return ranges;
}

}  // namespace superstep
