#pragma once
/// Doubles in vector registers, for kernels that are compiled once for each instruction set.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

// One text, compiled for each instruction set: inlined into functions with a `target` of their own.
#define SUPERSTEP_INLINE [[gnu::always_inline]] inline

#if defined(__x86_64__)
#define SUPERSTEP_AVX2 __attribute__((target("avx2,fma")))
#define SUPERSTEP_AVX512 __attribute__((target("avx512f,avx512vl,avx512dq,fma")))
#endif

namespace superstep {

/// `width` doubles in a vector register.
template <std::size_t width>
struct Vector {
  typedef double type __attribute__((vector_size(width * sizeof(double))));
  typedef std::int64_t integer __attribute__((vector_size(width * sizeof(double))));
};

/// Two neighbours in one load: in cache it is loads that limit kernels.
struct NeighbourPair {
  SUPERSTEP_INLINE explicit NeighbourPair(const std::int32_t* from) {
    std::memcpy(&both, from, sizeof(both));
  }
  [[nodiscard]] SUPERSTEP_INLINE std::size_t first() const {
    return std::endian::native == std::endian::little ? both & 0xffff'ffffU : both >> 32;
  }
  [[nodiscard]] SUPERSTEP_INLINE std::size_t second() const {
    return std::endian::native == std::endian::little ? both >> 32 : both & 0xffff'ffffU;
  }
  std::uint64_t both;
};

/// Instruction sets that this machine can run, best first; a kernel has one function for each.
enum class InstructionSet : char { avx512, avx2, baseline };
struct InstructionSets {
  std::array<InstructionSet, 3> list{};
  std::size_t count = 0;
};
[[nodiscard]] inline InstructionSets instruction_sets() noexcept {
  InstructionSets out;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("fma"))
    out.list[out.count++] = InstructionSet::avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    out.list[out.count++] = InstructionSet::avx2;
#endif
  out.list[out.count++] = InstructionSet::baseline;
  return out;
}

/// The kernels of one kind, best first, for every instruction set that this machine can run.
template <class Kernel>
class KernelList {
 public:
  explicit KernelList(Kernel (*of)(InstructionSet) noexcept) {
    const auto sets = instruction_sets();
    for (count_ = 0; count_ < sets.count; ++count_) list_[count_] = of(sets.list[count_]);
  }
  [[nodiscard]] std::span<const Kernel> all() const noexcept { return std::span(list_).first(count_); }

 private:
  std::array<Kernel, 3> list_{};
  std::size_t count_ = 0;
};

}  // namespace superstep
