#pragma once
/// Cases as texts, in a folder with the files that they read.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "case/scene.hpp"
#include "core/error.hpp"
#include "integrators/registry.hpp"
#include "support/temporary_folder.hpp"

namespace superstep::test {

/// Of a field on all nodes, by a tight run.
inline std::vector<double> values_at_end(const Scene& scene, std::size_t field = 0) {
  Plan plan;
  plan.output_times = {scene.t_end};
  for (const auto& one : scene.fields)
    if (!one.steady) plan.ranges.push_back(one.range_of_state());
  const auto integrator = make_integrator("cvode:rtol=1e-9");
  integrator->prepare(*scene.rhs, plan);
  integrator->start(0, scene.initial);
  const Outcome outcome = integrator->advance(scene.t_end);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  return scene.values_on_nodes(field, scene.t_end, integrator->state());
}

class CaseTexts : public testing::Test {
 protected:
  Scene load(const std::string& text) { return load_scene(folder_.write("c.toml", text)); }
  std::string refusal(const std::string& text) {
    return message_of<InputError>([&] { (void)load(text); });
  }
  void expect_refused(const std::string& text, const std::string& part) {
    const auto message = refusal(text);
    EXPECT_NE(message.find(part), std::string::npos) << "wanted: " << part << "\n   got: " << message;
  }
  TemporaryFolder folder_;
};

}  // namespace superstep::test
