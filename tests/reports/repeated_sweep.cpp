/// A program that does every fiftieth sweep twice: 2 % more work of the kind that matters, with the same
/// results and the same counters. Linked with --wrap, so that no code of the program knows of it; what gates
/// say about it is measured by reports/gate/rates.sh.

#include <vector>

#include "rhs/kernels/sweep.hpp"

using superstep::SlicedRows;
using superstep::Stage;

extern "C" void __real__ZN9superstep11fused_sweepERKNS_10SlicedRowsERKNS_5StageEmmPd(
    const SlicedRows& rate, const Stage& stage, std::size_t first, std::size_t last, double* out);

extern "C" void __wrap__ZN9superstep11fused_sweepERKNS_10SlicedRowsERKNS_5StageEmmPd(
    const SlicedRows& rate, const Stage& stage, std::size_t first, std::size_t last, double* out) {
  constexpr int every = 50;
  static int count = 0;
  static std::vector<double> elsewhere;  // a stage may be written over what it is made of
  if (++count % every == 0) {
    elsewhere.resize(rate.rows());
    __real__ZN9superstep11fused_sweepERKNS_10SlicedRowsERKNS_5StageEmmPd(rate, stage, first, last,
                                                                         elsewhere.data());
  }
  __real__ZN9superstep11fused_sweepERKNS_10SlicedRowsERKNS_5StageEmmPd(rate, stage, first, last, out);
}
