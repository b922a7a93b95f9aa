#include "rhs/one_way.hpp"

namespace superstep {
namespace {

bool linear_and_symmetric(const Rhs& rhs) {
  return rhs.traits().linear && rhs.traits().symmetric;
}

}  // namespace

bool exactly_solvable(Rhs& rhs) {
  if (rhs.fields().size() == 1) return linear_and_symmetric(rhs);
  OneWayCoupling* halves = rhs.one_way();
  return halves && linear_and_symmetric(halves->driver()) && linear_and_symmetric(halves->driven());
}

}  // namespace superstep
