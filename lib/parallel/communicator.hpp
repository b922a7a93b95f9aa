#pragma once
/// The processes that share a computation. A program that was started as usual is alone in its world; one
/// that `mpirun` started loads MPI when it is first asked for its world, so that nobody else pays for it.
///
/// Whatever several processes decide together they decide from values that are the same everywhere, and every
/// process makes the same calls in the same order: that is all the synchronisation there is.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "parallel/exact_sum.hpp"
#include "parallel/partition.hpp"

namespace superstep {

/// Work of communication since the world began, of this process.
struct Traffic {
  std::uint64_t reductions = 0;     ///< sums and maxima over all processes
  std::uint64_t halo_messages = 0;  ///< sent
  std::uint64_t halo_bytes = 0;     ///< sent
};

/// Values of rows that other processes own, fetched again and again by the same pattern.
class Exchange {
 public:
  virtual ~Exchange() = default;
  /// Sends what others need of `owned`, which may then be written over, and goes on receiving into `halo`
  /// until `end`.
  virtual void begin(const double* owned, double* halo) = 0;
  virtual void end() = 0;
  /// Between the two, now and then: what is on its way gets on. By the thread that began.
  virtual void progress() {}
  /// What one round sends.
  [[nodiscard]] virtual std::uint64_t messages() const noexcept = 0;
  [[nodiscard]] virtual std::uint64_t bytes() const noexcept = 0;
};

class FilePart;

class Communicator {
 public:
  virtual ~Communicator() = default;
  Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  [[nodiscard]] virtual int rank() const noexcept = 0;
  [[nodiscard]] virtual int size() const noexcept = 0;
  [[nodiscard]] bool alone() const noexcept { return size() == 1; }
  [[nodiscard]] bool is_root() const noexcept { return rank() == 0; }

  // Collective: every process calls, and all get the same.
  [[nodiscard]] double sum(const ExactSum& own);
  [[nodiscard]] std::uint64_t sum(std::uint64_t own);
  /// Of the processes of lower ranks.
  [[nodiscard]] std::uint64_t sum_before(std::uint64_t own);
  /// NaN where one of them is.
  [[nodiscard]] double max(double own);
  [[nodiscard]] double min(double own) { return -max(-own); }
  [[nodiscard]] bool any(bool own) { return sum(std::uint64_t{own ? 1u : 0u}) > 0; }
  /// The text of the lowest rank that has one.
  [[nodiscard]] std::optional<std::string> first_of(const std::optional<std::string>& own);
  /// Everybody's entries one behind the other, on the root; nothing elsewhere.
  [[nodiscard]] std::vector<double> gather(std::span<const double> own);
  /// What the root has.
  virtual void broadcast(std::vector<std::byte>& bytes) = 0;
  [[nodiscard]] virtual std::unique_ptr<Exchange> make_exchange(const Partition& rows,
                                                                std::span<const std::int64_t> halo) = 0;

  // From one to another. Who waits leaves the processor to others.
  virtual void send(int to, std::span<const std::byte> bytes) = 0;
  [[nodiscard]] virtual std::vector<std::byte> receive(int from) = 0;

  /// A file that is there, to write a part of it: see file_part.hpp. Not collective. Throws
  /// std::runtime_error with the reason where it cannot be opened here.
  [[nodiscard]] virtual std::unique_ptr<FilePart> open_part(const std::string& file) = 0;

  /// The wish of any process to stop, agreed on in every sum and maximum: all see it at the same place of
  /// their computation. `own` is looked at until another one is given; null = none.
  void watch(const std::atomic<bool>* own) noexcept {
    wish_ = own;
    agreed_.store(false);
  }
  [[nodiscard]] const std::atomic<bool>& agreed() const noexcept { return agreed_; }

  /// True when all processes arrive here within some seconds; they then went through the same.
  [[nodiscard]] virtual bool all_arrive(double seconds) = 0;
  /// Ends all processes.
  [[noreturn]] virtual void abort(int exit_code) = 0;

  [[nodiscard]] const Traffic& traffic() const noexcept { return traffic_; }
  void count_halo(std::uint64_t messages, std::uint64_t bytes) noexcept {
    traffic_.halo_messages += messages;
    traffic_.halo_bytes += bytes;
  }

 protected:
  virtual void add_up(std::span<std::int64_t> words) = 0;
  virtual void take_largest(std::span<double> values) = 0;
  virtual void gather_into(std::span<const double> own, std::span<const std::int64_t> counts,
                           std::span<double> all) = 0;

 private:
  void agree(bool wished) noexcept {
    if (wished) agreed_.store(true);
  }
  [[nodiscard]] bool wish() const noexcept { return wish_ && wish_->load(std::memory_order_relaxed); }

  const std::atomic<bool>* wish_ = nullptr;
  std::atomic<bool> agreed_{false};
  Traffic traffic_;
};

/// The processes that this program was started with. Throws UsageError where it was started several times
/// over and has no MPI to talk with.
[[nodiscard]] Communicator& world();

}  // namespace superstep
