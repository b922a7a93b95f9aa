#pragma once
/// Audits that look at something else than the accuracy of methods.

#include <cstdint>
#include <iosfwd>
#include <optional>

#include "audit/audit.hpp"

namespace superstep::audit {

struct SeedRange {
  std::uint64_t first = 1, last = 2;  ///< first to last - 1
};

/// The oracle's solution; where it has none a line says why.
[[nodiscard]] std::optional<Truth> truth_or_reason(std::uint64_t seed, const StatedScene& stated,
                                                   std::ostream& out);

/// Does a method deliver the same when every temperature is 273.15 higher? Scenes without laws and radiation.
void print_shift_audit(std::ostream& out, const SeedRange& seeds, const SceneWishes& wishes,
                       const std::vector<Contender>& methods, const std::vector<double>& rtols,
                       const AuditSettings& settings, TimeLimit& limit, bool list);

/// Is the reference's bar above its true error, and how large is it?
void print_reference_audit(std::ostream& out, const SeedRange& seeds, const SceneWishes& wishes, bool list);

/// The span that the library finds for a field against the oracle's.
struct SpanPair {
  std::string field;
  double found = 0, right = 0;  ///< K or V
  bool pilot = false;
  std::string how;
};
[[nodiscard]] std::vector<SpanPair> compare_spans(const StatedScene& stated, const Truth& truth);
/// Are the bounds that methods state above their errors? Linear scenes with one field, held against sixty
/// digits; how many bounds are not.
[[nodiscard]] std::size_t print_bounds_audit(std::ostream& out, const SeedRange& seeds,
                                             const SceneWishes& wishes, const std::vector<Contender>& methods,
                                             const std::vector<double>& rtols, bool list);

void print_span_audit(std::ostream& out, const SeedRange& seeds, const SceneWishes& wishes, bool list);

}  // namespace superstep::audit
