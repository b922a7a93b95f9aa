#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"
#include "network/files/pores.hpp"
#include "packing/formats/vtk/vtk_xml.hpp"

namespace superstep {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

std::size_t need(const DelimitedTable& table, const std::string& name) {
  const auto column = find_name(table.names(), name, table.where());
  if (!column)
    throw InputError(
        fmt::format("{}: there is no column '{}'; a pore network in CSV has it among its columns pore.* and "
                    "throat.*: export it, or name another",
                    table.where(), name));
  return *column;
}

bool is_gap(std::string_view cell) {
  return cell.empty() || lower_case(cell) == "nan";
}

double number(const DelimitedTable& table, std::size_t column) {
  const auto value = parse_number(table.cells()[column]);
  if (!value)
    throw InputError(fmt::format("{}: column '{}' is {}; it must be a finite decimal number", table.where(),
                                 table.names()[column], in_quotes(table.cells()[column])));
  return *value;
}

std::int64_t pore(const DelimitedTable& table, std::size_t column) {
  const auto value = parse_whole_number(table.cells()[column]);
  if (!value || *value < 0)
    throw InputError(fmt::format("{}: column '{}' is {}; it must be the number of a pore, counted from 0",
                                 table.where(), table.names()[column], in_quotes(table.cells()[column])));
  return *value;
}

/// Columns of pores and of throats stand side by side, and the shorter ones are padded at their end: what has
/// no number above that would be left out, and all that follows it counted wrongly.
class Padding {
 public:
  ///   columns  of a pore or a throat, the first of which tells whether there is one
  Padding(std::string what, std::vector<std::size_t> columns)
      : what_(std::move(what)), columns_(std::move(columns)) {}
  /// True where the row has no pore or throat any more. Throws InputError for half of one, or one below.
  bool has_begun(const DelimitedTable& table) {
    const auto cell = [&](std::size_t column) { return table.cells()[column]; };
    if (!is_gap(cell(columns_[0]))) {
      if (line_ > 0)
        throw InputError(
            fmt::format("{}: column '{}' has no number on line {}, and goes on here; give every {} "
                        "one, or remove that row",
                        table.where(), table.names()[columns_[0]], line_, what_));
      return false;
    }
    for (const auto column : columns_)
      if (!is_gap(cell(column)))
        throw InputError(
            fmt::format("{}: column '{}' is {}, and '{}' has no number; give the {} one, or remove "
                        "it",
                        table.where(), table.names()[column], in_quotes(cell(column)),
                        table.names()[columns_[0]], what_));
    if (line_ == 0) line_ = table.line();
    return true;
  }

 private:
  std::string what_;
  std::vector<std::size_t> columns_;
  std::size_t line_ = 0;
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

PoreNetwork pores_of_table(const std::string& file, const std::string& text, const std::string& conductance,
                           const std::string& capacity) {
  DelimitedTable table(file, text);
  const std::size_t first = need(table, "throat.conns[0]"), second = need(table, "throat.conns[1]"),
                    position = need(table, "pore.coords[0]"), value = need(table, conductance),
                    size = capacity.empty() ? none : need(table, capacity);
  PoreNetwork network;
  Labels labels(table, network);
  std::vector<Pore> pores;
  std::vector<Throat> throats;
  Padding below_pores("pore", size == none ? std::vector{position} : std::vector{position, size}),
      below_throats("throat", {first, second, value});
  while (table.next()) {
    if (!below_pores.has_begun(table)) {
      pores.push_back({size == none ? 1.0 : number(table, size), table.line()});
      labels.add(table);
    }
    if (below_throats.has_begun(table)) continue;
    throats.push_back({pore(table, first), pore(table, second), number(table, value), table.line()});
  }
  labels.drop_what_is_none();
  join_pores(file, pores, throats, network);
  return network;
}

}  // namespace

PoreNetwork read_openpnm(const std::string& file, const std::string& conductance,
                         const std::string& capacity) {
  const std::string text = read_text_file(file);
  if (is_vtk_xml(text)) return pores_of_vtk(file, text, conductance, capacity);
  return pores_of_table(file, text, conductance, capacity);
}

}  // namespace superstep
