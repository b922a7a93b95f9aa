#pragma once
/// Material tables of a case: one `[material]`, or several `[[materials]]` with `[[interfaces]]` between
/// them.

#include <string>
#include <utility>
#include <vector>

#include "contact/conductance.hpp"
#include "core/text/toml.hpp"
#include "packing/packing.hpp"
#include "rhs/conductivity_law.hpp"

namespace superstep {

/// How one field conducts in one material.
struct Conduction {
  ConductivityLaw conductivity;  ///< W/(m K) or S/m
  double capacity = 1;           ///< J/(kg K) or F/kg, > 0; without meaning in a steady field
};

/// One field's conduction in every material of the packing.
struct FieldMaterials {
  std::vector<Conduction> of_material;  ///< [materials]
  Interface grain_boundary;             ///< between equal and unnamed pairs
  std::vector<std::pair<std::pair<std::int32_t, std::int32_t>, Interface>>
      between;        ///< overrides, lower index first
  std::string place;  ///< of one of these, file and line

  [[nodiscard]] Interface interface(std::int32_t a, std::int32_t b) const;
};

/// The materials of a case, in the order of the packing's material names.
class Materials {
 public:
  /// Reads `[material]`, or `[[materials]]` and `[[interfaces]]` to the last of them: what the packing does
  /// not use must be right as well. Throws InputError.
  Materials(TomlTable& root, const Packing& packing);

  [[nodiscard]] double density(std::int32_t material) const {
    return density_[static_cast<std::size_t>(material)];
  }
  /// Reads one field (`key` = "thermal" or "electric") from its table and from the materials.
  ///   capacity_key  "specific_heat" or "specific_capacity"; empty = the field is steady and has none
  [[nodiscard]] FieldMaterials field(const std::string& key, TomlTable& field_table,
                                     const std::string& capacity_key);

 private:
  void read_materials(const TomlValue& list, const Packing& packing);
  void read_interfaces(const TomlValue& list);
  void add_interface(TomlTable& table, std::pair<std::int32_t, std::int32_t> between);

  struct Described {
    std::string name;
    TomlTable table;
  };
  std::vector<Described> given_;   ///< [[materials]] as written; empty for one material
  std::vector<std::size_t> used_;  ///< [materials of the packing] index into given_
  std::vector<double> density_;    ///< [materials of the packing] kg/m^3
  /// Interfaces by field between two of given_, lower index first; `place` = file and line.
  struct Given {
    std::string key, place;
    std::pair<std::int32_t, std::int32_t> between;
    Interface interface;
  };
  std::vector<Given> interfaces_;
};

}  // namespace superstep
