#pragma once
/// Errors by who has to act, each with the exit code that the program promises.

#include <stdexcept>
#include <string>

namespace superstep {

/// Exit codes of the program: a contract.
enum class ExitCode : int {
  ok = 0,
  internal = 1,
  usage = 2,
  input = 3,
  numerical = 4,
  regressed = 5,
  inconclusive = 6,
  output = 7,
};

/// Base of every error that a user can do something about.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

/// The command line or an integrator SPEC is wrong.
struct UsageError : Error {
  explicit UsageError(const std::string& message) : Error(ExitCode::usage, message) {}
};

/// A file or a value in it is wrong; the message names file, line, value, rule and the way out.
struct InputError : Error {
  explicit InputError(const std::string& message) : Error(ExitCode::input, message) {}
};

/// A file as a whole is wrong: it is missing, no file, empty or unreadable. Whoever knows who named it says
/// so.
class FileError : public InputError {
 public:
  FileError(const std::string& path, const std::string& what) : InputError(path + ": " + what), path_(path) {}
  [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
  std::string path_;
};

/// A computation could not be carried through.
struct NumericalError : Error {
  explicit NumericalError(const std::string& message) : Error(ExitCode::numerical, message) {}
};

/// A result could not be written.
struct OutputError : Error {
  explicit OutputError(const std::string& message) : Error(ExitCode::output, message) {}
};

}  // namespace superstep
