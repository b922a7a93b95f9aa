#include "rhs/kernels/skewed_passes.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <vector>

namespace superstep {
namespace {

/// Two buffers that passes write in turn, as rows see them: which pass wrote the value there, 0 = the start.
class TwoBuffers {
 public:
  TwoBuffers(std::size_t rows, std::size_t reach) : reach_(reach), written_{Rows(rows), Rows(rows)} {
    for (auto& rows_of : written_)
      for (auto& pass : rows_of) pass = 0;
  }
  /// Pass number `pass` on one row: every neighbour within reach must hold the result of the pass before.
  void visit(std::size_t pass, std::size_t row) {
    auto& read = written_[pass % 2];
    const std::size_t last = std::min(row + reach_, read.size() - 1);
    for (std::size_t j = row > reach_ ? row - reach_ : 0; j <= last; ++j)
      if (read[j] != pass) ++wrong_;
    written_[1 - pass % 2][row] = pass + 1;
    ++visits_;
  }
  /// What a watcher may rely on: the result of the pass before, in rows of its block.
  void look(std::size_t pass, std::size_t row) {
    if (written_[pass % 2][row] != pass) ++wrong_;
  }
  [[nodiscard]] std::size_t wrong() const { return wrong_; }
  [[nodiscard]] std::size_t visits() const { return visits_; }

 private:
  using Rows = std::vector<std::atomic<std::size_t>>;
  std::size_t reach_;
  Rows written_[2];
  std::atomic<std::size_t> wrong_{0}, visits_{0};
};

struct Setting {
  std::size_t rows, reach, smallest_block, passes, threads;
};

void expect_order(const Setting& s) {
  SCOPED_TRACE(testing::Message() << "rows " << s.rows << " reach " << s.reach << " block "
                                  << s.smallest_block << " passes " << s.passes << " threads " << s.threads);
  TwoBuffers buffers(s.rows, s.reach);
  std::vector<std::size_t> watched(s.passes, 0);  // rows seen so far: must come in order
  skewed_passes(
      SkewedBlocks(s.rows, s.reach, s.smallest_block, s.threads), s.passes,
      [&](std::size_t pass, std::size_t first, std::size_t last) {
        for (std::size_t row = first; row < last; ++row) buffers.visit(pass, row);
      },
      [&](std::size_t pass, std::size_t first, std::size_t last) {
        EXPECT_EQ(first, watched[pass]);
        watched[pass] = last;
        for (std::size_t row = first; row < last; ++row) buffers.look(pass, row);
      });
  EXPECT_EQ(buffers.wrong(), 0U);
  EXPECT_EQ(buffers.visits(), s.rows * s.passes);
  EXPECT_EQ(watched, std::vector<std::size_t>(s.passes, s.rows));
}

TEST(SkewedPasses, EveryRowReadsTheResultOfThePassBefore) {
  for (const std::size_t rows : {1U, 7U, 64U, 301U})
    for (const std::size_t reach : {1U, 5U, 40U})
      for (const std::size_t block : {1U, 16U})
        for (const std::size_t passes : {1U, 2U, 3U, 8U})
          for (const std::size_t threads : {1U, 2U, 3U}) expect_order({rows, reach, block, passes, threads});
}

TEST(SkewedPasses, TheTestWouldSeeASkewThatIsTooSmall) {
  TwoBuffers buffers(100, 5);  // told of a reach of 5, passed over with one of 4
  skewed_passes(
      SkewedBlocks(100, 4, 1, 1), 3,
      [&](std::size_t pass, std::size_t first, std::size_t last) {
        for (std::size_t row = first; row < last; ++row) buffers.visit(pass, row);
      },
      [](std::size_t, std::size_t, std::size_t) {});
  EXPECT_GT(buffers.wrong(), 0U);
}

}  // namespace
}  // namespace superstep
