#pragma once
/// The part of a run whose instructions are counted: a function with a name that callgrind can be told.

#include <type_traits>

extern "C" {
/// Calls `work(data)`. Instructions are counted from here until it returns (--toggle-collect).
void superstep_counted(void (*work)(void*), void* data);
}

namespace superstep {

/// Name of that function.
inline constexpr const char* counted_function = "superstep_counted";

template <class Work>
void counted(Work&& work) {
  superstep_counted([](void* data) { (*static_cast<std::remove_reference_t<Work>*>(data))(); }, &work);
}

}  // namespace superstep
