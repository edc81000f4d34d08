#include "emulators/data_files.h"

#include <array>
#include <cstdlib>
#include <string>

namespace overstrike::emulator {

std::filesystem::path find_data_file(std::string_view relative) {
  namespace fs = std::filesystem;
  const char* users = std::getenv("OVERSTRIKE_DATA");
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  const std::array<fs::path, 4> folders{
      fs::path(users ? users : ""),
      program.empty() ? fs::path() : program.parent_path() / ".." / "share" / "overstrike",
      fs::path(OVERSTRIKE_SOURCE_DATA), fs::path(OVERSTRIKE_INSTALLED_DATA)};
  std::string tried;
  for (const fs::path& folder : folders) {
    if (folder.empty()) continue;
    const fs::path file = folder / relative;
    if (fs::is_regular_file(file, failed)) return file;
    tried += "\n  " + file.string();
  }
  throw Error("data file " + std::string(relative) + " is missing; looked for" + tried);
}

}  // namespace overstrike::emulator
