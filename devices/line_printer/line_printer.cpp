#include "devices/line_printer/line_printer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <filesystem>
#include <utility>

#include "devices/line_printer/row_encoder.h"

namespace overstrike {
namespace {

constexpr int kLargest = 65536;
constexpr int kCarriage = 136;
constexpr double kMillimetresInInch = 25.4;
constexpr double kMostPitch = 24;  // characters or lines to the inch

constexpr std::array<std::string_view, 3> kStreams = {"cr", "asa", "plain"};
constexpr std::array<std::string_view, 2> kCharsets = {"upper64", "ascii95"};
constexpr std::array<std::string_view, 2> kForms = {"no", "yes"};

PrinterStream stream_of(const SettingReader& settings, std::string_view output_name) {
  std::string extension = std::filesystem::path(output_name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::string chosen = settings.choice("stream", kStreams);
  if (!settings.given("stream") && extension == ".asa") return PrinterStream::asa;
  if (chosen == "asa") return PrinterStream::asa;
  return chosen == "plain" ? PrinterStream::plain : PrinterStream::cr;
}

/// The printing characters: ASCII from the blank to the underscore, or all.
std::string characters_of(std::string_view charset) {
  const char last = charset == "upper64" ? '_' : '~';
  std::string characters;
  for (char c = ' '; c <= last; ++c) characters += c;
  return characters;
}

ToneTable table_of(const SettingReader& settings, PrinterStream stream) {
  const double cpi = settings.number("cpi", 1, kMostPitch);
  const double lpi = settings.number("lpi", 1, kMostPitch);
  const int levels = settings.integer("levels", 2, kMostLevels);
  const int strikes = settings.integer("strikes", 1, kMostStrikes);
  const std::string characters = characters_of(settings.choice("charset", kCharsets));
  const Typeface face = find_typeface(settings.text("typeface"));
  return make_tone_table(measure_alphabet(face, characters, cpi, lpi), levels,
                         stream == PrinterStream::plain ? 1 : strikes);
}

class LinePrinter final : public Device {
 public:
  LinePrinter(const SettingReader& settings, std::string_view output_name,
              std::unique_ptr<Transport> transport)
      : transport_(std::move(transport)),
        stream_(stream_of(settings, output_name)),
        forms_(settings.choice("forms", kForms) == "yes"),
        encoder_(table_of(settings, stream_), stream_) {
    const auto [columns, rows] = settings.size("size", kLargest);
    layout_.grid = {static_cast<double>(columns), static_cast<double>(rows),
                    kMillimetresInInch / settings.number("cpi", 1, kMostPitch),
                    kMillimetresInInch / settings.number("lpi", 1, kMostPitch)};
    layout_.cells = true;
  }

  Layout layout() const override { return layout_; }

  void cells(const CellRow& row) override {
    assert(static_cast<double>(row.density.size()) == layout_.grid.columns);
    bytes_.clear();
    encoder_.append(row.density, bytes_);
    // FORTRAN's 1: to the top of the next form, then print.
    if (forms_ && stream_ == PrinterStream::asa && row.row == 0) bytes_.front() = '1';
    transport_->write(bytes_);
  }

  void end() override {
    if (forms_ && stream_ != PrinterStream::asa) transport_->write("\f");
    transport_->finish();
  }

  std::vector<Diagnostic> warnings() const override {
    std::vector<Diagnostic> found;
    if (layout_.grid.columns > kCarriage) {
      Diagnostic& wide = found.emplace_back();
      wide.severity = Severity::warning;
      wide.message = fmt::format("{} columns are more than the {} of a line printer's carriage",
                                 layout_.grid.columns, kCarriage);
    }
    return found;
  }

 private:
  std::unique_ptr<Transport> transport_;
  PrinterStream stream_;
  bool forms_;
  RowEncoder encoder_;
  Layout layout_;
  std::string bytes_;
};

}  // namespace

DeviceKind line_printer_kind() {
  DeviceKind kind;
  kind.name = "line-printer";
  kind.summary = "prints half-tones with overstruck characters";
  kind.extensions = {".txt", ".lpt", ".asa"};
  kind.settings = {
      {"size", "135x180", "columns x rows of characters; a carriage has 136 columns"},
      {"cpi", "10", "characters to the inch, 1 to 24"},
      {"lpi", "8", "lines to the inch, 1 to 24; printers have 6 or 8"},
      {"levels", "20", "levels of tone, 2 to 64"},
      {"strikes", "7", "most characters struck on one cell, 1 to 16"},
      {"stream", "cr", "cr: overstrikes after CR; asa: carriage control (of .asa files); plain"},
      {"charset", "upper64", "upper64: no small letters; ascii95: all"},
      {"typeface", "dejavu-sans-mono", "whose ink is reckoned with: of data/typefaces or a font"},
      {"forms", "no", "yes: a form of its own, by form feed (asa: control 1); no: continuous"},
  };
  kind.make = [kind](const Settings& given, std::string_view output_name,
                     std::unique_ptr<Transport> transport) {
    return std::make_unique<LinePrinter>(SettingReader(kind, given), output_name,
                                         std::move(transport));
  };
  return kind;
}

}  // namespace overstrike
