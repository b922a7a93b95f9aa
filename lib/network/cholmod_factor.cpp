#include "network/cholmod_factor.hpp"

#include <cholmod.h>
#include <sys/mman.h>

#include <algorithm>
#include <mutex>
#include <new>

#include "core/error.hpp"
#include "core/shared_library.hpp"

namespace superstep {
namespace {

static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));

/// Operations an entry of the factor from which its blocks are worth their calls; the package says 40.
/// Lattices of 650 unknowns were factorized six times as fast without, of 9680 just as fast with (1 thread).
constexpr double supernodes_pay = 200;

/// OpenBLAS takes a buffer at its first call and keeps it; where there is no room it tries again for ever. So
/// it is called once while there is room.
void let_blas_take_its_buffer() {
  static std::mutex one_by_one;
  static bool taken = false;
  const std::lock_guard lock(one_by_one);
  if (taken) return;
  constexpr std::size_t largest_buffer = std::size_t{128} << 20;
  void* const room =
      ::mmap(nullptr, largest_buffer, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  ::munmap(room, largest_buffer);
  using Cholesky =
      void(const char* triangle, const int* n, double* a, const int* lda, int* info, std::size_t);
  if (auto* const factorize = loaded_function<Cholesky>("dpotrf_")) {
    const int n = 1;
    int info = 0;
    double a = 1;
    factorize("U", &n, &a, &n, &info, 1);
  }
  taken = true;
}

}  // namespace

struct CholmodFactor::Handles {
  Handles() {
    cholmod_l_start(&common);
    common.print = 0;
    common.supernodal_switch = supernodes_pay;
  }
  ~Handles() {
    cholmod_l_free_dense(&solution, &common);
    cholmod_l_free_dense(&work, &common);
    cholmod_l_free_dense(&sparse_work, &common);
    cholmod_l_free_factor(&factor, &common);
    cholmod_l_free_sparse(&matrix, &common);
    cholmod_l_finish(&common);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  cholmod_common common{};
  cholmod_sparse* matrix = nullptr;
  cholmod_factor* factor = nullptr;
  cholmod_dense *solution = nullptr, *work = nullptr, *sparse_work = nullptr;  // kept from solve to solve
  std::size_t fill = 0;
};

CholmodFactor::CholmodFactor(std::span<const std::int64_t> column_begin, std::span<const std::int64_t> row)
    : handles_(std::make_unique<Handles>()) {
  constexpr int sorted = 1, packed = 1, upper = 1;
  auto& [common, matrix, factor, solution, work, sparse_work, fill] = *handles_;
  const std::size_t n = column_begin.size() - 1;
  matrix = cholmod_l_allocate_sparse(n, n, row.size(), sorted, packed, upper, CHOLMOD_REAL, &common);
  if (!matrix) throw NumericalError("out of memory for a symmetric matrix");
  std::copy(column_begin.begin(), column_begin.end(), static_cast<SuiteSparse_long*>(matrix->p));
  std::copy(row.begin(), row.end(), static_cast<SuiteSparse_long*>(matrix->i));
  std::fill_n(static_cast<double*>(matrix->x), row.size(), 0.0);
  factor = cholmod_l_analyze(matrix, &common);
  if (!factor) throw NumericalError("out of memory for the analysis of a symmetric matrix");
}

CholmodFactor::~CholmodFactor() = default;

std::span<double> CholmodFactor::values() noexcept {
  return {static_cast<double*>(handles_->matrix->x), handles_->matrix->nzmax};
}

bool CholmodFactor::factorize() {
  if (handles_->factor->is_super) let_blas_take_its_buffer();
  auto& common = handles_->common;
  cholmod_l_factorize(handles_->matrix, handles_->factor, &common);
  handles_->fill = static_cast<std::size_t>(common.lnz);
  if (common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  return common.status == CHOLMOD_OK;
}

bool CholmodFactor::solve(std::span<const double> b, std::span<double> x) {
  auto& handles = *handles_;
  if (!handles.solution)
    handles.solution = cholmod_l_allocate_dense(b.size(), 1, b.size(), CHOLMOD_REAL, &handles.common);
  if (!handles.solution) return false;
  // By way of x, because CHOLMOD's interface does not promise to leave a right-hand side alone.
  if (b.data() != x.data()) std::copy(b.begin(), b.end(), x.begin());
  cholmod_dense right{};
  right.nrow = right.d = right.nzmax = x.size();
  right.ncol = 1;
  right.x = x.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  const int ok = cholmod_l_solve2(CHOLMOD_A, handles.factor, &right, nullptr, &handles.solution, nullptr,
                                  &handles.work, &handles.sparse_work, &handles.common);
  if (!ok) return false;
  std::copy_n(static_cast<const double*>(handles.solution->x), x.size(), x.begin());
  return true;
}

std::size_t CholmodFactor::fill() const noexcept {
  return handles_->fill;
}

std::string CholmodFactor::method() const {
  const auto& factor = *handles_->factor;
  std::string out = factor.is_super ? "supernodal" : "simplicial";
  if (factor.ordering == CHOLMOD_AMD) return out + ", amd";
  return factor.ordering == CHOLMOD_METIS ? out + ", metis" : out + ", natural order";
}

}  // namespace superstep
