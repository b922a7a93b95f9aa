/// The program: parse, call, exit code.

#include <cstdlib>
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
