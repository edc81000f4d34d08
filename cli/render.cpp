// overstrike render: a scene onto a device.
#include <fmt/core.h>

#include <chrono>
#include <filesystem>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/device_choice.h"
#include "cli/progress.h"
#include "cli/timings.h"
#include "devices/draw.h"

namespace overstrike {
namespace {

using Clock = std::chrono::steady_clock;

std::unique_ptr<Transport> open_output(const std::string& output) {
  return output == "-" ? open_stdout() : open_file(output);
}

DrawOptions draw_options(const RenderCommand& command, Progress& progress) {
  DrawOptions options;
  options.method = command.method;
  options.boolean = command.boolean;
  options.coherence = command.coherence;
  options.translucent = command.translucent;
  options.tolerance = command.tolerance;
  options.threads = command.threads;
  options.progress = [&progress](double fraction) { progress.show(fraction); };
  return options;
}

/// "bunny.png" from "bunny.txt": where an emulator's sheet may go without overwriting the output.
std::string sheet_name(const std::string& output) {
  const std::string name = std::filesystem::path(output).replace_extension(".png").string();
  return name == output ? output + ".png" : name;
}

/// The word as a POSIX shell must be told it.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./,:@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// The command that shows the file as its machine would draw it; empty when there is no machine.
std::string emulate_command(const DeviceChoice& choice, const Settings& settings) {
  const std::string name(choice.kind->name);
  if (choice.output == "-" || (name != "line-printer" && name != "plotter")) return {};
  std::string command =
      fmt::format("overstrike emulate {} {} -o {}", name, shell_word(choice.output),
                  shell_word(sheet_name(choice.output)));
  // What the emulated machines assume unless told.
  for (const auto& [setting, usual] : std::initializer_list<std::pair<std::string, std::string>>{
           {"lpi", "6"}, {"cpi", "10"}, {"stream", "cr"}, {"paper", "A4"}}) {
    std::string value = setting_value(*choice.kind, settings, setting);
    if (setting == "stream" && choice.output.ends_with(".asa")) value = "asa";
    if (!value.empty() && value != usual) command += fmt::format(" --{} {}", setting, value);
  }
  return command;
}

void say_what_was_drawn(const Scene& scene, const Layout& layout, const DeviceChoice& choice,
                        const Settings& settings) {
  const Grid& grid = layout.grid;
  say(fmt::format("{}: {}, {}", scene.source, counted(scene.bodies.size(), "body", "bodies"),
                  counted(scene.segments.size(), "segment", "segments")));
  say(fmt::format("{}: {:g} x {:g} cells of {:.4g} x {:.4g} mm", choice.kind->name, grid.columns,
                  grid.rows, grid.pitch_x_mm, grid.pitch_y_mm));
  const std::string command = emulate_command(choice, settings);
  if (!command.empty()) say("to see it: " + command);
}

void say_timings(TimingsFormat format, const RunTimings& timings) {
  if (format == TimingsFormat::text) say(timings_as_text(timings));
  if (format == TimingsFormat::json) say(timings_as_json(timings));
}

}  // namespace

int run(const RenderCommand& command) {
  const auto start = Clock::now();
  const DeviceChoice choice = choose_device(command, stdout_is_terminal());
  check_settings(*choice.kind, command.settings);
  ReadResult read = read_scene_argument(command.scene, command.format, command.definitions);
  say_warnings(read.warnings);
  apply(command.changes, read.scene);

  const auto device = make_device(choice, command, open_output(choice.output));
  const bool shares_terminal = choice.output == "-" && stdout_is_terminal();
  DrawReport report;
  {
    Progress progress(stderr_is_terminal() && !shares_terminal);
    report = draw(read.scene, *device, draw_options(command, progress));
  }
  say_warnings(report.warnings);
  if (command.verbose) say_what_was_drawn(read.scene, device->layout(), choice, command.settings);
  const std::chrono::duration<double, std::milli> total = Clock::now() - start;
  say_timings(command.timings, {report.timings, total.count(), peak_resident_bytes()});
  return kDone;
}

}  // namespace overstrike
