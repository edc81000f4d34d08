#include "emulators/line_printer/printer_typeface.h"

#include <fmt/core.h>

#include <fstream>
#include <sstream>

#include "emulators/data_files.h"

namespace overstrike::emulator {
namespace {

namespace fs = std::filesystem;

bool is_installed(const fs::path& file) {
  std::error_code failed;
  return fs::is_regular_file(file, failed);
}

/// "points" and "12" of "points: 12"; blanks around both are dropped.
std::pair<std::string, std::string> key_and_value(const std::string& line) {
  const auto trim = [](std::string text) {
    const auto from = text.find_first_not_of(" \t\r");
    if (from == std::string::npos) return std::string();
    return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
  };
  const auto colon = line.find(':');
  if (colon == std::string::npos) return {trim(line), ""};
  return {trim(line.substr(0, colon)), trim(line.substr(colon + 1))};
}

double number_of(const std::string& text, double low, double high, const std::string& where) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0;
  if (!(in >> value) || !in.eof() || !(value >= low && value <= high))
    throw Error(
        fmt::format("{}: expected a number between {} and {}, found '{}'", where, low, high, text));
  return value;
}

}  // namespace

PrinterTypeface read_printer_typeface(const fs::path& file) {
  PrinterTypeface face;
  std::ifstream in(file);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const auto [key, value] = key_and_value(line);
    const std::string where = fmt::format("{}:{}", file.string(), number);
    if (key.empty() || key[0] == '#' || key == "name") continue;
    if (key == "font") {
      const fs::path font = file.parent_path() / value;
      if (face.font.empty() && is_installed(font)) face.font = font;
    } else if (key == "points") {
      face.points = number_of(value, 1, 144, where);
    } else if (key == "middle") {
      face.middle_em = number_of(value, -1, 1, where);
    } else {
      throw Error(where + ": unknown key '" + key + "'");
    }
  }
  if (face.font.empty()) throw Error(file.string() + ": none of its fonts is installed");
  return face;
}

PrinterTypeface find_printer_typeface(const std::string& name) {
  const bool is_font = name.find('/') != std::string::npos || name.ends_with(".ttf") ||
                       name.ends_with(".otf") || name.ends_with(".pfb");
  if (!is_font) return read_printer_typeface(find_data_file("typefaces/" + name + ".typeface"));
  if (!is_installed(name)) throw Error(name + ": no such font file");
  return {name, 12, std::nullopt};
}

}  // namespace overstrike::emulator
