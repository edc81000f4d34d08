#include "devices/transport/temporary_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstring>
#include <utility>

#include "devices/transport/system_error.h"
#include "devices/transport/transport.h"

namespace overstrike {
namespace {

namespace fs = std::filesystem;

// What a signal handler may read: a table that never moves. Whoever turns `listed` into `busy` has
// the path to itself, so a handler and a destructor never meet over one. A program with more
// unfinished files than slots still removes them all by their destructors.
enum State : int { free_slot, busy, listed };
constexpr std::size_t kSlots = 64;

struct Slot {
  std::atomic<int> state;
  std::array<char, PATH_MAX> path;
};
std::array<Slot, kSlots> unfinished;
static_assert(std::atomic<int>::is_always_lock_free);

/// The slot's number or -1.
int enter(const fs::path& path) {
  if (path.native().size() >= PATH_MAX) return -1;
  for (std::size_t i = 0; i < kSlots; ++i) {
    int expected = free_slot;
    if (!unfinished[i].state.compare_exchange_strong(expected, busy)) continue;
    std::strcpy(unfinished[i].path.data(), path.c_str());
    unfinished[i].state = listed;
    return static_cast<int>(i);
  }
  return -1;
}

// A slot that a handler is just reading stays taken: the program ends.
void leave(int slot) {
  if (slot < 0) return;
  int expected = listed;
  unfinished[static_cast<std::size_t>(slot)].state.compare_exchange_strong(expected, free_slot);
}

// A file name has room for 255 bytes; what a long stem loses is the temporary file's alone.
constexpr std::size_t kLongestStem = 200;

std::string random_letters() {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz234567";
  std::array<std::uint8_t, 6> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw_system_error("cannot name a temporary file", errno);
  std::string text;
  for (std::uint8_t byte : bytes) text += kLetters[byte % kLetters.size()];
  return text;
}

}  // namespace

void remove_unfinished_files() noexcept {
  const int saved = errno;
  for (Slot& slot : unfinished) {
    int expected = listed;
    if (!slot.state.compare_exchange_strong(expected, busy)) continue;
    ::unlink(slot.path.data());
    slot.state = listed;
  }
  errno = saved;
}

TemporaryFile TemporaryFile::create(const fs::path& directory, std::string_view stem,
                                    std::string_view extension, const fs::path& target) {
  TemporaryFile file;
  file.target_ = target;
  do {
    leave(file.slot_);
    file.path_ = directory /
                 fmt::format(".{}.{}{}", stem.substr(0, kLongestStem), random_letters(), extension);
    // Listed before it exists: an interrupt right after open() must find it.
    file.slot_ = enter(file.path_);
    file.descriptor_ = ::open(file.path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (file.descriptor_ < 0 && (errno == EEXIST || errno == EINTR));
  if (file.descriptor_ < 0) {
    const int error = errno;
    file.path_.clear();  // not ours to remove
    throw_system_error(fmt::format("cannot write '{}'", target.string()), error);
  }
  return file;
}

TemporaryFile TemporaryFile::beside(const fs::path& target) {
  return create(target.parent_path(), target.stem().string(), target.extension().string(), target);
}

TemporaryFile TemporaryFile::spool() {
  std::error_code error;
  fs::path directory = fs::temp_directory_path(error);
  if (error) directory = "/tmp";
  return create(directory, "overstrike", "", directory / "overstrike");
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      slot_(std::exchange(other.slot_, -1)) {
  other.path_.clear();
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!path_.empty()) ::unlink(path_.c_str());
  leave(slot_);
}

void TemporaryFile::close() {
  // Linux has closed the descriptor even when close() says EINTR.
  const int result = descriptor_ < 0 ? 0 : ::close(std::exchange(descriptor_, -1));
  if (result != 0 && errno != EINTR)
    throw_system_error(fmt::format("cannot write '{}'", target_.string()), errno);
}

void TemporaryFile::rename_to(const fs::path& target) {
  close();
  if (::rename(path_.c_str(), target.c_str()) != 0)
    throw_system_error(fmt::format("cannot write '{}'", target.string()), errno);
  path_.clear();
  leave(std::exchange(slot_, -1));
}

}  // namespace overstrike
