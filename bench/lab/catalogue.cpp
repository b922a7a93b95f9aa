#include "bench/lab/catalogue.hpp"

#include "integrators/registry.hpp"

namespace superstep {
namespace {

std::vector<StabilityModel> of_all(StabilityTheory::Models StabilityTheory::*part, bool quick) {
  std::vector<StabilityModel> all;
  for (const auto& entry : integrators())
    if (const auto& models = entry.stability.*part)
      for (auto& model : models(quick)) all.push_back(std::move(model));
  return all;
}

}  // namespace

std::vector<StabilityModel> stability_functions(bool quick) {
  return of_all(&StabilityTheory::functions, quick);
}

std::vector<StabilityModel> stability_limits(bool quick) {
  return of_all(&StabilityTheory::limits, quick);
}

}  // namespace superstep
