#pragma once
// OpenSCAD's words: what a .csg file is made of.
#include <cstdint>
#include <string>
#include <string_view>

#include "scenes/readers/source_text.h"

namespace overstrike::openscad {

enum class TokenKind : std::uint8_t { word, number, text, mark, end };

struct Token {
  TokenKind kind = TokenKind::end;
  TextMark at;
  std::string_view source;  ///< as it stands in the file
  double number = 0;
  /// How far the number may be from what its writer meant: OpenSCAD writes six digits, so that one
  /// of six or more may be off by half a unit of its last; one of fewer is what it says.
  double precision = 0;
  std::string text;  ///< of a string, its escapes resolved

  bool is(char mark) const { return kind == TokenKind::mark && source[0] == mark; }
};

/// What was found, for messages: "'cube'", "a string", "the end of the file".
std::string describe(const Token& token);

/// Reads tokens one by one; comments and space go. What is no token is reported and thrown.
class Tokens {
 public:
  Tokens(std::string_view text, Reporter& reporter) : text_(text), reporter_(reporter) {}
  Token next();

 private:
  char peek(std::size_t ahead = 0) const {
    const std::size_t at = mark_.offset + ahead;
    return at < text_.size() ? text_[at] : '\0';
  }
  bool at_end() const { return mark_.offset >= text_.size(); }
  void step();
  void skip_space();
  void skip_comment();
  void read_word(Token& token);
  void read_number(Token& token);
  void read_text(Token& token);
  void read_escape(std::string& text);
  std::string_view since(const TextMark& start) const {
    return text_.substr(start.offset, mark_.offset - start.offset);
  }
  [[noreturn]] void fail(const TextMark& at, std::string message, std::string hint = {});

  std::string_view text_;
  Reporter& reporter_;
  TextMark mark_{1, 1, 0};
};

}  // namespace overstrike::openscad
