#include "scenes/readers/yaml/fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "scenes/readers/nearest.h"

namespace overstrike::yaml {
namespace {

constexpr std::size_t kMostKeysTold = 7;

std::string text(std::string_view s) { return std::string(s); }

/// "box, prism, cylinder, ...": the first of them.
std::string first_keys(Keys keys) {
  std::string names;
  for (const std::string_view key : keys.first(std::min(keys.size(), kMostKeysTold)))
    names += (names.empty() ? "" : ", ") + text(key);
  return keys.size() > kMostKeysTold ? names + ", ..." : names;
}

std::string short_number(double v) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, v).ptr};
}

/// "[x, y]" for two.
std::string_view as_list(std::size_t size) { return size == 2 ? "[x, y]" : "[x, y, z]"; }

struct Parsed {
  std::optional<double> value;
  std::string_view instead;  ///< what was found when it is a number but none to draw with
};

Parsed parse_number(std::string_view s) {
  std::string_view digits = s;
  const bool negative = digits.starts_with('-');
  if (negative || digits.starts_with('+')) digits.remove_prefix(1);
  std::string lower(digits.substr(0, 9));
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
  if (lower == ".nan" || lower == "nan") return {{}, "not a number (NaN)"};
  if (lower == ".inf" || lower == "inf" || lower == "infinity")
    return {{}, negative ? "minus infinity" : "infinity"};
  if (digits.empty() || !(digits[0] == '.' || (digits[0] >= '0' && digits[0] <= '9'))) return {};
  double value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (stop != end) return {};
  if (error == std::errc::result_out_of_range) return {{}, "a number out of range"};
  if (error != std::errc()) return {};
  return {negative ? -value : value, {}};
}

bool inside(double v, const Range& r) {
  return r.open ? v > r.low && v < r.high : v >= r.low && v <= r.high;
}

std::string words_of(const Range& r, double v) {
  if (std::fabs(v) > kLargest) return "must be at most 1e30 in size";
  if (v > 0 && r.low > 0 && v < r.low && r.high == kLargest) return "must be at least 1e-30";
  if (!r.words.empty()) return text(r.words);
  return "must lie between " + short_number(r.low) + " and " + short_number(r.high) +
         (r.open ? " (neither itself)" : "");
}

template <class Vec>
Vec vector(Reporter& reporter, const Node& node, std::string_view label, const Range& range) {
  constexpr auto kSize = static_cast<std::size_t>(Vec::length());
  Vec v(std::clamp(1.0, range.low, range.high));
  if (node.kind != NodeKind::list || node.items.size() != kSize) {
    reporter.error(node.mark, text(label) + " must be " + (kSize == 2 ? "two" : "three") +
                                  " numbers " + text(as_list(kSize)) + ", found " + describe(node));
    return v;
  }
  for (std::size_t i = 0; i < kSize; ++i)
    v[static_cast<int>(i)] = number(reporter, *node.items[i], label, range);
  return v;
}

template <class Vec>
std::vector<Vec> points(Reporter& reporter, const Node& node, std::string_view label,
                        std::size_t fewest) {
  const std::string of = "points " + text(as_list(Vec::length()));
  std::vector<Vec> result;
  const auto& items = list(reporter, node, label, of, fewest);
  result.reserve(items.size());
  const std::string each = "a point of " + text(label);
  for (const Node* item : items) result.push_back(vector<Vec>(reporter, *item, each, kAny));
  return result;
}

}  // namespace

double number(Reporter& reporter, const Node& node, std::string_view label, const Range& range) {
  const double harmless = std::clamp(1.0, range.low, range.high);
  const Parsed parsed =
      node.kind == NodeKind::scalar && !node.quoted ? parse_number(node.text) : Parsed{};
  if (parsed.value && inside(*parsed.value, range)) return *parsed.value;
  if (parsed.value)
    reporter.error(node.mark, text(label) + ' ' + words_of(range, *parsed.value) + ", found " +
                                  node.text.substr(0, 40));
  else if (!parsed.instead.empty())
    reporter.error(node.mark,
                   text(label) + " must be a finite number, found " + text(parsed.instead));
  else
    reporter.error(node.mark, text(label) + " must be a number, found " + describe(node),
                   node.quoted && parse_number(node.text).value ? "take the quotes away" : "");
  return harmless;
}

int whole_number(Reporter& reporter, const Node& node, std::string_view label, int low, int high) {
  int value = 0;
  const char* end = node.text.data() + node.text.size();
  const bool whole = node.kind == NodeKind::scalar && !node.quoted &&
                     std::from_chars(node.text.data(), end, value).ptr == end && !node.text.empty();
  const Parsed parsed = whole ? parse_number(node.text) : Parsed{};
  if (!whole)
    reporter.error(node.mark, text(label) + " must be a whole number, found " + describe(node));
  else if (!parsed.value || *parsed.value < low || *parsed.value > high)
    reporter.error(node.mark, text(label) + " must lie between " + std::to_string(low) + " and " +
                                  std::to_string(high) + ", found " + node.text.substr(0, 40));
  else
    return value;
  return low;
}

bool boolean(Reporter& reporter, const Node& node, std::string_view label) {
  if (is_word(node, "true")) return true;
  if (!is_word(node, "false"))
    reporter.error(node.mark, text(label) + " must be true or false, found " + describe(node));
  return false;
}

std::string word(Reporter& reporter, const Node& node, std::string_view label) {
  constexpr std::size_t kLongest = 100;
  if (node.kind != NodeKind::scalar || node.text.empty())
    reporter.error(node.mark, text(label) + " must be a word, found " + describe(node));
  else if (node.text.size() > kLongest)
    reporter.error(node.mark, text(label) + " must be at most 100 bytes long");
  else
    return node.text;
  return {};
}

