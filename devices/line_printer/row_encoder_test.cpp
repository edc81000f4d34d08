#include "devices/line_printer/row_encoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace overstrike {
namespace {

/// Five levels of 0 to 3 strikes.
const ToneTable kTable{{{"", 0}, {".", 10}, {"X", 20}, {"MO", 30}, {"M#W", 40}}, 64};
const ToneTable kPlain{{{"", 0}, {".", 10}, {"+", 20}, {"X", 30}, {"M", 40}}, 64};

std::string encoded(const std::vector<int>& levels, PrinterStream stream) {
  std::vector<float> densities;
  for (const int level : levels) densities.push_back(static_cast<float>(level) / 4);
  std::string bytes;
  RowEncoder(stream == PrinterStream::plain ? kPlain : kTable, stream).append(densities, bytes);
  return bytes;
}

struct Case {
  std::vector<int> levels;
  std::string cr, asa, plain;
};

const Case kCases[] = {
    {{}, "\n", " \n", "\n"},
    {{0, 0, 0}, "\n", " \n", "\n"},
    {{0, 1, 0}, " .\n", "  .\n", " .\n"},
    {{2, 2, 2}, "XXX\n", " XXX\n", "+++\n"},
    {{3, 0, 1}, "M .\rO\n", " M .\n+O\n", "X .\n"},
    {{0, 3, 0}, " M\r O\n", "  M\n+ O\n", " X\n"},
    {{4, 0, 3}, "M M\r# O\rW\n", " M M\n+# O\n+W\n", "M X\n"},
    {{1, 2, 3, 4}, ".XMM\r  O#\r   W\n", " .XMM\n+  O#\n+   W\n", ".+XM\n"},
};

TEST(RowEncoder, ExactBytes) {
  for (const Case& c : kCases) {
    EXPECT_EQ(encoded(c.levels, PrinterStream::cr), c.cr);
    EXPECT_EQ(encoded(c.levels, PrinterStream::asa), c.asa);
    EXPECT_EQ(encoded(c.levels, PrinterStream::plain), c.plain);
  }
}

TEST(RowEncoder, AppendsAndKeepsNothing) {
  RowEncoder encoder(kTable, PrinterStream::cr);
  std::string bytes = "before ";
  encoder.append(std::vector<float>{1.0f}, bytes);
  encoder.append(std::vector<float>{0.0f, 0.25f}, bytes);
  encoder.append(std::vector<float>{1.0f}, bytes);
  EXPECT_EQ(bytes, "before M\r#\rW\n .\nM\r#\rW\n");
}

TEST(RowEncoder, EveryStreamIsARowOfTheTable) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    std::vector<int> levels(random() % 140);
    for (int& level : levels) level = static_cast<int>(random() % 5);
    std::string bytes = encoded(levels, PrinterStream::cr);
    EXPECT_EQ(std::count(bytes.begin(), bytes.end(), '\n'), 1);
    EXPECT_EQ(bytes.back(), '\n');
    bytes.back() = '\r';
    std::vector<std::string> cells(levels.size());
    for (std::size_t i = 0, column = 0; i < bytes.size(); ++i, ++column) {
      if (bytes[i] == '\r') {
        EXPECT_TRUE(i == 0 || bytes[i - 1] != ' ') << "trailing blank";
        column = static_cast<std::size_t>(-1);
      } else if (bytes[i] != ' ') {
        cells.at(column) += bytes[i];
      }
    }
    for (std::size_t i = 0; i < cells.size(); ++i)
      EXPECT_EQ(cells[i], kTable.levels[levels[i]].strikes);
  }
}

}  // namespace
}  // namespace overstrike
