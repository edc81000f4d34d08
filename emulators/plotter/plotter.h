#pragma once
// An emulated pen plotter: HP-GL in, the drawn sheet out (docs/emulated-plotter.md).
#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/data_files.h"

namespace overstrike::emulator {

struct PlotterOptions {
  std::string machine = "hp7475a";  ///< data/plotters/NAME.profile, or a file if it has a slash
  std::string paper = "A4";
  double dpi = 100;               ///< of a PNG: kLeastDpi to kMostDpi
  double pen_width_mm = 0;        ///< of every pen; 0: each pen's own, from the profile
  std::vector<std::string> pens;  ///< colours "#rrggbb" of pens 1, 2, ...; others as the profile
};

constexpr double kLeastDpi = 10, kMostDpi = 600;

/// An instruction that the emulator does not draw, or does not know.
struct SkippedInstruction {
  std::string name;
  std::uint64_t count = 0;
  std::uint64_t first_byte = 0;
};

struct PlotterReport {
  std::uint64_t instructions = 0;  ///< taken and skipped ones
  double pen_down_mm = 0;          ///< inside the hard clip
  double pen_up_mm = 0;
  std::uint64_t lifts = 0;
  std::uint64_t pen_changes = 0;            ///< pens taken from the carousel
  std::uint64_t clipped = 0;                ///< moves with the pen down that leave the hard clip
  std::uint64_t unknown = 0;                ///< skipped instructions and bytes that mean nothing
  std::vector<SkippedInstruction> skipped;  ///< in the order of their first bytes
  std::vector<std::string> warnings;        ///< the first kMostWarnings
};

constexpr std::size_t kMostWarnings = 20;

/// Draws the sheet that the bytes make: PNG, PDF or SVG by the extension of `sheet`, which gets its
/// name when it is whole. Any bytes give a sheet and a report. PNG takes memory for the sheet
/// alone, PDF and SVG for every line. Throws Error: unknown machine, paper, colour or extension,
/// dpi out of range, input that cannot be read, a sheet that cannot be written.
PlotterReport emulate_plotter(std::istream& hpgl, const PlotterOptions& options,
                              const std::filesystem::path& sheet);
PlotterReport emulate_plotter(std::string_view hpgl, const PlotterOptions& options,
                              const std::filesystem::path& sheet);

}  // namespace overstrike::emulator
