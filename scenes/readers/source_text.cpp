#include "scenes/readers/source_text.h"

#include <algorithm>
#include <utility>

namespace overstrike {
namespace {

// So many are told one by one; who made more mistakes than this has made one mistake.
constexpr std::size_t kMostErrors = 200;
// An excerpt fits a terminal with room for its indentation.
constexpr std::size_t kExcerptCharacters = 90;
constexpr std::size_t kExcerptBefore = 50;
// Columns count characters; further right than this, where nobody counts, bytes: it keeps the cost
// of a place constant.
constexpr int kLongLine = 10'000;

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::size_t count_characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(c); }));
}

/// Bytes of the UTF-8 sequence at the start of `s` (RFC 3629: no overlong forms, no surrogates),
/// or 0 if there is none.
std::size_t sequence_length(std::string_view s) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
  const unsigned char lead = byte(0);
  if (lead == 0) return 0;
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || s.size() < length) return 0;
  const unsigned char low = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  const unsigned char high = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  if (byte(1) < low || byte(1) > high) return 0;
  for (std::size_t i = 2; i < length; ++i)
    if (!is_continuation(s[i])) return 0;
  return length;
}

/// Offset of the first byte of the line that holds `at`.
std::size_t line_start(std::string_view text, const TextMark& at) {
  const std::size_t offset = std::min(text.size(), at.offset);
  return offset - std::min(offset, static_cast<std::size_t>(at.column - 1));
}

bool ends_line(std::string_view text, std::size_t i) {
  return i >= text.size() || text[i] == '\n' || text.substr(i, 2) == "\r\n";
}

struct Excerpt {
  std::string text;
  int caret = 0;
};

/// The line that holds `at`, or the part of it round `at` if it is long; with tabs as blanks so
/// that the caret stands where it should.
Excerpt excerpt_of(std::string_view text, const TextMark& at) {
  const std::size_t start = line_start(text, at);
  std::size_t begin = std::min(text.size(), at.offset), end = begin, characters = 0, before = 0;
  const auto step_back = [&] {
    while (begin > start && is_continuation(text[--begin])) {
    }
    ++characters, ++before;
  };
  while (begin > start && before < kExcerptBefore) step_back();
  while (!ends_line(text, end) && characters < kExcerptCharacters) {
    do ++end;
    while (end < text.size() && is_continuation(text[end]));
    ++characters;
  }
  while (begin > start && characters < kExcerptCharacters) step_back();
  Excerpt excerpt;
  if (begin > start) excerpt.text = "...";
  excerpt.caret = static_cast<int>(before + excerpt.text.size()) + 1;
  excerpt.text += text.substr(begin, end - begin);
  if (!ends_line(text, end)) excerpt.text += "...";
  std::replace(excerpt.text.begin(), excerpt.text.end(), '\t', ' ');
  return excerpt;
}

bool before(const Diagnostic& a, const Diagnostic& b) {
  return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
}

}  // namespace

std::size_t first_non_text(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text.substr(i, 4));
    if (length == 0) return i;
    i += length;
  }
  return std::string_view::npos;
}

TextMark mark_at(std::string_view text, std::size_t offset) {
  const std::string_view before_it = text.substr(0, offset);
  const auto lines = std::count(before_it.begin(), before_it.end(), '\n');
  const std::size_t start = before_it.rfind('\n') + 1;  // npos + 1 is 0
  return {static_cast<int>(lines) + 1, static_cast<int>(offset - start) + 1, offset};
}

std::string_view without_bom(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

std::string in_quotes(std::string_view text) {
  std::string result;
  result.reserve(text.size() + 2);
  result += '\'';
  result += text;
  return result += '\'';
}

Place Reporter::place(const TextMark& at) const {
  if (at.line == 0) return {name_, 0, 0};
  if (at.column > kLongLine) return {name_, at.line, at.column};
  const std::string_view before_it =
      text_.substr(line_start(text_, at), static_cast<std::size_t>(at.column - 1));
  return {name_, at.line, static_cast<int>(count_characters(before_it)) + 1};
}

void Reporter::add(Severity severity, const TextMark& at, std::string message, std::string hint) {
  if (severity == Severity::error && ++errors_ > kMostErrors) return;
  Diagnostic d{severity, place(at), std::move(message), std::move(hint), {}};
  if (at.line > 0) {
    Excerpt excerpt = excerpt_of(text_, at);
    d.excerpt = std::move(excerpt.text);
    d.caret = excerpt.caret;
  }
  diagnostics_.push_back(std::move(d));
}

bool Reporter::full() const { return errors_ >= kMostErrors; }

void Reporter::error(const TextMark& at, std::string message, std::string hint) {
  add(Severity::error, at, std::move(message), std::move(hint));
}

void Reporter::warning(const TextMark& at, std::string message, std::string hint) {
  add(Severity::warning, at, std::move(message), std::move(hint));
}

void Reporter::append(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& d : diagnostics) {
    if (d.severity == Severity::error && ++errors_ > kMostErrors) continue;
    diagnostics_.push_back(d);
  }
}

void Reporter::throw_errors() const {
  if (errors_ == 0) return;
  std::vector<Diagnostic> own, others;
  for (const Diagnostic& d : diagnostics_) (d.place.file == name_ ? own : others).push_back(d);
  std::stable_sort(own.begin(), own.end(), before);
  own.insert(own.end(), others.begin(), others.end());
  if (errors_ > kMostErrors)
    own.emplace_back().message = "and " + std::to_string(errors_ - kMostErrors) + " more errors";
  throw InputError(std::move(own));
}

std::vector<Diagnostic> Reporter::warnings() const {
  std::vector<Diagnostic> found;
  for (const Diagnostic& d : diagnostics_)
    if (d.severity == Severity::warning) found.push_back(d);
  return found;
}

}  // namespace overstrike
