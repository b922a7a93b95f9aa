#include "network/files/matrix_market.hpp"

#include <fmt/format.h>

#include <limits>

#include "core/error.hpp"
#include "core/text/append.hpp"
#include "core/text/cut_off.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"

namespace superstep {
namespace {

constexpr std::string_view banner = "%%matrixmarket";

class Reader {
 public:
  Reader(std::string path, std::string_view text) : path_(std::move(path)), lines_(text) {}

  MatrixMarket read() {
    lines_.next();
    read_banner();
    if (!next_row()) fail("ends before its sizes; it is cut off");
    matrix_.rows = size(0);
    matrix_.columns = size(1);
    if (matrix_.is_symmetric && matrix_.rows != matrix_.columns) fail("a symmetric matrix must be square");
    if (matrix_.is_dense)
      read_dense();
    else
      read_coordinates();
    if (next_row()) fail("has more rows than its sizes announce; mend one of the two");
    return std::move(matrix_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(fmt::format("{}:{}: {}", path_, lines_.number(), reason));
  }
  void read_banner() {
    const std::string line = lower_case(lines_.line());
    split_cells(line, ' ', cells_);
    const auto word = [&](std::size_t k) {
      return k < cells_.size() ? std::string(cells_[k]) : std::string{};
    };
    if (word(0) != banner || word(1) != "matrix")
      fail("the first line must be %%MatrixMarket matrix coordinate|array real|integer general|symmetric");
    matrix_.is_dense = word(2) == "array";
    if (!matrix_.is_dense && word(2) != "coordinate")
      fail(fmt::format("layout is {}; it must be coordinate or array", in_quotes(word(2))));
    if (word(3) != "real" && word(3) != "integer")
      fail(fmt::format("entries are {}; they must be real or integer numbers", in_quotes(word(3))));
    matrix_.is_symmetric = word(4) == "symmetric";
    if (!matrix_.is_symmetric && word(4) != "general")
      fail(fmt::format("symmetry is {}; it must be general or symmetric", in_quotes(word(4))));
  }
  bool next_row() {
    while (lines_.next()) {
      if (is_comment_or_blank(lines_.line())) continue;
      split_cells(lines_.line(), ' ', cells_);
      return true;
    }
    return false;
  }
  [[nodiscard]] std::size_t size(std::size_t k) const {
    const auto value = k < cells_.size() ? parse_integer(cells_[k]) : std::nullopt;
    const bool is_count_of_entries = k == 2;
    const std::int64_t most =
        is_count_of_entries ? std::int64_t{1} << 40 : std::numeric_limits<std::int32_t>::max();
    if (!value || *value < (is_count_of_entries ? 0 : 1) || *value > most)
      fail(fmt::format("sizes are {}; they must be counts: rows columns{}", in_quotes(lines_.line()),
                       matrix_.is_dense ? "" : " entries"));
    return static_cast<std::size_t>(*value);
  }
  [[nodiscard]] std::int32_t place(std::size_t k, std::size_t most) const {
    const auto value = parse_integer(cells_[k]);
    if (!value || *value < 1 || *value > static_cast<std::int64_t>(most))
      fail(fmt::format("position {} must lie between 1 and {}", in_quotes(cells_[k]), most));
    return static_cast<std::int32_t>(*value - 1);
  }
  [[nodiscard]] double value(std::size_t k) const {
    const auto number = parse_number(cells_[k]);
    if (!number)
      fail(fmt::format("entry is {}; it must be a finite decimal number such as 1.5e-3",
                       in_quotes(cells_[k])));
    return *number;
  }
  void read_coordinates() {
    const std::size_t count = size(2);
    for (std::size_t k = 0; k < count; ++k) {
      if (!next_row())
        fail(fmt::format("ends after {} entries; its sizes announce {}; it is cut off", k, count));
      if (cells_.size() != 3)
        fail(fmt::format("row has {} columns; it must have 3: row column value", cells_.size()));
      matrix_.entries.push_back(
          {place(0, matrix_.rows), place(1, matrix_.columns), value(2), lines_.number()});
    }
  }
  void read_dense() {
    for (std::size_t column = 0; column < matrix_.columns; ++column)
      for (std::size_t row = matrix_.is_symmetric ? column : 0; row < matrix_.rows; ++row) {
        if (!next_row()) fail("ends before its last entry; it is cut off");
        if (cells_.size() != 1)
          fail(fmt::format("row has {} columns; it must have one entry", cells_.size()));
        matrix_.entries.push_back(
            {static_cast<std::int32_t>(row), static_cast<std::int32_t>(column), value(0), lines_.number()});
      }
  }

  std::string path_;
  LineReader lines_;
  std::vector<std::string_view> cells_;
  MatrixMarket matrix_;
};

}  // namespace

bool is_matrix_market(const std::string& text) noexcept {
  return text.size() >= banner.size() &&
         lower_case(std::string_view(text).substr(0, banner.size())) == banner;
}

MatrixMarket read_matrix_market(const std::string& path) {
  const std::string text = read_text_file(path);
  MatrixMarket matrix = Reader(path, text).read();
  matrix.warning = unfinished_line(path, text);
  return matrix;
}

std::string matrix_market_text(std::size_t size, std::span<const MatrixMarket::Entry> lower,
                               const std::string& comment) {
  std::string out;
  append(out, "%%MatrixMarket matrix coordinate real symmetric\n% {}\n{} {} {}\n", comment, size, size,
         lower.size());
  for (const auto& entry : lower) append(out, "{} {} {}\n", entry.row + 1, entry.column + 1, entry.value);
  return out;
}

std::string matrix_market_text(std::span<const double> vector, const std::string& comment) {
  std::string out;
  append(out, "%%MatrixMarket matrix array real general\n% {}\n{} 1\n", comment, vector.size());
  for (const double value : vector) append(out, "{}\n", value);
  return out;
}

}  // namespace superstep
