#include "bench/host/interrupt.hpp"

#include <unistd.h>

#include <csignal>

namespace superstep {
namespace {

constexpr int most_wishes = 3;
constexpr unsigned patience = 10;  // s

std::atomic<bool> stop{false};
std::atomic<int> wishes{0}, first_signal{SIGINT};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

extern "C" void on_signal(int signal) {
  if (signal == SIGALRM) _exit(interrupted_exit_code());
  const int count = ++wishes;
  if (count == 1) first_signal = signal;
  stop = true;
  if (count == most_wishes) _exit(interrupted_exit_code());
  if (signal != SIGINT) alarm(patience);
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;  // files being written must not notice
  for (const int signal : {SIGINT, SIGTERM, SIGXCPU, SIGALRM}) sigaction(signal, &action, nullptr);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

const std::atomic<bool>& stop_flag() noexcept {
  return stop;
}

int interrupted_exit_code() noexcept {
  constexpr int ended_by_signal = 128;
  return ended_by_signal + first_signal;
}

}  // namespace superstep
