#include "devices/line_printer/glyph_ink.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/error.h"

#include <ft2build.h>
#include FT_FREETYPE_H

namespace overstrike {
namespace {

const std::string kUpper64 = [] {
  std::string all;
  for (char c = 0x20; c < 0x60; ++c) all += c;
  return all;
}();

Alphabet measured(double cpi, double lpi, const std::string& characters = kUpper64) {
  return measure_alphabet(find_typeface("dejavu-sans-mono"), characters, cpi, lpi);
}

const Glyph* find(const Alphabet& alphabet, char character) {
  for (const Glyph& glyph : alphabet.glyphs)
    if (glyph.character == character) return &glyph;
  return nullptr;
}

TEST(Ink, CountsUnionsLikeASet) {
  std::mt19937 random(1);
  for (const int pixels : {1, 63, 64, 65, 2880, 5000}) {
    Ink a(pixels), b(pixels);
    std::set<int> in_a, in_either;
    for (int i = 0; i < pixels; ++i) {
      const int p = static_cast<int>(random() % pixels), q = static_cast<int>(random() % pixels);
      a.add(p), b.add(q);
      in_a.insert(p), in_either.insert(p), in_either.insert(q);
    }
    EXPECT_EQ(a.count(), static_cast<int>(in_a.size()));
    EXPECT_EQ(a.count_with(b), static_cast<int>(in_either.size()));
    a.add(b);
    EXPECT_EQ(a.count(), static_cast<int>(in_either.size()));
  }
}

TEST(Ink, CountsAFullCell) {
  Ink full(36864);
  for (int i = 0; i < 36864; ++i) full.add(i);
  EXPECT_EQ(full.count(), 36864);
}

/// The glyph's area in square ems, by FreeType's own anti-aliased rendering, large.
double area_of_outline(char character) {
  constexpr int kEm = 400;
  FT_Library library = nullptr;
  FT_Init_FreeType(&library);
  FT_Face face = nullptr;
  FT_New_Face(library, find_typeface("dejavu-sans-mono").font.c_str(), 0, &face);
  FT_Set_Char_Size(face, kEm * 64, kEm * 64, 72, 72);
  FT_Load_Char(face, static_cast<FT_ULong>(character), FT_LOAD_NO_HINTING);
  FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL);
  const FT_Bitmap& bitmap = face->glyph->bitmap;
  double sum = 0;
  for (unsigned y = 0; y < bitmap.rows; ++y)
    for (unsigned x = 0; x < bitmap.width; ++x)
      sum += bitmap.buffer[static_cast<int>(y) * bitmap.pitch + static_cast<int>(x)] / 255.0;
  FT_Done_Face(face);
  FT_Done_FreeType(library);
  return sum / (kEm * kEm);
}

// A cell at 10 characters and n lines to the inch is 0.6 ems wide and 6 / n high. 0.002 of a cell
// is a twentieth of a step of the default table.
TEST(GlyphInk, IsTheGlyphsAreaOverTheCells) {
  for (const double lpi : {8.0, 6.0}) {
    const Alphabet alphabet = measured(10, lpi);
    for (const Glyph& glyph : alphabet.glyphs)
      EXPECT_NEAR(static_cast<double>(glyph.count) / alphabet.cell_pixels,
                  area_of_outline(glyph.character) / (0.6 * 6 / lpi), 0.002)
          << glyph.character << " at " << lpi;
  }
}

TEST(GlyphInk, CellsHaveThePitchesShape) {
  EXPECT_EQ(measured(10, 8).cell_pixels, 96 * 120);
  EXPECT_EQ(measured(10, 6).cell_pixels, 96 * 160);
  EXPECT_EQ(measured(12, 6).cell_pixels, 96 * 192);
}

// The type follows the pitch: 12 to the inch by 9.6 looks as 10 by 8 does.
TEST(GlyphInk, DependsOnTheShapeOfTheCellOnly) {
  const Alphabet a = measured(10, 8), b = measured(12, 9.6);
  ASSERT_EQ(a.glyphs.size(), b.glyphs.size());
  for (std::size_t i = 0; i < a.glyphs.size(); ++i)
    EXPECT_EQ(a.glyphs[i].count, b.glyphs[i].count) << a.glyphs[i].character;
}

TEST(GlyphInk, CharactersThatReachIntoNeighboursAreLeftOut) {
  const Alphabet tight = measured(10, 8);
  for (const char c : std::string("@Q$,;()[]/\\_")) EXPECT_EQ(find(tight, c), nullptr) << c;
  for (const char c : std::string("M#0W8-.'")) EXPECT_NE(find(tight, c), nullptr) << c;
  const Alphabet loose = measured(10, 6);
  for (const char c : std::string("Q$,;()[]/\\M")) EXPECT_NE(find(loose, c), nullptr) << c;
  for (const Glyph& glyph : loose.glyphs) EXPECT_LE(glyph.spilt, 0.005 * loose.cell_pixels);
}

// Lines so narrow that nothing fits: all are used, and what falls outside counts wrapped round.
TEST(GlyphInk, WhereNothingFitsAllAreUsed) {
  const Alphabet alphabet = measured(10, 24);
  EXPECT_EQ(alphabet.glyphs.size(), 63u);
  const Glyph& m = *find(alphabet, 'M');
  EXPECT_GT(m.spilt, alphabet.cell_pixels / 4);
  EXPECT_GT(m.count, alphabet.cell_pixels / 2);
}

TEST(GlyphInk, BlanksAndMissingCharactersAreNoTones) {
  const Alphabet alphabet = measured(10, 8, " M\x7f");
  ASSERT_EQ(alphabet.glyphs.size(), 1u);
  EXPECT_EQ(alphabet.glyphs[0].character, 'M');
}

TEST(GlyphInk, BadFontsAreErrors) {
  const auto error_of = [](const std::filesystem::path& font, const std::string& characters) {
    try {
      measure_alphabet({"x", font, 12, {}}, characters, 10, 8);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const std::filesystem::path text = std::filesystem::path(OVERSTRIKE_SOURCE_DIR) / "LICENSE";
  EXPECT_EQ(error_of(text, "M"), text.string() + ": error: not a font file");
  const std::filesystem::path font = find_typeface("dejavu-sans-mono").font;
  EXPECT_EQ(error_of(font, " "),
            font.string() + ": error: the font has none of the characters to print with");
  EXPECT_EQ(error_of(font, "M"), "no error");
}

}  // namespace
}  // namespace overstrike
