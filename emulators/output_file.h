#pragma once
// A file that has its name only when it is whole.
#include <cstddef>
#include <filesystem>
#include <string>

namespace overstrike::emulator {

/// Writes beside `path` under a temporary name; commit() renames it over `path`. Destroyed before,
/// it leaves nothing. All throw OutputError with the system's message.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  void write(const void* bytes, std::size_t count);
  void commit();

 private:
  [[noreturn]] void fail(int error);
  std::filesystem::path path_, temporary_;
  int descriptor_ = -1;
};

}  // namespace overstrike::emulator
