#pragma once
// What the device must know of a plotter, from its file in data/plotters/ (docs/plotter.md).
#include <filesystem>
#include <string>
#include <vector>

namespace overstrike {

/// A sheet as the plotter takes it: X is the long side.
struct PlotterPaper {
  std::string name;
  double width_mm = 0, height_mm = 0;
  double origin_x_mm = 0, origin_y_mm = 0;  ///< of (0, 0), from the left and the bottom edge
  int clip_x = 0, clip_y = 0;               ///< hard-clip limits: 0..clip_x, 0..clip_y units
};

struct PlotterProfile {
  std::string name;
  double unit_mm = 0;  ///< one plotter unit
  std::vector<PlotterPaper> papers;
  int pens = 0;
  double slowest_cm_s = 0, fastest_cm_s = 0;

  const PlotterPaper* paper(std::string_view paper_name) const;
  std::string paper_names() const;  ///< "A4, A3, A, B"
};

/// Reads `key: values` lines; `#` with a blank after it begins a comment. Throws InputError with
/// the place of the line.
PlotterProfile read_plotter_profile(const std::filesystem::path& file);

}  // namespace overstrike
