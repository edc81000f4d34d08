#include "devices/line_printer/typeface.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <vector>

#include "core/error.h"
#include "devices/data_files.h"

namespace overstrike {
namespace {

namespace fs = std::filesystem;

constexpr double kMostPoints = 144;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

bool names_a_font(std::string_view name) {
  if (name.find('/') != std::string_view::npos) return true;
  const std::string_view suffixes[] = {".ttf", ".otf", ".pfb"};
  return std::any_of(std::begin(suffixes), std::end(suffixes),
                     [&](std::string_view s) { return name.ends_with(s); });
}

bool is_file(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(path, none);
}

double number(std::string_view text, double low, double high, const Place& place,
              std::string_view key) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  // Written so that a NaN fails, too.
  if (whole && value >= low && value <= high) return value;
  throw InputError(place, fmt::format("{} must be a number between {} and {}, found '{}'", key, low,
                                      high, text));
}

/// Fills a Typeface line by line.
class Parser {
 public:
  explicit Parser(const fs::path& path) : path_(path) {}

  void line(std::string_view text, int number_of_line) {
    text = trimmed(text);
    if (text.empty() || text.front() == '#') return;
    const Place place{path_.string(), number_of_line, 0};
    const auto colon = text.find(':');
    if (colon == std::string_view::npos)
      throw InputError(place, "found '" + std::string(text) + "', expected 'key: value'");
    set(trimmed(text.substr(0, colon)), trimmed(text.substr(colon + 1)), place);
  }

  Typeface finish() {
    const auto found = std::find_if(fonts_.begin(), fonts_.end(), is_file);
    if (found == fonts_.end()) throw InputError(Place{path_.string(), 0, 0}, missing(), hint());
    face_.font = *found;
    if (face_.name.empty()) face_.name = path_.stem().string();
    return face_;
  }

 private:
  void set(std::string_view key, std::string_view value, const Place& place) {
    if (key == "name") {
      face_.name = value;
    } else if (key == "font") {
      fonts_.push_back(path_.parent_path() / fs::path(value));
    } else if (key == "points") {
      face_.points = number(value, 1, kMostPoints, place, key);
    } else if (key == "middle") {
      face_.middle_em = number(value, -1, 1, place, key);
    } else {
      throw InputError(place, "unknown key '" + std::string(key) + "'",
                       "known are name, font, points, middle");
    }
  }

  std::string missing() const {
    std::string text = "none of its fonts is there:";
    for (const fs::path& font : fonts_) text += ' ' + font.string();
    return fonts_.empty() ? "it names no font" : text;
  }
  std::string hint() const {
    return "DejaVu Sans Mono is Debian's package fonts-dejavu-core; any font file can be named";
  }

  fs::path path_;
  Typeface face_;
  std::vector<fs::path> fonts_;
};

fs::path described(std::string_view name) {
  try {
    return find_data_file("typefaces/" + std::string(name) + ".typeface");
  } catch (const std::runtime_error& error) {
    throw InputError(
        Place{},
        "typeface must be one of data/typefaces or a font file, found '" + std::string(name) + "'",
        error.what());
  }
}

}  // namespace

Typeface parse_typeface(std::string_view text, const fs::path& path) {
  Parser parser(path);
  for (int line = 1; !text.empty(); ++line) {
    const auto end = std::min(text.find('\n'), text.size());
    parser.line(text.substr(0, end), line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parser.finish();
}

Typeface find_typeface(std::string_view name) {
  if (names_a_font(name)) {
    const fs::path font(name);
    if (!is_file(font)) throw InputError(Place{font.string(), 0, 0}, "no such font file");
    return {font.stem().string(), font, 12, std::nullopt};
  }
  const fs::path path = described(name);
  std::ifstream file(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return parse_typeface(text, path);
}

}  // namespace overstrike
