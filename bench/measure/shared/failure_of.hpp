#pragma once
/// Work that may fail on one of several processes, which must not keep the others waiting.

#include <exception>
#include <new>
#include <optional>
#include <string>

namespace superstep {

/// Why some work could not be done here; nothing where it was done. What all then do is theirs to agree on,
/// see Communicator::first_of.
template <class Work>
std::optional<std::string> failure_of(const Work& work) {
  try {
    work();
    return std::nullopt;
  } catch (const std::bad_alloc&) {
    return "a process found no memory for its part of a file; take more processes, or write less";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace superstep
