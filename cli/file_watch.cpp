#include "cli/file_watch.h"

#include <fmt/core.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "core/error.h"

namespace overstrike {
namespace {

/// A file was written and closed, or came by its name: what it holds is whole.
constexpr std::uint32_t kSaved = IN_CLOSE_WRITE | IN_MOVED_TO;

[[noreturn]] void fail(std::string_view what) {
  throw WorkError(fmt::format("cannot watch {}: {}", what, std::strerror(errno)));
}

}  // namespace

FileWatch::FileWatch() : descriptor_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  if (descriptor_ < 0) fail("files");
}

FileWatch::~FileWatch() { ::close(descriptor_); }

bool FileWatch::add(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::filesystem::path target = std::filesystem::canonical(file, ignored);
  const bool fresh = add_name(file);
  return (!target.empty() && add_name(target)) || fresh;
}

bool FileWatch::add_name(const std::filesystem::path& file) {
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  // The same folder has the same watch.
  const int watch = ::inotify_add_watch(descriptor_, folder.c_str(), kSaved | IN_ONLYDIR);
  if (watch >= 0) return names_[watch].insert(file.filename().string()).second;
  if (errno != ENOENT && errno != ENOTDIR) fail(folder.string());
  return false;
}

bool FileWatch::saved(bool beside) {
  alignas(inotify_event) std::array<char, 4096> buffer;
  bool saved = false;
  for (ssize_t size; (size = ::read(descriptor_, buffer.data(), buffer.size())) > 0;)
    for (const char* at = buffer.data(); at < buffer.data() + size;) {
      const auto* event = reinterpret_cast<const inotify_event*>(at);
      const auto names = names_.find(event->wd);
      const bool watched = event->len > 0 && names != names_.end() &&
                           (beside || names->second.count(event->name) > 0);
      // More happened than the system has kept.
      saved = saved || watched || (event->mask & IN_Q_OVERFLOW) != 0;
      at += sizeof(inotify_event) + event->len;
    }
  return saved;
}

}  // namespace overstrike
