/// What a benchmark makes of a case that leaves things open.

#include "bench/app/loaded_case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "bench/harness/harness.hpp"
#include "core/error.hpp"
#include "integrators/registry.hpp"
#include "support/small_press.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;
using test::message_of;
using test::Rod;

/// A row of spheres that overlap by 5 %, radius in the unit of the file.
std::string row_of_spheres(const CaseFolder& folder, const std::string& unit, double radius,
                           const std::string& first_line = "") {
  std::string packing = first_line + "id,x,y,z,radius\n";
  for (int k = 0; k < 8; ++k) packing += fmt::format("{},0,0,{},{}\n", k, 1.9 * radius * k, radius);
  folder.write("row.csv", packing);
  folder.write(
      "case.toml",
      fmt::format("t_end = 1e-3\n[packing]\nfile = \"row.csv\"\n{}[material]\ndensity = 5910.0\n"
                  "[contact]\nneck = \"geometric\"\n[thermal]\nconductivity = 85.0\nspecific_heat = 640.0\n"
                  "initial = 300.0\nfixed = [ {{ where = \"top\", value = 310.0 }} ]\n",
                  unit.empty() ? "" : fmt::format("length_unit = \"{}\"\n", unit)));
  return folder.file("case.toml");
}

TEST(BenchCase, WithoutIntegratorsEveryFamilyIsMeasuredAgainstEulerAtItsTrueLimit) {
  const CaseFolder folder;
  Rod rod;
  rod.bench = "";
  const Scene scene = load_scene(write_rod(folder, rod));
  const auto specs = contenders(scene.bench, {});
  EXPECT_EQ(scene.bench.baseline, "forward-euler:fraction=1,bound=lanczos");
  for (const auto& entry : integrators())
    EXPECT_TRUE(std::any_of(specs.begin(), specs.end(), [&](const auto& spec) {
      return parse_spec(spec).name == entry.name;
    })) << entry.name;
  EXPECT_EQ(contenders(scene.bench, {"rkc"}).size(), 2U) << "what is asked for, and the baseline";
}

TEST(BenchCase, WithoutOutputTimesErrorsAreJudgedThroughTheTransient) {
  const CaseFolder folder;
  Rod open, stated;
  open.head = "t_end = 100\n";
  stated.head = "t_end = 100\noutput_times = [100]\n";
  EXPECT_EQ(load_bench_case(write_rod(folder, open)).head().output_times, (std::vector<double>{2, 10, 100}));
  EXPECT_EQ(load_bench_case(write_rod(folder, stated)).head().output_times, (std::vector<double>{100}));
  EXPECT_EQ(load_checked_case(write_rod(folder, open)).head().output_times, (std::vector<double>{100}))
      << "a run";
}

TEST(LoadedCase, IsWhatItsFileSaysAndCommandsThatNeedAFixedNetworkSaySo) {
  const CaseFolder folder;
  const LoadedCase rod = load_checked_case(write_rod(folder, Rod{}));
  const LoadedCase press = load_bench_case(test::small_press(folder));
  ASSERT_TRUE(std::holds_alternative<Scene>(rod.content));
  ASSERT_TRUE(std::holds_alternative<Press>(press.content));
  EXPECT_EQ(&scene_of(rod.content, "stability"), &std::get<Scene>(rod.content));
  EXPECT_EQ(press.head().title, "small press");
  EXPECT_EQ(press.head().output_times, (std::vector<double>{0.02, 0.04})) << "those of the case";
  const auto said = message_of<InputError>([&] { (void)scene_of(press.content, "stability"); });
  EXPECT_NE(said.find("press.toml: its particles move"), std::string::npos) << said;
  EXPECT_NE(said.find("stability needs"), std::string::npos) << said;
}

TEST(LoadedCase, SpecsOfAPressAreTheFilesFaultAtTheirLine) {
  const CaseFolder folder;
  const std::string text = folder.read(std::filesystem::path(test::small_press(folder)).filename().string());
  for (const auto& [from, to, key] :
       {std::tuple{"\"rkc:rtol=1e-5\"", "\"rkq\"", "bench.integrators"},
        std::tuple{"[bench]\n", "[bench]\nbaseline = \"rkq\"\n", "bench.baseline"},
        std::tuple{"[dynamics]\n", "[dynamics]\nthermal_integrator = \"rkq\"\n",
                   "dynamics.thermal_integrator"}}) {
    std::string wrong = text;
    wrong.replace(wrong.find(from), std::string(from).size(), to);
    const std::string file = folder.write("wrong.toml", wrong);
    const auto line =
        1 + std::count(wrong.begin(), wrong.begin() + static_cast<long>(wrong.find("rkq")), '\n');
    const auto said = message_of<InputError>([&] { (void)load_checked_case(file); });
    EXPECT_EQ(said,
              fmt::format("{}:{}: key '{}': unknown integrator 'rkq'; did you mean 'rkc'?", file, line, key));
  }
}

TEST(BenchCase, SizesThatMustBeASlipAreRefusedWithTheLikelyUnit) {
  const CaseFolder folder;
  // Written in metres, read as micrometres.
  const auto said =
      message_of<InputError>([&] { (void)load_bench_case(row_of_spheres(folder, "um", 5e-6)); });
  EXPECT_NE(said.find("1e-11 m"), std::string::npos) << said;
  EXPECT_NE(said.find("length_unit = \"m\" would make it 1e-05 m"), std::string::npos) << said;
  EXPECT_NO_THROW((void)load_bench_case(row_of_spheres(folder, "um", 5)));
  EXPECT_NO_THROW((void)load_checked_case(row_of_spheres(folder, "um", 5e-6)))
      << "a run may be what it likes";
}

TEST(BenchCase, APackingThatStatesItsUnitIsReadInItAndMayNotBeContradicted) {
  const CaseFolder folder;
  const std::string states = "# made by hand\n# length_unit = \"um\"\n";
  for (const char* unit : {"", "um"}) {
    const Scene scene = load_scene(row_of_spheres(folder, unit, 5, states));
    EXPECT_DOUBLE_EQ(scene.packed->packing.radius[0], 5e-6);
  }
  const auto said =
      message_of<InputError>([&] { (void)load_scene(row_of_spheres(folder, "mm", 5, states)); });
  EXPECT_NE(said.find("states that its lengths are in um"), std::string::npos) << said;
  const auto unknown = message_of<InputError>(
      [&] { (void)load_scene(row_of_spheres(folder, "", 5, "# length_unit = \"furlong\"\n")); });
  EXPECT_NE(unknown.find("row.csv:1: length unit is 'furlong'"), std::string::npos) << unknown;
}

}  // namespace
}  // namespace superstep
