#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/error.hpp"
#include "core/text/quantity.hpp"
#include "network/files/matrix_market.hpp"
#include "network/files/read_network.hpp"

namespace superstep {
namespace {

using Entry = MatrixMarket::Entry;

/// Digits that writers drop or roundings leave: entries of a symmetric matrix are as equal as this, relative.
constexpr double rounding = 1e-12;

/// Where a matrix comes from, for messages.
struct Origin {
  const std::string& name;
  bool is_file;  ///< has lines, and counts from 1

  [[nodiscard]] int first() const noexcept { return is_file ? 1 : 0; }
  [[noreturn]] void refuse(const Entry& entry, const std::string& rule) const {
    throw InputError(fmt::format("{}: entry ({}, {}) is {}; {}",
                                 is_file ? fmt::format("{}:{}", name, entry.line) : name, entry.row + first(),
                                 entry.column + first(), entry.value, rule));
  }
};

/// Entries that stand for one place are summed, as the format has it for coordinates; zeros are left out.
void sort_and_sum(std::vector<Entry>& entries) {
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.row, a.column) < std::tie(b.row, b.column);
  });
  std::size_t kept = 0;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (kept > 0 && entries[kept - 1].row == entries[k].row && entries[kept - 1].column == entries[k].column)
      entries[kept - 1].value += entries[k].value;
    else
      entries[kept++] = entries[k];
  }
  entries.resize(kept);
  std::erase_if(entries, [](const Entry& entry) { return entry.value == 0; });
}

/// Off-diagonal entries with row < column, and the diagonal [rows].
struct Halves {
  std::vector<Entry> upper;
  std::vector<double> diagonal;
};

/// One triangle of a symmetric file stands for both. A pair in both of them is one stored in full, whose
/// conductance would count twice.
void require_one_triangle(const Origin& origin, const std::vector<Entry>& entries) {
  std::vector<Entry> upper, lower;
  for (const auto& entry : entries) (entry.row < entry.column ? upper : lower).push_back(entry);
  if (upper.empty()) return;
  const auto before = [](const Entry& a, const Entry& b) {
    return std::tie(a.row, a.column) < std::tie(b.row, b.column);
  };
  std::sort(lower.begin(), lower.end(), before);
  for (const auto& entry : upper)
    if (std::binary_search(lower.begin(), lower.end(), Entry{entry.column, entry.row, 0, 0}, before))
      origin.refuse(entry,
                    "the entry across the diagonal stands there, too, and one triangle of a symmetric matrix "
                    "stands for both: leave one out, or call the matrix general");
}

Halves split(const Origin& origin, MatrixMarket matrix) {
  Halves out;
  if (matrix.is_symmetric && !matrix.is_dense) require_one_triangle(origin, matrix.entries);
  out.diagonal.assign(matrix.rows, 0.0);
  std::vector<Entry> lower;
  for (const auto& entry : matrix.entries) {
    if (entry.row == entry.column)
      out.diagonal[static_cast<std::size_t>(entry.row)] += entry.value;
    else if (matrix.is_symmetric || entry.row < entry.column)
      out.upper.push_back(
          {std::min(entry.row, entry.column), std::max(entry.row, entry.column), entry.value, entry.line});
    else
      lower.push_back({entry.column, entry.row, entry.value, entry.line});
  }
  sort_and_sum(out.upper);
  if (matrix.is_symmetric) return out;
  sort_and_sum(lower);
  const std::size_t both = std::min(lower.size(), out.upper.size());
  for (std::size_t k = 0; k < both || k < std::max(lower.size(), out.upper.size()); ++k) {
    const bool same_place =
        k < both && lower[k].row == out.upper[k].row && lower[k].column == out.upper[k].column;
    if (same_place && std::abs(lower[k].value - out.upper[k].value) <=
                          rounding * std::max(std::abs(lower[k].value), std::abs(out.upper[k].value))) {
      out.upper[k].value = 0.5 * (lower[k].value + out.upper[k].value);
      continue;
    }
    const bool below =
        k >= out.upper.size() || (k < lower.size() && std::tie(lower[k].row, lower[k].column) <
                                                          std::tie(out.upper[k].row, out.upper[k].column));
    Entry odd = below ? lower[k] : out.upper[k];
    if (below) std::swap(odd.row, odd.column);
    origin.refuse(
        odd,
        "the entry across the diagonal is another; conduction is symmetric: mend the matrix, or check how it "
        "was written");
  }
  return out;
}

