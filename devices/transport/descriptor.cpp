#include "devices/transport/descriptor.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <utility>

#include "devices/transport/spool.h"
#include "devices/transport/system_error.h"

namespace overstrike {
namespace {

// One system call for this much: the size of a pipe on Linux.
constexpr std::size_t kBuffer = 65536;

class Descriptor final : public Transport {
 public:
  Descriptor(int descriptor, Ownership ownership, std::string where)
      : descriptor_(descriptor), ownership_(ownership), where_(std::move(where)) {
    buffer_.reserve(kBuffer);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() override {
    if (ownership_ == Ownership::owned && descriptor_ >= 0) ::close(descriptor_);
  }

  void write(std::string_view bytes) override {
    if (buffer_.size() + bytes.size() > kBuffer) flush();
    if (bytes.size() >= kBuffer)
      write_all(descriptor_, bytes, where_);
    else
      buffer_ += bytes;
  }

  void finish() override {
    flush();
    if (spool_) spool_->replay([this](std::string_view b) { write_all(descriptor_, b, where_); });
    if (ownership_ == Ownership::owned && ::close(std::exchange(descriptor_, -1)) != 0 &&
        errno != EINTR)
      throw_system_error("cannot write " + where_, errno);
  }

  std::filesystem::path path_to_write() override {
    if (!spool_) spool_.emplace();
    return spool_->path();
  }

 private:
  void flush() {
    write_all(descriptor_, buffer_, where_);
    buffer_.clear();
  }

  int descriptor_;
  Ownership ownership_;
  std::string where_;
  std::string buffer_;
  std::optional<Spool> spool_;
};

void wait_until_writable(int descriptor) {
  pollfd waiting{descriptor, POLLOUT, 0};
  ::poll(&waiting, 1, -1);
}

}  // namespace

void write_all(int descriptor, std::string_view bytes, const std::string& where) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(count));
    else if (errno == EAGAIN || errno == EWOULDBLOCK)
      wait_until_writable(descriptor);
    else if (errno != EINTR)
      throw_system_error("cannot write " + where, errno);
  }
}

std::unique_ptr<Transport> open_descriptor(int descriptor, Ownership ownership, std::string where) {
  return std::make_unique<Descriptor>(descriptor, ownership, std::move(where));
}

std::unique_ptr<Transport> open_stdout() {
  return open_descriptor(STDOUT_FILENO, Ownership::borrowed, "to standard output");
}

}  // namespace overstrike
