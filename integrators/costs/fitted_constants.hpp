#pragma once
/// Written by `superstep fit`.

#include "integrators/costs/constants.hpp"

namespace superstep::fitted {

constexpr CostConstants constants() {
  CostConstants c;
  return c;
}

}  // namespace superstep::fitted
