#pragma once
// What the fuzz targets share.
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace overstrike::fuzz {

/// While it lives, what it tells stands before the law that is broken.
class WhenBroken {
 public:
  explicit WhenBroken(std::function<std::string()> tell) { story() = std::move(tell); }
  ~WhenBroken() { story() = nullptr; }
  WhenBroken(const WhenBroken&) = delete;
  static std::function<std::string()>& story() {
    static std::function<std::string()> one;
    return one;
  }
};

/// A law that does not hold ends the run; libFuzzer keeps the input.
[[noreturn]] inline void broken(std::string_view law) {
  if (WhenBroken::story()) std::fputs(WhenBroken::story()().c_str(), stderr);
  std::fprintf(stderr, "broken: %.*s\n", static_cast<int>(law.size()), law.data());
  std::abort();
}
inline void expect(bool holds, std::string_view law) {
  if (!holds) broken(law);
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A file that has a name for readers that take one, and lies in memory.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : fd_(::memfd_create("fuzz", MFD_CLOEXEC)) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
      if (written <= 0) broken("a file in memory can be written");
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  ~MemoryFile() { ::close(fd_); }
  MemoryFile(const MemoryFile&) = delete;
  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(fd_); }

 private:
  int fd_;
};

/// Numbers made of bytes; after the last byte all are 0.
class ByteSource {
 public:
  ByteSource(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
  bool empty() const { return at_ == end_; }
  unsigned byte() { return empty() ? 0 : *at_++; }
  unsigned below(unsigned n) { return byte() % n; }
  /// One of the values.
  template <class Values>
  auto pick(const Values& values) {
    return values[below(static_cast<unsigned>(std::size(values)))];
  }

 private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

}  // namespace overstrike::fuzz
