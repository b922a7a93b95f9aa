#pragma once
/// Inputs that follow tables of time, seen whole or on one smooth piece.
///
/// Between two neighbouring breakpoints every table is a line. On a piece that line holds for any time that
/// is asked for: a method that looks a little beyond its end sees no kink, and at a step each side has its
/// own value.

#include <cstddef>
#include <optional>
#include <vector>

#include "core/time_table.hpp"

namespace superstep {

class TabledInputs {
 public:
  TabledInputs() = default;
  explicit TabledInputs(std::vector<TimeTable> tables) : tables_(std::move(tables)), line_(tables_.size()) {}

  [[nodiscard]] double at(std::size_t table, double t) const noexcept {
    if (!on_piece_) return tables_[table].at(t);
    return line_[table].value + line_[table].slope * (t - begin_);
  }
  /// From now on every table is the line that it is between `begin` and `end` [s], with no knot between them.
  void enter(double begin, double end) noexcept {
    for (std::size_t k = 0; k < tables_.size(); ++k) line_[k] = tables_[k].line(begin, end);
    begin_ = begin;
    on_piece_ = true;
  }
  /// Back to whole tables.
  void leave() noexcept { on_piece_ = false; }

  [[nodiscard]] const std::vector<TimeTable>& tables() const noexcept { return tables_; }

 private:
  std::vector<TimeTable> tables_;
  std::vector<TimeTable::Line> line_;
  double begin_ = 0;
  bool on_piece_ = false;
};

}  // namespace superstep
