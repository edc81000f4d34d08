#pragma once
// The subcommands: what each was asked, and what runs it. Options are already read and checked.
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "cli/scene_changes.h"
#include "core/drawing.h"
#include "devices/device.h"

namespace overstrike {

/// Exit statuses of the command.
constexpr int kDone = 0;
constexpr int kWorkFailed = 1;
constexpr int kBadUsage = 2;

enum class TimingsFormat : std::uint8_t { none, text, json };

struct RenderCommand {
  std::string scene;                     ///< a file, or - for standard input
  std::string output;                    ///< a file, - for standard output, or empty
  std::string device;                    ///< empty: by the output's extension
  std::string format;                    ///< of standard input
  std::vector<std::string> definitions;  ///< NAME=VALUE, for OpenSCAD
  Settings settings;                     ///< for the device
  std::size_t options = 0;  ///< so many of the settings, the first, were options of their own
  SceneChanges changes;
  Method method = Method::automatic;
  BooleanForm boolean = BooleanForm::automatic;
  Coherence coherence = Coherence::all;
  std::optional<double> translucent;  ///< else as the scene says
  double tolerance = 0;               ///< grid units; 0: the device's
  int threads = 0;                    ///< 0: all processors
  TimingsFormat timings = TimingsFormat::none;
  bool verbose = false;
};

/// Of what is rendered, without output and timings; the device is the terminal.
struct WatchCommand {
  RenderCommand render;
};

struct EmulateCommand {
  std::string machine;  ///< line-printer or plotter
  std::string input;    ///< a file, or - for standard input
  std::string output;   ///< a file, whose extension chooses the format, or - for standard output
  std::string format;   ///< of standard output: png (when empty), pdf or svg
  Settings settings;
  std::size_t options = 0;  ///< as in RenderCommand
};

struct CheckCommand {
  std::string scene;
  std::string format;
  std::vector<std::string> definitions;  ///< NAME=VALUE, for OpenSCAD
};

struct DevicesCommand {
  std::string name;  ///< empty: list all
};

/// --help and --version.
struct TextCommand {
  std::string text;
};

using Command = std::variant<RenderCommand, WatchCommand, EmulateCommand, CheckCommand,
                             DevicesCommand, TextCommand>;

/// The words after the program's name. Throws UsageError.
Command parse_command_line(std::span<const std::string> words);

// Each returns an exit status, or throws UsageError, InputError (both: status 2) or WorkError (1).
int run(const RenderCommand&);
int run(const WatchCommand&);
int run(const EmulateCommand&);
int run(const CheckCommand&);
int run(const DevicesCommand&);
int run(const TextCommand&);

}  // namespace overstrike
