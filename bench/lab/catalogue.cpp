#include "bench/lab/catalogue.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>

#include "integrators/schemes/stabilised_schemes.hpp"
#include "integrators/schemes/super_step.hpp"

namespace superstep {
namespace {

// Methods step by a spectral radius inflated by about one per cent; so does the laboratory.
constexpr double margin = 0.99;

MethodCase forward_euler() {
  return {.family = "forward-euler",
          .parameters = "",
          .order = "",
          .stages = 1,
          .beta = 2,
          .z_stiff = margin * 2,
          .response = [](double z) { return 1 - z; },
          .spec = [](double step) { return fmt::format("forward-euler:step={:.17g}", step); }};
}

MethodCase superstep(SuperstepShape shape, const std::string& order) {
  const int n = shape.n;  // not a structured binding: clang 14 cannot capture one
  const double nu = shape.nu;
  const double length = superstep_length(n, nu);
  return {.family = "sts",
          .parameters = fmt::format("n={},nu={:g}", n, nu),
          .order = order,
          .stages = n,
          .beta = 2 * length,
          .z_stiff = margin * 2 * length,
          .response = [=](double z) { return static_cast<double>(superstep_response(n, nu, z / length)); },
          .spec =
              [=](double step) {
                return fmt::format("sts:n={},nu={},order={},step={:.17g}", n, nu, order, step / length);
              }};
}

struct Family {
  const StabilisedFamily& (*family)();
  const char* name;  ///< of the SPEC
};

MethodCase stabilised(const Family& family, int stages) {
  const auto scheme = std::make_shared<ThreeTermScheme>(family.family().scheme(stages));
  // ROCK4's finish multiplies the roundings of its last stages, a few units each, by w(-l) = 1.5e-4 s^8.
  const double rounding = family.family().order == 4
                              ? 16 * std::numeric_limits<double>::epsilon() * 1.5e-4 * std::pow(stages, 8)
                              : 0;
  const std::string head =
      fmt::format("{}:{}stages={}", family.name, family.family().order == 1 ? "order=1," : "", stages);
  return {.family = family.family().name,
          .parameters = fmt::format("s={}", stages),
          .order = "",
          .stages = stages,
          .beta = scheme->beta,
          .z_stiff = margin * scheme->beta,
          .rounding = rounding,
          .response = [scheme](double z) { return stability_polynomial(*scheme, -z); },
          .spec = [head](double step) { return fmt::format("{},step={:.17g}", head, step); }};
}

MethodCase trapezoidal(double phi, double z_stiff) {
  return {.family = "trapezoidal",
          .parameters = fmt::format("phi={:g}", phi),
          .order = "",
          .stages = 1,
          .beta = std::nullopt,
          .z_stiff = z_stiff,
          .response = [phi](double z) { return (1 - (1 - phi) * z) / (1 + phi * z); },
          .spec = [phi](double step) { return fmt::format("trapezoidal:phi={},step={:.17g}", phi, step); }};
}

std::vector<int> stage_counts(const StabilisedFamily& family, bool quick) {
  const bool odd = family.stage_step == 2;
  if (family.order == 4) return quick ? std::vector{5, 20} : std::vector{5, 8, 10, 20, 50, 100};
  if (quick) return odd ? std::vector{3, 5, 21} : std::vector{2, 5, 20};
  return odd ? std::vector{3, 5, 11, 21, 51, 101, 199} : std::vector{2, 3, 5, 10, 20, 50, 100, 200};
}

}  // namespace

std::vector<SuperstepShape> superstep_shapes(bool quick) {
  if (quick) return {{5, 1e-3}, {20, 1e-4}, {64, 0.05}, {128, 1e-3}};
  std::vector<SuperstepShape> shapes;
  for (const double nu : {1e-3, 1e-4, 1e-5})
    for (const int n : {5, 10, 15, 20, 25}) shapes.push_back({n, nu});
  shapes.push_back({64, 0.05});
  shapes.push_back({128, 1e-3});
  return shapes;
}

std::vector<MethodCase> method_catalogue(bool quick) {
  std::vector<MethodCase> methods = {forward_euler()};
  for (const auto& shape : superstep_shapes(quick))
    for (const char* order : superstep_orders) methods.push_back(superstep(shape, order));
  const Family families[] = {{rkc1_family, "rkc"}, {rkc2_family, "rkc"}, {rkl1_family, "rkl"},
                             {rkl2_family, "rkl"}, {rkg2_family, "rkg"}, {rock4_family, "rock"}};
  for (const auto& family : families)
    for (const int stages : stage_counts(family.family(), quick))
      methods.push_back(stabilised(family, stages));
  for (const double phi : {0.5, 0.6, 1.0})
    for (const double z : {10.0, 1e4}) methods.push_back(trapezoidal(phi, z));
  return methods;
}

std::vector<MethodCase> limit_catalogue(bool quick) {
  std::vector<MethodCase> methods = {forward_euler(), superstep({10, 1e-3}, "leja"),
                                     stabilised({rkc2_family, "rkc"}, 10)};
  if (quick) return methods;
  methods.push_back(superstep({20, 1e-4}, "leja"));
  methods.push_back(stabilised({rkc1_family, "rkc"}, 10));
  methods.push_back(stabilised({rkl2_family, "rkl"}, 11));
  methods.push_back(stabilised({rkg2_family, "rkg"}, 11));
  methods.push_back(stabilised({rock4_family, "rock"}, 10));
  return methods;
}

}  // namespace superstep
