#pragma once
/// hypre's algebraic multigrid (BoomerAMG) as PETSc hands it on.
/// Source: Henson, Yang (2002), BoomerAMG: a parallel algebraic multigrid solver and preconditioner, Applied
/// Numerical Mathematics 41, 155-177.

#include <petscpc.h>

#include <cstdint>
#include <span>

namespace superstep::petsc {

/// Makes `pc` one cycle of it, symmetric where the matrix is. Throws std::runtime_error.
///
///   field_end  [fields] where the entries of each field end. Fields that act on each other are swept one
///              after the other, each by its own grids: how strongly entries of different units are coupled
///              says nothing.
void choose_multigrid(PC pc, std::span<const std::int32_t> field_end);

}  // namespace superstep::petsc
