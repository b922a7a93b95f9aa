/// What a table of presses amounts to, from rows whose answer is known.

#include "results/press/press_table.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

PressTableRow bed(std::uint64_t seed, double wall, double hold, double released) {
  PressTableRow row;
  row.case_name = "press";
  row.seed = seed;
  row.upper_wall = wall;
  row.hold = hold;
  row.status = "ok";
  row.poured = 0.6;
  row.pressed = 1.0;
  row.released = released;
  row.temperature_hold = 1200;
  row.temperature_end = 1150;
  row.bonds = 7;
  return row;
}

/// Two beds; springback falls with hold in both, and with densification in the first alone.
std::vector<PressTableRow> sample_rows() {
  return {bed(1, -0.4, 0.1, 0.90), bed(1, -0.4, 0.2, 0.92), bed(1, -0.5, 0.1, 0.94), bed(1, -0.5, 0.2, 0.96),
          bed(2, -0.4, 0.1, 0.92), bed(2, -0.4, 0.2, 0.94), bed(2, -0.5, 0.1, 0.88), bed(2, -0.5, 0.2, 0.93)};
}

TEST(PressTable, MeansAndSpreadsAreOverBeds) {
  const auto cells = press_table_cells(sample_rows());
  ASSERT_EQ(cells.size(), 4u);
  EXPECT_EQ(cells[0].upper_wall, -0.5);
  EXPECT_EQ(cells[0].hold, 0.1);
  EXPECT_EQ(cells[0].beds, 2u);
  EXPECT_NEAR(cells[0].springback, 0.09, 1e-15);
  EXPECT_NEAR(cells[0].spread, 0.03, 1e-15);
  EXPECT_NEAR(cells[0].points, 0.91 - 0.6, 1e-15);
  EXPECT_NEAR(cells[0].drop, (0.91 - 0.6) / 0.4, 1e-15);
  EXPECT_NEAR(cells[0].cooling, 50, 1e-10);
}

TEST(PressTable, TrendsAreThoseOfEachBed) {
  auto rows = sample_rows();
  EXPECT_EQ(trend_with_hold(rows).less, 4u);
  EXPECT_EQ(trend_with_hold(rows).pairs, 4u);
  EXPECT_EQ(trend_with_densification(rows).less, 2u);
  EXPECT_EQ(trend_with_densification(rows).pairs, 4u);
  for (auto& row : rows)
    if (row.seed == 2) row.case_name = "another";
  EXPECT_EQ(press_table_cells(rows).size(), 8u) << "beds of two cases are no means";
}

TEST(PressTable, WhatFailedHasNoPartInThem) {
  auto rows = sample_rows();
  rows[0].status = "failed";
  rows[0].reason = "it went wrong, \"really\"";
  rows[0].pressed.reset(), rows[0].released.reset();
  EXPECT_EQ(trend_with_hold(rows).pairs, 3u);
  const auto cells = press_table_cells(rows);
  EXPECT_EQ(cells[2].beds, 1u);
  EXPECT_NEAR(cells[2].springback, 0.08, 1e-15);
  EXPECT_EQ(cells[2].spread, 0);
}

TEST(PressTable, ReadsBackWhatItWrote) {
  const test::TemporaryFolder folder;
  auto rows = sample_rows();
  rows[3].status = "interrupted";
  rows[3].released.reset();
  const std::string file = folder.write("press_table.csv", press_table_csv(rows));
  const auto back = read_press_table_csv(file);
  EXPECT_EQ(press_table_csv(back), press_table_csv(rows));
  ASSERT_EQ(back.size(), rows.size());
  EXPECT_FALSE(back[3].springback());
  const auto json = nlohmann::json::parse(press_table_json(rows));
  EXPECT_EQ(json["schema"], "superstep.press_table");
  EXPECT_NEAR(json["rows"][1]["springback"], 0.08, 1e-15);
  EXPECT_TRUE(json["rows"][3]["springback"].is_null());
}

TEST(PressTable, RefusesAWholeRowWithoutItsNumbers) {
  const test::TemporaryFolder folder;
  auto rows = sample_rows();
  rows[2].released.reset();
  const std::string file = folder.write("press_table.csv", press_table_csv(rows));
  const std::string message = test::message_of<InputError>([&] { (void)read_press_table_csv(file); });
  EXPECT_NE(message.find("press_table.csv: row 3"), std::string::npos) << message;
}

}  // namespace
}  // namespace superstep
