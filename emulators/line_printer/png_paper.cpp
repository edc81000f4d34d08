#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "emulators/line_printer/paper.h"
#include "emulators/line_printer/type_element.h"

namespace overstrike::emulator {
namespace {

constexpr double kLargestSide = 32767;   // Cairo's
constexpr double kMostDots = 1 << 28;    // a quarter of a gigabyte
constexpr std::size_t kMostFiles = 500;  // all are open until the last is drawn

/// The sRGB value of an amount of reflected light 0..1: how many of the borders half-way between
/// neighbouring values it reaches. With the curve ((v + 0.055) / 1.055)^2.4 (IEC 61966-2-1) a
/// border v is reached where the fifth power of the light reaches the twelfth of the bracket, so no
/// library's power function decides.
unsigned char srgb_of(double light) {
  int value = 0;
  for (; value < 255; ++value) {
    const double border = (value + 0.5) / 255, base = (border + 0.055) / 1.055;
    const double base3 = base * base * base, light2 = light * light;
    const bool reached = border <= 0.04045
                             ? border / 12.92 <= light
                             : base3 * base3 * base3 * base3 <= light2 * light2 * light;
    if (!reached) break;
  }
  return static_cast<unsigned char>(value);
}

std::array<unsigned char, 256> paper_under_ink() {
  std::array<unsigned char, 256> values{};
  for (int ink = 0; ink < 256; ++ink) values[ink] = srgb_of(1 - ink / 255.0);
  return values;
}

class PngPaper final : public Paper {
 public:
  PngPaper(const LinePrinterOptions& options, std::filesystem::path file)
      : type_(options, options.dpi), file_(std::move(file)), width_(std::ceil(type_.width())) {
    const double height = std::min(kLargestSide, std::floor(kMostDots / width_));
    if (width_ > kLargestSide || type_.height(1) > height)
      throw Error(fmt::format("paper {} dots wide is more than a PNG takes", width_));
    const double line = options.dpi / options.lpi;
    most_lines_ = 1 + static_cast<std::size_t>((height - std::ceil(type_.height(1))) / line);
  }

  std::size_t most_lines() const override { return most_lines_; }

  void page(const PrintedPage& page) override {
    if (pages_.size() == kMostFiles)
      throw Error(fmt::format("more than {} pages: expected a PDF", kMostFiles));
    const PrinterSurface surface(
        cairo_image_surface_create(CAIRO_FORMAT_A8, static_cast<int>(width_),
                                   static_cast<int>(std::ceil(type_.height(page.size())))));
    check_printer(cairo_surface_status(surface.get()));
    strike(page, surface.get());
    ink_to_paper(surface.get());
    pages_.push_back(std::make_unique<PrinterOutput>(name_of(pages_.size() + 1)));
    PrinterOutput* output = pages_.back().get();
    output->settle(cairo_surface_write_to_png_stream(surface.get(), PrinterOutput::write, output));
  }

  void finish() override {
    for (const auto& page : pages_) page->file.commit();
  }

 private:
  /// A line's ink is one path, filled once: a union, exact also where strikes share an edge.
  void strike(const PrintedPage& page, cairo_surface_t* surface) {
    const PrinterContext context(cairo_create(surface));
    type_.use_on(context.get());
    for (std::size_t number = 0; number < page.size(); ++number) {
      const std::vector<cairo_glyph_t>& glyphs = type_.place(page[number], number);
      if (glyphs.empty()) continue;
      cairo_glyph_path(context.get(), glyphs.data(), static_cast<int>(glyphs.size()));
      cairo_fill(context.get());
    }
    check_printer(cairo_status(context.get()));
  }

  /// Coverage of ink to the sRGB value of what the paper reflects.
  static void ink_to_paper(cairo_surface_t* surface) {
    static const std::array<unsigned char, 256> kPaper = paper_under_ink();
    cairo_surface_flush(surface);
    unsigned char* bytes = cairo_image_surface_get_data(surface);
    const std::ptrdiff_t count =
        static_cast<std::ptrdiff_t>(cairo_image_surface_get_stride(surface)) *
        cairo_image_surface_get_height(surface);
    std::transform(bytes, bytes + count, bytes, [](unsigned char ink) { return kPaper[ink]; });
    cairo_surface_mark_dirty(surface);
  }

  std::filesystem::path name_of(std::size_t page) const {
    if (page == 1) return file_;
    return file_.parent_path() /
           fmt::format("{}-{}{}", file_.stem().string(), page, file_.extension().string());
  }

  TypeElement type_;
  std::filesystem::path file_;
  double width_;
  std::size_t most_lines_ = 0;
  std::vector<std::unique_ptr<PrinterOutput>> pages_;
};

}  // namespace

std::unique_ptr<Paper> png_paper(const LinePrinterOptions& options,
                                 const std::filesystem::path& file) {
  return std::make_unique<PngPaper>(options, file);
}

}  // namespace overstrike::emulator
