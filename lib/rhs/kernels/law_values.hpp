#pragma once
/// Values and slopes of one conductivity law at many temperatures, vectorised: `ConductivityLaw::at` and
/// `slope` to a few roundings.

#include <cstddef>
#include <span>

#include "rhs/conductivity_law.hpp"

namespace superstep {

/// out[i] = kappa(temperature[i]). AVX2 and AVX-512 agree bit by bit.
void law_values(const ConductivityLaw& law, std::span<const double> temperature, std::span<double> out);
/// out[i] = dkappa/dT at temperature[i]; likewise.
void law_slopes(const ConductivityLaw& law, std::span<const double> temperature, std::span<double> out);

/// The kernels of one instruction set, for tests.
struct LawKernel {
  using Values = void (*)(const ConductivityLaw& law, const double* temperature, std::size_t count,
                          double* out);
  const char* name;
  Values values, slopes;
};
/// Those that this machine can run, the one in use first.
[[nodiscard]] std::span<const LawKernel> law_kernels() noexcept;

}  // namespace superstep