MatrixKind find_kind(const Halves& halves) {
  const bool all_positive =
      std::all_of(halves.upper.begin(), halves.upper.end(), [](const Entry& e) { return e.value > 0; });
  const bool no_diagonal =
      std::all_of(halves.diagonal.begin(), halves.diagonal.end(), [](double d) { return d == 0; });
  return all_positive && no_diagonal ? MatrixKind::conductance : MatrixKind::laplacian;
}

/// What a row sums to flows to the surroundings.
void add_grounds(const Origin& origin, const std::vector<double>& diagonal, double ambient,
                 NetworkInput& input) {
  std::vector<double> sum = diagonal;
  for (std::size_t k = 0; k < input.graph.edges(); ++k)
    for (const auto node : {input.graph.i[k], input.graph.j[k]})
      sum[static_cast<std::size_t>(node)] -= input.graph.conductance[k];
  std::size_t grounds = 0;
  constexpr double cancellation = 1e-10;  // of the diagonal: what summing a row may leave
  for (std::size_t row = 0; row < sum.size(); ++row) {
    if (std::abs(sum[row]) <= cancellation * std::abs(diagonal[row])) continue;
    if (sum[row] < 0)
      throw InputError(
          fmt::format("{}: row {} of the Laplacian sums to {}; its diagonal must not be smaller than what "
                      "leads to other nodes: mend the matrix, or say matrix_kind",
                      origin.name, row + static_cast<std::size_t>(origin.first()), sum[row]));
    input.graph.convection.push_back({static_cast<std::int32_t>(row), sum[row], ambient, -1});
    ++grounds;
  }
  if (grounds > 0)
    input.notes.push_back(fmt::format("{}: {} to more than 0: these nodes exchange with surroundings at {}",
                                      origin.name, quantity(grounds, "row sums", "rows sum"), ambient));
}

NetworkInput network_of(const Origin& origin, MatrixMarket matrix, MatrixKind kind, double ambient) {
  if (matrix.rows != matrix.columns)
    throw InputError(fmt::format("{}: the matrix is {} by {}; a network's is square", origin.name,
                                 matrix.rows, matrix.columns));
  const std::size_t rows = matrix.rows;
  const Halves halves = split(origin, std::move(matrix));
  const bool is_guess = kind == MatrixKind::automatic;
  if (is_guess) kind = find_kind(halves);
  NetworkInput input{equal_nodes(rows), {}};
  for (auto& id : input.graph.id) id += origin.first();
  const double sign = kind == MatrixKind::laplacian ? -1 : 1;
  for (const auto& entry : halves.upper) {
    if (!(sign * entry.value > 0))
      origin.refuse(entry, kind == MatrixKind::laplacian
                               ? "off the diagonal a Laplacian holds -K, <= 0; is this a table of "
                                 "conductances (matrix_kind = \"conductance\")?"
                               : "a conductance must be >= 0; is this a Laplacian (matrix_kind = "
                                 "\"laplacian\")?");
    add_edge(input.graph, static_cast<std::size_t>(entry.row), static_cast<std::size_t>(entry.column),
             sign * entry.value);
  }
  if (is_guess)
    input.notes.push_back(fmt::format("{}: read as a {}", origin.name,
                                      kind == MatrixKind::laplacian ? "Laplacian" : "table of conductances"));
  if (kind == MatrixKind::laplacian) {
    add_grounds(origin, halves.diagonal, ambient, input);
  } else if (std::any_of(halves.diagonal.begin(), halves.diagonal.end(), [](double d) { return d != 0; })) {
    throw InputError(fmt::format(
        "{}: a table of conductances has no diagonal; remove it, or say matrix_kind = \"laplacian\"",
        origin.name));
  }
  return input;
}

}  // namespace

NetworkInput read_matrix_network(const std::string& file, MatrixKind kind, double ambient) {
  MatrixMarket matrix = read_matrix_market(file);
  // A few bytes must not ask for all the memory there is.
  constexpr std::size_t allowance = 1000;
  if (matrix.rows > 2 * matrix.entries.size() + allowance)
    throw InputError(fmt::format(
        "{}: has {} rows and {} entries, so that most nodes touch nothing; check its sizes, or leave these "
        "nodes out",
        file, matrix.rows, matrix.entries.size()));
  std::string warning = std::move(matrix.warning);
  NetworkInput input = network_of({file, true}, std::move(matrix), kind, ambient);
  if (!warning.empty()) input.notes.push_back(std::move(warning));
  return input;
}

NetworkInput network_of_matrix(const std::string& name, MatrixMarket matrix, MatrixKind kind,
                               double ambient) {
  return network_of({name, false}, std::move(matrix), kind, ambient);
}

}  // namespace superstep
