#pragma once
/// The beginning of a file, for those who have to tell what it is.

#include "core/text/text_file.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/text_row.hpp"

namespace superstep {

/// The first lines that are not blank, split at blanks.
class BeginningLines {
 public:
  explicit BeginningLines(const PackingFile& file)
      : lines_(file.is_text ? file.content : std::string_view{}), row_({}) {}
  bool next() {
    constexpr std::size_t looked_at = 100;  // lines; headers are shorter
    while (lines_.number() < looked_at && lines_.next()) {
      row_.split(lines_.line(), lines_.number());
      if (row_.size() > 0) return true;
    }
    return false;
  }
  /// The same, comments left out.
  bool next_statement() {
    while (next())
      if (row_[0].front() != '#') return true;
    return false;
  }
  [[nodiscard]] const TextRow& row() const noexcept { return row_; }

 private:
  LineReader lines_;
  TextRow row_;
};

/// True when every cell is a number.
[[nodiscard]] bool all_numbers(const TextRow& row);

}  // namespace superstep
