#pragma once
/// What a packing or network file is, and how it conducts, said without a case.

#include <optional>
#include <string>

#include "bench/app/commands.hpp"
#include "case/packed/starter_case.hpp"
#include "packing/packing.hpp"

namespace superstep {

/// How a packing conducts along an axis.
struct PackingConduction {
  char axis = 'z';
  double coordination = 0;               ///< mean number of contacts of a particle
  std::size_t components = 0;            ///< of particles that touch
  std::size_t isolated = 0;              ///< particles without a contact
  std::optional<double> between_layers;  ///< W/(m K), between layers at both ends
  std::string note;                      ///< why there is none, or why it is 0
  std::string basis;                     ///< the length and the cross-section that it is for, in words
  double length = 0, area = 0;           ///< m, m2; 0 where `basis` is empty
  std::optional<double>
      periodic;           ///< W/(m K), under a mean gradient, where the packing is periodic along the axis
  bool passes = true;     ///< false where no path of contacts leads from side to side
  bool all_held = false;  ///< layers at both ends leave no particle free
  double time = 0;  ///< s, about what heat needs from one side to the other, or through the slowest particle
  std::string method;  ///< what `auto` would take over that time, and why; empty where no heat passes
};

/// Settings of a starter case for a file, as the command line has them.
[[nodiscard]] StarterSettings starter_settings(const Packing& packing, const FileOptions& options,
                                               const std::string& file);

/// Builds the starter case of a packing file and looks at it. Throws InputError.
[[nodiscard]] PackingConduction assess_conduction(const Packing& packing, const std::string& file,
                                                  StarterSettings settings);

/// Text or JSON about any packing or network file. Throws InputError for what is neither.
[[nodiscard]] std::string file_report(const InfoCommand& command);

/// True for a file that is no case: it is not TOML, or it is called like a case and holds none.
[[nodiscard]] bool is_no_case(const std::string& path);

}  // namespace superstep
