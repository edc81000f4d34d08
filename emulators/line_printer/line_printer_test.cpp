#include "emulators/line_printer/line_printer.h"

#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>

namespace overstrike::emulator {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for every test.
class EmulatedPrinter : public testing::Test {
 protected:
  EmulatedPrinter() { fs::create_directory(folder_); }
  ~EmulatedPrinter() override { fs::remove_all(folder_); }

  LinePrinterReport print(std::string_view bytes, const std::string& name,
                          const LinePrinterOptions& options = {}) {
    return emulate_line_printer(bytes, options, folder_ / name);
  }
  std::string error_of(std::string_view bytes, const std::string& name,
                       const LinePrinterOptions& options = {}) {
    try {
      print(bytes, name, options);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      names.push_back(entry.path().filename().string());
    return names;
  }
  std::string content(const std::string& name) const {
    std::ifstream in(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_ =
      fs::temp_directory_path() / ("emulated_printer." + std::to_string(::getpid()) + "." +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
};

/// A PNG read back: ink is 1 - reflected light.
class Picture {
 public:
  explicit Picture(const fs::path& file)
      : surface_(cairo_image_surface_create_from_png(file.c_str())) {
    for (int value = 0; value < 256; ++value) {
      const double v = value / 255.0;
      ink_[value] = 1 - (v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
  }
  ~Picture() { cairo_surface_destroy(surface_); }
  Picture(const Picture&) = delete;
  int width() const { return cairo_image_surface_get_width(surface_); }
  int height() const { return cairo_image_surface_get_height(surface_); }
  /// The average over whole pixels.
  double ink(int x, int y, int wide, int high) const {
    const unsigned char* data = cairo_image_surface_get_data(surface_);
    double sum = 0;
    for (int row = y; row < y + high; ++row)
      for (int column = x; column < x + wide; ++column)
        sum += ink_[data[row * cairo_image_surface_get_stride(surface_) + 4 * column]];
    return sum / (wide * high);
  }

 private:
  cairo_surface_t* surface_;
  double ink_[256];
};

/// Cells of 24 x 30 dots and no margin: 240 dots to the inch, 10 characters, 8 lines.
LinePrinterOptions whole_cells(int columns) {
  LinePrinterOptions options;
  options.dpi = 240, options.lpi = 8, options.columns = columns, options.margin_in = 0;
  return options;
}

TEST_F(EmulatedPrinter, PaperIsAsLargeAsColumnsAndLines) {
  print("A\nB\nC\n", "page.png");
  const Picture page(folder_ / "page.png");
  EXPECT_EQ(page.width(), std::ceil((13.6 + 1) * 144));
  EXPECT_EQ(page.height(), (0.5 + 1) * 144);
  EXPECT_EQ(page.ink(0, 0, page.width(), 72), 0);
  EXPECT_EQ(page.ink(0, 144, page.width(), 72), 0);
  EXPECT_EQ(page.ink(0, 0, 72, page.height()), 0);
  EXPECT_GT(page.ink(72, 72, 15, 24), 0.1);
}

// A hyphen is a rectangle of 521 x 164 units of 2048 an em; a cell at 10 by 8 to the inch is 0.6 by
// 0.75 ems. Its middle is 0.3645 - 561/2048 ems below the middle of the line.
TEST_F(EmulatedPrinter, InkIsTheGlyphsArea) {
  print("-", "page.png", whole_cells(1));
  const Picture page(folder_ / "page.png");
  EXPECT_NEAR(page.ink(0, 0, 24, 30), 521.0 * 164.0 / (2048 * 2048 * 0.6 * 0.75), 0.001);
  EXPECT_EQ(page.ink(0, 0, 24, 15), 0);
  EXPECT_GT(page.ink(8, 18, 8, 2), 0.99);
}

TEST_F(EmulatedPrinter, InkIsAUnion) {
  print("M W\rM W\rM W\n", "again.png", whole_cells(3));
  print("M W\n", "once.png", whole_cells(3));
  EXPECT_EQ(content("again.png"), content("once.png"));
  print("M\r#\rW\r0\n", "many.png", whole_cells(1));
  print("M\n", "one.png", whole_cells(1));
  const Picture many(folder_ / "many.png"), one(folder_ / "one.png");
  EXPECT_NEAR(one.ink(0, 0, 24, 30), 0.4291, 0.002);  // the outline's area
  EXPECT_GT(many.ink(0, 0, 24, 30), 0.80);
  EXPECT_LT(many.ink(0, 0, 24, 30), 0.87);
}

TEST_F(EmulatedPrinter, StreamsSayTheSamePage) {
  LinePrinterOptions asa = whole_cells(4);
  asa.stream = "asa";
  print("AB\r #\n\nC", "cr.png", whole_cells(4));
  print(" AB\n+ #\n \n C\n", "asa.png", asa);
  EXPECT_EQ(content("cr.png"), content("asa.png"));
  print("AB\b#\n\nC\n\f", "bs.png", whole_cells(4));
  EXPECT_EQ(content("cr.png"), content("bs.png"));
}

TEST_F(EmulatedPrinter, PagesAreNumbered) {
  EXPECT_EQ(print("A\fB\fC", "page.png").pages, 3u);
  EXPECT_THAT(files(), testing::UnorderedElementsAre("page.png", "page-2.png", "page-3.png"));
  print("B", "b.png");
  EXPECT_EQ(content("page-2.png"), content("b.png"));
}

TEST_F(EmulatedPrinter, APdfHasAllPagesAndTheSameBytesAgain) {
  print("A\fB\fC", "a.pdf");
  print("A\fB\fC", "b.PDF");
  EXPECT_THAT(files(), testing::UnorderedElementsAre("a.pdf", "b.PDF"));
  const std::string pdf = content("a.pdf");
  EXPECT_THAT(pdf, testing::StartsWith("%PDF-"));
  EXPECT_THAT(pdf, testing::HasSubstr("/Count 3"));
  EXPECT_EQ(pdf, content("b.PDF"));
}

TEST_F(EmulatedPrinter, EveryByteIsTaken) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  std::mt19937 random(11);
  for (int i = 0; i < 20000; ++i) bytes += static_cast<char>(random() % 256);
  for (const char* stream : {"cr", "plain", "asa"}) {
    LinePrinterOptions options;
    options.stream = stream, options.dpi = 10;
    const LinePrinterReport report = print(bytes, "any.pdf", options);
    EXPECT_GT(report.strikes, 5000u);
    EXPECT_GT(report.unprintable, 5000u);
    EXPECT_EQ(report.warnings.back(), std::to_string(report.unprintable) +
                                          " bytes are neither characters nor known controls");
  }
}

TEST_F(EmulatedPrinter, LongLinesAndManyLinesStayBounded) {
  const LinePrinterReport report = print(std::string(10'000'000, 'M'), "long.png");
  EXPECT_EQ(report.beyond, 10'000'000u - 136u);
  EXPECT_THAT(report.warnings,
              testing::ElementsAre("9999864 characters struck right of the carriage are lost"));
  const std::string many(100'000, '\n');
  EXPECT_EQ(error_of(many, "many.png"),
            "page 1 has more than 1359 lines, the most that such paper takes");
  EXPECT_EQ(error_of(many, "many.pdf"),
            "page 1 has more than 1194 lines, the most that such paper takes");
  EXPECT_EQ(error_of(std::string(501, '\f'), "forms.png"), "more than 500 pages: expected a PDF");
  EXPECT_EQ(error_of(std::string(10'001, '\f'), "forms.pdf"), "more than 10000 pages");
  EXPECT_THAT(files(), testing::ElementsAre("long.png"));
}

TEST_F(EmulatedPrinter, TheLongestPageOfAPngIsPrinted) {
  const LinePrinterReport report = print(std::string(1359, '\n'), "long.png");
  EXPECT_EQ(report.lines, 1359u);
  EXPECT_EQ(Picture(folder_ / "long.png").height(), 1360 * 24 + 120);
}

TEST_F(EmulatedPrinter, WrongOptionsAreErrors) {
  const auto with = [](auto set) {
    LinePrinterOptions options;
    set(options);
    return options;
  };
  EXPECT_EQ(error_of("A", "a.png", with([](auto& o) { o.lpi = 0; })),
            "lpi must be between 1 and 24, found 0");
  EXPECT_EQ(error_of("A", "a.png", with([](auto& o) { o.cpi = 25; })),
            "cpi must be between 1 and 24, found 25");
  EXPECT_EQ(error_of("A", "a.png", with([](auto& o) { o.dpi = 5; })),
            "dpi must be between 10 and 600, found 5");
  EXPECT_EQ(error_of("A", "a.png", with([](auto& o) { o.dpi = std::nan(""); })),
            "dpi must be between 10 and 600, found nan");
  EXPECT_EQ(error_of("A", "a.png", with([](auto& o) { o.columns = 0; })),
            "columns must be between 1 and 1024, found 0");
  EXPECT_EQ(error_of("A", "a.png", with([](auto& o) { o.stream = "hpgl"; })),
            "stream must be one of cr, plain, asa, found 'hpgl'");
  EXPECT_THAT(error_of("A", "a.png", with([](auto& o) { o.typeface = "none"; })),
              testing::HasSubstr("typefaces/none.typeface"));
  EXPECT_EQ(error_of("A", "a.png", with([](auto& o) { o.typeface = "./none.ttf"; })),
            "./none.ttf: no such font file");
  EXPECT_EQ(
      error_of("A", "a.png", with([](auto& o) { o.typeface = OVERSTRIKE_SOURCE_DIR "/LICENSE"; })),
      OVERSTRIKE_SOURCE_DIR "/LICENSE: not a font file");
  EXPECT_EQ(error_of("A", "a.png", with([](auto& o) { o.columns = 1024, o.cpi = 1, o.dpi = 600; })),
            "paper 615000 dots wide is more than a PNG takes");
  EXPECT_THAT(error_of("A", "a.gif"), testing::StartsWith("paper is .png or .pdf, found '"));
  EXPECT_THAT(files(), testing::IsEmpty());
}

TEST_F(EmulatedPrinter, PaperThatCannotBeWrittenIsAnError) {
  for (const char* name : {"none/a.png", "none/a.pdf"})
    EXPECT_THROW(print("A", name), OutputError) << name;
  EXPECT_THAT(files(), testing::IsEmpty());
}

}  // namespace
}  // namespace overstrike::emulator
