#pragma once
// What the emulator must know of a machine and its paper, from the same file in data/plotters/ that
// the device reads, by a reader of its own.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/plotter/machine.h"

namespace overstrike::emulator {

struct Colour {
  unsigned char red = 0, green = 0, blue = 0;
};

/// "#rrggbb". Throws Error.
Colour parse_colour(std::string_view text);

struct Pen {
  double width_mm = 0.3;
  Colour colour;
};

struct MachineProfile {
  PlotterLimits limits;
  double width_mm = 0, height_mm = 0;       ///< of the paper
  double origin_x_mm = 0, origin_y_mm = 0;  ///< of (0, 0), from the left and the bottom edge
  std::vector<Pen> pens;                    ///< pen 1 first
};

/// The machine with that paper in it. Throws Error that names the file and what is wrong.
MachineProfile read_machine(const std::filesystem::path& file, std::string_view paper);

}  // namespace overstrike::emulator
