/// The one place that knows how a program becomes one of several: the module with MPI is loaded at run time.

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/error.hpp"
#include "parallel/communicator.hpp"
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

/// Beside the program, or where it is installed.
void* load_module() {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path folder = program.parent_path();
  for (const fs::path& place : {folder, folder / "../lib", folder / "../lib64"})
    // For all to see: MPI's own modules want its symbols.
    if (void* module = ::dlopen((place / "libsuperstep_mpi.so").c_str(), RTLD_NOW | RTLD_GLOBAL))
      return module;
  return nullptr;
}

std::unique_ptr<Communicator> make_world() {
  const int processes = started_processes();
  if (processes == 1) return std::make_unique<Serial>();
  void* module = load_module();
  using Make = Communicator* (*)();
  const auto make = module ? reinterpret_cast<Make>(::dlsym(module, "superstep_make_world")) : nullptr;
  if (!make) {
    const char* why = ::dlerror();
    throw UsageError(
        fmt::format("it was started {} times by a launcher of parallel programs but has no MPI to share the "
                    "work with ({}); "
                    "start it once, or build it where PETSc and MPI are installed (libpetsc-real-dev)",
                    processes, why ? why : "not built"));
  }
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
