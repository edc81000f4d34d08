// Cells -> bytes -> emulated paper: the ink of every cell is the tone that was meant. Device and
// emulator share the type face's file and ASCII; each measures and draws with code of its own.
#include <cairo.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "devices/device.h"
#include "devices/line_printer/tone_table.h"
#include "emulators/line_printer/line_printer.h"

namespace overstrike {
namespace {

namespace fs = std::filesystem;

constexpr int kColumns = 40, kRows = 24, kLevels = 20;

/// How far a cell's printed ink may lie from its table's: the samples that the table counts are
/// right to 0.002 for a character (its own test) and eight bits of grey to another 0.002.
constexpr double kCellBound = 0.004;
/// On average over many cells rounding of both kinds cancels, but for a quarter.
constexpr double kMeanBound = 0.001;

struct Pitch {
  const char* lpi;
  int cell_high;  // dots, at 240 to the inch; cells are 24 wide
};
constexpr Pitch kPitches[] = {{"8", 30}, {"6", 40}};
constexpr int kCellWide = 24;

ToneTable table_of(const Pitch& pitch, int strikes) {
  std::string characters;
  for (char c = ' '; c <= '_'; ++c) characters += c;
  return make_tone_table(
      measure_alphabet(find_typeface("dejavu-sans-mono"), characters, 10, std::stod(pitch.lpi)),
      kLevels, strikes);
}

/// One level a cell, row by row.
using Levels = std::vector<int>;

std::string printed(const Levels& levels, const Pitch& pitch, const std::string& stream) {
  std::string bytes;
  const std::string size = std::to_string(kColumns) + "x" + std::to_string(kRows);
  const auto device =
      find_device("line-printer")
          ->make({{"size", size}, {"lpi", pitch.lpi}, {"stream", stream}}, "-", open_memory(bytes));
  device->begin();
  std::vector<float> row(kColumns);
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x)
      row[x] = static_cast<float>(levels[y * kColumns + x]) / (kLevels - 1);
    device->cells({y, row});
  }
  device->end();
  return bytes;
}

/// The ink of every cell, from the emulated paper's reflected light.
std::vector<double> ink_on_paper(const std::string& bytes, const Pitch& pitch,
                                 const std::string& stream) {
  const fs::path file =
      fs::temp_directory_path() / ("round_trip." + std::to_string(::getpid()) + ".png");
  emulator::LinePrinterOptions options;
  options.stream = stream, options.lpi = std::stod(pitch.lpi), options.columns = kColumns;
  options.dpi = 240, options.margin_in = 0;
  const auto report = emulator::emulate_line_printer(bytes, options, file);
  EXPECT_EQ(report.lines, static_cast<std::uint64_t>(kRows));
  EXPECT_TRUE(report.warnings.empty());
  cairo_surface_t* page = cairo_image_surface_create_from_png(file.c_str());
  fs::remove(file);
  EXPECT_EQ(cairo_image_surface_get_width(page), kColumns * kCellWide);
  EXPECT_EQ(cairo_image_surface_get_height(page), kRows * pitch.cell_high);
  double light[256];
  for (int value = 0; value < 256; ++value) {
    const double v = value / 255.0;
    light[value] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  std::vector<double> ink(kColumns * kRows);
  const unsigned char* data = cairo_image_surface_get_data(page);
  const int stride = cairo_image_surface_get_stride(page);
  for (int y = 0; y < kRows * pitch.cell_high; ++y)
    for (int x = 0; x < kColumns * kCellWide; ++x)
      ink[y / pitch.cell_high * kColumns + x / kCellWide] +=
          (1 - light[data[y * stride + 4 * x]]) / (kCellWide * pitch.cell_high);
  cairo_surface_destroy(page);
  return ink;
}

Levels random_levels(unsigned seed) {
  std::mt19937 random(seed);
  Levels levels(kColumns * kRows);
  for (int& level : levels) level = static_cast<int>(random() % kLevels);
  return levels;
}

TEST(RoundTrip, EveryCellPrintsItsTone) {
  for (const Pitch& pitch : kPitches)
    for (const std::string stream : {"cr", "asa", "plain"}) {
      const ToneTable table = table_of(pitch, stream == "plain" ? 1 : 7);
      const Levels levels = random_levels(5);
      const std::vector<double> ink = ink_on_paper(printed(levels, pitch, stream), pitch, stream);
      double worst = 0, sum = 0;
      for (std::size_t i = 0; i < levels.size(); ++i) {
        const double error = ink[i] - table.coverage(levels[i]);
        worst = std::max(worst, std::abs(error));
        sum += error;
      }
      EXPECT_LE(worst, kCellBound) << stream << " at " << pitch.lpi;
      EXPECT_LE(std::abs(sum / levels.size()), kMeanBound) << stream << " at " << pitch.lpi;
    }
}

// Fields of one level, as flat faces are: evenly spaced on paper, to a third of a step.
TEST(RoundTrip, LevelsAreEvenlySpacedOnPaper) {
  for (const Pitch& pitch : kPitches) {
    std::vector<double> ink_of_level;
    Levels levels(kColumns * kRows);  // 20 fields of 8 columns x 6 rows
    for (int i = 0; i < kColumns * kRows; ++i) levels[i] = i / kColumns / 6 * 5 + i % kColumns / 8;
    const std::vector<double> ink = ink_on_paper(printed(levels, pitch, "cr"), pitch, "cr");
    for (int level = 0; level < kLevels; ++level) {
      double sum = 0;
      for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 8; ++x) sum += ink[(level / 5 * 6 + y) * kColumns + level % 5 * 8 + x];
      ink_of_level.push_back(sum / 48);
    }
    const double step = ink_of_level.back() / (kLevels - 1);
    EXPECT_GE(ink_of_level.back(), pitch.cell_high == 30 ? 0.88 : 0.72);
    for (int level = 0; level < kLevels; ++level)
      EXPECT_NEAR(ink_of_level[level], step * level, step / 3) << level << " at " << pitch.lpi;
  }
}

// The comparison can fail: at another pitch the same bytes are other tones.
TEST(RoundTrip, AWrongPitchIsSeen) {
  const ToneTable table = table_of(kPitches[0], 7);
  const Levels levels = random_levels(5);
  const std::vector<double> ink =
      ink_on_paper(printed(levels, kPitches[0], "cr"), kPitches[1], "cr");
  double worst = 0;
  for (std::size_t i = 0; i < levels.size(); ++i)
    worst = std::max(worst, std::abs(ink[i] - table.coverage(levels[i])));
  EXPECT_GT(worst, 10 * kCellBound);
}

}  // namespace
}  // namespace overstrike
