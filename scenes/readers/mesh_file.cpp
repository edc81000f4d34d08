#include "scenes/readers/mesh_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "scenes/readers/mesh_build.h"

namespace overstrike {
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t{4} << 30;
constexpr std::size_t kHead = 65536;

class File {
 public:
  explicit File(const std::filesystem::path& path)
      : name_(path.string()), fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY)) {
    if (fd_ < 0) fail_mesh(name_, std::strerror(errno));
  }
  ~File() { ::close(fd_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// Its size, or 0 for a pipe.
  std::uint64_t size() const {
    struct ::stat info {};
    if (::fstat(fd_, &info) != 0) fail_mesh(name_, std::strerror(errno));
    return S_ISREG(info.st_mode) ? static_cast<std::uint64_t>(info.st_size) : 0;
  }
  /// Appends up to `most` bytes; fewer only at the end of the file.
  void append(std::string& bytes, std::size_t most) const {
    std::size_t used = bytes.size();
    bytes.resize(used + most);
    while (used < bytes.size()) {
      const ssize_t got = ::read(fd_, bytes.data() + used, bytes.size() - used);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) fail_mesh(name_, std::strerror(errno));
      if (got == 0) break;
      used += static_cast<std::size_t>(got);
    }
    bytes.resize(used);
  }

 private:
  std::string name_;
  int fd_;
};

/// Opening a device may do something; files and pipes only are read.
void check_kind(const std::filesystem::path& path) {
  struct ::stat info {};
  if (::stat(path.c_str(), &info) != 0) fail_mesh(path.string(), std::strerror(errno));
  if (S_ISDIR(info.st_mode)) fail_mesh(path.string(), "is a directory, not a mesh file");
  if (!S_ISREG(info.st_mode) && !S_ISFIFO(info.st_mode))
    fail_mesh(path.string(), "is neither a file nor a pipe");
}

void check_size(std::uint64_t size, const std::string& name) {
  if (size > kLargestFile) fail_mesh(name, "is larger than 4 GB");
}

}  // namespace

std::string read_mesh_file(const std::filesystem::path& path, const FileCheck& check) {
  check_kind(path);
  const File file(path);
  const std::uint64_t size = file.size();
  check_size(size, path.string());
  std::string bytes;
  file.append(bytes, kHead);
  check(bytes, size, path.string());
  if (bytes.size() < size) file.append(bytes, size - bytes.size());
  if (size > 0) return bytes;
  for (std::size_t before = 0; before < bytes.size();) {
    before = bytes.size();
    file.append(bytes, before);
    check_size(bytes.size(), path.string());
  }
  return bytes;
}

}  // namespace overstrike
