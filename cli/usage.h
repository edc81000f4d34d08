#pragma once
// What a user of the command said wrong, and what was probably meant.
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace overstrike {

/// Bad usage: the command says it and exits with status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// " (did you mean 'light'?)", or empty when no known word is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

}  // namespace overstrike
