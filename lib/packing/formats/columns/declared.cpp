#include "packing/formats/columns/declared.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "packing/formats/columns/known_names.hpp"

namespace superstep {

void require_same_meaning(const PackingFile& file, std::span<const std::string> names) {
  const auto& options = file.options;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto of_file = plain_name(names[k]), declared = plain_name(options.columns[k]);
    const std::string meaning = usual_meaning(names[k]);
    const bool other_unit = of_file.unit && declared.unit && *of_file.unit != *declared.unit;
    if (meaning.empty() || (meaning == usual_meaning(options.columns[k]) && !other_unit)) continue;
    throw InputError(fmt::format(
        "{}: columns calls column {} '{}', and {} calls it '{}'; leave columns out, or mend the "
        "names in the file",
        options.place.empty() ? file.path : options.place, k + 1, options.columns[k], file.path, names[k]));
  }
}

}  // namespace superstep
