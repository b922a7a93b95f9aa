#pragma once
/// Reference solutions on disk.

#include <optional>
#include <string>
#include <vector>

#include "integrators/probe_history.hpp"

namespace superstep {

/// What a cached reference holds.
struct CachedReference {
  std::vector<std::vector<double>> states;  ///< one per output time
  std::vector<std::vector<double>> cvode;   ///< the same of CVODE, or empty
  std::vector<double> error_bar, spans;     ///< one per field
  std::vector<double> scalars;              ///< inflow, CPU time of the pilot runs [s]
  ProbeHistory history;
};

/// Folder of the cache: $SUPERSTEP_CACHE, else $XDG_CACHE_HOME/superstep, else $HOME/.cache/superstep; empty
/// = none.
[[nodiscard]] std::string cache_folder();

/// File of the reference with that key; empty without a folder.
[[nodiscard]] std::string cache_file(const std::string& key);

/// Reads a reference. Empty when there is none, or when the file is damaged or not ours: the caller computes
/// it anew.
[[nodiscard]] std::optional<CachedReference> read_cached_reference(const std::string& file);

/// Writes a reference, whole or not at all. Throws OutputError.
void write_cached_reference(const std::string& file, const CachedReference& reference);

}  // namespace superstep
