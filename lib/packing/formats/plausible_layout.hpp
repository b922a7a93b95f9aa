#pragma once
/// The order of columns of a data file that does not state it: the only one that makes sense.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "packing/cell.hpp"
#include "packing/formats/atom_styles.hpp"

namespace superstep {

/// Looks at every row with every order that has as many columns.
class PlausibleLayout {
 public:
  ///   cell   in units of the file; nothing = positions may be anywhere
  ///   types  number of atom types; 0 = any
  PlausibleLayout(std::optional<Cell> cell, std::int64_t types, bool hybrid_only);

  /// A row; three image flags may be its last cells.
  void look_at(std::span<const std::string_view> row);
  /// The one order in which every row has whole ids and types, sizes and densities > 0, and positions in the
  /// box (or no more than a diameter outside it). Where none fits every row, the one that fits most of them
  /// while the others fit next to none: then some rows are wrong, and their reader says what. Throws
  /// InputError, beginning with `place`, when there is none, or more than one, and says what to declare.
  [[nodiscard]] AtomLayout choose(const std::string& place) const;

 private:
  struct Candidate {
    AtomLayout layout;
    std::size_t id, type, x, diameter, density;
    std::size_t fits = 0;  ///< rows
  };
  void add_candidates(std::size_t columns);
  [[nodiscard]] bool accepts(const Candidate& candidate, std::span<const std::string_view> row) const;
  [[nodiscard]] bool is_inside(double diameter, Vec3 centre) const;

  std::optional<Cell> cell_;
  std::int64_t types_;
  bool hybrid_only_;
  std::size_t width_ = 0;  ///< of the first row
  std::size_t rows_ = 0;
  std::vector<Candidate> candidates_;
};

}  // namespace superstep
