#pragma once
/// Tables of particles that are read in parts.

#include <cstdint>
#include <optional>
#include <string>

#include "core/text/rows_in_parts.hpp"
#include "packing/packing.hpp"
#include "packing/read_options.hpp"

namespace superstep {

class TableInParts {
 public:
  /// Opens a table that says before its first row all that there is to know: plain text that is not packed,
  /// with names of its columns, or declared ones, without a box and without materials. Nothing where the file
  /// is another one; `why_not` says then what it is. Throws InputError for a file that cannot be read, and
  /// for a head that is wrong.
  [[nodiscard]] static std::optional<TableInParts> open(const std::string& path,
                                                        const PackingOptions& options, std::string& why_not);

  [[nodiscard]] const std::string& path() const noexcept { return rows_.path(); }
  /// Bytes of all rows.
  [[nodiscard]] std::uint64_t bytes() const noexcept { return rows_.bytes(); }
  [[nodiscard]] double length_unit() const noexcept { return length_unit_; }  ///< m
  [[nodiscard]] bool has_ids() const noexcept { return has_ids_; }

  /// The rows that begin at bytes [first, last) of all, read as the whole file would be: checks are those of
  /// the part. Ids count from 0 where the file has none. Columns that are attributes are left out. Throws
  /// InputError, whose line counts from the first of the part: who has memory for the file reads it to say
  /// where.
  [[nodiscard]] Packing read(std::uint64_t first, std::uint64_t last) const;

 private:
  RowsInParts rows_;
  PackingOptions options_;
  double length_unit_ = 1;
  bool has_ids_ = false;
};

}  // namespace superstep
