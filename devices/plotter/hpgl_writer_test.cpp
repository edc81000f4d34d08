#include "devices/plotter/hpgl_writer.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <sstream>
#include <vector>

namespace overstrike {
namespace {

struct Bytes final : Transport {
  void write(std::string_view bytes) override { text += bytes; }
  void finish() override {}
  std::filesystem::path path_to_write() override { return {}; }
  std::string text;
};

std::string written(const std::function<void(HpglWriter&)>& say) {
  Bytes bytes;
  HpglWriter writer(bytes);
  say(writer);
  return bytes.text;
}

std::string line(std::vector<PlotPoint> points) {
  return written([&](HpglWriter& w) { w.polyline(points); });
}

TEST(HpglWriter, ExactBytes) {
  EXPECT_EQ(written([](HpglWriter& w) { w.begin(); }), "IN;\n");
  EXPECT_EQ(written([](HpglWriter& w) { w.end(); }), "PU;SP0;\n");
  EXPECT_EQ(written([](HpglWriter& w) { w.speed(10); }), "VS10;\n");
  EXPECT_EQ(written([](HpglWriter& w) { w.speed(0.38); }), "VS0.38;\n");
  EXPECT_EQ(written([](HpglWriter& w) { w.speed(38.1); }), "VS38.1;\n");
  EXPECT_EQ(written([](HpglWriter& w) {
              w.select_pen(1);
              w.select_pen(1);
              w.select_pen(2);
            }),
            "PU;SP1;\nPU;SP2;\n");
  EXPECT_EQ(line({{0, 0}, {10, 0}}), "PU0,0;PD10,0;\n");
  EXPECT_EQ(line({{1, 2}, {-3, 4}, {50, 60}}), "PU1,2;PD-3,4,50,60;\n");
  EXPECT_EQ(line({{7, 8}}), "PU7,8;PD;\n");
}

TEST(HpglWriter, LongLinesAreSplitBetweenPairs) {
  // 20 pairs of 12 bytes with their comma: 2 + 20 * 12 - 1 + 1 = 242 would be too long.
  const std::vector<PlotPoint> points(21, PlotPoint{11040, 12345});
  std::string pairs;
  for (int i = 0; i < 19; ++i) pairs += std::string(i ? "," : "") + "11040,12345";
  EXPECT_EQ(line(points), "PU11040,12345;PD" + pairs + ";\nPD11040,12345;\n");
}

TEST(HpglWriter, NoInstructionIsTooLongAndAllPointsArrive) {
  std::mt19937 random(240);
  std::uniform_int_distribution<int> count(1, 300), at(-32768, 32767), digits(0, 5);
  std::size_t longest = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<PlotPoint> points(static_cast<std::size_t>(count(random)));
    for (PlotPoint& p : points) p = {at(random) >> (3 * digits(random)), at(random)};
    std::istringstream instructions(line(points));
    std::vector<int> numbers;
    for (std::string one; std::getline(instructions, one, ';');) {
      longest = std::max(longest, one.size() + 1 - (one[0] == '\n'));
      for (char& c : one) c = c == ',' || c == 'P' || c == 'U' || c == 'D' ? ' ' : c;
      std::istringstream values(one);
      for (int v; values >> v;) numbers.push_back(v);
    }
    ASSERT_EQ(numbers.size(), 2 * points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_EQ((PlotPoint{numbers[2 * k], numbers[2 * k + 1]}), points[k]);
    }
  }
  EXPECT_LE(longest, kLongestInstruction);
  EXPECT_GT(longest, kLongestInstruction - 14);  // full but for less than a pair
}

}  // namespace
}  // namespace overstrike
