// Compiled once for each target by foreach_target.h.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/z_buffer_rows.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/bench/triangles.h"
#include "tests/bench/z_buffer_rows.h"

HWY_BEFORE_NAMESPACE();
namespace overstrike::bench::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kRowPadding>;
using Words = hn::RebindToUnsigned<Floats>;

void clear(const BandPixels& band) {
  const Floats d;
  const int count = band.stride * (band.bottom - band.top);
  const auto far = hn::Set(d, -std::numeric_limits<float>::infinity());
  const auto nothing = hn::Set(Words(), kNothing);
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    hn::StoreU(far, d, band.depth + i);
    hn::StoreU(nothing, Words(), band.number + i);
  }
}

/// Pixels [first, end) of a row: depth z at the first, and so much more for each further one.
HWY_INLINE void fill_span(float* depth, std::uint32_t* number, int first, int end, float z,
                          float step, std::uint32_t triangle) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto mine = hn::Set(Words(), triangle);
  const auto stride = hn::Set(d, step * static_cast<float>(lanes));
  auto depths = hn::MulAdd(hn::Iota(d, 0), hn::Set(d, step), hn::Set(d, z));
  for (int x = first; x < end; x += lanes) {
    const auto inside = hn::FirstN(d, static_cast<std::size_t>(end - x));
    const auto wins = hn::And(inside, hn::Gt(depths, hn::LoadU(d, depth + x)));
    hn::BlendedStore(depths, wins, d, depth + x);
    hn::BlendedStore(mine, hn::RebindMask(Words(), wins), Words(), number + x);
    depths = hn::Add(depths, stride);
  }
}

/// The first pixel whose centre is not left of x.
HWY_INLINE int first_pixel(double x, int most) {
  return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(most)));
}

HWY_INLINE void fill_triangle(const BandPixels& band, const ScreenTriangle& t) {
  const double long_slope = (t.x[2] - t.x[0]) / (t.y[2] - t.y[0]);
  int row = std::max(band.top, first_pixel(t.y[0], band.bottom));
  for (int half = 0; half < 2; ++half) {
    const int end = first_pixel(t.y[half + 1], band.bottom);
    if (row >= end) continue;
    const double slope = (t.x[half + 1] - t.x[half]) / (t.y[half + 1] - t.y[half]);
    for (; row < end; ++row) {
      const double y = row + 0.5;
      const double across = t.x[0] + (y - t.y[0]) * long_slope;
      const double bent = t.x[half] + (y - t.y[half]) * slope;
      const int first = first_pixel(t.middle_left ? bent : across, band.columns);
      const int last = first_pixel(t.middle_left ? across : bent, band.columns);
      const std::ptrdiff_t start = std::ptrdiff_t{row - band.top} * band.stride;
      const double z = t.a * (first + 0.5) + t.b * y + t.c;
      fill_span(band.depth + start, band.number + start, first, last, static_cast<float>(z),
                static_cast<float>(t.a), t.number);
    }
  }
}

void fill(const BandPixels& band, const ScreenTriangle* first, const ScreenTriangle* end) {
  for (const ScreenTriangle* t = first; t != end; ++t) fill_triangle(band, *t);
}

HWY_INLINE void shade_row(const std::uint32_t* number, const std::uint32_t* shade_of,
                          std::uint8_t* image, int columns) {
  const Words d;
  const hn::RebindToSigned<Words> indices;
  const hn::Rebind<std::uint8_t, Words> bytes;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto nothing = hn::Set(d, kNothing);
  int x = 0;
  for (; x + lanes <= columns; x += lanes) {
    const auto numbers = hn::LoadU(d, number + x);
    const auto paper = hn::Eq(numbers, nothing);
    const auto index = hn::BitCast(indices, hn::IfThenZeroElse(paper, numbers));
    const auto shades = hn::IfThenZeroElse(paper, hn::GatherIndex(d, shade_of, index));
    hn::StoreU(hn::TruncateTo(bytes, shades), bytes, image + x);
  }
  for (; x < columns; ++x)
    image[x] = static_cast<std::uint8_t>(number[x] == kNothing ? 0 : shade_of[number[x]]);
}

void shade(const BandPixels& band, const std::uint32_t* shade_of, std::uint8_t* image) {
  for (std::ptrdiff_t row = 0; row < band.bottom - band.top; ++row)
    shade_row(band.number + row * band.stride, shade_of, image + row * band.columns, band.columns);
}

}  // namespace overstrike::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overstrike::bench {

HWY_EXPORT(clear);
HWY_EXPORT(fill);
HWY_EXPORT(shade);

void clear(const BandPixels& band) { HWY_DYNAMIC_DISPATCH(clear)(band); }
void fill(const BandPixels& band, const ScreenTriangle* first, const ScreenTriangle* end) {
  HWY_DYNAMIC_DISPATCH(fill)(band, first, end);
}
void shade(const BandPixels& band, const std::uint32_t* shade_of, std::uint8_t* image) {
  HWY_DYNAMIC_DISPATCH(shade)(band, shade_of, image);
}

}  // namespace overstrike::bench
#endif
