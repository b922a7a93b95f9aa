#include "bench/app/cli/run_program.hpp"

#include <exception>
#include <new>
#include <variant>

#include "bench/app/cli/cli.hpp"
#include "bench/app/commands.hpp"
#include "bench/host/machine.hpp"
#include "bench/host/terminal.hpp"
#include "core/error.hpp"

namespace superstep {

int run_program(const std::vector<std::string>& arguments) {
  try {
    const Command command = parse_command_line(arguments);
    return std::visit(
        [](const auto& chosen) {
          if constexpr (requires { chosen.common; }) set_library_threads(chosen.common.threads);
          return execute(chosen);
        },
        command);
  } catch (const Error& error) {
    note("error: ", error.what());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    note("error: ", "out of memory; give it more, or a smaller case");
  } catch (const std::exception& error) {
    note("error: internal: ", error.what());
  }
  return static_cast<int>(ExitCode::internal);
}

}  // namespace superstep
