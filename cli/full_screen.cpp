#include "cli/full_screen.h"

#include <fmt/core.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "core/error.h"

namespace overstrike {
namespace {

/// The other screen, without a cursor; and back.
constexpr std::string_view kEnter = "\033[?1049h\033[?25l\033[2J", kLeave = "\033[?25h\033[?1049l";
constexpr char kControlC = 3, kControlD = 4;

[[noreturn]] void fail(std::string_view what) {
  throw WorkError(fmt::format("{}: {}", what, std::strerror(errno)));
}

}  // namespace

FullScreen::FullScreen() {
  sigset_t taken;
  sigemptyset(&taken);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGWINCH}) sigaddset(&taken, signal);
  pthread_sigmask(SIG_BLOCK, &taken, &unblocked_);
  signals_ = ::signalfd(-1, &taken, SFD_NONBLOCK | SFD_CLOEXEC);
  if (signals_ < 0) fail("signals");
  keys_ = ::tcgetattr(STDIN_FILENO, &cooked_) == 0;
  if (keys_) {
    termios raw = cooked_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  }
  show(kEnter);
}

FullScreen::~FullScreen() {
  try {
    show(kLeave);
  } catch (const WorkError&) {
    // There is no terminal to put right any more.
  }
  if (keys_) ::tcsetattr(STDIN_FILENO, TCSANOW, &cooked_);
  ::close(signals_);
  pthread_sigmask(SIG_SETMASK, &unblocked_, nullptr);
}

FullScreen::Event FullScreen::wait(int other) {
  std::array<pollfd, 3> on{
      {{signals_, POLLIN, 0}, {other, POLLIN, 0}, {keys_ ? STDIN_FILENO : -1, POLLIN, 0}}};
  Event event;
  if (::poll(on.data(), on.size(), -1) < 0 && errno != EINTR) fail("waiting");
  if (on[0].revents != 0) read_signals(event);
  event.other = on[1].revents != 0;
  if (on[2].revents != 0 && read_keys()) event.exit_status = 128 + SIGINT;
  return event;
}

/// True for a key that ends the program, or when there are no more keys.
bool FullScreen::read_keys() {
  std::array<char, 64> keys;
  const ssize_t count = ::read(STDIN_FILENO, keys.data(), keys.size());
  if (count <= 0) return count == 0 || (errno != EINTR && errno != EAGAIN);
  for (ssize_t i = 0; i < count; ++i)
    for (const char key : {'q', kControlC, kControlD})
      if (keys[static_cast<std::size_t>(i)] == key) return true;
  return false;
}

void FullScreen::read_signals(Event& event) {
  signalfd_siginfo info;
  while (::read(signals_, &info, sizeof info) == sizeof info) {
    if (info.ssi_signo == SIGWINCH)
      event.resized = true;
    else
      event.exit_status = 128 + static_cast<int>(info.ssi_signo);
  }
}

std::pair<int, int> FullScreen::size() {
  winsize window{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0 && window.ws_row > 0)
    return {window.ws_col, window.ws_row};
  return {80, 24};
}

void FullScreen::show(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(STDOUT_FILENO, text.data(), text.size());
    if (count < 0 && errno != EINTR) fail("standard output");
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
}

}  // namespace overstrike
