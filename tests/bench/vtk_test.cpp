/// `superstep run --vtk`, read back by VTK itself.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "bench/loaded_case.hpp"
#include "bench/vtk_series.hpp"
#include "core/error.hpp"
#include "reports/vtk_poly_data.hpp"
#include "temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;
using test::message_of;

int exit_code_of(const std::string& command) {
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): a shell is what users have
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Vtk, ItsOwnReaderFindsWhatFinalCsvHolds) {
  const CaseFolder folder;
  // The folder's name is the user's too.
  const std::string out = folder.file("</script> =cmd() \"ünï\"");
  ASSERT_EQ(exit_code_of(fmt::format("'{}' run '{}/cases/lattice.toml' --vtk --quiet --out '{}'",
                                     SUPERSTEP_PROGRAM, SUPERSTEP_SOURCE_DIR, out)),
            0);
  EXPECT_NE(folder.read("</script> =cmd() \"ünï\"/run.json").find("vtk/particles.pvd"), std::string::npos);
  const int code = exit_code_of(
      fmt::format("/usr/bin/python3 '{}/tests/bench/check_vtk.py' '{}'", SUPERSTEP_SOURCE_DIR, out));
  if (code == 77) GTEST_SKIP() << "python3-vtk9 is not installed";
  EXPECT_EQ(code, 0);
}

TEST(Vtk, ANetworkWithoutPositionsIsRefused) {
  const CaseFolder folder;
  const LoadedCase loaded = load_case(write_rod(folder, {}));
  EXPECT_NE(
      message_of<InputError>([&] { VtkSeries(loaded.scene, folder.file("out")); }).find("leave --vtk out"),
      std::string::npos);
  EXPECT_FALSE(folder.has("out"));
}

TEST(Vtk, OnlyItsOwnOldFilesAreRemoved) {
  const CaseFolder folder;
  std::filesystem::create_directories(folder.file("out/vtk"));
  for (const char* name : {"particles_0099.vtp", "contacts_0099.vtp", "mine.vtp", "particles.txt"})
    folder.write(std::string("out/vtk/") + name, "old");
  const LoadedCase loaded = load_case(SUPERSTEP_SOURCE_DIR "/cases/lattice.toml");
  const VtkSeries series(loaded.scene, folder.file("out"));
  EXPECT_FALSE(folder.has("out/vtk/particles_0099.vtp"));
  EXPECT_FALSE(folder.has("out/vtk/contacts_0099.vtp"));
  EXPECT_TRUE(folder.has("out/vtk/mine.vtp"));
  EXPECT_TRUE(folder.has("out/vtk/particles.txt"));
  EXPECT_TRUE(folder.has("out/vtk/particles_0000.vtp"));
  remove_vtk_series(folder.file("out"));
  EXPECT_FALSE(folder.has("out/vtk/particles_0000.vtp"));
  EXPECT_TRUE(folder.has("out/vtk/mine.vtp"));
}

TEST(Vtk, ArraysOfTheWrongLengthAreAMistakeOfOurs) {
  const std::vector<Vec3> points(3);
  const VtkPolyData data{.points = points,
                         .lines = {},
                         .point_data = {{"a", std::vector<double>{1, 2}}},
                         .cell_data = {},
                         .time = 0};
  EXPECT_THROW((void)vtp_text(data), std::logic_error);
}

}  // namespace
}  // namespace superstep
