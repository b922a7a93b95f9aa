#pragma once
/// How many instructions a method's stepping takes, counted by callgrind: the same number on a busy machine
/// as on an idle one. Valgrind hides AVX-512 from the dispatch, so that what is counted is the AVX2 kernel.
/// Source: Nethercote & Seward (2007), doi:10.1145/1250734.1250746.

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

namespace superstep {

/// "valgrind-3.19.0"; empty where it is not installed.
[[nodiscard]] std::string valgrind_version();

/// What a count depends on besides the build: "valgrind-3.19.0, avx2", the second being the sweep that is
/// left without AVX-512. Empty where Valgrind is not installed.
[[nodiscard]] std::string counter_facts();

/// Result of one count.
struct InstructionCount {
  std::optional<std::uint64_t> instructions;
  std::string reason;  ///< why there is none
};

/// Runs the case under callgrind with one SPEC, in a process of its own on one thread, and counts what it
/// executes between start and end of the integration.
///   program  path of this program
///   stop     ends the run, which takes some fifty times as long as another, without a count; may be null
[[nodiscard]] InstructionCount count_instructions(const std::string& program, const std::string& case_file,
                                                  const std::string& spec, const std::atomic<bool>* stop);

}  // namespace superstep
