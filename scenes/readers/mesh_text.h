#pragma once
// A text mesh, word by word, with places for errors.
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/geometry/vec.h"
#include "scenes/readers/mesh_build.h"
#include "scenes/readers/source_text.h"

namespace overstrike {

/// How finely a file's numbers are written.
///
/// Numbers with a point or an exponent tell it by their last digit; whole numbers are meant as they
/// stand. Writers drop trailing zeros (C's %g), so that only numbers of the most significant digits
/// in the file count, and of those the one whose last digit weighs most. Numbers of fewer than
/// kFewestDigits are meant as they stand, too: the 0.5 of a unit cube is no rounded number.
class DigitCensus {
 public:
  static constexpr int kFewestDigits = 4;

  /// `significant` digits of which the last weighs 10^`last`.
  void count(int significant, int last);
  /// Half of what the last digit weighs, or 0 if the numbers are meant as they stand.
  double precision() const;

 private:
  // More digits than any double has are told alike.
  static constexpr int kMostDigits = 20;
  static constexpr int kNone = std::numeric_limits<int>::min();
  int most_ = 0;
  int coarsest_ = kNone;
};

/// Reads lines and words (separated by blanks). Reports up to kMostErrors errors, then throws them.
class MeshText {
 public:
  static constexpr std::size_t kMostErrors = 20;

  /// `text` must outlive it.
  MeshText(std::string_view text, const std::string& name);

  /// Goes to the next line; false at the end of the file.
  bool next_line();
  /// The next word of this line, or empty.
  std::string_view word();
  /// The next word of this line or of a later one; empty at the end of the file.
  std::string_view word_of_any_line();
  /// The rest of this line is not read.
  void skip_line() { at_ = line_end_; }
  /// From here to the end of the line is a comment if it begins with `mark`.
  void set_comment(char mark) { comment_ = mark; }
  /// A `\` at the end of a line joins it to the next one.
  void join_lines() { joins_ = true; }

  int line() const { return line_; }
  std::size_t offset_of_next_line() const { return next_line_; }
  /// Where `word`, a part of the text, stands; an empty one: where reading stands.
  TextMark mark(std::string_view word) const;
  void error(std::string_view word, std::string message, std::string hint = {});
  void error_at(const TextMark& mark, std::string message, std::string hint = {});
  void warning(std::string_view word, std::string message, std::string hint = {});
  bool failed() const { return reporter_.errors() > 0; }
  const Reporter& reporter() const { return reporter_; }

  /// A finite number, or none after an error that begins with `what` ("x must be a number, found
  /// 'b'"). Numbers too small for a double are 0.
  std::optional<double> number(std::string_view word, std::string_view what);
  /// As number(), and counted in census().
  std::optional<double> coordinate(std::string_view word, std::string_view what);
  /// The next three words of this line as x, y, z; `what` as in "vertex".
  std::optional<Vec3> point(std::string_view what) { return point_from(word(), what); }
  /// As point(), its first word being read.
  std::optional<Vec3> point_from(std::string_view first, std::string_view what);
  std::optional<std::int64_t> whole_number(std::string_view word, std::string_view what);
  const DigitCensus& census() const { return census_; }

 private:
  void find_line_end();

  std::string_view text_;
  Reporter reporter_;
  DigitCensus census_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  std::size_t line_end_ = 0;
  std::size_t next_line_ = 0;
  int line_ = 0;
  int joined_ = 0;  ///< lines that a `\` joined to this one
  char comment_ = '\0';
  bool joins_ = false;
};

/// 'text', or "the end of the line" if it is empty; long ones are cut.
std::string found(std::string_view word);

/// 12345678 -> "12 345 678"
std::string in_thousands(std::uint64_t number);

}  // namespace overstrike
