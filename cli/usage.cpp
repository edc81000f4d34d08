#include "cli/usage.h"

#include "devices/nearest.h"

namespace overstrike {

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
  const std::string_view meant = nearest_name(word, known);
  return meant.empty() ? std::string() : " (did you mean '" + std::string(meant) + "'?)";
}

}  // namespace overstrike
