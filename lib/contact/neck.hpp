#pragma once
/// Neck laws: radius of the conducting neck from radii and overlap. One law a file neck_NAME.cpp, one line in
/// neck.cpp.

#include <span>
#include <string>
#include <vector>

#include "contact/contact.hpp"

namespace superstep {

/// Parameters that a law may use; a law ignores the others.
struct NeckParameters {
  double hardening = 1.45;  ///< plastic: f_c^2, 0.5 (linear hardening) to 1.45 (perfectly plastic)
  double bond_radius = 0;   ///< m; no neck is narrower, and contacts across a gap have it; 0 = no gaps
};

struct NeckLaw {
  std::string name;                     ///< as the case file writes it
  std::string formula;                  ///< for `superstep list`
  std::string source;                   ///< paper and equation
  std::vector<std::string> parameters;  ///< case keys beside `neck` that it reads
  double (*radius)(double r_i, double r_j, double overlap, const NeckParameters&);  ///< [m]; not limited
};

/// Every law, in the order of `superstep list`.
[[nodiscard]] std::span<const NeckLaw> neck_laws();
/// Law of that name, or nullptr.
[[nodiscard]] const NeckLaw* find_neck_law(const std::string& name);

/// How the necks of a packing came out.
struct NeckReport {
  std::size_t limited = 0;    ///< contacts whose neck was limited to min(r_i, r_j)
  std::size_t saturated = 0;  ///< contacts deeper than the saturation overlap of the volume-preserving neck
};

/// Fills `contacts.neck_radius`, limited to the smaller of the two radii. A contact across a gap (overlap <=
/// 0) gets no neck from a formula: without a bond radius it is an error, whose way out is one, or a file of
/// bonds.
NeckReport apply_neck_law(const Packing& packing, const NeckLaw& law, const NeckParameters& parameters,
                          Contacts& contacts);

}  // namespace superstep
