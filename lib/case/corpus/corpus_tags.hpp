#pragma once
/// `[corpus]`: what a case stands for in a set of cases that methods are compared on.

#include <optional>
#include <string>
#include <vector>

#include "core/text/toml.hpp"

namespace superstep {

/// Sets of the corpus; each holds those before it.
inline constexpr const char* corpus_sets[] = {"quick", "standard", "large"};
/// What scenes are about.
inline constexpr const char* corpus_classes[] = {"linear",
                                                 "driven",
                                                 "exchange",
                                                 "conductivity of temperature",
                                                 "one-way thermoelectric",
                                                 "two-way thermoelectric",
                                                 "steady potential",
                                                 "two materials"};

struct CorpusTags {
  std::string set;                     ///< the smallest that holds the case
  std::string scene_class, kind;       ///< what it is about; of which kind its network is
  std::string purpose;                 ///< one line
  double unknowns = 0, stiffness = 0;  ///< as stated: entries of the state; t_end times spectral radius
  double contrast = 1;                 ///< largest over smallest rate of exchange, as stated
};

/// Tags of a case; empty where it has none. Throws InputError.
[[nodiscard]] std::optional<CorpusTags> read_corpus_tags(TomlTable& root);

/// True when `set` is among the sets that hold the case.
[[nodiscard]] bool belongs_to(const CorpusTags& tags, const std::string& set);

}  // namespace superstep
