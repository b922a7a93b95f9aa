#pragma once
/// Memory that was used and is not any more.

#include <malloc.h>

#include <vector>

namespace superstep {

/// Leaves a list empty and without room: assigning {} keeps it.
template <class Value>
void free_list(std::vector<Value>& list) noexcept {
  std::vector<Value>().swap(list);
}

/// Gives what has been freed back to the system: after much has been built up and thrown away, before as much
/// is built that stays.
inline void give_back_memory() noexcept {
  (void)malloc_trim(0);
}

}  // namespace superstep
