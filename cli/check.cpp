// overstrike check: everything that is wrong with a scene, and what is in it.
#include <fmt/core.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/console.h"
#include "core/visibility/canonical.h"
#include "core/visibility/view.h"

namespace overstrike {
namespace {

std::string summary(const Scene& scene, const Canonical& canonical) {
  const auto closed = std::count_if(canonical.bodies.begin(), canonical.bodies.end(),
                                    [](const CanonicalBody& body) { return body.closed; });
  std::string text = fmt::format("{}: {} ({} closed), {}, {}, {}", scene.source,
                                 counted(canonical.bodies.size(), "body", "bodies"), closed,
                                 counted(canonical.vertices.size(), "vertex", "vertices"),
                                 counted(canonical.edges.size(), "edge", "edges"),
                                 counted(canonical.faces.size(), "face", "faces"));
  if (!canonical.patterns.empty())
    text += ", " + counted(canonical.patterns.size(), "pattern", "patterns");
  if (!canonical.segments.empty())
    text += ", " + counted(canonical.segments.size(), "segment", "segments");
  return text + "\n";
}

}  // namespace

int run(const CheckCommand& command) {
  const ReadResult read = read_scene_argument(command.scene, command.format, command.definitions);
  say_warnings(read.warnings);
  const DrawOptions usual;
  const View view = make_view(read.scene, Grid{});
  std::vector<Diagnostic> warnings;
  const Canonical canonical = canonicalize(read.scene, view, usual.tolerance, warnings);
  say_warnings(warnings);
  print(summary(read.scene, canonical));
  return kDone;
}

int run(const TextCommand& command) {
  print(command.text);
  return kDone;
}

}  // namespace overstrike
