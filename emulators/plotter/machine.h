#pragma once
// What the plotter does with its instructions: pen, position, hard clip.
#include <istream>
#include <span>

#include "emulators/plotter/plotter.h"

namespace overstrike::emulator {

/// In plotter units, y up, from the lower left corner of the hard clip.
struct PenPoint {
  double x = 0, y = 0;
};

/// What the machine is.
struct PlotterLimits {
  double unit_mm = 0.02488;
  double clip_x = 0, clip_y = 0;  ///< the pen draws in 0..clip_x, 0..clip_y only
  double range = 32767;           ///< largest coordinate; the smallest is -range - 1
  int pens = 6;
};

/// Takes the ink. Virtual: a picture, a page of lines, or a test's list.
class Ink {
 public:
  virtual ~Ink() = default;
  /// A line of pen `pen` (1 ..), at most kLongestLine points, all inside the hard clip; one
  /// point is a dot. A longer line comes in pieces, each beginning where the last one ended.
  virtual void line(int pen, std::span<const PenPoint> points) = 0;
};

constexpr std::size_t kLongestLine = 64;

/// Runs the whole stream: IN SP PU PD PA PR are drawn, DF (absolute coordinates again) and VS
/// taken; everything else is skipped and reported.
PlotterReport run_plotter(std::istream& hpgl, const PlotterLimits& limits, Ink& ink);

}  // namespace overstrike::emulator
