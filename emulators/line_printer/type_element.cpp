#include "emulators/line_printer/type_element.h"

#include <cairo-ft.h>

#include <string>

#include "emulators/line_printer/printer_typeface.h"

namespace overstrike::emulator {
namespace {

using FontFace = std::unique_ptr<cairo_font_face_t, FreePrinterCairo>;

/// A FreeType face and the library that it lives in.
struct FontFile {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  ~FontFile() {
    if (face) FT_Done_Face(face);
    if (library) FT_Done_FreeType(library);
  }
};

/// Cairo keeps scaled fonts for later; the file closes with the last of them.
FontFace open_font(const std::filesystem::path& path) {
  auto file = std::make_unique<FontFile>();
  if (FT_Init_FreeType(&file->library) || FT_New_Face(file->library, path.c_str(), 0, &file->face))
    throw Error(path.string() + ": not a font file");
  if (!FT_IS_SCALABLE(file->face))
    throw Error(path.string() + ": a font of fixed size: expected one with outlines");
  FontFace face(cairo_ft_font_face_create_for_ft_face(file->face, 0));
  static const cairo_user_data_key_t kKey{};
  check_printer(cairo_font_face_set_user_data(
      face.get(), &kKey, file.get(), [](void* opened) { delete static_cast<FontFile*>(opened); }));
  (void)file.release();  // now the face's
  return face;
}

}  // namespace

void check_printer(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw OutputError(std::string("the paper cannot be drawn: ") + cairo_status_to_string(status));
}

TypeElement::TypeElement(const LinePrinterOptions& options, double dots_per_inch)
    : pitch_x_(dots_per_inch / options.cpi),
      pitch_y_(dots_per_inch / options.lpi),
      margin_(dots_per_inch * options.margin_in),
      columns_(options.columns) {
  const PrinterTypeface typeface = find_printer_typeface(options.typeface);
  const FontFace face = open_font(typeface.font);
  const double em = typeface.points * (10 / options.cpi) / 72 * dots_per_inch;
  cairo_matrix_t size, identity;
  cairo_matrix_init_scale(&size, em, em);
  cairo_matrix_init_identity(&identity);
  cairo_font_options_t* hints = cairo_font_options_create();
  cairo_font_options_set_hint_style(hints, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(hints, CAIRO_HINT_METRICS_OFF);
  font_.reset(cairo_scaled_font_create(face.get(), &size, &identity, hints));
  cairo_font_options_destroy(hints);
  check_printer(cairo_scaled_font_status(font_.get()));

  FT_Face letters = cairo_ft_scaled_font_lock_face(font_.get());
  if (!letters) throw Error(typeface.font.string() + ": the font cannot be scaled");
  for (unsigned char c = '!'; c <= '~'; ++c) slugs_[c].index = FT_Get_Char_Index(letters, c);
  cairo_ft_scaled_font_unlock_face(font_.get());
  const auto extents_of = [&](unsigned char c) {
    const cairo_glyph_t glyph{slugs_[c].index, 0, 0};
    cairo_text_extents_t extents;
    cairo_scaled_font_glyph_extents(font_.get(), &glyph, 1, &extents);
    return extents;
  };
  for (unsigned char c = '!'; c <= '~'; ++c)
    slugs_[c].shift = (pitch_x_ - extents_of(c).x_advance) / 2;
  const double middle =
      typeface.middle_em ? *typeface.middle_em * em : -extents_of('H').y_bearing / 2;
  baseline_ = pitch_y_ / 2 + middle;
}

double TypeElement::width() const { return 2 * margin_ + columns_ * pitch_x_; }

double TypeElement::height(std::size_t lines) const {
  return 2 * margin_ + static_cast<double>(lines) * pitch_y_;
}

const std::vector<cairo_glyph_t>& TypeElement::place(const PrintedLine& line, std::size_t number) {
  glyphs_.clear();
  const double y = margin_ + static_cast<double>(number) * pitch_y_ + baseline_;
  for (std::size_t column = 0; column < line.size(); ++column) {
    if (line[column].blank()) continue;
    const double x = margin_ + static_cast<double>(column) * pitch_x_;
    for (unsigned char c = '!'; c <= '~'; ++c)
      if (line[column].has(c) && slugs_[c].index != 0)
        glyphs_.push_back({slugs_[c].index, x + slugs_[c].shift, y});
  }
  return glyphs_;
}

cairo_status_t PrinterOutput::write(void* self, const unsigned char* bytes, unsigned count) {
  PrinterOutput& output = *static_cast<PrinterOutput*>(self);
  if (output.failure) return CAIRO_STATUS_WRITE_ERROR;
  try {
    output.file.write(bytes, count);
    return CAIRO_STATUS_SUCCESS;
  } catch (...) {
    output.failure = std::current_exception();
    return CAIRO_STATUS_WRITE_ERROR;
  }
}

void PrinterOutput::settle(cairo_status_t status) const {
  if (failure) std::rethrow_exception(failure);
  check_printer(status);
}

}  // namespace overstrike::emulator
