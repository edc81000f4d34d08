#pragma once
// A PNG as the light that it reflects.
#include <filesystem>
#include <vector>

namespace overstrike {

struct GreyPicture {
  int width = 0, height = 0;
  std::vector<double> light;  ///< of the green channel, 0..1, row by row
  double at(int x, int y) const { return light[static_cast<std::size_t>(y) * width + x]; }
  /// 1 - mean light of the pixels in [x0, x1) x [y0, y1).
  double coverage(int x0, int y0, int x1, int y1) const;
};

GreyPicture read_png(const std::filesystem::path& file);

}  // namespace overstrike
