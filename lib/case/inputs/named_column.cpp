#include "case/inputs/named_column.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/text/bracketed_unit.hpp"
#include "core/text/number.hpp"

namespace superstep {

std::size_t column_named(const DelimitedTable& table, const std::string& name, const std::string& where,
                         std::optional<std::size_t> fallback) {
  const auto& names = table.names();
  if (const auto place = place_of_name(names, name, table.where_header())) return *place;
  if (names.empty() && fallback && *fallback < table.width()) return *fallback;
  throw InputError(fmt::format("{}: there is no column '{}' in the table ({}); its columns are: {}", where,
                               name, table.where_header(),
                               names.empty() ? "not named" : fmt::format("{}", fmt::join(names, ", "))));
}

double number_in(const DelimitedTable& table, std::size_t column) {
  const auto value = parse_number(table.cells()[column]);
  if (!value)
    throw InputError(
        fmt::format("{}: column {} is {}; it must be a finite decimal number such as 1.5e-3", table.where(),
                    table.names().empty() ? std::to_string(column + 1) : in_quotes(table.names()[column]),
                    in_quotes(table.cells()[column])));
  return *value;
}

}  // namespace superstep
