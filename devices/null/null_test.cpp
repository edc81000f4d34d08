#include "devices/null/null.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>

namespace overstrike {
namespace {

TEST(Null, CountsWhatItGets) {
  std::string bytes;
  const auto device = null_device().make({{"size", "4x2"}}, "-", open_memory(bytes));
  const Layout layout = device->layout();
  EXPECT_EQ(layout.grid.columns, 4);
  EXPECT_EQ(layout.grid.rows, 2);
  EXPECT_TRUE(layout.cells && layout.strokes && layout.hatches.size() == 1);
  device->begin();
  const std::array strokes = {Stroke{{{0, 0}, {1, 1}}, StrokeKind::contour, 0},
                              Stroke{{{0, 0}, {1, 1}, {2, 0}}, StrokeKind::crease, 0}};
  device->strokes(strokes);
  const DensityRun run{0, 1, 0.5, 0.5, 0, 0, Kind::lit};
  const std::array runs = {run, run, run};
  device->hatch(0, {0, runs});
  device->hatch(0, {1, {}});
  const std::array density = {0.0f, 0.5f, 1.0f, 0.0f};
  device->cells({0, density});
  device->cells({1, density});
  device->end();
  EXPECT_EQ(bytes,
            "strokes 2 of 5 points\n"
            "lines 2 of 3 runs\n"
            "rows 2 of 8 cells, 4 inked\n");
}

std::string read(const std::string& path) {
  std::ifstream in(std::string(OVERSTRIKE_SOURCE_DIR "/").append(path));
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Null, IsWhatThePageShows) {
  const std::string page = read("docs/add-a-device.md");
  for (const char* path : {"devices/null/null.h", "devices/null/null.cpp"}) {
    const std::string code = read(path);
    ASSERT_FALSE(code.empty());
    EXPECT_NE(page.find(std::string("```cpp\n").append(code).append("```\n")), std::string::npos)
        << path << " has changed: copy it into docs/add-a-device.md";
  }
}

TEST(Null, IsInTheRegistry) {
  ASSERT_NE(find_device("null"), nullptr);
  EXPECT_EQ(find_device("null")->name, "null");
}

TEST(Null, RefusesBadSettings) {
  std::string bytes;
  EXPECT_THROW(null_device().make({{"size", "0x2"}}, "-", open_memory(bytes)), InputError);
  EXPECT_THROW(null_device().make({{"sise", "1x2"}}, "-", open_memory(bytes)), InputError);
}

}  // namespace
}  // namespace overstrike
