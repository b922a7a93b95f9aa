#pragma once
/// Looks names up among those of a file, and says what is wrong with them.

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "packing/formats/columns/columns.hpp"
#include "packing/formats/columns/known_names.hpp"

namespace superstep {

class ColumnFinder {
 public:
  ColumnFinder(std::span<const std::string> names, const ColumnRules& rules, std::string place,
               std::string header);

  /// The column with the first of these plain names that there is, or none. Throws InputError where two have
  /// that name.
  [[nodiscard]] std::size_t find(const std::vector<std::string>& candidates) const;
  /// The columns of x, y and z, none for those that are missing. Throws InputError where all are there and
  /// one stands twice.
  [[nodiscard]] SphereColumns::Axes find_axes(const CoordinateNames& names) const;
  /// True where nothing is missing that the rules ask for.
  [[nodiscard]] bool is_complete(const SphereColumns::Axes& axes) const;

  /// Columns, and others of the very same name, which nothing is found in.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& repeated() const noexcept {
    return repeated_;
  }
  [[nodiscard]] std::optional<double> unit(std::size_t column) const;
  [[nodiscard]] const std::string& written(std::size_t column) const { return written_[column]; }
  [[nodiscard]] const ColumnRules& rules() const noexcept { return rules_; }
  [[nodiscard]] const std::string& place() const noexcept { return place_; }
  /// Says that there is no column of this name, nor with one of the candidates.
  [[noreturn]] void missing(const std::string& name, const std::vector<std::string>& candidates) const;

 private:
  [[nodiscard]] std::vector<std::size_t> all(const std::string& name) const;
  void require_one(const std::vector<std::size_t>& columns) const;
  [[nodiscard]] bool is_of_format(std::size_t column) const;
  [[nodiscard]] std::string hint(const std::string& name, const std::vector<std::string>& candidates) const;

  std::span<const std::string> written_;
  ColumnRules rules_;
  std::string place_, header_;
  std::vector<PlainName> plain_;
  std::vector<std::pair<std::size_t, std::size_t>> repeated_;
};

}  // namespace superstep
