#pragma once
// Where a device's bytes go.
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace overstrike {

/// A stream of bytes to somewhere. Not thread-safe.
class Transport {
 public:
  virtual ~Transport() = default;
  /// May block. Throws WorkError with the system's message when it fails (disk full, closed pipe).
  virtual void write(std::string_view bytes) = 0;
  /// Everything is there: flush and make it final (a file gets its name now). Called once, last. A
  /// transport that is destroyed before leaves nothing under the output's name.
  virtual void finish() = 0;
  /// For writers that can only write to a file by name (image libraries): a path to write to
  /// instead of write(); it has the extension of the final name and becomes the output at finish().
  virtual std::filesystem::path path_to_write() = 0;
};

/// A temporary file beside `path`, renamed over it by finish().
std::unique_ptr<Transport> open_file(const std::filesystem::path& path);
/// Standard output.
std::unique_ptr<Transport> open_stdout();
/// Bytes into a string, for tests and for callers in the same process.
std::unique_ptr<Transport> open_memory(std::string& bytes);

}  // namespace overstrike
