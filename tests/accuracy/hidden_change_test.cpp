/// Changes that an estimate or a criterion did not see: a body of low potential beside one of high, bends of
/// a table of conductivities, a sudden ambient behind a slow phase.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/measure/run_one.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

/// The last temperatures of all nodes [K].
std::vector<double> temperatures(const Scene& scene, const std::string& spec) {
  std::vector<double> last;
  RunRequest request;
  request.observe = [&](std::size_t, double, std::span<const double> state) {
    last.assign(state.begin(), state.end());
  };
  const RunResult run = run_one(scene, spec, request);
  EXPECT_TRUE(run.outcome.ok()) << spec << ": " << run.outcome.reason;
  for (std::size_t f = 0; f < scene.fields.size(); ++f)
    if (scene.fields[f].name == "temperature")
      return scene.values_on_nodes(f, scene.output_times.back(), last);
  return {};
}

/// Spheres in a row with given necks; the last ones may be of a second material.
///   times, rest  what the case says above and below that
std::string write_spheres(const test::CaseFolder& folder, const std::string& times,
                          const std::vector<double>& radii, const std::string& necks, int of_second_material,
                          const std::string& rest) {
  std::string rows = "id,x,y,z,radius,material\n";
  const int count = static_cast<int>(radii.size());
  for (int k = 0; k < count; ++k)
    rows += fmt::format("{},{},0,0,{},{}\n", k + 1, 0.0025 * k, radii[static_cast<std::size_t>(k)],
                        k < count - of_second_material ? "m0" : "m1");
  folder.write("row.csv", rows);
  folder.write("necks.csv", "i,j,radius\n" + necks);
  return folder.write("row.toml", times +
                                      "[packing]\nfile = \"row.csv\"\n[contact]\nneck = \"given\"\nfile = "
                                      "\"necks.csv\"\n" +
                                      rest);
}

/// Two chains of six that do not touch: one at `volts`, one between 0 and 0.02 V and ten thousand times
/// slower.
std::string write_two_bodies(const test::CaseFolder& folder, double volts) {
  std::string necks;
  for (const int first : {1, 7})
    for (int k = first; k < first + 5; ++k) necks += fmt::format("{},{},3e-4\n", k, k + 1);
  const char* material =
      "[[materials]]\nname = \"{}\"\ndensity = 5000.0\nthermal = {{ conductivity = 20.0, specific_heat = "
      "500.0 "
      "}}\nelectric = {{ conductivity = 1e4, specific_capacity = {} }}\n";
  std::string rest = "conductance = \"series\"\n" + fmt::format(fmt::runtime(material), "m0", 100.0) +
                     fmt::format(fmt::runtime(material), "m1", 1e6);
  rest += "[electric]\nmode = \"transient\"\ninitial = 0.0\nfixed = [\n";
  for (const auto& [id, value] : {std::pair{1, volts}, {6, volts}, {7, 0.0}, {12, 0.02}})
    rest += fmt::format("{{ where = {{ ids = [{}] }}, value = {} }},\n", id, value);
  rest +=
      "]\n[thermal]\ninitial = 300.0\nfixed = [ { where = { ids = [1, 2, 3, 4, 5, 6] }, value = 300.0 } ]\n";
  return write_spheres(folder, "t_end = 20.0\noutput_times = [0.5, 2.0, 8.0, 20.0]\n",
                       std::vector<double>(12, 1e-3), necks, 6, rest);
}

TEST(HiddenChange, APotentialIsNotSettledBeforeItsHeatIs) {
  constexpr double right = 300.22457, span = 0.225;  // K, at node 12: by SciPy's LSODA and Radau
  const test::CaseFolder folder;
  for (const double volts : {24.0, 230.0, 1e5}) {
    const Scene scene = load_scene(write_two_bodies(folder, volts));
    for (const char* method :
         {"auto", "exponential", "exprb", "rkc", "rkl", "rock", "trapezoidal", "esdirk", "cvode"})
      for (const double rtol : {1e-3, 1e-4}) {
        const auto values = temperatures(scene, fmt::format("{}:rtol={}", method, rtol));
        EXPECT_NEAR(values[11], right, 2 * rtol * span + 1e-5) << method << ' ' << rtol << ' ' << volts;
      }
  }
}

