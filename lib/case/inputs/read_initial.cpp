#include "case/inputs/read_initial.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>

#include "case/inputs/column_unit.hpp"
#include "case/inputs/named_column.hpp"
#include "case/inputs/named_file.hpp"
#include "core/error.hpp"
#include "core/text/bracketed_unit.hpp"
#include "core/text/ids_in_words.hpp"
#include "core/text/number.hpp"

namespace superstep {
namespace {

std::vector<double> of_packing(const TomlValue& column, const Packing& packing, std::string_view unit) {
  const auto* attribute = find_attribute(packing, column.string());
  if (attribute == nullptr) {
    std::vector<std::string> names;
    for (const auto& one : packing.attributes) names.push_back(one.name);
    column.reject(names.empty() ? "the packing has no columns beside positions, sizes, ids and materials"
                                : fmt::format("it must be a column of the packing; those are {}",
                                              fmt::join(names, ", ")));
  }
  require_column_unit(attribute->name, unit, column.where());
  for (std::size_t k = 0; k < packing.size(); ++k)
    if (!std::isfinite(attribute->value[k]))
      column.reject(
          fmt::format("the column has no number for particle {}; every particle needs one", packing.id[k]));
  return attribute->value;
}

std::vector<double> of_file(const TomlValue& file, const TomlValue& column, std::span<const std::int64_t> id,
                            std::string_view unit) {
  const std::string path = named_path(file),
                    text = read_named_file(file, [](const auto&name) { return read_text_file(name); });
  DelimitedTable rows(path, text, header_of({"id", bare_name(column.string())}, 2));
  const std::size_t id_column = column_named(rows, "id", path),
                    value_column = column_named(rows, column.string(), column.where());
  if (!rows.names().empty()) require_column_unit(rows.names()[value_column], unit, column.where());
  std::unordered_map<std::int64_t, std::size_t> position;
  for (std::size_t k = 0; k < id.size(); ++k) position.emplace(id[k], k);
  std::vector<double> values(id.size(), std::numeric_limits<double>::quiet_NaN());
  while (rows.next()) {
    const auto number = parse_whole_number(rows.cells()[id_column]);
    const auto found = number ? position.find(*number) : position.end();
    if (found == position.end())
      throw InputError(fmt::format(
          "{}: id is {}, which is nobody of this case; the file must hold its particles or nodes, "
          "each once: {}",
          rows.where(), in_quotes(rows.cells()[id_column]), ids_in_words(id)));
    if (!std::isnan(values[found->second]))
      throw InputError(fmt::format("{}: id {} stands twice; keep one", rows.where(), found->first));
    values[found->second] = number_in(rows, value_column);
  }
  for (std::size_t k = 0; k < id.size(); ++k)
    if (std::isnan(values[k]))
      throw InputError(
          fmt::format("{}: there is no row for id {}; the file must hold every particle or node of the case",
                      path, id[k]));
  return values;
}

}  // namespace

std::vector<double> read_initial(TomlTable& table, std::span<const std::int64_t> id, const Packing* packing,
                                 std::string_view unit) {
  const auto initial = table.find("initial");
  if (!initial || !initial->is_table())
    return std::vector<double>(id.size(), initial ? initial->number() : 0.0);
  TomlTable source = initial->table();
  const auto column = source.require("column", "it names the column of the packing, or of a file beside it");
  const auto file = source.find("file");
  source.finish();
  if (file) return of_file(*file, column, id, unit);
  if (packing == nullptr) column.reject("there is no packing to take it from; name a file beside it");
  return of_packing(column, *packing, unit);
}

}  // namespace superstep
