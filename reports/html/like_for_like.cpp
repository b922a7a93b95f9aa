#include "reports/html/like_for_like.hpp"

namespace superstep {

Number substeps(const BenchRow& row) {
  if (!row.steps || !row.max_stages) return std::nullopt;
  return static_cast<double>(*row.steps) * static_cast<double>(*row.max_stages);
}

LikeForLike like_for_like(const BenchRow& euler, const BenchRow& sts, double cpu_joule) {
  const Number euler_substeps = substeps(euler), sts_substeps = substeps(sts);
  if (!euler_substeps || !sts_substeps || !euler.cpu_stepping || !sts.cpu_stepping) return {};
  const double evaluations = static_cast<double>(*sts.steps);
  const double euler_cpu = euler.cpu_stepping->median, sts_cpu = sts.cpu_stepping->median;
  const double dearer = sts_cpu + (*sts_substeps - evaluations) * cpu_joule;
  const double cheaper = euler_cpu - (*euler_substeps - evaluations) * cpu_joule;
  LikeForLike out;
  if (dearer > 0) out.every_substep = euler_cpu / dearer;
  if (sts_cpu > 0 && cheaper > 0) out.every_superstep = cheaper / sts_cpu;
  return out;
}

}  // namespace superstep