std::size_t choice(Reporter& reporter, const Node& node, std::string_view label, Keys words) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (is_word(node, words[i])) return i;
  std::string all;
  for (std::size_t i = 0; i < words.size(); ++i)
    all += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + text(words[i]);
  reporter.error(node.mark, text(label) + " must be " + all + ", found " + describe(node),
                 node.kind == NodeKind::scalar ? did_you_mean(node.text, words) : "");
  return 0;
}

Vec2 vec2(Reporter& reporter, const Node& node, std::string_view label) {
  return vector<Vec2>(reporter, node, label, kAny);
}

Vec3 vec3(Reporter& reporter, const Node& node, std::string_view label, const Range& range) {
  return vector<Vec3>(reporter, node, label, range);
}

std::vector<Vec2> points2(Reporter& reporter, const Node& node, std::string_view label,
                          std::size_t fewest) {
  return points<Vec2>(reporter, node, label, fewest);
}

std::vector<Vec3> points3(Reporter& reporter, const Node& node, std::string_view label,
                          std::size_t fewest) {
  return points<Vec3>(reporter, node, label, fewest);
}

const std::vector<const Node*>& list(Reporter& reporter, const Node& node, std::string_view label,
                                     std::string_view of_what, std::size_t fewest) {
  static const std::vector<const Node*> kEmpty;
  if (node.kind == NodeKind::list && node.items.size() >= fewest) return node.items;
  if (node.kind != NodeKind::list)
    reporter.error(node.mark, text(label) + " must be a list of " + text(of_what) + ", found " +
                                  describe(node));
  else if (fewest == 1)
    reporter.error(node.mark, text(label) + " must not be empty");
  else
    reporter.error(node.mark,
                   text(label) + " must have at least " + std::to_string(fewest) + ' ' +
                       text(of_what) + ", found " +
                       (node.items.empty() ? "none" : std::to_string(node.items.size())));
  return kEmpty;
}

bool is_word(const Node& node, std::string_view text) {
  return node.kind == NodeKind::scalar && node.text == text;
}

Fields::Fields(Reporter& reporter, const Node& node, const MapKind& kind)
    : reporter_(reporter), node_(node), kind_(kind) {
  if (node.kind == NodeKind::map) {
    check_keys();
    return;
  }
  usable_ = !kind.shorthand.empty() && node.kind != NodeKind::nothing;
  if (usable_) return;
  reporter.error(node.mark, text(kind.name) + " must be a map with the keys " +
                                first_keys(kind.keys) + ", found " + describe(node));
}

void Fields::check_keys() {
  for (std::size_t i = 0; i < node_.entries(); ++i) {
    const Node& key = node_.key(i);
    if (key.kind != NodeKind::scalar) {
      reporter_.error(key.mark,
                      "a key of " + text(kind_.name) + " must be a word, found " + describe(key));
      continue;
    }
    if (std::find(kind_.keys.begin(), kind_.keys.end(), key.text) == kind_.keys.end()) {
      const std::string meant = reporter_.full() ? "" : suggestion(key.text, kind_.keys);
      reporter_.error(key.mark, "unknown key " + describe(key) + " in " + text(kind_.name),
                      meant.empty() ? "known are " + first_keys(kind_.keys) : meant);
      suggested_ += meant;
      continue;
    }
    for (std::size_t j = 0; j < i; ++j)
      if (is_word(node_.key(j), key.text)) {
        reporter_.error(key.mark, "key " + in_quotes(key.text) + " is given twice; first in line " +
                                      std::to_string(node_.key(j).mark.line));
        break;
      }
  }
}

const Node* Fields::find(std::string_view key) const {
  if (node_.kind != NodeKind::map) return usable_ && key == kind_.shorthand ? &node_ : nullptr;
  for (std::size_t i = 0; i < node_.entries(); ++i)
    if (is_word(node_.key(i), key)) return &node_.value(i);
  return nullptr;
}

bool Fields::suggested(std::string_view key) const {
  return suggested_.find(in_quotes(key)) != std::string::npos;
}

const Node* Fields::need(std::string_view key) const {
  const Node* value = find(key);
  if (value == nullptr && usable_ && !suggested(key))
    reporter_.error(node_.mark, text(kind_.name) + " needs '" + text(key) + "'");
  return value;
}

double Fields::number(std::string_view key, const Range& range) const {
  const Node* value = need(key);
  return value ? yaml::number(reporter_, *value, key, range)
               : std::clamp(1.0, range.low, range.high);
}

double Fields::number_or(std::string_view key, double otherwise, const Range& range) const {
  const Node* value = find(key);
  return value ? yaml::number(reporter_, *value, key, range) : otherwise;
}

int Fields::whole_number_or(std::string_view key, int otherwise, int low, int high) const {
  const Node* value = find(key);
  return value ? yaml::whole_number(reporter_, *value, key, low, high) : otherwise;
}

bool Fields::boolean_or(std::string_view key, bool otherwise) const {
  const Node* value = find(key);
  return value ? boolean(reporter_, *value, key) : otherwise;
}

Vec3 Fields::vec3_or(std::string_view key, const Vec3& otherwise) const {
  const Node* value = find(key);
  return value ? vec3(reporter_, *value, key) : otherwise;
}

const TextMark& Fields::mark(std::string_view key) const {
  const Node* value = find(key);
  return value ? value->mark : node_.mark;
}

}  // namespace overstrike::yaml
