#pragma once
// What strikes: the type face at its size, on a Cairo context.
#include <cairo.h>

#include <array>
#include <exception>
#include <memory>
#include <vector>

#include "emulators/line_printer/carriage.h"
#include "emulators/output_file.h"

namespace overstrike::emulator {

struct FreePrinterCairo {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_font_face_t* face) const { cairo_font_face_destroy(face); }
  void operator()(cairo_scaled_font_t* font) const { cairo_scaled_font_destroy(font); }
};
using PrinterSurface = std::unique_ptr<cairo_surface_t, FreePrinterCairo>;
using PrinterContext = std::unique_ptr<cairo_t, FreePrinterCairo>;

/// Throws OutputError with Cairo's message unless all is well.
void check_printer(cairo_status_t status);

/// The glyphs of the type face, unhinted, and where they stand on the paper; lengths in dots.
class TypeElement {
 public:
  TypeElement(const LinePrinterOptions& options, double dots_per_inch);

  double width() const;                    ///< of the paper
  double height(std::size_t lines) const;  ///< of a page
  /// The glyphs of line `number`; a character that the font lacks leaves none.
  const std::vector<cairo_glyph_t>& place(const PrintedLine& line, std::size_t number);
  void use_on(cairo_t* context) const { cairo_set_scaled_font(context, font_.get()); }

 private:
  struct Slug {
    unsigned long index = 0;  ///< 0: the font lacks it
    double shift = 0;         ///< from the column's left edge to the glyph's origin
  };

  double pitch_x_, pitch_y_, margin_, columns_;
  double baseline_ = 0;  ///< below the top of the line
  std::unique_ptr<cairo_scaled_font_t, FreePrinterCairo> font_;
  std::array<Slug, 128> slugs_{};
  std::vector<cairo_glyph_t> glyphs_;
};

/// Cairo's writer to an OutputFile; an exception is kept until settle().
struct PrinterOutput {
  explicit PrinterOutput(const std::filesystem::path& path) : file(path) {}
  static cairo_status_t write(void* self, const unsigned char* bytes, unsigned count);
  void settle(cairo_status_t status) const;
  OutputFile file;
  std::exception_ptr failure;
};

}  // namespace overstrike::emulator
