#pragma once
// The yardstick: a vectorised, banded Z-buffer, as good as a plain one gets.
//
// Every frame: vertices are projected in double, triangles that face away are dropped, the others
// are binned to bands of rows whose depths and numbers fit in the second-level cache. In a band
// each triangle fills its rows between exact double span ends, 16 pixels at a time (float depth
// test, number under it); then numbers become 8-bit shades. Parallel views only.
#include <cstdint>
#include <vector>

#include "tests/bench/triangles.h"
#include "tests/bench/z_buffer_rows.h"

namespace overstrike::bench {

class ZBuffer {
 public:
  /// Both must outlive this. All columns and rows of view.grid are pixels.
  ZBuffer(const Triangles& triangles, const View& view, int threads);

  /// One frame.
  void draw();
  /// Rows of 8-bit shades, columns a row.
  const std::vector<std::uint8_t>& image() const { return image_; }
  /// The triangle at every pixel of a row (kNothing: none); draws the row's band anew.
  std::vector<std::uint32_t> row(int row);

 private:
  struct Buffer {
    std::vector<float> depth;
    std::vector<std::uint32_t> number;
  };
  void set_up();
  void project_vertices();
  void bin(std::uint32_t triangle);
  void add(const ScreenTriangle& triangle);
  void draw_bands(int worker);
  BandPixels pixels(int band, Buffer& buffer) const;
  void fill_band(int band, const BandPixels& pixels) const;

  const Triangles& input_;
  const View& view_;
  int columns_, rows_, stride_, band_rows_, band_count_, threads_;
  std::vector<Vec3> points_;
  std::vector<std::vector<ScreenTriangle>> bins_;
  std::vector<Buffer> buffers_;  ///< one a thread
  std::vector<std::uint8_t> image_;
};

}  // namespace overstrike::bench
