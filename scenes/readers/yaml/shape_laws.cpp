#include "scenes/readers/yaml/shape_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "core/geometry/tessellate.h"

namespace overstrike::yaml {
namespace {

/// Where core's complaint about "loop N" of a region belongs: the outline or a hole.
const Node* complained_loop(const Fields& f, const std::string& complaint) {
  constexpr std::string_view kLoop = "loop ";
  const Node* outline = f.find("outline");
  if (!outline || !complaint.starts_with(kLoop)) return outline;
  const int loop = std::atoi(complaint.c_str() + kLoop.size());
  const Node* holes = f.find("holes");
  if (loop < 2 || !holes || holes->items.size() < static_cast<std::size_t>(loop - 1))
    return outline;
  return holes->items[static_cast<std::size_t>(loop - 2)];
}

/// Core numbers a region's loops; scenes have an outline and holes.
std::string in_scene_words(std::string complaint) {
  constexpr std::string_view kLoop = "loop ";
  for (std::size_t at = complaint.find(kLoop); at != std::string::npos;
       at = complaint.find(kLoop, at + 1)) {
    const std::size_t digits = at + kLoop.size();
    const std::size_t end =
        std::min(complaint.size(), complaint.find_first_not_of("0123456789", digits));
    const int loop = std::atoi(complaint.c_str() + digits);
    if (end == digits) continue;
    complaint.replace(at, end - at, loop == 1 ? "the outline" : fmt::format("hole {}", loop - 1));
  }
  return complaint;
}

}  // namespace

void check_laws(const Fields& f, const Shape& shape) {
  const std::string complaint = validate(shape);
  if (complaint.empty()) return;
  std::string_view named;
  std::size_t first = std::string::npos;
  for (const std::string_view key : f.kind().keys)
    if (const std::size_t at = complaint.find(key); at < first && f.has(key))
      first = at, named = key;
  if (named.empty() && f.has("region")) return f.reporter().error(f.mark("region"), complaint);
  const Node* loop = complained_loop(f, complaint);
  f.reporter().error(named.empty() && loop ? loop->mark : f.mark(named), in_scene_words(complaint));
}

}  // namespace overstrike::yaml
