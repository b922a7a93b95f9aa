#include "rhs/rhs.hpp"

#include <atomic>

namespace superstep {
namespace {

/// Entries of each field where they stand one behind the other.
std::vector<std::size_t> parts_of(std::size_t size, std::span<const FieldView> fields) {
  std::vector<std::size_t> parts;
  std::size_t end = 0;
  for (const auto& field : fields) {
    if (field.stride != 1 || field.offset != end) return {size};
    parts.push_back(field.count);
    end += field.count;
  }
  if (end != size) return {size};
  return parts;
}

std::size_t total_of(std::size_t size, std::span<const FieldView> fields) {
  for (const auto& field : fields) size += field.elsewhere;
  return size;
}

std::uint64_t next_identity() noexcept {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

Rhs::Rhs(std::size_t size, RhsTraits traits, std::vector<FieldView> fields, Communicator* among)
    : reduction_(parts_of(size, fields), total_of(size, fields), among),
      traits_(traits),
      fields_(std::move(fields)),
      identity_(next_identity()) {}

void Rhs::do_chain(std::span<ChainedStage> stages, bool with_inflow, ChainObserver* observer) {
  for (std::size_t k = 0; k < stages.size(); ++k) {
    auto& link = stages[k];
    if (with_inflow) link.inflow = inflow(link.t, {link.stage.y1, size()});
    do_stage(link.t, link.stage, {link.out, size()});
    if (observer) observer->entries_done(k, 0, size());
  }
}

}  // namespace superstep
