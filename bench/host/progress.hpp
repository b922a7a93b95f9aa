#pragma once
/// One line on stderr that says what goes on and how long it may take.

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace superstep {

class Progress {
 public:
  /// A disabled one does nothing at all.
  explicit Progress(bool enabled) : enabled_(enabled) {}
  ~Progress() { end(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Work begins that goes from 0 to `goal` (simulated time [s], or a fraction); the line is redrawn ten
  /// times a second.
  void begin(std::string label, double goal);
  /// The same for work that is being timed: the line is written once, and nothing runs beside the work.
  void begin_timed(const std::string& label);
  /// How far the work has come. May be called from the working thread at any time.
  void reached(double position) noexcept;
  /// A place that the work may write its position to as well, at no cost; looked at when the line is redrawn.
  /// Null when nobody would look.
  [[nodiscard]] std::atomic<double>* watched() noexcept { return enabled_ ? &watched_ : nullptr; }
  /// Takes the line away.
  void end();

 private:
  void tick(std::stop_token stop);
  void draw() const;

  bool enabled_, shown_ = false;
  std::string label_;
  double goal_ = 1, began_ = 0;
  std::atomic<double> position_{0}, reached_at_{0}, watched_{0};
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread ticker_;
};

/// What a progress line says after its label: "42 %, 1.2e-05/s, 12 s left"; only the time spent while nothing
/// is known.
///   position, goal    how far, of what
///   taken, now [s]    wall time since the beginning: when `position` was reached, and at present
[[nodiscard]] std::string progress_text(double position, double goal, double taken, double now);

}  // namespace superstep
