#pragma once
/// What a measurement has to say about where it was made.

#include <string>
#include <vector>

#include "results/results.hpp"

namespace superstep {

[[nodiscard]] std::string program_version();
/// Revision of the sources at configure time; empty when unknown.
[[nodiscard]] std::string program_revision();

/// Processor, cores, kernel, compiler and flags, the BLAS that is loaded and its threads.
[[nodiscard]] std::vector<Fact> machine_facts();
/// Versions of the libraries that the numbers depend on.
[[nodiscard]] std::vector<Fact> library_facts();

/// Tells libraries that start threads of their own (OpenBLAS, OpenMP) how many they may have. CPU time is
/// process time, so idle helpers that spin would be charged to the method.
void set_library_threads(int threads);

/// Makes `peak_memory_megabytes()` count anew from the present use; where the kernel does not allow it, the
/// peak stays that of the whole process.
void reset_peak_memory();

}  // namespace superstep
