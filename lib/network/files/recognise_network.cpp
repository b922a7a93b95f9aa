#include "network/files/recognise_network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "network/files/matrix_market.hpp"

namespace superstep {
namespace {

/// Headers of edges in comments; other lines of as many words are prose.
HeaderRule edge_rule() {
  return {{}, [](const std::vector<std::string>& names) {
            return std::any_of(names.begin(), names.end(), [](const std::string& name) {
              return lower_case(name) == "i" || lower_case(name).ends_with("throat.conns[0]");
            });
          }};
}

/// Rows of two whole numbers and one more. A packing has a position and a size in each, four at least.
bool holds_bare_edges(const std::string& path, const std::string& text) {
  DelimitedTable table(path, text, edge_rule());
  while (table.next()) {
    const auto cells = table.cells();
    if (cells.size() != 3 || !parse_whole_number(cells[0]) || !parse_whole_number(cells[1]) ||
        !parse_number(cells[2]))
      return false;
  }
  return true;
}

}  // namespace

std::optional<NetworkFile> recognise_network(const std::string& path) {
  const std::string text = read_file(path);
  if (is_matrix_market(text))
    return NetworkFile{"Matrix Market", "matrix", read_matrix_network(path, MatrixKind::automatic, 0.0)};
  if (text.find('\0') != std::string::npos || text.find_first_not_of(" \t\r\n") == std::string::npos)
    return std::nullopt;
  std::vector<std::string> names;
  try {
    const DelimitedTable table(path, text, edge_rule());
    for (const auto& name : table.names()) names.push_back(lower_case(name));
  } catch (const InputError&) {
    return std::nullopt;
  }
  const auto ends_with = [&](const std::string& ending) {
    return std::find_if(names.begin(), names.end(), [&](const auto& name) { return name.ends_with(ending); });
  };
  if (ends_with("throat.conns[0]") != names.end()) {
    for (const auto& name : names)
      if (name.find("throat.") != std::string::npos && name.find("conductance") != std::string::npos)
        return NetworkFile{fmt::format("OpenPNM pore network, conducting by '{}'", name), "openpnm",
                           read_openpnm(path, name.substr(name.find("throat.")), {}).input};
    throw InputError(
        fmt::format("{}: a pore network without a column throat.*conductance; export one", path));
  }
  const auto has = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (has("i") && has("j") && has("conductance"))
    return NetworkFile{"edge list", "edges", read_edge_list(path)};
  if (names.empty() && holds_bare_edges(path, text))
    return NetworkFile{"edge list without a header: i, j, conductance", "edges", read_edge_list(path)};
  return std::nullopt;
}

}  // namespace superstep
