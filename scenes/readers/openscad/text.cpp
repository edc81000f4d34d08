#include "scenes/readers/openscad/text.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_BBOX_H
#include FT_OUTLINE_H
#include <hb-ft.h>

#include <algorithm>
#include <memory>

#include "scenes/readers/openscad/fonts.h"

namespace overstrike::openscad {
namespace {

/// OpenSCAD's units: a size of 1 is so many 26.6 units of type at 100 dots to the inch, so that an
/// em is 100/72. Hints act at that size, as in OpenSCAD.
constexpr FT_F26Dot6 kUnits = 100000;
constexpr FT_UInt kDotsPerInch = 100;
/// Advances and heights are 1000/1024 of what they are in glyphs (OpenSCAD up to 2021.01 divides
/// 26.6 numbers of a thousandth by 1024).
constexpr double kAdvance = 1000.0 / 1024;

struct Close {
  void operator()(FT_Face face) const { FT_Done_Face(face); }
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
  void operator()(hb_font_t* font) const { hb_font_destroy(font); }
  void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
};
template <class T>
using Owned = std::unique_ptr<std::remove_pointer_t<T>, Close>;

struct Font {
  Owned<FT_Library> library;
  Owned<FT_Face> face;

  explicit Font(const FontFile& file) {
    FT_Library new_library = nullptr;
    FT_Face new_face = nullptr;
    if (FT_Init_FreeType(&new_library) != 0) return;
    library.reset(new_library);
    if (FT_New_Face(new_library, file.path.c_str(), file.index, &new_face) != 0) return;
    face.reset(new_face);
    if (FT_Set_Char_Size(new_face, 0, kUnits, kDotsPerInch, kDotsPerInch) != 0) face.reset();
  }
};

/// Collects outlines, curves in equal steps of their parameter.
class Tracer {
 public:
  Tracer(int steps, double unit) : steps_(steps), unit_(unit) {}

  Region trace(FT_Outline& outline, const Vec2& offset) {
    region_ = {};
    offset_ = offset;
    FT_Outline_Funcs calls{};
    calls.move_to = [](const FT_Vector* to, void* self) { return of(self).move(*to); };
    calls.line_to = [](const FT_Vector* to, void* self) { return of(self).line(*to); };
    calls.conic_to = [](const FT_Vector* c, const FT_Vector* to, void* self) {
      return of(self).conic(of(self).at(*c), of(self).at(*to));
    };
    calls.cubic_to = [](const FT_Vector* c, const FT_Vector* d, const FT_Vector* to, void* self) {
      return of(self).cubic(of(self).at(*c), of(self).at(*d), of(self).at(*to));
    };
    FT_Outline_Decompose(&outline, &calls, this);
    std::erase_if(region_.loops, [](const auto& loop) { return loop.size() < 3; });
    return std::move(region_);
  }

 private:
  static Tracer& of(void* self) { return *static_cast<Tracer*>(self); }
  Vec2 at(const FT_Vector& v) const {
    return Vec2(static_cast<double>(v.x), static_cast<double>(v.y)) * unit_;
  }
  void add(const Vec2& p) { region_.loops.back().push_back(p + offset_); }

  int move(const FT_Vector& to) {
    region_.loops.emplace_back();
    return line(to);
  }
  int line(const FT_Vector& to) {
    pen_ = at(to);
    add(pen_);
    return 0;
  }
  int conic(const Vec2& c, const Vec2& to) {
    for (int i = 1; i <= steps_; ++i) {
      const double t = static_cast<double>(i) / steps_, s = 1 - t;
      add(pen_ * (s * s) + c * (2 * s * t) + to * (t * t));
    }
    pen_ = to;
    return 0;
  }
  int cubic(const Vec2& c, const Vec2& d, const Vec2& to) {
    for (int i = 1; i <= steps_; ++i) {
      const double t = static_cast<double>(i) / steps_, s = 1 - t;
      add(pen_ * (s * s * s) + c * (3 * s * s * t) + d * (3 * s * t * t) + to * (t * t * t));
    }
    pen_ = to;
    return 0;
  }

