/// The program: what has to be seen to before libraries start, parse, call, exit code.

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "bench/app/cli/run_program.hpp"
#include "bench/host/terminal.hpp"
#include "core/error.hpp"

namespace {

/// What nobody could catch, before `main` or where nothing may throw: one line and an exit code, no signal.
[[noreturn]] void end_in_one_line() {
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    superstep::note("error: ", "out of memory; give it more, or a smaller case");
    std::_Exit(static_cast<int>(superstep::ExitCode::internal));
  } catch (const std::exception& error) {
    superstep::note("error: internal: ", error.what());
    std::_Exit(static_cast<int>(superstep::ExitCode::internal));
  } catch (...) {  // the same without a reason
  }
  superstep::note("error: internal: ", "the program cannot go on");
  std::_Exit(static_cast<int>(superstep::ExitCode::internal));
}

/// OpenBLAS begins threads while it is loaded. Where a limit on memory is too low for what each of them
/// takes, it ends the program, or its threads try again for ever and the program waits for them at its end.
/// So under such a limit the program starts anew, with one thread for BLAS.
__attribute__((no_sanitize("address", "thread", "undefined"))) void start_with_one_blas_thread(
    int, char** argv, char** environment) {
  constexpr char setting[] = "OPENBLAS_NUM_THREADS=";
  rlimit space{}, data{};
  getrlimit(RLIMIT_AS, &space);
  getrlimit(RLIMIT_DATA, &data);
  if (space.rlim_cur == RLIM_INFINITY && data.rlim_cur == RLIM_INFINITY) return;
  constexpr std::size_t most = 4096;
  static std::array<char*, most + 2> kept;  // nothing may be allocated yet
  std::size_t count = 0;
  for (; environment[count] != nullptr; ++count) {
    if (count == most || std::strncmp(environment[count], setting, sizeof setting - 1) == 0) return;
    kept[count] = environment[count];
  }
  static char one_thread[] = "OPENBLAS_NUM_THREADS=1";
  kept[count] = one_thread;
  execve("/proc/self/exe", argv, kept.data());  // where that is refused the program goes on as it is
}
/// Runs before libraries are told to start.
[[gnu::section(".preinit_array"),
  gnu::used]] void (*const before_libraries)(int, char**, char**) = start_with_one_blas_thread;

/// Before the objects of libraries that allocate while the program is being loaded.
[[gnu::constructor(101)]] void watch_for_the_uncaught() {
  std::set_terminate(end_in_one_line);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace superstep;
  prepare_streams();
  try {
    return run_program(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& error) {  // not even the arguments fit into memory
    note("error: ", error.what());
    return static_cast<int>(ExitCode::internal);
  }
}
