#include "devices/plotter/profile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/error.h"

namespace overstrike {
namespace {

/// One line of the file, taken apart; its numbers are read with the place of the line.
class Line {
 public:
  Line(Place place, const std::string& text) : place_(std::move(place)) {
    std::istringstream words(text);
    std::string word;
    while (words >> word && !(word[0] == '#' && (word.size() == 1 || words_.empty()))) {
      words_.push_back(word);
    }
  }

  bool empty() const { return words_.empty(); }
  const std::string& key() const { return words_[0]; }

  /// The words after the key; `count` of them, or `what` is expected.
  const std::string& word(std::size_t i, std::size_t count, const char* what) const {
    if (words_.size() != count + 1) fail(what);
    return words_[i + 1];
  }

  double number(std::size_t i, std::size_t count, const char* what) const {
    const std::string& text = word(i, count, what);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
        value < 0) {
      fail(what);
    }
    return value;
  }

  std::string rest() const {
    std::string text;
    for (std::size_t i = 1; i < words_.size(); ++i) text += (i > 1 ? " " : "") + words_[i];
    return text;
  }

  [[noreturn]] void fail(const std::string& expected) const {
    throw InputError(place_, words_[0] + " is '" + rest() + "'", "expected " + expected);
  }

 private:
  Place place_;
  std::vector<std::string> words_;
};

PlotterPaper read_paper(const Line& line) {
  const char* what = "a name, width, height, origin x and y in mm, hard clip X and Y in units";
  const auto number = [&](std::size_t i) { return line.number(i, 7, what); };
  PlotterPaper paper{line.word(0, 7, what), number(1), number(2), number(3), number(4), 0, 0};
  constexpr double kMostUnits = 8388607;  // HP-GL/2's largest coordinate, 2^23 - 1
  const auto is_limit = [](double x) { return x >= 1 && x <= kMostUnits && x == std::floor(x); };
  if (!is_limit(number(5)) || !is_limit(number(6))) line.fail(what);
  paper.clip_x = static_cast<int>(number(5));
  paper.clip_y = static_cast<int>(number(6));
  return paper;
}

int read_stall(const Line& line) {
  const char* what = "stall from 1 to 255, width, colour";
  constexpr double kMostPens = 255;
  const double stall = line.number(0, 3, what);
  if (!(stall >= 1 && stall <= kMostPens && stall == std::floor(stall))) line.fail(what);
  return static_cast<int>(stall);
}

void read_line(const Line& line, PlotterProfile& profile) {
  if (line.key() == "name:") {
    profile.name = line.rest();
  } else if (line.key() == "unit:") {
    profile.unit_mm = line.number(0, 1, "the length of a plotter unit in mm");
  } else if (line.key() == "speed:") {
    profile.slowest_cm_s = line.number(0, 2, "the slowest and the fastest speed in cm/s");
    profile.fastest_cm_s = line.number(1, 2, "the slowest and the fastest speed in cm/s");
  } else if (line.key() == "paper:") {
    profile.papers.push_back(read_paper(line));
  } else if (line.key() == "pen:") {
    profile.pens = std::max(profile.pens, read_stall(line));
  } else if (line.key() != "buffer:" && line.key() != "range:") {
    line.fail("name:, unit:, buffer:, range:, speed:, paper: or pen:");
  }
}

}  // namespace

const PlotterPaper* PlotterProfile::paper(std::string_view paper_name) const {
  const auto found = std::find_if(papers.begin(), papers.end(),
                                  [&](const PlotterPaper& p) { return p.name == paper_name; });
  return found == papers.end() ? nullptr : &*found;
}

std::string PlotterProfile::paper_names() const {
  std::string names;
  for (const PlotterPaper& p : papers) names += (names.empty() ? "" : ", ") + p.name;
  return names;
}

PlotterProfile read_plotter_profile(const std::filesystem::path& file) {
  std::ifstream in(file);
  Place place{file.string(), 0, 0};
  if (!in) throw InputError(place, "cannot be read");
  PlotterProfile profile;
  for (std::string text; std::getline(in, text);) {
    ++place.line;
    if (const Line line(place, text); !line.empty()) read_line(line, profile);
  }
  if (!(profile.unit_mm > 0) || profile.papers.empty() || profile.pens < 1) {
    throw InputError(Place{file.string(), 0, 0}, "is no plotter profile",
                     "expected at least unit:, one paper: and one pen:");
  }
  return profile;
}

}  // namespace overstrike
