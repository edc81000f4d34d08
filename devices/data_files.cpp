#include "devices/data_files.h"

#include <cstdlib>
#include <string>
#include <vector>

#include "core/error.h"

namespace overstrike {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> data_folders() {
  std::vector<fs::path> folders;
  if (const char* given = std::getenv("OVERSTRIKE_DATA"); given && *given)
    folders.emplace_back(given);
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  if (!none) folders.push_back(program.parent_path().parent_path() / "share" / "overstrike");
  folders.emplace_back(OVERSTRIKE_SOURCE_DATA);
  folders.emplace_back(OVERSTRIKE_INSTALLED_DATA);
  return folders;
}

}  // namespace

fs::path find_data_file(std::string_view relative) {
  std::string tried;
  for (const fs::path& folder : data_folders()) {
    std::error_code none;
    if (const fs::path file = folder / relative; fs::is_regular_file(file, none)) return file;
    tried += (tried.empty() ? "" : ", ") + folder.string();
  }
  throw InputError(Place{std::string(relative), 0, 0}, "no such data file", "looked in " + tried);
}

}  // namespace overstrike