/// Node 1 radiates and touches two held ones, of which one repeats; the conductivity bends by factors of ten.
std::string write_bends(const test::CaseFolder& folder) {
  return write_spheres(
      folder, "t_end = 2.11118461662948\noutput_times = [0.8576713228381159, 2.11118461662948]\n",
      {0.0007072564067506414, 0.0007856773594417765, 0.0007446398136362124},
      "1,2,3.0536515333679186e-05\n2,3,0.0001394932595988495\n1,3,3.1192740854368286e-05\n", 0,
      "conductance = \"pipe\"\n[[materials]]\nname = \"m0\"\ndensity = 5000.0\nthermal = { conductivity = { "
      "law = "
      "\"table\", temperatures = [427.34838933835715, 509.2853079621799, 547.922285732505, "
      "610.7958558994079, "
      "639.14591922664, 712.5912077582927], values = [29.871136450959437, 8.86706334578895, "
      "143.00586760281206, "
      "185.03173779249616, 27.32167725736069, 74.00144019436249], outside = \"clamp\" }, specific_heat = "
      "500.0 }\n"
      "[thermal]\ninitial = 300.0\nfixed = [ { where = { ids = [3] }, value = { times = [0.0, "
      "0.422236923325896], "
      "values = [658.4365769610201, 317.02345373896475], period = 0.7037282055431601 } }, { where = { ids = "
      "[2] }, "
      "value = 441.1777257758607 } ]\nradiation = [ { where = { ids = [1, 2, 3] }, emissivity = "
      "0.8180321145226205, "
      "ambient = 466.0717950799824 } ]\n");
}

TEST(HiddenChange, BendsOfATableAreSeen) {
  const test::CaseFolder folder;
  const Scene scene = load_scene(write_bends(folder));
  const double right = temperatures(scene, "cvode:rtol=1e-9")[0];
  constexpr double span = 358.4;  // K: 658.4 - 300
  for (const char* method : {"auto", "exprb", "rkc", "cvode"})
    for (const double rtol : {1e-4, 1e-5})
      EXPECT_NEAR(temperatures(scene, fmt::format("{}:rtol={}", method, rtol))[0], right, 3 * rtol * span)
          << method << ' ' << rtol;
}

/// Node 1 follows its surroundings by radiation, slowly, while a held neighbour wanders.
TEST(HiddenChange, OneCorrectionWithAnOldMatrixIsNoSolution) {
  const test::CaseFolder folder;
  const Scene scene = load_scene(write_spheres(
      folder,
      "t_end = 10.118994351448384\noutput_times = [8.230691208255985, 8.865586704762592, "
      "8.926687486501807, 10.118994351448384]\n",
      {0.0006797081272237172, 0.0009812904975033672}, "1,2,0.0005219410573393701\n", 0,
      "conductance = \"pipe\"\n[[materials]]\nname = \"m0\"\ndensity = 5000.0\nthermal = { conductivity = "
      "4.977703057715661, specific_heat = 500.0 }\n[thermal]\ninitial = 300.0\nfixed = [ { where = { ids = "
      "[2] }, value "
      "= { times = [0.0, 0.0, 5.059497175724192, 10.118994351448384, 10.118994351448384], values = "
      "[300.9411332551355, 300.8043004601289, 300.0402124080536, 300.6233955272623, 300.0564117096763] } } "
      "]\nradiation "
      "= [ { where = { ids = [1] }, emissivity = 0.5336988666629869, ambient = { times = [0.0, 0.0, "
      "5.059497175724192, 10.118994351448384, 10.118994351448384], values = [300.6407445107448, "
      "300.8900258913666, "
      "300.9183830513806, 300.6023753952001, 300.5327541332076] } } ]\n"));
  const double right = temperatures(scene, "cvode:rtol=1e-9")[0];
  constexpr double span = 0.94;  // K
  for (const char* spec : {"arkode:rtol=1e-6", "arkode:rtol=1e-7", "cvode:rtol=1e-6"})
    EXPECT_NEAR(temperatures(scene, spec)[0], right, 5e-6 * span) << spec;
}

