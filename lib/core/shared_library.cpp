#include "core/shared_library.hpp"

#include <filesystem>
#include <vector>

namespace superstep {
namespace {

namespace fs = std::filesystem;

/// Folder of the file that this code was loaded from: the program, or a shared library.
fs::path folder_of_code() {
  Dl_info info{};
  if (::dladdr(reinterpret_cast<const void*>(&folder_of_code), &info) == 0 || !info.dli_fname) return {};
  std::error_code ignored;
  return fs::weakly_canonical(info.dli_fname, ignored).parent_path();
}

}  // namespace

std::string program_file() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored).string();
}

LoadedModule::LoadedModule(const std::string& file) {
  const fs::path program = fs::path(program_file()).parent_path(), code = folder_of_code();
  std::vector<fs::path> places;
  for (const fs::path& folder : {program, code})
    for (const char* from : {".", "../lib", "../lib64"}) places.push_back(folder / from);
  places.push_back(code / "../../..");   // lib of a prefix, from lib/python3/dist-packages/superstep
  places.push_back(code / "../../bin");  // of a build folder, from python/superstep
  for (const fs::path& place : places) {
    const fs::path path = (place / file).lexically_normal();
    // For all to see: modules that a package loads by itself, as MPI does, want its symbols.
    if (handle_ = ::dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL); handle_) {
      why_not_.clear();
      return;
    }
    const char* why = ::dlerror();
    std::error_code ignored;
    // One that is there and does not load says more than those that are not there.
    if (why_not_.empty() || fs::exists(path, ignored)) why_not_ = why ? why : "the system does not say why";
  }
}

}  // namespace superstep
