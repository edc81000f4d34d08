#include "emulators/plotter/plotter.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <new>
#include <sstream>

#include "emulators/plotter/machine.h"
#include "emulators/plotter/profile.h"
#include "emulators/plotter/sheet.h"

namespace overstrike::emulator {
namespace {

namespace fs = std::filesystem;

fs::path profile_of(const std::string& machine) {
  if (machine.find('/') != std::string::npos) return machine;
  return find_data_file("plotters/" + machine + ".profile");
}

MachineProfile machine_for(const PlotterOptions& options) {
  MachineProfile machine = read_machine(profile_of(options.machine), options.paper);
  if (options.pens.size() > machine.pens.size()) {
    throw Error(fmt::format("{} colours for {} pens", options.pens.size(), machine.pens.size()));
  }
  for (std::size_t i = 0; i < options.pens.size(); ++i) {
    machine.pens[i].colour = parse_colour(options.pens[i]);
  }
  constexpr double kThickest = 20;  // mm; thicker is a slip
  if (!(options.pen_width_mm >= 0 && options.pen_width_mm <= kThickest)) {
    throw Error(fmt::format("pen width {} mm, expected 0 to {}", options.pen_width_mm, kThickest));
  }
  for (Pen& pen : machine.pens) {
    if (options.pen_width_mm > 0) pen.width_mm = options.pen_width_mm;
  }
  return machine;
}

std::unique_ptr<Sheet> sheet_for(const MachineProfile& machine, double dpi, const fs::path& file) {
  if (!(dpi >= kLeastDpi && dpi <= kMostDpi)) {
    throw Error(fmt::format("{} dpi, expected {} to {}", dpi, kLeastDpi, kMostDpi));
  }
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".png") return png_sheet(machine, dpi, file);
  if (extension == ".pdf" || extension == ".svg") {
    return vector_sheet(machine, file, extension == ".pdf");
  }
  throw Error(fmt::format("{}: a sheet is drawn as .png, .pdf or .svg", file.string()));
}

}  // namespace

PlotterReport emulate_plotter(std::istream& hpgl, const PlotterOptions& options,
                              const fs::path& sheet) {
  if (!hpgl) throw Error("the stream cannot be read");
  const MachineProfile machine = machine_for(options);
  const std::unique_ptr<Sheet> paper = sheet_for(machine, options.dpi, sheet);
  PlotterReport report;
  try {
    report = run_plotter(hpgl, machine.limits, *paper);
  } catch (const std::ios_base::failure& failure) {
    throw Error(fmt::format("the stream cannot be read: {}", failure.code().message()));
  }
  paper->finish();
  return report;
}

PlotterReport emulate_plotter(std::string_view hpgl, const PlotterOptions& options,
                              const fs::path& sheet) {
  std::istringstream in{std::string(hpgl)};
  return emulate_plotter(in, options, sheet);
}

}  // namespace overstrike::emulator
