#pragma once
/// Memory that was used and is not any more.

#include <vector>

namespace superstep {

/// Leaves a list empty and without room: assigning {} keeps it.
template <class Value>
void free_list(std::vector<Value>& list) noexcept {
  std::vector<Value>().swap(list);
}

/// Gives what has been freed back to the system, kept huge pages included: before as much is built that
/// stays, or before somebody measures.
void give_back_memory() noexcept;

}  // namespace superstep
