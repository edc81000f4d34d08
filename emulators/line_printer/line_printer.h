#pragma once
// An emulated line printer: a stream of bytes in, the printed paper out (docs/emulated-printer.md).
#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/data_files.h"

namespace overstrike::emulator {

struct LinePrinterOptions {
  std::string stream = "cr";  ///< cr or plain: ASCII with control characters; asa: FORTRAN's
  double cpi = 10;            ///< characters to the inch
  double lpi = 6;             ///< lines to the inch
  int columns = 136;          ///< of the carriage; what is struck right of it is lost
  double dpi = 144;           ///< of a PNG
  double margin_in = 0.5;     ///< bare paper on every side
  std::string typeface = "dejavu-sans-mono";  ///< data/typefaces/NAME.typeface, or a font file
};

constexpr double kLeastPitch = 1, kMostPitch = 24;
constexpr double kLeastPrinterDpi = 10, kMostPrinterDpi = 600;
constexpr int kMostColumns = 1024;
constexpr double kMostMarginIn = 4;

struct LinePrinterReport {
  std::uint64_t pages = 0;
  std::uint64_t lines = 0;        ///< of all pages
  std::uint64_t strikes = 0;      ///< printing characters, blanks not counted
  std::uint64_t overstrikes = 0;  ///< of them on a place that had ink already
  std::uint64_t beyond = 0;       ///< struck right of the carriage: lost
  std::uint64_t unprintable = 0;  ///< bytes that are neither characters nor known controls
  std::vector<std::string> warnings;
};

/// Prints the bytes: PNG or PDF by the extension of `paper`. A page is as long as its lines
/// (continuous paper); a form feed begins the next: in a PDF all in one file, as PNGs in paper.png,
/// paper-2.png, ... Nothing has its name before all is printed. Any bytes print; memory is bounded
/// whatever the input. Throws Error: options out of range, an unknown type face or extension, a
/// page longer than its file can be (32767 dots or 2^28 in all; 200 inches of PDF), more than 500
/// PNGs or 10000 pages; OutputError: the paper cannot be written.
LinePrinterReport emulate_line_printer(std::istream& bytes, const LinePrinterOptions& options,
                                       const std::filesystem::path& paper);
LinePrinterReport emulate_line_printer(std::string_view bytes, const LinePrinterOptions& options,
                                       const std::filesystem::path& paper);

}  // namespace overstrike::emulator