/// The heat is that of a potential that a source has yet to raise: at the start nothing seems to become warm.
TEST(HiddenChange, AHeatStillToComeIsInTheSpan) {
  const test::CaseFolder folder;
  const char* material =
      "[[materials]]\nname = \"{}\"\ndensity = 5000.0\nthermal = {{ conductivity = {}, specific_heat = {} "
      "}}\n"
      "electric = {{ conductivity = {}, specific_capacity = {} }}\n";
  const std::string rest = "conductance = \"pipe\"\n" +
                           fmt::format(fmt::runtime(material), "m0", 7.5, 1300.0, 4.4e4, 180.0) +
                           fmt::format(fmt::runtime(material), "m1", 5.55, 880.0, 2.36e4, 6660.0) +
                           "[electric]\nmode = \"transient\"\ninitial = 0.0\nfixed = [ { where = { ids = [1] "
                           "}, value = 0.0 }, { where = { "
                           "ids = [7] }, value = 0.0015 }, { where = { ids = [12] }, value = 0.0 } ]\nsource "
                           "= [ { where = { ids = [6] }, "
                           "value = 13.0 } ]\n[thermal]\ninitial = 300.0\nfixed = [ { where = { ids = [7, 8, "
                           "9, 10, 11, 12] }, value = "
                           "300.0 } ]\nconvection = [ { where = { ids = [1, 2, 3, 4, 5, 6] }, coefficient = "
                           "1.65, ambient = 300.0 } ]\n";
  const Scene scene = load_scene(write_spheres(folder, "t_end = 1.62\n",
                                               {1.93e-4, 2.35e-4, 2.24e-4, 2.21e-4, 2.47e-4, 2.14e-4, 4.11e-4,
                                                4.01e-4, 5.70e-4, 3.85e-4, 4.83e-4, 4.62e-4},
                                               "1,2,3.37e-5\n2,3,8.66e-5\n3,4,2.22e-5\n4,5,2.79e-5\n5,6,4."
                                               "38e-5\n7,8,5.67e-5\n8,9,4.16e-5\n9,10,5.18e-5\n"
                                               "8,11,7.23e-5\n11,12,3.95e-5\n6,7,7.28e-8\n",
                                               6, rest));
  const auto values = temperatures(scene, "exponential:rtol=1e-8");
  const double rise = *std::max_element(values.begin(), values.end()) - 300;
  const auto spans = scene_spans(scene).spans;
  EXPECT_GT(spans.back(), 0.9 * rise);
  EXPECT_LT(spans.back(), 1.5 * rise);
  const auto others = temperatures(scene, "auto:rtol=1e-4");
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(others[k], values[k], 2e-4 * rise) << k;
}

/// A source feeds a body of a hundredth of the other's potential, whose heat alone moves a temperature.
TEST(HiddenChange, ALowPotentialHeatsAsItShouldBesideAHighOne) {
  const test::CaseFolder folder;
  const char* material =
      "[[materials]]\nname = \"{}\"\ndensity = 5000.0\nthermal = {{ conductivity = {}, specific_heat = {} "
      "}}\n"
      "electric = {{ conductivity = {}, specific_capacity = {} }}\n";
  const Scene scene = load_scene(write_spheres(
      folder, "t_end = 0.428\n", {6.21e-4, 4.72e-4, 5.61e-4, 1.05e-4, 9.27e-5},
      "1,2,1.62e-4\n2,3,8.51e-5\n4,5,4.13e-5\n", 2,
      "conductance = \"pipe\"\n" + fmt::format(fmt::runtime(material), "m0", 12.3, 463.0, 1260.0, 1490.0) +
          fmt::format(fmt::runtime(material), "m1", 7.13, 544.0, 177.0, 5.94e5) +
          "[electric]\nmode = \"transient\"\ninitial = 0.0\nfixed = [ { where = { ids = [1, 4] }, value = "
          "0.0 } ]\n"
          "source = [ { where = { ids = [3] }, value = 1.26e-3 }, { where = { ids = [5] }, value = 6.94e-5 } "
          "]\n"
          "[thermal]\ninitial = 300.0\nfixed = [ { where = { ids = [1, 2, 3] }, value = 300.0 } "
          "]\nconvection = [ { "
          "where = { ids = [4, 5] }, coefficient = 4350.0, ambient = 300.0 } ]\n"));
  const auto right = temperatures(scene, "cvode:rtol=1e-9");
  const double span = *std::max_element(right.begin(), right.end()) - 300;
  for (const double rtol : {1e-3, 1e-4, 1e-5})
    for (const char* method : {"auto", "rkc", "exponential"}) {
      const auto values = temperatures(scene, fmt::format("{}:rtol={}", method, rtol));
      for (std::size_t k = 0; k < right.size(); ++k)
        EXPECT_NEAR(values[k], right[k], 3 * rtol * span) << method << ' ' << rtol << ' ' << k;
    }
}

