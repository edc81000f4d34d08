#pragma once
// What the printer does with a byte: where the next character is struck, and what was struck where.
#include <cstdint>
#include <functional>
#include <istream>
#include <vector>

#include "emulators/line_printer/line_printer.h"

namespace overstrike::emulator {

/// The characters that were struck on one place; ink is a union, so how often does not matter.
class StruckCell {
 public:
  /// False when other ink was there.
  bool strike(unsigned char character);
  bool has(unsigned char character) const {
    return words_[character / 64 & 1] >> (character % 64) & 1;
  }
  bool blank() const { return words_[0] == 0 && words_[1] == 0; }

 private:
  std::uint64_t words_[2] = {0, 0};
};

/// A line as far as something was struck.
using PrintedLine = std::vector<StruckCell>;
using PrintedPage = std::vector<PrintedLine>;

/// The carriage over the paper. Counts into the report.
class Carriage {
 public:
  using Eject = std::function<void(const PrintedPage&)>;

  /// `eject` gets every page when it is done. A page of more than `most_lines` throws Error.
  Carriage(int columns, std::size_t most_lines, LinePrinterReport& report, Eject eject);

  void print(unsigned char character);  ///< a printing character or the blank
  /// The line counts from now on, even if bare; the carriage stands at column 0.
  void begin_line() {
    column_ = 0;
    begin();
  }
  void carriage_return() { column_ = 0; }
  void back_space() { column_ -= column_ > 0; }
  void tab();
  void feed(std::size_t lines);  ///< the paper moves; the carriage returns
  void form();                   ///< the page is done
  /// After the last byte: ejects what was begun. Nothing at all is one bare page.
  void finish();

 private:
  void begin();
  void check_length() const;
  bool page_is_fresh() const { return line_ == 0 && !begun_; }

  int columns_;
  std::size_t most_lines_;
  LinePrinterReport& report_;
  Eject eject_;
  PrintedPage page_;
  std::size_t line_ = 0;
  std::uint64_t column_ = 0;
  bool begun_ = false;  ///< something was printed on the present line, be it a blank
};

/// ASCII: CR back to column 0, LF next line from column 0, FF next page, BS one back, HT to the
/// next multiple of 8. Other controls are skipped, bytes from 127 take a place and leave it bare;
/// both are counted.
void print_ascii(std::istream& bytes, Carriage& carriage, LinePrinterReport& report);

/// FORTRAN: lines end with LF (a CR before it is dropped); their first character moves the paper
/// before the rest is printed: blank one line, 0 two, - three, + none, 1 next page (not from the
/// top of a fresh one); any other counts as unprintable and as a blank, a missing one as a blank.
void print_asa(std::istream& bytes, Carriage& carriage, LinePrinterReport& report);

}  // namespace overstrike::emulator
