/// The report of moving particles: phases, curves and pictures as the files have them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "checked_report.hpp"
#include "core/error.hpp"
#include "results/read_motion.hpp"
#include "results/results_json.hpp"
#include "sample_report.hpp"

namespace superstep {
namespace {

using test::message_of;
using test::report_of;
using test::TemporaryFolder;
using Json = nlohmann::ordered_json;

constexpr const char* columns =
    "time,phase,volume_fraction,mean_temperature,max_temperature,wall_force,kinetic_energy,bonds,contacts,"
    "step,iterations,rejections";

bool has(const std::string& html, const std::string& part) {
  return html.find(part) != std::string::npos;
}

std::size_t count_after(const std::string& html, const std::string& mark, const std::string& part,
                        const std::string& end) {
  const std::size_t begin = html.find(mark), last = html.find(end, begin);
  std::size_t count = 0;
  for (std::size_t at = begin; (at = html.find(part, at)) < last; ++at) ++count;
  return count;
}

/// Four particles, two of them in the rear half; press for 2 s and release for 2 s.
struct Press {
  std::string press = "press, \"slowly\"";
  bool keeps_account = false, electric = false;
  RunRecord record = test::sample_run();
  Json motion = {{"box", {{"min", {0, 0, 0}}, {"max", {2, 4, 3}}}}, {"snapshots", Json::array()}};

  Press() {
    record.integrator = "staggered";
    record.params.clear();
    record.t_end = record.t_reached = 4;
    record.nodes = 4;
    for (const double t : {2.0, 4.0})
      motion["snapshots"].push_back(
          {{"file", fmt::format("snapshots/p{}.csv", t)}, {"time", t}, {"upper_wall", t}});
  }

