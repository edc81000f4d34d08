#include "tests/hard/corpus.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "core/visibility/canonical.h"
#include "core/visibility/view.h"
#include "scenes/readers/read.h"

namespace overstrike::hard {
namespace {

/// Calls `found` with what stands after "# key: " in comments of the file.
template <class Found>
void find_remarks(const std::filesystem::path& file, const std::string& key, const Found& found) {
  const std::string start = "# " + key + ": ";
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(start)) found(line.substr(start.size()));
}

std::vector<std::string> split_at_commas(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream in(list);
  for (std::string part; std::getline(in >> std::ws, part, ',');) parts.push_back(part);
  return parts;
}

Case read_case(const std::filesystem::path& file) {
  Case c{file.stem().string(), read_scene(file).scene, {}, {}};
  find_remarks(file, "warns", [&c](const std::string& text) { c.warns.push_back(text); });
  find_remarks(file, "apart", [&c](const std::string& list) { c.apart = split_at_commas(list); });
  find_remarks(file, "finest", [&c](const std::string& number) { c.finest = std::stod(number); });
  return c;
}

std::vector<Case> read_all() {
  std::vector<Case> cases;
  const auto folder = std::filesystem::path(OVERSTRIKE_SOURCE_DIR) / "tests" / "hard";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") cases.push_back(read_case(entry.path()));
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
