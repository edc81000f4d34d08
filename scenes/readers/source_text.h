#pragma once
// A text file as its reader reports it: places counted in characters, excerpts short enough to
// print.
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace overstrike {

/// A byte of a text: `line` and `column` count from 1, `column` in bytes; `offset` is that of the
/// byte from the text's start.
struct TextMark {
  int line = 0;
  int column = 0;
  std::size_t offset = 0;
};

/// Offset of the first byte that is not UTF-8 text (NUL counts as none), or npos.
std::size_t first_non_text(std::string_view text);

/// The mark of the byte at `offset`, by counting lines.
TextMark mark_at(std::string_view text, std::size_t offset);

/// The text without a byte order mark.
std::string_view without_bom(std::string_view text);

/// 'text'
std::string in_quotes(std::string_view text);

/// Collects everything that is wrong with one file.
class Reporter {
 public:
  /// `text` must outlive the reporter; `name` stands in messages.
  Reporter(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  void error(const TextMark& at, std::string message, std::string hint = {});
  void warning(const TextMark& at, std::string message, std::string hint = {});
  /// What another file's reader said, with its own places.
  void append(const std::vector<Diagnostic>& diagnostics);

  std::size_t errors() const { return errors_; }
  /// So many errors were reported that further ones are only counted: save the work of hints.
  bool full() const;
  Place place(const TextMark& at) const;
  const std::string& name() const { return name_; }

  /// Throws InputError with everything reported, in the order of the file, if any is an error.
  void throw_errors() const;
  std::vector<Diagnostic> warnings() const;

 private:
  void add(Severity severity, const TextMark& at, std::string message, std::string hint);

  std::string_view text_;
  std::string name_;
  std::vector<Diagnostic> diagnostics_;
  std::size_t errors_ = 0;
};

}  // namespace overstrike
