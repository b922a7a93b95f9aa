#pragma once
/// A thread beside a run that looks at the clock, so that no method has to.

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace superstep {

class Watchdog {
 public:
  static constexpr double first_look = 10;  ///< s after which a forecast is worth something

  /// Watches from now on.
  ///   seconds  after which `flag` is set; 0 = never
  ///   of_cpu   they are CPU time of the process, so that a busy machine makes no run late
  ///   stop     sets `flag` as well; may be null
  Watchdog(double seconds, const std::atomic<bool>* stop, bool of_cpu = false);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// Set once the run has to end.
  [[nodiscard]] const std::atomic<bool>* flag() const noexcept { return thread_.joinable() ? &flag_ : stop_; }
  /// True when that is because its time is over.
  [[nodiscard]] bool time_is_up() const noexcept { return time_is_up_.load(); }
  /// `look` is called once from the thread, with the seconds gone by, when `delay` [s] have passed from now.
  void look_after(double delay, std::function<void(double seconds)> look);

 private:
  void watch(const std::stop_token& quit);

  [[nodiscard]] double spent() const noexcept;            // of what is limited [s]
  [[nodiscard]] double until_next_look() const noexcept;  // s

  double limit_;
  bool of_cpu_;
  double began_;
  const std::atomic<bool>* stop_;
  std::atomic<bool> flag_{false}, time_is_up_{false};
  std::mutex mutex_;
  std::condition_variable_any wake_;
  double look_at_ = 0, look_from_ = 0;  // 0 = nobody wants to look
  std::function<void(double)> look_;
  std::jthread thread_;
};

}  // namespace superstep
