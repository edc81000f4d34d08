#include "devices/line_printer/typeface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/error.h"

namespace overstrike {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::filesystem::path kFolder = OVERSTRIKE_SOURCE_DIR;

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string error_in(const std::string& text) {
  return error_of([&] { parse_typeface(text, kFolder / "x.typeface"); });
}

TEST(Typeface, TheDefaultOneIsThere) {
  const Typeface face = find_typeface("dejavu-sans-mono");
  EXPECT_EQ(face.name, "DejaVu Sans Mono");
  EXPECT_EQ(face.font.filename(), "DejaVuSansMono.ttf");
  EXPECT_EQ(face.points, 12);
  EXPECT_EQ(face.middle_em, 0.3645);
}

TEST(Typeface, TheFirstFontThatExistsIsTaken) {
  const Typeface face = parse_typeface(
      "# any\n\n font :  /nowhere/a.ttf\r\nfont: README.md.ttf\nfont: LICENSE\nfont: "
      "CMakeLists.txt\npoints: 9.5",
      kFolder / "own.typeface");
  EXPECT_EQ(face.font, kFolder / "LICENSE");
  EXPECT_EQ(face.name, "own");
  EXPECT_EQ(face.points, 9.5);
  EXPECT_FALSE(face.middle_em.has_value());
}

TEST(Typeface, ErrorsHaveTheirLine) {
  const std::string file = (kFolder / "x.typeface").string();
  EXPECT_EQ(error_in("name: X\nfont LICENSE\n"),
            file + ":2: error: found 'font LICENSE', expected 'key: value'");
  EXPECT_EQ(error_in("size: 12"),
            file + ":1: error: unknown key 'size' (known are name, font, points, middle)");
  EXPECT_EQ(error_in("\n\npoints: many"),
            file + ":3: error: points must be a number between 1 and 144, found 'many'");
  for (const char* bad : {"", "0", "145", "nan", "inf", "12pt", "-3"})
    EXPECT_EQ(error_in(std::string("points: ") + bad),
              file + ":1: error: points must be a number between 1 and 144, found '" + bad + "'");
  EXPECT_EQ(error_in("middle: 1.5"),
            file + ":1: error: middle must be a number between -1 and 1, found '1.5'");
}

TEST(Typeface, WithoutAFontSaysWhatWasSought) {
  EXPECT_THAT(error_in("font: /nowhere/a.ttf\nfont: /nowhere/b.ttf"),
              HasSubstr("none of its fonts is there: /nowhere/a.ttf /nowhere/b.ttf (DejaVu Sans "
                        "Mono is Debian's package fonts-dejavu-core"));
  EXPECT_THAT(error_in("name: X"), HasSubstr("it names no font"));
}

TEST(Typeface, NamesThatAreNoneSayWhatIsExpected) {
  EXPECT_THAT(error_of([] { find_typeface("comic"); }),
              StartsWith("error: typeface must be one of data/typefaces or a font file, found "
                         "'comic' ("));
  EXPECT_EQ(error_of([] { find_typeface("/nowhere/a.ttf"); }),
            "/nowhere/a.ttf: error: no such font file");
  EXPECT_EQ(error_of([] { find_typeface("a.ttf"); }), "a.ttf: error: no such font file");
}

TEST(Typeface, AFontFileIsAFace) {
  const std::string font = find_typeface("dejavu-sans-mono").font.string();
  const Typeface face = find_typeface(font);
  EXPECT_EQ(face.font, font);
  EXPECT_EQ(face.name, "DejaVuSansMono");
  EXPECT_EQ(face.points, 12);
}

}  // namespace
}  // namespace overstrike
