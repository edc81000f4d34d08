// Replays the files of the folders named, each whole and cut short at every sixteenth of its
// length (with --whole not cut), in the order of their names.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void replay(const std::filesystem::path& path, std::size_t parts) {
  std::printf("%s\n", path.c_str());
  std::fflush(stdout);  // the last name says which input it was
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  for (std::size_t part = parts == 1; part <= parts; ++part)
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                           bytes.size() * part / parts);
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t parts = 16;
  std::vector<std::filesystem::path> paths;
  for (int i = 1; i < argc; ++i) {
    if (argv[i] == std::string("--whole")) {
      parts = 1;
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
      if (entry.is_regular_file()) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  for (const auto& path : paths) replay(path, parts);
  return paths.empty() ? 1 : 0;
}
