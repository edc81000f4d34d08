#include "tests/bench/z_buffer.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace overstrike::bench {
namespace {

/// Half of a common second-level cache: depth and number of each pixel of a band.
constexpr int kBandBytes = 1 << 20;
constexpr int kPixelBytes = 8;

/// The first pixel whose centre is not left of x.
int first_pixel(double x, int most) {
  return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(most)));
}

double cross(const Vec3& o, const Vec3& a, const Vec3& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

}  // namespace

ZBuffer::ZBuffer(const Triangles& triangles, const View& view, int threads)
    : input_(triangles),
      view_(view),
      columns_(static_cast<int>(view.grid.columns)),
      rows_(static_cast<int>(view.grid.rows)),
      stride_((columns_ + 2 * kRowPadding - 1) / kRowPadding * kRowPadding),
      band_rows_(std::clamp(kBandBytes / kPixelBytes / stride_, 1, rows_)),
      band_count_((rows_ + band_rows_ - 1) / band_rows_),
      threads_(threads),
      points_(triangles.vertices.size()),
      bins_(static_cast<std::size_t>(band_count_)),
      buffers_(static_cast<std::size_t>(threads)),
      image_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
  for (Buffer& buffer : buffers_) {
    buffer.depth.resize(static_cast<std::size_t>(stride_ * band_rows_));
    buffer.number.resize(buffer.depth.size());
  }
}

void ZBuffer::set_up() {
  project_vertices();
  for (std::vector<ScreenTriangle>& bin : bins_) bin.clear();
  for (std::uint32_t t = 0; t < input_.corners.size(); ++t) bin(t);
}

void ZBuffer::project_vertices() {
  const Mat4& m = view_.matrix;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec3& p = input_.vertices[i];
    points_[i] = {m[0][0] * p.x + m[1][0] * p.y + m[2][0] * p.z + m[3][0],
                  m[0][1] * p.x + m[1][1] * p.y + m[2][1] * p.z + m[3][1],
                  m[0][3] * p.x + m[1][3] * p.y + m[2][3] * p.z + m[3][3]};
  }
}

void ZBuffer::bin(std::uint32_t triangle) {
  const auto& corners = input_.corners[triangle];
  const Vec3 &p = points_[corners[0]], &q = points_[corners[1]], &r = points_[corners[2]];
  // Counter-clockwise from outside is clockwise where y runs down.
  const double area = cross(p, q, r);
  if (!(area < 0)) return;
  const Vec3 *low = &p, *middle = &q, *high = &r;
  if (middle->y < low->y) std::swap(low, middle);
  if (high->y < middle->y) std::swap(middle, high);
  if (middle->y < low->y) std::swap(low, middle);
  ScreenTriangle t;
  t.x[0] = low->x, t.x[1] = middle->x, t.x[2] = high->x;
  t.y[0] = low->y, t.y[1] = middle->y, t.y[2] = high->y;
  t.a = ((q.z - p.z) * (r.y - p.y) - (r.z - p.z) * (q.y - p.y)) / area;
  t.b = ((r.z - p.z) * (q.x - p.x) - (q.z - p.z) * (r.x - p.x)) / area;
  t.c = p.z - t.a * p.x - t.b * p.y;
  t.number = triangle;
  t.middle_left = cross(*low, *high, *middle) > 0;
  add(t);
}

void ZBuffer::add(const ScreenTriangle& triangle) {
  const int first = first_pixel(triangle.y[0], rows_), end = first_pixel(triangle.y[2], rows_);
  if (first == end) return;
  for (int band = first / band_rows_; band <= (end - 1) / band_rows_; ++band)
    bins_[static_cast<std::size_t>(band)].push_back(triangle);
}

BandPixels ZBuffer::pixels(int band, Buffer& buffer) const {
  const int top = band * band_rows_;
  return {buffer.depth.data(),
          buffer.number.data(),
          columns_,
          stride_,
          top,
          std::min(rows_, top + band_rows_)};
}

void ZBuffer::fill_band(int band, const BandPixels& pixels) const {
  const std::vector<ScreenTriangle>& bin = bins_[static_cast<std::size_t>(band)];
  clear(pixels);
  fill(pixels, bin.data(), bin.data() + bin.size());
}

void ZBuffer::draw_bands(int worker) {
  for (int band = worker; band < band_count_; band += threads_) {
    const BandPixels here = pixels(band, buffers_[static_cast<std::size_t>(worker)]);
    fill_band(band, here);
    shade(here, input_.shade.data(), image_.data() + std::ptrdiff_t{here.top} * columns_);
  }
}

void ZBuffer::draw() {
  set_up();
  std::vector<std::jthread> others;
  for (int worker = 1; worker < threads_; ++worker)
    others.emplace_back([this, worker] { draw_bands(worker); });
  draw_bands(0);
}

std::vector<std::uint32_t> ZBuffer::row(int row) {
  const auto empty = [](const std::vector<ScreenTriangle>& bin) { return bin.empty(); };
  if (std::all_of(bins_.begin(), bins_.end(), empty)) set_up();
  const int band = row / band_rows_;
  const BandPixels here = pixels(band, buffers_[0]);
  fill_band(band, here);
  const std::uint32_t* first = here.number + std::ptrdiff_t{row - here.top} * stride_;
  return {first, first + columns_};
}

}  // namespace overstrike::bench
