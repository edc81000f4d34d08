#include "tests/plotter/picture.h"

#include <cairo.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace overstrike {
namespace {

double light_of(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

double GreyPicture::coverage(int x0, int y0, int x1, int y1) const {
  double sum = 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) sum += 1 - at(x, y);
  }
  return sum / (double(x1 - x0) * (y1 - y0));
}

GreyPicture read_png(const std::filesystem::path& file) {
  cairo_surface_t* surface = cairo_image_surface_create_from_png(file.c_str());
  if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(file.string() + " is no PNG");
  }
  GreyPicture picture{
      cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  for (int y = 0; y < picture.height; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(
        cairo_image_surface_get_data(surface) +
        std::ptrdiff_t(y) * cairo_image_surface_get_stride(surface));
    for (int x = 0; x < picture.width; ++x) {
      picture.light.push_back(light_of((row[x] >> 8 & 255) / 255.0));
    }
  }
  cairo_surface_destroy(surface);
  return picture;
}

}  // namespace overstrike
