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

/// A temporary file beside `path`, renamed over it by finish(); its mode is what the umask leaves
/// of rw-rw-rw-. A link is followed. What exists and is no plain file (/dev/null, a FIFO) is
/// written to as it stands. Throws WorkError with the path and the system's message.
std::unique_ptr<Transport> open_file(const std::filesystem::path& path);
/// Standard output. A closed pipe is a WorkError if the program ignores SIGPIPE.
std::unique_ptr<Transport> open_stdout();
/// Bytes into a string, for tests and for callers in the same process. The string gets them, all at
/// once, at finish().
std::unique_ptr<Transport> open_memory(std::string& bytes);

/// Removes the temporary files of all transports that have not finished. Async-signal-safe: for the
/// handler of a signal that ends the program.
void remove_unfinished_files() noexcept;

}  // namespace overstrike
