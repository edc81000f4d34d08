#include "devices/line_printer/glyph_ink.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/error.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace overstrike {
namespace {

/// Of a cell: a character that spills more into its neighbours is not used. A tenth of a step of
/// the default table.
constexpr double kMostSpill = 0.005;
/// A font whose glyphs reach further than so many cells is broken.
constexpr int kMostReach = 64;
constexpr int kFewestRows = 32, kMostRows = 384;
constexpr double kTypicalMiddle = 0.36;  // half of usual capitals, for fonts without an H
constexpr double kUnit = 64;             // FreeType's 26.6 fixed point

[[noreturn]] void reject(const Typeface& face, const std::string& message) {
  throw InputError(Place{face.font.string(), 0, 0}, message);
}

std::uint64_t bits_in_bytes(std::uint64_t word) {
  constexpr std::uint64_t k5 = 0x5555555555555555u, k3 = 0x3333333333333333u,
                          kF = 0x0F0F0F0F0F0F0F0Fu;
  word -= (word >> 1) & k5;
  word = (word & k3) + ((word >> 2) & k3);
  return (word + (word >> 4)) & kF;
}

int sum_of_bytes(std::uint64_t word) {
  constexpr std::uint64_t kLow = 0x00FF00FF00FF00FFu;
  return static_cast<int>((((word & kLow) + (word >> 8 & kLow)) * 0x0001000100010001u) >> 48);
}

/// Where in x a row's samples lie: one of so many places across the pixel, a power of two.
constexpr int kTurns = 8;
int turn_of(int row) { return row * 5 & (kTurns - 1); }

/// How much a sheared outline rises per pixel of x, in 1/65536: the golden section, so that any run
/// of columns takes its samples at well spread heights.
constexpr int kRise = 40503;
/// Whole pixels risen at the middle of the turn `x`.
int whole_rise(int x) {
  static_assert(kTurns == 8);
  return static_cast<int>((std::int64_t{2 * x + 1} * kRise) >> (16 + 1 + 3));
}

/// A raster of bits; 0 outside.
struct Bitmap {
  int width, height, pitch;
  std::vector<unsigned char> bytes;
  /// y upwards.
  bool at(int x, int y) const {
    if (x < 0 || y < 0 || x >= width || y >= height) return false;
    return bytes[static_cast<std::size_t>(height - 1 - y) * pitch + x / 8] >> (7 - x % 8) & 1;
  }
};

/// The font at the size of a cell's pixels.
class Font {
 public:
  Font(const Typeface& face, double cpi, double lpi)
      : rows_(std::clamp(static_cast<int>(std::lround(kCellWidth * cpi / lpi)), kFewestRows,
                         kMostRows)) {
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library)) reject(face, "FreeType does not start");
    library_.reset(library);
    FT_Face opened = nullptr;
    if (FT_New_Face(library, face.font.c_str(), 0, &opened)) reject(face, "not a font file");
    face_.reset(opened);
    if (!FT_IS_SCALABLE(opened)) reject(face, "a font of fixed size: expected one with outlines");
    const double em_in = face.points * (10 / cpi) / 72;
    const double em_x = em_in * kCellWidth * cpi, em_y = em_in * rows_ * lpi;
    if (FT_Set_Char_Size(opened, std::lround(em_x * kUnit), std::lround(em_y * kUnit), 72, 72))
      reject(face, "the font cannot be scaled");
    const double middle =
        face.middle_em ? *face.middle_em * em_y * kUnit : middle_of_capitals(em_y * kUnit);
    baseline_ = std::lround(rows_ * kUnit / 2 - middle);
  }

  int cell_pixels() const { return kCellWidth * rows_; }

  /// None when the font lacks the character.
  std::optional<Glyph> measure(const Typeface& face, char character) {
    if (!load(character)) return std::nullopt;
    FT_Outline& outline = face_->glyph->outline;
    const double advance = face_->glyph->linearHoriAdvance / 65536.0 * kUnit;
    FT_Outline_Translate(&outline, std::lround((kCellWidth * kUnit - advance) / 2), baseline_);
    const Box box = box_of(outline);
    if (box.width() > kMostReach * kCellWidth || box.height() > kMostReach * rows_)
      reject(face, std::string("the glyph of '") + character + "' is broken: it is too large");
    Glyph glyph{character, Ink(cell_pixels()), 0, 0};
    scan(outline, box, glyph);
    glyph.count = glyph.ink.count();
    return glyph;
  }

 private:
  /// Whole pixels, half-open; y upwards.
  struct Box {
    int left, bottom, right, top;
    int width() const { return right - left; }
    int height() const { return top - bottom; }
  };

  static Box box_of(FT_Outline& outline) {
    FT_BBox box;
    FT_Outline_Get_CBox(&outline, &box);
    const auto pixel = [](FT_Pos position) { return static_cast<int>(position >> 6); };
    return {pixel(box.xMin), pixel(box.yMin), pixel(box.xMax) + 1, pixel(box.yMax) + 1};
  }

  bool load(char character) {
    const FT_UInt index = FT_Get_Char_Index(face_.get(), static_cast<unsigned char>(character));
    return index != 0 && FT_Load_Glyph(face_.get(), index, FT_LOAD_NO_HINTING) == 0 &&
           face_->glyph->format == FT_GLYPH_FORMAT_OUTLINE;
  }

  double middle_of_capitals(double em) {
    return load('H') ? face_->glyph->metrics.horiBearingY / 2.0 : kTypicalMiddle * em;
  }

  /// Each pixel is one sample, at a place of its own inside it: rows take turns among kTurns
  /// places in x, columns among many in y. Were all in the middle, a stem would gain or lose a
  /// whole pixel of width along its height; so the count is right to a small part of a pixel, and
  /// unions stay exact, because all glyphs are sampled at the same places.
  ///
  /// In y it is done by a shear: the outline rises by kRise per pixel of x, and what is whole in
  /// the rise is taken back by choosing the row.
  void scan(FT_Outline& outline, const Box& cells, Glyph& glyph) {
    const FT_Matrix sheared{kTurns * 0x10000, 0, kRise, 0x10000};
    FT_Outline_Transform(&outline, &sheared);
    FT_Outline_Translate(&outline, 0, -static_cast<FT_Pos>(kUnit / 2));
    const Box box = box_of(outline);
    const Bitmap bitmap = draw(outline, box);
    for (int row = cells.bottom; row < cells.top; ++row)
      for (int column = cells.left; column < cells.right; ++column) {
        const int x = column * kTurns + turn_of(row);
        const int y = row + whole_rise(x);
        if (bitmap.at(x - box.left, y - box.bottom)) put(glyph, column, row);
      }
  }

  /// The outline inside the box.
  Bitmap draw(FT_Outline& outline, const Box& box) {
    Bitmap drawn{box.width(), box.height(), (box.width() + 7) / 8, {}};
    drawn.bytes.resize(static_cast<std::size_t>(drawn.pitch) * drawn.height);
    FT_Outline_Translate(&outline, static_cast<FT_Pos>(-box.left * kUnit),
                         static_cast<FT_Pos>(-box.bottom * kUnit));
    FT_Bitmap target{};
    target.width = drawn.width, target.rows = drawn.height, target.pitch = drawn.pitch;
    target.buffer = drawn.bytes.data(), target.pixel_mode = FT_PIXEL_MODE_MONO;
    FT_Outline_Get_Bitmap(library_.get(), &outline, &target);
    return drawn;
  }

  /// x to the right, y up, from the cell's lower left corner.
  void put(Glyph& glyph, int x, int y) const {
    const auto wrapped = [](int v, int size) { return ((v % size) + size) % size; };
    const int column = wrapped(x, kCellWidth), row = wrapped(y, rows_);
    glyph.spilt += column != x || row != y;
    glyph.ink.add(row * kCellWidth + column);
  }

  struct Close {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    void operator()(FT_Face face) const { FT_Done_Face(face); }
  };
  std::unique_ptr<FT_LibraryRec_, Close> library_;
  std::unique_ptr<FT_FaceRec_, Close> face_;
  int rows_;
  FT_Pos baseline_ = 0;  // above the cell's lower edge, in 26.6 pixels
};

}  // namespace

