// overstrike watch: a scene in the terminal, drawn anew whenever it is saved.
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/device_choice.h"
#include "cli/file_watch.h"
#include "cli/full_screen.h"
#include "cli/usage.h"
#include "devices/draw.h"

namespace overstrike {
namespace {

using Clock = std::chrono::steady_clock;

/// The lines of a text, each cut to so many characters. (UTF-8; what is wider than one column may
/// reach over.)
std::vector<std::string> lines_of(std::string_view text, int columns) {
  std::vector<std::string> lines{{}};
  int width = 0;
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
      width = 0;
      continue;
    }
    const bool goes_on = (c & 0xC0) == 0x80;
    if (!goes_on && ++width > columns) continue;
    if (goes_on && width > columns) continue;
    const bool control = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
    lines.back() += control ? ' ' : c;
  }
  return lines;
}

class Watcher {
 public:
  explicit Watcher(const RenderCommand& command)
      : command_(command), choice_(choose_device(command, true)) {
    check_settings(*choice_.kind, command_.settings);
    // Bad settings end the program before there is a screen.
    std::string nowhere;
    make_device(choice_, command_, open_memory(nowhere));
  }

  int run() {
    watch_.add(command_.scene);
    FullScreen screen;
    draw_until_all_is_watched();
    while (true) {
      const FullScreen::Event event = screen.wait(watch_.descriptor());
      if (event.exit_status != 0) return event.exit_status;
      const bool saved = event.other && watch_.saved(!errors_.empty());
      if (event.resized) FullScreen::show("\033[2J");
      if (saved || event.resized) draw_until_all_is_watched();
    }
  }

 private:
  /// A file that was saved between its being read and its being watched is read once more.
  void draw_until_all_is_watched() {
    do {
      draw_once();
      show();
    } while (watch_files());
  }

  void draw_once() {
    start_ = Clock::now();
    errors_.clear();
    try {
      ReadResult read = read_scene_argument(command_.scene, {}, command_.definitions);
      files_.clear();
      for (const Body& body : read.scene.bodies)
        if (const Mesh* mesh = std::get_if<Mesh>(body.shape.get()); mesh && !mesh->source.empty())
          files_.insert(mesh->source);
      apply(command_.changes, read.scene);
      std::string picture;
      const auto device = make_device(choice_, command_, open_memory(picture));
      DrawOptions options;
      options.method = command_.method;
      options.tolerance = command_.tolerance;
      options.threads = command_.threads;
      const DrawReport report = draw(read.scene, *device, options);
      picture_ = std::move(picture);
      warnings_ = read.warnings.size() + report.warnings.size();
    } catch (const InputError& error) {
      errors_ = error.what();
      for (const Diagnostic& d : error.diagnostics()) files_.insert(d.place.file);
    } catch (const WorkError& error) {
      errors_ = error.what();
    }
  }

  bool watch_files() {
    bool fresh = false;
    for (const std::string& file : files_)
      if (!file.empty()) fresh = watch_.add(file) || fresh;
    return fresh;
  }

  /// The picture, what is wrong over its lower half, and a line that says what is seen.
  void show() const {
    const auto [columns, lines] = FullScreen::size();
    std::string text = "\033[H" + picture_;
    if (!errors_.empty()) {
      std::vector<std::string> said = lines_of(errors_, columns);
      const auto room = static_cast<std::size_t>(std::max(1, lines / 2));
      if (said.size() > room) said.resize(room);
      int line = lines - static_cast<int>(said.size());
      for (const std::string& one : said)
        text += fmt::format("\033[{};1H\033[0m{}\033[K", line++, one);
    }
    const std::chrono::duration<double, std::milli> spent = Clock::now() - start_;
    const std::string status = fmt::format(
        "{}: {}, {:.1f} ms (q ends)", std::filesystem::path(command_.scene).filename().string(),
        state(), spent.count());
    text += fmt::format("\033[{};1H\033[7m{}\033[0m\033[K", lines, lines_of(status, columns)[0]);
    FullScreen::show(text);
  }

  std::string state() const {
    if (!errors_.empty()) return "not drawn";
    return warnings_ == 0 ? "drawn" : counted(warnings_, "warning", "warnings");
  }

  RenderCommand command_;
  DeviceChoice choice_;
  FileWatch watch_;
  std::set<std::string> files_;  ///< besides the scene's own
  std::string picture_;          ///< the last good one
  std::string errors_;
  std::size_t warnings_ = 0;
  Clock::time_point start_;
};

}  // namespace

int run(const WatchCommand& command) {
  if (command.render.scene == "-")
    throw UsageError("SCENE must be a file: standard input cannot be saved anew");
  if (!stdout_is_terminal()) throw UsageError("standard output must be a terminal");
  check_definitions(command.render.scene, command.render.definitions);
  if (!std::filesystem::exists(command.render.scene)) read_scene_argument(command.render.scene, {});
  return Watcher(command.render).run();
}

}  // namespace overstrike