  void write(const TemporaryFolder& folder, const std::string& below = "") const {
    std::filesystem::create_directories(folder.file(below + "snapshots"));
    Json json = Json::parse(run_json(record));
    json["motion"] = motion;
    folder.write(below + "run.json", json.dump());
    std::string quoted;
    for (const char c : press) quoted += c == '"' ? "\"\"" : std::string(1, c);
    const auto row = [&](const std::string& start, int joules) {
      return start + (keeps_account ? fmt::format(",{},{},{},{},{},{},{}\n", 9 * joules, joules, 2 * joules,
                                                  5 * joules, 7 * joules, 3 * joules, 100 + 4 * joules)
                                    : "\n");
    };
    folder.write(
        below + "history.csv",
        std::string(columns) +
            (keeps_account
                 ? ",wall_work,potential_energy,elastic_energy,dissipated,joule_heat,heat_lost,heat_content\n"
                 : "\n") +
            row(fmt::format("0,\"{}\",0.2,300,300,0,0,0,1,0,0,0", quoted), 0) +
            row(fmt::format("1,\"{}\",0.8,500,600,90,1,2,5,1,3,0", quoted), 1) +
            row(fmt::format("2,\"{}\",0.6,600,900,50,1,4,6,1,3,0", quoted), 2) +
            row("4,release,0.4,550,700,0,0,3,4,2,3,1", 3));
    for (const char* name : {"snapshots/p2.csv", "snapshots/p4.csv"}) {
      std::string text =
          electric ? "id,x,y,z,r,current,temperature,vx,vy,vz\n" : "id,x,y,z,r,temperature,vx,vy,vz\n";
      for (const int k : {1, 2, 3, 4})
        text +=
            fmt::format("{},1,{}.5,0.5,0.5,{}{},0,0,0\n", k, k - 1,
                        electric ? fmt::format("{},", 10 * k) : "", k < 3 ? 200 + 100 * k : 500 + 100 * k);
      folder.write(below + name, text);
    }
  }
};

TEST(SinteringReport, PhasesAreReadAsTheHistoryHasThem) {
  const TemporaryFolder folder;
  Press().write(folder);
  const auto motion = read_motion(folder.file("."));
  ASSERT_TRUE(motion);
  ASSERT_EQ(motion->phases.size(), 2U);
  const auto &press = motion->phases[0], &release = motion->phases[1];
  EXPECT_EQ(press.name, "press, \"slowly\"");
  EXPECT_EQ(press.begin, 0);
  EXPECT_EQ(press.end, 2);
  EXPECT_EQ(press.steps, 2U) << "the initial state is no step";
  EXPECT_EQ(press.volume_fraction, 0.6);
  EXPECT_EQ(press.wall_force, 50);
  EXPECT_EQ(press.largest_wall_force, 90);
  EXPECT_EQ(release.begin, 2);
  EXPECT_EQ(release.steps, 1U);
  EXPECT_EQ(release.bonds, 3);
  EXPECT_EQ(motion->largest_fraction, 0.8);
  EXPECT_EQ(motion->largest_fraction_at, 1);
  ASSERT_EQ(motion->frames.size(), 2U);
  ASSERT_EQ(motion->frames[0].spheres.size(), 2U) << "the front half is left out";
  EXPECT_EQ(motion->frames[0].spheres[0].id, 4) << "what lies behind is drawn first";
  EXPECT_EQ(motion->frames[0].spheres[1].temperature, 800);
}

TEST(SinteringReport, HoldsTableCurvesAndPictures) {
  const TemporaryFolder folder;
  Press press;
  press.press = test::hostile_name;
  press.write(folder);
  const std::string html = report_of(folder);
  for (const char* id : {"sintering-1-phases", "sintering-1-history", "sintering-1-pictures", "runs"}) {
    EXPECT_TRUE(has(html, fmt::format("<section id=\"{}\"", id))) << id;
    EXPECT_TRUE(has(html, fmt::format("href=\"#{}\"", id))) << id << " in the contents";
  }
  for (const char* id : {"fraction", "temperature", "force", "pairs"}) {
    const std::string figure = fmt::format("id=\"sintering-1-{}\"", id);
    EXPECT_TRUE(has(html, figure)) << id;
    EXPECT_EQ(count_after(html, figure, ">release</text>", "</svg>"), 1U) << "phases are marked: " << id;
  }
  EXPECT_TRUE(has(html, "<dd>50 %</dd>")) << "springback from 0.8 to 0.4";
  EXPECT_TRUE(has(html, "<dd>0.8 at 1 s</dd>"));
  EXPECT_EQ(count_after(html, "id=\"sintering-1-particles\"", "<circle", "</figure>"), 4U)
      << "two spheres at two instants";
  EXPECT_FALSE(has(html, "id=\"sintering-compared\"")) << "nothing to compare with";
  EXPECT_FALSE(has(html, "id=\"runs-packing-temperature\"")) << "no cut through a packing that moves";
}

TEST(SinteringReport, ShowsEnergiesAndCurrentsWhereTheRunHasThem) {
  const TemporaryFolder folder;
  Press press;
  press.write(folder);
  const std::string without = report_of(folder);
  for (const char* id : {"energy", "heat", "particles-electric"})
    EXPECT_FALSE(has(without, fmt::format("id=\"sintering-1-{}\"", id))) << id;
  press.keeps_account = press.electric = true;
  press.write(folder);
  const auto motion = read_motion(folder.file("."));
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->history.wall_work, (std::vector<double>{0, 9, 18, 27}));
  EXPECT_EQ(motion->history.heat_gained, (std::vector<double>{0, 4, 8, 12})) << "since the start";
  EXPECT_EQ(motion->electric, "current");
  EXPECT_EQ(motion->frames[0].spheres[0].electric, 40);
  const std::string with = report_of(folder);
  for (const char* id : {"energy", "heat", "particles-electric"})
    EXPECT_TRUE(has(with, fmt::format("id=\"sintering-1-{}\"", id))) << id;
  EXPECT_EQ(count_after(with, "id=\"sintering-1-particles-electric\"", "<circle", "</figure>"), 4U);
}

TEST(SinteringReport, OfAFailedRunSaysWhereItStopped) {
  const TemporaryFolder folder;
  Press press;
  press.record.status = "failed";
  press.record.reason = "the step of particle 7 collapsed <&>";
  press.record.t_reached = 0.5;
  press.write(folder);
  EXPECT_TRUE(has(report_of(folder), "failed at 0.5 s: the step of particle 7 collapsed &lt;&amp;&gt;"));
}

TEST(SinteringReport, OfSeveralRunsComparesThem) {
  const TemporaryFolder folder;
  Press().write(folder, "long/");
  Press().write(folder, "short/");
  const std::string html = report_of(folder);
  EXPECT_TRUE(has(html, "<section id=\"sintering-compared\""));
  EXPECT_TRUE(has(html, "id=\"sintering-compared-fraction\""));
  EXPECT_TRUE(has(html, "<section id=\"sintering-2-pictures\""));
  EXPECT_TRUE(has(html, "(long)</h2>"));
  EXPECT_TRUE(has(html, "(short)</h2>"));
}

TEST(SinteringReport, OfAFolderWithoutSnapshotsHasNoPictures) {
  const TemporaryFolder folder;
  Press press;
  press.motion = Json::object();  // as older programs wrote it
  press.write(folder);
  const std::string html = report_of(folder);
  EXPECT_TRUE(has(html, "id=\"sintering-1-history\""));
  EXPECT_FALSE(has(html, "id=\"sintering-1-pictures\""));
}

TEST(SinteringReport, ShowsTheLastSnapshotOfEachPhase) {
  const TemporaryFolder folder;
  Press press;
  press.motion["snapshots"] = Json::array();
  for (int k = 1; k <= 16; ++k)
    press.motion["snapshots"].push_back(
        {{"file", "snapshots/p2.csv"}, {"time", 0.25 * k}, {"upper_wall", 3}});
  press.write(folder);
  const auto motion = read_motion(folder.file("."));
  ASSERT_TRUE(motion);
  std::vector<double> times;
  for (const auto& frame : motion->frames) times.push_back(frame.time);
  // The first one and the ends of the phases at 2 s and 4 s; then, halving the longest gaps, 3, 1 and 1.5 s.
  EXPECT_EQ(times, (std::vector<double>{0.25, 1, 1.5, 2, 3, 4}));
}

TEST(SinteringReport, BrokenFilesAreRefused) {
  const TemporaryFolder folder;
  Press press;
  press.write(folder);
  folder.write("snapshots/p4.csv", "id,x\n1,2\n");
  EXPECT_NE(message_of<InputError>([&] { (void)read_motion(folder.file(".")); }).find("p4.csv"),
            std::string::npos);
  press.motion["snapshots"][1]["file"] = "../elsewhere.csv";
  press.write(folder);
  EXPECT_NE(message_of<InputError>([&] {
              (void)read_motion(folder.file("."));
            }).find("it must name a file inside the folder"),
            std::string::npos);
  press.motion["snapshots"] = {1};
  press.write(folder);
  EXPECT_NE(message_of<InputError>([&] {
              (void)read_motion(folder.file("."));
            }).find("key 'motion.snapshots[0]' is"),
            std::string::npos);
  folder.write("history.csv", columns);
  EXPECT_NE(message_of<InputError>([&] { (void)read_motion(folder.file(".")); }).find("has no rows"),
            std::string::npos);
}

}  // namespace
}  // namespace superstep
