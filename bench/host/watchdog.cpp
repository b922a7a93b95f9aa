#include "bench/host/watchdog.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "core/stopwatch.hpp"

namespace superstep {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr double interval = 0.05;  // s between looks
constexpr double shortest = 1e-4;  // s: CPU time may pass slower than the clock does

}  // namespace

Watchdog::Watchdog(double seconds, const std::atomic<bool>* stop, bool of_cpu)
    : limit_(seconds),
      of_cpu_(of_cpu),
      began_(of_cpu ? process_cpu_seconds() : wall_seconds()),
      stop_(stop),
      flag_(stop && stop->load()) {
  try {
    thread_ = std::jthread([this](const std::stop_token& quit) { watch(quit); });
  } catch (const std::system_error&) {  // no thread to be had: the run goes on unwatched
  }
}

Watchdog::~Watchdog() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void Watchdog::look_after(double delay, std::function<void(double)> look) {
  const std::lock_guard lock(mutex_);
  look_from_ = wall_seconds();
  look_at_ = look_from_ + delay;
  look_ = std::move(look);
}

double Watchdog::spent() const noexcept {
  return (of_cpu_ ? process_cpu_seconds() : wall_seconds()) - began_;
}

// A limit may be shorter than the time between looks: the last look comes when it is reached.
double Watchdog::until_next_look() const noexcept {
  if (!(limit_ > 0) || flag_) return interval;
  return std::clamp(limit_ - spent(), shortest, interval);
}

void Watchdog::watch(const std::stop_token& quit) {
  std::unique_lock lock(mutex_);
  const auto wait = [&] {
    return wake_.wait_for(lock, quit, Seconds(until_next_look()), [&] { return quit.stop_requested(); });
  };
  while (!wait()) {
    const double now = wall_seconds();
    if (stop_ && stop_->load(std::memory_order_relaxed)) flag_ = true;
    if (limit_ > 0 && spent() > limit_ && !flag_) {
      time_is_up_ = true;
      flag_ = true;
    }
    if (look_ && now > look_at_) std::exchange(look_, nullptr)(now - look_from_);
  }
}

}  // namespace superstep
