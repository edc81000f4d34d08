#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "emulators/plotter/canvas.h"
#include "emulators/plotter/sheet.h"

namespace overstrike::emulator {
namespace {

/// y^(1/5) for y in [0.008, 1.3], whose root lies in [0.38, 1.06]: Newton's iteration from above,
/// which settles in 12 steps; the same bits on every machine, which pow does not promise.
double fifth_root(double y) {
  double x = 1.3;
  for (int i = 0; i < 40; ++i) x = (4 * x + y / (x * x * x * x)) / 5;
  return x;
}

/// Reflected light of an sRGB value 0..255 (IEC 61966-2-1).
double light_of(double value) {
  const double v = value / 255;
  if (v <= 0.04045) return v / 12.92;
  const double base = (v + 0.055) / 1.055;
  return base * base * fifth_root(base * base);  // base^2.4
}

/// The light half-way between neighbouring values, in value: what lies below value + 1/2.
std::array<double, 255> borders_of_values() {
  std::array<double, 255> borders{};
  for (std::size_t i = 0; i < borders.size(); ++i) borders[i] = light_of(double(i) + 0.5);
  return borders;
}

std::uint32_t encoded(double light) {
  static const std::array<double, 255> kBorders = borders_of_values();
  return static_cast<std::uint32_t>(std::upper_bound(kBorders.begin(), kBorders.end(), light) -
                                    kBorders.begin());
}

struct Light {
  double red = 1, green = 1, blue = 1;
};

class PngSheet final : public Sheet {
 public:
  PngSheet(const MachineProfile& machine, double dpi, const std::filesystem::path& file)
      : machine_(machine), file_(file) {
    const double dots_per_mm = dpi / 25.4;
    width_ = std::max(1, static_cast<int>(std::lround(machine.width_mm * dots_per_mm)));
    height_ = std::max(1, static_cast<int>(std::lround(machine.height_mm * dots_per_mm)));
    samples_ = samples_a_side();
    // Each sample holds the number of the pen on top, 0 for paper: ink of one pen is a union, exact
    // whatever the order of its lines.
    surface_.reset(
        cairo_image_surface_create(CAIRO_FORMAT_A8, width_ * samples_, height_ * samples_));
    context_ = pen_context(surface_.get(), machine, dots_per_mm * samples_);
    cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_NONE);
    cairo_set_operator(context_.get(), CAIRO_OPERATOR_SOURCE);
    lights_.push_back({});
    for (const Pen& pen : machine.pens) {
      lights_.push_back(
          {light_of(pen.colour.red), light_of(pen.colour.green), light_of(pen.colour.blue)});
    }
  }

  void line(int pen, std::span<const PenPoint> points) override {
    cairo_set_source_rgba(context_.get(), 0, 0, 0, pen / 255.0);
    const Pen& with = machine_.pens[static_cast<std::size_t>(pen - 1)];
    stroke(context_.get(), points, with.width_mm / machine_.limits.unit_mm);
  }

  void finish() override {
    check(cairo_status(context_.get()));
    cairo_surface_flush(surface_.get());
    const Surface picture(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_, height_));
    check(cairo_surface_status(picture.get()));
    unsigned char* pixels = cairo_image_surface_get_data(picture.get());
    for (int row = 0; row < height_; ++row) {
      average_row(
          row, reinterpret_cast<std::uint32_t*>(
                   pixels + std::ptrdiff_t(row) * cairo_image_surface_get_stride(picture.get())));
    }
    cairo_surface_mark_dirty(picture.get());
    CairoOutput output(file_);
    output.settle(cairo_surface_write_to_png_stream(picture.get(), CairoOutput::write, &output));
    output.file.commit();
  }

 private:
  int samples_a_side() const {
    constexpr int kMost = 8, kLargestSurface = 32767;  // Cairo's
    const double area = double(width_) * height_;
    int samples = std::clamp(static_cast<int>(std::sqrt(kMostSamples / area)), 1, kMost);
    while (samples > 1 && samples * std::max(width_, height_) > kLargestSurface) --samples;
    return samples;
  }

  void average_row(int row, std::uint32_t* pixels) const {
    const unsigned char* samples = cairo_image_surface_get_data(surface_.get());
    const std::ptrdiff_t stride = cairo_image_surface_get_stride(surface_.get());
    for (int column = 0; column < width_; ++column) {
      std::array<int, 256> counts{};
      for (int y = 0; y < samples_; ++y) {
        const unsigned char* at =
            samples + (std::ptrdiff_t(row) * samples_ + y) * stride + column * samples_;
        for (int x = 0; x < samples_; ++x) ++counts[at[x]];
      }
      pixels[column] = mixed(counts);
    }
  }

  std::uint32_t mixed(const std::array<int, 256>& counts) const {
    Light sum{0, 0, 0};
    for (std::size_t pen = 0; pen < lights_.size(); ++pen) {
      sum.red += counts[pen] * lights_[pen].red;
      sum.green += counts[pen] * lights_[pen].green;
      sum.blue += counts[pen] * lights_[pen].blue;
    }
    const double all = samples_ * samples_;
    return encoded(sum.red / all) << 16 | encoded(sum.green / all) << 8 | encoded(sum.blue / all);
  }

  MachineProfile machine_;
  std::filesystem::path file_;
  int width_ = 0, height_ = 0, samples_ = 1;
  std::vector<Light> lights_;  ///< paper, then the pens
  Surface surface_;
  Context context_;
};

}  // namespace

std::unique_ptr<Sheet> png_sheet(const MachineProfile& machine, double dpi,
                                 const std::filesystem::path& file) {
  return std::make_unique<PngSheet>(machine, dpi, file);
}

}  // namespace overstrike::emulator
