#include "python/binding/one_blas_thread.hpp"

#include "core/shared_library.hpp"

namespace superstep::python {
namespace {

void set_threads(int threads) {
  if (auto* const set = loaded_function<void(int)>("openblas_set_num_threads")) (*set)(threads);
}

}  // namespace

OneBlasThread::OneBlasThread() {
  if (auto* const count = loaded_function<int()>("openblas_get_num_threads")) before_ = (*count)();
  if (before_ > 1) set_threads(1);
}

OneBlasThread::~OneBlasThread() {
  if (before_ > 1) set_threads(before_);
}

}  // namespace superstep::python
