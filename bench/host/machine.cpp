#include "bench/host/machine.hpp"

#include <cholmod.h>
#include <fmt/format.h>
#include <klu.h>
#include <link.h>
#include <sundials/sundials_config.h>
#include <sys/utsname.h>

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <thread>

#include "build_info.hpp"
#include "core/memory.hpp"
#include "core/shared_library.hpp"
#include "rhs/kernels/sweep.hpp"

namespace superstep {
namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  return "unknown";
}

std::string kernel() {
  utsname name{};
  if (uname(&name) != 0) return "unknown";
  return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

// File names of the loaded libraries, symbolic links followed: Debian's libblas.so.3 is a link to one of
// several.
std::vector<std::string> loaded_libraries() {
  std::vector<std::string> names;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* out) {
        std::error_code error;
        const auto path = std::filesystem::canonical(info->dlpi_name, error);
        if (!error) static_cast<std::vector<std::string>*>(out)->push_back(path.filename());
        return 0;
      },
      &names);
  return names;
}

std::string blas() {
  if (auto* const config = loaded_function<const char*()>("openblas_get_config"))
    return fmt::format("openblas ({})", (*config)());
  for (const auto& name : loaded_libraries())
    if (name.starts_with("libblas")) return fmt::format("reference ({})", name);
  return "none";
}

std::string blas_threads() {
  auto* const threads = loaded_function<int()>("openblas_get_num_threads");
  return threads ? fmt::format("{}", (*threads)()) : "1";
}

}  // namespace

std::string program_version() {
  return build::version;
}
std::string program_revision() {
  return build::revision;
}

std::vector<Fact> machine_facts() {
  return {{"processor", processor()},
          {"cores", fmt::format("{}", std::thread::hardware_concurrency())},
          {"kernel", kernel()},
          {"compiler", build::compiler},
          {"build_type", build::build_type},
          {"flags", build::flags},
          {"sweep", sweep_kernels().front().name},
          {"blas", blas()},
          {"blas_threads", blas_threads()}};
}

std::vector<Fact> library_facts() {
  return {
      {"sundials", SUNDIALS_VERSION},
      {"klu", fmt::format("{}.{}.{}", KLU_MAIN_VERSION, KLU_SUB_VERSION, KLU_SUBSUB_VERSION)},
      {"cholmod", fmt::format("{}.{}.{}", CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION)},
      {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)}};
}

void set_library_threads(int threads) {
  for (const char* name : {"openblas_set_num_threads", "omp_set_num_threads"})
    if (auto* const set = loaded_function<void(int)>(name)) (*set)(threads);
  // CHOLMOD's loops name a number of threads of their own; none is begun where no level of them is allowed.
  if (auto* const set = loaded_function<void(int)>("omp_set_max_active_levels")) (*set)(threads > 1 ? 1 : 0);
}

void reset_peak_memory() {
  give_back_memory();                             // what earlier runs gave back must not count
  std::ofstream("/proc/self/clear_refs") << "5";  // Linux: 5 resets the peak resident set
}

}  // namespace superstep
