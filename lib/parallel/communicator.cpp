#include "parallel/communicator.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace superstep {

double Communicator::sum(const ExactSum& own) {
  if (alone()) return own.value();
  const auto words = own.words();
  std::array<std::int64_t, ExactSum::word_count + 1> shared;  // the last one: who wishes to stop
  std::copy(words.begin(), words.end(), shared.begin());
  shared.back() = wish() ? 1 : 0;
  add_up(shared);
  ++traffic_.reductions;
  agree(shared.back() > 0);
  ExactSum::Words all;
  std::copy_n(shared.begin(), all.size(), all.begin());
  return ExactSum::of(all).value();
}

std::uint64_t Communicator::sum(std::uint64_t own) {
  if (alone()) return own;
  std::array<std::int64_t, 2> shared{static_cast<std::int64_t>(own), wish() ? 1 : 0};
  add_up(shared);
  ++traffic_.reductions;
  agree(shared[1] > 0);
  return static_cast<std::uint64_t>(shared[0]);
}

std::uint64_t Communicator::sum_before(std::uint64_t own) {
  if (alone()) return 0;
  std::vector<std::int64_t> all(static_cast<std::size_t>(size()), 0);
  all[static_cast<std::size_t>(rank())] = static_cast<std::int64_t>(own);
  add_up(all);
  const auto sum = std::accumulate(all.begin(), all.begin() + rank(), std::int64_t{0});
  return static_cast<std::uint64_t>(sum);
}

double Communicator::max(double own) {
  if (alone()) return own;
  const bool missing = std::isnan(own);
  std::array<double, 3> shared{missing ? 0 : own, missing ? 1.0 : 0.0, wish() ? 1.0 : 0.0};
  take_largest(shared);
  ++traffic_.reductions;
  agree(shared[2] > 0);
  return shared[1] > 0 ? std::numeric_limits<double>::quiet_NaN() : shared[0];
}

std::optional<std::string> Communicator::first_of(const std::optional<std::string>& own) {
  if (alone()) return own;
  const double nobody = size();
  const double first = min(own ? rank() : nobody);
  if (first == nobody) return std::nullopt;
  // Entries of the rank that has it; the others' are nought, and a sum of words is exact.
  const bool mine = rank() == static_cast<int>(first);
  std::vector<std::int64_t> letters(sum(std::uint64_t{mine ? own->size() : 0}));
  for (std::size_t k = 0; mine && k < letters.size(); ++k) letters[k] = static_cast<unsigned char>((*own)[k]);
  add_up(letters);
  std::string text;
  for (const auto letter : letters) text += static_cast<char>(letter);
  return text;
}

std::vector<double> Communicator::gather(std::span<const double> own) {
  if (alone()) return {own.begin(), own.end()};
  std::vector<std::int64_t> counts(static_cast<std::size_t>(size()), 0);
  counts[static_cast<std::size_t>(rank())] = static_cast<std::int64_t>(own.size());
  add_up(counts);
  std::int64_t total = 0;
  for (const auto count : counts) total += count;
  std::vector<double> all(is_root() ? static_cast<std::size_t>(total) : 0);
  gather_into(own, counts, all);
  return all;
}

}  // namespace superstep
