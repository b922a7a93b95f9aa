/// What a corpus says, from rows whose answer is known.

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.hpp"
#include "core/median.hpp"
#include "results/corpus/corpus_csv.hpp"
#include "results/corpus/corpus_summary.hpp"
#include "results/corpus/corpus_tables.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

CorpusRow row(const std::string& scene, const std::string& integrator, const std::string& params,
              std::vector<double> samples, double error) {
  CorpusRow out;
  out.scene = scene;
  out.set = "quick";
  out.scene_class = "linear";
  out.kind = "lattice";
  out.unknowns = 1000;
  out.integrator = integrator;
  out.params = params;
  out.spec = integrator + (params.empty() ? "" : ":" + params);
  out.status = "ok";
  out.samples = std::move(samples);
  out.cpu = median_of(out.samples);
  out.error = error;
  out.memory = 1;
  out.reference_error = 1e-12;
  out.key = "k";
  return out;
}

/// rkc is twice as fast as rock at 1e-2 and does not reach 1e-4; sts ties with rock there.
std::vector<CorpusRow> sample_rows() {
  return {row("a", "rkc", "rtol=1e-2", {0.010, 0.011, 0.010}, 5e-3),
          row("a", "rock", "rtol=1e-2", {0.020, 0.021, 0.022}, 1e-3),
          row("a", "rock", "rtol=1e-4", {0.030, 0.031, 0.033}, 1e-5),
          row("a", "sts", "n=5,nu=0.1", {0.031, 0.030, 0.032}, 5e-5),
          row("a", "auto", "rtol=1e-2", {0.020, 0.020, 0.020}, 4e-3)};
}

TEST(CorpusCells, NameTheWinnerOnlyWhereItIsClear) {
  const auto rows = sample_rows();
  const auto scenes = scenes_of(rows);
  const auto cells = corpus_cells(scenes);
  ASSERT_EQ(cells.size(), corpus_levels().size());
  EXPECT_EQ(cells[0].winner(), "rkc");
  EXPECT_NEAR(cells[0].entrants[1].behind.estimate, 2.1, 1e-12);
  EXPECT_EQ(cells[1].winner(), "");  // rock and sts take turns
  EXPECT_EQ(cells[1].tied(), 2u);
  EXPECT_TRUE(cells[2].entrants.empty());
  for (const auto& cell : cells)
    for (const auto& entrant : cell.entrants) EXPECT_NE(entrant.row->integrator, "auto");
}

TEST(CorpusCells, AreNotJudgedBelowTheReference) {
  auto rows = sample_rows();
  for (auto& one : rows) one.reference_error = 1e-4;
  const auto scenes = scenes_of(rows);
  const auto cells = corpus_cells(scenes);
  EXPECT_TRUE(cells[0].judged);
  EXPECT_FALSE(cells[1].judged);
}

TEST(CorpusRegret, IsThatOfTheBestWithinTheTolerance) {
  const auto rows = sample_rows();
  const auto scenes = scenes_of(rows);
  const auto regrets = regrets_of(scenes);
  ASSERT_EQ(regrets.size(), 1u);
  EXPECT_EQ(regrets[0].best->integrator, "rkc");
  EXPECT_DOUBLE_EQ(regrets[0].ratio, 2.0);
  EXPECT_NEAR(regrets[0].delivered, 0.4, 1e-12);
  EXPECT_FALSE(regrets[0].within(1.3));
  EXPECT_TRUE(regrets[0].within(2));
  const auto sum = summarize(regrets);
  EXPECT_EQ(sum.close, 0u);
  EXPECT_EQ(sum.kept, 1u);
  EXPECT_TRUE(sum.never_beyond);
}

TEST(CorpusProfile, CountsWhatIsReached) {
  const auto rows = sample_rows();
  const auto scenes = scenes_of(rows);
  const auto profiles = corpus_profiles(corpus_cells(scenes));
  for (const auto& profile : profiles) {
    EXPECT_EQ(profile.cells, 2u);
    if (profile.integrator == "rkc") {
      EXPECT_DOUBLE_EQ(profile.within(1), 0.5);
      EXPECT_DOUBLE_EQ(profile.within(100), 0.5);
    }
    if (profile.integrator == "rock") {
      EXPECT_DOUBLE_EQ(profile.within(3), 1.0);
    }
  }
}

TEST(CorpusAgreement, TellsSameUntoldAndDifferentApart) {
  const auto rows = sample_rows();
  auto other = rows;
  for (auto& one : other)
    if (one.integrator == "rkc") one.cpu = 1.0, one.samples = {1.0, 1.0, 1.0};
  const auto a = scenes_of(rows), b = scenes_of(other);
  const auto same = agreement(corpus_cells(a), corpus_cells(a));
  EXPECT_EQ(same.cells, 2u);
  EXPECT_EQ(same.same, 1u);
  EXPECT_EQ(same.untold, 1u);
  const auto changed = agreement(corpus_cells(a), corpus_cells(b));
  EXPECT_EQ(changed.different, 1u);
}

TEST(CorpusCsv, ReadsBackWhatItWrote) {
  test::TemporaryFolder folder;
  auto rows = sample_rows();
  rows[1].status = "timeout";
  rows[1].reason = "not done after 1 s, \"really\"";
  rows[1].cpu.reset();
  rows[1].samples.clear();
  rows[1].error.reset();
  folder.write("corpus.csv", corpus_csv(rows));
  const auto back = read_corpus_csv(folder.file("corpus.csv"));
  EXPECT_EQ(corpus_csv(back), corpus_csv(rows));
  ASSERT_EQ(back.size(), rows.size());
  EXPECT_EQ(back[1].reason, rows[1].reason);
  EXPECT_EQ(back[0].samples, rows[0].samples);
  EXPECT_EQ(back[3].spec, "sts:n=5,nu=0.1");
}

TEST(CorpusCsv, NamesABrokenCell) {
  test::TemporaryFolder folder;
  std::string text = corpus_csv(sample_rows());
  text.replace(text.find("0.01 0.011 0.01"), 4, "oops");
  folder.write("corpus.csv", text);
  EXPECT_THROW((void)read_corpus_csv(folder.file("corpus.csv")), InputError);
}

TEST(CorpusCsv, RefusesWhatWasNeverMeasured) {
  test::TemporaryFolder folder;
  const auto refuses = [&](const auto& garble) {
    auto rows = sample_rows();
    garble(rows);
    const auto file = folder.write("corpus.csv", corpus_csv(rows));
    return !test::message_of<InputError>([&] { (void)read_corpus_csv(file); }).empty();
  };
  using Rows = std::vector<CorpusRow>;
  EXPECT_FALSE(refuses([](Rows&) {}));
  EXPECT_TRUE(refuses([](Rows& rows) { rows[0].cpu = -5; }));
  EXPECT_TRUE(refuses([](Rows& rows) { rows[0].error = -5; }));
  EXPECT_TRUE(refuses([](Rows& rows) { rows[0].status = "okay"; }));
  EXPECT_TRUE(refuses([](Rows& rows) { rows.push_back(rows[0]); })) << "a method twice on one scene";
}

TEST(CorpusTables, KeepWhatFailed) {
  auto rows = sample_rows();
  rows.push_back(rows[0]);
  rows.back().status = "failed";
  rows.back().reason = "it went wrong at t = 3";
  rows.back().cpu.reset();
  bool found = false;
  for (const auto& table : corpus_tables(rows))
    for (const auto& cells : table.rows)
      for (const auto& cell : cells) found = found || cell.text == "it went wrong at t = 3";
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace superstep
