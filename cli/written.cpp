#include "cli/written.h"

namespace overstrike {

std::string as_written(const WrittenSettings& written, std::string_view name) {
  for (std::size_t i = written.settings.size(); i-- > 0;) {
    if (written.settings[i].first == name)
      return (i < written.options ? "--" : "--set ") + std::string(name);
  }
  return std::string(name);
}

std::string say_as_written(const WrittenSettings& written, const std::string& message) {
  const std::size_t end = message.find(' ');
  if (end == std::string::npos) return message;
  return as_written(written, std::string_view(message).substr(0, end)) + message.substr(end);
}

}  // namespace overstrike
