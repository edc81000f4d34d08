// overstrike emulate: what a machine would put on paper.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/numbers.h"
#include "cli/sheet_output.h"
#include "cli/usage.h"
#include "cli/written.h"
#include "emulators/line_printer/line_printer.h"
#include "emulators/plotter/plotter.h"

namespace overstrike {
namespace {

constexpr std::string_view kMachines[] = {"line-printer", "plotter"};
constexpr std::string_view kPaperFormats[] = {"png", "pdf"};
constexpr std::string_view kSheetFormats[] = {"png", "pdf", "svg"};

/// Everything that the machine is sent. Throws InputError that names the file.
std::string read_stream(const std::string& input) {
  if (input == "-") return read_stdin();
  const Place place{input, 0, 0};
  if (std::filesystem::is_directory(input))
    throw InputError(place, "expected a file, found a directory");
  std::ifstream file(input, std::ios::binary);
  if (!file) throw InputError(place, std::strerror(errno));
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The settings of a machine, each read by name once; what is left over is unknown.
class MachineSettings {
 public:
  MachineSettings(std::string_view machine, const EmulateCommand& command)
      : machine_(machine), given_(command.settings), options_(command.options) {}

  void read(std::string_view name, std::string& value) {
    known_.push_back(name);
    for (const auto& [key, text] : given_) {
      if (key == name) value = text;
    }
  }

  void read(std::string_view name, std::string_view expected, double low, double high,
            double& value) {
    std::string text;
    read(name, text);
    if (text.empty()) return;
    const std::string option = as_written({given_, options_}, name);
    const NumberRule rule{option, expected};
    value = read_numbers(rule, text).front();
    if (value < low || value > high) refuse(rule, text);
  }

  void finish() const {
    for (const auto& [key, text] : given_) {
      if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
      throw UsageError(fmt::format("the emulated {} has no setting '{}'{}; it has {}", machine_,
                                   key, suggestion(key, known_), fmt::join(known_, ", ")));
    }
  }

 private:
  std::string_view machine_;
  const Settings& given_;
  std::size_t options_;
  std::vector<std::string_view> known_;
};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; !text.empty() && at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    parts.push_back(text.substr(at, comma - at));
    at = comma + 1;
  }
  return parts;
}

emulator::PlotterOptions plotter_options(const EmulateCommand& command) {
  emulator::PlotterOptions options;
  MachineSettings settings("plotter", command);
  std::string pens;
  settings.read("machine", options.machine);
  settings.read("paper", options.paper);
  settings.read("dpi",
                fmt::format("a number from {} to {}", emulator::kLeastDpi, emulator::kMostDpi),
                emulator::kLeastDpi, emulator::kMostDpi, options.dpi);
  settings.read("pen-width", "millimetres from 0 (the profile's) to 10", 0, 10,
                options.pen_width_mm);
  settings.read("pens", pens);
  options.pens = split(pens);
  settings.finish();
  return options;
}

emulator::LinePrinterOptions line_printer_options(const EmulateCommand& command) {
  emulator::LinePrinterOptions options;
  MachineSettings settings("line-printer", command);
  const std::string pitch =
      fmt::format("a number from {} to {}", emulator::kLeastPitch, emulator::kMostPitch);
  const std::string dpi =
      fmt::format("a number from {} to {}", emulator::kLeastPrinterDpi, emulator::kMostPrinterDpi);
  double columns = options.columns;
  settings.read("stream", options.stream);
  settings.read("cpi", pitch, emulator::kLeastPitch, emulator::kMostPitch, options.cpi);
  settings.read("lpi", pitch, emulator::kLeastPitch, emulator::kMostPitch, options.lpi);
  settings.read("columns", fmt::format("a number from 1 to {}", emulator::kMostColumns), 1,
                emulator::kMostColumns, columns);
  settings.read("dpi", dpi, emulator::kLeastPrinterDpi, emulator::kMostPrinterDpi, options.dpi);
  settings.read("margin", fmt::format("inches from 0 to {}", emulator::kMostMarginIn), 0,
                emulator::kMostMarginIn, options.margin_in);
  settings.read("typeface", options.typeface);
  settings.finish();
  options.columns = static_cast<int>(columns);
  return options;
}

void say_report(const EmulateCommand& command, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    say(fmt::format("{}: warning: {}", command.input == "-" ? "<stdin>" : command.input, warning));
}

void emulate_plotter(const EmulateCommand& command) {
  const emulator::PlotterOptions options = plotter_options(command);
  const std::string stream = read_stream(command.input);
  const SheetOutput output(command.output, command.format, kSheetFormats);
  const auto report = emulator::emulate_plotter(stream, options, output.path());
  output.deliver();
  say_report(command, report.warnings);
}

void emulate_line_printer(const EmulateCommand& command) {
  const emulator::LinePrinterOptions options = line_printer_options(command);
  const std::string stream = read_stream(command.input);
  const SheetOutput output(command.output, command.format, kPaperFormats);
  const auto report = emulator::emulate_line_printer(stream, options, output.path());
  output.deliver();
  say_report(command, report.warnings);
}

void emulate(const EmulateCommand& command) {
  if (command.machine == "line-printer") return emulate_line_printer(command);
  if (command.machine == "plotter") return emulate_plotter(command);
  throw UsageError(fmt::format("expected a machine, {}, found '{}'{}", fmt::join(kMachines, " or "),
                               command.machine, suggestion(command.machine, kMachines)));
}

}  // namespace

int run(const EmulateCommand& command) {
  try {
    emulate(command);
  } catch (const emulator::OutputError& error) {
    throw WorkError(error.what());
  } catch (const emulator::Error& error) {
    throw UsageError(say_as_written({command.settings, command.options}, error.what()));
  }
  return kDone;
}

}  // namespace overstrike