/// Two hundred turns of a sawtooth, with a jump in each; the heat of all of them stays.
TEST(HiddenChange, ErrorsOfManyTurnsDoNotAddUp) {
  const test::CaseFolder folder;
  const Scene scene =
      load_scene(write_spheres(folder, "t_end = 1.0\n", {1e-3, 1e-3, 1e-3}, "1,2,3e-4\n2,3,3e-4\n", 0,
                               "conductance = \"series\"\n[[materials]]\nname = \"m0\"\ndensity = "
                               "5000.0\nthermal = { conductivity = 20.0, "
                               "specific_heat = 500.0 }\nelectric = { conductivity = 1e4, specific_capacity "
                               "= 3000.0 }\n[electric]\nmode = "
                               "\"transient\"\ninitial = 0.0\nfixed = [ { where = { ids = [1] }, value = { "
                               "times = [0.0, 0.003], values = "
                               "[-0.1, 0.1], period = 0.005 } }, { where = { ids = [3] }, value = 0.0 } "
                               "]\n[thermal]\ninitial = 300.0\n"));
  const double right = temperatures(scene, "exponential:rtol=1e-8")[0], rise = right - 300;
  for (const char* spec :
       {"auto", "trapezoidal:rtol=1e-4", "rkc:rtol=1e-4", "rkl:rtol=1e-4", "cvode:rtol=1e-4"})
    EXPECT_NEAR(temperatures(scene, spec)[0], right, 7e-4 * rise) << spec;
}

/// A held temperature comes down for seconds while conductivities follow it by smooth laws.
TEST(HiddenChange, ASlowPhaseBehindAStepIsNoEasyOne) {
  const test::CaseFolder folder;
  const Scene scene = load_scene(
      write_spheres(folder, "t_end = 26.2\noutput_times = [4.0, 6.7, 18.3, 26.2]\n",
                    {8.24e-4, 8.65e-4, 7.77e-4}, "1,2,7.22e-5\n1,3,6.20e-5\n2,3,4.20e-5\n", 0,
                    "conductance = \"series\"\n[[materials]]\nname = \"m0\"\ndensity = 5000.0\nthermal = { "
                    "conductivity = { law = "
                    "\"sigmoid\", value = 42.0, amplitude = 10.0, steepness = 0.0714, reference = 322.0 }, "
                    "specific_heat = 500.0 "
                    "}\nelectric = { conductivity = { law = \"sigmoid\", value = 2.16e4, amplitude = 2.0, "
                    "steepness = 0.0143, "
                    "reference = 315.6 }, specific_capacity = 4.46e4 }\n[electric]\nmode = "
                    "\"transient\"\ninitial = -0.0115\nfixed "
                    "= [ { where = { ids = [1] }, value = -0.0385 }, { where = { ids = [2] }, value = { "
                    "times = [0.0, 0.0, 13.1, "
                    "26.2], values = [0.0064, 0.0435, 0.0434, 0.0134] } } ]\n[thermal]\ninitial = "
                    "300.0\nfixed = [ { where = { ids "
                    "= [3] }, value = { times = [0.0, 3.66, 3.66, 26.2], values = [308.8, 345.7, 343.5, "
                    "315.6] } } ]\nconvection "
                    "= [ { where = { ids = [1, 2, 3] }, coefficient = 108.5, ambient = 312.4 } ]\n"));
  const auto right = temperatures(scene, "cvode:rtol=1e-9");
  constexpr double span = 45.7;  // K: 345.7 - 300
  for (const char* method : {"auto", "exprb", "rkc"})
    for (const double rtol : {1e-4, 1e-5})
      EXPECT_NEAR(temperatures(scene, fmt::format("{}:rtol={}", method, rtol))[1], right[1], 3 * rtol * span)
          << method << ' ' << rtol;
}

}  // namespace
}  // namespace superstep
