#include "devices/terminal/terminal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace overstrike {
namespace {

std::string drawn(const Settings& settings, const std::vector<std::vector<float>>& rows) {
  std::string bytes;
  const auto device = terminal_device().make(settings, "-", open_memory(bytes));
  EXPECT_EQ(device->layout().grid.rows, static_cast<double>(rows.size()));
  EXPECT_EQ(device->layout().grid.columns, static_cast<double>(rows.front().size()));
  device->begin();
  for (std::size_t y = 0; y < rows.size(); ++y)
    device->cells({static_cast<std::int64_t>(y), rows[y]});
  device->end();
  return bytes;
}

TEST(Terminal, AsciiIsLightOnDark) {
  EXPECT_EQ(drawn({{"size", "4x2"}, {"blocks", "ascii"}}, {{1, 0, 1, 0}, {0, 0, 1, 1}}),
            " @ @\n@@  \n");
}

TEST(Terminal, AsciiGetsBrighterWithReflectance) {
  std::vector<float> row;
  for (int i = 0; i <= 100; ++i) row.push_back(static_cast<float>(100 - i) / 100);
  std::string line = drawn({{"size", "101x1"}, {"color", "none"}}, {row});
  line.erase(std::unique(line.begin(), line.end()), line.end());
  EXPECT_EQ(line, " .-:*+=%#@\n");
}

TEST(Terminal, TrueColorHalfBlocks) {
  EXPECT_EQ(
      drawn({{"size", "3x1"}, {"blocks", "half"}, {"color", "true"}}, {{0, 0, 1}, {1, 1, 0.5}}),
      "\033[38;2;255;255;255m\033[48;2;0;0;0m\u2580\u2580"
      "\033[38;2;0;0;0m\033[48;2;188;188;188m\u2580\033[0m\n");
}

TEST(Terminal, GreysOf256) {
  EXPECT_EQ(drawn({{"size", "2x1"}, {"blocks", "half"}, {"color", "256"}}, {{0, 0.5}, {1, 1}}),
            "\033[38;5;231m\033[48;5;16m\u2580\033[38;5;250m\u2580\033[0m\n");
}

TEST(Terminal, PitchKeepsThePicturesAspect) {
  std::string bytes;
  const auto grid = [&](const char* blocks) {
    const Settings settings = {{"size", "10x5"}, {"blocks", blocks}, {"color", "256"}};
    return terminal_device().make(settings, "-", open_memory(bytes))->layout().grid;
  };
  EXPECT_EQ(grid("half").rows, 10);
  EXPECT_EQ(grid("half").pitch_x_mm, grid("half").pitch_y_mm);
  EXPECT_EQ(grid("ascii").rows, 5);
  EXPECT_EQ(2 * grid("ascii").pitch_x_mm, grid("ascii").pitch_y_mm);
}

TEST(Terminal, AsksTheEnvironment) {
  std::string bytes;
  const auto rows = [&] {
    return terminal_device().make({{"size", "10x5"}}, "-", open_memory(bytes))->layout().grid.rows;
  };
  ::setenv("TERM", "xterm-256color", 1);
  ::setenv("LC_ALL", "C.UTF-8", 1);
  ::unsetenv("NO_COLOR");
  EXPECT_EQ(rows(), 10);
  ::setenv("NO_COLOR", "1", 1);
  EXPECT_EQ(rows(), 5);
  ::unsetenv("NO_COLOR");
  ::setenv("LC_ALL", "C", 1);
  EXPECT_EQ(rows(), 5);
  ::setenv("LC_ALL", "C.UTF-8", 1);
  ::setenv("TERM", "dumb", 1);
  EXPECT_EQ(rows(), 5);
}

/// Standard output is a file while this lives, so that there is no window whose size it could tell.
class NoWindow {
 public:
  NoWindow() : kept_(::dup(STDOUT_FILENO)) {
    std::fflush(stdout);
    const int nothing = ::open("/dev/null", O_WRONLY);
    ::dup2(nothing, STDOUT_FILENO);
    ::close(nothing);
  }
  ~NoWindow() {
    ::dup2(kept_, STDOUT_FILENO);
    ::close(kept_);
  }
  NoWindow(const NoWindow&) = delete;
  NoWindow& operator=(const NoWindow&) = delete;

 private:
  int kept_;
};

TEST(Terminal, WithoutAWindowTakesTheEnvironmentsSize) {
  const auto size = [](const char* columns, const char* lines) {
    const NoWindow no_window;
    columns == nullptr ? ::unsetenv("COLUMNS") : ::setenv("COLUMNS", columns, 1);
    lines == nullptr ? ::unsetenv("LINES") : ::setenv("LINES", lines, 1);
    std::string bytes;
    const Grid grid =
        terminal_device().make({{"blocks", "ascii"}}, "-", open_memory(bytes))->layout().grid;
    return std::pair(grid.columns, grid.rows);
  };
  EXPECT_EQ(size("132", "50"), std::pair(132.0, 49.0));  // a line is left for the prompt
  EXPECT_EQ(size("7", "1"), std::pair(7.0, 1.0));
  EXPECT_EQ(size(nullptr, nullptr), std::pair(80.0, 23.0));
  EXPECT_EQ(size("wide", "-3"), std::pair(80.0, 23.0));
  EXPECT_EQ(size("0", "10001"), std::pair(80.0, 23.0));
}

TEST(Terminal, RefusesWhatItDoesNotKnow) {
  std::string bytes;
  EXPECT_THROW(terminal_device().make({{"color", "16"}}, "-", open_memory(bytes)), InputError);
  EXPECT_THROW(terminal_device().make({{"size", "80"}}, "-", open_memory(bytes)), InputError);
}

}  // namespace
}  // namespace overstrike