  int steps_;
  double unit_;
  Vec2 offset_{0.0}, pen_{0.0};
  Region region_;
};

struct Glyph {
  Index number;
  Vec2 advance, offset;
};

Owned<hb_buffer_t*> shaped(const Arguments& a, const std::string& text, FT_Face face) {
  Owned<hb_buffer_t*> buffer(hb_buffer_create());
  hb_buffer_set_direction(buffer.get(),
                          hb_direction_from_string(a.text("direction", "ltr").c_str(), -1));
  hb_buffer_set_script(buffer.get(), hb_script_from_string(a.text("script", "latn").c_str(), -1));
  hb_buffer_set_language(buffer.get(),
                         hb_language_from_string(a.text("language", "en").c_str(), -1));
  hb_buffer_add_utf8(buffer.get(), text.data(), static_cast<int>(text.size()), 0, -1);
  hb_buffer_guess_segment_properties(buffer.get());
  const Owned<hb_font_t*> font(hb_ft_font_create(face, nullptr));
  hb_shape(font.get(), buffer.get(), nullptr, 0);
  return buffer;
}

std::vector<Glyph> glyphs_of(hb_buffer_t* buffer, double unit) {
  unsigned count = 0;
  const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(buffer, &count);
  const hb_glyph_position_t* const places = hb_buffer_get_glyph_positions(buffer, &count);
  std::vector<Glyph> glyphs(count);
  for (unsigned i = 0; i < count; ++i)
    glyphs[i] = {infos[i].codepoint, Vec2(places[i].x_advance, places[i].y_advance) * unit,
                 Vec2(places[i].x_offset, places[i].y_offset) * unit};
  return glyphs;
}

/// How large the line is, for its alignment.
struct Extent {
  double width = 0, above = 0, below = 0;
};

Extent extent_of(const std::vector<Glyph>& glyphs, const Font& font, double unit, double spacing,
                 bool horizontal) {
  Extent extent;
  for (const Glyph& glyph : glyphs) {
    if (FT_Load_Glyph(font.face.get(), glyph.number, FT_LOAD_NO_BITMAP) != 0) continue;
    FT_BBox box;
    FT_Outline_Get_CBox(&font.face->glyph->outline, &box);
    box.yMax = (box.yMax + 63) & ~63, box.yMin &= ~63;  // to whole dots
    if (horizontal) {
      extent.width += glyph.advance.x * spacing;
      extent.above = std::fmax(extent.above, static_cast<double>(box.yMax) * unit * kAdvance);
      extent.below = std::fmax(extent.below, -static_cast<double>(box.yMin) * unit * kAdvance);
    } else {
      extent.width = std::fmax(extent.width, static_cast<double>(box.xMax - box.xMin) * unit);
      extent.above += glyph.advance.y * spacing;
    }
  }
  return extent;
}

Vec2 alignment(const Arguments& a, const Extent& extent) {
  const std::string across = a.text("halign", "left"), up = a.text("valign", "baseline");
  Vec2 offset(0.0);
  if (across == "right") offset.x = -extent.width;
  if (across == "center") offset.x = -extent.width / 2;
  if (up == "top") offset.y = -extent.above;
  if (up == "center") offset.y = (extent.below - extent.above) / 2;
  if (up == "bottom") offset.y = extent.below;
  return offset;
}

/// Fontconfig's answer, and what to say of it.
FontFile font_for(const Arguments& a) {
  const std::string wanted = a.text("font", "");
  FontFile file = find_font(wanted);
  if (file.path.empty()) a.error("there is no outline font to draw text with");
  if (file.substitute)
    a.reporter().warning(a.at(),
                         "no font " + in_quotes(wanted) + ": drawn with " + in_quotes(file.family));
  return file;
}

}  // namespace

std::vector<Region> text_outlines(const Arguments& a) {
  const std::string text = a.text("text", "");
  const double size = a.number("size", 10), spacing = a.number("spacing", 1);
  if (text.empty() || !(size > 0) || !std::isfinite(size) || !std::isfinite(spacing)) return {};
  const FontFile file = font_for(a);
  if (file.path.empty()) return {};
  const Font font(file);
  if (!font.face) {
    a.error("cannot use the font " + in_quotes(file.path));
    return {};
  }
  const double unit = size / kUnits;
  const Owned<hb_buffer_t*> line = shaped(a, text, font.face.get());
  const std::vector<Glyph> glyphs = glyphs_of(line.get(), unit * kAdvance);
  const bool horizontal = HB_DIRECTION_IS_HORIZONTAL(hb_buffer_get_direction(line.get()));
  Vec2 pen = alignment(a, extent_of(glyphs, font, unit, spacing, horizontal));
  Tracer tracer(std::max(a.fragments(size) / 8 + 1, 2), unit);
  std::vector<Region> regions;
  for (const Glyph& glyph : glyphs) {
    if (FT_Load_Glyph(font.face.get(), glyph.number, FT_LOAD_NO_BITMAP) != 0) continue;
    Region region = tracer.trace(font.face->glyph->outline, pen + glyph.offset);
    if (!region.loops.empty()) regions.push_back(std::move(region));
    pen += glyph.advance * spacing;
  }
  return regions;
}

}  // namespace overstrike::openscad
