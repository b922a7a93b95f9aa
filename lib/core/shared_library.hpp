#pragma once
/// Where the program lies, and libraries that it loads when they are first wanted.

#include <dlfcn.h>

#include <string>

namespace superstep {

/// Path of the running program; empty where the system does not say.
[[nodiscard]] std::string program_file();

/// A function of a library that the process has loaded already; null where there is none.
template <class Function>
[[nodiscard]] Function* loaded_function(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_DEFAULT, name));
}

/// A library of ours that only those load who need what it brings along. It stays loaded.
class LoadedModule {
 public:
  /// Looks for it beside the program, where it is installed, and beside the code that asks, which may be a
  /// shared library itself.
  ///   file  name without a folder
  explicit LoadedModule(const std::string& file);
  /// Why it could not be loaded; empty where it was.
  [[nodiscard]] const std::string& why_not() const noexcept { return why_not_; }
  /// One of its functions; null where it has none of that name, or was not loaded.
  template <class Function>
  [[nodiscard]] Function* function(const char* name) const {
    return handle_ ? reinterpret_cast<Function*>(::dlsym(handle_, name)) : nullptr;
  }

 private:
  void* handle_ = nullptr;
  std::string why_not_;
};

}  // namespace superstep
