#pragma once
/// Small cases in a folder of their own, with a reference cache of their own.

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "support/temporary_folder.hpp"

namespace superstep::test {

/// A folder for cases; SUPERSTEP_CACHE points into it.
class CaseFolder : public TemporaryFolder {
 public:
  CaseFolder() { setenv("SUPERSTEP_CACHE", cache().c_str(), 1); }

  [[nodiscard]] std::string cache() const { return file("cache"); }
  [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(file(name)); }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream stream(file(name));
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

/// A rod of equal nodes: ids 1 .. nodes, capacity 1 J/K, conductance 1 W/K, the ends held at 0 and 10 K, 0 K
/// inside at the start. With 20 nodes lambda_max is a little below 4 1/s and the slowest mode decays at
/// 0.0273 1/s.
struct Rod {
  int nodes = 20;
  double conductance = 1;  ///< W/K
  std::string title = "rod";
  std::string head = "t_end = 100\noutput_times = [10, 50, 100]\nprobe = 10\n";
  std::string bench =
      "baseline = \"forward-euler\"\nintegrators = [\"sts:n=5,nu=0.05\", \"cvode:rtol=1e-4\"]\n";
};

/// Writes `name`.toml with its two CSV files and returns the path of the case.
inline std::string write_rod(const CaseFolder& folder, const Rod& rod, const std::string& name = "rod") {
  std::string nodes = "id,capacity,source,initial,fixed\n", edges = "i,j,conductance\n";
  for (int id = 1; id <= rod.nodes; ++id) {
    const char* fixed = id == 1 ? "0" : id == rod.nodes ? "10" : "";
    nodes += fmt::format("{},1,0,0,{}\n", id, fixed);
    if (id > 1) edges += fmt::format("{},{},{}\n", id - 1, id, rod.conductance);
  }
  folder.write(name + "_nodes.csv", nodes);
  folder.write(name + "_edges.csv", edges);
  folder.write(
      name + ".toml",
      fmt::format("title = \"{0}\"\n{1}\n[network]\nnodes = \"{2}_nodes.csv\"\nedges = \"{2}_edges.csv\"\n"
                  "field = \"temperature\"\n\n[bench]\n{3}",
                  rod.title, rod.head, name, rod.bench));
  return folder.file(name + ".toml");
}

}  // namespace superstep::test
