#include "tests/hard/corpus.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "core/visibility/canonical.h"
#include "core/visibility/view.h"
#include "scenes/readers/read.h"

namespace overstrike::hard {
namespace {

std::vector<std::string> warnings_asked(const std::filesystem::path& file) {
  const std::string key = "# warns: ";
  std::vector<std::string> asked;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(key)) asked.push_back(line.substr(key.size()));
  return asked;
}

std::vector<Case> read_all() {
  std::vector<Case> cases;
  const auto folder = std::filesystem::path(OVERSTRIKE_SOURCE_DIR) / "tests" / "hard";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto& path = entry.path();
    if (path.extension() != ".yaml") continue;
    cases.push_back({path.stem().string(), read_scene(path).scene, warnings_asked(path)});
  }
  std::sort(cases.begin(), cases.end(),
            [](const Case& a, const Case& b) { return a.name < b.name; });
  return cases;
}

}  // namespace

const std::vector<Case>& corpus() {
  static const std::vector<Case> cases = read_all();
  return cases;
}

const Case& find_case(const std::string& name) {
  for (const Case& c : corpus())
    if (c.name == name) return c;
  throw std::out_of_range("no hard case " + name);
}

std::size_t face_count(const Case& hard) {
  std::vector<Diagnostic> warnings;
  return canonicalize(hard.scene, make_view(hard.scene, kGrid), kTolerance, warnings).faces.size();
}

}  // namespace overstrike::hard
