#include "integrators/detail/petsc/multigrid.hpp"

#include <petscksp.h>

#include <string>
#include <utility>

#include "integrators/detail/petsc/package.hpp"

namespace superstep::petsc {
namespace {

constexpr const char* prefix = "superstep_";  // of options that are meant for nobody else

/// The package sets these by text alone. One cycle, for matrices with positive diagonals and negative
/// neighbours in three dimensions. Its smoother is symmetric, as conjugate gradients want it; grids are
/// coarse, for most of the time goes into making them anew after every change of the step size.
void set_multigrid_options(const std::string& whose) {
  constexpr std::pair<const char*, const char*> choices[] = {{"strong_threshold", "0.5"},
                                                             {"coarsen_type", "PMIS"},
                                                             {"agg_nl", "1"},
                                                             {"interp_type", "ext+i"},
                                                             {"P_max", "4"},
                                                             {"relax_type_all", "symmetric-SOR/Jacobi"},
                                                             {"relax_type_coarse", "Gaussian-elimination"},
                                                             {"max_iter", "1"},
                                                             {"tol", "0"}};
  for (const auto& [name, value] : choices)
    check(PetscOptionsSetValue(nullptr, ("-" + whose + "pc_hypre_boomeramg_" + name).c_str(), value),
          "an option");
}

}  // namespace

void choose_multigrid(PC pc, std::span<const std::int32_t> field_end) {
  check(PCSetOptionsPrefix(pc, prefix), "PCSetOptionsPrefix");
  if (field_end.size() == 1) {
    set_multigrid_options(prefix);
    check(PCSetType(pc, PCHYPRE), "PCSetType");
    check(PCHYPRESetType(pc, "boomeramg"), "PCHYPRESetType");
    check(PCSetFromOptions(pc), "PCSetFromOptions");
    return;
  }
  check(PCSetType(pc, PCFIELDSPLIT), "PCSetType");
  check(PCFieldSplitSetType(pc, PC_COMPOSITE_MULTIPLICATIVE), "PCFieldSplitSetType");
  std::int32_t begin = 0;
  for (std::size_t field = 0; field < field_end.size(); ++field) {
    const std::string name = std::to_string(field), whose = std::string(prefix) + "fieldsplit_" + name + "_";
    for (const auto& [option, value] :
         {std::pair{"ksp_type", "preonly"}, {"pc_type", "hypre"}, {"pc_hypre_type", "boomeramg"}})
      check(PetscOptionsSetValue(nullptr, ("-" + whose + option).c_str(), value), "an option");
    set_multigrid_options(whose);
    Owned<IS, ISDestroy> entries;
    check(ISCreateStride(PETSC_COMM_SELF, field_end[field] - begin, begin, 1, entries.fill()),
          "ISCreateStride");
    check(PCFieldSplitSetIS(pc, name.c_str(), entries), "PCFieldSplitSetIS");
    begin = field_end[field];
  }
}

}  // namespace superstep::petsc
