#include "results/corpus/corpus_csv.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "results/schema/corpus_fields.hpp"
#include "results/schema/record_csv.hpp"

namespace superstep {

std::string corpus_csv(std::span<const CorpusRow> rows) {
  const auto& columns = fields_of<CorpusRow>();
  std::string out = csv_header(columns);
  for (const auto& row : rows) out += csv_record(columns, row);
  return out;
}

std::vector<CorpusRow> read_corpus_csv(const std::string& path) {
  const CsvTable table(path);
  const auto& columns = fields_of<CorpusRow>();
  for (const char* needed : {"scene", "class", "integrator", "params", "status", "cpu_s", "error"})
    (void)table.column(needed);
  std::vector<CorpusRow> rows;
  std::set<std::pair<std::string, std::string>> measured;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const Json json = json_of_row(columns, table, k);
    CorpusRow& row = rows.emplace_back();
    read_record(columns, row, JsonObject(path, json, "row " + std::to_string(k + 1)));
    if (!measured.emplace(row.scene, row.spec).second)
      table.reject(k, fmt::format("an earlier row is of {} on {}, too", row.spec, row.scene));
  }
  return rows;
}

}  // namespace superstep
