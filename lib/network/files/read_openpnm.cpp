#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"
#include "network/files/read_network.hpp"

namespace superstep {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// A column by the end of its name, since OpenPNM puts the network's name before it
/// ("net_01.pore.coords[0]").
std::size_t find(const DelimitedTable& table, const std::string& name) {
  for (std::size_t k = 0; k < table.names().size(); ++k) {
    const std::string& column = table.names()[k];
    if (column == name) return k;
    if (column.size() > name.size() && column.ends_with(name)) {
      const char before = column[column.size() - name.size() - 1];
      if (before == '.' || before == ' ' || before == '|') return k;
    }
  }
  return none;
}

std::size_t need(const DelimitedTable& table, const std::string& name) {
  const std::size_t column = find(table, name);
  if (column == none)
    throw InputError(
        fmt::format("{}: there is no column '{}'; a pore network in CSV has it among its columns pore.* and "
                    "throat.*: export it, or name another",
                    table.where(), name));
  return column;
}

bool is_gap(std::string_view cell) {
  return cell.empty() || lower_case(cell) == "nan";
}

double number(const DelimitedTable& table, std::size_t column) {
  const auto value = parse_number(table.cells()[column]);
  if (!value)
    throw InputError(fmt::format("{}: column '{}' is {}; it must be a finite decimal number", table.where(),
                                 table.names()[column], quoted(table.cells()[column])));
  return *value;
}

std::int64_t pore(const DelimitedTable& table, std::size_t column) {
  const auto value = parse_whole_number(table.cells()[column]);
  if (!value || *value < 0)
    throw InputError(fmt::format("{}: column '{}' is {}; it must be the number of a pore, counted from 0",
                                 table.where(), table.names()[column], quoted(table.cells()[column])));
  return *value;
}

struct Throat {
  std::int64_t i, j;
  double conductance;
  std::size_t line;
};

/// Columns of pores that hold True and False.
struct Labels {
  std::vector<std::size_t> column;
  PoreNetwork* network;

  Labels(const DelimitedTable& table, PoreNetwork& into) : network(&into) {
    for (std::size_t k = 0; k < table.names().size(); ++k) {
      const auto at = table.names()[k].find("pore.");
      if (at == std::string::npos || table.names()[k].find('[') != std::string::npos) continue;
      column.push_back(k);
      into.labels.push_back({table.names()[k].substr(at), {}});
    }
  }
  void add(const DelimitedTable& table) {
    for (std::size_t k = 0; k < column.size(); ++k) {
      const std::string word = lower_case(table.cells()[column[k]]);
      network->labels[k].second.push_back(word == "true" ? 1 : word == "false" ? 0 : 2);
    }
  }
  void drop_what_is_none() {
    std::erase_if(network->labels, [](const auto& label) {
      return std::any_of(label.second.begin(), label.second.end(), [](char value) { return value == 2; });
    });
  }
};

}  // namespace

PoreNetwork read_openpnm(const std::string& file, const std::string& conductance,
                         const std::string& capacity) {
  const std::string text = read_text_file(file);
  DelimitedTable table(file, text);
  const std::size_t first = need(table, "throat.conns[0]"), second = need(table, "throat.conns[1]"),
                    position = need(table, "pore.coords[0]"), value = need(table, conductance),
                    size = capacity.empty() ? none : need(table, capacity);
  PoreNetwork network;
  Labels labels(table, network);
  std::vector<double> capacities;
  std::vector<Throat> throats;
  while (table.next()) {  // columns of pores and of throats stand side by side, the shorter ones padded
    if (!is_gap(table.cells()[position])) {
      capacities.push_back(size == none ? 1.0 : number(table, size));
      if (!(capacities.back() >= 0))
        throw InputError(
            fmt::format("{}: {} is {}; a capacity must be >= 0", table.where(), capacity, capacities.back()));
      labels.add(table);
    }
    if (is_gap(table.cells()[first])) continue;
    throats.push_back({pore(table, first), pore(table, second), number(table, value), table.line()});
    if (!(throats.back().conductance >= 0))
      throw InputError(fmt::format("{}: {} is {}; it must be >= 0", table.where(), conductance,
                                   throats.back().conductance));
  }
  labels.drop_what_is_none();
  if (capacities.empty()) throw InputError(fmt::format("{}: has no pores; at least one is needed", file));
  network.input.graph = equal_nodes(capacities.size());
  network.input.graph.capacity = capacities;
  const auto pores = static_cast<std::int64_t>(capacities.size());
  for (const auto& throat : throats) {
    if (throat.i >= pores || throat.j >= pores || throat.i == throat.j)
      throw InputError(fmt::format("{}:{}: throat joins pores {} and {}; they must be two of the {} pores",
                                   file, throat.line, throat.i, throat.j, pores));
    add_edge(network.input.graph, static_cast<std::size_t>(throat.i), static_cast<std::size_t>(throat.j),
             throat.conductance);
  }
  if (const auto joined = join_parallel_edges(network.input.graph); joined > 0)
    network.input.notes.push_back(fmt::format(
        "{}: {} throats run parallel to others, and their conductances are summed", file, joined));
  return network;
}

}  // namespace superstep
