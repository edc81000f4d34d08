#include "cli/interrupt.h"

#include <csignal>
#include <initializer_list>

#include <unistd.h>

#include "devices/transport/transport.h"

namespace overstrike {
namespace {

extern "C" void leave(int signal) {
  remove_unfinished_files();
  _exit(128 + signal);
}

}  // namespace

void catch_interrupts() {
  struct sigaction ignore = {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, nullptr);
  for (int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction previous = {};
    sigaction(signal, nullptr, &previous);
    if (previous.sa_handler == SIG_IGN) continue;  // nohup and background jobs stay ignorant of it
    struct sigaction action = {};
    action.sa_handler = leave;
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace overstrike
