#include "devices/image/load_module.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "core/error.h"

namespace overstrike {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kName = "overstrike_image.so";

std::vector<fs::path> module_folders() {
  std::vector<fs::path> folders;
  if (const char* given = std::getenv("OVERSTRIKE_MODULES"); given != nullptr && *given != '\0')
    folders.emplace_back(given);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path prefix = program.parent_path().parent_path();
    folders.push_back(prefix / OVERSTRIKE_LIBRARY_FOLDER / "overstrike");
    folders.push_back(prefix / "lib");  // the build tree has bin/ and lib/
  }
  folders.emplace_back(OVERSTRIKE_INSTALLED_MODULES);
  return folders;
}

fs::path find_module() {
  std::string tried;
  for (const fs::path& folder : module_folders()) {
    std::error_code error;
    if (fs::is_regular_file(folder / kName, error)) return folder / kName;
    tried += (tried.empty() ? "" : ", ") + folder.string();
  }
  throw WorkError(
      fmt::format("cannot find {}, which reads and writes pictures; looked in {}", kName, tried));
}

const OverstrikeImageModule& load() {
  const fs::path path = find_module();
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw WorkError(fmt::format("cannot load pictures' module: {}", ::dlerror()));
  using Entry = decltype(&overstrike_image_module);
  const auto entry = reinterpret_cast<Entry>(::dlsym(library, "overstrike_image_module"));
  const OverstrikeImageModule* module = entry == nullptr ? nullptr : entry();
  if (module == nullptr || module->abi != OVERSTRIKE_IMAGE_ABI)
    throw WorkError(fmt::format("'{}' is not of this version of overstrike", path.string()));
  return *module;
}

}  // namespace

const OverstrikeImageModule& image_module() {
  static const OverstrikeImageModule& module = load();
  return module;
}

}  // namespace overstrike
