#include "scenes/readers/mesh_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

namespace overstrike {
namespace {

// A word longer than this is told by its beginning.
constexpr std::size_t kLongestQuote = 40;

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// How a number is written: 0.0120 has 3 significant digits, the last of which weighs 10^-4.
struct Digits {
  int significant = 0;
  int last = 0;
  bool fraction = false;  ///< written with a point or an exponent
};

Digits digits_of(std::string_view word) {
  Digits d;
  bool point = false;
  std::size_t i = 0;
  for (; i < word.size(); ++i) {
    if (is_digit(word[i])) {
      if (d.significant > 0 || word[i] != '0') ++d.significant;
      if (point) --d.last;
    } else if (word[i] == '.') {
      point = d.fraction = true;
    } else if (word[i] == 'e' || word[i] == 'E') {
      break;
    }
  }
  if (i >= word.size()) return d;
  d.fraction = true;
  if (++i < word.size() && word[i] == '+') ++i;
  int exponent = 0;
  const auto [end, fault] = std::from_chars(word.data() + i, word.data() + word.size(), exponent);
  if (fault == std::errc{}) d.last += std::clamp(exponent, -100'000, 100'000);
  return d;
}

}  // namespace

void DigitCensus::count(int significant, int last) {
  significant = std::min(significant, kMostDigits);
  if (significant < std::max(most_, kFewestDigits)) return;
  coarsest_ = significant > most_ ? last : std::max(coarsest_, last);
  most_ = significant;
}

double DigitCensus::precision() const {
  if (coarsest_ == kNone) return 0;
  const std::string half = "5e" + std::to_string(coarsest_ - 1);
  double value = 0;  // stays 0 if it is too small for a double
  std::from_chars(half.data(), half.data() + half.size(), value);
  return value;
}

MeshText::MeshText(std::string_view text, const std::string& name)
    : text_(text), reporter_(text, name) {}

void MeshText::find_line_end() {
  const std::size_t newline = text_.find('\n', next_line_);
  line_end_ = std::min(newline, text_.size());
  next_line_ = newline == std::string_view::npos ? text_.size() : newline + 1;
  if (line_end_ > line_start_ && text_[line_end_ - 1] == '\r') --line_end_;
}

bool MeshText::next_line() {
  if (next_line_ >= text_.size()) {
    at_ = line_end_;
    return false;
  }
  line_ += 1 + joined_;
  joined_ = 0;
  at_ = line_start_ = next_line_;
  find_line_end();
  while (joins_ && line_end_ > line_start_ && text_[line_end_ - 1] == '\\' &&
         next_line_ < text_.size()) {
    ++joined_;
    find_line_end();
  }
  return true;
}

std::string_view MeshText::word() {
  const auto blank = [&](char c) { return is_blank(c) || (joins_ && c == '\\'); };
  while (at_ < line_end_ && blank(text_[at_])) ++at_;
  if (at_ < line_end_ && comment_ != '\0' && text_[at_] == comment_) at_ = line_end_;
  const std::size_t begin = at_;
  while (at_ < line_end_ && !blank(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view MeshText::word_of_any_line() {
  while (true) {
    const std::string_view next = word();
    if (!next.empty()) return next;
    if (!next_line()) return {};
  }
}

TextMark MeshText::mark(std::string_view word) const {
  const std::size_t offset =
      word.empty() ? at_ : static_cast<std::size_t>(word.data() - text_.data());
  if (offset < line_start_ || joined_ > 0) return mark_at(text_, offset);
  return {std::max(line_, 1), static_cast<int>(offset - line_start_) + 1, offset};
}

void MeshText::error(std::string_view word, std::string message, std::string hint) {
  error_at(mark(word), std::move(message), std::move(hint));
}

void MeshText::error_at(const TextMark& mark, std::string message, std::string hint) {
  const bool last = reporter_.errors() + 1 >= kMostErrors;
  if (last) hint += (hint.empty() ? "" : "; ") + std::string("reading stops after so many errors");
  reporter_.error(mark, std::move(message), std::move(hint));
  if (last) reporter_.throw_errors();
}

void MeshText::warning(std::string_view word, std::string message, std::string hint) {
  reporter_.warning(mark(word), std::move(message), std::move(hint));
}

std::optional<double> MeshText::number(std::string_view word, std::string_view what) {
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, fault] = std::from_chars(digits.data(), end, value);
  if (word.empty() || stop != end || fault == std::errc::invalid_argument) {
    error(word, std::string(what) + " must be a number, found " + found(word));
    return std::nullopt;
  }
  if (fault == std::errc::result_out_of_range) {
    const Digits d = digits_of(digits);
    if (d.significant + d.last <= 0) return 0.0;
  }
  if (fault != std::errc{} || !std::isfinite(value)) {
    error(word, std::string(what) + " must be a finite number, found " + found(word));
    return std::nullopt;
  }
  return value;
}

std::optional<double> MeshText::coordinate(std::string_view word, std::string_view what) {
  const std::optional<double> value = number(word, what);
  if (!value) return value;
  if (std::fabs(*value) > kLargestCoordinate) {
    error(word, std::string(what) + " must be at most 1e+100, found " + found(word));
    return std::nullopt;
  }
  const Digits d = digits_of(word);
  if (d.fraction) census_.count(d.significant, d.last);
  return value;
}

std::optional<Vec3> MeshText::point_from(std::string_view first, std::string_view what) {
  Vec3 p{0};
  bool good = true;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view w = axis == 0 ? first : word();
    const auto value = coordinate(w, std::string(what) + "'s " + "xyz"[axis]);
    if (!value && w.empty()) return std::nullopt;
    good = good && value;
    p[axis] = value.value_or(0) + 0.0;  // -0 is 0
  }
  return good ? std::optional(p) : std::nullopt;
}

std::optional<std::int64_t> MeshText::whole_number(std::string_view word, std::string_view what) {
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  std::int64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, fault] = std::from_chars(digits.data(), end, value);
  if (!word.empty() && stop == end && fault == std::errc{}) return value;
  error(word, std::string(what) + " must be a whole number, found " + found(word));
  return std::nullopt;
}

std::string found(std::string_view word) {
  if (word.empty()) return "the end of the line";
  std::string text(word.substr(0, kLongestQuote));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';  // no terminal obeys it
  return in_quotes(word.size() > kLongestQuote ? text + "..." : text);
}

std::string in_thousands(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, 1, ' ');
  return text;
}

}  // namespace overstrike
