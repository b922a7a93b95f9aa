#include "bench/host/interrupt.hpp"

#include <csignal>

#include "parallel/communicator.hpp"

namespace superstep {
namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

extern "C" void on_interrupt(int) {
  stop.store(true, std::memory_order_relaxed);
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESTART;  // files being written must not notice
  sigaction(SIGINT, &action, nullptr);
  // A launcher of several processes passes the wish on by another name.
  if (!world().alone()) sigaction(SIGTERM, &action, nullptr);
}

const std::atomic<bool>& stop_flag() noexcept {
  return stop;
}

}  // namespace superstep
