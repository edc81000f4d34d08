#pragma once
// The whole terminal for one program: keys as they are pressed, signals as they come, and the
// screen as it was when it ends.
#include <termios.h>
#include <csignal>
#include <string_view>
#include <utility>

namespace overstrike {

/// One at a time, before any thread. Takes the signals that end the program, and those of the
/// window's size: they are read, not caught.
class FullScreen {
 public:
  /// Precondition: standard output is a terminal. Throws WorkError.
  FullScreen();
  ~FullScreen();
  FullScreen(const FullScreen&) = delete;
  FullScreen& operator=(const FullScreen&) = delete;

  struct Event {
    int exit_status = 0;   ///< 128 + a signal that ends the program; q, Ctrl-C and Ctrl-D: SIGINT
    bool resized = false;  ///< the window has another size
    bool other = false;    ///< the other descriptor is readable
  };
  /// Waits for any of them.
  Event wait(int other);

  /// Columns and lines.
  static std::pair<int, int> size();
  /// All of it, on the screen. Throws WorkError.
  static void show(std::string_view text);

 private:
  bool read_keys();
  void read_signals(Event& event);

  bool keys_ = false;  ///< standard input is a terminal
  termios cooked_{};
  sigset_t unblocked_{};
  int signals_ = -1;
};

}  // namespace overstrike
