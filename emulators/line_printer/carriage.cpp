#include "emulators/line_printer/carriage.h"

#include <fmt/core.h>

#include <utility>

namespace overstrike::emulator {
namespace {

constexpr int kTab = 8;
constexpr int kEnd = std::char_traits<char>::eof();

bool is_character(int byte) { return byte >= ' ' && byte <= '~'; }

/// What both kinds of stream do with the bytes of a line.
void print_byte(int byte, Carriage& carriage, LinePrinterReport& report) {
  if (is_character(byte)) return carriage.print(static_cast<unsigned char>(byte));
  if (byte == '\b') return carriage.back_space();
  if (byte == '\t') return carriage.tab();
  ++report.unprintable;
  if (byte > '~') carriage.print(' ');
}

/// Acts on FORTRAN's control character. Before the
/// first line the carriage stands above the paper.
void move_paper(int control, bool first, Carriage& carriage, LinePrinterReport& report) {
  if (control == '1' && !first) {
    carriage.form();
  } else if (control != '+' && control != '1') {
    const bool known = control == ' ' || control == '\n' || control == '0' || control == '-';
    report.unprintable += !known;
    const std::size_t lines = control == '0' ? 2 : control == '-' ? 3 : 1;
    carriage.feed(first ? lines - 1 : lines);
  }
  carriage.begin_line();
}

}  // namespace

bool StruckCell::strike(unsigned char character) {
  const bool bare = blank();
  words_[character / 64 & 1] |= std::uint64_t{1} << (character % 64);
  return bare;
}

Carriage::Carriage(int columns, std::size_t most_lines, LinePrinterReport& report, Eject eject)
    : columns_(columns), most_lines_(most_lines), report_(report), eject_(std::move(eject)) {}

void Carriage::print(unsigned char character) {
  begin();
  const std::uint64_t column = column_++;
  if (character == ' ') return;
  ++report_.strikes;
  if (column >= static_cast<std::uint64_t>(columns_)) {
    ++report_.beyond;
    return;
  }
  if (page_.size() <= line_) page_.resize(line_ + 1);
  PrintedLine& line = page_[line_];
  if (line.size() <= column) line.resize(column + 1);
  report_.overstrikes += !line[column].strike(character);
}

void Carriage::tab() {
  begin();
  column_ += kTab - column_ % kTab;
}

void Carriage::feed(std::size_t lines) {
  line_ += lines;
  column_ = 0;
  begun_ = false;
  check_length();
}

void Carriage::begin() {
  begun_ = true;
  check_length();
}

void Carriage::check_length() const {
  if (line_ + begun_ <= most_lines_) return;
  throw Error(fmt::format("page {} has more than {} lines, the most that such paper takes",
                          report_.pages + 1, most_lines_));
}

void Carriage::finish() {
  if (!page_is_fresh() || report_.pages == 0) form();
}

void Carriage::form() {
  page_.resize(line_ + (begun_ || line_ == 0));
  ++report_.pages;
  report_.lines += page_.size();
  eject_(page_);
  page_.clear();
  line_ = 0, column_ = 0, begun_ = false;
}

void print_ascii(std::istream& bytes, Carriage& carriage, LinePrinterReport& report) {
  std::streambuf& in = *bytes.rdbuf();
  for (int byte = in.sbumpc(); byte != kEnd; byte = in.sbumpc()) {
    if (byte == '\r') {
      carriage.carriage_return();
    } else if (byte == '\n') {
      carriage.feed(1);
    } else if (byte == '\f') {
      carriage.form();
    } else {
      print_byte(byte, carriage, report);
    }
  }
  carriage.finish();
}

void print_asa(std::istream& bytes, Carriage& carriage, LinePrinterReport& report) {
  std::streambuf& in = *bytes.rdbuf();
  bool first = true;
  for (int control = in.sbumpc(); control != kEnd; control = in.sbumpc()) {
    if (control == '\r' && in.sgetc() == '\n') control = in.sbumpc();
    move_paper(control, first, carriage, report);
    first = false;
    if (control == '\n') continue;
    for (int byte = in.sbumpc(); byte != '\n' && byte != kEnd; byte = in.sbumpc())
      if (byte != '\r' || in.sgetc() != '\n') print_byte(byte, carriage, report);
  }
  carriage.finish();
}

}  // namespace overstrike::emulator
