#include "devices/terminal/terminal.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "devices/srgb.h"

namespace overstrike {
namespace {

constexpr int kLargest = 10000;
constexpr std::array<std::string_view, 4> kColors = {"auto", "none", "256", "true"};
constexpr std::array<std::string_view, 3> kBlocks = {"auto", "half", "ascii"};

enum class Mode { ascii, greys_256, greys_true };

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool speaks_utf8() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    std::string locale = variable(name);
    if (locale.empty()) continue;
    std::transform(locale.begin(), locale.end(), locale.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return locale.find("utf-8") != std::string::npos || locale.find("utf8") != std::string::npos;
  }
  return false;
}

std::string color_of_terminal() {
  const std::string term = variable("TERM"), color = variable("COLORTERM");
  if (!variable("NO_COLOR").empty() || term.empty() || term == "dumb") return "none";
  return color == "truecolor" || color == "24bit" ? "true" : "256";
}

Mode mode_of(const SettingReader& settings) {
  const std::string blocks = settings.choice("blocks", kBlocks);
  std::string color = settings.choice("color", kColors);
  if (color == "auto") color = color_of_terminal();
  if (blocks == "ascii" || color == "none" || (blocks == "auto" && !speaks_utf8()))
    return Mode::ascii;
  return color == "true" ? Mode::greys_true : Mode::greys_256;
}

int positive(const std::string& text, int otherwise) {
  const int value = std::atoi(text.c_str());
  return value >= 1 && value <= kLargest ? value : otherwise;
}

/// Characters and lines; one line is left for the prompt.
std::pair<int, int> size_of(const SettingReader& settings) {
  if (settings.text("size") != "auto") return settings.size("size", kLargest);
  winsize window{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0 && window.ws_row > 0)
    return {std::min<int>(window.ws_col, kLargest),
            std::clamp<int>(window.ws_row - 1, 1, kLargest)};
  return {positive(variable("COLUMNS"), 80), std::max(1, positive(variable("LINES"), 24) - 1)};
}

struct Glyph {
  char character;
  float coverage;
};

// The part of a character cell that is lit, measured with FreeType on DejaVu Sans Mono at 200
// pixels (advance x line height is 1).
constexpr Glyph kRamp[] = {{' ', 0.000f}, {'.', 0.026f}, {'-', 0.029f}, {':', 0.052f},
                           {'*', 0.096f}, {'+', 0.112f}, {'=', 0.123f}, {'%', 0.186f},
                           {'#', 0.243f}, {'@', 0.277f}};

/// The character whose light, against the brightest one's, is nearest; the darker of equals.
char character_of(float reflectance) {
  const float wanted = reflectance * std::end(kRamp)[-1].coverage;
  const Glyph* best = kRamp;
  for (const Glyph& glyph : kRamp)
    if (std::fabs(glyph.coverage - wanted) < std::fabs(best->coverage - wanted)) best = &glyph;
  return best->character;
}

/// xterm's greys: 16 is black, 232..255 are 8, 18, ... 238, and 231 is white. The nearest.
int color_256(int grey) {
  if (grey < 4) return 16;
  if (grey > 246) return 231;
  return 232 + std::clamp((grey - 3) / 10, 0, 23);
}

class Terminal final : public Device {
 public:
  Terminal(Mode mode, std::pair<int, int> size, std::unique_ptr<Transport> transport)
      : mode_(mode), size_(size), transport_(std::move(transport)) {}

  Layout layout() const override {
    // A character is about twice as high as wide; half blocks cut it into two squares.
    Layout layout;
    const double halves = mode_ == Mode::ascii ? 1 : 2;
    layout.grid = {static_cast<double>(size_.first), size_.second * halves, 1, 2 / halves};
    layout.cells = true;
    return layout;
  }

  void cells(const CellRow& row) override {
    if (mode_ == Mode::ascii) {
      for (float density : row.density) line_ += character_of(1 - density);
      end_line();
    } else if (row.row % 2 == 0) {
      upper_ = greys(row.density);
    } else {
      half_blocks(greys(row.density));
    }
  }

  void end() override { transport_->finish(); }

 private:
  std::vector<int> greys(std::span<const float> density) const {
    std::vector<int> result;
    for (float d : density) {
      const int grey = encode_(1 - d);
      result.push_back(mode_ == Mode::greys_256 ? color_256(grey) : grey);
    }
    return result;
  }

  void half_blocks(const std::vector<int>& lower) {
    int fore = -1, back = -1;
    for (std::size_t i = 0; i < lower.size(); ++i) {
      change_color(38, std::exchange(fore, upper_[i]), upper_[i]);
      change_color(48, std::exchange(back, lower[i]), lower[i]);
      line_ += "\u2580";
    }
    line_ += "\033[0m";
    end_line();
  }

  void change_color(int which, int from, int to) {
    if (from == to) return;
    line_ += mode_ == Mode::greys_256 ? fmt::format("\033[{};5;{}m", which, to)
                                      : fmt::format("\033[{};2;{};{};{}m", which, to, to, to);
  }

  void end_line() {
    line_ += '\n';
    transport_->write(line_);
    line_.clear();
  }

  Mode mode_;
  std::pair<int, int> size_;
  std::unique_ptr<Transport> transport_;
  SrgbEncoder encode_{255};
  std::vector<int> upper_;
  std::string line_;
};

}  // namespace

DeviceKind terminal_device() {
  DeviceKind kind;
  kind.name = "terminal";
  kind.summary = "the picture as text in the terminal";
  kind.settings = {
      {"size", "auto", "characters x lines; auto: the terminal's, less a line for the prompt"},
      {"color", "auto", "none, 256 or true; auto: by NO_COLOR, TERM and COLORTERM"},
      {"blocks", "auto", "half or ascii; auto: half where the locale is UTF-8"}};
  kind.make = [kind](const Settings& given, std::string_view,
                     std::unique_ptr<Transport> transport) {
    const SettingReader settings(kind, given);
    return std::make_unique<Terminal>(mode_of(settings), size_of(settings), std::move(transport));
  };
  return kind;
}

}  // namespace overstrike
