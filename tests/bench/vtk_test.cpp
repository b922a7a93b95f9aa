/// `superstep run --vtk`, read back by VTK itself.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "bench/app/commands.hpp"
#include "bench/output/vtk_poly_data.hpp"
#include "bench/output/vtk_series.hpp"
#include "core/error.hpp"
#include "support/small_press.hpp"
#include "support/temporary_case.hpp"

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

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
  return count;
}

/// Cells of a row of a CSV file without quotes.
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out(1);
  for (const char c : line) {
    if (c == ',')
      out.emplace_back();
    else
      out.back().push_back(c);
  }
  return out;
}

// Counts per instant against history.csv: contacts come and go while particles move.
TEST(Vtk, MovingParticlesHaveTheirOwnContactsAtEachInstant) {
  const CaseFolder folder;
  RunCommand command;
  command.case_file = test::small_press(folder);
  command.out = folder.file("out");
  command.vtk = true;
  command.common.quiet = true;
  testing::internal::CaptureStdout();
  const int code = execute(command);
  testing::internal::GetCapturedStdout();
  ASSERT_EQ(code, 0);

  const std::string series = folder.read("out/vtk/contacts.pvd"), history = folder.read("out/history.csv");
  ASSERT_EQ(occurrences(series, "<DataSet "), 3U) << "the start and two output times";
  EXPECT_EQ(occurrences(folder.read("out/vtk/particles.pvd"), "<DataSet "), 3U);
  std::vector<std::string> lines_at;
  for (const std::string time : {"0", "0.02", "0.04"}) {
    const std::size_t k = lines_at.size();
    EXPECT_NE(series.find(fmt::format("timestep=\"{}\" part=\"0\" file=\"contacts_000{}.vtp\"", time, k)),
              std::string::npos);
    const std::size_t row = history.find("\n" + time + ",\"press, slowly\",");
    ASSERT_NE(row, std::string::npos);
    const std::size_t begin = history.find("slowly\",", row) + 8;
    const auto values = cells(history.substr(begin, history.find('\n', begin) - begin));
    lines_at.push_back(values.at(6));  // contacts
    const std::string contacts = folder.read(fmt::format("out/vtk/contacts_000{}.vtp", k));
    EXPECT_NE(contacts.find(fmt::format("NumberOfLines=\"{}\"", lines_at.back())), std::string::npos)
        << "t = " << time;
    const std::string particles = folder.read(fmt::format("out/vtk/particles_000{}.vtp", k));
    EXPECT_NE(particles.find("NumberOfPoints=\"30\" NumberOfVerts=\"30\""), std::string::npos);
    for (const char* name : {"id", "radius", "temperature", "current"})
      EXPECT_NE(particles.find(fmt::format("Name=\"{}\" NumberOfComponents=\"1\"", name)), std::string::npos);
    EXPECT_NE(particles.find("Name=\"velocity\" NumberOfComponents=\"3\""), std::string::npos);
  }
  EXPECT_NE(lines_at[1], lines_at[2]) << "the press makes new contacts";
  EXPECT_NE(folder.read("out/run.json").find("vtk/contacts.pvd"), std::string::npos);

  const int checked = exit_code_of(fmt::format("/usr/bin/python3 '{}/tests/bench/check_vtk.py' '{}'",
                                               SUPERSTEP_SOURCE_DIR, folder.file("out")));
  EXPECT_TRUE(checked == 0 || checked == 77) << "77: python3-vtk9 is not installed";

  command.vtk = false;
  testing::internal::CaptureStdout();
  (void)execute(command);
  testing::internal::GetCapturedStdout();
  EXPECT_FALSE(folder.has("out/vtk/contacts.pvd"))
      << "fields of an earlier run beside the numbers of this one";
}

TEST(Vtk, ANetworkWithoutPositionsIsRefused) {
  const CaseFolder folder;
  const Scene scene = load_scene(write_rod(folder, {}));
  EXPECT_NE(message_of<InputError>([&] { VtkSeries(scene, folder.file("out")); }).find("leave --vtk out"),
            std::string::npos);
  EXPECT_FALSE(folder.has("out"));
}

TEST(Vtk, OnlyItsOwnOldFilesAreRemoved) {
  const CaseFolder folder;
  std::filesystem::create_directories(folder.file("out/vtk"));
  for (const char* name : {"particles_0099.vtp", "contacts_0099.vtp", "mine.vtp", "particles.txt"})
    folder.write(std::string("out/vtk/") + name, "old");
  const Scene scene = load_scene(SUPERSTEP_SOURCE_DIR "/cases/lattice.toml");
  const VtkSeries series(scene, folder.file("out"));
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
