#pragma once
/// What explicit methods ask a right-hand side for: stages, one by one or several in a row.

#include <cstddef>

namespace superstep {

/// One stage of a three-term method, done in a single pass over the network:
///   out = a*y1 + b*y2 + c*y0 + d*f(t, y1) + e*f0
/// Terms with a null vector do not exist. `out` may be y2 but not y1.
struct Stage {
  const double* y1 = nullptr;
  double a = 1, d = 0;
  const double* y2 = nullptr;
  double b = 0;
  const double* y0 = nullptr;
  double c = 0;
  const double* f0 = nullptr;
  double e = 0;
};

/// A stage that starts from the result of the one before: its y1 is that one's out. `out` may be a vector
/// that only earlier stages read, even the y1 of the one before.
struct ChainedStage {
  double t = 0;  ///< s
  Stage stage;
  double* out = nullptr;  ///< [n]
  double inflow = 0;      ///< set to inflow(t, stage.y1) where asked for
};

/// Stages that methods put into one chain at most; bounds what runs between two looks at a run.
constexpr std::size_t longest_chain = 32;

/// Looks at entries of a chain as they become final, before later stages write over them.
class ChainObserver {
 public:
  /// Entries [first, last) of the result of stage number `stage` are there, and those of its y1 still. Called
  /// by several threads, each with entries of its own; for one entry in the order of the stages.
  virtual void entries_done(std::size_t stage, std::size_t first, std::size_t last) = 0;

 protected:
  ~ChainObserver() = default;
};

}  // namespace superstep
