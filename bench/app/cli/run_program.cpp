#include "bench/app/cli/run_program.hpp"

#include <exception>
#include <new>
#include <optional>
#include <variant>

#include "bench/app/cli/cli.hpp"
#include "bench/app/commands.hpp"
#include "bench/host/machine.hpp"
#include "bench/host/memory_limit.hpp"
#include "bench/host/terminal.hpp"
#include "bench/measure/shared/worker.hpp"
#include "bench/output/layered_vtk.hpp"
#include "core/error.hpp"
#include "parallel/communicator.hpp"

namespace superstep {
namespace {

/// What went wrong is said by the root alone, unless it is a worker's own trouble.
template <class Work>
int with_errors_said(bool say, const Work& work) {
  const auto tell = [&](const char* kind, const char* what) {
    if (say) note(kind, what);
  };
  try {
    return work();
  } catch (const Error& error) {
    tell("error: ", error.what());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    tell("error: ", "out of memory; give it more, or a smaller case");
  } catch (const std::exception& error) {
    tell("error: internal: ", error.what());
  }
  return static_cast<int>(ExitCode::internal);
}

/// Every process reads the command line; the root carries it out.
int carry_out(const Command& command, bool root) {
  std::visit(
      [](const auto& chosen) {
        if constexpr (requires { chosen.common; }) {
          set_library_threads(chosen.common.threads);
          if (chosen.common.block_rows > 0) set_block_rows(chosen.common.block_rows);
        }
      },
      command);
  if (!root) {
    const int code = with_errors_said(true, [] { return serve_the_root(write_layered_frame); });
    if (code == static_cast<int>(ExitCode::internal)) world().abort(code);  // the root would wait for ever
    return code;
  }
  const int code = with_errors_said(
      true, [&] { return std::visit([](const auto& chosen) { return execute(chosen); }, command); });
  dismiss_workers(code);
  return code;
}

}  // namespace

int run_program(const std::vector<std::string>& arguments) {
  bool root = true;
  return with_errors_said(true, [&] {
    root = world().is_root();
    keep_to_memory(attainable_memory());
    std::optional<Command> command;
    const int code = with_errors_said(root, [&] {
      command = parse_command_line(arguments);
      return 0;
    });
    return command ? carry_out(*command, root) : code;
  });
}

}  // namespace superstep
