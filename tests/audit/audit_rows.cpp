#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "audit/audit.hpp"
#include "core/text/number.hpp"

namespace superstep::audit {
namespace {

const char* const header =
    "seed,class,shape,unknowns,t_lambda,method,rtol,status,error,delivered,floored,steps,rejected,sweeps,"
    "seconds,"
    "reason";
constexpr std::size_t columns = 16;

/// The reason without what would end a field or a line.
std::string plain(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '"' || c == '\n' || c == '\r'; }, ' ');
  return text;
}

/// Fields of a line; one in quotes may hold commas.
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

}  // namespace

void write_rows(std::ostream& out, const std::vector<Row>& rows) {
  out << header << '\n';
  for (const auto& row : rows)
    out << fmt::format("{},{},{},{},{:.6g},\"{}\",{:g},{},{:.6g},{:.6g},{},{},{},{},{:.3g},\"{}\"\n",
                       row.seed, row.kind, row.shape, row.unknowns, row.t_lambda, row.label, row.rtol,
                       row.status, row.error, row.delivered, row.floored ? 1 : 0, row.steps, row.rejected,
                       row.sweeps, row.seconds, plain(row.reason));
}

std::vector<Row> read_rows(std::istream& in) {
  std::string line;
  if (!std::getline(in, line) || line != header) throw std::runtime_error("not a CSV of the audit");
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    const auto f = split(line);
    if (f.size() != columns)
      throw std::runtime_error("a line of the audit's CSV has " + std::to_string(f.size()) +
                               " fields: " + line);
    Row row;
    row.seed = std::stoull(f[0]);
    row.kind = f[1];
    row.shape = f[2];
    row.unknowns = std::stoull(f[3]);
    row.t_lambda = std::stod(f[4]);
    row.label = f[5];
    row.rtol = std::stod(f[6]);
    row.status = f[7];
    row.error = std::stod(f[8]);
    row.delivered = std::stod(f[9]);
    row.floored = f[10] == "1";
    row.steps = std::stoull(f[11]);
    row.rejected = std::stoull(f[12]);
    row.sweeps = std::stoull(f[13]);
    row.seconds = std::stod(f[14]);
    row.reason = f[15];
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace superstep::audit
