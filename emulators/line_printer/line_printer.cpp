#include "emulators/line_printer/line_printer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <streambuf>

#include "emulators/line_printer/carriage.h"
#include "emulators/line_printer/paper.h"

namespace overstrike::emulator {
namespace {

void expect(std::string_view name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw Error(fmt::format("{} must be between {} and {}, found {}", name, low, high, value));
}

void check(const LinePrinterOptions& options) {
  expect("cpi", options.cpi, kLeastPitch, kMostPitch);
  expect("lpi", options.lpi, kLeastPitch, kMostPitch);
  expect("dpi", options.dpi, kLeastPrinterDpi, kMostPrinterDpi);
  expect("columns", options.columns, 1, kMostColumns);
  expect("margin", options.margin_in, 0, kMostMarginIn);
  if (options.stream != "cr" && options.stream != "plain" && options.stream != "asa")
    throw Error("stream must be one of cr, plain, asa, found '" + options.stream + "'");
}

std::unique_ptr<Paper> paper_for(const LinePrinterOptions& options,
                                 const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".png") return png_paper(options, file);
  if (extension == ".pdf") return pdf_paper(options, file);
  throw Error("paper is .png or .pdf, found '" + file.string() + "'");
}

/// Reads from memory without a copy.
class View final : public std::streambuf {
 public:
  explicit View(std::string_view bytes) {
    char* first = const_cast<char*>(bytes.data());  // never written: there is no put area
    setg(first, first, first + bytes.size());
  }
};

void warn(LinePrinterReport& report) {
  if (report.beyond > 0)
    report.warnings.push_back(
        fmt::format("{} characters struck right of the carriage are lost", report.beyond));
  if (report.unprintable > 0)
    report.warnings.push_back(
        fmt::format("{} bytes are neither characters nor known controls", report.unprintable));
}

}  // namespace

LinePrinterReport emulate_line_printer(std::istream& bytes, const LinePrinterOptions& options,
                                       const std::filesystem::path& file) {
  check(options);
  const std::unique_ptr<Paper> paper = paper_for(options, file);
  LinePrinterReport report;
  Carriage carriage(options.columns, paper->most_lines(), report,
                    [&](const PrintedPage& page) { paper->page(page); });
  if (options.stream == "asa") {
    print_asa(bytes, carriage, report);
  } else {
    print_ascii(bytes, carriage, report);
  }
  if (bytes.bad()) throw Error("the stream cannot be read");
  paper->finish();
  warn(report);
  return report;
}

LinePrinterReport emulate_line_printer(std::string_view bytes, const LinePrinterOptions& options,
                                       const std::filesystem::path& file) {
  View view(bytes);
  std::istream in(&view);
  return emulate_line_printer(in, options, file);
}

}  // namespace overstrike::emulator
