#include "audit/time_limit.hpp"

#include <chrono>

#include "core/stopwatch.hpp"

namespace superstep::audit {

TimeLimit::TimeLimit(double seconds)
    : seconds_(seconds), watcher_([this](const std::stop_token& quit) { watch(quit); }) {}

const std::atomic<bool>* TimeLimit::begin() {
  const std::lock_guard lock(mutex_);
  began_ = process_cpu_seconds();
  running_ = true;
  stop_ = false;
  return &stop_;
}

bool TimeLimit::end() {
  const std::lock_guard lock(mutex_);
  running_ = false;
  return stop_;
}

void TimeLimit::watch(const std::stop_token& quit) {
  using namespace std::chrono_literals;
  std::unique_lock lock(mutex_);
  while (!quit.stop_requested()) {
    if (running_ && process_cpu_seconds() - began_ > seconds_) stop_ = true;
    wake_.wait_for(lock, quit, 50ms, [] { return false; });
  }
}

}  // namespace superstep::audit
