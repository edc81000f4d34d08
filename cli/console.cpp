#include "cli/console.h"

#include <fmt/core.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <set>

#include "cli/usage.h"

namespace overstrike {

void print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0)
    throw WorkError(fmt::format("standard output: {}", std::strerror(errno)));
}

void say(std::string_view text) {
  // A message that cannot be said does not undo the work: no exception, as fmt::print would throw.
  std::fputs((std::string(text) + "\n").c_str(), stderr);
}

void say_warnings(std::span<const Diagnostic> warnings) {
  std::set<std::string> said;
  for (const Diagnostic& warning : warnings) {
    std::string text = to_string(warning);
    if (said.insert(text).second) say(text);
  }
}

bool stdout_is_terminal() { return isatty(STDOUT_FILENO) == 1; }
bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1; }

std::string read_stdin() {
  std::string text;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t got = read(STDIN_FILENO, buffer, sizeof buffer);
    if (got == 0) return text;
    if (got > 0) text.append(buffer, static_cast<std::size_t>(got));
    if (got < 0 && errno != EINTR)
      throw WorkError(fmt::format("standard input: {}", std::strerror(errno)));
  }
}

void check_definitions(const std::string& scene, const std::vector<std::string>& definitions) {
  if (!definitions.empty() && !is_program(scene))
    throw UsageError("-D is for OpenSCAD programs (.scad)");
}

ReadResult read_scene_argument(const std::string& scene, const std::string& format,
                               const std::vector<std::string>& definitions) {
  check_definitions(scene, definitions);
  if (scene != "-") {
    if (!format.empty())
      throw UsageError("--format is for standard input; a file's extension says what it is");
    return read_scene(scene, definitions);
  }
  const auto known = scene_formats();
  const std::string chosen = format.empty() ? "yaml" : format;
  if (std::find(known.begin(), known.end(), chosen) == known.end()) {
    throw UsageError(fmt::format("--format: expected one of {}, found '{}'{}",
                                 fmt::join(known, ", "), chosen, suggestion(chosen, known)));
  }
  return read_scene_text(read_stdin(), chosen, "<stdin>", ".");
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace overstrike
