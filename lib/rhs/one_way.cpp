#include "rhs/one_way.hpp"

namespace superstep {
namespace {

bool linear_with_constants(const Rhs& rhs) {
  const auto& traits = rhs.traits();
  return traits.linear && traits.symmetric && traits.autonomous;
}

}  // namespace

bool exactly_solvable(Rhs& rhs) {
  if (linear_with_constants(rhs)) return true;
  OneWayCoupling* halves = rhs.one_way();
  return halves && linear_with_constants(halves->driver()) && linear_with_constants(halves->driven());
}

}  // namespace superstep
