#pragma once
/// Several processes as threads of one: what MPI does for real, in an obvious way.

#include <functional>

#include "parallel/communicator.hpp"

namespace superstep::test {

/// Calls body once for each of so many processes, all at the same time. An OpenMP team has `threads` threads.
void as_processes(int count, int threads, const std::function<void(Communicator&)>& body);

}  // namespace superstep::test
