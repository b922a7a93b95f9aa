#pragma once
/// All bond laws by name. One more = one file in `laws/bonds`, its place in `BondRule`, one line in the list.

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "dynamics/contacts/contact_table.hpp"
#include "dynamics/laws/bond_law.hpp"
#include "dynamics/laws/contact_law.hpp"

namespace superstep::dynamics {

/// Bonds at one instant, beside the table of their pairs.
struct BondArrays {
  std::vector<std::size_t> pair;  ///< [bonds] place in the table
  std::vector<BondMemory> begin;  ///< when the step began
  std::vector<double> rate;       ///< of growth then [1/s]
  std::vector<BondMemory> now;
  std::vector<double> rate_now;  ///< 1/s
  std::vector<double> slope;     ///< bound of the slope of their force [N/m]

  [[nodiscard]] std::size_t size() const noexcept { return pair.size(); }
  void resize(std::size_t bonds);
};

/// From the beginning of a step to the instant.
struct StepPart {
  double h = 0;    ///< s; 0 = at its beginning
  double phi = 1;  ///< of the phi rule
};

/// What bonds are told beside the geometry.
struct BondSurroundings {
  const BondLaw& law;
  const ContactLaw& contact;
  std::span<const double> temperature;  ///< [n] K
  std::span<const double> mobility;     ///< [n] Arrhenius root; empty where no neck grows
  StepPart step;
};

/// True where a pair at this margin forms a bond, or breaks the one that it has.
[[nodiscard]] constexpr bool switches(double margin, bool bonded) noexcept {
  return bonded ? margin < 0 : margin <= 0;
}

struct BondKind {
  BondRule rule;
  std::string_view name;  ///< in case files
  bool smooth;            ///< no jump of the force when bonds form or break
  bool grows;             ///< has a neck that needs temperatures
  /// > 0 while the pair stays as it is; see `switches`.
  double (*margin)(const BondLaw&, double strain, BondMemory, bool bonded);
  /// Whether any pair of the table would form a bond, or break its own.
  bool (*any_switches)(const BondLaw&, const BondArrays&, const ContactTable&);
  /// Takes the bonds [first, last) to the instant and puts what they do into the table.
  void (*act)(const BondSurroundings&, BondArrays&, ContactTable&, std::size_t first, std::size_t last);
};

[[nodiscard]] std::span<const BondKind> bond_kinds() noexcept;
[[nodiscard]] const BondKind& bond_kind(BondRule rule) noexcept;

}  // namespace superstep::dynamics
