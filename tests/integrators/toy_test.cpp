/// The example of integrators/README.md: it stands there as it is compiled here, and does what it says.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "support/problem.hpp"
#include "toy/heun.cpp"

namespace superstep {
namespace {

std::string content_of(const std::string& file) {
  std::ifstream stream(std::string(SUPERSTEP_SOURCE_DIR) + "/" + file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ToyIntegrator, StandsInTheReadmeAsItIsCompiled) {
  const std::string code = content_of("tests/toy/heun.cpp");
  const auto begin = code.find("class Heun"), end = code.find("\n\n private:");
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  EXPECT_NE(content_of("integrators/README.md").find(code.substr(begin, end - begin)), std::string::npos)
      << "copy the class from tests/toy/heun.cpp into integrators/README.md";
}

TEST(ToyIntegrator, IsOfOrderTwo) {
  test::Problem problem(test::random_graph({.nodes = 25, .seed = 7, .contrast = 4, .sources = true}));
  const auto exact = problem.exact(1.0);
  const auto entry = heun_entry();
  const auto error = [&](double step) {
    Integrator integrator(entry.make(Options(parse_spec("heun:step=" + std::to_string(step)), entry.keys)));
    integrator.prepare(*problem.rhs, problem.plan({1.0}));
    integrator.start(0, problem.initial);
    EXPECT_TRUE(integrator.advance(1.0).ok());
    return test::rms_difference({integrator.state().begin(), integrator.state().end()}, exact);
  };
  EXPECT_NEAR(std::log2(error(0.0025) / error(0.00125)), 2, 0.1);
}

}  // namespace
}  // namespace superstep