void Ink::add(const Ink& other) {
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
}

int Ink::count() const { return count_with(*this); }

int Ink::count_with(const Ink& other) const {
  const std::uint64_t* a = words_.data();
  const std::uint64_t* b = other.words_.data();
  const std::size_t size = words_.size();
  int total = 0;
  // Bytes hold at most 8 a word: 31 words fit one byte-wise sum.
  for (std::size_t i = 0; i < size;) {
    std::uint64_t bytes = 0;
    for (const std::size_t end = std::min(size, i + 31); i < end; ++i)
      bytes += bits_in_bytes(a[i] | b[i]);
    total += sum_of_bytes(bytes);
  }
  return total;
}

Alphabet measure_alphabet(const Typeface& face, std::string_view characters, double cpi,
                          double lpi) {
  Font font(face, cpi, lpi);
  Alphabet alphabet{font.cell_pixels(), {}};
  for (const char character : characters) {
    std::optional<Glyph> glyph = font.measure(face, character);
    if (glyph && glyph->count > 0) alphabet.glyphs.push_back(*std::move(glyph));
  }
  if (alphabet.glyphs.empty()) reject(face, "the font has none of the characters to print with");
  const auto spills = [&](const Glyph& g) { return g.spilt > kMostSpill * alphabet.cell_pixels; };
  const auto spilling = std::count_if(alphabet.glyphs.begin(), alphabet.glyphs.end(), spills);
  if (2 * spilling <= static_cast<std::ptrdiff_t>(alphabet.glyphs.size()))
    std::erase_if(alphabet.glyphs, spills);
  return alphabet;
}

}  // namespace overstrike
