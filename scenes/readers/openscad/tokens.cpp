#include "scenes/readers/openscad/tokens.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace overstrike::openscad {
namespace {

/// OpenSCAD's own export has so many.
constexpr int kExportedDigits = 6;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

/// Half a unit of the last digit of a number of six digits or more.
double precision_of(std::string_view source) {
  int digits = 0, after_point = 0, exponent = 0;
  bool point = false;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const char c = source[i];
    if (c == 'e' || c == 'E') {
      const std::size_t sign = source[i + 1] == '+' ? 1 : 0;
      std::from_chars(source.data() + i + 1 + sign, source.data() + source.size(), exponent);
      break;
    }
    if (c == '.') point = true;
    if (!is_digit(c)) continue;
    after_point += point ? 1 : 0;
    if (digits > 0 || c != '0') ++digits;
  }
  return digits < kExportedDigits ? 0 : 0.5 * std::pow(10.0, exponent - after_point);
}

void append_utf8(std::string& text, unsigned long code) {
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | code >> 6);
    text += static_cast<char>(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | code >> 12);
    text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
    text += static_cast<char>(0x80 | (code & 0x3F));
  } else if (code < 0x110000) {
    text += static_cast<char>(0xF0 | code >> 18);
    text += static_cast<char>(0x80 | (code >> 12 & 0x3F));
    text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
    text += static_cast<char>(0x80 | (code & 0x3F));
  }
}

}  // namespace

std::string describe(const Token& token) {
  if (token.kind == TokenKind::end) return "the end of the file";
  if (token.kind == TokenKind::text) return "a string";
  return in_quotes(token.source);
}

void Tokens::fail(const TextMark& at, std::string message, std::string hint) {
  reporter_.error(at, std::move(message), std::move(hint));
  reporter_.throw_errors();
  std::abort();  // errors were reported
}

void Tokens::step() {
  const bool newline = peek() == '\n';
  ++mark_.offset;
  mark_.line += newline ? 1 : 0;
  mark_.column = newline ? 1 : mark_.column + 1;
}

void Tokens::skip_comment() {
  const TextMark start = mark_;
  const bool to_line_end = peek(1) == '/';
  step(), step();
  while (!at_end()) {
    if (to_line_end && peek() == '\n') return;
    if (!to_line_end && peek() == '*' && peek(1) == '/') {
      step(), step();
      return;
    }
    step();
  }
  if (!to_line_end) fail(start, "the comment has no end", "it ends with */");
}

void Tokens::skip_space() {
  while (!at_end()) {
    if (is_space(peek())) {
      step();
    } else if (peek() == '/' && (peek(1) == '/' || peek(1) == '*')) {
      skip_comment();
    } else {
      return;
    }
  }
}

void Tokens::read_word(Token& token) {
  step();
  while (is_letter(peek()) || is_digit(peek())) step();
  token.kind = TokenKind::word;
  token.source = since(token.at);
  if (token.source != "inf" && token.source != "nan") return;
  token.kind = TokenKind::number;
  token.number = token.source == "inf" ? std::numeric_limits<double>::infinity()
                                       : std::numeric_limits<double>::quiet_NaN();
}

void Tokens::read_number(Token& token) {
  token.kind = TokenKind::number;
  const bool minus = peek() == '-';
  if (minus || peek() == '+') step();
  if (is_letter(peek())) {
    Token word{TokenKind::word, mark_, {}, 0, 0, {}};
    read_word(word);
    token.source = since(token.at);
    if (word.kind != TokenKind::number)
      fail(token.at, "expected a number, found " + describe(token));
    token.number = minus ? -word.number : word.number;
    return;
  }
  const TextMark digits = mark_;
  while (is_digit(peek()) || peek() == '.') step();
  const bool sign = peek(1) == '-' || peek(1) == '+';
  if ((peek() == 'e' || peek() == 'E') && is_digit(peek(sign ? 2 : 1))) {
    step(), step();
    while (is_digit(peek())) step();
  }
  token.source = since(token.at);
  const std::string_view source = since(digits);
  const char* const end = source.data() + source.size();
  const auto [stop, error] = std::from_chars(source.data(), end, token.number);
  if (stop != end || error == std::errc::invalid_argument)
    fail(token.at, "expected a number, found " + describe(token));
  // Beyond the range of a double: from_chars leaves the number as it was.
  if (error == std::errc::result_out_of_range)
    token.number =
        source.find('-') == std::string_view::npos ? std::numeric_limits<double>::infinity() : 0;
  if (minus) token.number = -token.number;
  token.precision = precision_of(source);
}

void Tokens::read_escape(std::string& text) {
  const TextMark start = mark_;
  step();
  const char c = peek();
  step();
  const std::size_t digits = c == 'x' ? 2 : c == 'u' ? 4 : c == 'U' ? 6 : 0;
  if (digits == 0) {
    text += c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c;
    return;
  }
  unsigned long code = 0;
  const std::string_view hex = text_.substr(std::min(mark_.offset, text_.size()), digits);
  const auto [stop, error] = std::from_chars(hex.data(), hex.data() + hex.size(), code, 16);
  if (error != std::errc{} || hex.size() != digits || stop != hex.data() + digits)
    fail(start, "expected " + std::to_string(digits) + " hexadecimal digits after \\" + c);
  for (std::size_t i = 0; i < digits; ++i) step();
  append_utf8(text, code);
}

void Tokens::read_text(Token& token) {
  token.kind = TokenKind::text;
  step();
  while (peek() != '"') {
    if (at_end()) fail(token.at, "the string has no end", "it ends with \"");
    if (peek() == '\\' && mark_.offset + 1 < text_.size()) {
      read_escape(token.text);
    } else {
      token.text += peek();
      step();
    }
  }
  step();
  token.source = since(token.at);
}

Token Tokens::next() {
  skip_space();
  Token token{TokenKind::end, mark_, {}, 0, 0, {}};
  if (at_end()) return token;
  const char c = peek();
  if (is_letter(c) || c == '$') {
    read_word(token);
  } else if (is_digit(c) || c == '-' || c == '+' || c == '.') {
    read_number(token);
  } else if (c == '"') {
    read_text(token);
  } else {
    step();
    token.kind = TokenKind::mark;
    token.source = since(token.at);
  }
  return token;
}

}  // namespace overstrike::openscad
