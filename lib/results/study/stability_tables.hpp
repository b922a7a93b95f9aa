#pragma once
/// The stability laboratory's results for machines: five CSV files and one JSON object from the same tables.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "results/study/stability_results.hpp"

namespace superstep {

/// One table; a cell that is null does not exist or is not finite.
struct StabilityTable {
  std::string name;  ///< "methods", "critical_step", "rounding", "sweeps", "states"
  std::vector<std::string> columns;
  std::vector<std::vector<nlohmann::ordered_json>> rows;

  [[nodiscard]] std::string file_name() const { return "stability_" + name + ".csv"; }
  [[nodiscard]] std::string csv() const;
};

[[nodiscard]] std::vector<StabilityTable> stability_tables(const StabilityResults& results);

inline constexpr const char* schema_of_stability = "superstep.stability";
/// Of stability.json: 2 since it holds frozen states.
constexpr int stability_schema_version = 2;

/// All tables, each as an array of objects with the CSV columns as keys, and the verdicts.
[[nodiscard]] std::string stability_json(const StabilityResults& results);

}  // namespace superstep
