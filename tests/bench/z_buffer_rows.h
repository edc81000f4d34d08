#pragma once
// The Z-buffer's loops over pixels, compiled for every width of vector registers; the widest that
// the machine has is chosen when the program starts.
#include <cstdint>

namespace overstrike::bench {

/// A triangle on screen: corners by rising y, and its depth a x + b y + c.
struct ScreenTriangle {
  double x[3], y[3];
  double a, b, c;
  std::uint32_t number;
  bool middle_left;  ///< the corner of middle height lies left of the long side
};

/// A band of rows [top, bottom) of depths and numbers, `stride` a row; rows are padded by
/// kRowPadding.
struct BandPixels {
  float* depth;
  std::uint32_t* number;
  int columns, stride, top, bottom;
};
constexpr int kRowPadding = 16;

/// Depths to minus infinity, numbers to kNothing.
void clear(const BandPixels&);
/// Draws the triangles into the band: rows between exact double span ends, a float depth test.
void fill(const BandPixels&, const ScreenTriangle* first, const ScreenTriangle* end);
/// Numbers to shades; kNothing to 0. The image has `columns` a row.
void shade(const BandPixels&, const std::uint32_t* shade_of, std::uint8_t* image);

}  // namespace overstrike::bench
