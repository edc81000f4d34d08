#include "emulators/plotter/profile.h"

#include <fmt/core.h>

#include <charconv>
#include <fstream>
#include <sstream>

namespace overstrike::emulator {
namespace {

/// Reads `count` numbers that follow; all must be there, finite and not negative.
bool read_numbers(std::istream& in, std::vector<double>& numbers, std::size_t count) {
  numbers.clear();
  for (std::string word; numbers.size() < count && in >> word;) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || *end != '\0' || !(value >= 0 && value <= 1e9)) return false;
    numbers.push_back(value);
  }
  return numbers.size() == count;
}

class Reader {
 public:
  Reader(const std::filesystem::path& file, std::string_view paper) : file_(file), paper_(paper) {}

  MachineProfile read() {
    std::ifstream in(file_);
    if (!in) throw Error(file_.string() + ": cannot be read");
    for (std::string text; std::getline(in, text);) {
      ++line_;
      std::istringstream words(text);
      std::string key;
      if (words >> key && key[0] != '#') take(key, words);
    }
    if (machine_.pens.empty()) throw Error(file_.string() + ": no pen");
    if (machine_.limits.clip_x <= 0 || machine_.limits.clip_y <= 0) {
      throw Error(fmt::format("no paper '{}' for the plotter, it takes {}", paper_, names_));
    }
    machine_.limits.pens = static_cast<int>(machine_.pens.size());
    return machine_;
  }

 private:
  void take(const std::string& key, std::istream& words) {
    if (key == "unit:") {
      expect(read_numbers(words, numbers_, 1) && numbers_[0] > 0);
      machine_.limits.unit_mm = numbers_[0];
    } else if (key == "range:") {
      expect(read_numbers(words, numbers_, 1));
      machine_.limits.range = numbers_[0];
    } else if (key == "paper:") {
      take_paper(words);
    } else if (key == "pen:") {
      take_pen(words);
    }
  }

  void take_paper(std::istream& words) {
    std::string name;
    words >> name;
    expect(read_numbers(words, numbers_, 6));
    names_ += (names_.empty() ? "" : ", ") + name;
    const bool known = machine_.width_mm > 0;  // of several with one name the first counts
    if (name != paper_ || known) return;
    machine_.width_mm = numbers_[0];
    machine_.height_mm = numbers_[1];
    machine_.origin_x_mm = numbers_[2];
    machine_.origin_y_mm = numbers_[3];
    machine_.limits.clip_x = numbers_[4];
    machine_.limits.clip_y = numbers_[5];
    constexpr double kLargestSheet = 5000;  // mm; larger is a slip in the file
    expect(numbers_[0] > 0 && numbers_[0] <= kLargestSheet && numbers_[1] > 0 &&
           numbers_[1] <= kLargestSheet);
  }

  void take_pen(std::istream& words) {
    std::string colour;
    expect(read_numbers(words, numbers_, 2) && bool(words >> colour) &&
           numbers_[0] == double(machine_.pens.size() + 1));
    constexpr std::size_t kMostPens = 255;
    expect(machine_.pens.size() < kMostPens);
    machine_.pens.push_back({numbers_[1], parse_colour(colour)});
  }

  void expect(bool right) const {
    if (!right)
      throw Error(fmt::format("{}:{}: not as a plotter profile has it", file_.string(), line_));
  }

  std::filesystem::path file_;
  std::string paper_, names_;
  MachineProfile machine_;
  std::vector<double> numbers_;
  int line_ = 0;
};

}  // namespace

Colour parse_colour(std::string_view text) {
  unsigned value = 0;
  const bool shaped = text.size() == 7 && text[0] == '#';
  const auto [end, error] = shaped ? std::from_chars(text.data() + 1, text.data() + 7, value, 16)
                                   : std::from_chars_result{nullptr, std::errc::invalid_argument};
  if (error != std::errc() || end != text.data() + 7) {
    throw Error(fmt::format("'{}' is no colour, expected #rrggbb", text));
  }
  return {static_cast<unsigned char>(value >> 16), static_cast<unsigned char>(value >> 8),
          static_cast<unsigned char>(value)};
}

MachineProfile read_machine(const std::filesystem::path& file, std::string_view paper) {
  return Reader(file, paper).read();
}

}  // namespace overstrike::emulator
