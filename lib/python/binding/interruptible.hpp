#pragma once
/// Long work beside a Python interpreter that stays awake.

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>

namespace superstep::python {

/// Work runs in a thread of its own, without the interpreter's lock. The calling thread waits without it as
/// well, so that other Python threads go on, and takes it some twenty times a second to see whether a signal
/// handler wants to raise something, KeyboardInterrupt above all. Then `stop()` is set, and the work ends at
/// its next look at it.
class Interruptible {
 public:
  /// Call with the interpreter's lock held. Throws what a signal handler, a call `in_interpreter` or the work
  /// threw, in that order.
  ///   threads  that loops of the work may take
  void run(int threads, const std::function<void()>& work);

  /// From within the work: has `call` made by the thread that `run` was called from, with the lock, and waits
  /// until it is over. What it throws ends the run.
  void in_interpreter(std::function<void()> call);

  [[nodiscard]] const std::atomic<bool>& stop() const noexcept { return stop_; }

 private:
  void attend();
  void serve(std::unique_lock<std::mutex>& lock);
  void note_failure();

  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable wake_;
  std::function<void()> call_;
  bool done_ = false;
  std::exception_ptr failure_;
};

}  // namespace superstep::python
