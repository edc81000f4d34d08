#include "emulators/plotter/hpgl_parser.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace overstrike::emulator {
namespace {

constexpr int kEscape = 27;
/// Numbers grow no further: far out of any plotter's range, and safe to compute with.
constexpr double kHugeNumber = 1e12;

bool is_letter(int c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool is_digit(int c) { return c >= '0' && c <= '9'; }
bool starts_number(int c) { return is_digit(c) || c == '+' || c == '-' || c == '.'; }
bool is_separator(int c) { return c == ',' || (c >= 0 && c <= ' ') || c == 127; }
char capital(int c) { return static_cast<char>(c >= 'a' ? c - 'a' + 'A' : c); }

bool one_of(int c, std::string_view set) {
  return c >= 0 && set.find(static_cast<char>(c)) != std::string_view::npos;
}

}  // namespace

int HpglParser::raw() {
  if (pushed_back_ != kNoByte) return std::exchange(pushed_back_, kNoByte);
  const int c = in_.sbumpc();
  if (c == std::streambuf::traits_type::eof()) return kEnd;
  ++read_;
  return c;
}

void HpglParser::advance() {
  int c = raw();
  for (; c == kEscape; c = raw()) skip_escape();
  look_ = c;
  look_byte_ = c == kEnd ? read_ : read_ - 1;
}

void HpglParser::skip_escape() {
  const int c = raw();
  if (c == '.') return skip_device_control();
  if (c == '%') return skip_pcl();
  // ESC and a letter is PCL (ESC E resets); any other byte stays.
  if (!is_letter(c)) pushed_back_ = c;
}

/// ESC . letter; those with parameters go on to a colon, or end before the first byte that cannot
/// be one of theirs.
void HpglParser::skip_device_control() {
  if (!one_of(raw(), "@HIMNPST")) return;
  int c = raw();
  while (is_digit(c) || one_of(c, ";,+- ")) c = raw();
  if (c != ':') pushed_back_ = c;
}

/// ESC % number letter. ESC %-12345X leaves the language: lines of PJL may follow.
void HpglParser::skip_pcl() {
  int c = raw();
  while (is_digit(c) || c == '-' || c == '+') c = raw();
  if (!is_letter(c)) {
    pushed_back_ = c;
    return;
  }
  if (c != 'X') return;
  for (c = raw(); c == '@'; c = raw()) {
    while (c != '\n' && c != kEscape && c != kEnd) c = raw();
    if (c != '\n') break;
  }
  pushed_back_ = c;
}

HpglEvent HpglParser::next() {
  for (;;) {
    HpglEvent event{HpglEvent::Kind::none, {}, 0, look_byte_};
    const bool ends = look_ == kEnd || look_ == ';' || is_letter(look_);
    if (ends && in_instruction_) {
      if (look_ == ';') advance();
      in_instruction_ = false;
      event.kind = HpglEvent::Kind::end;
      return event;
    }
    if (look_ == kEnd) return event;
    if (is_letter(look_)) return mnemonic();
    if (starts_number(look_) && number(event.number)) {
      event.kind = in_instruction_ ? HpglEvent::Kind::number : HpglEvent::Kind::stray;
      return event;
    }
    if (starts_number(look_)) continue;  // a sign or a point alone was skipped
    const int c = look_;
    advance();
    if (is_separator(c) || c == ';') continue;
    event.kind = HpglEvent::Kind::stray;
    return event;
  }
}

HpglEvent HpglParser::mnemonic() {
  HpglEvent event{HpglEvent::Kind::instruction, std::string(1, capital(look_)), 0, look_byte_};
  advance();
  while (look_ != kEnd && look_ != ',' && is_separator(look_)) advance();
  in_instruction_ = true;
  if (!is_letter(look_)) return event;
  event.name += capital(look_);
  if (event.name == "LB" || event.name == "DT" || event.name == "SM" || event.name == "PE" ||
      event.name == "BL" || event.name == "WD" || event.name == "BP" || event.name == "CO" ||
      event.name == "MG") {
    skip_text(event.name);
  } else {
    advance();
  }
  return event;
}

/// Precondition: the mnemonic's second letter is the byte that comes next.
void HpglParser::skip_text(const std::string& name) {
  if (name == "LB" || name == "BL") return skip_through(label_end_);
  if (name == "WD") return skip_through(3);
  if (name != "PE" && name != "DT" && name != "SM") return skip_quoted();
  advance();
  if (name == "PE") {
    while (look_ != ';' && look_ != kEnd) advance();
  } else {
    if (name == "DT") label_end_ = look_ == ';' || look_ == kEnd ? 3 : look_;
    if (look_ != ';') advance();
  }
}

void HpglParser::skip_through(int last) {
  do advance();
  while (look_ != last && look_ != kEnd);
  advance();
}

/// BP, CO and MG: "text" in quotation marks where there are any, or none up to the `;`.
void HpglParser::skip_quoted() {
  bool quoted = false;
  for (advance(); look_ != kEnd && (quoted || look_ != ';'); advance()) {
    if (look_ == '"') quoted = !quoted;
  }
}

/// False when there is no digit; what looked like a number is skipped then.
bool HpglParser::number(double& value) {
  const bool negative = look_ == '-';
  if (look_ == '-' || look_ == '+') advance();
  bool digits = false;
  double scale = 1;
  value = 0;
  for (; is_digit(look_); advance(), digits = true) {
    value = std::min(value * 10 + (look_ - '0'), kHugeNumber);
  }
  if (look_ == '.') {
    for (advance(); is_digit(look_); advance(), digits = true) {
      scale /= 10;
      value += (look_ - '0') * scale;
    }
  }
  if (negative) value = -value;
  return digits;
}

}  // namespace overstrike::emulator
