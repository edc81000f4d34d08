#pragma once
// Settings in messages as the user wrote them: --lpi, or --set margin.
#include <string>
#include <string_view>

#include "devices/device.h"

namespace overstrike {

/// What was given, and how: the first `options` of the settings by options of their own ("--lpi"),
/// the others by --set.
struct WrittenSettings {
  const Settings& settings;
  std::size_t options = 0;
};

/// "--lpi" or "--set lpi" by the last one given, which counts; the bare name when it was not given.
std::string as_written(const WrittenSettings& written, std::string_view name);

/// A message that begins with the name of a setting that was given ("lpi must be ...") begins as
/// the user wrote it; any other message is returned as it is.
std::string say_as_written(const WrittenSettings& written, const std::string& message);

}  // namespace overstrike
