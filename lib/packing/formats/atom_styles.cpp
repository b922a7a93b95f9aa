#include "packing/formats/atom_styles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/text/text_file.hpp"

namespace superstep {
namespace {

using Names = std::vector<std::string>;

/// What a style puts behind `id type x y z` when it is part of a hybrid one. Source: LAMMPS manual,
/// `read_data`.
const std::vector<std::pair<std::string, Names>>& parts() {
  static const std::vector<std::pair<std::string, Names>> list = {
      {"sphere", {"diameter", "density"}},
      {"granular", {"diameter", "density"}},
      {"bpm/sphere", {"mol", "diameter", "density"}},
      {"atomic", {}},
      {"bond", {"mol"}},
      {"bond/gran", {"mol"}},
      {"angle", {"mol"}},
      {"molecular", {"mol"}},
      {"charge", {"q"}},
      {"full", {"mol", "q"}},
      {"dipole", {"q", "mux", "muy", "muz"}},
      {"ellipsoid", {"ellipsoidflag", "density_"}},
      {"template", {"mol", "template", "atom"}},
      {"dpd", {"theta"}},
      {"edpd", {"edpd_temp", "edpd_cv"}},
      {"sph", {"rho", "esph", "cv"}}};
  return list;
}

bool knows_diameters(const std::string& style) {
  return style == "sphere" || style == "granular" || style == "bpm/sphere";
}

AtomLayout hybrid(const Names& styles, const std::string& where) {
  AtomLayout layout{"hybrid", {"id", "type", "x", "y", "z"}};
  for (const auto& style : styles) {
    const auto part =
        std::find_if(parts().begin(), parts().end(), [&](const auto& one) { return one.first == style; });
    if (part == parts().end())
      throw InputError(
          fmt::format("{}: atom style is {}, whose columns are not known here; declare them all, as in "
                      "[packing] columns = [\"id\", \"type\", \"x\", \"y\", \"z\", \"diameter\", "
                      "\"density\"]",
                      where, in_quotes(style)));
    layout.style += " " + style;
    layout.columns.insert(layout.columns.end(), part->second.begin(), part->second.end());
  }
  return layout;
}

std::ptrdiff_t place(const AtomLayout& layout, const char* name) {
  return std::find(layout.columns.begin(), layout.columns.end(), name) - layout.columns.begin();
}

/// Two layouts that differ in nothing that a packing needs are one.
bool reads_alike(const AtomLayout& a, const AtomLayout& b) {
  for (const char* name : {"id", "type", "x", "diameter"})
    if (place(a, name) != place(b, name)) return false;
  return true;
}

std::vector<AtomLayout> all_layouts(bool hybrid_only) {
  std::vector<AtomLayout> out;
  if (!hybrid_only) {
    out.push_back(atom_layout("sphere", {}));
    out.push_back(atom_layout("bpm/sphere", {}));
  }
  out.push_back(hybrid({"sphere"}, {}));
  for (const auto& [style, columns] : parts()) {
    if (knows_diameters(style) || columns.empty()) continue;
    out.push_back(hybrid({"sphere", style}, {}));
    out.push_back(hybrid({style, "sphere"}, {}));
  }
  return out;
}

}  // namespace

AtomLayout atom_layout(const std::string& style, const std::string& where) {
  std::istringstream words(style);
  Names styles;
  for (std::string word; words >> word;) styles.push_back(word);
  if (styles.size() > 1 && styles[0] == "hybrid") {
    styles.erase(styles.begin());
    if (std::any_of(styles.begin(), styles.end(), knows_diameters)) return hybrid(styles, where);
  }
  if (styles.size() == 1 && (style == "sphere" || style == "granular"))
    return {style, {"id", "type", "diameter", "density", "x", "y", "z"}};
  if (styles.size() == 1 && style == "bpm/sphere")
    return {style, {"id", "mol", "type", "diameter", "density", "x", "y", "z"}};
  throw InputError(fmt::format(
      "{}: atom style is {}; it must be sphere or granular, bpm/sphere, or a hybrid that holds one of them, "
      "which know diameters; write the data file with one of these, or declare [packing] columns",
      where, in_quotes(style)));
}

std::vector<AtomLayout> atom_layouts(std::size_t columns, bool hybrid_only) {
  std::vector<AtomLayout> out;
  for (auto& layout : all_layouts(hybrid_only)) {
    const bool is_new =
        std::none_of(out.begin(), out.end(), [&](const auto& one) { return reads_alike(one, layout); });
    if (layout.columns.size() == columns && is_new) out.push_back(std::move(layout));
  }
  return out;
}

}  // namespace superstep
