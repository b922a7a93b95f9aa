#include "support/thread_world.hpp"

#include <omp.h>

#include <algorithm>
#include <barrier>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "parallel/file_part.hpp"

namespace superstep::test {
namespace {

struct Shared {
  explicit Shared(int count)
      : processes(count), meeting(count), words(at_least(count)), values(words.size()) {}
  static std::size_t at_least(int count) { return static_cast<std::size_t>(count); }

  int processes;
  std::barrier<> meeting;
  std::vector<std::span<std::int64_t>> words;
  std::vector<std::span<double>> values;
  std::mutex lock;
  std::condition_variable news;
  std::map<std::pair<int, int>, std::deque<std::vector<std::byte>>> letters;  ///< from, to
  /// What every process has of a vector, by the number of its exchange.
  std::deque<std::vector<std::vector<double>>> owned;
};

class SharedVector final : public Exchange {
 public:
  SharedVector(Shared& shared, int rank, std::size_t number, const Partition& rows,
               std::span<const std::int64_t> halo)
      : shared_(shared), rank_(rank), number_(number), rows_(rows), halo_rows_(halo.begin(), halo.end()) {}
  void begin(const double* owned, double* halo) override {
    halo_ = halo;
    const std::scoped_lock guard(shared_.lock);
    shared_.owned[number_][static_cast<std::size_t>(rank_)].assign(owned, owned + rows_.owned());
  }
  void end() override {
    shared_.meeting.arrive_and_wait();
    for (std::size_t k = 0; k < halo_rows_.size(); ++k) {
      const int owner = rows_.owner(halo_rows_[k]);
      halo_[k] = shared_.owned[number_][static_cast<std::size_t>(owner)]
                              [static_cast<std::size_t>(halo_rows_[k] - rows_.first(owner))];
    }
    shared_.meeting.arrive_and_wait();
  }
  [[nodiscard]] std::uint64_t messages() const noexcept override { return 1; }
  [[nodiscard]] std::uint64_t bytes() const noexcept override { return 0; }

 private:
  Shared& shared_;
  int rank_;
  std::size_t number_;
  Partition rows_;
  std::vector<std::int64_t> halo_rows_;
  double* halo_ = nullptr;
};

class OneOfThem final : public Communicator {
 public:
  OneOfThem(Shared& shared, int rank) : shared_(shared), rank_(rank) {}
  [[nodiscard]] int rank() const noexcept override { return rank_; }
  [[nodiscard]] int size() const noexcept override { return shared_.processes; }
  void broadcast(std::vector<std::byte>& /*bytes*/) override { throw std::logic_error("not asked for"); }
  std::unique_ptr<Exchange> make_exchange(const Partition& rows,
                                          std::span<const std::int64_t> halo) override {
    {
      const std::scoped_lock guard(shared_.lock);
      if (shared_.owned.size() <= exchanges_)
        shared_.owned.emplace_back(static_cast<std::size_t>(shared_.processes));
    }
    return std::make_unique<SharedVector>(shared_, rank_, exchanges_++, rows, halo);
  }
  void send(int to, std::span<const std::byte> bytes) override {
    const std::scoped_lock guard(shared_.lock);
    shared_.letters[{rank_, to}].emplace_back(bytes.begin(), bytes.end());
    shared_.news.notify_all();
  }
  std::vector<std::byte> receive(int from) override {
    std::unique_lock guard(shared_.lock);
    auto& box = shared_.letters[{from, rank_}];
    shared_.news.wait(guard, [&] { return !box.empty(); });
    auto letter = std::move(box.front());
    box.pop_front();
    return letter;
  }
  std::unique_ptr<FilePart> open_part(const std::string& file) override { return open_plain_part(file); }
  bool all_arrive(double /*seconds*/) override { return true; }
  void abort(int exit_code) override { std::_Exit(exit_code); }

 private:
  /// into = op of everybody's `own`.
  template <class Value, class Combine>
  void combine(std::vector<std::span<Value>>& all, std::span<Value> own, const Combine& op) {
    all[static_cast<std::size_t>(rank_)] = own;
    shared_.meeting.arrive_and_wait();
    std::vector<Value> result(all.front().begin(), all.front().end());
    for (std::size_t other = 1; other < all.size(); ++other)
      for (std::size_t k = 0; k < result.size(); ++k) result[k] = op(result[k], all[other][k]);
    shared_.meeting.arrive_and_wait();
    std::copy(result.begin(), result.end(), own.begin());
  }
  void add_up(std::span<std::int64_t> words) override {
    combine(shared_.words, words, [](std::int64_t a, std::int64_t b) { return a + b; });
  }
  void take_largest(std::span<double> values) override {
    combine(shared_.values, values, [](double a, double b) { return std::max(a, b); });
  }
  void gather_into(std::span<const double> /*own*/, std::span<const std::int64_t> /*counts*/,
                   std::span<double> /*all*/) override {
    throw std::logic_error("not asked for");
  }

  Shared& shared_;
  int rank_;
  std::size_t exchanges_ = 0;
};

}  // namespace

void as_processes(int count, int threads, const std::function<void(Communicator&)>& body) {
  Shared shared(count);
  std::vector<std::thread> all;
  for (int rank = 0; rank < count; ++rank)
    all.emplace_back([&, rank] {
      omp_set_num_threads(threads);
      OneOfThem here(shared, rank);
      body(here);
    });
  for (auto& one : all) one.join();
}

}  // namespace superstep::test
