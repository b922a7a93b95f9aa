#include "bench/host/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <system_error>

#include "bench/host/terminal.hpp"
#include "core/stopwatch.hpp"

namespace superstep {
namespace {

constexpr auto between_lines = std::chrono::milliseconds(100);
constexpr const char* clear_line = "\r\033[K";

// Wrapping is off while the line is written: a long one is cut at the edge instead of filling the screen.
void write_line(const std::string& text) {
  say(fmt::format("{}\033[?7l{}\033[?7h", clear_line, text));
}

}  // namespace

std::string progress_text(double position, double goal, double taken, double now) {
  if (!(position > 0) || !(taken > 0)) return fmt::format("{:.1f} s", now);
  const double rate = position / taken;
  return fmt::format("{:.0f} %, {:.2g}/s, {:.0f} s left", 100 * position / goal, rate,
                     std::max(0.0, goal / rate - now));
}

void Progress::reached(double position) noexcept {
  if (!enabled_) return;
  reached_at_.store(wall_seconds() - began_, std::memory_order_relaxed);
  position_.store(position, std::memory_order_relaxed);
}

void Progress::begin(std::string label, double goal) {
  if (!enabled_) return;
  end();
  label_ = std::move(label);
  goal_ = goal;
  began_ = wall_seconds();
  position_ = reached_at_ = watched_ = 0;
  shown_ = true;
  try {
    ticker_ = std::jthread([this](std::stop_token stop) { tick(std::move(stop)); });
  } catch (const std::system_error&) {  // no thread to be had: the work goes on unwatched
  }
}

void Progress::begin_timed(const std::string& label) {
  if (!enabled_) return;
  end();
  write_line(label);
  shown_ = true;
}

void Progress::end() {
  if (ticker_.joinable()) {
    ticker_.request_stop();
    ticker_.join();
  }
  if (shown_) {
    write_line("");
  }
  shown_ = false;
}

void Progress::tick(std::stop_token stop) {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, stop, between_lines, [&] { return stop.stop_requested(); })) {
    const double seen = watched_.load(std::memory_order_relaxed);
    if (seen > position_.load(std::memory_order_relaxed)) reached(seen);
    draw();
  }
}

void Progress::draw() const {
  const double position = position_.load(std::memory_order_relaxed);
  const double taken = reached_at_.load(std::memory_order_relaxed);
  write_line(label_ + ": " + progress_text(position, goal_, taken, wall_seconds() - began_));
}

}  // namespace superstep
