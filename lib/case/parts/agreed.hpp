#pragma once
/// Mistakes that one process finds are everybody's.

#include <optional>
#include <string>

#include "core/error.hpp"
#include "parallel/communicator.hpp"

namespace superstep {

/// Does what may throw InputError on some process; then all throw that of the lowest rank. Collective.
template <class Work>
void agreed(Communicator& among, const Work& work) {
  std::optional<std::string> wrong;
  try {
    work();
  } catch (const InputError& error) {
    wrong = error.what();
  }
  if (const auto first = among.first_of(wrong)) throw InputError(*first);
}

}  // namespace superstep
