#include "python/binding/one_blas_thread.hpp"

#include <dlfcn.h>

namespace superstep::python {
namespace {

/// A function of a library that the process has loaded; null where there is none.
template <class Function>
Function* loaded(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_DEFAULT, name));
}

void set_threads(int threads) {
  if (auto* const set = loaded<void(int)>("openblas_set_num_threads")) (*set)(threads);
}

}  // namespace

OneBlasThread::OneBlasThread() {
  if (auto* const count = loaded<int()>("openblas_get_num_threads")) before_ = (*count)();
  if (before_ > 1) set_threads(1);
}

OneBlasThread::~OneBlasThread() {
  if (before_ > 1) set_threads(before_);
}

}  // namespace superstep::python
