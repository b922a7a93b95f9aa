#pragma once
/// Asks a run to stop that takes too long.

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace superstep::audit {

/// CPU time of the process is what counts, so that a busy machine changes no result.
class TimeLimit {
 public:
  explicit TimeLimit(double seconds);
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;

  /// A run begins; it has to look at this flag.
  [[nodiscard]] const std::atomic<bool>* begin();
  /// The run has ended; true when it had been asked to.
  bool end();
  [[nodiscard]] double seconds() const noexcept { return seconds_; }

 private:
  void watch(const std::stop_token& quit);

  double seconds_, began_ = 0;
  bool running_ = false;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread watcher_;
};

}  // namespace superstep::audit
