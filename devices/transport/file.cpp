#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>

#include "devices/transport/descriptor.h"
#include "devices/transport/system_error.h"
#include "devices/transport/temporary_file.h"
#include "devices/transport/transport.h"

namespace overstrike {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) { return fmt::format("'{}'", path.string()); }

[[noreturn]] void refuse(const fs::path& path, int error) {
  throw_system_error("cannot write " + quoted(path), error);
}

/// Where a link leads, even to nothing. Precondition: links do not run in a circle.
fs::path end_of_links(fs::path path) {
  std::error_code error;
  while (fs::is_symlink(fs::symlink_status(path, error)))
    path = path.parent_path() / fs::read_symlink(path);
  return path;
}

class File final : public Transport {
 public:
  explicit File(const fs::path& target)
      : target_(target),
        file_(TemporaryFile::beside(target)),
        bytes_(open_descriptor(file_.descriptor(), Ownership::borrowed, quoted(target))) {}

  void write(std::string_view bytes) override { bytes_->write(bytes); }

  void finish() override {
    bytes_->finish();
    file_.rename_to(target_);
  }

  fs::path path_to_write() override { return file_.path(); }

 private:
  fs::path target_;
  TemporaryFile file_;
  std::unique_ptr<Transport> bytes_;
};

std::unique_ptr<Transport> open_special(const fs::path& path) {
  int descriptor = -1;
  do descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  while (descriptor < 0 && errno == EINTR);
  if (descriptor < 0) refuse(path, errno);
  return open_descriptor(descriptor, Ownership::owned, quoted(path));
}

}  // namespace

std::unique_ptr<Transport> open_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (path.empty()) refuse(path, ENOENT);
  if (status.type() == fs::file_type::none) refuse(path, error.value());
  if (!path.has_filename() || fs::is_directory(status)) refuse(path, EISDIR);
  if (fs::exists(status)) {
    if (!fs::is_regular_file(status)) return open_special(path);
    // Renaming could replace a file that its owner has protected from writing; it should not.
    if (::access(path.c_str(), W_OK) != 0) refuse(path, errno);
  }
  return std::make_unique<File>(end_of_links(path));
}

}  // namespace overstrike
