#pragma once
/// Loops over contacts in vector registers.

#include <cstddef>

/// Also compiled for AVX2, chosen when the program starts. Without FMA, so that both give the same bits. The
/// choice runs before sanitizers are ready.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define SUPERSTEP_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define SUPERSTEP_CLONES
#endif

/// Before a loop whose turns do not depend on each other. clang warns where a sanitizer's checks keep it from
/// making use of that.
#ifndef __clang__
#define SUPERSTEP_INDEPENDENT _Pragma("GCC ivdep")
#elif __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SUPERSTEP_INDEPENDENT
#else
#define SUPERSTEP_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#endif

namespace superstep::dynamics {

/// What is gathered at a time: it stays in the first cache.
inline constexpr std::size_t pairs_per_block = 128;

}  // namespace superstep::dynamics
