#pragma once
#include <string>
#include <system_error>

#include "core/error.h"

namespace overstrike {

/// WorkError "WHAT: the system's message".
[[noreturn]] inline void throw_system_error(const std::string& what, int error) {
  throw WorkError(what + ": " + std::system_category().message(error));
}

}  // namespace overstrike
