/// The one place that knows how a program becomes one of several: the module with MPI is loaded at run time.

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "core/error.hpp"
#include "core/shared_library.hpp"
#include "parallel/communicator.hpp"
#include "parallel/file_part.hpp"
#include "parallel/stay_alone.hpp"

namespace superstep {
namespace {

class Serial final : public Communicator {
 public:
  [[nodiscard]] int rank() const noexcept override { return 0; }
  [[nodiscard]] int size() const noexcept override { return 1; }
  void broadcast(std::vector<std::byte>& /*bytes*/) override {}
  std::unique_ptr<Exchange> make_exchange(const Partition& /*rows*/,
                                          std::span<const std::int64_t> /*halo*/) override {
    return nullptr;
  }
  void send(int /*to*/, std::span<const std::byte> /*bytes*/) override {}
  std::vector<std::byte> receive(int /*from*/) override { return {}; }
  std::unique_ptr<FilePart> open_part(const std::string& file) override { return open_plain_part(file); }
  bool all_arrive(double /*seconds*/) override { return true; }
  void abort(int exit_code) override { std::_Exit(exit_code); }

 private:
  void add_up(std::span<std::int64_t> /*words*/) override {}
  void take_largest(std::span<double> /*values*/) override {}
  void gather_into(std::span<const double> /*own*/, std::span<const std::int64_t> /*counts*/,
                   std::span<double> /*all*/) override {}
};

bool by_choice = false;  // alone, see stay_alone.hpp

/// Processes that a launcher says it started; 1 without one.
int started_processes() {
  if (by_choice) return 1;
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* value = std::getenv(name)) return std::max(1, std::atoi(value));
  return 1;
}

std::unique_ptr<Communicator> make_world() {
  const int processes = started_processes();
  if (processes == 1) return std::make_unique<Serial>();
  const LoadedModule module("libsuperstep_mpi.so");
  auto* const make = module.function<Communicator*()>("superstep_make_world");
  if (!make)
    throw UsageError(
        fmt::format("it was started {} times by a launcher of parallel programs but has no MPI to share the "
                    "work with ({}); "
                    "start it once, or build it where PETSc and MPI are installed (libpetsc-real-dev)",
                    processes, module.why_not()));
  return std::unique_ptr<Communicator>(make());
}

}  // namespace

void stay_alone() noexcept {
  by_choice = true;
}

Communicator& world() {
  static const std::unique_ptr<Communicator> communicator = make_world();
  return *communicator;
}

}  // namespace superstep
