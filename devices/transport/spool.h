#pragma once
// A file to write by name for outputs that have none.
#include <filesystem>
#include <functional>
#include <string_view>

#include "devices/transport/temporary_file.h"

namespace overstrike {

/// Throws WorkError when the system's directory for temporary files takes no file.
class Spool {
 public:
  Spool() : file_(TemporaryFile::spool()) {}
  const std::filesystem::path& path() const { return file_.path(); }
  /// What is now under the path, piece by piece. Throws WorkError.
  void replay(const std::function<void(std::string_view)>& sink) const;

 private:
  TemporaryFile file_;
};

}  // namespace overstrike
