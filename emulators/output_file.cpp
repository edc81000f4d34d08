#include "emulators/output_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "emulators/data_files.h"

namespace overstrike::emulator {

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
  constexpr int kNames = 100;  // other programs may hold a few
  for (int i = 0; descriptor_ < 0 && i < kNames; ++i) {
    temporary_ = path_;
    temporary_ += fmt::format(".{}-{}.tmp", ::getpid(), i);
    descriptor_ = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) break;
  }
  if (descriptor_ < 0) fail(errno);
}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
}

void OutputFile::write(const void* bytes, std::size_t count) {
  const char* at = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = ::write(descriptor_, at, count);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    at += written;
    count -= static_cast<std::size_t>(written);
  }
}

void OutputFile::commit() {
  const int descriptor = std::exchange(descriptor_, -1);
  int error = ::close(descriptor) == 0 ? 0 : errno;
  if (error == 0 && ::rename(temporary_.c_str(), path_.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(temporary_.c_str());
  fail(error);
}

void OutputFile::fail(int error) {
  throw OutputError(path_.string() + ": cannot be written: " +
                    std::error_code(error, std::generic_category()).message());
}

}  // namespace overstrike::emulator
