#include "python/binding/interruptible.hpp"

#include <omp.h>
#include <pybind11/pybind11.h>

#include <chrono>
#include <thread>
#include <utility>

#include "python/binding/one_blas_thread.hpp"

namespace superstep::python {
namespace {

namespace py = pybind11;
constexpr std::chrono::milliseconds between_looks{50};

}  // namespace

void Interruptible::run(int threads, const std::function<void()>& work) {
  std::exception_ptr thrown;
  {
    const py::gil_scoped_release released;
    const OneBlasThread one;
    std::thread worker([&] {
      omp_set_num_threads(threads);  // of the loops that this thread begins
      try {
        work();
      } catch (...) {
        thrown = std::current_exception();
      }
      const std::scoped_lock lock(mutex_);
      done_ = true;
      wake_.notify_all();
    });
    attend();
    worker.join();
  }
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  if (thrown) std::rethrow_exception(thrown);
}

void Interruptible::attend() {
  std::unique_lock lock(mutex_);
  while (!done_) {
    wake_.wait_for(lock, between_looks, [&] { return done_ || call_; });
    if (!done_) serve(lock);
  }
}

void Interruptible::serve(std::unique_lock<std::mutex>& lock) {
  const auto call = call_;
  lock.unlock();
  {
    const py::gil_scoped_acquire acquired;
    try {
      if (call && !failure_) call();
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    } catch (...) {
      note_failure();
    }
  }
  lock.lock();
  if (!call) return;
  call_ = nullptr;
  wake_.notify_all();
}

void Interruptible::note_failure() {
  if (!failure_) failure_ = std::current_exception();
  stop_.store(true);
}

void Interruptible::in_interpreter(std::function<void()> call) {
  std::unique_lock lock(mutex_);
  call_ = std::move(call);
  wake_.notify_all();
  wake_.wait(lock, [&] { return !call_; });
}

}  // namespace superstep::python
