#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <optional>

#include "devices/device.h"
#include "devices/nearest.h"

namespace overstrike {
namespace {

template <typename T>
std::optional<T> parse(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::pair<int, int>> parse_size(std::string_view text) {
  const std::size_t cross = text.find_first_of("xX");
  if (cross == std::string_view::npos) return std::nullopt;
  const auto columns = parse<int>(text.substr(0, cross));
  const auto rows = parse<int>(text.substr(cross + 1));
  if (!columns || !rows) return std::nullopt;
  return std::pair(*columns, *rows);
}

std::string unknown_setting_hint(const DeviceKind& kind, std::string_view name) {
  std::vector<std::string_view> names;
  for (const Setting& setting : kind.settings) names.push_back(setting.name);
  const std::string_view near = nearest_name(name, names);
  if (!near.empty()) return fmt::format("did you mean '{}'?", near);
  return names.empty() ? "it takes none" : fmt::format("it takes {}", fmt::join(names, ", "));
}

}  // namespace

SettingReader::SettingReader(const DeviceKind& kind, const Settings& given) : device_(kind.name) {
  for (const Setting& setting : kind.settings) values_.emplace_back(setting.name, setting.value);
  for (const auto& [name, value] : given) {
    const auto entry = std::find_if(values_.begin(), values_.end(),
                                    [&name = name](const auto& v) { return v.first == name; });
    if (entry == values_.end())
      throw InputError({}, fmt::format("the device '{}' has no setting '{}'", device_, name),
                       unknown_setting_hint(kind, name));
    entry->second = value;
    given_.push_back(name);
  }
}

const std::string& SettingReader::value(std::string_view name) const {
  const auto entry =
      std::find_if(values_.begin(), values_.end(), [&](const auto& v) { return v.first == name; });
  assert(entry != values_.end());
  return entry->second;
}

void SettingReader::refuse(std::string_view name, std::string_view expected) const {
  throw InputError({}, fmt::format("{} must be {}, found '{}'", name, expected, value(name)));
}

std::string SettingReader::text(std::string_view name) const { return value(name); }

double SettingReader::number(std::string_view name, double low, double high) const {
  const auto number = parse<double>(value(name));
  if (!number || !(*number >= low && *number <= high))
    refuse(name, fmt::format("a number between {} and {}", low, high));
  return *number;
}

int SettingReader::integer(std::string_view name, int low, int high) const {
  const auto number = parse<int>(value(name));
  if (!number || *number < low || *number > high)
    refuse(name, fmt::format("a whole number between {} and {}", low, high));
  return *number;
}

std::string SettingReader::choice(std::string_view name,
                                  std::span<const std::string_view> words) const {
  const std::string& found = value(name);
  if (std::find(words.begin(), words.end(), found) != words.end()) return found;
  const std::string_view near = nearest_name(found, words);
  const std::string hint = near.empty() ? "" : fmt::format("did you mean '{}'?", near);
  throw InputError(
      {}, fmt::format("{} must be one of {}, found '{}'", name, fmt::join(words, ", "), found),
      hint);
}

std::pair<int, int> SettingReader::size(std::string_view name, int most) const {
  const auto size = parse_size(value(name));
  const auto fits = [most](int n) { return n >= 1 && n <= most; };
  if (!size || !fits(size->first) || !fits(size->second))
    refuse(name, fmt::format("COLUMNSxROWS, each between 1 and {}", most));
  return *size;
}

bool SettingReader::given(std::string_view name) const {
  return std::find(given_.begin(), given_.end(), name) != given_.end();
}

}  // namespace overstrike
